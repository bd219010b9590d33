// Unknowns that algebraic equations determine from a component.
#include <fmt/core.h>

#include "attack/question.hpp"

namespace libration::attack {

outcome ask_algebraic(choices& next) {
    const component u = any_component(next);
    const constant k = any_constant(next);
    solved_problem problem = alone(u, "x");
    problem.columns.emplace_back("z");
    const auto with_slope = [&](const std::string& x, const std::string& equation) {
        return fmt::format("x' = {}; {}; x(0) = {}", u.slope(x, "t"), equation, u.start.text);
    };
    if (next.one_in(3)) {
        problem.text = with_slope("x", "0 = x^2 + " + k.text + " - z");
        problem.values.emplace_back([u, k](const mpfr& s) {
            const mpfr x = u.value(s);
            return mpfr(x * x + k.value());
        });
    } else {
        problem.values.emplace_back([u, k](const mpfr& s) { return mpfr(k.value() * u.value(s)); });
        const std::string scaled = "z - " + k.text + "*x";
        if (next.one_in(2)) {
            problem.text = with_slope("(z/" + k.text + ")", "0 = " + scaled);
        } else {  // a singular mass matrix
            const std::string slope = fmt::format("(1 + {})*({})", k.text, u.slope("x", "t"));
            problem.text = fmt::format("x' + z' = {0}; x' + z' = {0} + {1}; x(0) = {2}; z(0) = {3}*{2}", slope, scaled,
                                       u.start.text, k.text);
        }
    }
    return asked_values(problem, reached_time(problem, next), any_digits(next),
                        [](const std::string&) { return verdict::refused; });
}

}  // namespace libration::attack
