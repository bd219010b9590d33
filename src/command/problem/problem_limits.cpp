// Conditions at infinity in the text of a problem.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "libration/equation/text/limit_condition.hpp"
#include "libration/equation/text/parse.hpp"
#include "problem_options.hpp"
#include "text/input_error.hpp"

namespace libration {

std::vector<std::string> problem_options::take_limits() {
    if (!problem_) {
        return {};
    }
    ode::separated_text separated;
    std::optional<std::string> started;
    try {
        separated = ode::with_limits_separated(problem_named(*problem_).text);
        if (separated.limits.empty()) {
            return {};
        }
        const auto ends_at = [&](const char* end) {
            return std::ranges::any_of(separated.limits,
                                       [&](const std::string& each) { return each.find(end) != std::string::npos; });
        };
        const auto system = ode::parse(separated.problem);
        const auto highest = system.highest_derivatives();
        for (const std::string& name :
             ends_at("(-inf)") && ends_at("(inf)") ? system.unknowns() : std::vector<std::string>()) {
            for (int order = 0; order < highest.at(name); ++order) {
                const auto of = ode::unknown(name, order);
                if (std::ranges::any_of(system.starts,
                                        [&](const ode::start& each) { return same_form(each.of, of); })) {
                    started = ode::primed(name, order);
                }
                separated.problem += fmt::format("\n{}(0) = 0", ode::primed(name, order));
            }
        }
    } catch (const error&) {
        return {};  // reported where the problem is read
    }
    if (started) {
        throw input_error(
            "--problem", *started,
            "has an initial value and limits at both ends, which determine an orbit up to its time",
            "leave the value out, or, where the orbit is symmetric about it, one of the ends, as u(0) = pi; "
            "u(inf) = 2*pi with --unknown \"u'(0)\"");
    }
    with_limits_ = problem_;
    problem_ = separated.problem;
    limits_ = separated.limits;
    return limits_;
}

bool problem_options::has_limits() const {
    try {
        return problem_ && !ode::with_limits_separated(problem_named(*problem_).text).limits.empty();
    } catch (const error&) {
        return false;  // reported where the problem is read
    }
}

std::vector<std::string> problem_options::take_shown(const std::vector<std::string>& words) {
    std::vector<std::string> taken;
    std::erase_if(shown_, [&](const std::string& each) {
        if (std::ranges::find(words, each) == words.end()) {
            return false;
        }
        try {
            ode::with_column(ode::parse(problem_named(*problem_).text), each);
            return false;
        } catch (const error&) {
            taken.push_back(each);
            return true;
        }
    });
    return taken;
}

}  // namespace libration
