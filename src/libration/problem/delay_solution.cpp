#include "delay_solution.hpp"

#include <algorithm>
#include <iterator>

#include "libration/digits/printed_values.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/problem/proved_answer.hpp"
#include "libration/query/delay_events.hpp"
#include "libration/query/delay_trajectory.hpp"
#include "libration/scalar/decimal.hpp"
#include "states_at_times.hpp"

namespace libration {

namespace {

constexpr const char* not_with_delays = "is not supported for a problem with delays";

// For what the solution does not answer.
[[noreturn]] void refuse_question() {
    throw error(error_kind::argument, error_subject::problem, "",
                "has delays, for which only values at times and events are supported: use reference or trajectory");
}

}  // namespace

delay_solution::delay_solution(const ode::equation_system& equations)
    : solution(ode::names_of_state(ode::delay_system(equations))), equations_(equations), system_(equations) {}

answer delay_solution::states(const std::vector<exact>& times, const request& how) const {
    if (!how.derivatives.empty()) {
        throw error(error_kind::argument, error_subject::derivatives, how.derivatives.front(),
                    std::string(not_with_delays) + ": leave it out");
    }
    require_plain_states(how, not_with_delays);
    std::vector<ode::number> at;
    std::ranges::transform(times, std::back_inserter(at), time_of_problem);
    const bool proves = how.scalar.kind == scalar_kind::proved || how.scalar.kind == scalar_kind::arbitrary;
    return proves ? proved_states(at, how) : rounded_states(at, how);
}

// With the stages up to the last of the times.
ode::delay_system delay_solution::system_to(const std::vector<ode::number>& times) const {
    if (!system_.is_neutral() || times.empty()) {
        return system_;
    }
    const auto last =
        std::ranges::max_element(times, [](const ode::number& a, const ode::number& b) { return (a - b).sign() < 0; });
    return ode::delay_system(equations_, *last);
}

answer delay_solution::proved_states(const std::vector<ode::number>& times, const request& how) const {
    const auto checked = checked_products(how.check);
    const long digits = how.printed_digits();
    const ode::delay_system system = system_to(times);
    const auto found = ode::proved_part_of_delay(system, times, digits, watch_of(system.point(), times, how));
    if (how.check) {
        const auto other = ode::proved_part_of_delay(system, times, digits + ode::more_digits_of_second_proof);
        require_agreement(found, other, quantities());
    }
    return answer_of(quantities(), found);
}

answer delay_solution::rounded_states(const std::vector<ode::number>& times, const request& how) const {
    answer result{.names = quantities(), .rows = {}, .rigour = "heuristic"};
    result.rows.resize(times.size());
    const ode::delay_system system = system_to(times);
    const precision_scope wide(how.scalar.digits + digits_beyond_result);
    with_scalar(how.scalar, 0, [&]<class T>() {
        auto part = ode::part_of_delay<T>(system, times, watch_of(system.point(), times, how));
        for (std::size_t i = 0; i < times.size(); ++i) {
            for (const T& value : part.states[i].front()) {
                result.rows[i].push_back({to_decimal(widen(value), how.printed_digits()), ""});
            }
        }
        result.missing = std::move(part.missing);
    });
    return result;
}

answer delay_solution::states_along(const complex_path_request& /*along*/, const request& /*how*/) const {
    throw error(error_kind::argument, error_subject::point, "of the complex plane",
                std::string(not_with_delays) + ": use real times");
}

answer delay_solution::limits(const request& /*how*/) const {
    throw error(error_kind::argument, error_subject::time, "inf",
                std::string(not_with_delays) + ": choose finite times");
}

answer delay_solution::events(const ode::event_request& of, const request& how, const ode::event_watch& watch) const {
    return events_by(quantities(), how, watch, [&](long digits, const auto& /*route*/, const auto& watched) {
        return ode::searched_delay_events(system_, of, digits, watched);
    });
}

ode::expression delay_solution::condition(const std::string& text) const {
    return ode::parse_condition(equations_, text);
}

void delay_solution::require_point(const std::string& about) const {
    if (!about.empty()) {
        throw error(error_kind::argument, error_subject::point, about, std::string(not_with_delays) + ": leave it out");
    }
}

answer delay_solution::series(const series_request& /*of*/, const request& /*how*/) const { refuse_question(); }

std::vector<unknown_series> delay_solution::coefficient_lists(const series_request& /*of*/,
                                                              const scalar_spec& /*scalar*/) const {
    refuse_question();
}

answer delay_solution::singularities(const std::optional<double>& /*within*/, const request& /*how*/) const {
    refuse_question();
}

answer delay_solution::proved_radius(const series_request& /*of*/, const request& /*how*/) const { refuse_question(); }

}  // namespace libration
