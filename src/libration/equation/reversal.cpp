#include "reversal.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "libration/equation/constant_value.hpp"
#include "power_sum.hpp"

namespace libration::ode {

namespace {

constexpr std::size_t most_zeros = 12;

// 1 for f(-x) = f(x), -1 for f(-x) = -f(x), else 0.
int parity_of(function_kind f) {
    using enum function_kind;
    static constexpr std::array odd{sin, tan, asin, atan, sinh, tanh, asinh, atanh, cbrt, erf};
    static constexpr std::array even{cos, cosh, sinc};
    return std::ranges::find(odd, f) != odd.end() ? -1 : std::ranges::find(even, f) != even.end() ? 1 : 0;
}

// Expressions with the arguments of their functions as sums of products of powers, of which sin and cos have no multiple of pi/2
// and functions with parity the sign of their last term: sin(2*pi - y) is -sin(y).
class argument_forms {
public:
    expression in(const expression& e) {
        return with_nodes_replaced(e, [this](const expression& each) -> std::optional<expression> {
            return each.kind() == node_kind::function && parity_of(each.function()) != 0
                       ? std::optional(reduced(each.function(), in(each.left())))
                       : std::nullopt;
        });
    }

private:
    // Throws no_power_sum.
    expression reduced(function_kind f, const expression& argument) {
        power_sum sum = sums_.of(argument);
        int sign = 1;
        if (f == function_kind::sin || f == function_kind::cos) {
            // sin(x + pi/2) = cos(x), cos(x + pi/2) = -sin(x).
            for (int turns = take_quarter_turns(sum); turns > 0; --turns) {
                sign = f == function_kind::cos ? -sign : sign;
                f = f == function_kind::cos ? function_kind::sin : function_kind::cos;
            }
        }
        if (!sum.empty() && sum.rbegin()->second < 0) {
            sign *= parity_of(f);
            for (auto& term : sum) {
                term.second = -term.second;
            }
        }
        return sign * apply(f, typed(sum));
    }

    // Removes the multiples k pi/2 of a sum: the sum of all k, from 0 to 3.
    int take_quarter_turns(power_sum& sum) const {
        rational turns = 0;
        std::erase_if(sum, [&](const auto& term) {
            const auto& product = term.first;
            if (product.size() != 1 || product.front().second != 1) {
                return false;
            }
            const expression& base = sums_.bases()[product.front().first].typed;
            const auto value = base.kind() == node_kind::constant ? base.constant().plain() : std::nullopt;
            const rational quarters = value && value->measure == unit::pi ? 2 * value->coefficient * term.second : 0;
            const bool is_taken = quarters != 0 && denominator(quarters) == 1;
            turns += is_taken ? quarters : 0;
            return is_taken;
        });
        const integer rest = numerator(turns) % 4;
        return static_cast<int>(rest < 0 ? rest + 4 : rest);
    }

    expression typed(const power_sum& sum) const {
        expression all = 0;
        for (const auto& [product, factor] : sum) {
            expression term = factor;
            for (const auto& [index, exponent] : product) {
                term = term * pow(sums_.bases()[index].typed, exponent);
            }
            all = all + term;
        }
        return all;
    }

    power_sums sums_;
};

expression reversed(const expression& e, const first_order_form& form, const std::vector<int>& signs,
                    const std::vector<expression>& centre = {}) {
    return replaced(e, [&](const expression& leaf) -> std::optional<expression> {
        for (std::size_t k = 0; k < form.leaves.size(); ++k) {
            if (signs[k] < 0 && same_form(leaf, form.leaves[k])) {
                return centre.empty() ? -leaf : 2 * centre[k] - leaf;
            }
        }
        return std::nullopt;
    });
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

bool is_zero_sum(const expression& e) {
    try {
        power_sums sums;
        const power_sum sum = sums.of(argument_forms().in(e));
        return !sums.relations(std::vector<power_sum>{sum}).empty();
    } catch (const no_power_sum&) {
        return false;
    }
}

bool is_reversal(const first_order_form& form, const std::vector<int>& signs, const std::vector<expression>& centre) {
    for (std::size_t i = 0; i < signs.size(); ++i) {
        const expression turned = reversed(form.slopes[i], form, signs, centre);
        if (!is_zero_sum(signs[i] > 0 ? turned + form.slopes[i] : turned - form.slopes[i])) {
            return false;
        }
    }
    return true;
}

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
