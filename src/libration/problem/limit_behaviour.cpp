#include "libration/problem/limit_behaviour.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "known/far_start.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/equation/text/limit_condition.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/scalar/error.hpp"

namespace libration {

namespace {

constexpr long digits_beyond_twice = 20;
constexpr double first_far_time = 8;
constexpr double latest_far_time = 1000;

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

// y - L t where y' is L to these digits.
far_behaviour along_a_line(const ode::equation_system& given, const std::string& name, const mpfr& slope, long digits) {
    const ode::explicit_system system(given);
    if (system.unknowns().front().name != name) {
        refuse_behaviour(
            "has a condition at a derivative of another unknown than the first one: write its equation first");
    }
    const mpfr point = ode::constant_value<mpfr>::of(system.point());
    mpfr distance(first_far_time);
    auto state = far::state_at(given, mpfr(point + distance));
    while (abs(mpfr(state[1] - slope)) > far::ten_to(-digits - 4)) {
        distance = distance * 5 / 4;
        if (distance > latest_far_time) {
            refuse_behaviour("approaches its limit so slowly that no asymptote is seen");
        }
        state = far::state_at(given, mpfr(point + distance));
    }
    const mpfr offset = state[0] - slope * distance;
    return {"", name, far_form::power, system, far::polynomial({offset, slope}), mpfr(0), distance, {{"B", offset}}};
}

}  // namespace

far_behaviour behaviour_at_infinity(const limit_problem& of, long digits) {
    ode::equation_system given = of.of.equations();
    std::vector<ode::limit_condition> limits;
    for (const std::string& each : of.conditions) {
        limits.push_back(ode::parse_limit(given, each));
        if (limits.back().direction < 0) {
            refuse_behaviour("has a condition at -inf, where an asymptotic approximant has no series");
        }
    }
    const answer found = limit_solution(of).unknowns(proved_digits(2 * digits + digits_beyond_twice));
    for (const auto& row : found.rows) {
        if (row[2].text == "unknown") {
            given = ode::changed(given, row[0].text + " = " + row[1].text);
        }
    }
    const ode::limit_condition& condition = leading_condition(limits);
    const std::string name = condition.of.name();
    mpfr limit = ode::constant_value<mpfr>::of(ode::number_with_values(condition.value, given));
    if (condition.of.derivative() == 1 && limit != 0) {
        return along_a_line(given, name, limit, digits);
    }
    if (condition.of.derivative() == 1) {
        const auto free = numbers_of_kind(found, "limit");
        const auto own = std::ranges::find(free, name + "(inf)", &std::pair<std::string, mpfr>::first);
        if (own == free.end()) {
            refuse_behaviour("does not determine the limit of " + name + ": add " + name + "(inf)");
        }
        limit = own->second;
    }
    const mpfr rate = slowest_rate(found, digits);
    const mpfr end = mpfr(log(mpfr(10))) * digits / rate;
    return {"",   name, far_form::exponential, ode::explicit_system(given), far::polynomial({limit}),
            rate, end,  {{"rate", rate}}};
}

}  // namespace libration
