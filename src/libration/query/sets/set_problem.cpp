#include "set_problem.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "constant_unknowns.hpp"
#include "libration/equation/parametric_system.hpp"
#include "libration/equation/polynomial_form.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

// With the midpoint of each set as the value of a parameter.
equation_system with_midpoints(equation_system given) {
    for (const number_set& each : std::exchange(given.sets, {})) {
        given.parameters.push_back({each.name, (each.lower + each.upper) / 2, each.at});
    }
    return given;
}

// Each set as a separate leaf.
std::map<std::string, expression> leaves_by_name(const std::vector<number_set>& sets) {
    std::map<std::string, expression> leaves;
    for (const number_set& each : sets) {
        leaves.emplace(each.name, unknown("set " + std::to_string(leaves.size())));
    }
    return leaves;
}

bool has_leaf(const expression& e, const expression& leaf) {
    bool found = false;
    each_leaf(e, [&](const expression& each) { found = found || same_form(each, leaf); });
    return found;
}

// The sets on which the equations depend, also through parameters.
std::vector<std::string> sets_in_equations(const equation_system& given) {
    const auto leaves = leaves_by_name(given.sets);
    const equation_system numbers = with_midpoints(given);
    parameter_values values(numbers, leaves);
    std::vector<std::string> found;
    for (const number_set& each : given.sets) {
        const expression& leaf = leaves.at(each.name);
        if (std::ranges::any_of(numbers.equations, [&](const equation& of) {
                return has_leaf(values.in(of.left), leaf) || has_leaf(values.in(of.right), leaf);
            })) {
            found.push_back(each.name);
        }
    }
    return found;
}

// Parameters that are sets are unknowns in it.
expression condition_of(const equation_system& given, const std::optional<std::string>& condition) {
    if (!condition) {
        return {};
    }
    equation_system names = with_midpoints(given);
    for (const number_set& each : given.sets) {
        if (each.name.find('(') == std::string::npos) {
            std::erase_if(names.parameters, [&](const definition& of) { return of.name == each.name; });
            names.add(derivative(unknown(each.name)));
        }
    }
    return parse_condition(names, *condition);
}

// The sets on which the equations or the condition depend.
std::vector<std::string> sets_in(const equation_system& given, const expression& condition) {
    std::vector<std::string> found = sets_in_equations(given);
    for (const number_set& each : given.sets) {
        if (std::ranges::find(found, each.name) == found.end() && has_leaf(condition, unknown(each.name))) {
            found.push_back(each.name);
        }
    }
    return found;
}

// Events, step functions and delays would need the sets of solutions on each branch or piece.
void require_one_branch(const equation_system& given) {
    const std::string reason =
        ", which enclosures of sets and over spans of time do not support: leave it out, or give numbers and times";
    if (!given.events.empty()) {
        refuse(given.events.front().text, given.events.front().at, "is an event" + reason);
    }
    if (!given.steps.empty()) {
        refuse(given.steps.front().text, given.steps.front().at, "is piecewise" + reason);
    }
    if (!given.delays.empty()) {
        const delayed_value& first = given.delays.front();
        refuse(primed(first.of.name(), first.of.derivative()), first.at, "is delayed" + reason);
    }
}

// The initial point is one number.
void require_one_point(const equation_system& given) {
    const auto leaves = leaves_by_name(given.sets);
    const equation_system numbers = with_midpoints(given);
    parameter_values values(numbers, leaves);
    for (const start& each : numbers.starts) {
        const expression point = values.in(each.point);
        for (const auto& [name, leaf] : leaves) {
            if (has_leaf(point, leaf)) {
                refuse(name, each.at, "is a set, and cannot be the initial point: give it one number");
            }
        }
    }
}

std::pair<number, number> ends_of(const number_set& of, const equation_system& given) {
    const number lower = number_with_values(of.lower, given);
    const number upper = number_with_values(of.upper, given);
    if ((upper - lower).sign() < 0) {
        refuse(of.name, of.at, "is an interval whose first end is above the second: write the lower end first");
    }
    return {lower, upper};
}

}  // namespace

set_problem::set_problem(const equation_system& given, const std::optional<std::string>& condition)
    : condition_((require_one_branch(given), require_one_point(given), condition_of(given, condition))),
      free_(sets_in(given, condition_)),
      system_(opened(with_midpoints(given), free_).system) {
    if (system_.singular()) {
        refuse("", {},
               "is singular at the initial point, where enclosures of sets and over spans of time are not supported: "
               "choose a later initial point");
    }
    if (!system_.algebraic().empty() && !given.sets.empty()) {
        refuse(given.sets.front().name, given.sets.front().at,
               "is a set of values, which algebraic equations do not support, since initial values must satisfy them: "
               "give it one number");
    }
    for (const number_set& each : given.sets) {
        const auto [lower, upper] = ends_of(each, given);
        sets_.push_back(each.name);
        lower_.push_back(lower);
        upper_.push_back(upper);
    }
    const auto by_name = leaves_by_name(given.sets);
    for (const std::string& each : sets_) {
        leaves_.push_back(by_name.at(each));
    }
    read_starts(given);
    names_ = names_of_own();
    const std::vector<std::size_t> all = own_;
    const std::vector<expression> starts = starts_;
    leave_out_constants(given);
    const std::vector<std::string> left = names_of_own();
    for (std::size_t k = 0; k < names_.size(); ++k) {
        if (const auto at = std::ranges::find(left, names_[k]); at != left.end()) {
            values_.emplace_back(static_cast<std::size_t>(at - left.begin()));
        } else {
            values_.emplace_back(starts[all[k]].constant());
        }
    }
    for (const expression& each : starts_) {
        auto& row = derivatives_.emplace_back();
        for (const expression& leaf : leaves_) {
            row.push_back(partial(each, leaf));
        }
    }
}

// The initial values of system_, in terms of the sets.
void set_problem::read_starts(const equation_system& given) {
    const equation_system numbers = with_midpoints(given);
    const auto by_name = leaves_by_name(given.sets);
    parameter_values values(numbers, by_name);
    starts_.clear();
    own_.clear();
    std::size_t place = 0;
    for (const unknown_function& each : system_.unknowns()) {
        const bool is_set = std::ranges::find(free_, each.name) != free_.end();
        for (int order = 0; order < each.order; ++order, ++place) {
            if (is_set) {
                starts_.push_back(by_name.at(each.name));
                continue;
            }
            own_.push_back(place);
            const auto at = std::ranges::find_if(
                numbers.starts, [&](const start& s) { return s.of.name() == each.name && s.of.derivative() == order; });
            starts_.push_back(values.in(at->value));
        }
    }
}

// At least one unknown of the problem remains.
void set_problem::leave_out_constants(const equation_system& given) {
    if (!system_.algebraic().empty()) {
        return;
    }
    const std::set<std::string> constant = constant_unknowns(system_, starts_, condition_);
    if (!constant.empty() && constant.size() + free_.size() < system_.unknowns().size()) {
        system_ = without(system_, constant);
        read_starts(given);
    }
}

std::vector<std::string> set_problem::names_of_own() const {
    const std::vector<std::string> all = names_of_state(system_);
    std::vector<std::string> result;
    for (const std::size_t place : own_) {
        result.push_back(all[place]);
    }
    return result;
}

std::vector<closed_interval> set_problem::all_values(const std::vector<closed_interval>& of_own) const {
    std::vector<closed_interval> result;
    for (const auto& each : values_) {
        if (const auto* const index = std::get_if<std::size_t>(&each)) {
            result.push_back(of_own[*index]);
        } else {
            const ball value = constant_value<ball>::of(std::get<number>(each));
            result.push_back({lower_bound(value), upper_bound(value)});
        }
    }
    return result;
}

number_box set_problem::box() const {
    number_box result;
    for (std::size_t j = 0; j < sets_.size(); ++j) {
        result.push_back(
            {lower_bound(constant_value<ball>::of(lower_[j])), upper_bound(constant_value<ball>::of(upper_[j]))});
    }
    return result;
}

std::vector<ball> set_problem::starts_at(const std::vector<ball>& numbers) const {
    expression_values<ball> values(leaves_, ball(0));
    for (const ball& each : numbers) {
        values.push_back(each);
    }
    std::vector<ball> result;
    for (const expression& each : starts_) {
        result.push_back(values.of(each));
    }
    return result;
}

ball_matrix set_problem::derivative_of_start(const number_box& box) const {
    expression_values<ball> values(leaves_, ball(0));
    for (const closed_interval& each : box) {
        values.push_back(ball_of(each));
    }
    ball_matrix result;
    for (const auto& row : derivatives_) {
        auto& of_unknown = result.emplace_back();
        for (const expression& each : row) {
            of_unknown.push_back(values.of(each));
        }
    }
    return result;
}

state_set set_problem::states_of(const number_box& box) const {
    std::vector<ball> centre;
    for (const closed_interval& each : box) {
        centre.push_back(middle_of(each));
    }
    const std::vector<ball> at_centre = starts_at(centre);
    const ball_matrix derivative = derivative_of_start(box);
    const std::size_t size = starts_.size();
    state_set result;
    std::vector<magnitude> added;
    for (const ball& each : at_centre) {
        result.centre.push_back(exact_midpoint(each));
        added.emplace_back(each - result.centre.back());
    }
    ball_matrix columns;
    std::vector<magnitude> radii;
    for (std::size_t j = 0; j < box.size(); ++j) {
        if (!has_width(box[j])) {
            continue;
        }
        radii.push_back(radius_of(box[j]));
        auto& column = columns.emplace_back();
        for (std::size_t i = 0; i < size; ++i) {
            column.push_back(exact_midpoint(derivative[i][j]));
            added[i].add_product(magnitude(derivative[i][j] - column[i]), radii.back());
        }
    }
    for (std::size_t i = 0; i < size; ++i) {
        radii.emplace_back();
        columns.emplace_back(size, ball(0))[i] = ball(1);
    }
    std::vector<std::size_t> blocks(columns.size(), 1);
    result.errors = lohner_set(std::move(columns), std::move(blocks), std::move(radii), std::move(added));
    return result;
}

}  // namespace libration::ode
