// How does the series about the bottom of the trajectory behave over one period? [paper fig:series]
#include <algorithm>

#include "libration/pendulum/bottom_series.hpp"
#include "shared/agreed_numbers.hpp"
#include "shared/radius_on_interval.hpp"
#include "shared/sweep_columns.hpp"
#include "shared/sweep_plan.hpp"
#include "shared/unknown_on_interval.hpp"

namespace libration::studies {

namespace divergence_study {

namespace of_pendulum {

using namespace pendulum;

namespace {

// A partial sum at a time.
struct sum_row {
    const sweep_energy& at;
    long digits;
    int order;
    mpfr time, period, theta, truth, error;
};

const column_list<sum_row>& columns() {
    using row = sum_row;
    const auto value = [](mpfr row::*which) {
        return [which](const row& r) { return decimal_cell(r.*which, r.digits); };
    };
    static const auto all = with_typed_energy<row>({
        energy_column<row>(),
        {"order", "N, last power of the series about the bottom", [](const row& r) { return r.order; }},
        {"time", "dimensionless time since the bottom", value(&row::time)},
        {"periods", "time over the period T",
         [](const row& r) { return decimal_cell(mpfr(r.time / r.period), r.digits); }},
        {"theta", "partial sum, radians", value(&row::theta)},
        {"theta_exact", "radians, unwrapped", value(&row::truth)},
        {"error", "|theta - theta_exact|, radians", value(&row::error)},
        {"log10_error", "log10 of error; -inf where it is 0", [](const row& r) { return log10_cell(r.error); }},
        {"log10_abs_theta", "log10 of |theta|; -inf where it is 0", [](const row& r) { return log10_cell(r.theta); }},
        gap_column<row>(),
    });
    return all;
}

struct radius_row {
    const sweep_energy& at;
    long digits;
    mpfr effective_period, radius, period;
};

const column_list<radius_row>& radius_columns() {
    using row = radius_row;
    const auto value = [](mpfr row::*which) {
        return [which](const row& r) { return decimal_cell(r.*which, r.digits); };
    };
    static const auto all = with_typed_energy<row>({
        energy_column<row>(),
        {"tstar", "T*, dimensionless time from the bottom to the top", value(&row::effective_period)},
        {"radius", "R, radius of convergence about the bottom, dimensionless time", value(&row::radius)},
        {"period", "T, dimensionless time", value(&row::period)},
        {"radius_over_tstar", "R/T*: below 1 for 1 < E < 4 only",
         [](const row& r) { return decimal_cell(mpfr(r.radius / r.effective_period), r.digits); }},
        gap_column<row>(),
    });
    return all;
}

// Both tables of one energy.
std::vector<table> tables_at(const sweep_energy& at, const std::vector<int>& orders, const std::vector<exact>& instants,
                             long digits) {
    const int highest = *std::max_element(orders.begin(), orders.end());
    const precision_scope scope(digits + bottom_digits_below(at.value, highest, instants));
    const bottom_series<mpfr> bottom(at.value, highest);
    std::vector<mpfr> times;
    std::vector<mpfr> truth;
    times.reserve(instants.size());
    truth.reserve(instants.size());
    for (const exact& time : instants) {
        times.push_back(bottom.dimensionless(time));
        truth.push_back(bottom.theta(time));
    }
    std::vector<sum_row> sums;
    sums.reserve(times.size() * orders.size());
    for (const int order : orders) {
        for (std::size_t i = 0; i < times.size(); ++i) {
            const mpfr theta = bottom.partial_sum(order, times[i]);
            // At the bottom itself the sum is exact, and its error 0.
            const mpfr error = instants[i].is_zero() ? mpfr(0) : mpfr(abs(theta - truth[i]));
            sums.push_back({at, digits, order, times[i], bottom.period(), theta, truth[i], error});
        }
    }
    const radius_row radius{at, digits, bottom.effective_period(), bottom.radius(), bottom.period()};
    return {make_table(columns(), sums), make_table(radius_columns(), std::vector<radius_row>{radius})};
}

study_plan plan(const study_request& request) {
    const auto sweep = sweep_of(request);
    const auto orders = request.orders();
    const auto digits = request.digits();
    const scalar_spec scalar{scalar_kind::arbitrary, *std::max_element(digits.begin(), digits.end())};
    return plan_by_energy({head_of("", scalar, columns()), head_of("radius", scalar, radius_columns())}, sweep,
                          [sweep, orders, digits = scalar.digits](const sweep_energy& at) {
                              return tables_at(at, orders, sweep->times, digits);
                          });
}

}  // namespace
}  // namespace of_pendulum

namespace of_equation {

namespace {

struct sum_row {
    int order;
    const exact& time;
    mpfr value, solution, error;
    long digits;
    std::string unknown;
};

const column_list<sum_row>& columns() {
    using row = sum_row;
    const auto number = [](mpfr row::*which) {
        return [which](const row& r) { return decimal_cell(r.*which, r.digits); };
    };
    static const column_list<row> all{
        {"order", "N, last power of the series about the start", [](const row& r) { return r.order; }},
        {"time", "of the problem, in the unit of its variable",
         [](const row& r) { return number_cell(decimal_of(r.time, 50)); }},
        {"value", "partial sum, in the unit of the unknown", number(&row::value)},
        {"solution", "the unknown itself", number(&row::solution)},
        {"error", "|value - solution|", number(&row::error)},
        {"log10_error", "log10 of error; -inf where it is 0", [](const row& r) { return log10_cell(r.error); }},
        {"log10_abs_value", "log10 of |value|; -inf where it is 0", [](const row& r) { return log10_cell(r.value); }},
        unknown_column<row>(),
    };
    return all;
}

// Partial sum, solution and error, one after the other, at all times of all unknowns.
std::vector<mpfr> sums_of(const interval_run& run, const std::vector<int>& unknowns, int order) {
    std::vector<mpfr> all;
    for (const int unknown : unknowns) {
        const auto at = static_cast<std::size_t>(unknown);
        for (std::size_t i = 0; i < run.truth.times.size(); ++i) {
            const mpfr sum = run.unknowns[at].partial_sum(order, i);
            const bool at_start = run.truth.times[i] == run.truth.start;
            all.push_back(sum);
            all.push_back(run.truth.values[at][i]);
            all.push_back(at_start ? mpfr(0) : mpfr(abs(mpfr(sum - run.truth.values[at][i]))));
        }
    }
    return all;
}

struct question {
    shared_equation_sweep sweep;
    std::vector<ode::number> times;
    std::vector<exact> typed_times;
    long digits;
};

table rows_at(const question& asked, std::size_t i, const std::vector<int>& orders) {
    const auto system = asked.sweep->system(i);
    interval_runs runs(system, asked.times, *std::ranges::max_element(orders));
    std::vector<sum_row> rows;
    for (const int order : orders) {
        const auto found = agreed_numbers(asked.digits, [&](long guard) {
            const precision_scope scope(asked.digits + guard);
            return sums_of(runs.at(asked.digits + guard), asked.sweep->unknowns(), order);
        });
        std::size_t next = 0;
        for (const int unknown : asked.sweep->unknowns()) {
            for (const exact& time : asked.typed_times) {
                rows.push_back({order, time, found[next].value, found[next + 1].value, found[next + 2].value,
                                asked.digits, asked.sweep->name_of(unknown)});
                next += 3;
            }
        }
    }
    const precision_scope scope(asked.digits + 20);
    return make_table(columns(), rows);
}

study_plan plan(const study_request& request) {
    const auto digits = request.digits();
    const question asked{equation_sweep_of(request), times_of(request, 2), request.values.of("time"),
                         *std::ranges::max_element(digits)};
    const scalar_spec scalar{scalar_kind::arbitrary, asked.digits};
    return with_radii(plan_by_numbers({head_of(*asked.sweep, "", scalar, columns())}, asked.sweep, "order",
                                      orders_from(request, 0, ""),
                                      [asked](std::size_t i, const std::vector<int>& chosen) {
                                          return std::vector<table>{rows_at(asked, i, chosen)};
                                      }),
                      asked.sweep, asked.times);
}

}  // namespace
}  // namespace of_equation
}  // namespace divergence_study

const study& divergence() {
    using namespace divergence_study;
    static const study result{
        .name = "divergence",
        .title = "Divergence of the series about the bottom",
        .label = "fig:series",
        .question = "How far does the series about the bottom of the trajectory reach before it diverges?",
        .reading =
            "Above: the exact angle (circles) over one period from the bottom and the partial sums of its Taylor "
            "series there (dashed); below: their error. The vertical lines mark the radius of convergence R and the "
            "effective period T*, when the pendulum is at the top. Left of R more terms are better, right of it they "
            "are worse, and at these energies R is less than T*: no number of terms reaches the top. Libration leaves "
            "the bottom with omega < 0, as the motion released at +theta_max does, rotation counterclockwise at theta "
            "= 2 pi. R is less than T* only for 1 < E < 4, not for all E < 2 as the paper says: at E = 1 and 4 they "
            "are equal.",
        .of = &pendulum_problem(),
        .parameters = {{"--energies", "1.71,2.02", "energies E, in m g l"},
                       {"--gaps", "", "energies as 2 - E"},
                       {"--orders", "10,100,1000", "N, last power of the series"},
                       {"--times", "0:T:401", "dimensionless times since the bottom"},
                       {"--digits", "40", "digits of every number; the largest of a list"}},
        .quick = {{"--energies", "1.71,2.02", ""}, {"--orders", "10,40", ""}, {"--times", "0:T:9", ""}},
        .seconds = 2.5,
        .excluded = no_answer_at_limits("the series is the constant 0", "the period is infinite"),
        .plan = of_pendulum::plan,
        .any_equation = equation_form{
            .plan = of_equation::plan,
            .title = "Partial sums beyond the circle of convergence",
            .question = "What becomes of the partial sums of the series about the start along the solution?",
            .reading =
                "The solution (black) and partial sums of growing order. Up to the radius of convergence, the dotted "
                "line, more terms follow the solution further; beyond it they leave it, the sooner and the steeper the "
                "more there are. The solution itself may go on smoothly there: what bounds the series is a singularity "
                "at a complex time.",
            .parameters = {required_times("times at which the sums are taken"),
                           {"--orders", "5,10,20,40,80", "N, last power of the series"},
                           {"--digits", "20", "digits of every number; the largest of a list"}},
            .example = {"blasius", {}},
            .example_words = {{"--times", "0:6:61"}},
            .quick = {{"--times", "0:5:6"}, {"--orders", "5,20"}},
            .seconds = 1}};
    return result;
}

}  // namespace libration::studies
