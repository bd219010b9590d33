// How does the angle of a pendulum pushed from the bottom depend on time and energy? [paper fig:surf]
#include <algorithm>
#include <string_view>
#include <utility>

#include "../shared/sweep_columns.hpp"
#include "../shared/sweep_plan.hpp"
#include "folded.hpp"
#include "libration/pendulum/critical_formula.hpp"
#include "libration/pendulum/dimensionless_time.hpp"
#include "libration/pendulum/exact_solution.hpp"
#include "text/input_error.hpp"

namespace libration::studies {

namespace surface_study {

using namespace elliptic;
using namespace pendulum;

namespace {

motion pushed(const sweep_energy& at) { return motion::of_energy_from(at.value, exact{}); }

// (critical) is exact: its only error is that of the arithmetic.
std::vector<value_with_error> by_critical_formula(const motion& m, const std::vector<exact>& times,
                                                  const scalar_spec& scalar) {
    const precision_scope scope(scalar.digits + 2 * guard_digits);
    const exact_solution<mpfr> truth(m);
    return with_scalar(scalar, guard_digits, [&]<class T>() {
        std::vector<value_with_error> values;
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

// The angle at a time, and an approximation of it.
struct surface_row {
    const sweep_energy& at;
    long digits;
    mpfr time, theta;
    regime kind;
    std::string_view method;
    cell order, period_by;
    value_with_error approximation;
    mpfr norm;  // largest error over the times
};

const column_list<surface_row>& columns() {
    using row = surface_row;
    static const auto all = with_typed_energy<row>({
        energy_column<row>(),
        {"time", "dimensionless time since the bottom, where omega = sqrt(2E)",
         [](const row& r) { return decimal_cell(r.time, r.digits); }},
        {"theta", "the exact angle, not reduced to a turn, radians",
         [](const row& r) { return decimal_cell(r.theta, r.digits); }},
        {"regime", "libration | separatrix | rotation", [](const row& r) { return regime_name(r.kind); }},
        {"method", "resummed: (fullresummation) extended by (newseries) | critical: the closed solution at E = 2",
         [](const row& r) { return r.method; }},
        {"order", "N, last index of the resummed series; empty for critical", [](const row& r) { return r.order; }},
        {"period_by", "way to T*: agm | series:N (Kold) | resummed:N (Knew); empty for critical",
         [](const row& r) { return r.period_by; }},
        {"approximation", "the angle by the method, radians",
         [](const row& r) { return decimal_cell(r.approximation.theta, r.digits); }},
        {"error", "|approximation - theta|, radians",
         [](const row& r) { return decimal_cell(r.approximation.error, r.digits); }},
        {"log10_error", "log10 of error", [](const row& r) { return log10_cell(r.approximation.error); }},
        gap_column<row>(),
        {"log10_norm", "log10 of the largest error over the times, by this way to T* at this energy",
         [](const row& r) { return log10_cell(r.norm); }},
    });
    return all;
}

table rows_at(const sweep_energy& at, const pendulum_sweep& sweep, const std::vector<int>& orders,
              const scalar_spec& scalar) {
    const motion m = pushed(at);
    std::vector<surface_row> rows;
    const auto add = [&](std::string_view method, const cell& order, const cell& period_by,
                         const std::vector<value_with_error>& values) {
        const precision_scope scope(scalar.digits + 2 * guard_digits);
        const exact_solution<mpfr> truth(m);
        const mpfr norm = std::ranges::max(values, {}, &value_with_error::error).error;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const exact& time = sweep.times[i];
            rows.push_back({at, scalar.digits, dimensionless_time<mpfr>(m, time), truth(time).theta, m.regime(), method,
                            order, period_by, values[i], norm});
        }
    };
    if (m.regime() == regime::separatrix) {
        add("critical", {}, {}, by_critical_formula(m, sweep.times, scalar));
        return make_table(columns(), rows);
    }
    for (const int order : orders) {
        for (const sweep_period_rule& period : sweep.period_rules) {
            add("resummed", order, period.text, folded(m, sweep.times, order, period.rule, scalar));
        }
    }
    return make_table(columns(), rows);
}

void require_surface(const pendulum_sweep& sweep) {
    const bool critical = std::any_of(sweep.energies.begin(), sweep.energies.end(),
                                      [](const sweep_energy& at) { return sign_of_exact(at.value - exactly(2)) == 0; });
    for (const exact& time : sweep.times) {
        if (critical && time.has_periods()) {
            throw input_error("--times", time.text, "is a multiple of the period, which is infinite at the energy 2",
                              "write times without T, or leave 2 out of --energies");
        }
    }
}

study_plan plan(const study_request& request) {
    const auto sweep = sweep_of(request);
    require_surface(*sweep);
    const auto orders = request.orders();
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:40"));
    return plan_by_energy({head_of("", scalar, columns())}, sweep, [sweep, orders, scalar](const sweep_energy& at) {
        return std::vector<table>{rows_at(at, *sweep, orders, scalar)};
    });
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
            "resummed series of K(k) and with the exact T*. With N = 60 in each the errors grow up to "
            "{{max error of surface where method=resummed order=60 to 1}}: next to E = 2 it is T* that limits them, "
            "not the resummation of theta.",
        .of = &pendulum_problem(),
        .parameters = {{"--energies", "0.1:1.9:10,1.97,1.997,2,2.003,2.03,2.1,2.2:3:5", "energies E, in m g l"},
                       {"--gaps", "", "energies as 2 - E"},
                       {"--times", "0:15:61",
                        "times since the bottom; multiples of T where E = 2 is not among the energies"},
                       {"--orders", "60", "N, last index of the resummed series"},
                       {"--period-by", "resummed:60,agm", "methods for T*"},
                       {"--scalar", "mpfr:40", "arithmetic of the paper's formulas"}},
        .quick = {{"--energies", "1.71,2,2.02", ""}, {"--times", "0:20:6", ""}, {"--orders", "10", ""}},
        .seconds = 0.5,
        .excluded = no_answer_at_limits("the pendulum rests", ""),
        .plan = plan,
        .version = 2};
    return result;
}

}  // namespace libration::studies
