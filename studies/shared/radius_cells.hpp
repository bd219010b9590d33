// The result of a radius test as the cells of a row, compared with the exact radius.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/convergence/radius_report.hpp"
#include "libration/pendulum/error/series_on_arc.hpp"
#include "sweep_columns.hpp"

namespace libration::studies {

inline constexpr long digits_of_errors = 12;
/// Digits in addition to those of the estimates for the comparison.
inline constexpr long digits_for_judging = 20;

/// Lists are passed to the tests in units of this many radii, so that no test finds the answer 1 by construction.
inline rational hidden_unit() { return rational(9) / 8; }

/// |radius/exact - 1|, in the working precision in force.
template <rounding_scalar T>
mpfr relative_error(const convergence::radius_estimate<T>& found, const mpfr& exact) {
    return abs(mpfr(widen(*found.radius) / exact - 1));
}

/// A result with the true radius. `exact` has more digits than the result.
struct judged_radius {
    std::optional<mpfr> radius;
    mpfr uncertainty;
    mpfr exact;
    long digits;
    std::optional<mpfr> error;
    std::optional<mpfr> relative_uncertainty;
};

template <rounding_scalar T>
judged_radius against_exact(const convergence::radius_estimate<T>& found, const mpfr& exact, long digits) {
    if (!found.radius) {
        return {std::nullopt, mpfr(0), exact, digits, std::nullopt, std::nullopt};
    }
    const mpfr uncertainty = widen(found.uncertainty);
    return {widen(*found.radius), uncertainty, exact, digits, relative_error(found, exact), mpfr(uncertainty / exact)};
}

/// The columns of a radius compared with the exact one.
inline const column_list<judged_radius>& judged_columns() {
    using row = judged_radius;
    static const column_list<row> all{
        {"radius", "estimated radius of convergence, dimensionless time; empty where the test does not apply",
         [](const row& r) { return decimal_cell(r.radius, r.digits); }},
        {"uncertainty", "that the test gives, dimensionless time: an estimate, not a bound",
         [](const row& r) { return r.radius ? decimal_cell(r.uncertainty, 3) : cell(); }},
        {"exact", "radius of convergence from the lattice of singularities, dimensionless time",
         [](const row& r) { return decimal_cell(r.exact, r.digits); }},
        {"relative_error", "|radius/exact - 1|", [](const row& r) { return decimal_cell(r.error, digits_of_errors); }},
        {"log10_relative_error", "log10 of relative_error", [](const row& r) { return log10_cell(r.error); }},
        {"log10_relative_uncertainty", "log10 of uncertainty/exact",
         [](const row& r) { return log10_cell(r.relative_uncertainty); }},
    };
    return all;
}

/// The first coefficients a_0 .. a_N of a longer list.
template <rounding_scalar T>
series::power_series<T> cut(const series::power_series<T>& list, int order) {
    return series::power_series<T>(
        {list.coefficients().begin(), list.coefficients().begin() + std::ptrdiff_t{order} + 1});
}

/// The result for one list.
struct answer_row {
    const sweep_energy& at;
    const exact& point;
    int order;
    std::string method;
    judged_radius found;
    std::string note;
};

inline const column_list<answer_row>& judged_answer_columns() {
    using row = answer_row;
    static const auto all = with_typed_energy<row>(joined(
        joined<row>({energy_column<row>(),
                     point_column<row>(),
                     {"order", "N, last power of t of the list", [](const row& r) { return r.order; }},
                     {"method", "verdict, or the radius test", [](const row& r) { return r.method; }}},
                    columns_within(judged_columns(), &row::found)),
        {{"note", "why there is no radius, or what a reader should know", [](const row& r) { return r.note; }}}));
    return all;
}

/// The results of the tests that are `shown` for the lists of these orders (the largest last), about one point of one
/// motion.
template <class Shown>
table answers_about(const sweep_energy& at, const exact& point, const std::vector<int>& orders,
                    const scalar_spec& scalar, const Shown& shown) {
    const precision_scope scope(scalar.digits + digits_for_judging);
    const pendulum::motion m = pendulum::motion::of_energy(at.value);
    const mpfr truth = coverage_from<mpfr>(m, point.coefficient).radius;
    std::vector<answer_row> all;
    with_scalar(scalar, 0, [&]<class T>() {
        const auto list = series_on_arc<T>(m, point.coefficient, orders.back(), hidden_unit());
        for (const int order : orders) {
            const auto report = convergence::report_on_radius(cut(list.scaled, order), epsilon<T>());
            std::vector<convergence::radius_estimate<T>> answers{report.verdict};
            answers.insert(answers.end(), report.tests.begin(), report.tests.end());
            for (const auto& answer : answers) {
                if (shown(answer.method)) {
                    const auto found = in_unit(answer, list.unit);
                    const precision_scope judging(scalar.digits + digits_for_judging);
                    all.push_back(
                        {at, point, order, found.method, against_exact(found, truth, scalar.digits), found.note});
                }
            }
        }
    });
    const precision_scope judging(scalar.digits + digits_for_judging);
    return make_table(judged_answer_columns(), all);
}

}  // namespace libration::studies
