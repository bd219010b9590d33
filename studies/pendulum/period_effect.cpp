// How does an inexact T* affect the extended resummation? [paper fig:period]
#include "../shared/sweep_plan.hpp"
#include "folded.hpp"
#include "numerical_points.hpp"
#include "periodic_rows.hpp"

namespace libration::studies {

namespace period_effect_study {

using namespace pendulum;

namespace {

// A value of one curve at a time, with the T* used for folding.
struct effect_row {
    const sweep_energy& at;
    cell period_by, order, period, period_error;
    std::string_view method;
    time_cells when;
    value_with_error value;
    long digits;
};

const column_list<effect_row>& columns() {
    using row = effect_row;
    static const auto all = with_typed_energy<row>({
        energy_column<row>(),
        {"period_by", "way to T*: agm (exact) | series:N (Kold) | resummed:N (Knew); empty for rk4",
         [](const row& r) { return r.period_by; }},
        {"order", "N, last index of the resummed series; empty for rk4", [](const row& r) { return r.order; }},
        {"period", "T that follows, dimensionless; empty for rk4", [](const row& r) { return r.period; }},
        {"period_error", "|period - T|; empty for rk4", [](const row& r) { return r.period_error; }},
        {"time", "dimensionless time since the bottom, where omega = sqrt(2E)",
         [](const row& r) { return r.when.time; }},
        {"theta", "angle, radians", [](const row& r) { return decimal_cell(r.value.theta, r.digits); }},
        {"error", "|theta - exact|, radians", [](const row& r) { return decimal_cell(r.value.error, r.digits); }},
        {"log10_error", "log10 of error", [](const row& r) { return log10_cell(r.value.error); }},
        {"periods", "time over the exact period T, 12 digits", [](const row& r) { return r.when.periods; }},
        gap_column<row>(),
        {"method", "resummed | rk4", [](const row& r) { return r.method; }},
    });
    return all;
}

// The folded curves and the numerical one of one energy.
std::vector<table> tables_at(const sweep_energy& at, const pendulum_sweep& sweep, const study_request& request,
                             const scalar_spec& scalar) {
    const motion m = motion::of_energy_from(at.value, exact{});
    std::vector<effect_row> folded_rows;
    const auto when = cells_of(m, sweep.times, scalar.digits);
    for (const sweep_period_rule& by : sweep.period_rules) {
        const value_with_error period = period_by(m, by.rule, scalar);
        for (const int order : request.orders()) {
            const auto values = folded(m, sweep.times, order, by.rule, scalar);
            for (std::size_t i = 0; i < values.size(); ++i) {
                folded_rows.push_back({at, by.text, order, decimal_cell(period.theta, scalar.digits),
                                       decimal_cell(period.error, scalar.digits), "resummed", when[i], values[i],
                                       scalar.digits});
            }
        }
    }
    const auto some = some_of(sweep.times);
    const auto at_some = cells_of(m, some, 17);
    const auto values = marched(m, some, request.step());
    std::vector<effect_row> numerical;
    for (std::size_t i = 0; i < values.size(); ++i) {
        numerical.push_back({at, {}, {}, {}, {}, "rk4", at_some[i], values[i], 17});
    }
    return {make_table(columns(), folded_rows), make_table(columns(), numerical)};
}

study_plan plan(const study_request& request) {
    const auto sweep = sweep_of(request);
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:40"));
    return plan_by_energy(
        {head_of("", scalar, columns()), head_of("numerical", read_scalar("double"), columns())}, sweep,
        [sweep, request, scalar](const sweep_energy& at) { return tables_at(at, *sweep, request, scalar); });
}

}  // namespace
}  // namespace period_effect_study

const study& period_effect() {
    using namespace period_effect_study;
    static const study result{
        .name = "period_effect",
        .title = "What an inexact period does to the solution",
        .label = "fig:period",
        .question = "What becomes of the extended resummation when T* is not exact?",
        .reading =
            "Just below (left) and just above the separatrix, pushed from the bottom: the resummation extended with T* "
            "from (Kold) with 100 powers (long dashes), from (Knew) with 1 (short dashes) and with 10 (solid), and "
            "with the exact T* (thin grey); dots: the numerical solution. An inexact T* is wrong everywhere: in the "
            "interval of the resummation, in the mirrors and in the modulo, so that the motion gets out of step by the "
            "error of the period in every period. With (Kold) a third of the period is missing and the curve is "
            "another motion. With (Knew) and 10 powers the curve looks right, but the period is short by 2 thousandths "
            "of itself and the error after three periods is {{the error of period_effect where energy=1.999800005 "
            "period_by=resummed:10 periods=3 to 2}} radians below and {{the error of period_effect where "
            "energy=2.000200005 period_by=resummed:10 periods=3 to 2}} above the separatrix, where the resummation "
            "with the exact T* is off by {{max error of period_effect where period_by=agm to 2}} at most.",
        .of = &pendulum_problem(),
        .parameters = {{"--energies", "1.999800005,2.000200005",
                        "energies E, in m g l; the usual two are omega0 = 1.9999 and 2.0001 at the bottom"},
                       {"--gaps", "", "energies as 2 - E"},
                       {"--orders", "20", "N, last index of the resummed series"},
                       {"--times", "0:3T:401",
                        "times since the bottom: multiples of the exact T, or dimensionless numbers"},
                       {"--period-by", "agm,series:100,resummed:1,resummed:10", "methods for T*"},
                       {"--step", "1e-5", "step of the Runge-Kutta method, dimensionless"},
                       {"--scalar", "mpfr:40", "arithmetic of the resummation; the numerical solution is in double"}},
        .quick = {{"--energies", "1.9998,2.0002", ""}, {"--times", "0:T:9", ""}, {"--step", "1e-3", ""}},
        .seconds = 1,
        .excluded = without_period(),
        .plan = plan};
    return result;
}

}  // namespace libration::studies
