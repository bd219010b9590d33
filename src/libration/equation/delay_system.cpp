#include "libration/equation/delay_system.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

// The value of an expression in the variable at a point.
number value_at(const expression& e, const number& point, const history& of) {
    try {
        return replaced(e, [&](const expression&) { return std::optional(expression(point)); }).constant();
    } catch (const error& problem) {
        refuse(of.unknown, of.at,
               "has a history that has no value at the initial point, because a number in it " + problem.reason() +
                   ": choose another");
    }
}

std::string slope_name(const delayed_value& of) { return "slope of " + of.parameter; }

// Derivatives of algebraic equations would contain those of delayed values.
void require_differential(const explicit_system& system) {
    if (!system.algebraic().empty()) {
        refuse("", {}, "has an algebraic equation, which is not supported with delays: solve it for an unknown");
    }
}

// The derivative of a leaf of a system by its name, x or x', in leaves of these names.
expression derivative_of_leaf(const std::string& name, const explicit_system& system) {
    for (std::size_t i = 0; i < system.unknowns().size(); ++i) {
        const unknown_function& each = system.unknowns()[i];
        for (int j = 0; j + 1 < each.order; ++j) {
            if (primed(each.name, j) == name) {
                return unknown(primed(each.name, j + 1));
            }
        }
        if (primed(each.name, each.order - 1) == name) {
            return replaced(system.right()[i], [](const expression& leaf) {
                return leaf.kind() == node_kind::unknown
                           ? std::optional(unknown(primed(leaf.name(), leaf.derivative())))
                           : std::nullopt;
            });
        }
    }
    return {};
}

// All parameters replaced.
expression with_parameters(const expression& e, const std::map<std::string, expression>& values) {
    return replaced(e, [&](const expression& leaf) {
        return leaf.kind() == node_kind::parameter ? std::optional(values.at(leaf.name())) : std::nullopt;
    });
}

// All leaves with numbers for the parameters that are not delayed values.
parameter_values parameters_of(const equation_system& given) {
    std::map<std::string, expression> open;
    for (const delayed_value& each : given.delays) {
        open.emplace(each.parameter, parameter(each.parameter));
    }
    return parameter_values(given, std::move(open));
}

}  // namespace

delay_system::delay_system(const equation_system& given, const std::optional<number>& last) : given_(given) {
    if (given.delays.empty()) {
        const history& first = given.histories.front();
        refuse(first.unknown, first.at,
               "has a history and is not delayed: write its initial value, as " + first.unknown + "(0) = 1");
    }
    given_.invariants.clear();
    given_.exact.clear();
    parameter_values parameters = parameters_of(given);
    for (equation& each : given_.equations) {
        each.left = parameters.in(each.left);
        each.right = parameters.in(each.right);
    }
    for (start& each : given_.starts) {
        each.point = parameters.in(each.point);
        each.value = parameters.in(each.value);
    }
    read_histories(parameters);
    read_delays(parameters);
    given_.parameters.clear();
    expand_slopes(last);
    order_delays();
    read_starts();
}

// Their values at the initial point are the initial values.
void delay_system::read_histories(parameter_values& parameters) {
    for (history& each : given_.histories) {
        each.point = expression(parameters.number_of(each.point));
        each.value = parameters.in(each.value);
        if (each.value.has_unknowns()) {
            refuse(each.unknown, each.at, "has a history that contains an unknown: write it in the variable");
        }
        const auto own = std::ranges::find(given_.starts, each.unknown, [](const start& s) { return s.of.name(); });
        if (own != given_.starts.end()) {
            refuse(each.unknown, own->at, "has a history, which contains the initial value: leave one of them out");
        }
    }
    for (const history& each : given_.histories) {
        expression value = each.value;
        for (int j = 0; j < given_.order_of(each.unknown); ++j) {
            const number start_value = value_at(value, each.point.constant(), each);
            given_.starts.push_back({unknown(each.unknown, j), each.point, expression(start_value), each.at});
            value = partial(value, ode::variable());
        }
    }
}

void delay_system::read_delays(parameter_values& parameters) {
    std::vector<delayed_value> values;
    for (delayed_value& each : given_.delays) {
        const std::string name = primed(each.of.name(), each.of.derivative());
        const int order = given_.order_of(each.of.name());
        if (each.of.derivative() > order || order == 0) {
            refuse(name, each.at, "is a delayed derivative that is higher than the highest one of its equation");
        }
        if (history_of(each.of.name()) == nullptr) {
            const std::string form = each.of.name() + "(" + given_.variable + " <= 0)";
            refuse(name, each.at, "is delayed and has no history: add " + form + " = number");
        }
        each.delay = expression(parameters.number_of(each.delay));
        if (each.delay.constant().sign() <= 0) {
            refuse(name, each.at, "has a delay that is not positive: choose a positive one");
        }
        if (each.of.derivative() == order) {
            slopes_.push_back({.value = each});
        } else {
            values.push_back(each);
        }
    }
    given_.delays = std::move(values);
}

// The right-hand side of x' = ..., without other highest derivatives.
expression delay_system::right_side_of(const delayed_value& slope) const {
    const std::string name = primed(slope.of.name(), slope.of.derivative());
    const auto own =
        std::ranges::find_if(given_.equations, [&](const equation& each) { return same_form(each.left, slope.of); });
    if (own == given_.equations.end()) {
        refuse(name, slope.at, "is delayed, which is supported only with an equation " + name + " = ...: solve for it");
    }
    each_leaf(own->right, [&](const expression& leaf) {
        if (leaf.kind() == node_kind::unknown && leaf.derivative() >= given_.order_of(leaf.name())) {
            refuse(name, slope.at,
                   "is delayed, and its equation has a highest derivative on the right-hand side: replace that");
        }
    });
    return own->right;
}

// The parameter that represents an unknown or a derivative at an earlier time.
expression delay_system::delayed(const expression& of, const number& delay, const place& at) {
    const auto is_it = [&](const delayed_value& each) {
        return same_form(each.of, of) && (each.delay.constant() - delay).sign() == 0;
    };
    const delayed_value made{"delayed " + std::to_string(given_.delays.size() + slopes_.size() + 1), of,
                             expression(delay), at};
    if (of.derivative() == given_.order_of(of.name())) {
        const auto found = std::ranges::find_if(slopes_, is_it, &delayed_slope::value);
        return parameter(found != slopes_.end() ? found->value.parameter : slopes_.emplace_back(made).value.parameter);
    }
    const auto found = std::ranges::find_if(given_.delays, is_it);
    return parameter(found != given_.delays.end() ? found->parameter : given_.delays.emplace_back(made).parameter);
}

// An expression at an earlier time: in the unknowns, delayed values and the variable.
expression delay_system::earlier(const expression& e, const number& delay) {
    return replaced(e, [&](const expression& leaf) -> std::optional<expression> {
        if (leaf.kind() == node_kind::variable) {
            return leaf - expression(delay);
        }
        if (leaf.kind() == node_kind::unknown) {
            return delayed(leaf, delay, {});
        }
        const auto slope =
            std::ranges::find(slopes_, leaf.name(), [](const delayed_slope& each) { return each.value.parameter; });
        const delayed_value of = slope != slopes_.end()
                                     ? slope->value
                                     : *std::ranges::find(given_.delays, leaf.name(), &delayed_value::parameter);
        return delayed(of.of, of.delay.constant() + delay, of.at);
    });
}

// Each expansion may add further slopes, with longer delays.
void delay_system::expand_slopes(const std::optional<number>& last) {
    for (std::size_t i = 0; i < slopes_.size(); ++i) {
        const delayed_value slope = slopes_[i].value;
        const expression right = right_side_of(slope);
        const number delay = slope.delay.constant();
        if (last && (*last - given_.histories.front().point.constant() - delay).sign() >= 0) {
            const expression expanded = earlier(right, delay);  // which may move slopes_
            slopes_[i].right = expanded;
        }
    }
}

void delay_system::order_delays() {
    for (const delayed_value& each : given_.delays) {
        delays_.push_back(each.delay.constant());
    }
    for (const delayed_slope& each : slopes_) {
        delays_.push_back(each.value.delay.constant());
    }
    std::ranges::sort(delays_, [](const number& a, const number& b) { return (a - b).sign() < 0; });
    const auto is_same = [](const number& a, const number& b) { return (a - b).sign() == 0; };
    delays_.erase(std::unique(delays_.begin(), delays_.end(), is_same), delays_.end());
    const auto index_of = [&](const delayed_value& of) {
        const auto found =
            std::ranges::find_if(delays_, [&](const number& each) { return (each - of.delay.constant()).sign() == 0; });
        return static_cast<std::size_t>(found - delays_.begin());
    };
    for (const delayed_value& each : given_.delays) {
        delayed_.push_back({0, index_of(each)});
    }
    for (delayed_slope& each : slopes_) {
        each.delay = index_of(each.value);
    }
    // The right-hand side of a slope contains slopes of longer delays only.
    std::ranges::sort(slopes_, [](const delayed_slope& a, const delayed_slope& b) { return a.delay > b.delay; });
}

void delay_system::read_starts() {
    const explicit_system first(equations(0));
    require_differential(first);
    if (first.singular()) {
        refuse("", {},
               "has a singular initial point, which is not supported with delays: choose another initial point");
    }
    point_ = first.point();
    for (std::size_t i = 0; i < first.unknowns().size(); ++i) {
        for (int j = 0; j < first.unknowns()[i].order; ++j) {
            leaves_.push_back(unknown(first.unknowns()[i].name, j));
            starts_.push_back(first.starts()[i][static_cast<std::size_t>(j)]);
        }
    }
    for (std::size_t i = 0; i < delayed_.size(); ++i) {
        const auto leaf =
            std::ranges::find_if(leaves_, [&](const expression& each) { return same_form(each, given_.delays[i].of); });
        delayed_[i].leaf = static_cast<std::size_t>(leaf - leaves_.begin());
    }
}

const history* delay_system::history_of(const std::string& unknown) const {
    const auto found = std::ranges::find(given_.histories, unknown, &history::unknown);
    return found == given_.histories.end() ? nullptr : &*found;
}

// A delayed value as long as it is that of the history.
expression delay_system::of_history(const expression& of, std::size_t delay) const {
    expression value = history_of(of.name())->value;
    for (int j = 0; j < of.derivative(); ++j) {
        value = partial(value, ode::variable());
    }
    const expression before = ode::variable() - expression(delays_[delay]);
    return replaced(value, [&](const expression&) { return std::optional(before); });
}

// Instead of the parameters that represent them.
std::map<std::string, expression> delay_system::delayed_values(std::size_t passed) const {
    std::map<std::string, expression> values;
    for (std::size_t i = 0; i < delayed_.size(); ++i) {
        const delayed_value& each = given_.delays[i];
        if (delayed_[i].delay < passed) {
            values.emplace(each.parameter, unknown(each.parameter));
        } else if (history_of(each.of.name()) != nullptr) {
            values.emplace(each.parameter, of_history(each.of, delayed_[i].delay));
        }
    }
    for (const delayed_slope& each : slopes_) {
        if (each.delay >= passed) {
            values.emplace(each.value.parameter, of_history(each.value.of, each.delay));
        } else if (each.right) {
            values.emplace(each.value.parameter, with_parameters(*each.right, values));
        } else {
            throw error(error_kind::undecided, error_subject::time, "",
                        "is beyond the last one for which the delayed highest derivatives are known");
        }
    }
    return values;
}

// With the starts of the given system.
equation_system delay_system::equations(std::size_t passed) const {
    equation_system result = given_;
    result.delays.clear();
    result.histories.clear();
    const auto values = delayed_values(passed);
    for (equation& each : result.equations) {
        each.left = with_parameters(each.left, values);
        each.right = with_parameters(each.right, values);
    }
    return result;
}

delay_stage delay_system::stage(std::size_t passed, const number& point, const std::vector<number>& leaves,
                                const std::vector<number>& inputs) const {
    equation_system smooth = equations(passed);
    smooth.starts.clear();
    for (std::size_t k = 0; k < leaves_.size(); ++k) {
        smooth.begin(leaves_[k], expression(leaves[k]), expression(point));
    }
    std::size_t next = 0;
    for (std::size_t i = 0; i < delayed_.size(); ++i) {
        if (delayed_[i].delay < passed) {
            const expression value = unknown(given_.delays[i].parameter);
            const expression slope = unknown(slope_name(given_.delays[i]));
            smooth.add(derivative(value), slope).add(derivative(slope));
            smooth.begin(value, expression(inputs[next]), expression(point));
            smooth.begin(slope, expression(inputs[next + 1]), expression(point));
            next += 2;
        }
    }
    const explicit_system solved(smooth);
    require_differential(solved);
    std::vector<expression> unknowns;
    for (const std::string& name : names_of_state(*this)) {
        unknowns.push_back(unknown(name));
    }
    std::vector<delayed_input> of_stage;
    for (std::size_t i = 0; i < delayed_.size(); ++i) {
        if (delayed_[i].delay < passed) {
            of_stage.push_back({delayed_[i], unknowns.size(), unknowns.size() + 1});
            unknowns.push_back(unknown(given_.delays[i].parameter));
            unknowns.push_back(unknown(slope_name(given_.delays[i])));
        }
    }
    std::vector<expression> right;
    right.reserve(unknowns.size());
    for (const expression& each : unknowns) {
        right.push_back(derivative_of_leaf(each.name(), solved));
    }
    return {explicit_system::first_order(unknowns, std::move(right), point), std::move(of_stage)};
}

std::vector<std::string> names_of_state(const delay_system& system) {
    std::vector<std::string> names;
    names.reserve(system.leaves().size());
    for (const expression& each : system.leaves()) {
        names.push_back(primed(each.name(), each.derivative()));
    }
    return names;
}

}  // namespace libration::ode
