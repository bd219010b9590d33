// How large is the error of T* from the two partial sums of K? [paper fig:perioderror]
#include <algorithm>

#include "../shared/sweep_columns.hpp"
#include "../shared/sweep_plan.hpp"
#include "libration/pendulum/period_error.hpp"

namespace libration::studies {

namespace period_error_study {

using namespace elliptic;
using namespace pendulum;

namespace {

constexpr long guard_digits = 15;

// One sum at one energy.
struct sum_row {
    const sweep_energy& at;
    int order;
    period_method method;
    const scalar_spec& scalar;
    mpfr tstar;
    mpfr error;
    mpfr bound;
};

const column_list<sum_row>& columns() {
    using row = sum_row;
    static const auto all = with_typed_energy<row>({
        energy_column<row>(),
        {"order", "N: the sum ends with k^(2N)", [](const row& r) { return r.order; }},
        {"method", "series (Kold) | resummed (Knew)", [](const row& r) { return name_of(r.method); }},
        {"error", "|T* by the sum - T*|, dimensionless time; both sums are below T*",
         [](const row& r) { return decimal_cell(r.error, r.scalar.digits); }},
        {"tstar", "T* by the sum, dimensionless time",
         [](const row& r) { return decimal_cell(r.tstar, r.scalar.digits); }},
        gap_column<row>(),
        {"bound", "proved bound of the error, dimensionless time",
         [](const row& r) { return decimal_cell(r.bound, 12); }},
        {"bound_over_error", "bound / error",
         [](const row& r) { return r.error == 0 ? number_cell("inf") : decimal_cell(mpfr(r.bound / r.error), 6); }},
        {"scalar", "arithmetic of the sum", [](const row& r) { return r.scalar.name(); }},
        {"log10_error", "log10 of error", [](const row& r) { return log10_cell(r.error); }},
        {"log10_bound", "log10 of bound", [](const row& r) { return log10_cell(r.bound); }},
        log10_gap_column<row>(),
    });
    return all;
}

// T* by the sum in the scalar, converted to mpfr.
mpfr sum_in(const scalar_spec& scalar, long guard, const motion& m, const period_rule& rule) {
    return with_scalar(scalar, guard,
                       [&]<class T>() { return widen(effective_period_by(rule, energy_level_of<T>(m))); });
}

table rows_at(const sweep_energy& at, const std::vector<int>& orders, const scalar_spec& scalar) {
    const motion m = motion::of_energy(at.value);
    const int highest = orders.empty() ? 0 : *std::max_element(orders.begin(), orders.end());
    const long guard = period_digits_below(m, highest) + guard_digits;
    const precision_scope scope(scalar.digits + guard);
    const energy_level<mpfr> o = energy_level_of<mpfr>(m);
    const mpfr truth = effective_period(o);
    std::vector<sum_row> rows;
    rows.reserve(orders.size() * 2);
    for (const int order : orders) {
        for (const auto method : {period_method::series, period_method::resummed}) {
            const mpfr value = sum_in(scalar, guard, m, {method, order});
            const mpfr error = abs(value - truth);
            rows.push_back({at, order, method, scalar, value, error, effective_period_bound({method, order}, o)});
        }
    }
    return make_table(columns(), rows);
}

study_plan plan(const study_request& request) {
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:40"));
    return plan_by_order({head_of("", scalar, columns())}, sweep_of(request), request.orders(),
                         [scalar](const sweep_energy& at, const std::vector<int>& orders) {
                             return std::vector<table>{rows_at(at, orders, scalar)};
                         });
}

}  // namespace
}  // namespace period_error_study

const study& period_error() {
    using namespace period_error_study;
    static const study result{
        .name = "period_error",
        .title = "Error of the period",
        .label = "fig:perioderror",
        .question = "How large is the error of T* by the series of K and by its resummation, at each energy and order?",
        .reading =
            "Dashed: T* from the series (Kold) cut after k^(2N); solid: from its resummation (Knew) with as many "
            "terms; crosses: the proved bounds of both, which are at most "
            "{{max bound_over_error of period_error to 3}} times the error and so lie on the curves. Left over the "
            "energy, right towards the separatrix, where rotation (circles) falls on "
            "libration. Both sums are too small at every order, and both lose their rate as E goes to 2: the error of "
            "the series then grows like the period itself, and that of the resummation settles at 1/(8N + 7), the "
            "algebraic tail of its brackets, which more terms reduce only in proportion.",
        .of = &pendulum_problem(),
        .parameters = {{"--energies", "1e-3,1e-2,0.05:1.95:39,1.99,2.01,2.02,2.05:2.95:19,3:8:26",
                        "energies E, in m g l"},
                       {"--gaps", "1e-2:1e-10:17log,-1e-2:-1e-10:17log", "energies as 2 - E"},
                       {"--orders", "1,5,10,20,50,100", "N: the sums end with k^(2N)"},
                       {"--scalar", "mpfr:40", "arithmetic of the sums"}},
        .quick = {{"--energies", "1.71,2.02", ""}, {"--orders", "1,10", ""}},
        .seconds = 0.4,
        .excluded = no_answer_at_limits("k = 0 and both sums are exact", "the period is infinite"),
        .plan = plan};
    return result;
}

}  // namespace libration::studies
