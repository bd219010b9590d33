#include "coefficient_tables.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "answer_table.hpp"
#include "libration/algebra/polynomial_roots.hpp"
#include "libration/convergence/coefficient_unit.hpp"
#include "option/options.hpp"

namespace libration {

using namespace series;
using namespace convergence;

namespace {

constexpr long first_guard = 30;

// a_n u^n of coefficients in their own precision.
power_series<mpfr> scaled(const power_series<mpfr>& a, const mpfr& unit) {
    std::vector<mpfr> values;
    mpfr power(1);
    for (int n = 0; n <= a.order(); ++n, power *= unit) {
        values.push_back(mpfr(a[n] * power));
    }
    return power_series<mpfr>(std::move(values));
}

// The power of t that symmetry leaves: the greatest common divisor of the steps between the coefficients behind a_0
// that are not 0; 1 where there are not two of them.
int power_left(const power_series<mpfr>& a) {
    int first = 0;
    int power = 0;
    for (int n = 1; n <= a.order(); ++n) {
        if (a[n] != 0) {
            first = first == 0 ? n : first;
            power = std::gcd(power, n - first);
        }
    }
    return std::max(power, 1);
}

struct pole_or_zero {
    const char* kind;
    complex_number<mpfr> at;
};

// The roots with im >= 0; none of a constant.
std::vector<pole_or_zero> upper_roots(const char* kind, power_series<mpfr> p, const mpfr& unit) {
    int degree = p.order();
    while (degree > 0 && p[degree] == 0) {
        --degree;
    }
    std::vector<pole_or_zero> found;
    if (degree == 0) {
        return found;
    }
    for (const auto& root : roots_of(p.truncated(degree)).all) {
        const bool real = abs(root.at.im) <= root.error_bound;
        if (real || root.at.im > 0) {
            found.push_back({kind, complex_number<mpfr>{root.at.re, real ? mpfr(0) : root.at.im} * unit});
        }
    }
    return found;
}

std::optional<mpfr> distance_to_other_kind(const pole_or_zero& from, const std::vector<pole_or_zero>& all) {
    std::optional<mpfr> least;
    for (const auto& other : all) {
        if (other.kind != from.kind) {
            const mpfr apart = modulus_of(other.at - from.at);
            least = least && *least < apart ? *least : apart;
        }
    }
    return least;
}

std::optional<mpfr> nth_root(const mpfr& x, int n) {
    return x == 0 ? std::nullopt : std::optional(mpfr(exp(mpfr(log(x)) / n)));
}

// The ratios of coefficients in t^p behind a_0 (all of them if p is 1), empty where they do not exist.
class ratios_in_power {
public:
    ratios_in_power(const power_series<mpfr>& a, int power) : a_(a), power_(power), first_(power == 1 ? 0 : 1) {}

    // a_n/a_{n-p}.
    std::optional<mpfr> single(int n) const {
        return n - power_ < first_ || a_[n - power_] == 0 ? std::nullopt : std::optional(mpfr(a_[n] / a_[n - power_]));
    }
    // (D_n/D_{n-p})^(1/2).
    std::optional<mpfr> of_pair(int n) const {
        if (n - 2 * power_ < first_ || n + power_ > a_.order()) {
            return std::nullopt;
        }
        const mpfr before = determinant(n - power_);
        const mpfr now = determinant(n);
        return before == 0 || now == 0 || (before < 0) != (now < 0) ? std::nullopt
                                                                    : std::optional(mpfr(sqrt(mpfr(now / before))));
    }

private:
    mpfr determinant(int n) const { return mpfr(a_[n + power_] * a_[n - power_] - a_[n] * a_[n]); }

    const power_series<mpfr>& a_;
    int power_, first_;
};

}  // namespace

// The linear system of an approximant loses less than a digit and a half with each degree, and its roots as many again.
long digits_for_poles(long digits, int order) { return digits + first_guard + 3L * order; }

long digits_for_ratios(long digits) { return digits + first_guard; }

pade_approximant<mpfr> pade_of_list(const power_series<mpfr>& a) {
    for (int m = a.order() / 2; m > 0; --m) {
        if (auto found = pade(a, a.order() - m, m)) {
            return *std::move(found);
        }
    }
    return {a, power_series<mpfr>(std::vector<mpfr>{mpfr(1)})};
}

table poles_of(const power_series<mpfr>& a, long digits) {
    mpfr unit;
    {
        const precision_scope scope(40);
        unit = unit_of(a).length;
    }
    const precision_scope scope(digits_for_poles(digits, a.order()));
    const auto found = pade_of_list(scaled(a, unit));
    const char* const pole = "pole";
    const char* const zero = "zero";
    auto all = upper_roots(pole, found.denominator, unit);
    const auto zeros = upper_roots(zero, found.numerator, unit);
    all.insert(all.end(), zeros.begin(), zeros.end());
    std::stable_sort(all.begin(), all.end(),
                     [](const auto& near, const auto& far) { return modulus_of(near.at) < modulus_of(far.at); });
    table data({{"kind", ""}, {"position_re", ""}, {"position_im", ""}, {"modulus", ""}, {"distance", ""}});
    for (const auto& each : all) {
        data.add_row({each.kind, decimal_cell(each.at.re, digits), decimal_cell(each.at.im, digits),
                      decimal_cell(modulus_of(each.at), digits),
                      decimal_cell(distance_to_other_kind(each, all), error_digits)});
    }
    return data;
}

table ratios_of(const power_series<mpfr>& a, long digits) {
    const precision_scope scope(digits_for_ratios(digits));
    table data({{"n", ""},
                {"inverse_n", ""},
                {"ratio", ""},
                {"root", ""},
                {"corrected_root", ""},
                {"power", ""},
                {"ratio_in_power", ""},
                {"pair_ratio", ""}});
    const int power = power_left(a);
    const ratios_in_power successive(a, 1);
    const ratios_in_power in_power(a, power);
    for (int n = 1; n <= a.order(); ++n) {
        const mpfr size = abs(a[n]);
        data.add_row({n, decimal_cell(mpfr(mpfr(1) / n), digits), decimal_cell(successive.single(n), digits),
                      decimal_cell(nth_root(size, n), digits), decimal_cell(nth_root(mpfr(size * n), n), digits), power,
                      decimal_cell(in_power.single(n), digits), decimal_cell(in_power.of_pair(n), digits)});
    }
    return data;
}

table tests_of(const answer& found) {
    const table data = table_of(found).without_lists();
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < data.columns().size(); ++i) {
        if (data.columns()[i].name != "note") {
            places.push_back(i);
        }
    }
    return data.with_columns(places);
}

}  // namespace libration
