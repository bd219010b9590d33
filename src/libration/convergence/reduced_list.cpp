#include "reduced_list.hpp"

#include <algorithm>
#include <cstddef>

#include "libration/scalar/integer_power.hpp"

namespace libration::convergence {

reduced_list::reduced_list(const series_list& list, std::span<const mpfr> noise, long bits)
    : unit_(level_unit(list.values)) {
    const auto scaled = in_unit(list.values, unit_, bits);
    auto errors = in_unit(noise, unit_, bits);
    errors.resize(scaled.size(), mpfr(0));
    pattern_ = pattern_of(list);
    for (int n = 0; n <= pattern_.order; ++n) {
        const auto at = static_cast<std::size_t>(n);
        const bool in_class = !pattern_.polynomial && pattern_.last >= 0 && n % pattern_.stride == pattern_.first;
        if (in_class) {
            b_.push_back(scaled[at]);
            noise_.push_back(abs(errors[at]));
        }
        // Later ones are zeros with a rounding error.
        const bool outside = !in_class && (pattern_.polynomial ? n <= pattern_.last : 4 * n <= pattern_.order);
        outside_.push_back(outside ? scaled[at] : mpfr(0));
        noise_outside_.push_back(outside ? mpfr(abs(errors[at])) : mpfr(0));
    }
}

bool reduced_list::is_exact() const {
    return std::ranges::all_of(noise_, [](const mpfr& each) { return each == 0; });
}

mpfr reduced_list::point(const mpfr& x) const { return integer_power(mpfr(x / unit_), pattern_.stride); }

mpfr reduced_list::place_of(const mpfr& z, const mpfr& towards) const {
    const mpfr modulus = exp(mpfr(log(mpfr(abs(z))) / pattern_.stride)) * unit_;
    return towards < 0 ? mpfr(-modulus) : modulus;
}

reduced_list::value_with_error reduced_list::complete(const value_with_error& g, const mpfr& x) const {
    const mpfr y = x / unit_;
    const mpfr modulus = abs(y);
    const mpfr factor = integer_power(y, pattern_.first);
    value_with_error f{mpfr(0), mpfr(0)};
    for (std::size_t n = outside_.size(); n-- > 0;) {
        f.value = f.value * y + outside_[n];
        f.error = f.error * modulus + noise_outside_[n];
    }
    f.value += g.value * factor;
    f.error += g.error * mpfr(abs(factor));
    return f;
}

}  // namespace libration::convergence
