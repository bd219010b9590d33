#include "libration/convergence/written_list.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <string>

#include "libration/convergence/coefficient_noise.hpp"

namespace libration::convergence {

namespace {

constexpr long exact_from = 60;  // digits of decimals that are not taken as rounded

// Significant digits of a decimal; 0 for other numbers.
long decimals_of(const exact& number) { return number.composed ? 0 : written_digits(number); }

// The last decimal place that is written: 4 for 1.25e-2; negative before the point.
long places_of(const exact& number) {
    const std::string& text = number.text;
    const std::size_t exponent_at = std::min(text.find_first_of("eE"), text.size());
    const std::size_t point = std::min(text.find('.'), exponent_at);
    const long behind = point == exponent_at ? 0 : static_cast<long>(exponent_at - point) - 1;
    return behind - (exponent_at == text.size() ? 0 : std::strtol(text.c_str() + exponent_at + 1, nullptr, 10));
}

mpfr power_of_ten(long exponent) { return pow(mpfr(10), static_cast<int>(exponent)); }

}  // namespace

written_list written_list_of(const std::vector<exact>& coefficients, std::optional<long> rounded) {
    written_list written;
    std::vector<long> digits;
    std::vector<long> places;
    for (const exact& each : coefficients) {
        written.list.values.push_back(from_exact<mpfr>(each));
        if (const long count = decimals_of(each); count > 0) {
            digits.push_back(count);
            places.push_back(places_of(each));
        }
    }
    if (digits.empty() || rounded == 0) {
        return written;
    }
    const auto middle = digits.begin() + static_cast<std::ptrdiff_t>(digits.size() / 2);
    std::nth_element(digits.begin(), middle, digits.end());
    if (!rounded && *middle >= exact_from) {
        return written;
    }
    const mpfr relative = power_of_ten(1 - rounded.value_or(*middle)) / 2;
    const mpfr absolute = rounded ? mpfr(0) : mpfr(power_of_ten(-*std::max_element(places.begin(), places.end())) / 2);
    written.list.noise = relative.convert_to<double>();
    written.list.zero = written.list.noise;
    for (std::size_t n = 0; n < coefficients.size(); ++n) {
        const bool decimal = decimals_of(coefficients[n]) > 0;
        written.rounding.push_back(decimal ? mpfr(abs(written.list.values[n]) * relative + absolute) : mpfr(0));
    }
    return written;
}

}  // namespace libration::convergence
