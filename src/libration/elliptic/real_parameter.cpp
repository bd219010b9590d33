#include "libration/elliptic/real_parameter.hpp"

#include "libration/scalar/error.hpp"

namespace libration::elliptic {

namespace {

real_parameter::range range_of(const exact& m, const exact& complement) {
    const int of_m = sign_of_exact(m);
    if (of_m <= 0) {
        return of_m < 0 ? real_parameter::range::negative : real_parameter::range::zero;
    }
    const int of_complement = sign_of_exact(complement);
    return of_complement > 0    ? real_parameter::range::within
           : of_complement == 0 ? real_parameter::range::one
                                : real_parameter::range::above;
}

}  // namespace

real_parameter real_parameter::from_modulus(const exact& k) {
    if (sign_of_exact(k) < 0) {
        throw error(error_kind::argument, "modulus", k.text, "is negative");
    }
    return from_parameter(k * k);
}

real_parameter real_parameter::from_modular_angle(const exact& alpha) {
    const exact_real angle = as_exact_real(alpha);
    const exact_real sine = apply(function_kind::sin, angle);
    const exact_real cosine = apply(function_kind::cos, angle);
    return {exactly(sine * sine, alpha.text), exactly(cosine * cosine, alpha.text), false};
}

real_parameter::real_parameter(exact m, exact complement, bool from_complement)
    : m_(std::move(m)),
      complement_(std::move(complement)),
      from_complement_(from_complement),
      where_(range_of(m_, complement_)) {}

exact_parameter real_parameter::within() const {
    return from_complement_ ? exact_parameter::from_complement(complement_) : exact_parameter::from_parameter(m_);
}

modulus<ball> real_parameter::reduced() const {
    const auto m = from_exact<ball>(m_);
    const auto complement = from_exact<ball>(complement_);
    switch (where_) {
        case range::negative: return modulus<ball>::from_both(sqrt(ball(-m / complement)), sqrt(ball(1 / complement)));
        case range::above: return modulus<ball>::from_both(sqrt(ball(1 / m)), sqrt(ball(-complement / m)));
        case range::zero:
        case range::within:
        case range::one: break;
    }
    return modulus<ball>::from_both(sqrt(m), sqrt(complement));
}

ball real_parameter::stretch() const {
    return where_ == range::negative ? sqrt(from_exact<ball>(complement_))
           : where_ == range::above  ? sqrt(from_exact<ball>(m_))
                                     : ball(1);
}

}  // namespace libration::elliptic
