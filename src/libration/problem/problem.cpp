#include "libration/problem/problem.hpp"

#include "libration/ode/parse.hpp"
#include "libration/problem/catalogue.hpp"

namespace libration {

problem::problem(const std::string& text) {
    const bool typed = text.find('=') != std::string::npos;
    name = typed ? "" : text;
    equations = ode::parse(typed ? text : std::string(problem_text(text)));
}

problem& problem::set(const std::string& change) {
    equations = ode::changed(std::move(equations), change);
    return *this;
}

std::string reason_against(const std::vector<without_answer>& excluded, const std::string& coordinate,
                           const exact& value) {
    for (const without_answer& each : excluded) {
        if (each.coordinate == coordinate && each.at(value)) {
            return each.reason;
        }
    }
    return "";
}

}  // namespace libration
