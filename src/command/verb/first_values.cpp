#include "first_values.hpp"

#include <algorithm>

#include "libration/equation/text/parse.hpp"
#include "problem/swept_problem.hpp"
#include "text/input_error.hpp"

namespace libration {

std::vector<std::pair<std::string, std::string>> first_values(const first_guess& guess,
                                                              const std::optional<branch_values>& along) {
    std::vector<std::pair<std::string, std::string>> values;
    for (const std::string& each : guess) {
        values.emplace_back("--guess", each);
    }
    if (along) {
        values.emplace_back("--along", along->parameter + " = " + along->values.front());
    }
    return values;
}

void require_first_values(const problem_options& problem_of, const std::vector<std::string>& unknowns,
                          const first_guess& guess, const std::optional<branch_values>& along) {
    ode::equation_system typed;
    try {
        typed = problem(problem_named(*problem_of.problem()).text).equations();
    } catch (const error&) {
        return;  // problem_options::equations() reports it
    }
    const auto gives = [](const std::string& change, const std::string& name) {
        return without_blanks(change).starts_with(name + "=");
    };
    for (const std::string& name : unknowns) {
        const bool given =
            (along && along->parameter == name) ||
            std::ranges::any_of(guess, [&](const auto& each) { return gives(each, name); }) ||
            std::ranges::any_of(problem_of.changes(), [&](const auto& each) { return gives(each, name); });
        if (typed.is_open(name) && !given) {
            throw input_error("--unknown", name, "has no first value from which the search begins",
                              "add --guess " + name + "=1, or another number near the solution");
        }
    }
}

std::vector<std::string> add_first_values(const problem_options& problem_of, const std::vector<std::string>& unknowns,
                                          first_guess& guess) {
    std::vector<std::string> without_guess;
    const ode::equation_system typed = problem(problem_named(*problem_of.problem()).text).equations();
    const auto is_given = [&](const std::string& name) {
        const auto gives = [&](const std::string& each) { return without_blanks(each).starts_with(name + "="); };
        const auto paren = name.find('(');
        return std::ranges::any_of(guess, gives) || std::ranges::any_of(problem_of.changes(), gives) ||
               (paren == std::string::npos
                    ? !typed.is_open(name)
                    : std::ranges::any_of(typed.starts, [&](const ode::start& each) {
                          return ode::primed(each.of.name(), each.of.derivative()) == name.substr(0, paren);
                      }));
    };
    for (const std::string& name : unknowns) {
        if (!is_given(name)) {
            without_guess.push_back(name);
            guess.push_back(name + " = 1");
        }
    }
    return without_guess;
}

}  // namespace libration
