#include <algorithm>
#include <cstdlib>
#include <string>

#include "certificate.hpp"
#include "libration/scalar/decimal.hpp"

namespace libration::ode {

decimal_interval within_one_unit(const std::string& decimal, long digits) {
    const bool negative = decimal.starts_with('-');
    const std::size_t e = decimal.find('e');
    std::string mantissa = decimal.substr(negative ? 1 : 0, e - (negative && e != std::string::npos ? 1 : 0));
    long exponent = e == std::string::npos ? 0 : std::stol(decimal.substr(e + 1));
    if (const std::size_t point = mantissa.find('.'); point != std::string::npos) {
        exponent -= static_cast<long>(mantissa.size() - point - 1);
        mantissa.erase(point, 1);
    }
    integer whole(mantissa.substr(std::min(mantissa.find_first_not_of('0'), mantissa.size() - 1)));
    whole = negative ? integer(-whole) : whole;
    if (whole == 0) {
        exponent = -digits;
    }
    const integer power = pow(integer(10), static_cast<unsigned>(std::abs(exponent)));
    const auto scaled = [&](const integer& n) {
        return exponent < 0 ? rational(n, power) : rational(integer(n * power));
    };
    const auto text = [&](const integer& n) {
        const std::string units = integer(abs(n)).str();
        return n == 0 ? std::string("0") : place_point(n < 0, units, exponent + static_cast<long>(units.size()));
    };
    const integer below = whole - 1;
    const integer above = whole + 1;
    return {text(below), text(above), scaled(below), scaled(above)};
}

}  // namespace libration::ode
