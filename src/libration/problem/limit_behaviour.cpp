#include "libration/problem/limit_behaviour.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "../query/connection/linear_decay.hpp"
#include "../query/connection/power_equation.hpp"
#include "known/far_start.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/equation/text/limit_condition.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/expansion/tape.hpp"
#include "libration/scalar/error.hpp"

namespace libration {

namespace {

constexpr long digits_beyond_twice = 20;
constexpr double first_far_time = 8;
constexpr double latest_far_time = 1000;
constexpr double latest_power_time = 1000;

[[noreturn]] void refuse_behaviour(const std::string& reason) {
    throw error(error_kind::argument, error_subject::problem, "", reason);
}

mpfr number_in(const std::string& decimal) {
    return ode::constant_value<mpfr>::of(ode::parse_constant(decimal).constant());
}

// What the proof yields besides the unknowns, by kind, in order.
std::vector<std::pair<std::string, mpfr>> numbers_of_kind(const answer& found, const std::string& kind) {
    std::vector<std::pair<std::string, mpfr>> result;
    for (const auto& row : found.rows) {
        if (row[2].text == kind && !row[1].text.empty()) {
            result.emplace_back(row[0].text, number_in(row[1].text));
        }
    }
    return result;
}

mpfr slowest_rate(const answer& found, long digits) {
    const auto rates = numbers_of_kind(found, "rate");
    if (rates.empty()) {
        refuse_behaviour("has no proved rate of exponential decay, which an asymptotic approximant contains");
    }
    const mpfr& rate = rates.front().second;
    if (rates.size() > 1 && abs(mpfr(rates[1].second - rate)) <= rate * far::ten_to(-digits)) {
        refuse_behaviour(
            "has two equal slowest rates, as an oscillation has, for which a series of powers of one exponential is "
            "not available");
    }
    return rate;
}

const ode::limit_condition& leading_condition(const std::vector<ode::limit_condition>& limits) {
    for (const int derivative : {0, 1}) {
        for (const ode::limit_condition& each : limits) {
            if (each.of.derivative() == derivative) {
                return each;
            }
        }
    }
    refuse_behaviour("has no condition y(inf) or y'(inf): add one");
}

// y - L t where y' is L to these digits; for L = 0 where y is 0.
far_behaviour along_a_line(const ode::equation_system& given, const std::string& name, const mpfr& slope, long digits) {
    const ode::explicit_system system(given);
    if (system.unknowns().front().name != name) {
        refuse_behaviour(
            "has a condition at a derivative of another unknown than the first one: write its equation first");
    }
    const mpfr point = ode::constant_value<mpfr>::of(system.point());
    const auto is_far = [&](const std::vector<mpfr>& state) {
        const mpfr off = slope == 0 ? state[0] : mpfr(state[1] - slope);
        return abs(off) <= far::ten_to(-digits - 4);
    };
    mpfr distance(first_far_time);
    auto state = far::state_at(given, mpfr(point + distance));
    while (!is_far(state)) {
        distance = distance * 5 / 4;
        if (distance > latest_far_time) {
            refuse_behaviour("approaches its limit so slowly that no asymptote is seen");
        }
        state = far::state_at(given, mpfr(point + distance));
    }
    const mpfr offset = slope == 0 ? mpfr(0) : mpfr(state[0] - slope * distance);
    return {"", name, far_form::power, system, far::polynomial({offset, slope}), mpfr(0), distance, {{"B", offset}}};
}

// y ~ t^-m. `end`: where t^-m has fallen by as many digits, at most latest_power_time.
far_behaviour along_a_power(const ode::equation_system& given, const ode::power_equation& of, long digits) {
    const mpfr decay = from_rational<mpfr>(of.decay);
    const mpfr end = std::min(mpfr(pow(mpfr(10), mpfr(mpfr(digits) / decay))), mpfr(latest_power_time));
    return {"",    of.name, far_form::algebraic, ode::explicit_system(given), far::polynomial({mpfr(0)}),
            decay, end,     {{"m", decay}}};
}

// By the equation with the values found.
far_behaviour form_of_approach(const ode::connection_question& question, const answer& found) {
    const ode::equation_system& given = question.system;
    const ode::limit_condition& condition = leading_condition(question.limits);
    const std::string name = condition.of.name();
    if (const auto power = ode::power_equation_in(question)) {
        return along_a_power(given, *power, question.digits);
    }
    if (ode::is_linear_decay(question)) {
        return along_a_line(given, name, mpfr(0), question.digits);
    }
    mpfr limit = ode::constant_value<mpfr>::of(ode::number_with_values(condition.value, given));
    if (condition.of.derivative() == 1 && limit != 0) {
        return along_a_line(given, name, limit, question.digits);
    }
    if (condition.of.derivative() == 1) {
        const auto free = numbers_of_kind(found, "limit");
        const auto own = std::ranges::find(free, name + "(inf)", &std::pair<std::string, mpfr>::first);
        if (own == free.end()) {
            refuse_behaviour("does not determine the limit of " + name + ": add " + name + "(inf)");
        }
        limit = own->second;
    }
    const mpfr rate = slowest_rate(found, question.digits);
    const mpfr end = mpfr(log(mpfr(10))) * question.digits / rate;
    return {"",   name, far_form::exponential, ode::explicit_system(given), far::polynomial({limit}),
            rate, end,  {{"rate", rate}}};
}

}  // namespace

far_behaviour behaviour_at_infinity(const limit_problem& of, long digits) {
    const precision_scope scope(2 * digits + 2 * digits_beyond_twice);
    ode::equation_system given = of.of.equations();
    std::vector<ode::limit_condition> limits;
    for (const std::string& each : of.conditions) {
        limits.push_back(ode::parse_limit(given, each));
        if (limits.back().direction < 0) {
            refuse_behaviour("has a condition at -inf, where an asymptotic approximant has no series");
        }
    }
    // Along a layer an error of the initial value grows like t, otherwise at most as fast as the solution approaches.
    const bool of_layer = std::ranges::all_of(limits, [](const ode::limit_condition& each) {
        return each.of.derivative() == 1 && each.value.fraction() != rational(0);
    });
    const answer found =
        limit_solution(of).unknowns(proved_digits((of_layer ? digits : 2 * digits) + digits_beyond_twice));
    for (const auto& row : found.rows) {
        if (row[2].text == "unknown") {
            given = ode::changed(given, row[0].text + " = " + row[1].text);
        }
    }
    far_behaviour result = form_of_approach({given, of.unknowns, limits, {}, digits}, found);
    result.root = ode::tape::about_start(result.system).root();
    if (result.root > 1 && result.form != far_form::algebraic) {
        refuse_behaviour(
            "has a series in powers of a root of the time, of which approximants of this form are not made");
    }
    return result;
}

}  // namespace libration
