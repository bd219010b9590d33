#include "libration/problem/limit_text.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include "../query/connection/orbit_symmetry.hpp"
#include "found_values.hpp"
#include "libration/equation/text/limit_condition.hpp"
#include "libration/equation/text/parse.hpp"

namespace libration {

namespace {

std::string without_spaces(std::string text) {
    std::erase(text, ' ');
    return text;
}

// Of "c = 0.3" or "c".
std::string name_in(const std::string& unknown) { return without_spaces(unknown.substr(0, unknown.find('='))); }

// The right-hand side of "y(inf) = 2*pi fast".
std::string value_in(const std::string& condition) {
    std::string value = condition.substr(condition.find('=') + 1);
    for (const char* const word : {" exponentially", " fast", " with amplitude"}) {
        value = value.substr(0, value.find(word));
    }
    return value;
}

std::string value_of(const ode::expression& centre, const std::string& name,
                     const std::vector<ode::limit_condition>& limits) {
    if (const auto q = centre.fraction()) {
        return q->str();
    }
    std::string sum;
    for (const ode::limit_condition& each : limits) {
        if (ode::primed(each.of.name(), each.of.derivative()) == name) {
            sum += (sum.empty() ? "(" : " + (") + value_in(each.text) + ")";
        }
    }
    return "(" + sum + ")/2";
}

std::vector<ode::limit_condition> limits_in(const ode::equation_system& system, const ode::separated_text& text) {
    std::vector<ode::limit_condition> limits;
    for (const std::string& each : text.limits) {
        limits.push_back(about(error_subject::conditions, [&] { return ode::parse_limit(system, each); }));
    }
    return limits;
}

[[noreturn]] void refuse_start(const std::string& name) {
    throw error(error_kind::argument, error_subject::problem, name,
                "has an initial value and limits at both ends, which determine an orbit up to its time: leave the "
                "value out, or, where the orbit is symmetric about it, one of the ends, as u(0) = pi; u(inf) = 2*pi "
                "with --unknown \"u'(0)\"");
}

ode::separated_text separated_limits(const std::string& text) {
    auto separated = ode::with_limits_separated(text);
    if (separated.limits.empty()) {
        throw error(error_kind::argument, error_subject::problem, "",
                    "has no condition at infinity: add one, such as y(inf) = 0");
    }
    return separated;
}

}  // namespace

std::vector<std::string> open_numbers(const ode::equation_system& system) {
    std::vector<std::string> names;
    for (const ode::open_parameter& each : system.open) {
        names.push_back(each.name);
    }
    const auto point = system.starts.empty() ? std::optional<rational>(0) : system.starts.front().point.fraction();
    const auto highest = system.highest_derivatives();
    for (const std::string& name : system.unknowns()) {
        for (int order = 0; order < highest.at(name); ++order) {
            const auto of = ode::unknown(name, order);
            if (point &&
                std::ranges::none_of(system.starts, [&](const ode::start& each) { return same_form(each.of, of); })) {
                names.push_back(ode::primed(name, order) + "(" + point->str() + ")");
            }
        }
    }
    return names;
}

std::string with_starts_between(const ode::separated_text& separated, const std::vector<std::string>& unknowns) {
    const auto typed = ode::parse(separated.problem);
    const auto complete = ode::with_idle_starts(typed);
    const auto limits = limits_in(complete, separated);
    if (!ode::is_two_sided(limits)) {
        return separated.problem;
    }
    const auto symmetry = ode::symmetry_between(complete, limits, unknowns);
    std::string result = separated.problem;
    for (const ode::start& each : complete.starts) {
        const std::string name = ode::primed(each.of.name(), each.of.derivative());
        const bool is_typed =
            std::ranges::any_of(typed.starts, [&](const ode::start& other) { return same_form(other.of, each.of); });
        const auto centre = symmetry ? symmetry->centre_of(each.of) : std::optional<ode::expression>();
        if (is_typed) {
            if (!centre || !(ode::expression(ode::parameter_values(complete).number_of(each.value)) - *centre).is(0)) {
                refuse_start(name);
            }
        } else if (centre || !symmetry) {
            result +=
                "\n" + ode::name_of_start(each.of, each.point) + " = " + value_of(centre.value_or(0), name, limits);
        }
    }
    return result;
}

std::optional<limit_problem> symmetric_orbit_of(const problem& of, const std::vector<std::string>& limits) {
    ode::equation_system system = of.equations();
    std::vector<ode::limit_condition> conditions;
    conditions.reserve(limits.size());
    for (const std::string& each : limits) {
        conditions.push_back(ode::parse_limit(system, each));
    }
    const auto symmetry = ode::symmetry_between(system, conditions);
    if (!symmetry) {
        return std::nullopt;
    }
    std::vector<std::string> unknowns;
    for (ode::start& each : system.starts) {
        const auto centre = symmetry->centre_of(each.of);
        if (centre) {
            each.value = *centre;
        } else {
            unknowns.push_back(ode::name_of_start(each.of, each.point));
        }
    }
    return limit_problem{problem(std::move(system)), unknowns, limits, unknowns};
}

limit_problem limit_problem_of(const std::string& text, const std::vector<std::string>& unknowns) {
    const auto separated = separated_limits(text);
    std::vector<std::string> names;
    std::ranges::transform(unknowns, std::back_inserter(names), name_in);
    auto system = ode::parse(with_starts_between(separated, names));
    limit_problem result{problem(ode::equation_system()), {}, separated.limits, {}};
    for (const std::string& each : unknowns.empty() ? open_numbers(system) : unknowns) {
        const bool is_guessed = each.find('=') != std::string::npos;
        const std::string name = name_in(each);
        result.unknowns.push_back(name);
        if (!is_guessed) {
            result.without_guess.push_back(name);
        }
        system = about(error_subject::unknowns,
                       [&] { return ode::changed(std::move(system), is_guessed ? each : name + " = 1"); });
    }
    if (result.unknowns.empty() && !ode::is_two_sided(limits_in(system, separated))) {
        throw error(error_kind::argument, error_subject::problem, "",
                    "leaves nothing open: leave out the value that the conditions at infinity determine, or name it as "
                    "an unknown");
    }
    result.of = problem(std::move(system));
    return result;
}

limit_problem eigenvalue_problem_of(const std::string& text, const std::string& energy) {
    const auto separated = separated_limits(text);
    auto system =
        about(error_subject::unknowns, [&] { return ode::changed(ode::parse(separated.problem), energy + " = 1"); });
    return {problem(std::move(system)), {energy}, separated.limits, {}};
}

}  // namespace libration
