#include "libration/equation/hybrid_system.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>

#include "emptied_store.hpp"
#include "libration/equation/choice.hpp"
#include "libration/equation/defined_zero.hpp"
#include "libration/scalar/error.hpp"
#include "removable_singularity.hpp"
#include "start_values.hpp"
#include "still_value.hpp"
#include "varied_value.hpp"

namespace libration::ode {

namespace {

number integer_number(long n) { return number(rational(n)); }

}  // namespace

number floor_of(const number& x, const number& divisor) {
    rational lower;
    const number quotient = x / divisor;
    if (const auto exactly = quotient.fraction()) {
        lower = *exactly;
    } else {
        const auto rough = quotient.bounds_at(64);
        const number_bounds near = rough ? *rough : quotient.narrowed(64);
        mpfr_get_q(lower.backend().data(), handle(near.lower));
    }
    integer n;
    mpz_fdiv_q(n.backend().data(), mpq_numref(lower.backend().data()), mpq_denref(lower.backend().data()));
    number below{rational(n)};
    while ((x - (below + integer_number(1)) * divisor).sign() >= 0) {
        below = below + integer_number(1);
    }
    return below;
}

namespace {

bool is_state_of(const std::vector<expression>& leaves, const expression& e) {
    return std::ranges::any_of(leaves, [&](const expression& leaf) { return same_form(leaf, e); });
}

// Throws error for an unknown in an expression that is not one of the leaves.
void require_state(const expression& e, const std::vector<expression>& leaves, const place& at) {
    each_leaf(e, [&](const expression& leaf) {
        if (leaf.kind() == node_kind::unknown && !is_state_of(leaves, leaf)) {
            refuse(primed(leaf.name(), leaf.derivative()), at,
                   "is not part of the state, which consists of unknowns and lower derivatives: replace it by its "
                   "right-hand side");
        }
    });
}

// Throws error for step functions in an event, which names for expressions may contain.
void require_smooth(const expression& e, const state_event& in) {
    if (e.has_parameters()) {
        refuse(in.text, in.at,
               "contains a piecewise function, which is supported only in equations: write one of its branches");
    }
}

// A linear expression with fractions as coefficients: those of its leaves, and its constant term.
struct fraction_form {
    std::map<std::string, rational> coefficients;

    static std::optional<fraction_form> of(const expression& e) {
        if (!is_defined_everywhere(e)) {
            return std::nullopt;
        }
        fraction_form result;
        bool linear = true;
        each_leaf(e, [&](const expression& leaf) {
            const expression factor = partial(e, leaf);
            const auto coefficient = factor.kind() == node_kind::constant ? factor.fraction() : std::nullopt;
            linear = linear && coefficient;
            if (coefficient && *coefficient != 0) {
                const bool unknown = leaf.kind() == node_kind::unknown;
                const std::string name = leaf.kind() == node_kind::variable ? "" : leaf.name();
                result.coefficients[std::to_string(static_cast<int>(leaf.kind())) + " " +
                                    primed(name, unknown ? leaf.derivative() : 0)] = *coefficient;
            }
        });
        if (!linear || result.coefficients.empty()) {
            return std::nullopt;
        }
        const auto constant = replaced(e, [](const expression&) { return std::optional(expression()); }).fraction();
        if (!constant) {
            return std::nullopt;
        }
        result.coefficients["1"] = *constant;
        return result;
    }

    // The sign of the constant quotient of both; 0 if it is not constant.
    int relative_sign(const fraction_form& other) const {
        if (coefficients.size() != other.coefficients.size()) {
            return 0;
        }
        std::optional<rational> quotient;
        for (const auto& [name, coefficient] : coefficients) {
            const auto found = other.coefficients.find(name);
            if (found == other.coefficients.end() || (coefficient == 0) != (found->second == 0)) {
                return 0;
            }
            if (coefficient == 0) {
                continue;
            }
            const rational here = found->second / coefficient;
            if (quotient && *quotient != here) {
                return 0;
            }
            quotient = here;
        }
        return *quotient > 0 ? 1 : -1;
    }
};

// A sum of expressions other than sums, each multiplied by a fraction, and a fraction, by the form as written.
class written_combination {
public:
    explicit written_combination(const expression& e) { add(e, 1, 0); }

    // The sign of the constant quotient of both; 0 if they are not multiples of each other.
    int relative_sign(const written_combination& other) const {
        if (terms_.empty() || terms_.size() != other.terms_.size()) {  // as many, so that none is of one alone
            return 0;
        }
        const rational own = factor_of(terms_.front().first);
        if (own == 0) {
            return 0;
        }
        const rational first = other.factor_of(terms_.front().first) / own;
        const bool multiple =
            first != 0 && first * constant_ == other.constant_ && std::ranges::all_of(terms_, [&](const auto& each) {
                return other.factor_of(each.first) == first * factor_of(each.first);
            });
        return multiple ? (first > 0 ? 1 : -1) : 0;
    }

private:
    void add(const expression& e, const rational& factor, int depth) {
        constexpr int deepest = 16;
        if (const auto number = e.fraction()) {
            constant_ += factor * *number;
        } else if (e.kind() == node_kind::sum && depth < deepest) {
            add(e.left(), factor, depth + 1);
            add(e.right(), factor, depth + 1);
        } else if (const auto times = e.kind() == node_kind::product ? e.left().fraction() : std::nullopt;
                   times && *times != 0 && depth < deepest) {
            add(e.right(), factor * *times, depth + 1);
        } else {
            terms_.emplace_back(e, factor);
        }
    }

    rational factor_of(const expression& part) const {
        rational sum = 0;
        for (const auto& [each, factor] : terms_) {
            sum += same_form(each, part) ? factor : 0;
        }
        return sum;
    }

    std::vector<std::pair<expression, rational>> terms_;
    rational constant_ = 0;
};

}  // namespace

std::optional<linear_in_variable> linear_in_variable::of(const expression& e) {
    if (!e.has_variable() || e.has_unknowns() || e.has_parameters() || !is_defined_everywhere(e)) {
        return std::nullopt;
    }
    const expression slope = partial(e, ode::variable());
    if (slope.kind() != node_kind::constant || slope.constant().sign() == 0) {
        return std::nullopt;
    }
    const expression rest = replaced(e, [](const expression&) { return std::optional(expression()); });
    return linear_in_variable{slope.constant(), rest.constant()};
}

int relative_sign(const expression& a, const expression& b) {
    if (same_form(a, b)) {
        return 1;
    }
    if (same_form(a, -b)) {
        return -1;
    }
    const auto first = fraction_form::of(a);
    const auto second = fraction_form::of(b);
    if (first && second) {
        return first->relative_sign(*second);
    }
    return first || second ? 0 : written_combination(a).relative_sign(written_combination(b));
}

hybrid_system::hybrid_system(const equation_system& given) : given_(given) {
    if (!given.delays.empty()) {
        const delayed_value& first = given.delays.front();
        refuse(primed(first.of.name(), first.of.derivative()), first.at,
               "is delayed, which is not supported together with events or piecewise right-hand sides: leave it out");
    }
    given_.invariants.clear();
    given_.exact.clear();
    require_numbers(given_);
    parameter_values parameters(given, kept_steps(given_.steps));
    put_values(given_, parameters);
    read_starts(parameters);
    given_.parameters.clear();
    read_still_leaves();
    require_state_in_events();
    for (std::size_t i = 0; i < given_.steps.size(); ++i) {
        for (const definition& each : parameters_of(given_.steps[i], number())) {
            step_places_.emplace(each.name, i);
        }
    }
    read_dependence();
}

// Those of which the derivative is 0 by an equation.
void hybrid_system::read_still_leaves() {
    std::ranges::transform(leaves_, std::back_inserter(still_),
                           [&](const expression& leaf) { return has_zero_slope(given_, leaf); });
}

bool hybrid_system::is_kept(const expression& e) const {
    bool kept = e.has_unknowns() && std::ranges::find(still_, true) != still_.end();
    each_leaf(e, [&](const expression& leaf) {
        const auto k = static_cast<std::size_t>(
            std::ranges::find_if(leaves_, [&](const expression& each) { return same_form(each, leaf); }) -
            leaves_.begin());
        kept = kept && k < leaves_.size() && still_[k] &&
               std::ranges::none_of(variations_, [&](const state_variation& each) {
                   return std::ranges::find(each, std::optional(k)) != each.end();
               });
    });
    return kept;
}

bool hybrid_system::is_kept(const state_event& event) const {
    bool kept = event.holds.has_value();
    if (kept) {
        each_leaf(*event.holds,
                  [&](const expression& leaf) { kept = kept && is_kept(given_.steps[step_of(leaf.name())].argument); });
    }
    return kept;
}

// The equations y^(n) = f without highest derivatives in f.
void hybrid_system::read_dependence() {
    const auto orders = given_.highest_derivatives();
    const auto is_highest = [&](const expression& e) {
        return e.kind() == node_kind::unknown && e.derivative() >= std::max(orders.at(e.name()), 1);
    };
    for (std::size_t i = 0; i < given_.equations.size(); ++i) {
        const equation& each = given_.equations[i];
        bool explicitly = is_highest(each.left);
        each_leaf(each.right, [&](const expression& leaf) { explicitly = explicitly && !is_highest(leaf); });
        if (!explicitly) {
            equation_places_.clear();
            return;
        }
        equation_places_.emplace(each.left.name(), i);
    }
}

void hybrid_system::add_influences(const expression& e, std::set<std::string>& unknowns,
                                   std::vector<bool>& steps) const {
    each_leaf(e, [&](const expression& leaf) {
        if (leaf.kind() == node_kind::unknown && unknowns.insert(leaf.name()).second) {
            add_influences(given_.equations[equation_places_.at(leaf.name())].right, unknowns, steps);
        }
        if (leaf.kind() == node_kind::parameter && !steps[step_of(leaf.name())]) {
            steps[step_of(leaf.name())] = true;
            add_influences(given_.steps[step_of(leaf.name())].argument, unknowns, steps);
        }
    });
}

std::vector<bool> hybrid_system::influences_on(const expression& e) const {
    std::vector<bool> steps(given_.steps.size(), equation_places_.empty());
    if (!equation_places_.empty()) {
        std::set<std::string> unknowns;
        add_influences(e, unknowns, steps);
    }
    return steps;
}

void hybrid_system::read_starts(parameter_values& parameters) {
    bool first = true;
    for (const std::string& name : given_.unknowns()) {
        for (int j = 0; j < given_.order_of(name); ++j) {
            const expression leaf = unknown(name, j);
            const auto found =
                std::ranges::find_if(given_.starts, [&](const start& s) { return same_form(s.of, leaf); });
            if (found == given_.starts.end()) {
                refuse(primed(name, j), {}, "has no initial value: add " + primed(name, j) + "(0) = number");
            }
            const number point = parameters.number_of(found->point);
            if (!first && (point - point_).sign() != 0) {
                refuse(primed(name, j), found->at,
                       "has another initial point: give all initial values at one point, or leave out the condition "
                       "elsewhere and solve for an initial value with `libration find --such-that`");
            }
            point_ = point;
            first = false;
            leaves_.push_back(leaf);
            starts_.push_back(parameters.number_of(found->value));
        }
    }
    for (const start& each : given_.starts) {
        const auto same = [&](const start& other) { return same_form(other.of, each.of); };
        const std::string name = primed(each.of.name(), each.of.derivative());
        if (!is_state_of(leaves_, each.of)) {
            refuse(name, each.at, "has no free initial value: leave it out");
        }
        if (std::ranges::count_if(given_.starts, same) > 1) {
            refuse_second_start(given_, each.of);
        }
    }
}

void hybrid_system::require_state_in_events() const {
    for (const step_function& each : given_.steps) {
        require_state(each.argument, leaves_, each.at);
    }
    for (const definition& each : given_.shown) {
        require_state(each.value, leaves_, each.at);
    }
    for (const state_event& each : given_.events) {
        require_smooth(each.condition, each);
        for (const reset& value : each.resets) {
            require_smooth(value.value, each);
        }
        if (each.holds ? each.holds->kind() == node_kind::constant : each.condition.is_constant()) {
            refuse(each.text, each.at,
                   "has a condition that does not depend on the solution or on " + given_.variable +
                       ": write one, as y = 0");
        }
        require_state(each.condition, leaves_, each.at);
        if (is_kept(each.condition)) {
            refuse(each.text, each.at,
                   "has a direction, or is an equation, of values that resets alone change, which cross nothing: write "
                   "the condition, as when n == 2 or when n >= 2");
        }
        for (const reset& value : each.resets) {
            if (!is_state_of(leaves_, value.of)) {
                refuse(primed(value.of.name(), value.of.derivative()), value.at,
                       "is not part of the state, which consists of unknowns and lower derivatives: leave it out");
            }
            require_state(value.value, leaves_, value.at);
        }
    }
}

void put_values(equation_system& in, parameter_values& parameters) {
    for (equation& each : in.equations) {
        each.left = parameters.in(each.left);
        each.right = parameters.in(each.right);
    }
    for (step_function& each : in.steps) {
        each.argument = parameters.in(each.argument);
    }
    for (definition& each : in.shown) {
        each.value = parameters.in(each.value);
    }
    for (state_event& each : in.events) {
        each.condition = parameters.in(each.condition);
        for (reset& value : each.resets) {
            value.value = parameters.in(value.value);
        }
    }
}

expression with_leaves(const expression& e, const std::vector<expression>& leaves, const std::vector<expression>& by) {
    return replaced(e, [&](const expression& leaf) -> std::optional<expression> {
        for (std::size_t k = 0; k < leaves.size(); ++k) {
            if (same_form(leaf, leaves[k])) {
                return by[k];
            }
        }
        return std::nullopt;
    });
}

std::vector<std::string> names_of_state(const hybrid_system& system) {
    std::vector<std::string> names;
    for (const expression& leaf : system.leaves()) {
        names.push_back(primed(leaf.name(), leaf.derivative()));
    }
    return names;
}

explicit_system hybrid_system::branch(const step_values& values, const number& point,
                                      const std::vector<number>& state) const {
    explicit_system smooth(equations(values, point, state));
    if (libration::ode::names_of_state(smooth) != names_of_state(*this)) {
        throw std::logic_error("a branch with its state in another order");
    }
    if (!smooth.algebraic().empty()) {
        refuse("algebraic equations", {},
               "are not supported with events and piecewise functions: write the differential equations to which they "
               "lead");
    }
    return smooth;
}

equation_system hybrid_system::equations(const step_values& values, const number& point,
                                         const std::vector<number>& state) const {
    equation_system smooth = given_;
    smooth.events.clear();
    smooth.steps.clear();
    smooth.starts.clear();
    slide(values, smooth);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (is_at_rest(i, values) && !is_sliding(i, values)) {
            keep_both_sides(i, values, smooth);
        }
        for (const definition& each : parameters_on(i, values)) {
            smooth.set(each.name, each.value);
        }
    }
    for (std::size_t k = 0; k < leaves_.size(); ++k) {
        smooth.begin(leaves_[k], expression(state[k]), expression(point));
    }
    return smooth;
}

// Where the solution slides or a store is empty, conditions on the sign are as written on the surface.
std::vector<definition> hybrid_system::parameters_on(std::size_t step, const step_values& values) const {
    const bool on_surface = is_sliding(step, values) || is_emptied(values[step]);
    return parameters_of(given_.steps[step], on_surface ? number() : values[step]);
}

void hybrid_system::require_explicit(std::size_t step) const {
    if (equation_places_.empty()) {
        refuse(given_.steps[step].text, given_.steps[step].at,
               "remains 0, which is supported for equations that are solved for the highest derivatives: solve them");
    }
}

// Where the argument of a sign remains 0, it and what the equations are on both sides of its surface have to be defined;
// of a store that is empty only at 0, about which they are not analytic on one side.
// Their parts are added behind all other occurrences of the unknowns, whose order is that of the state.
void hybrid_system::keep_both_sides(std::size_t step, const step_values& values, equation_system& of) const {
    require_explicit(step);
    std::map<std::string, expression> known;
    for (const definition& each : parameters_on(step, values)) {
        known.emplace(each.name, each.value);
    }
    const auto value = [&](const std::string& name) {
        const auto found = known.find(name);
        return found != known.end() ? std::optional(found->second) : std::nullopt;
    };
    expression parts = zero_where_defined(argument(step, values));
    parameter_values parameters(given_, kept_steps(given_.steps));
    for (const equation& each : given_.equations) {
        const expression both = with_parameters(each.right, value, true);
        const auto at_0 = [&](const expression& e) {
            return same_form(e, argument(step, values)) ? std::optional(expression()) : std::nullopt;
        };
        parts =
            parts + zero_where_defined(is_emptied(values[step])
                                           ? replaced_as_written(with_removed_singularities(parameters.in(both)), at_0)
                                           : both);
    }
    expression& last = of.equations.back().right;
    last = last + parts;
}

expression hybrid_system::argument(std::size_t step, const step_values& values) const {
    const expression& u = given_.steps[step].argument;
    if (!u.has_parameters()) {
        return u;
    }
    std::map<std::string, expression> known;
    for (std::size_t i = 0; i < step; ++i) {
        for (const definition& each : parameters_on(i, values)) {
            known.emplace(each.name, each.value);
        }
    }
    return with_parameters(u, [&](const std::string& name) { return std::optional(known.at(name)); });
}

expression hybrid_system::on_branch(const expression& e, const step_values& values) const {
    std::map<std::string, expression> known;
    for (std::size_t i = 0; i < values.size(); ++i) {
        for (const definition& each : parameters_on(i, values)) {
            known.emplace(each.name, each.value);
        }
    }
    return with_parameters(e, [&](const std::string& name) { return std::optional(known.at(name)); });
}

bool hybrid_system::holds(const state_event& event, const step_values& values) const {
    return event.holds && !on_branch(*event.holds, values).is(0);
}

std::optional<number> hybrid_system::constant_step(std::size_t step, const step_values& values) const {
    const expression u = argument(step, values);
    if (u.kind() != node_kind::constant) {
        return std::nullopt;
    }
    return step_value(step, u.constant());
}

number hybrid_system::step_value(std::size_t step, const number& argument) const {
    const step_function& of = given_.steps[step];
    try {
        return of.kind == step_kind::sign ? integer_number(argument.sign()) : floor_of(argument, of.divisor);
    } catch (const error& problem) {
        if (problem.kind() != error_kind::undecided || !problem.is_about(error_subject::number)) {
            throw;
        }
        const std::string where = of.at.line == 0 ? ""
                                                  : "at line " + std::to_string(of.at.line) + ", column " +
                                                        std::to_string(of.at.column) + " ";
        throw error(error_kind::undecided, error_subject::problem, beginning_of(of.text),
                    where + "has a number that " + problem.reason() + ": write it in another form");
    }
}

bool hybrid_system::is_at_rest(std::size_t step, const step_values& values) const {
    if (given_.steps[step].kind != step_kind::sign ||
        !(values[step].sign() == 0 || is_sliding(step, values) || is_emptied(values[step]))) {
        return false;
    }
    const expression u = argument(step, values);
    return u.kind() != node_kind::constant && (!is_kept(u) || is_varied(*this, u));
}

// The functions of which floor(u/d) = n changes at the zeros: of a function that is linear in time, in one direction.
std::vector<expression> hybrid_system::levels(std::size_t step, const expression& u, const number& value) const {
    const step_function& of = given_.steps[step];
    if (of.kind == step_kind::sign) {
        return {u};
    }
    const auto linear = linear_in_variable::of(u);
    std::vector<expression> all;
    for (const int above : {0, 1}) {
        if (!linear || (linear->slope.sign() > 0) == (above == 1)) {
            all.push_back(u - expression((value + integer_number(above)) * of.divisor));
        }
    }
    return all;
}

surface& hybrid_system::add_surface(std::vector<surface>& to, const expression& g, const std::string& text) {
    const auto linear = linear_in_variable::of(g);
    for (surface& each : to) {
        const bool same_time = linear && each.time && (*each.time - linear->time_of(number())).sign() == 0;
        if (same_time || relative_sign(each.g, g) != 0) {
            return each;
        }
    }
    surface made{.g = g, .time = {}, .events = {}, .steps = {}, .text = text};
    if (linear) {
        made.time = linear->time_of(number());
        made.g = ode::variable() - expression(*made.time);
    }
    to.push_back(std::move(made));
    return to.back();
}

std::vector<surface> hybrid_system::surfaces(const step_values& values) const {
    std::vector<surface> all;
    const auto orientation = [](const surface& of, const expression& g) {
        const auto linear = linear_in_variable::of(g);
        return linear ? linear->slope.sign() : relative_sign(of.g, g);
    };
    for (std::size_t i = 0; i < given_.steps.size(); ++i) {
        const expression u = argument(i, values);
        if (u.kind() == node_kind::constant || is_kept(u) || is_at_rest(i, values)) {
            if (is_sliding(i, values)) {
                add_ends_of_sliding(i, values, all);
            }
            continue;
        }
        for (const expression& each : levels(i, u, values[i])) {
            surface& at = add_surface(all, each, given_.steps[i].text);
            at.steps.push_back({i, orientation(at, each)});
        }
    }
    for (std::size_t i = 0; i < given_.events.size(); ++i) {
        if (given_.events[i].holds) {
            continue;
        }
        const expression& g = given_.events[i].condition;
        surface& at = add_surface(all, g, given_.events[i].text);
        at.events.push_back({i, orientation(at, g)});
    }
    return all;
}

}  // namespace libration::ode
