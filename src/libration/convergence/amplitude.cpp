#include "amplitude.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "libration/algebra/linear_system.hpp"

namespace libration::convergence {

namespace {

constexpr std::size_t most_powers = 9;

// The coefficients of (1 - x/x0)^t, or of (1 - x/x0)^m log(1 - x/x0), m the integer next to t, up to the order `last`.
std::vector<mpfr> coefficients_of(const mpfr& x0, const mpfr& t, bool is_logarithm, int last) {
    std::vector<mpfr> c(static_cast<std::size_t>(last) + 1, mpfr(0));
    const int power = is_logarithm ? round(t).convert_to<int>() : -1;
    if (power >= last) {
        return c;
    }
    mpfr each(1);
    if (is_logarithm) {
        each = mpfr(power % 2 == 0 ? -1 : 1) / (power + 1) / pow(x0, power + 1);
    }
    for (int k = power + 1; k <= last; ++k) {
        c[static_cast<std::size_t>(k)] = each;
        each *= (is_logarithm ? mpfr(k - power) : mpfr(k - t)) / (k + 1) / x0;
    }
    return c;
}

// The functions of which the list is a sum, by their exponents; an integer power is none.
std::vector<std::vector<mpfr>> terms_of(const known_power& at, int last) {
    std::vector<mpfr> exponents;
    for (std::size_t i = 0; i < most_powers; ++i) {
        const auto more = static_cast<int>(i);
        exponents.push_back(at.exponent.value + more);
        if (at.second) {
            exponents.push_back(mpfr(*at.second) + more);
        }
    }
    const auto is_regular = [&](const mpfr& t) { return t > -0.5 && abs(mpfr(t - round(t))) < 1e-9; };
    if (!at.is_logarithm) {
        std::erase_if(exponents, is_regular);
    }
    std::ranges::sort(exponents);
    exponents.resize(std::min(exponents.size(), most_powers));
    std::vector<std::vector<mpfr>> terms;
    for (const mpfr& t : exponents) {
        terms.push_back(coefficients_of(at.position.value, t, at.is_logarithm, last));
    }
    return terms;
}

// The factor of the first function by the last `count` of the first `size` coefficients.
std::optional<mpfr> leading_factor(std::span<const mpfr> b, const std::vector<std::vector<mpfr>>& terms,
                                   std::size_t size, std::size_t count) {
    std::vector<std::vector<mpfr>> rows;
    std::vector<mpfr> right;
    for (std::size_t k = size - count; k < size; ++k) {
        const mpfr& unit = terms[0][k];
        if (unit == 0) {
            return std::nullopt;
        }
        std::vector<mpfr> row;
        for (std::size_t i = 0; i < count; ++i) {
            row.emplace_back(terms[i][k] / unit);
        }
        rows.push_back(std::move(row));
        right.emplace_back(b[k] / unit);
    }
    const auto solved = solve_linear(std::move(rows), std::move(right), mpfr(0));
    return solved ? std::optional((*solved)[0]) : std::nullopt;
}

// The factors by 1, 2, .. coefficients, until a system has no solution: pairs of that from all and that without the last.
std::vector<std::pair<mpfr, mpfr>> factors(std::span<const mpfr> b, const known_power& at) {
    const auto terms = terms_of(at, static_cast<int>(b.size()) - 1);
    std::vector<std::pair<mpfr, mpfr>> all;
    for (std::size_t count = 1; count <= terms.size() && count < b.size(); ++count) {
        auto now = leading_factor(b, terms, b.size(), count);
        auto before = leading_factor(b, terms, b.size() - 1, count);
        if (!now || !before) {
            break;
        }
        all.emplace_back(*std::move(now), *std::move(before));
    }
    return all;
}

// The error of the first of three values at lengths N, N/sqrt 2 and N/2 that approach their limit like N^-theta: the
// differences of neighbours have the ratio q = 2^(-theta/2), and what follows after the first is a geometric series.
mpfr error_by_rate(const mpfr& at_n, const mpfr& shorter, const mpfr& shortest) {
    const mpfr last = abs(mpfr(at_n - shorter));
    const mpfr before = abs(mpfr(shorter - shortest));
    const mpfr slowest = mpfr(19) / 20;  // theta = 0.15
    const mpfr q = before == 0 ? mpfr(0) : std::min(mpfr(last / before), slowest);
    return last * q / (1 - q);
}

}  // namespace

std::optional<exponent_estimate> amplitude_of(std::span<const mpfr> b, const known_power& at) {
    const auto& t = at.exponent;
    const mpfr nearest = round(t.value);
    const bool is_integer = abs(mpfr(t.value - nearest)) <= std::max(t.uncertainty, mpfr(1e-9));
    if (b.size() < 2 * (most_powers + 1) || (nearest >= 0 && is_integer && !at.is_logarithm)) {
        return std::nullopt;
    }
    const auto orders = factors(b, at);
    const auto shorter = factors(b.first(b.size() * 12 / 17), at);
    const auto shortest = factors(b.first(b.size() / 2), at);
    const std::size_t count = std::min({orders.size(), shorter.size(), shortest.size()});
    if (count == 0) {
        return std::nullopt;
    }
    const auto change = [&](std::size_t k) { return mpfr(abs(orders[k].first - orders[k].second)); };
    // Of two families of powers, every second one may change nothing.
    const std::size_t reach = at.second ? 2 : 1;
    const auto largest_change = [&](std::size_t k) {
        mpfr largest = change(k);
        for (std::size_t j = k; j-- > 0 && k - j <= reach;) {
            largest = std::max(largest, change(j));
        }
        return largest;
    };
    std::size_t i = 0;
    for (std::size_t k = 1; k < count; ++k) {
        i = largest_change(k) < largest_change(i) ? k : i;
    }
    exponent_estimate found{orders[i].first, change(i)};
    for (std::size_t near = i - std::min(i, reach); near < std::min(i + reach + 1, orders.size()); ++near) {
        found.uncertainty = std::max(found.uncertainty, mpfr(abs(found.value - orders[near].first)));
    }
    found.uncertainty *= 4;
    found.uncertainty =
        std::max(found.uncertainty, mpfr(2 * error_by_rate(found.value, shorter[i].first, shortest[i].first)));
    known_power moved = at;
    moved.position.value += at.position.uncertainty;
    known_power shifted = at;
    if (!at.is_logarithm) {
        shifted.exponent.value += t.uncertainty;
    }
    known_power beside = at;
    if (at.second) {
        constexpr double least = 1e-13;  // it is a double
        beside.second = *at.second + std::max(least, 10 * t.uncertainty.convert_to<double>());
    }
    for (const auto& each : {moved, shifted, beside}) {
        const auto others = factors(b, each);
        if (i >= others.size()) {
            return std::nullopt;
        }
        found.uncertainty = std::max(found.uncertainty, mpfr(abs(others[i].first - found.value)));
    }
    return found.uncertainty < abs(found.value) ? std::optional(std::move(found)) : std::nullopt;
}

}  // namespace libration::convergence
