#include "root_time.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "libration/equation/defined_zero.hpp"
#include "libration/equation/hybrid_system.hpp"
#include "libration/equation/node_values.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr int largest_degree = 64;

// slope (t - time) under a root of this degree, real on both sides if odd.
struct linear_root {
    number slope, time;
    rational exponent;
    bool cubic;
};

std::optional<linear_root> linear_root_of(const expression& e) {
    rational exponent;
    bool cubic = false;
    if (e.kind() == node_kind::power) {
        const auto fraction = e.right().fraction();
        if (!fraction || denominator(*fraction) == 1) {
            return std::nullopt;
        }
        exponent = *fraction;
    } else if (e.kind() == node_kind::function && e.function() == function_kind::sqrt) {
        exponent = rational(1, 2);
    } else if (e.kind() == node_kind::function && e.function() == function_kind::cbrt) {
        exponent = rational(1, 3);
        cubic = true;
    } else {
        return std::nullopt;
    }
    if (denominator(exponent) > largest_degree) {
        return std::nullopt;
    }
    try {
        const auto base = linear_in_variable::of(e.left());
        return base ? std::optional(linear_root{base->slope, base->time_of(number()), exponent, cubic}) : std::nullopt;
    } catch (const error&) {
        return std::nullopt;  // whether u depends on t is not decided
    }
}

// False if it is not decided: the root remains a root then, and no step leads to its time.
bool is_same(const number& a, const number& b) {
    try {
        return (a - b).sign() == 0;
    } catch (const error&) {
        return false;
    }
}

void add_root(std::vector<root_time>& times, std::vector<bool>& impossible, const linear_root& root) {
    const int side = root.cubic ? 1 : root.slope.sign();
    const int degree = denominator(root.exponent).convert_to<int>();
    for (std::size_t i = 0; i < times.size(); ++i) {
        root_time& known = times[i];
        if (!is_same(known.time, root.time)) {
            continue;
        }
        known.degree = std::lcm(known.degree, degree);
        impossible[i] = impossible[i] || known.degree > largest_degree;
        if (!root.cubic) {
            impossible[i] = impossible[i] || (!known.both && known.side != side);
            known.side = side;
            known.both = false;
        }
        return;
    }
    times.push_back({root.time, degree, side, root.cubic});
    impossible.push_back(false);
}

// (slope (t - tau))^exponent = (slope side)^exponent w^(exponent degree), slope side > 0 or the root cubic.
expression power_of_root(const linear_root& root, const root_time& about) {
    const expression factor = root.cubic ? cbrt(expression(root.slope) * expression(about.side))
                                         : pow(expression(root.slope) * expression(about.side), root.exponent);
    return factor * pow(variable(), expression(rational(root.exponent * about.degree)));
}

// w^exponent rest.
struct factored_power {
    long exponent = 0;
    expression rest;

    expression product() const { return exponent == 0 ? rest : pow(variable(), expression(rational(exponent))) * rest; }
};

// With as many factors w as are visible, so that those of dt/dw cancel negative powers.
factored_power factored(const expression& whole) {
    node_values<factored_power> done;
    return done.of(whole, [&](const expression& e) -> factored_power {
        switch (e.kind()) {
            case node_kind::variable: return {1, 1};
            case node_kind::product: {
                const auto& [a, left] = done.at(e.left());
                const auto& [b, right] = done.at(e.right());
                if (e.is_unfolded_zero()) {
                    const expression zero = zero_where_defined(right);
                    return {zero.is(0) ? 0 : b, zero};
                }
                return {a + b, left * right};
            }
            case node_kind::quotient: {
                const auto& [a, left] = done.at(e.left());
                const auto& [b, right] = done.at(e.right());
                return {a - b, left / right};
            }
            case node_kind::sum: {
                const auto& [a, left] = done.at(e.left());
                const auto& [b, right] = done.at(e.right());
                const long least = left.is(0) ? b : right.is(0) ? a : std::min(a, b);
                return {least, factored_power{a - least, left}.product() + factored_power{b - least, right}.product()};
            }
            case node_kind::power: {
                const auto& base = done.at(e.left());
                const auto n = e.right().fraction();
                if (n && denominator(*n) == 1) {
                    return {base.exponent * numerator(*n).convert_to<long>(), pow(base.rest, e.right())};
                }
                return {0, pow(base.product(), e.right())};
            }
            case node_kind::function: return {0, with_argument(e, done.at(e.left()).product())};
            case node_kind::constant:
            case node_kind::unknown:
            case node_kind::parameter: break;
        }
        return {0, e};
    });
}

// dy/dw from dy/dt in w.
expression slope_in_root(const expression& slope, const root_time& about) {
    const auto [exponent, rest] = factored(slope);
    return expression(about.degree * about.side) * factored_power{exponent + about.degree - 1, rest}.product();
}

}  // namespace

std::vector<root_time> root_times(const explicit_system& system) {
    std::vector<root_time> times;
    std::vector<bool> impossible;
    node_values<bool> seen;
    for (const expression& right : system.right()) {
        seen.of(right, [&](const expression& e) {
            if (const auto root = linear_root_of(e)) {
                add_root(times, impossible, *root);
            }
            return true;
        });
    }
    std::vector<root_time> possible;
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (!impossible[i]) {
            possible.push_back(std::move(times[i]));
        }
    }
    return possible;
}

expression in_root(const expression& e, const root_time& about) {
    const expression time = expression(about.time) + expression(about.side) * pow(variable(), about.degree);
    return with_nodes_replaced(e, [&](const expression& node) -> std::optional<expression> {
        if (node.kind() == node_kind::variable) {
            return time;
        }
        const auto root = linear_root_of(node);
        return root && is_same(root->time, about.time) ? std::optional(power_of_root(*root, about)) : std::nullopt;
    });
}

explicit_system in_root(const first_order_form& form, const root_time& about, const number& point) {
    std::vector<expression> slopes;
    for (const expression& each : form.slopes) {
        slopes.push_back(slope_in_root(in_root(each, about), about));
    }
    return explicit_system::first_order(form.leaves, std::move(slopes), point);
}

explicit_system in_root_of_start(const explicit_system& system) {
    const root_time about{system.point(), system.singular()->root, 1, false};
    const first_order_form form(system);
    equation_system made;
    made.variable = "w";
    for (std::size_t k = 0; k < form.leaves.size(); ++k) {
        made.add(derivative(form.leaves[k]), slope_in_root(in_root(form.slopes[k], about), about));
        made.begin(form.leaves[k], expression(form.starts[k]), expression(0));
    }
    return explicit_system(made);
}

}  // namespace libration::ode
