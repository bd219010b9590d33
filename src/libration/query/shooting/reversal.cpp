#include "reversal.hpp"

#include <cmath>

#include "../../equation/power_sum.hpp"
#include "libration/equation/constant_value.hpp"

namespace libration::ode {

namespace {

constexpr std::size_t most_zeros = 12;

expression reversed(const expression& e, const first_order_form& form, const std::vector<int>& signs) {
    return replaced(e, [&](const expression& leaf) -> std::optional<expression> {
        for (std::size_t k = 0; k < form.leaves.size(); ++k) {
            if (signs[k] < 0 && same_form(leaf, form.leaves[k])) {
                return -leaf;
            }
        }
        return std::nullopt;
    });
}

bool is_zero_sum(const expression& e) {
    try {
        power_sums sums;
        const power_sum sum = sums.of(e);
        return !sums.relations(std::vector<power_sum>{sum}).empty();
    } catch (const no_power_sum&) {
        return false;
    }
}

bool is_reversal(const first_order_form& form, const std::vector<int>& signs) {
    for (std::size_t i = 0; i < signs.size(); ++i) {
        const expression turned = reversed(form.slopes[i], form, signs);
        if (!is_zero_sum(signs[i] > 0 ? turned + form.slopes[i] : turned - form.slopes[i])) {
            return false;
        }
    }
    return true;
}

// Whether it holds at one point, in double precision.
bool may_be_reversal(const first_order_form& form, const std::vector<int>& signs) {
    std::vector<double> point;
    std::vector<double> mirrored;
    for (std::size_t i = 0; i < signs.size(); ++i) {
        const double start = constant_value<double>::of(form.starts[i]);
        point.push_back(start + 0.01 * std::sin(1.0 + 2.7 * static_cast<double>(i)));
        mirrored.push_back(signs[i] * point.back());
    }
    const auto here = form.slopes_at(point, 0.0);
    const auto there = form.slopes_at(mirrored, 0.0);
    for (std::size_t i = 0; i < signs.size(); ++i) {
        const double sum = there[i] + signs[i] * here[i];
        if (!(std::abs(sum) <= 1e-9 * (1 + std::abs(here[i])))) {
            return false;
        }
    }
    return true;
}

}  // namespace

bool is_odd_under(const first_order_form& form, const expression& e, const std::vector<int>& signs) {
    return is_zero_sum(reversed(e, form, signs) + e);
}

std::vector<int> reversal_of(const first_order_form& form) {
    std::vector<std::size_t> zeros;
    for (std::size_t i = 0; i < form.starts.size(); ++i) {
        const auto start = form.starts[i].fraction();
        if (start && *start == 0) {
            zeros.push_back(i);
        }
    }
    if (zeros.size() > most_zeros) {
        return {};
    }
    for (std::size_t subset = 1; subset < (std::size_t{1} << zeros.size()); ++subset) {
        std::vector<int> signs(form.starts.size(), 1);
        for (std::size_t k = 0; k < zeros.size(); ++k) {
            signs[zeros[k]] = (subset >> k) % 2 == 1 ? -1 : 1;
        }
        if (may_be_reversal(form, signs) && is_reversal(form, signs)) {
            return signs;
        }
    }
    return {};
}

}  // namespace libration::ode
