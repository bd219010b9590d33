#include "saltation.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "../expansion/differentiated_numbers.hpp"
#include "libration/equation/parametric_system.hpp"
#include "libration/hybrid/initial_mode.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

std::size_t index_of(const std::vector<expression>& leaves, const expression& leaf) {
    const auto found = std::ranges::find_if(leaves, [&](const expression& each) { return same_form(each, leaf); });
    return static_cast<std::size_t>(found - leaves.begin());
}

// Of an unknown, or of one of its derivatives, with respect to a number.
expression variation_of(const expression& leaf, const std::string& by) {
    return unknown("d/d" + by + " " + leaf.name(), leaf.derivative());
}

bool has_steps(const expression& e) {
    bool found = false;
    each_leaf(e, [&](const expression& leaf) { found = found || leaf.kind() == node_kind::parameter; });
    return found;
}

// A highest derivative and its right-hand side, in the state and the parameters of the step functions.
struct solved_equation {
    expression highest, right;
};

class varying {
public:
    varying(const equation_system& given, const std::vector<std::string>& numbers)
        : plain_(given),
          numbers_(numbers),
          requested_(given, names_of_state(plain_), plain_.point(), numbers),
          leaves_(plain_.leaves()),
          numbers_at_start_(plain_.starts()),
          varied_(with_parameters_open(given)) {
        for (const expression& leaf : plain_.leaves()) {
            const auto found =
                std::ranges::find_if(varied_.starts, [&](const start& each) { return same_form(each.of, leaf); });
            starts_.push_back(found->value);
        }
        for (const std::string& each : requested_.parameters) {
            leaves_.push_back(unknown(each));
            starts_.push_back(unknown(each));
            numbers_at_start_.push_back(number_with_values(given.parameter_of(each)->value, given));
        }
        solve();
    }

    varied_system result() {
        std::vector<dependence_on_number> dependences;
        for (const auto& column : requested_.columns) {
            const std::size_t place = column.of_start ? column.index : plain_.leaves().size() + column.index;
            dependences.push_back(dependence_on(place));
        }
        varied_.starts.clear();
        varied_.equations.clear();
        for (std::size_t k = 0; k < leaves_.size(); ++k) {
            varied_.begin(leaves_[k], expression(numbers_at_start_[k]), expression(plain_.point()));
        }
        for (const solved_equation& each : solved_) {
            varied_.add(each.highest, each.right);
        }
        for (std::size_t i = 0; i < numbers_.size(); ++i) {
            add_variation(dependences[i], numbers_[i]);
        }
        varied_system made{hybrid_system(varied_), leaves_, {}, std::move(dependences)};
        for (std::size_t k = 0; k < plain_.leaves().size(); ++k) {
            made.own.push_back(index_of(made.system.leaves(), leaves_[k]));
        }
        for (std::size_t i = 0; i < numbers_.size(); ++i) {
            state_variation indices(made.system.leaves().size());
            for (const expression& leaf : leaves_) {
                if (made.dependences[i].has(leaf)) {
                    indices[index_of(made.system.leaves(), leaf)] =
                        index_of(made.system.leaves(), variation_of(leaf, numbers_[i]));
                }
            }
            made.system.add_variation(std::move(indices));
        }
        return made;
    }

private:
    // Numbers for the parameters, except those of the step functions, and the requested ones, which become unknowns.
    equation_system with_parameters_open(const equation_system& given) const {
        std::map<std::string, expression> open = kept_steps(given.steps);
        for (const std::string& each : requested_.parameters) {
            open.emplace(given_parameter(given, each).name, unknown(each));
        }
        parameter_values values(given, std::move(open));
        equation_system made = given;
        made.invariants.clear();
        made.exact.clear();
        made.parameters.clear();
        put_values(made, values);
        for (start& each : made.starts) {
            each.value = values.in(each.value);
        }
        return made;
    }

    // The equations solved for the highest derivatives, with the step functions as constant unknowns.
    void solve() {
        const step_values steps = values_at_start(plain_);
        const auto point = expression(plain_.point());
        equation_system smooth;
        smooth.variable = varied_.variable;
        const auto opened = [](const expression& e) {
            return replaced(e, [](const expression& leaf) {
                return leaf.kind() == node_kind::parameter ? std::optional(unknown(leaf.name())) : std::nullopt;
            });
        };
        for (const equation& each : varied_.equations) {
            smooth.equations.push_back({opened(each.left), opened(each.right), each.at});
        }
        for (std::size_t k = 0; k < leaves_.size(); ++k) {
            smooth.begin(leaves_[k], expression(numbers_at_start_[k]), point);
        }
        for (const std::string& each : requested_.parameters) {
            smooth.add(derivative(unknown(each)));
        }
        for (std::size_t i = 0; i < steps.size(); ++i) {
            for (const definition& each : parameters_of(varied_.steps[i], steps[i])) {
                const expression step = unknown(each.name);
                smooth.add(derivative(step)).begin(step, each.value, point);
            }
        }
        const explicit_system solved(smooth);
        const auto kept = kept_steps(varied_.steps);
        const auto is_step = [&](const std::string& name) { return kept.contains(name); };
        for (std::size_t k = 0; k < solved.unknowns().size(); ++k) {
            const auto& [name, order] = solved.unknowns()[k];
            if (!is_step(name)) {
                solved_.push_back({unknown(name, order), replaced(solved.right()[k], [&](const expression& leaf) {
                                       const bool step = leaf.kind() == node_kind::unknown && is_step(leaf.name());
                                       return step ? std::optional(parameter(leaf.name())) : std::nullopt;
                                   })});
            }
        }
    }

    // By the fixed point: an unknown depends on what is in its right-hand side, in its resets, and in the conditions of
    // events and step functions that change it.
    dependence_on_number dependence_on(std::size_t place) const {
        dependence_on_number of{leaves_[place], {leaves_[place].name()}, {}};
        for (std::size_t k = 0; k < leaves_.size(); ++k) {
            of.starts.push_back(k == place ? of.leaf : at_values_of_others(starts_[k], of.leaf));
            if (!of.starts.back().is_constant()) {
                of.unknowns.insert(leaves_[k].name());
            }
        }
        for (std::size_t before = 0; before != of.unknowns.size();) {
            before = of.unknowns.size();
            const bool switches =
                std::ranges::any_of(varied_.steps, [&](const step_function& each) { return of.has(each.argument); });
            for (const solved_equation& each : solved_) {
                if (of.has(each.right) || (switches && has_steps(each.right))) {
                    of.unknowns.insert(each.highest.name());
                }
            }
            for (const state_event& event : varied_.events) {
                add_dependence_by(event, of);
            }
        }
        return of;
    }

    void add_dependence_by(const state_event& event, dependence_on_number& of) const {
        const auto has_argument = [&](const step_function& each) { return of.has(each.argument); };
        const bool moves = event.holds ? std::ranges::any_of(varied_.steps, has_argument) : of.has(event.condition);
        for (const reset& each : event.resets) {
            if (moves || of.has(each.value)) {
                of.unknowns.insert(each.of.name());
            }
        }
        for (const solved_equation& each : solved_) {
            const auto contains_reset = [&](const reset& value) { return !partial(each.right, value.of).is(0); };
            if (moves && (has_steps(each.right) || std::ranges::any_of(event.resets, contains_reset))) {
                of.unknowns.insert(each.highest.name());
            }
        }
    }

    expression at_values_of_others(const expression& start, const expression& leaf) const {
        return replaced(start, [&](const expression& each) {
            return same_form(each, leaf) ? std::nullopt
                                         : std::optional(expression(numbers_at_start_[index_of(leaves_, each)]));
        });
    }

    void add_variation(const dependence_on_number& of, const std::string& by) {
        for (const solved_equation& each : solved_) {
            if (!of.has(each.highest)) {
                continue;
            }
            expression right;
            for (const expression& leaf : leaves_) {
                if (of.has(leaf)) {
                    right = right + partial(each.right, leaf) * variation_of(leaf, by);
                }
            }
            varied_.add(variation_of(each.highest, by), right);
        }
        const expression value(numbers_at_start_[index_of(leaves_, of.leaf)]);
        for (std::size_t k = 0; k < leaves_.size(); ++k) {
            if (of.has(leaves_[k])) {
                varied_.begin(variation_of(leaves_[k], by),
                              with_leaves(partial(of.starts[k], of.leaf), {of.leaf}, {value}),
                              expression(plain_.point()));
            }
        }
    }

    hybrid_system plain_;
    const std::vector<std::string>& numbers_;
    differentiated_numbers requested_;
    std::vector<expression> leaves_;  // the state, and the parameters
    std::vector<expression> starts_;  // of the leaves, in terms of the parameters
    std::vector<number> numbers_at_start_;
    equation_system varied_;
    std::vector<solved_equation> solved_;
};

}  // namespace

bool dependence_on_number::has(const expression& e) const {
    bool found = false;
    each_leaf(e, [&](const expression& each) {
        found = found || (each.kind() == node_kind::unknown && unknowns.contains(each.name()));
    });
    return found;
}

varied_system system_with_variations(const equation_system& given, const std::vector<std::string>& numbers) {
    return with_derivative_errors([&] { return varying(given, numbers).result(); });
}

}  // namespace libration::ode
