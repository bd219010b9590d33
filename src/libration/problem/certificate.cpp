#include "libration/problem/certificate.hpp"

#include <algorithm>

#include "certificate_text.hpp"
#include "libration/query/proved_events.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration {

namespace {

// More zeros than those of the requested direction are not listed.
constexpr long most_zeros = 100'000;

rational fraction_of(const exact& time) {
    const auto q = time.has_periods() ? std::nullopt : as_exact_real(time).fraction();
    if (!q) {
        throw error(error_kind::argument, error_subject::certificate, "",
                    "is for times that are fractions, and " + time.text + " is not one: choose fractions as times");
    }
    return *q;
}

rational middle_of(const ode::decimal_interval& of) { return (of.low + of.high) / 2; }

// All zeros after the initial point up to the last of the given ones, to as many digits.
std::vector<ode::decimal_interval> all_zeros(const ode::explicit_system& system, const ode::expression& g,
                                             const ode::decimal_interval& last, long digits, const request& how) {
    ode::event_request all{.g = g, .count = most_zeros};
    const bool backwards = (ode::number(middle_of(last)) - system.point()).sign() < 0;
    all.before = ode::number(backwards ? last.low : last.high);
    all.direction = backwards ? -1 : 1;
    const auto report = ode::searched_events(system, all, digits, {}, [&](const ball& reached, long bits, const auto&) {
        if (how.reached) {
            how.reached(midpoint_of(reached).convert_to<double>(), bits);
        }
    });
    std::vector<ode::decimal_interval> zeros;
    for (const ode::known_event& each : report.events) {
        if (!each.time.decimal) {
            throw error(error_kind::undecided, error_subject::certificate, "",
                        "does not contain an event at a time that is not distinguished from 0");
        }
        zeros.push_back(ode::within_one_unit(each.time.decimal->text, digits));
    }
    return zeros;
}

// The index of the zero that is printed like this.
std::size_t place_of(const std::vector<ode::decimal_interval>& zeros, const ode::decimal_interval& printed) {
    const auto found = std::ranges::find_if(
        zeros, [&](const ode::decimal_interval& each) { return each.low <= printed.high && printed.low <= each.high; });
    if (found == zeros.end()) {
        throw error(error_kind::undecided, error_subject::certificate, printed.lower,
                    "is near an event that a second search does not find: ask for more digits");
    }
    return static_cast<std::size_t>(found - zeros.begin());
}

}  // namespace

std::string certificate_of_states(const ode::explicit_system& system, const std::vector<exact>& times,
                                  const printed_rows& states, const request& how, const certificate_notes& notes) {
    ode::certified_statement statement;
    rational farthest;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const rational time = fraction_of(times[i]);
        farthest = abs(time) > abs(farthest) ? time : farthest;
        for (std::size_t place = 0; place < states.of[i].size(); ++place) {
            statement.values.push_back({time, place, ode::within_one_unit(states.of[i][place], states.digits)});
        }
    }
    return compressed_certificate(text_of_certificate(system, statement, farthest, how.printed_digits(), how), notes);
}

std::string certificate_of_events(const ode::explicit_system& system, const ode::expression& g, int way,
                                  const printed_rows& events, const request& how, const certificate_notes& notes) {
    std::vector<ode::decimal_interval> times;
    for (const auto& row : events.of) {
        times.push_back(ode::within_one_unit(row.front(), events.digits));
    }
    ode::certified_statement statement;
    statement.zeros = {g, way == 0 ? times : all_zeros(system, g, times.back(), events.digits, how)};
    for (std::size_t i = 0; i < times.size(); ++i) {
        const std::size_t zero = place_of(statement.zeros->times, times[i]);
        for (std::size_t place = 0; place + 1 < events.of[i].size(); ++place) {
            statement.values.push_back({{}, place, ode::within_one_unit(events.of[i][place + 1], events.digits), zero});
        }
    }
    return compressed_certificate(
        text_of_certificate(system, statement, middle_of(times.back()), how.printed_digits(), how), notes);
}

}  // namespace libration
