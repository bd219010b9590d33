// Four figures of the paper with the same structure: an approximation on [0, T*], extended periodically, compared with
// the numerical and the exact solution. Each is a study with separate energies, orders and approximation.
#pragma once

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

/// A value of one curve at a time.
struct extension_row {
    const sweep_energy& at;
    std::optional<int> order;
    std::string_view method;
    time_cells when;
    value_with_error value;
    long digits;
    bool judges = true;  ///< false for the exact solution itself
};

inline const column_list<extension_row>& extension_columns() {
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

/// Whether a value is exact in exact arithmetic: both approximations at the top, the resummation also at the bottom.
inline bool interpolates(pendulum::arc_method method, const pendulum::phase<mpfr>& at) {
    const bool top = elliptic::quarter_of_four(at.quarter) % 2 != 0;
    return at.side == 0 && (top || method == pendulum::arc_method::resummed);
}

/// The extension of one function on the fundamental arc, in the arithmetic T, compared with the exact solution in the
/// working precision.
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

/// All times of one energy and order.
inline std::vector<value_with_error> extended(const pendulum::motion& m, const std::vector<exact>& times,
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

/// One study's tables at one energy: the approximations of all orders; the numerical solution; the exact one.
inline std::vector<table> extension_at(const sweep_energy& energy, const pendulum_sweep& sweep,
                                       const study_request& request, pendulum::arc_method method,
                                       const scalar_spec& scalar) {
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

/// The cells of such a study: its energies, with three tables.
inline study_plan plan_of_extension(pendulum::arc_method method, const study_request& request) {
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

/// The parameters of such a study, with its default energy and orders.
inline std::vector<study_parameter> extension_parameters(const std::string& energies, const std::string& orders,
                                                         const std::string& meaning_of_order) {
    return {{"--energies", energies, "energies E, in m g l"},
            {"--gaps", "", "energies as 2 - E"},
            {"--orders", orders, meaning_of_order},
            {"--times", "0:2T:401", "times since the top: multiples of the period T, or dimensionless numbers"},
            {"--step", "1e-5", "step of the Runge-Kutta method, dimensionless"},
            {"--scalar", "mpfr:40", "arithmetic of the approximation; the numerical solution is in double"}};
}

}  // namespace libration::studies
