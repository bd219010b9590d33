#include "libration/elliptic/digits_enclosure.hpp"

#include "given_parameter.hpp"
#include "libration/digits/proved_decimals.hpp"
#include "libration/elliptic/proved_functions.hpp"
#include "libration/number/given_number.hpp"

namespace libration::proved {

using namespace elliptic;

namespace {

// The digits of a function, plus those that its argument loses.
template <class Function>
proved_decimal digits_of(long digits, long before, const Function& function) {
    return proved_value(given_digits(digits), [&] {
        const precision_scope wider(working_digits() + before);
        return function();
    });
}

proved_decimal jacobi_digits(elliptic::jacobi_function f, const std::string& u, const elliptic::given_modulus& modulus,
                             long digits) {
    const elliptic::exact_parameter p = exact_parameter_of(modulus);
    const exact at = exact_argument(u);
    return digits_of(digits, digits_before_point(at), [&] { return jacobi_value(f, at, p); });
}

}  // namespace

proved_decimal am(const std::string& u, const elliptic::given_modulus& modulus, long digits) {
    return jacobi_digits(elliptic::jacobi_function::am, u, modulus, digits);
}
proved_decimal sn(const std::string& u, const elliptic::given_modulus& modulus, long digits) {
    return jacobi_digits(elliptic::jacobi_function::sn, u, modulus, digits);
}
proved_decimal cn(const std::string& u, const elliptic::given_modulus& modulus, long digits) {
    return jacobi_digits(elliptic::jacobi_function::cn, u, modulus, digits);
}
proved_decimal dn(const std::string& u, const elliptic::given_modulus& modulus, long digits) {
    return jacobi_digits(elliptic::jacobi_function::dn, u, modulus, digits);
}

proved_decimal K(const elliptic::given_modulus& modulus, long digits) {
    const elliptic::exact_parameter p = exact_parameter_of(modulus);
    return p.complement().is_zero() ? proved_decimal{"inf", "0"}
                                    : digits_of(digits, 0, [&] { return complete_integral(p.shape<ball>()); });
}

proved_decimal F(const std::string& phi, const elliptic::given_modulus& modulus, long digits) {
    const elliptic::exact_parameter p = exact_parameter_of(modulus);
    const exact at = given_angle("amplitude", phi);
    if (const int sign = infinite_sign(at, p); sign != 0) {
        return {sign < 0 ? "-inf" : "inf", "0"};
    }
    return digits_of(digits, digits_before_point(at), [&] { return incomplete_value(at, p); });
}

}  // namespace libration::proved
