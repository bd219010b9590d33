// The radius of convergence of a list of coefficients in practice: of any magnitude, and possibly with a noise floor.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "libration/convergence/coefficient_floor.hpp"
#include "libration/convergence/coefficient_unit.hpp"
#include "libration/convergence/radius_report.hpp"

namespace libration::convergence {

/// The report on a list; its lengths are in its unit.
template <rounding_scalar T>
struct list_report {
    radius_report<T> report;
    coefficient_unit unit;
    std::optional<coefficient_floor> floor;  ///< if the list ends in noise, which the report ignores

    /// "a noise floor of about 1.1e-16 from n = 53 on, left out"; empty if there is none.
    std::string floor_text() const {
        if (!floor) {
            return "";
        }
        const std::string rate = floor->rate == 1 ? "" : " times " + to_decimal(floor->rate, 3) + "^n";
        return "a noise floor of about " + to_decimal(floor->level, 2) + rate +
               " from n = " + std::to_string(floor->first) + " on is left out";
    }
};

/// All tests on a_0 .. a_N, of any magnitude and known to a relative accuracy `noise`. If the list ends in a noise
/// floor, the coefficients above it are analysed, cut where they are 16, 256 or 4096 times the floor, whichever gives
/// the most certain radius: later coefficients contain more information about the radius and larger errors. Throws
/// error of the kind range if T cannot represent a coefficient in the unit of the list.
template <rounding_scalar T>
list_report<T> report_on_list(const series::power_series<mpfr>& a, const T& noise) {
    const auto judged = [&](const series::power_series<mpfr>& list) {
        list_report<T> found{{}, unit_of(list), std::nullopt};
        found.report = report_on_radius(in_unit_of<T>(list, found.unit), noise);
        return found;
    };
    auto floor = floor_of(a);
    if (!floor) {
        return judged(a);
    }
    std::optional<list_report<T>> best;
    const auto relative = [](const list_report<T>& l) {
        const auto& verdict = l.report.verdict;
        return verdict.radius ? T(verdict.uncertainty / *verdict.radius) : T(2);
    };
    for (const int times : {16, 256, 4096}) {
        auto found = judged(above_floor(a, *floor, times));
        if (!best || relative(found) < relative(*best)) {
            best = std::move(found);
        }
    }
    best->floor = std::move(floor);
    return *std::move(best);
}

}  // namespace libration::convergence
