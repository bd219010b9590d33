// Values at times, exact zeros, and times beyond the end of a solution.
#include <fmt/core.h>

#include <cmath>

#include "attack/facts.hpp"
#include "attack/question.hpp"
#include "libration/number/exact.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/error.hpp"

namespace libration::attack {

namespace {

std::string value_command(const std::string& text, const std::string& time, long digits, ode::integrator_choice by) {
    const char* const integrator = by == ode::integrator_choice::collocation  ? " --integrator collocation"
                                   : by == ode::integrator_choice::comparison ? " --integrator comparison"
                                                                              : "";
    return fmt::format("libration reference --problem \"{}\" --time={} --digits {}{}", text, time, digits, integrator);
}

}  // namespace

verdict judged_existence(const std::string& message, double from, double singular) {
    const auto facts = facts_of(message);
    if (!facts.exists_up_to || !std::isfinite(singular)) {
        return verdict::refused;
    }
    const double until = std::stod(*facts.exists_up_to);
    const double tolerance = 1e-9 * (std::abs(singular) + std::abs(from) + 1);
    const bool before = singular > from ? until <= singular + tolerance : until >= singular - tolerance;
    return before ? verdict::refused : verdict::wrong;
}

void add_number(outcome& to, const known_value& number, long digits, const truth& exact, const std::string& name) {
    if (number.decimal) {
        to.add(judged(*number.decimal, digits, exact),
               fmt::format("{} = {} +- {}", name, number.decimal->text, number.decimal->uncertainty));
    } else if (!number.bound.empty()) {
        to.add(judged_bounds("-" + number.bound, number.bound, exact), "|" + name + "| < " + number.bound);
    }
}

long any_digits(choices& next) {
    switch (next.below(20)) {
        case 0: return next.between(140, 230);
        case 1:
        case 2:
        case 3: return next.between(40, 100);
        default: return next.between(1, 40);
    }
}

outcome asked_values(const solved_problem& problem, const rational& since, long digits,
                     const std::function<verdict(const std::string&)>& refused, ode::integrator_choice integrator) {
    outcome result;
    const std::string time = problem.typed_time(since);
    result.command = announce(value_command(problem.text, time, digits, integrator));
    try {
        ode::proof_route route;
        route.integrator = integrator;
        const auto states = ode::proved_trajectory(
            system_of(problem.text), {time_number(time)}, digits, [](const ball&, long) { require_time_left(); },
            route);
        for (std::size_t i = 0; i < problem.columns.size(); ++i) {
            const truth exact = [&problem, &since, i] { return problem.values[i](real(since)); };
            const proved_decimal& printed = states.front()[i];
            result.add(judged(printed, digits, exact),
                       fmt::format("{} = {} +- {}", problem.columns[i], printed.text, printed.uncertainty));
        }
    } catch (const error& refusal) {
        const std::string message = refusal.what();
        result.add(refused(message), message);
    } catch (const no_answer& late) {
        result.add(verdict::undecided, late.what());
    }
    return result;
}

outcome asked_enclosures(const solved_problem& problem, const rational& since, long bits,
                         ode::integrator_choice integrator) {
    const std::string time = problem.typed_time(since);
    const long digits = decimal_digits(bits);
    return answered(value_command(problem.text, time, digits, integrator), [&](outcome& result) {
        ode::proof_route route;
        route.integrator = integrator;
        const precision_scope scope(digits);
        ode::proved_march march(
            system_of(problem.text), bits, [](const ball&, long) { require_time_left(); },
            ode::proved_march::usual_error_bits, route);
        const auto state = march.at(time_number(time));
        if (!state) {
            result.add(verdict::refused, "the solution is not enclosed at that time");
            return;
        }
        for (std::size_t i = 0; i < problem.columns.size(); ++i) {
            const truth exact = [&problem, &since, i] { return problem.values[i](real(since)); };
            const ball& found = (*state)[i];
            result.add(judged_ball(found, exact),
                       fmt::format("{} = {} +- {}", problem.columns[i], to_decimal(midpoint_of(found), digits),
                                   to_decimal(midpoint_of(radius_of(found)), 3)));
        }
    });
}

ode::number time_number(const std::string& typed) { return as_exact_real(read_exact(typed)); }

outcome ask_value(choices& next) {
    const solved_problem problem = any_problem(next);
    const rational since = reached_time(problem, next);
    const double singular = since < 0 ? -problem.backward : problem.forward;
    const double from = problem.origin.convert_to<double>();
    const long digits = any_digits(next);
    if (next.one_in(3)) {
        return asked_enclosures(problem, since, 4 * digits + next.between(20, 64), ode::integrator_choice::automatic);
    }
    return asked_values(problem, since, digits, [&](const std::string& message) {
        return problem.unit.empty() ? judged_existence(message, from, from + singular) : verdict::refused;
    });
}

// Unknowns that the equations keep at 0, together with others that move.
outcome ask_zero(choices& next) {
    const component u = any_component(next);
    const constant rate = any_constant(next);
    solved_problem problem = alone(u, "x");
    const std::string f = u.slope("x", "t");
    const auto other = fmt::format("{}*z*x-z^3", rate.text);
    switch (next.below(3)) {
        case 0: problem.text = fmt::format("x' = {}; z' = {}; x(0) = {}; z(0) = 0", f, other, u.start.text); break;
        case 1: problem.text = fmt::format("z' = {}; x' = {}+z; x(0) = {}; z(0) = 0", other, f, u.start.text); break;
        default:
            problem.text = fmt::format("x' = {}+z*w; z' = {}; w' = z-{}*w; x(0) = {}; z(0) = 0; w(0) = 0", f, other,
                                       rate.text, u.start.text);
            problem.columns.emplace_back("w");
            problem.values.emplace_back([](const mpfr&) { return mpfr(0); });
            break;
    }
    const bool first = problem.text.starts_with("z");
    const auto at = first ? problem.columns.begin() : problem.columns.begin() + 1;
    problem.values.insert(first ? problem.values.begin() : problem.values.begin() + 1,
                          [](const mpfr&) { return mpfr(0); });
    problem.columns.insert(at, "z");
    const rational since = reached_time(problem, next);
    return asked_values(problem, since, next.between(1, 40), [](const std::string&) { return verdict::refused; });
}

// Times after a singularity.
outcome ask_refusal(choices& next) {
    solved_problem problem = alone(next.one_in(2) ? pole(any_constant(next), any_constant(next))
                                                  : tangent(any_constant(next), any_constant(next)));
    if (next.one_in(2)) {
        problem = mixed(problem.parts.front(), any_component(next), next);
    }
    const rational since = decimal_fraction(integer(std::floor(problem.forward * 1000)) + next.between(1, 3000), 3);
    const double from = problem.origin.convert_to<double>();
    outcome result = asked_values(problem, since, next.between(1, 30), [&](const std::string& message) {
        return judged_existence(message, from, from + problem.forward);
    });
    // No value exists there on this solution: any printed value is false.
    const auto printed = result.counts[static_cast<std::size_t>(verdict::right)];
    for (long i = 0; i < printed; ++i) {
        result.add(verdict::wrong, "a value behind a singularity");
    }
    result.counts[static_cast<std::size_t>(verdict::right)] = 0;
    return result;
}

}  // namespace libration::attack
