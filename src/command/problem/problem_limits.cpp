// Conditions at infinity in the text of a problem.
#include <algorithm>
#include <utility>

#include "libration/equation/text/limit_condition.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/problem/limit_text.hpp"
#include "problem_options.hpp"

namespace libration {

std::vector<std::string> problem_options::take_limits(const std::vector<std::string>& unknowns) {
    if (!has_limits()) {
        return {};
    }
    const auto separated = ode::with_limits_separated(problem_named(*problem_).text);
    with_limits_ =
        std::exchange(problem_, naming_option("--problem", [&] { return with_starts_between(separated, unknowns); }));
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
