// Singular initial points, with the initial value that the equation determines and with one beside it.
#include <fmt/core.h>

#include "attack/question.hpp"
#include "libration/number/exact.hpp"
#include "libration/query/states.hpp"

namespace libration::attack {

namespace {

// The text has a place for the start that the equation determines; x is the first unknown.
struct singular_problem {
    std::string text;
    std::string start;
    function value;
};

singular_problem any_singular_start(choices& next) {
    const constant c = any_constant(next);
    const constant k = next.one_in(3) ? constant{"pi", pi_value} : any_constant(next);
    const constant r = simple_constant(next);
    switch (next.below(4)) {
        case 0:  // c sin(w t)/(w t), w^2 = k
            return {fmt::format("x'' = -2*x'/t - {}*x; x(0) = {}; x'(0) = {{}}", k.text, c.text), "0",
                    [c, k](const mpfr& t) {
                        const mpfr w = sqrt(k.value());
                        return mpfr(c.value() * sin(mpfr(w * t)) / (w * t));
                    }};
        case 1:
            return {fmt::format("x' = ({}-x)/({}*t); x(0) = {{}}", c.text, next.between(1, 5)), c.text,
                    [c](const mpfr&) { return c.value(); }};
        case 2:
            return {fmt::format("x' = ({}-x)/t + {}; x(0) = {{}}", c.text, k.text), c.text,
                    [c, k](const mpfr& t) { return mpfr(c.value() + k.value() * t / 2); }};
        default:  // x = c + k/t times the integral of s e^(r s) from 0 to t
            return {fmt::format("x' = ({}-x)/t + y; y' = {}*y; y(0) = {}; x(0) = {{}}", c.text, r.text, k.text), c.text,
                    [c, k, r](const mpfr& t) {
                        const mpfr rate = r.value();
                        const mpfr grown = exp(mpfr(rate * t));
                        return mpfr(c.value() + k.value() * (t * grown / rate - (grown - 1) / (rate * rate)) / t);
                    }};
    }
}

std::string unit_beside(choices& next) {
    const long n = next.between(1, 400);
    const std::string size = next.one_in(2) ? fmt::format("10^(-{})", n) : fmt::format("exp(-{})", n);
    return (next.one_in(2) ? "+" : "-") + size;
}

}  // namespace

outcome ask_singular_start(choices& next) {
    const singular_problem problem = any_singular_start(next);
    const bool exists = next.one_in(2);
    const std::string start = exists ? problem.start : problem.start + unit_beside(next);
    const std::string text = fmt::format(fmt::runtime(problem.text), start);
    const rational since = decimal_fraction(next.between(1, 2000), 3);
    const long digits = next.between(1, 40);
    const std::string time = since.str();
    return answered(fmt::format("libration reference --problem \"{}\" --time={} --digits {}", text, time, digits),
                    [&](outcome& result) {
                        const auto found =
                            ode::proved_part_of_trajectory(system_of(text), {time_number(time)}, digits,
                                                           [](const ball&, long) { require_time_left(); });
                        if (exists) {
                            add_first_value(
                                result, found, digits, [&] { return problem.value(real(since)); }, "x");
                        } else {
                            result.add(verdict::wrong, "there is no solution with these initial values");
                        }
                    });
}

}  // namespace libration::attack
