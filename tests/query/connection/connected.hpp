// Questions about conditions at infinity in the text of a problem, for tests.
#pragma once

#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/query/connection/connection.hpp"

namespace libration::tests {

/// "c" is without a first guess, "c=0.3" with one.
inline ode::connection connected(const std::string& text, const std::vector<std::string>& unknowns, long digits) {
    const ode::separated_text separated = ode::with_limits_separated(text);
    ode::connection_question question;
    question.system = ode::parse(separated.problem);
    question.digits = digits;
    for (const std::string& each : unknowns) {
        const std::string name = each.substr(0, each.find('='));
        question.unknowns.push_back(name);
        if (name == each) {
            question.open.push_back(name);
        }
        question.system = ode::changed(question.system, name == each ? name + " = 1" : each);
    }
    for (const std::string& each : separated.limits) {
        question.limits.push_back(ode::parse_limit(question.system, each));
    }
    return ode::proved_connection(question);
}

}  // namespace libration::tests
