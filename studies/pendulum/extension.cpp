// How accurate are the series from the top and its resummation, extended periodically? Four figures of the paper with the
// same structure: an approximation on [0, T*], extended periodically, compared with the numerical and the exact solution.
// Each is a study with its own energy, orders and approximation. [paper fig:librationfixed, fig:rotationfixed,
// fig:librationseries, fig:librationapproximant]
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../shared/sweep_plan.hpp"
#include "libration/pendulum/error_norm.hpp"
#include "libration/pendulum/exact_solution.hpp"
#include "libration/pendulum/periodic_extension.hpp"
#include "numerical_points.hpp"
#include "periodic_rows.hpp"
#include "value_with_error.hpp"

namespace libration::studies {

namespace extension_study {

namespace {

// A value of one curve at a time.
struct extension_row {
    const sweep_energy& at;
    std::optional<int> order;
    std::string_view method;
    time_cells when;
    value_with_error value;
    long digits;
    bool judges = true;  // false for the exact solution itself
};

const column_list<extension_row>& extension_columns() {
    using row = extension_row;
    static const auto all = with_typed_energy<row>({
        energy_column<row>(),
        {"order", "N, last power of the series; last index of the resummed series; empty for rk4 and exact",
         [](const row& r) { return r.order ? cell(*r.order) : cell(); }},
        {"method", "series | resummed | rk4 | exact", [](const row& r) { return r.method; }},
        {"time", "dimensionless time since the top", [](const row& r) { return r.when.time; }},
        {"theta", "angle, radians", [](const row& r) { return decimal_cell(r.value.theta, r.digits); }},
        {"omega", "angular velocity in dimensionless time, radians",
         [](const row& r) { return decimal_cell(r.value.omega, r.digits); }},
        {"error", "|theta - exact|, radians; empty for exact",
         [](const row& r) { return r.judges ? decimal_cell(r.value.error, r.digits) : cell(); }},
        {"log10_error", "log10 of error", [](const row& r) { return r.judges ? log10_cell(r.value.error) : cell(); }},
        {"periods", "time over the period T, 12 digits", [](const row& r) { return r.when.periods; }},
        gap_column<row>(),
    });
    return all;
}

// Whether a value is exact in exact arithmetic: both approximations at the top, the resummation also at the bottom.
bool interpolates(pendulum::arc_method method, const pendulum::phase<mpfr>& at) {
    const bool top = elliptic::quarter_of_four(at.quarter) % 2 != 0;
    return at.side == 0 && (top || method == pendulum::arc_method::resummed);
}

// The extension of one function on the fundamental arc, in the arithmetic T, compared with the exact solution in the
// working precision.
template <class T, class F>
std::vector<value_with_error> follow(const pendulum::motion& m, const std::vector<exact>& times,
                                     pendulum::arc_method method, const pendulum::periodic_extension<T, F>& extension,
                                     bool slope_at_top) {
    const pendulum::exact_solution<mpfr> truth(m);
    std::vector<value_with_error> values;
    values.reserve(times.size());
    for (const exact& time : times) {
        const pendulum::phase<mpfr> at = truth.phases().at(time);
        const pendulum::pendulum_state<mpfr> expected = truth.at(at);
        const series::jet<T> found = extension(time);
        value_with_error value{widen(found.value), widen(found.slope), mpfr(0), interpolates(method, at)};
        if (fixed_scalar<T> || !value.settled) {
            value.error = abs(value.theta - expected.theta);
        } else if (slope_at_top || elliptic::quarter_of_four(at.quarter) % 2 == 0) {
            value.theta = expected.theta;
            value.omega = expected.omega;
        }
        values.push_back(std::move(value));
    }
    return values;
}

// All times of one energy and order.
std::vector<value_with_error> extended(const pendulum::motion& m, const std::vector<exact>& times,
                                       pendulum::arc_method method, int order, const scalar_spec& scalar) {
    return resolved(scalar.digits, digits_below(m, order), [&] {
        return with_scalar(scalar, working_digits() - scalar.digits, [&]<class T>() {
            const pendulum::fundamental_arc<T> arc = arc_of<T>(m);
            const bool slope_at_top = order >= 1;
            if (method == pendulum::arc_method::series) {
                const auto f = series_from_top(arc, order);
                return follow<T>(m, times, method, pendulum::periodic_extension<T, truncated_series<T>>(m, f),
                                 slope_at_top);
            }
            const auto f = resummation_from_top(arc, order);
            return follow<T>(m, times, method, pendulum::periodic_extension<T, endpoint_approximant<T>>(m, f),
                             slope_at_top);
        });
    });
}

// One study's tables at one energy: the approximations of all orders; the numerical solution; the exact one.
std::vector<table> extension_at(const sweep_energy& energy, const pendulum_sweep& sweep, const study_request& request,
                                pendulum::arc_method method, const scalar_spec& scalar) {
    const pendulum::motion m = pendulum::motion::of_energy(energy.value);
    const auto curve = [&](std::optional<int> order, std::string_view name, const std::vector<time_cells>& at,
                           const std::vector<value_with_error>& values, long digits) {
        std::vector<extension_row> rows;
        rows.reserve(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            rows.push_back({energy, order, name, at[i], values[i], digits, name != "exact"});
        }
        return make_table(extension_columns(), rows);
    };
    const auto cells = cells_of(m, sweep.times, scalar.digits);
    std::vector<table> approximate;
    for (const int order : request.orders()) {
        approximate.push_back(
            curve(order, name_of(method), cells, extended(m, sweep.times, method, order, scalar), scalar.digits));
    }
    const auto some = some_of(sweep.times);
    table numerical = curve(std::nullopt, "rk4", cells_of(m, some, 17), marched(m, some, request.step()), 17);
    const precision_scope scope(scalar.digits + 2 * guard_digits);
    const pendulum::exact_solution<mpfr> truth(m);
    std::vector<value_with_error> values;
    values.reserve(sweep.times.size());
    for (const exact& time : sweep.times) {
        const pendulum::pendulum_state<mpfr> at = truth(time);
        values.push_back({at.theta, at.omega, mpfr(0), true});
    }
    return {stacked(approximate), std::move(numerical), curve(std::nullopt, "exact", cells, values, scalar.digits)};
}

// The cells of such a study: its energies, with three tables.
study_plan plan_of_extension(pendulum::arc_method method, const study_request& request) {
    const auto sweep = sweep_of(request);
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:40"));
    const scalar_spec exact_digits{scalar_kind::arbitrary, scalar.digits};
    return plan_by_energy(
        {head_of("", scalar, extension_columns()), head_of("numerical", read_scalar("double"), extension_columns()),
         head_of("exact", exact_digits, extension_columns())},
        sweep, [sweep, request, method, scalar](const sweep_energy& at) {
            return extension_at(at, *sweep, request, method, scalar);
        });
}

// What distinguishes a study of them: its texts, and its default energy and orders.
struct extension_texts {
    std::string name, title, label, question, reading;
    std::string energy, orders;
    double seconds;
};

study study_of(pendulum::arc_method method, extension_texts texts) {
    const std::string first_order = texts.orders.substr(0, texts.orders.find(','));
    return {
        .name = std::move(texts.name),
        .title = std::move(texts.title),
        .label = std::move(texts.label),
        .question = std::move(texts.question),
        .reading = std::move(texts.reading),
        .of = &pendulum_problem(),
        .parameters = {{"--energies", texts.energy, "energies E, in m g l"},
                       {"--gaps", "", "energies as 2 - E"},
                       {"--orders", texts.orders,
                        method == pendulum::arc_method::series ? "N, last power of the series"
                                                               : "N, last index of the resummed series"},
                       {"--times", "0:2T:401",
                        "times since the top: multiples of the period T, or dimensionless numbers"},
                       {"--step", "1e-5", "step of the Runge-Kutta method, dimensionless"},
                       {"--scalar", "mpfr:40", "arithmetic of the approximation; the numerical solution is in double"}},
        .quick = {{"--energies", texts.energy, ""},
                  {"--orders", first_order, ""},
                  {"--times", "0:T:9", ""},
                  {"--step", "1e-3", ""}},
        .seconds = texts.seconds,
        .excluded = without_period(),
        .plan = [method](const study_request& request) { return plan_of_extension(method, request); },
        .script = "extension"};
}

}  // namespace
}  // namespace extension_study

const study& libration_series() {
    using namespace extension_study;
    static const study result = study_of(
        pendulum::arc_method::series,
        {.name = "libration_series",
         .title = "The series from the top over two periods of libration",
         .label = "fig:librationfixed",
         .question = "How well does the series from the top, extended periodically, follow a swinging pendulum?",
         .reading =
             "Dashed: the series about the top cut after the power N, on a quarter of a period T* and mirrored "
             "from there; thin line: the exact solution; circles: the numerical solution by the Runge-Kutta method"
             " in double. The error is largest at the passages through the bottom, T* after each top, where the "
             "pieces meet with a jump: {{max error of libration_series where order=2 to 2}} radians for N = 2, "
             "{{max error of libration_series where order=4 to 2}} for N = 4 and "
             "{{max error of libration_series where order=6 to 2}} for N = 6. The panel below "
             "shows that error over time, and how small that of the numerical solution is beside it.",
         .energy = "1.71",
         .orders = "2,4,6",
         .seconds = 0.4});
    return result;
}

const study& rotation_series() {
    using namespace extension_study;
    static const study result = study_of(
        pendulum::arc_method::series,
        {.name = "rotation_series",
         .title = "The series from the top over two periods of rotation",
         .label = "fig:rotationfixed",
         .question = "How well does the series from the top, extended periodically, follow a rotating pendulum?",
         .reading =
             "Dashed: the series about the top cut after the power N, on half a period T* and continued by its "
             "mirror image and by whole turns; thin line: the exact solution; circles: the numerical solution by "
             "the Runge-Kutta method in double. Only odd powers of the time since the top are there, so that N = 6"
             " is the same as N = 5. The error is largest at the bottom, T* after each top, and falls with N, but "
             "slowly: at this energy T* is 0.92 of the radius of convergence.",
         .energy = "2.02",
         .orders = "3,6,36",
         .seconds = 0.4});
    return result;
}

const study& near_separatrix_series() {
    using namespace extension_study;
    static const study result = study_of(
        pendulum::arc_method::series,
        {.name = "near_separatrix_series",
         .title = "The series from the top near the separatrix",
         .label = "fig:librationseries",
         .question = "How well does the series from the top follow a pendulum that almost stops upside down?",
         .reading =
             "Dashed: the series about the top cut after the power N, on a quarter of a period T* and mirrored from "
             "there; thin line: the exact solution; circles: the numerical solution by the Runge-Kutta method in "
             "double. So near to the separatrix the pendulum spends most of its time close to the top, and T* is 0.97 "
             "of the radius of convergence: the error at the bottom is "
             "{{max error of near_separatrix_series where order=5 to 2}} radians for N = 5 and still "
             "{{max error of near_separatrix_series where order=20 to 2}} for N = 20. "
             "The study near_separatrix_resummed shows what the resummation makes of the same coefficients.",
         .energy = "1.9998",
         .orders = "5,10,20",
         .seconds = 0.6});
    return result;
}

const study& near_separatrix_resummed() {
    using namespace extension_study;
    static const study result = study_of(
        pendulum::arc_method::resummed,
        {.name = "near_separatrix_resummed",
         .title = "The resummation near the separatrix",
         .label = "fig:librationapproximant",
         .question = "How well does the resummation follow a pendulum that almost stops upside down?",
         .reading =
             "Solid: the resummation with the last index N of the same series, which has the right angle and speed at "
             "the bottom too, extended periodically; thin line: the exact solution; circles: the numerical solution by "
             "the Runge-Kutta method in double. No jump is left, the error is largest in between, and at N = 20 it is "
             "{{max error of near_separatrix_series where order=20 / max error of near_separatrix_resummed where "
             "order=20 to 2}} times smaller than that of the series: compare with the study near_separatrix_series, "
             "which has the same energy and orders.",
         .energy = "1.9998",
         .orders = "5,10,20",
         .seconds = 0.6});
    return result;
}

}  // namespace libration::studies
