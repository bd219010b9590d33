// What becomes of the partial sums of any equation beyond the circle of convergence?
#include <algorithm>
#include <map>
#include <memory>

#include "agreed_numbers.hpp"
#include "radius_on_interval.hpp"
#include "unknown_on_interval.hpp"

namespace libration::studies::of_equation {

namespace divergence_of_equation {

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

// The solution and the series of one precision.
struct one_run {
    solution_on_interval truth;
    series_about_start<mpfr> series;
    std::vector<unknown_on_interval<mpfr>> unknowns;

    one_run(const ode::explicit_system& system, const std::vector<ode::number>& times, int order)
        : truth(solve_on(system, times)), series(system, order) {
        for (int i = 0; i < static_cast<int>(system.unknowns().size()); ++i) {
            unknowns.emplace_back(series, truth, i);
        }
    }
};

// Partial sum, solution and error, one after the other, at all times of all unknowns.
std::vector<mpfr> sums_of(const one_run& run, const std::vector<int>& unknowns, int order) {
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
    std::map<long, std::unique_ptr<one_run>> runs;
    const int highest = *std::ranges::max_element(orders);
    std::vector<sum_row> rows;
    for (const int order : orders) {
        const auto found = agreed_numbers(asked.digits, [&](long guard) {
            const precision_scope scope(asked.digits + guard);
            auto& run = runs[guard];
            if (!run) {
                run = std::make_unique<one_run>(system, asked.times, highest);
            }
            return sums_of(*run, asked.sweep->unknowns(), order);
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

study_plan plan(const shared_problem& problem, const study_request& request) {
    const auto digits = request.digits();
    const question asked{sweep_of(problem, request), times_of(request, 2), request.values.of("time"),
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
}  // namespace divergence_of_equation

const equation_study& divergence() {
    using namespace divergence_of_equation;
    static const equation_study result{
        .name = "divergence",
        .title = "Partial sums beyond the circle of convergence",
        .question = "What becomes of the partial sums of the series about the start along the solution?",
        .reading =
            "The solution (black) and partial sums of growing order. Up to the radius of convergence, the dotted line, "
            "more terms follow the solution further; beyond it they leave it, the sooner and the steeper the more "
            "there are. The solution itself may go on smoothly there: what bounds the series is a singularity at a "
            "complex time.",
        .parameters = {{"--times", "", "times at which the sums are taken"},
                       {"--orders", "5,10,20,40,80", "N, last power of the series"},
                       {"--digits", "20", "digits of every number; of a list the largest"}},
        .example = {"blasius", {}},
        .example_words = {{"--times", "0:6:61"}},
        .quick = {{"--times", "0:5:6"}, {"--orders", "5,20"}},
        .seconds = 1,
        .plan = plan};
    return result;
}

}  // namespace libration::studies::of_equation
