// Jacobi's functions at complex arguments and any real parameter by Arb's theta functions of a complex tau, for the
// attack: without the library's reduction of the parameter, addition theorems and imaginary transformation.
#pragma once

#include <array>
#include <string_view>

#include "libration/number/exact.hpp"
#include "truncation/arb_theta.hpp"

namespace libration::tests {

/// A complex number of Arb.
class complex_ball {
public:
    complex_ball() { acb_init(value_); }
    complex_ball(const ball& real, const ball& imaginary) : complex_ball() {
        arb_set(acb_realref(value_), real.handle());
        arb_set(acb_imagref(value_), imaginary.handle());
    }
    complex_ball(const complex_ball& other) : complex_ball() { acb_set(value_, other.value_); }
    complex_ball& operator=(const complex_ball& other) {
        acb_set(value_, other.value_);
        return *this;
    }
    ~complex_ball() { acb_clear(value_); }

    acb_struct* handle() { return value_; }
    const acb_struct* handle() const { return value_; }
    ball real() const { return part(acb_realref(value_)); }
    ball imaginary() const { return part(acb_imagref(value_)); }

    friend complex_ball operator*(const complex_ball& a, const complex_ball& b) {
        complex_ball result;
        acb_mul(result.value_, a.value_, b.value_, ball::working_bits());
        return result;
    }
    friend complex_ball operator/(const complex_ball& a, const complex_ball& b) {
        complex_ball result;
        acb_div(result.value_, a.value_, b.value_, ball::working_bits());
        return result;
    }

private:
    static ball part(const arb_struct* from) {
        ball result;
        arb_set(result.handle(), from);
        return result;
    }

    acb_t value_;
};

/// The functions of one parameter, m and 1 - m exact [DLMF 20.9.1-2, 22.2.4-9]; for m = 0 and m = 1 circular and
/// hyperbolic functions [DLMF 22.5.3, 22.5.4].
class complex_route {
public:
    complex_route(const rational& m, const rational& complement) : circular_(m == 0), hyperbolic_(complement == 0) {
        if (circular_ || hyperbolic_) {
            return;
        }
        quarter_ = complete(m);
        tau_ = complex_ball(ball(0), ball(1)) * complete(complement) / quarter_;
        at_zero_ = thetas(complex_ball(ball(0), ball(0)));
    }

    /// pq(x + iy).
    complex_ball operator()(std::string_view name, const rational& x, const rational& y) const {
        const complex_ball u(from_rational<ball>(x), from_rational<ball>(y));
        if (circular_ || hyperbolic_) {
            return elementary(name[0], u) / elementary(name[1], u);
        }
        const auto at = thetas(u / quarter_ / complex_ball(ball(2), ball(0)));
        return over_fourth(name[0], at) / over_fourth(name[1], at);
    }

private:
    static complex_ball complete(const rational& m) {
        complex_ball result(from_rational<ball>(m), ball(0));
        acb_elliptic_k(result.handle(), result.handle(), ball::working_bits());
        return result;
    }

    std::array<complex_ball, 4> thetas(const complex_ball& z) const {
        std::array<complex_ball, 4> values;
        acb_modular_theta(values[0].handle(), values[1].handle(), values[2].handle(), values[3].handle(), z.handle(),
                          tau_.handle(), ball::working_bits());
        return values;
    }

    // sn, cn, dn or 1, times theta_4(z).
    complex_ball over_fourth(char letter, const std::array<complex_ball, 4>& at) const {
        switch (letter) {
            case 's': return at_zero_[2] / at_zero_[1] * at[0];
            case 'c': return at_zero_[3] / at_zero_[1] * at[1];
            case 'd': return at_zero_[3] / at_zero_[2] * at[2];
            default: return at[3];
        }
    }

    // For m = 0 sn = sin, cn = cos, dn = 1; for m = 1 sn = sinh/cosh, cn = dn = 1/cosh, all times cosh.
    complex_ball elementary(char letter, const complex_ball& u) const {
        complex_ball result(ball(1), ball(0));
        if (letter == 's') {
            (circular_ ? acb_sin : acb_sinh)(result.handle(), u.handle(), ball::working_bits());
        } else if (letter == (circular_ ? 'c' : 'n')) {
            (circular_ ? acb_cos : acb_cosh)(result.handle(), u.handle(), ball::working_bits());
        }
        return result;
    }

    bool circular_, hyperbolic_;
    complex_ball quarter_;  ///< K
    complex_ball tau_;
    std::array<complex_ball, 4> at_zero_;
};

}  // namespace libration::tests
