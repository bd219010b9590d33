// The radii of convergence compared with an interval: the theoretical rate of the errors there.
#pragma once

#include <algorithm>
#include <vector>

#include "libration/equation/constant_value.hpp"
#include "libration/expansion/tape.hpp"
#include "list_answers.hpp"

namespace libration::studies {

/// The radius of an unknown by the tests, and the farthest of the times.
struct radius_row {
    mpfr reach;
    answered_list of;
    int root;  // q of the variable's q-th root, in powers of which the series proceeds
};

inline const column_list<radius_row>& radius_columns() {
    using row = radius_row;
    static const column_list<row> all = joined(
        joined<row>({{"reach", "distance of the farthest time from the start",
                      [](const row& r) { return decimal_cell(r.reach, 12); }}},
                    columns_within(result_columns(), &row::of)),
        {{"rate",
          "reach/radius, to the power 1/q where the series goes in powers of the q-th root: factor of the error of the "
          "series a power; above 1 it diverges",
          [](const row& r) {
              const auto& radius = r.of.found.radius;
              return radius ? decimal_cell(mpfr(pow(mpfr(r.reach / *radius), mpfr(mpfr(1) / r.root))), 12) : cell();
          }},
         {"unknown", "of the problem", [](const row& r) { return r.of.unknown; }}});
    return all;
}

/// From lists of 120 powers in mpfr:30.
inline std::vector<radius_row> radii_about(const ode::explicit_system& system, const equation_sweep& sweep,
                                           const std::vector<ode::number>& times) {
    constexpr int order = 120;
    const scalar_spec scalar = read_scalar("mpfr:30");
    const precision_scope scope(scalar.digits + guard_of_lists);
    mpfr reach(0);
    for (const ode::number& time : times) {
        reach = std::max(reach, mpfr(abs(ode::constant_value<mpfr>::of(time - system.point()))));
    }
    std::vector<radius_row> rows;
    const int root = ode::tape::about_start(system).root();
    for (const auto& each : verdicts_of(system, sweep, {order}, scalar)) {
        rows.push_back({reach, each, root});
    }
    return rows;
}

/// A plan by orders followed by a cell for the radii of each combination: the rows of the last of its tables.
inline study_plan with_radii(study_plan plan, const shared_equation_sweep& sweep,
                             const std::vector<ode::number>& times) {
    const std::size_t count = plan.groups;
    const std::size_t place = plan.tables.size();
    plan.tables.push_back(head_of(*sweep, "radius", read_scalar("mpfr:30"), radius_columns()));
    plan.groups = 2 * count;
    plan.group = [of_orders = plan.group, count, sweep, times, place](std::size_t i) {
        if (i < count) {
            return of_orders(i);
        }
        const std::size_t at = i - count;
        return cell_group{{with_input(sweep->inputs(at), "part", "radius")},
                          [sweep, times, at, place](const std::vector<std::size_t>& /*the only one*/) {
                              const auto radii = radii_about(sweep->system(at), *sweep, times);
                              cell_rows rows(place + 1);
                              const precision_scope scope(50);
                              rows.back() = sweep->framed(at, make_table(radius_columns(), radii)).rows();
                              return std::vector<cell_rows>{std::move(rows)};
                          }};
    };
    return plan;
}

}  // namespace libration::studies
