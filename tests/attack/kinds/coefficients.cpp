// Taylor coefficients, also of long series.
#include <fmt/core.h>

#include "attack/question.hpp"
#include "libration/query/problem_coefficients.hpp"
#include "libration/scalar/error.hpp"

namespace libration::attack {

namespace {

struct asked_series {
    solved_problem problem;
    std::vector<std::function<mpfr(long)>> coefficients;
};

// x = 2 u + v, y = u - v, typed with fractions.
asked_series sums(const component& u, const component& v) {
    asked_series made;
    const std::string f = u.slope("((x+y)/3)", "t");
    const std::string g = v.slope("((x-2*y)/3)", "t");
    made.problem.text = fmt::format("x' = 2*({0})+{1}; y' = {0}-({1}); x(0) = 2*({2})+{3}; y(0) = {2}-({3})", f, g,
                                    u.start.text, v.start.text);
    made.problem.columns = {"x", "y"};
    made.coefficients = {[=](long n) { return mpfr(2 * u.coefficient(n) + v.coefficient(n)); },
                         [=](long n) { return mpfr(u.coefficient(n) - v.coefficient(n)); }};
    return made;
}

asked_series any_series(choices& next) {
    const component u = with_coefficients(next);
    if (next.below(3) == 0) {
        return sums(u, with_coefficients(next));
    }
    if (next.one_in(2)) {
        return {alone(u), {u.coefficient}};
    }
    const component v = with_coefficients(next);
    return {beside({u, v}), {u.coefficient, v.coefficient}};
}

}  // namespace

// A list of coefficients counts as one statement per unknown.
outcome ask_coefficient(choices& next) {
    const asked_series asked = any_series(next);
    const bool is_long = next.one_in(12);
    const long order = is_long ? next.between(100, 260) : next.between(4, 40);
    const long digits = is_long ? next.between(100, 220) : any_digits(next);
    outcome result;
    result.command = announce(fmt::format("libration coefficients --problem \"{}\" --order {} --scalar ball:{}",
                                          asked.problem.text, order, digits));
    try {
        const ode::coefficient_request request{system_of(asked.problem.text), 0, order};
        const auto list = ode::proved_coefficients(request, digits).values;
        const std::size_t unknowns = asked.problem.columns.size();
        for (std::size_t i = 0; i < unknowns; ++i) {
            verdict all = verdict::right;
            std::string message;
            for (long n = 0; n <= order && all == verdict::right; ++n) {
                const proved_decimal& printed = list[static_cast<std::size_t>(n) * unknowns + i];
                all = judged(printed, digits, [&] { return asked.coefficients[i](n); });
                message = fmt::format("coefficient {} of {} = {} +- {}", n, asked.problem.columns[i], printed.text,
                                      printed.uncertainty);
            }
            result.add(all, message);
        }
    } catch (const error& refusal) {
        result.add(verdict::refused, refusal.what());
    }
    return result;
}

}  // namespace libration::attack
