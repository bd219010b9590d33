// Factors that are multiplied by 0 and leave their domain: the solution ends there.
#include <fmt/core.h>

#include <array>
#include <cmath>

#include "attack/question.hpp"
#include "libration/number/exact.hpp"
#include "libration/query/states.hpp"
#include "libration/query/trajectory.hpp"

namespace libration::attack {

namespace {

// A factor of t that is analytic where its argument u, linear in t, is in (0, 1], and not at u = 0: bounded there or with
// a logarithm, or infinite like a power.
constexpr std::array bounded_forms{"log({})",       "sqrt({})",        "({})^(2/3)",      "({})^(5/4)",
                                   "acosh(1+({}))", "asin(1-({}))",    "acos(1-({}))",    "atanh(1-({}))",
                                   "log1p(({})-1)", "bessel_k(0, {})", "bessel_y(0, {})", "lambertw((({})-1)/e)",
                                   "log10({})"};
constexpr std::array infinite_forms{"1/({})",        "({})^(-1/2)", "1/sin({})", "tan(pi/2-({}))",
                                    "1/(exp({})-1)", "1/({})^2",    "({})^(-3)"};
// Functions of it with the same domain; of an infinite factor the last ones have an essential singularity, which no
// integration approaches in a reasonable time.
constexpr std::array outer_forms{"(2+({})^2)", "1/(2+({})^2)", "log(2+({})^2)", "sqrt(1+({})^2)", "(({})+cos(t))",
                                 "atan({})*t", "(t-3)*({})",   "sin({})",       "erf({})",        "(2+sin({}))^(1/3)"};
constexpr std::size_t forms_with_essential_singularity = 3;

template <std::size_t N>
std::string filled(const std::array<const char*, N>& forms, std::size_t among, const std::string& by, choices& next) {
    return fmt::format(fmt::runtime(forms[static_cast<std::size_t>(next.below(among))]), by);
}

std::string any_factor(const std::string& u, choices& next) {
    const bool infinite = next.one_in(3);
    std::string f = infinite ? filled(infinite_forms, infinite_forms.size(), u, next)
                             : filled(bounded_forms, bounded_forms.size(), u, next);
    for (auto depth = next.below(4); depth > 0; --depth) {
        f = filled(outer_forms, outer_forms.size() - (infinite ? forms_with_essential_singularity : 0), f, next);
    }
    return f;
}

// An equation of x whose solution is known as long as the factor f is defined; z is a zero.
struct zero_problem {
    std::string text;
    function value;
    bool cancels = false;  // two terms, which no method in double shows
};

zero_problem resting(const std::string& f, choices& next) {
    const constant c = next.one_in(3) ? constant_of(0L) : any_constant(next);
    const std::string away = fmt::format("(x-{})", c.text);
    const std::string start = fmt::format("; x(0) = {}", c.text);
    const function value = [c](const mpfr&) { return c.value(); };
    switch (next.below(6)) {
        case 0: return {fmt::format("x' = {}*({}){}", away, f, start), value};
        case 1: return {fmt::format("x' = ({})*sin({}){}", f, away, start), value};
        case 2: return {fmt::format("x' = {0}^2*(x+({1})){2}", away, f, start), value};
        case 3: return {fmt::format("x'' = x'*({}) + {}{}; x'(0) = 0", f, away, start), value};
        case 4: return {fmt::format("x' = y*({0}); y' = {1}*({0}){2}; y(0) = 0", f, away, start), value};
        default: return {fmt::format("0 = {}*({}){}", away, f, start), value};
    }
}

zero_problem moving(const std::string& f, choices& next) {
    const constant a = any_constant(next);
    const constant c = any_constant(next);
    const component u = growth(a, c);
    const std::string slope = u.slope("x", "t");
    const std::string start = fmt::format("; x(0) = {}", c.text);
    switch (next.below(7)) {
        case 0: return {fmt::format("x' = {} + 0*({}){}", slope, f, start), u.value};
        case 1: return {fmt::format("x' = {} + k*({}){}; k = 0", slope, f, start), u.value};
        case 2: return {fmt::format("x' = {} - ({})*z{}; z' = 0; z(0) = 0", slope, f, start), u.value};
        case 3: return {fmt::format("x' = {} + z; z' = z*({}){}; z(0) = 0", slope, f, start), u.value};
        case 4: return {fmt::format("x' = {0} + ({1}) - ({1}){2}", slope, f, start), u.value, true};
        case 5: return {fmt::format("x' = ({0})*(1 + k*({1})){2}; k = m - 1; m = 1", slope, f, start), u.value};
        default: return {fmt::format("x' = {0} + ({1})^k - 1{2}; k = 0", slope, f, start), u.value};
    }
}

// Whether x has a value there, in double.
void add_rounded(outcome& to, const std::string& text, const std::string& time, bool beyond) {
    const auto found = ode::part_of_march<double>(system_of(text), {time_number(time)});
    const bool stated = !found.states.front().front().empty() && std::isfinite(found.states.front().front().front());
    to.add(stated && beyond ? verdict::wrong : stated ? verdict::right : verdict::refused, "x in double");
}

}  // namespace

outcome ask_domain(choices& next) {
    const constant any = any_constant(next);
    const constant end = any.rough() > 0.05 ? any : constant_of(1L);  // of the domain, at time +-end
    const bool forwards = next.one_in(2);
    const std::string u = fmt::format("(1{}t/{})", forwards ? "-" : "+", end.text);
    const std::string f = any_factor(u, next);
    const zero_problem problem = next.one_in(2) ? resting(f, next) : moving(f, next);
    const bool beyond = next.one_in(2);
    const auto thousandths = static_cast<long>(std::floor(1000 * end.rough()));
    const rational away =
        decimal_fraction(beyond ? thousandths + next.between(2, 3000) : next.between(1, thousandths * 9 / 10), 3);
    const rational since = forwards ? away : rational(-away);
    const long digits = next.between(1, 30);
    const std::string time = since.str();
    const bool rounded = next.one_in(4) && !problem.cancels;
    const std::string command =
        fmt::format("libration {} --problem \"{}\" --time={} --digits {}",
                    rounded ? "trajectory --scalar double" : "reference", problem.text, time, digits);
    return answered(command, [&](outcome& result) {
        if (rounded) {
            add_rounded(result, problem.text, time, beyond);
            return;
        }
        const auto found = ode::proved_part_of_trajectory(system_of(problem.text), {time_number(time)}, digits,
                                                          [](const ball&, long) { require_time_left(); });
        const auto& state = found.states.front();
        if (found.missing) {
            result.add(judged_existence(found.missing->what(), 0, (forwards ? 1 : -1) * end.rough()),
                       found.missing->what());
        }
        if (state.empty()) {
            return;
        }
        if (beyond && (state.front().decimal || !state.front().bound.empty())) {
            result.add(verdict::wrong, "x has a value beyond the domain");
        } else {
            add_number(
                result, state.front(), digits, [&] { return problem.value(real(since)); }, "x");
        }
    });
}

}  // namespace libration::attack
