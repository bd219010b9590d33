#include "hybrid_solution.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "../query/shown_values.hpp"
#include "libration/digits/printed_values.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/hybrid/initial_mode.hpp"
#include "libration/problem/proved_answer.hpp"
#include "libration/query/hybrid_derivatives.hpp"
#include "libration/query/hybrid_trajectory.hpp"
#include "libration/query/trajectory.hpp"
#include "libration/scalar/decimal.hpp"
#include "states_at_times.hpp"

namespace libration {

namespace {

constexpr const char* unsupported = "is not supported for a problem with events or a piecewise right-hand side";

// The states on one branch, each value in the arithmetic in which it is printed.
template <class T>
void add_states(const ode::hybrid_system& system, const ode::hybrid_branch& branch,
                const std::vector<ode::number>& times, long digits, answer& result) {
    std::vector<ode::number> on_branch;
    for (const std::size_t index : branch.times) {
        on_branch.push_back(times[index]);
    }
    const auto part = ode::part_of_march<T>(branch.system, on_branch);
    for (std::size_t i = 0; i < branch.times.size(); ++i) {
        std::vector<T> values;
        for (const auto& of_unknown : part.states[i]) {
            values.insert(values.end(), of_unknown.begin(), of_unknown.end());
        }
        if (!values.empty()) {
            ode::append_shown(values, system, branch.system, branch.steps, T(ode::constant_value<T>::of(on_branch[i])));
        }
        for (const T& value : values) {
            result.rows[branch.times[i]].push_back({to_decimal(widen(value), digits), ""});
        }
    }
    if (part.missing && !result.missing) {
        result.missing = part.missing;
    }
}

// Of the first branch, in which the expressions to show are unknowns.
ode::equation_system equations_with_shown(const ode::hybrid_system& system) {
    const auto steps = ode::values_at_start(system);
    auto first = system.first_equations(steps);
    first.shown.clear();
    for (const ode::definition& each : system.shown()) {
        first.add(ode::unknown(each.name), system.on_branch(each.value, steps));
    }
    return first;
}

}  // namespace

hybrid_solution::hybrid_solution(ode::equation_system equations)
    : solution(ode::names_with_shown(ode::hybrid_system(equations))),
      equations_(std::move(equations)),
      system_(equations_),
      first_(equations_with_shown(system_)) {}

answer hybrid_solution::states(const std::vector<exact>& times, const request& how) const {
    require_plain_states(how, unsupported);
    require_proof_of_derivatives(how);
    std::vector<ode::number> at;
    std::ranges::transform(times, std::back_inserter(at), time_of_problem);
    const bool proves = how.scalar.kind == scalar_kind::proved || how.scalar.kind == scalar_kind::arbitrary;
    return proves ? proved_states(at, how) : rounded_states(at, how);
}

answer hybrid_solution::proved_states(const std::vector<ode::number>& times, const request& how) const {
    const auto checked = checked_products(how.check);
    const long digits = how.printed_digits();
    ode::proof_route route;
    route.integrator = how.integrator;
    const auto columns = names_of_states(quantities(), system_.variable(), how);
    const auto found = proved_part(times, how, digits, watch_of(system_.point(), times, how), route);
    if (how.check) {
        ode::proof_route second = ode::proof_route::second();
        second.integrator = how.integrator;
        const auto other = proved_part(times, how, digits + ode::more_digits_of_second_proof, {}, second);
        require_agreement(found, other, columns);
    }
    return answer_of(columns, found);
}

ode::partial_trajectory hybrid_solution::proved_part(const std::vector<ode::number>& times, const request& how,
                                                     long digits, const ode::march_watch& watch,
                                                     const ode::proof_route& route) const {
    if (!how.derivatives.empty() && !system_.shown().empty()) {
        throw error(
            error_kind::argument, "columns", system_.shown().front().name,
            "of expressions have no derivatives for a problem with events or a piecewise right-hand side: leave "
            "out one of both");
    }
    if (how.derivatives.empty()) {
        return ode::proved_part_of_hybrid(system_, times, digits, watch, route);
    }
    return in_columns(ode::proved_derivatives_of_hybrid(equations_, times, how.derivatives, digits, watch, route),
                      names_of_states(quantities(), system_.variable(), how).size());
}

answer hybrid_solution::rounded_states(const std::vector<ode::number>& times, const request& how) const {
    answer result{.names = quantities(), .rows = {}, .rigour = "heuristic"};
    result.rows.resize(times.size());
    auto found = ode::branches_at_times(system_, times, how.scalar.digits);
    result.missing = std::move(found.missing);
    const precision_scope wide(how.scalar.digits + digits_beyond_result);
    for (const ode::hybrid_branch& each : found.branches) {
        with_scalar(how.scalar, 0,
                    [&]<class T>() { add_states<T>(system_, each, times, how.printed_digits(), result); });
    }
    return result;
}

answer hybrid_solution::states_along(const complex_path_request& /*along*/, const request& /*how*/) const {
    throw error(error_kind::argument, error_subject::point, "of the complex plane",
                std::string(unsupported) + ": use real times");
}

answer hybrid_solution::limits(const request& /*how*/) const {
    throw error(error_kind::undecided, error_subject::time, "inf", unsupported);
}

answer hybrid_solution::events(const ode::event_request& of, const request& how, const ode::event_watch& watch) const {
    return events_by(quantities(), how, watch, [&](long digits, const auto& route, const auto& watched) {
        return ode::searched_hybrid_events(system_, of, digits, route, watched);
    });
}

ode::expression hybrid_solution::condition(const std::string& text) const {
    return ode::parse_condition(equations_, text);
}

namespace {

constexpr const char* first_equations = "the equations as they are at the initial point, up to the first event";

answer of_first_branch(answer found) {
    found.notes.insert(found.notes.begin(), {"branch", "of " + std::string(first_equations)});
    return found;
}

}  // namespace

void hybrid_solution::require_point(const std::string& about) const {
    if (!about.empty()) {
        throw error(error_kind::argument, error_subject::point, about,
                    std::string(unsupported) + ": leave it out for the initial point");
    }
}

answer hybrid_solution::series(const series_request& of, const request& how) const {
    require_point(of.about);
    return of_first_branch(first_.series(of, how));
}

std::optional<answer> hybrid_solution::fractions(const series_request& of) const {
    require_point(of.about);
    return first_.fractions(of);
}

std::vector<unknown_series> hybrid_solution::coefficient_lists(const series_request& of,
                                                               const scalar_spec& scalar) const {
    require_point(of.about);
    return first_.coefficient_lists(of, scalar);
}

answer hybrid_solution::singularities(const std::optional<double>& within, const request& how) const {
    return of_first_branch(first_.singularities(within, how));
}

answer hybrid_solution::proved_radius(const series_request& of, const request& how) const {
    require_point(of.about);
    answer found = first_.proved_radius(of, how);
    for (answer_note& each : found.notes) {
        each.text += "; of " + std::string(first_equations);
    }
    return found;
}

}  // namespace libration
