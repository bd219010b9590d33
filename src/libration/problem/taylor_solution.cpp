#include "taylor_solution.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "libration/digits/printed_values.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/expansion/fast_product.hpp"
#include "libration/expansion/invariant.hpp"
#include "libration/integration/taylor/taylor_march.hpp"
#include "libration/number/two_proofs.hpp"
#include "libration/problem/known_facts.hpp"
#include "libration/problem/proved_answer.hpp"
#include "libration/problem/proved_law.hpp"
#include "libration/query/limit.hpp"
#include "libration/query/proved_events.hpp"
#include "libration/query/states.hpp"
#include "libration/query/stiff_trajectory.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/decimal.hpp"
#include "states_at_times.hpp"

namespace libration {

namespace {

constexpr long digits_of_second = ode::more_digits_of_second_proof;

std::vector<ode::number> numbers_of(const std::vector<exact>& times) {
    std::vector<ode::number> at;
    std::ranges::transform(times, std::back_inserter(at), time_of_problem);
    return at;
}

// In the arithmetic in which they are printed.
template <class T>
ode::partial_states<mpfr> in_wide_numbers(ode::partial_states<T> part) {
    ode::partial_states<mpfr> all{{}, std::move(part.missing), std::move(part.collocation)};
    for (const auto& state : part.states) {
        auto& wide = all.states.emplace_back();
        for (const auto& of_unknown : state) {
            auto& values = wide.emplace_back();
            std::ranges::transform(of_unknown, std::back_inserter(values), [](const T& x) { return widen(x); });
        }
    }
    return all;
}

ode::partial_states<mpfr> integrated(const ode::explicit_system& system, const std::vector<ode::number>& times,
                                     const request& how) {
    if (how.scalar.kind == scalar_kind::arbitrary) {
        return ode::part_of_stiff_trajectory(system, times, digits_of_integration(how), how.integrator,
                                             ode::fast_product<mpfr>());
    }
    const precision_scope wide(how.scalar.digits + digits_beyond_result);
    return with_scalar(how.scalar, 0, [&]<class T>() {
        return in_wide_numbers(ode::part_of_stiff_march<T>(system, times, how.integrator));
    });
}

// The values of a state in order; empty if it is not reached at all.
std::vector<answer_value> rounded_row(const ode::explicit_system& system, const ode::solution_state<mpfr>& state,
                                      long digits) {
    std::vector<answer_value> row;
    bool reached = false;
    for (std::size_t i = 0; i < state.size(); ++i) {
        if (state[i].empty()) {
            row.resize(row.size() + static_cast<std::size_t>(system.unknowns()[i].order));
        }
        for (const mpfr& value : state[i]) {
            row.push_back({to_decimal(value, digits), ""});
            reached = true;
        }
    }
    return reached ? row : std::vector<answer_value>{};
}

}  // namespace

ode::number time_of_problem(const exact& time) {
    if (time.has_periods()) {
        throw error(error_kind::argument, error_subject::time, time.text,
                    "is a multiple of a period, which a problem does not have");
    }
    return as_exact_real(time);
}

taylor_solution::taylor_solution(ode::equation_system equations)
    : solution(ode::names_of_state(ode::explicit_system(equations))),
      equations_(std::move(equations)),
      system_(equations_) {}

answer taylor_solution::states(const std::vector<exact>& times, const request& how) const {
    require_proof_of_derivatives(how);
    return how.scalar.kind == scalar_kind::proved ? proved_states(times, how) : rounded_states(times, how);
}

// The values at each time and, if any are requested, the derivatives.
ode::partial_trajectory taylor_solution::proved_part(const std::vector<exact>& times, const request& how, long digits,
                                                     const ode::march_watch& watch, const ode::proof_route& route,
                                                     const ode::step_observer& observer) const {
    const auto at = numbers_of(times);
    if (how.derivatives.empty()) {
        const ode::shared_integrations::use kept(kept_);
        return ode::proved_part_of_trajectory(system_, at, digits, watch, route, observer, kept.steps());
    }
    return in_columns(ode::proved_derivatives(equations_, at, how.derivatives, digits, watch, route, observer),
                      columns_of(how).size());
}

std::vector<std::string> taylor_solution::columns_of(const request& how) const {
    return names_of_states(quantities(), system_.variable(), how);
}

void taylor_solution::require_second_proof(const std::vector<exact>& times, const request& how,
                                           const ode::partial_trajectory& first) const {
    ode::proof_route route = ode::proof_route::second();
    route.integrator = how.integrator;
    const auto second = proved_part(times, how, how.printed_digits() + digits_of_second, {}, route, {});
    const auto names = columns_of(how);
    for (std::size_t i = 0; i < first.states.size(); ++i) {
        const std::size_t compared = std::min(first.states[i].size(), second.states[i].size());
        for (std::size_t j = 0; j < compared; ++j) {
            const auto& a = first.states[i][j].decimal;
            const auto& b = second.states[i][j].decimal;
            if (a && b) {
                require_agreement(*a, *b, names[j] + " at time " + times[i].text);
            }
        }
    }
}

answer taylor_solution::proved_states(const std::vector<exact>& times, const request& how) const {
    const auto checked = checked_products(how.check);
    ode::proof_route route;
    route.integrator = how.integrator;
    const auto found = proved_part(times, how, how.printed_digits(), watch_of(system_.point(), numbers_of(times), how),
                                   route, how.observer);
    if (how.check) {
        require_second_proof(times, how, found);
    }
    return answer_of(columns_of(how), found);
}

answer taylor_solution::rounded_states(const std::vector<exact>& times, const request& how) const {
    auto part = integrated(system_, numbers_of(times), how);
    const bool agreed = how.scalar.kind == scalar_kind::arbitrary;
    answer result{.names = quantities(), .rows = {}, .rigour = agreed ? "two-method" : "heuristic"};
    for (const auto& state : part.states) {
        result.rows.push_back(rounded_row(system_, state, how.printed_digits()));
    }
    result.drifts = drifts(times, part.states, digits_of_integration(how));
    result.missing = std::move(part.missing);
    result.collocation = std::move(part.collocation);
    return result;
}

std::vector<std::string> taylor_solution::drifts(const std::vector<exact>& times,
                                                 const std::vector<ode::solution_state<mpfr>>& states,
                                                 long digits) const {
    std::vector<std::string> all;
    if (system_.invariants().empty() || system_.singular()) {
        return all;
    }
    const precision_scope scope(digits + digits_beyond_result);
    ode::invariants<mpfr> constant(system_);
    const auto at = numbers_of(times);
    for (std::size_t i = 0; i < at.size(); ++i) {
        if (std::ranges::any_of(states[i], [](const auto& values) { return values.empty(); })) {
            all.emplace_back();
            continue;
        }
        const mpfr drift = constant.drift(ode::constant_value<mpfr>::of(at[i]), states[i]);
        all.push_back(to_decimal(drift, digits_of_drift));
    }
    return all;
}

answer taylor_solution::limits(const request& how) const {
    if (const auto known = limits_by_lemma(equations_, how.printed_digits())) {
        ode::partial_trajectory found{.states = {{}}, .missing = {}};
        for (const proved_decimal& each : *known) {
            found.states.front().push_back({each, ""});
        }
        return answer_of(quantities(), found);
    }
    const auto watch = [&](const ball& reached, long bits) {
        if (how.reached) {
            how.reached(midpoint_of(reached).convert_to<double>(), bits);
        }
    };
    ode::proof_route route;
    route.integrator = how.integrator;
    return answer_of(quantities(), ode::limit_at_equilibrium(system_, how.printed_digits(), watch, route));
}

answer taylor_solution::events(const ode::event_request& of, const request& how, const ode::event_watch& watch) const {
    return events_by(quantities(), how, watch, [&](long digits, const auto& route, const auto& watched) {
        const ode::shared_integrations::use kept(kept_);
        return ode::searched_events(system_, of, digits, route, watched, kept.steps());
    });
}

ode::expression taylor_solution::condition(const std::string& text) const {
    return ode::parse_condition(equations_, text);
}

proved_law taylor_solution::law(const law_question& asked, const request& how) const { return {system_, asked, how}; }

}  // namespace libration
