#include "libration/problem/certificate.hpp"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "libration/ode/opened_system.hpp"
#include "libration/ode/parse.hpp"
#include "libration/ode/proved/proved_events.hpp"
#include "libration/ode/proved/proved_trajectory.hpp"
#include "libration/ode/rigorous/certificate/certificate.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration {

namespace {

// More zeros than those of the requested direction are not listed.
constexpr long most_zeros = 100'000;

// The digits by which a value near 0 is seen to be missed.
constexpr long least_digits = 4;

std::string compressed(const std::string& text) {
    uLongf size = compressBound(text.size());
    std::string result(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
                  text.size(), Z_BEST_COMPRESSION) != Z_OK) {
        throw std::runtime_error("zlib does not compress a text in memory");
    }
    result.resize(size);
    return result;
}

rational fraction_of(const exact& time) {
    const auto q = time.has_periods() ? std::nullopt : as_expression(time).fraction();
    if (!q) {
        throw error(error_kind::argument, "certificate", "",
                    "is for times that are fractions, and " + time.text + " is not one: choose fractions as times");
    }
    return *q;
}

rational middle_of(const ode::decimal_interval& of) { return (of.low + of.high) / 2; }

// The text with the progress of the run that is going on, to the time that is farthest.
std::string text_of(const ode::explicit_system& system, const ode::certified_statement& statement,
                    const rational& farthest, const request& how) {
    const auto whole = farthest.convert_to<double>();
    return ode::certificate_of(system, statement, how.printed_digits(), [&](const ball& reached, long bits) {
        const double time = midpoint_of(reached).convert_to<double>();
        if (how.reached) {
            how.reached(time, bits);
        }
        if (how.progress) {
            how.progress(whole == 0 ? 0 : std::clamp(time / whole, 0.0, 1.0));
        }
    });
}

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
            throw error(error_kind::undecided, "certificate", "",
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
        throw error(error_kind::undecided, "certificate", printed.lower,
                    "is near an event that a second search does not find: ask for more digits");
    }
    return static_cast<std::size_t>(found - zeros.begin());
}

// A problem with a number of it that is an initial value of its own: a parameter becomes a constant unknown.
struct problem_at {
    ode::explicit_system system;
    std::size_t place;
};

[[noreturn]] void refuse_root(const std::string& reason) {
    throw error(error_kind::argument, "certificate", "", reason + ": leave the certificate out");
}

std::size_t place_of(const ode::explicit_system& system, const std::string& name) {
    const auto names = ode::names_of_state(system);
    return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
}

problem_at with_value(const ode::equation_system& equations, const std::string& name, const rational& value) {
    const ode::equation_system changed = ode::changed(equations, name + " = " + value.str());
    if (const auto point = name.find('('); point != std::string::npos) {
        const ode::explicit_system system(changed);
        return {system, place_of(system, name.substr(0, point))};
    }
    const ode::opened_system open = ode::opened(changed, {name});
    if (std::ranges::count_if(open.starts, &ode::expression::has_unknowns) == 1) {
        return {open.system, place_of(open.system, name)};
    }
    // A parameter that is an initial value and nothing else, as of f''(0) = k.
    const auto is_other = [&](std::size_t k) { return ode::names_of_state(open.system)[k] != name; };
    std::vector<std::size_t> others;
    for (std::size_t k = 0; k < open.starts.size(); ++k) {
        if (open.starts[k].has_unknowns() && is_other(k)) {
            others.push_back(k);
        }
    }
    const bool in_equations = std::ranges::any_of(open.system.right(), [&](const ode::expression& right) {
        bool found = false;
        each_leaf(right, [&](const ode::expression& leaf) {
            found = found || (leaf.kind() == ode::node_kind::unknown && leaf.name() == name);
        });
        return found;
    });
    if (others.size() > 1 || in_equations || !same_form(open.starts[others.front()], open.leaves.front())) {
        refuse_root("does not contain parameters on which an initial value depends, as on " + name);
    }
    const ode::explicit_system system(changed);
    return {system, place_of(system, ode::names_of_state(open.system)[others.front()])};
}

// f'(5) = 1: a value at a time.
struct value_at_time {
    std::string name;
    rational time, value;
};

value_at_time read_condition(const ode::equation_system& equations, const std::string& condition) {
    const std::string contained =
        "contains roots of one condition such as y(1) = 1/2, with fractions, and not of " + condition;
    try {
        const auto equals = condition.find('=');
        const ode::start left = ode::parse_value_at_time(equations, condition.substr(0, equals));
        const auto value =
            ode::parse_constant(condition.substr(equals == std::string::npos ? 0 : equals + 1)).fraction();
        const auto time = left.point.fraction();
        if (value && time) {
            return {ode::primed(left.of.name(), left.of.derivative()), *time, *value};
        }
    } catch (const error& problem) {
        if (problem.kind() != error_kind::argument) {
            throw;
        }
    }
    refuse_root(contained);
}

// The interval of a value, with as many digits as exclude `missed`.
ode::decimal_interval apart_from(const rational& missed, const problem_at& of, const value_at_time& at, long digits) {
    for (const long more : {least_digits - digits, 0L, 4L, 8L, 16L, 32L, 64L}) {
        const auto values = ode::proved_trajectory(of.system, {ode::number(at.time)}, digits + more);
        const auto found = ode::within_one_unit(values.front()[place_of(of.system, at.name)].text, digits + more);
        if (missed < found.low || found.high < missed) {
            return found;
        }
    }
    throw error(error_kind::undecided, "certificate", at.time.str(),
                "has a value that is not distinguished from that of the condition: ask for fewer digits");
}

}  // namespace

std::string certificate_of_root(const problem& of, const std::string& unknown, const std::string& condition,
                                const std::string& decimal, const request& how) {
    const auto& equations = of.equations();
    const value_at_time at = read_condition(equations, condition);
    const long digits = how.printed_digits();
    const auto root = ode::within_one_unit(decimal, digits);
    std::string text;
    std::vector<ode::decimal_interval> found;
    for (const rational& end : {root.low, root.high}) {
        const problem_at here = with_value(equations, unknown, end);
        found.push_back(apart_from(at.value, here, at, digits));
        const std::size_t place = place_of(here.system, at.name);
        text += text_of(here.system, {.values = {{at.time, place, found.back()}}}, at.time, how);
    }
    if ((found[0].low < at.value) == (found[1].low < at.value)) {
        throw error(error_kind::undecided, "certificate", decimal,
                    "is a root at which the value of the condition does not change its sign");
    }
    // Only the existence of these solutions is needed.
    const integer size =
        1 + std::max(nearest_integer(rational(abs(found[0].low))), nearest_integer(rational(abs(found[1].low))));
    const integer wide = 2 * size;
    const ode::decimal_interval anything{integer(-wide).str(), wide.str(), rational(integer(-wide)), rational(wide)};
    const problem_at between = with_value(equations, unknown, root.low);
    const std::size_t place = place_of(between.system, at.name);
    text += text_of(
        between.system,
        {.values = {{at.time, place, anything}}, .start = ode::start_interval{between.place, root.low, root.high}},
        at.time, how);
    return compressed(text);
}

std::string certificate_of_states(const ode::explicit_system& system, const std::vector<exact>& times,
                                  const printed_rows& states, const request& how) {
    ode::certified_statement statement;
    rational farthest;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const rational time = fraction_of(times[i]);
        farthest = abs(time) > abs(farthest) ? time : farthest;
        for (std::size_t place = 0; place < states.of[i].size(); ++place) {
            statement.values.push_back({time, place, ode::within_one_unit(states.of[i][place], states.digits)});
        }
    }
    return compressed(text_of(system, statement, farthest, how));
}

std::string certificate_of_events(const ode::explicit_system& system, const ode::expression& g, int way,
                                  const printed_rows& events, const request& how) {
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
    return compressed(text_of(system, statement, middle_of(times.back()), how));
}

}  // namespace libration
