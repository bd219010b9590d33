// Four figures of the paper with one shape: an approximation on [0, T*], extended periodically, beside the numerical
// and the exact solution. Each of them is a study with its own energies, orders and way of approximating.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "judged.hpp"
#include "libration/pendulum/arc/periodic_extension.hpp"
#include "libration/pendulum/error/error_norm.hpp"
#include "libration/pendulum/solution/exact_solution.hpp"
#include "numerical_points.hpp"
#include "periodic_rows.hpp"
#include "run/parallel.hpp"

namespace libration::studies {

inline const std::vector<column>& extension_columns() {
    static const std::vector<column> all{
        {"energy", "E, in units of m g l"},
        {"order", "N, last power of the series; last index of the resummed series; empty for rk4 and exact"},
        {"method", "series | resummed | rk4 | exact"},
        {"time", "dimensionless time since the top"},
        {"theta", "angle, radians"},
        {"omega", "angular velocity in dimensionless time, radians"},
        {"error", "|theta - exact|, radians; empty for exact"},
        {"log10_error", "log10 of error"},
        {"periods", "time over the period T, 12 digits"},
        {"gap", "2 - E"},
    };
    return all;
}

/// What a value is equal to in exact arithmetic: both approximations at the top, the resummation at the bottom too.
inline bool interpolates(descent_method method, const phase<mpfr>& at) {
    const bool top = quarter_of_four(at.quarter) % 2 != 0;
    return at.side == 0 && (top || method == descent_method::resummed);
}

/// The extension of one function of the descent, in the arithmetic T, against the exact solution in the working
/// precision.
template <class T, class F>
std::vector<judged> follow(const motion& m, const std::vector<exact>& times, descent_method method,
                           const periodic_extension<T, F>& extension, bool slope_at_top) {
    const exact_solution<mpfr> truth(m);
    std::vector<judged> values;
    values.reserve(times.size());
    for (const exact& time : times) {
        const phase<mpfr> at = truth.clock().at(time);
        const pendulum_state<mpfr> expected = truth.at(at);
        const jet<T> found = extension(time);
        judged value{widen(found.value), widen(found.slope), mpfr(0), interpolates(method, at)};
        if (fixed_scalar<T> || !value.settled) {
            value.error = abs(value.theta - expected.theta);
        } else if (slope_at_top || quarter_of_four(at.quarter) % 2 == 0) {
            value.theta = expected.theta;
            value.omega = expected.omega;
        }
        values.push_back(std::move(value));
    }
    return values;
}

/// All times of one energy and order.
inline std::vector<judged> extended(const motion& m, const std::vector<exact>& times, descent_method method, int order,
                                    const scalar_spec& scalar) {
    return resolved(scalar.digits, digits_below(m, order), [&] {
        return with_scalar(scalar, working_digits() - scalar.digits, [&]<class T>() {
            const descent<T> way = descent_of<T>(m);
            const bool slope_at_top = order >= 1;
            if (method == descent_method::series) {
                const auto f = series_from_top(way, order);
                return follow<T>(m, times, method, periodic_extension<T, truncated_series<T>>(m, f), slope_at_top);
            }
            const auto f = resummation_from_top(way, order);
            return follow<T>(m, times, method, periodic_extension<T, endpoint_approximant<T>>(m, f), slope_at_top);
        });
    });
}

/// Rows of one energy: the approximations of all orders; the numerical solution; the exact one.
struct extension_rows {
    table_rows approximate;
    table_rows numerical;
    table_rows exact_curve;
};

/// One study's rows at one energy.
inline extension_rows extension_at(const sweep_energy& energy, const study_request& request, descent_method method,
                                   const scalar_spec& scalar) {
    const motion m = motion::of_energy(energy.value);
    const auto add = [&](table_rows& rows, const std::string& order, const std::string& name,
                         const std::vector<time_cells>& at, const std::vector<judged>& values, long digits) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            const judged& v = values[i];
            const bool judges = name != "exact";
            rows.push_back({energy.energy, order, name, at[i].time, to_decimal(v.theta, digits),
                            to_decimal(v.omega, digits), judges ? to_decimal(v.error, digits) : "",
                            judges ? log10_text(v.error) : "", at[i].periods, energy.gap});
        }
    };
    extension_rows result;
    const auto cells = cells_of(m, request.times, scalar.digits);
    const std::string name = method == descent_method::series ? "series" : "resummed";
    for (const int order : request.orders) {
        add(result.approximate, std::to_string(order), name, cells, extended(m, request.times, method, order, scalar),
            scalar.digits);
    }
    const auto some = some_of(request.times);
    add(result.numerical, "", "rk4", cells_of(m, some, 17), marched(m, some, request.step), 17);
    const precision_scope scope(scalar.digits + 2 * guard_digits);
    const exact_solution<mpfr> truth(m);
    std::vector<judged> values;
    values.reserve(request.times.size());
    for (const exact& time : request.times) {
        const pendulum_state<mpfr> at = truth(time);
        values.push_back({at.theta, at.omega, mpfr(0), true});
    }
    add(result.exact_curve, "", "exact", cells, values, scalar.digits);
    return result;
}

/// The three tables of such a study.
inline std::vector<study_table> run_extension(const std::string& name, descent_method method,
                                              const study_request& request) {
    require_period(request.energies);
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:40"));
    progress shown(name + ", energies", request.energies.size(), request.shown);
    const auto parts = parallel_map(request.energies.size(), request.jobs, shown, [&](std::size_t i) {
        return extension_at(request.energies[i], request, method, scalar);
    });
    const scalar_spec exact_digits{scalar_kind::arbitrary, scalar.digits};
    std::vector<study_table> tables{{"", scalar, {extension_columns(), {}}},
                                    {"numerical", read_scalar("double"), {extension_columns(), {}}},
                                    {"exact", exact_digits, {extension_columns(), {}}}};
    for (const extension_rows& part : parts) {
        const auto append = [](table& to, const table_rows& rows) {
            to.rows.insert(to.rows.end(), rows.begin(), rows.end());
        };
        append(tables[0].data, part.approximate);
        append(tables[1].data, part.numerical);
        append(tables[2].data, part.exact_curve);
    }
    return tables;
}

/// The parameters of such a study, with its usual energy and orders.
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
