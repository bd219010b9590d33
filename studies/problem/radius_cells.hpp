// What a radius test answered, as the cells of a row, judged by the exact radius.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "libration/convergence/radius_report.hpp"
#include "libration/pendulum/error/series_on_descent.hpp"
#include "libration/scalar/text/decimal.hpp"
#include "sweep/study.hpp"

namespace libration::studies {

inline constexpr long digits_of_errors = 12;
/// Digits beyond those of the estimates, in which they are judged.
inline constexpr long digits_for_judging = 20;

/// Lists are handed to the tests in this many radii, so that no test is served the answer 1.
inline rational hidden_unit() { return rational(9) / 8; }

inline std::vector<column> radius_columns() {
    return {
        {"radius", "estimated radius of convergence, dimensionless time; empty where the test does not apply"},
        {"uncertainty", "that the test gives, dimensionless time: an estimate, not a bound"},
        {"exact", "radius of convergence from the lattice of singularities, dimensionless time"},
        {"relative_error", "|radius/exact - 1|"},
        {"log10_relative_error", "log10 of relative_error"},
        {"log10_relative_uncertainty", "log10 of uncertainty/exact"},
    };
}

/// |radius/exact - 1|, in the working precision in force.
template <rounding_scalar T>
mpfr relative_error(const radius_estimate<T>& found, const mpfr& exact) {
    return abs(mpfr(widen(*found.radius) / exact - 1));
}

/// The cells of radius_columns(). `exact` has more digits than the estimate.
template <rounding_scalar T>
std::vector<std::string> radius_cells(const radius_estimate<T>& found, const mpfr& exact, long digits) {
    const std::string truth = to_decimal(exact, digits);
    if (!found.radius) {
        return {"", "", truth, "", "", ""};
    }
    const mpfr error = relative_error(found, exact);
    return {to_decimal(*found.radius, digits),
            to_decimal(found.uncertainty, 3),
            truth,
            to_decimal(error, digits_of_errors),
            log10_text(error),
            log10_text(mpfr(widen(found.uncertainty) / exact))};
}

/// The cells of several columns in one row.
inline std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

inline std::vector<column> joined(std::vector<column> first, const std::vector<column>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

/// The list a_0 .. a_N of a longer one.
template <rounding_scalar T>
power_series<T> cut(const power_series<T>& list, int order) {
    return power_series<T>({list.coefficients().begin(), list.coefficients().begin() + std::ptrdiff_t{order} + 1});
}

inline std::vector<column> answer_columns() {
    auto all = joined({{"energy", "E, in units of m g l"},
                       {"point", "expansion point as a fraction of T*: 0 the top, 1 the bottom"},
                       {"order", "N, last power of t of the list"},
                       {"method", "verdict, or the radius test"}},
                      radius_columns());
    all.push_back({"note", "why there is no radius, or what a reader should know"});
    return all;
}

/// What the tests that are `shown` answer to the lists of these orders (the largest last), about one point of
/// one motion: rows of answer_columns().
template <class Shown>
std::vector<std::vector<std::string>> answers_about(const sweep_energy& at, const exact& point,
                                                    const std::vector<int>& orders, const scalar_spec& scalar,
                                                    const Shown& shown) {
    const precision_scope scope(scalar.digits + digits_for_judging);
    const motion m = motion::of_energy(at.value);
    const mpfr truth = cover_from<mpfr>(m, point.coefficient).radius;
    std::vector<std::vector<std::string>> all;
    with_scalar(scalar, 0, [&]<class T>() {
        const auto list = series_on_descent<T>(m, point.coefficient, orders.back(), hidden_unit());
        for (const int order : orders) {
            const auto report = report_on_radius(cut(list.scaled, order), epsilon<T>());
            std::vector<radius_estimate<T>> answers{report.verdict};
            answers.insert(answers.end(), report.tests.begin(), report.tests.end());
            for (const auto& answer : answers) {
                if (shown(answer.method)) {
                    const auto found = in_unit(answer, list.unit);
                    const precision_scope judging(scalar.digits + digits_for_judging);
                    all.push_back(joined({at.energy, point.text, std::to_string(order), found.method},
                                         radius_cells(found, truth, scalar.digits)));
                    all.back().push_back(found.note);
                }
            }
        }
    });
    return all;
}

}  // namespace libration::studies
