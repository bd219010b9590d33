// What becomes of the extended resummation when T* is not exact? [paper fig:period]
#include "folded.hpp"
#include "numerical_points.hpp"
#include "periodic_rows.hpp"
#include "run/parallel.hpp"

namespace libration::studies {

namespace period_effect_study {
namespace {

const std::vector<column>& columns() {
    static const std::vector<column> all{
        {"energy", "E, in units of m g l"},
        {"period_by", "way to T*: agm (exact) | series:N (Kold) | resummed:N (Knew); empty for rk4"},
        {"order", "N, last index of the resummed series; empty for rk4"},
        {"period", "T that follows, dimensionless; empty for rk4"},
        {"period_error", "|period - T|; empty for rk4"},
        {"time", "dimensionless time since the bottom, where omega = sqrt(2E)"},
        {"theta", "angle, radians"},
        {"error", "|theta - exact|, radians"},
        {"log10_error", "log10 of error"},
        {"periods", "time over the exact period T, 12 digits"},
        {"gap", "2 - E"},
        {"method", "resummed | rk4"},
    };
    return all;
}

struct rows_of_energy {
    table_rows folded_rows;
    table_rows numerical;
};

rows_of_energy rows_at(const sweep_energy& at, const study_request& request, const scalar_spec& scalar) {
    const motion m = motion::of_energy_from(at.value, exact{});
    const auto add = [&](table_rows& rows, const std::vector<std::string>& way, const std::string& method,
                         const std::vector<time_cells>& when, const std::vector<judged>& values, long digits) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            rows.push_back({at.energy, way[0], way[1], way[2], way[3], when[i].time,
                            to_decimal(values[i].theta, digits), to_decimal(values[i].error, digits),
                            log10_text(values[i].error), when[i].periods, at.gap, method});
        }
    };
    rows_of_energy result;
    const auto when = cells_of(m, request.times, scalar.digits);
    for (const sweep_period_rule& by : request.period_rules) {
        const judged period = period_by(m, by.rule, scalar);
        for (const int order : request.orders) {
            add(result.folded_rows,
                {by.text, std::to_string(order), to_decimal(period.theta, scalar.digits),
                 to_decimal(period.error, scalar.digits)},
                "resummed", when, folded(m, request.times, order, by.rule, scalar), scalar.digits);
        }
    }
    const auto some = some_of(request.times);
    add(result.numerical, {"", "", "", ""}, "rk4", cells_of(m, some, 17), marched(m, some, request.step), 17);
    return result;
}

std::vector<study_table> run(const study_request& request) {
    require_period(request.energies);
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:40"));
    progress shown("period_effect, energies", request.energies.size(), request.shown);
    const auto parts = parallel_map(request.energies.size(), request.jobs, shown,
                                    [&](std::size_t i) { return rows_at(request.energies[i], request, scalar); });
    std::vector<study_table> tables{{"", scalar, {columns(), {}}},
                                    {"numerical", read_scalar("double"), {columns(), {}}}};
    for (const rows_of_energy& part : parts) {
        const auto append = [](table& to, const table_rows& rows) {
            to.rows.insert(to.rows.end(), rows.begin(), rows.end());
        };
        append(tables[0].data, part.folded_rows);
        append(tables[1].data, part.numerical);
    }
    return tables;
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
            "of itself and the error after three periods is 0.27 radians below and 0.14 above the separatrix, where "
            "the resummation with the exact T* is never off by more than 0.0015.",
        .parameters = {{"--energies", "1.999800005,2.000200005",
                        "energies E, in m g l; the usual two are omega0 = 1.9999 and 2.0001 at the bottom"},
                       {"--gaps", "", "energies as 2 - E"},
                       {"--orders", "20", "N, last index of the resummed series"},
                       {"--times", "0:3T:401",
                        "times since the bottom: multiples of the exact T, or dimensionless numbers"},
                       {"--period-by", "agm,series:100,resummed:1,resummed:10", "ways to T*"},
                       {"--step", "1e-5", "step of the Runge-Kutta method, dimensionless"},
                       {"--scalar", "mpfr:40", "arithmetic of the resummation; the numerical solution is in double"}},
        .quick = {{"--energies", "1.9998,2.0002", ""}, {"--times", "0:T:9", ""}, {"--step", "1e-3", ""}},
        .seconds = 1,
        .run = run};
    return result;
}

}  // namespace libration::studies
