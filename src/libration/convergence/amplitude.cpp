#include "amplitude.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace libration::convergence {

namespace {

constexpr int most_orders = 6;

// The last b_k/c_k, as many as Neville's scheme needs for two values of each order; empty if some c_k is 0.
std::vector<mpfr> ratios_of(std::span<const mpfr> b, const mpfr& x0, const mpfr& t, bool is_logarithm) {
    const auto last = static_cast<int>(b.size()) - 1;
    const int from = last - most_orders - 2;
    const int power = is_logarithm ? round(t).convert_to<int>() : -1;  // m of (1 - x)^m log(1 - x)
    if (from <= power || power > last) {
        return {};
    }
    std::vector<mpfr> ratios;
    mpfr c(1);
    if (is_logarithm) {
        c = mpfr(power % 2 == 0 ? -1 : 1) / (power + 1);
    }
    mpfr scale = is_logarithm ? pow(x0, power + 1) : mpfr(1);
    for (int k = is_logarithm ? power + 1 : 0; k <= last; ++k) {
        if (k >= from) {
            if (c == 0) {
                return {};
            }
            ratios.push_back(b[static_cast<std::size_t>(k)] * scale / c);
        }
        c *= is_logarithm ? mpfr(k - power) / (k + 1) : mpfr((k - t) / (k + 1));
        scale *= x0;
    }
    return ratios;
}

// The extrapolated values of the orders 0 .. 6 from the ratios up to `last`, and from those up to `last` - 1.
std::vector<std::pair<mpfr, mpfr>> neville(std::vector<mpfr> ratios, int last) {
    std::vector<std::pair<mpfr, mpfr>> orders;
    for (int i = 0; i <= most_orders; ++i) {
        orders.emplace_back(ratios.back(), ratios[ratios.size() - 2]);
        for (std::size_t j = ratios.size(); j-- > 1;) {
            const int k = last - static_cast<int>(ratios.size() - 1 - j);
            ratios[j] = (ratios[j] * k - ratios[j - 1] * (k - i - 1)) / (i + 1);
        }
        ratios.erase(ratios.begin());
    }
    return orders;
}

}  // namespace

std::optional<exponent_estimate> amplitude_of(std::span<const mpfr> b, const exponent_estimate& position,
                                              const exponent_estimate& exponent, bool is_logarithm) {
    const auto last = static_cast<int>(b.size()) - 1;
    const auto orders_at = [&](const mpfr& x0, const mpfr& t) {
        auto ratios = ratios_of(b, x0, t, is_logarithm);
        return ratios.empty() ? std::vector<std::pair<mpfr, mpfr>>() : neville(std::move(ratios), last);
    };
    const auto orders = orders_at(position.value, exponent.value);
    if (orders.empty()) {
        return std::nullopt;
    }
    const auto change = [](const auto& each) { return mpfr(abs(each.first - each.second)); };
    const auto best = std::ranges::min_element(orders, {}, change) - orders.begin();
    const auto at = static_cast<std::size_t>(best);
    exponent_estimate found{orders[at].first, change(orders[at])};
    if (at > 0) {
        found.uncertainty = std::max(found.uncertainty, mpfr(abs(orders[at].first - orders[at - 1].first)));
    }
    if (at + 1 < orders.size()) {
        found.uncertainty = std::max(found.uncertainty, mpfr(abs(orders[at].first - orders[at + 1].first)));
    }
    found.uncertainty *= 4;
    const mpfr shifted_exponent = is_logarithm ? exponent.value : mpfr(exponent.value + exponent.uncertainty);
    for (const auto& moved : {orders_at(mpfr(position.value + position.uncertainty), exponent.value),
                              orders_at(position.value, shifted_exponent)}) {
        if (moved.empty()) {
            return std::nullopt;
        }
        found.uncertainty = std::max(found.uncertainty, mpfr(abs(moved[at].first - found.value)));
    }
    return found.uncertainty < abs(found.value) ? std::optional(std::move(found)) : std::nullopt;
}

}  // namespace libration::convergence
