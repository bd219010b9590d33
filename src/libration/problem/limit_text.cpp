#include "libration/problem/limit_text.hpp"

#include <algorithm>
#include <optional>

#include "found_values.hpp"
#include "libration/equation/text/limit_condition.hpp"
#include "libration/equation/text/parse.hpp"

namespace libration {

namespace {

std::string without_spaces(std::string text) {
    std::erase(text, ' ');
    return text;
}

// Initial values that have no effect.
ode::equation_system with_idle_starts(ode::equation_system system) {
    const auto highest = system.highest_derivatives();
    for (const std::string& name : system.unknowns()) {
        for (int order = 0; order < highest.at(name); ++order) {
            const auto of = ode::unknown(name, order);
            if (std::ranges::none_of(system.starts, [&](const ode::start& each) { return same_form(each.of, of); })) {
                system.begin(of, 0, system.starts.empty() ? ode::expression(0) : system.starts.front().point);
            }
        }
    }
    return system;
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

limit_problem limit_problem_of(const std::string& text, const std::vector<std::string>& unknowns) {
    const auto separated = separated_limits(text);
    auto system = ode::parse(separated.problem);
    const auto ends_at = [&](const char* end) {
        return std::ranges::any_of(separated.limits,
                                   [&](const std::string& each) { return each.find(end) != std::string::npos; });
    };
    if (ends_at("(-inf)") && ends_at("(inf)")) {
        system = with_idle_starts(std::move(system));
    }
    limit_problem result{problem(ode::equation_system()), {}, separated.limits, {}};
    for (const std::string& each : unknowns.empty() ? open_numbers(system) : unknowns) {
        const auto equals = each.find('=');
        const std::string name = without_spaces(each.substr(0, equals));
        result.unknowns.push_back(name);
        if (equals == std::string::npos) {
            result.without_guess.push_back(name);
        }
        system = about(error_subject::unknowns, [&] {
            return ode::changed(std::move(system), equals == std::string::npos ? name + " = 1" : each);
        });
    }
    if (result.unknowns.empty()) {
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
