#include "libration/elliptic/digits.hpp"

#include "given_parameter.hpp"
#include "libration/digits/agreed_values.hpp"
#include "libration/digits/bounded_value.hpp"
#include "libration/number/given_number.hpp"
#include "libration/scalar/decimal.hpp"

namespace libration::rounded {

using namespace elliptic;

namespace {

// The digits of a function without a bound, plus those that its argument loses.
template <class Function>
rounded_decimal agreed(long digits, long before, const Function& function) {
    const auto compute = [&](long guard) {
        const precision_scope scope(given_digits(digits) + before + guard);
        return std::vector<mpfr>{function()};
    };
    return {to_decimal(agreed_values(digits, compute).front(), digits)};
}

rounded_decimal jacobi_digits(elliptic::jacobi_function f, const std::string& u, const elliptic::given_modulus& modulus,
                              long digits) {
    const elliptic::exact_parameter p = exact_parameter_of(modulus);
    const exact at = exact_argument(u);
    return agreed(digits, digits_before_point(at), [&] { return jacobi_value<mpfr>(f, at, p); });
}

}  // namespace

rounded_decimal am(const std::string& u, const elliptic::given_modulus& modulus, long digits) {
    return jacobi_digits(elliptic::jacobi_function::am, u, modulus, digits);
}
rounded_decimal sn(const std::string& u, const elliptic::given_modulus& modulus, long digits) {
    return jacobi_digits(elliptic::jacobi_function::sn, u, modulus, digits);
}
rounded_decimal cn(const std::string& u, const elliptic::given_modulus& modulus, long digits) {
    return jacobi_digits(elliptic::jacobi_function::cn, u, modulus, digits);
}
rounded_decimal dn(const std::string& u, const elliptic::given_modulus& modulus, long digits) {
    return jacobi_digits(elliptic::jacobi_function::dn, u, modulus, digits);
}

rounded_decimal K(const elliptic::given_modulus& modulus, long digits) {
    const elliptic::exact_parameter p = exact_parameter_of(modulus);
    if (p.complement().is_zero()) {
        return {"inf"};
    }
    // The chain has at most 64 levels, each of which adds less than 2 epsilon; k' and the quotient add 3.
    const auto compute = [&] {
        const mpfr value = complete_integral(p.shape<mpfr>());
        return bounded_value{value, value * epsilon<mpfr>() * 256};
    };
    constexpr long lost = 3;
    return {to_decimal(value_within_bound(given_digits(digits), lost, compute), digits)};
}

rounded_decimal F(const std::string& phi, const elliptic::given_modulus& modulus, long digits) {
    const elliptic::exact_parameter p = exact_parameter_of(modulus);
    const exact at = given_angle("amplitude", phi);
    if (const int sign = infinite_sign(at, p); sign != 0) {
        return {sign < 0 ? "-inf" : "inf"};
    }
    return agreed(digits, digits_before_point(at), [&] { return incomplete_value<mpfr>(at, p); });
}

}  // namespace libration::rounded
