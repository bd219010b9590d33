// How does the angle of a pendulum pushed from the bottom depend on time and energy? [paper fig:surf]
#include <utility>

#include "folded.hpp"
#include "libration/pendulum/solution/critical_formula.hpp"
#include "libration/pendulum/solution/exact_solution.hpp"
#include "libration/pendulum/time/dimensionless_time.hpp"
#include "run/parallel.hpp"
#include "sweep/study.hpp"
#include "text/input_error.hpp"

namespace libration::studies {

namespace surface_study {
namespace {

const std::vector<column>& columns() {
    static const std::vector<column> all{
        {"energy", "E, in units of m g l"},
        {"time", "dimensionless time since the bottom, where omega = sqrt(2E)"},
        {"theta", "the exact angle, not reduced to a turn, radians"},
        {"regime", "libration | separatrix | rotation"},
        {"method", "resummed: (fullresummation) extended by (newseries) | critical: the closed solution at E = 2"},
        {"order", "N, last index of the resummed series; empty for critical"},
        {"period_by", "way to T*: agm | series:N (Kold) | resummed:N (Knew); empty for critical"},
        {"approximation", "the angle by the method, radians"},
        {"error", "|approximation - theta|, radians"},
        {"log10_error", "log10 of error"},
        {"gap", "2 - E"},
    };
    return all;
}

motion pushed(const sweep_energy& at) { return motion::of_energy_from(at.value, exact{}); }

// (critical) is exact: beyond the digits of the arithmetic it has no error.
std::vector<judged> by_critical_formula(const motion& m, const std::vector<exact>& times, const scalar_spec& scalar) {
    const precision_scope scope(scalar.digits + 2 * guard_digits);
    const exact_solution<mpfr> truth(m);
    return with_scalar(scalar, guard_digits, [&]<class T>() {
        std::vector<judged> values;
        values.reserve(times.size());
        for (const exact& time : times) {
            const mpfr theta = widen(critical_formula(m, dimensionless_time<T>(m, time)));
            const pendulum_state<mpfr> expected = truth(time);
            const mpfr error = abs(theta - expected.theta);
            const bool rounding = std::same_as<T, mpfr> && error < pow(mpfr(10), static_cast<int>(-scalar.digits));
            values.push_back({theta, expected.omega, rounding ? mpfr(0) : error, true});
        }
        return values;
    });
}

std::string regime_name(regime r) {
    return r == regime::libration ? "libration" : r == regime::rotation ? "rotation" : "separatrix";
}

using table_rows = std::vector<std::vector<std::string>>;

table_rows rows_at(const sweep_energy& at, const study_request& request, const scalar_spec& scalar) {
    const motion m = pushed(at);
    table_rows rows;
    const auto add = [&](const std::vector<std::string>& way, const std::vector<judged>& values) {
        const precision_scope scope(scalar.digits + 2 * guard_digits);
        const exact_solution<mpfr> truth(m);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const exact& time = request.times[i];
            rows.push_back({at.energy, to_decimal(dimensionless_time<mpfr>(m, time), scalar.digits),
                            to_decimal(truth(time).theta, scalar.digits), regime_name(m.regime()), way[0], way[1],
                            way[2], to_decimal(values[i].theta, scalar.digits),
                            to_decimal(values[i].error, scalar.digits), log10_text(values[i].error), at.gap});
        }
    };
    if (m.regime() == regime::separatrix) {
        add({"critical", "", ""}, by_critical_formula(m, request.times, scalar));
        return rows;
    }
    for (const int order : request.orders) {
        for (const sweep_period_rule& period : request.period_rules) {
            add({"resummed", std::to_string(order), period.text}, folded(m, request.times, order, period.rule, scalar));
        }
    }
    return rows;
}

void require_surface(const study_request& request) {
    refuse_limits(request.energies, "the pendulum rests", "");
    const bool critical = std::any_of(request.energies.begin(), request.energies.end(),
                                      [](const sweep_energy& at) { return at.value == 2; });
    for (const exact& time : request.times) {
        if (critical && time.has_periods()) {
            throw input_error("--times", time.text, "is a multiple of the period, which is infinite at the energy 2",
                              "write times without T, or leave 2 out of --energies");
        }
    }
}

std::vector<study_table> run(const study_request& request) {
    require_surface(request);
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:40"));
    progress shown("surface, energies", request.energies.size(), request.shown);
    const auto parts = parallel_map(request.energies.size(), request.jobs, shown,
                                    [&](std::size_t i) { return rows_at(request.energies[i], request, scalar); });
    study_table result{"", scalar, {columns(), {}}};
    for (const table_rows& part : parts) {
        result.data.rows.insert(result.data.rows.end(), part.begin(), part.end());
    }
    return {result};
}

}  // namespace
}  // namespace surface_study

const study& surface() {
    using namespace surface_study;
    static const study result{
        .name = "surface",
        .title = "All motions of the pendulum",
        .label = "fig:surf",
        .question = "How does the angle of a pendulum pushed from the bottom depend on time and energy?",
        .reading =
            "Left: the angle over time for each energy, pushed from the bottom with omega = sqrt(2E); rotations "
            "count their turns, and above E = 2 the angle climbs in steps of 2 pi. The black line is the "
            "separatrix: it creeps up to pi and stays there, while its neighbours fall back (blue) or go over the"
            " top (orange). A push the other way gives the mirror image. Right: the largest error over these "
            "times of the paper's way to the surface, the resummation extended periodically, with T* from the "
            "resummed series of K(k) and with the exact T*. With N = 60 in each the errors are from 1e-26 to "
            "1e-2: next to E = 2 it is T* that limits them, not the resummation of theta.",
        .parameters = {{"--energies", "0.1:1.9:10,1.97,1.997,2,2.003,2.03,2.1,2.2:3:5", "energies E, in m g l"},
                       {"--gaps", "", "energies as 2 - E"},
                       {"--times", "0:15:61",
                        "times since the bottom; multiples of T where E = 2 is not among the energies"},
                       {"--orders", "60", "N, last index of the resummed series"},
                       {"--period-by", "resummed:60,agm", "ways to T*"},
                       {"--scalar", "mpfr:40", "arithmetic of the paper's formulas"}},
        .quick = {{"--energies", "1.71,2,2.02", ""}, {"--times", "0:20:6", ""}, {"--orders", "10", ""}},
        .seconds = 0.5,
        .run = run};
    return result;
}

}  // namespace libration::studies
