#include "libration/problem/known/pendulum.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/whole_number.hpp"

#include <algorithm>

namespace libration {

namespace {

constexpr long digits_of_endless_decimals = 50;

// A formula without T is accepted; a bare multiple of pi is an angle, which is not intended.
void require_number(const exact& number) {
    if (!number.is_number() || number.has_periods()) {
        require_plain_number(number);
    }
}

void require_energy(const exact& number, const exact& energy) {
    if (sign_of_exact(energy) < 0) {
        throw error(error_kind::argument, "value", "", "has '" + number.text + "', which makes the energy negative");
    }
}

std::string text_of(const exact& number) { return decimal_of(number, digits_of_endless_decimals); }

// A formula twice is one number, though no precision would show it.
bool comes_before(const exact& a, const exact& b) { return a.text != b.text && sign_of_exact(a - b) < 0; }

int order_from(std::string_view text) {
    constexpr int largest_order = 100'000;
    return static_cast<int>(read_whole_number(text, largest_order, "value"));
}

void require_time(const exact& time) {
    if (time.measure == unit::degree) {
        throw error(error_kind::argument, "value", "", "has the angle '" + time.text + "'");
    }
}

void require_point(const exact& point) {
    require_plain_number(point);
    if (point.coefficient < 0 || point.coefficient > 1) {
        throw error(error_kind::argument, "value", "", "has '" + point.text + "', which is not between 0 and 1");
    }
}

axis energy_axis() {
    return {.name = "energy",
            .option = "--energies",
            .help = "energies",
            .unit = "m g l",
            .form = axis_form::numbers,
            .remedy = "write energies such as 0.5,1.71,2.02 or 0.1:1.9:19",
            .check = [](const exact& e) { energy_from(e); },
            .coordinate = "energy"};
}

axis gap_axis() {
    return {.name = "gap",
            .option = "--gaps",
            .help = "energies as gaps 2 - E",
            .unit = "m g l",
            .form = axis_form::numbers,
            .remedy = "write gaps 2 - E such as 1e-3,-1e-3 or 1e-1:1e-12:12log",
            .check = [](const exact& gap) { energy_from_gap(gap); },
            .coordinate = "energy",
            .to_coordinate = [](const exact& gap) { return exactly(2) - gap; }};
}

axis time_axis() {
    return {.name = "time",
            .option = "--times",
            .help = "times",
            .forms = "LIST, a:b:count or a:b:COUNTlog, multiples of T allowed",
            .unit = "sqrt(l/g)",
            .form = axis_form::numbers,
            .remedy = "write times such as 0,1.5,T/4 or a range 0:2T:401",
            .check = require_time,
            .coordinate = "time"};
}

axis point_axis() {
    return {.name = "point",
            .option = "--points",
            .help = "expansion points as fractions of T*, 0 the top, 1 the bottom",
            .unit = "T*",
            .form = axis_form::numbers,
            .remedy = "write fractions of T* such as 0,1/4,1/2,1 or 0:1:21",
            .check = require_point,
            .coordinate = "point"};
}

axis periods_axis() {
    return {.name = "periods",
            .option = "--periods",
            .help = "whole numbers of periods",
            .unit = "T",
            .form = axis_form::whole,
            .remedy = "write whole numbers such as 1,1e3,1e6",
            .coordinate = "periods"};
}

axis period_by_axis() {
    return {.name = "period_by",
            .option = "--period-by",
            .help = "methods for T*",
            .forms = "LIST of agm, series:N (Kold) or resummed:N (Knew)",
            .form = axis_form::words,
            .remedy = "write methods for T* such as agm,series:100,resummed:10",
            .check = [](const exact& words) { read_period_rule(words.text); },
            .coordinate = "period_by"};
}

}  // namespace

sweep_energy energy_from(const exact& energy) {
    require_number(energy);
    require_energy(energy, energy);
    return {text_of(energy), text_of(exactly(2) - energy), energy, energy.text, ""};
}

sweep_energy energy_from_gap(const exact& gap) {
    require_number(gap);
    const exact energy = exactly(2) - gap;
    require_energy(gap, energy);
    return {text_of(energy), text_of(gap), energy, "", gap.text};
}

sweep_period_rule read_period_rule(std::string_view text) {
    if (text == "agm") {
        return {{pendulum::period_method::agm, 0}, std::string(text)};
    }
    const auto colon = text.find(':');
    const std::string_view method = text.substr(0, colon);
    if (colon == std::string_view::npos || (method != "series" && method != "resummed")) {
        throw error(error_kind::argument, "value", "",
                    "has '" + std::string(text) + "', which is not agm, series:N or resummed:N");
    }
    const auto arc = method == "series" ? pendulum::period_method::series : pendulum::period_method::resummed;
    return {{arc, order_from(text.substr(colon + 1))}, std::string(text)};
}

const problem_family& pendulum_problem() {
    static const problem_family result{
        "pendulum", {energy_axis(), gap_axis(), time_axis(), point_axis(), periods_axis(), period_by_axis()}};
    return result;
}

pendulum_sweep::pendulum_sweep(const axis_values& values)
    : times(values.of("time")), points(values.of("point")), periods(values.whole("periods")) {
    const auto& by_energy = values.of("energy");
    const auto& by_gap = values.of("gap");
    energies.reserve(by_energy.size() + by_gap.size());
    std::transform(by_energy.begin(), by_energy.end(), std::back_inserter(energies), energy_from);
    std::transform(by_gap.begin(), by_gap.end(), std::back_inserter(energies), energy_from_gap);
    std::stable_sort(energies.begin(), energies.end(),
                     [](const sweep_energy& a, const sweep_energy& b) { return comes_before(a.value, b.value); });
    for (const exact& rule : values.of("period_by")) {
        period_rules.push_back(read_period_rule(rule.text));
    }
}

std::vector<without_answer> no_answer_at_limits(const std::string& at_rest, const std::string& critical) {
    std::vector<without_answer> excluded;
    if (!at_rest.empty()) {
        excluded.push_back({"energy", [](const exact& energy) { return sign_of_exact(energy) == 0; }, at_rest});
    }
    if (!critical.empty()) {
        excluded.push_back(
            {"energy", [](const exact& energy) { return sign_of_exact(energy - exactly(2)) == 0; }, critical});
    }
    return excluded;
}

}  // namespace libration
