// The classical tests of the radius of convergence on a list of coefficients, with its pattern and growth. The verdict on
// a list is not drawn from them (verdict.hpp).
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "libration/convergence/coefficient_growth.hpp"
#include "libration/convergence/coefficient_pattern.hpp"
#include "libration/convergence/exponent_uncertainty.hpp"
#include "libration/convergence/test/differential_approximants.hpp"
#include "libration/convergence/test/domb_sykes.hpp"
#include "libration/convergence/test/hunter_guerrieri.hpp"
#include "libration/convergence/test/mercer_roberts.hpp"
#include "libration/convergence/test/pole_test.hpp"
#include "libration/convergence/test/ratio_test.hpp"
#include "libration/convergence/test/root_test.hpp"
#include "libration/convergence/test/six_term_test.hpp"
#include "libration/convergence/test/three_term_test.hpp"
#include "libration/convergence/test/top_line_test.hpp"
#include "libration/scalar/compiled.hpp"

namespace libration::convergence {

/// What a test examines.
enum class radius_test_kind {
    ratios,      ///< of successive coefficients, for one singularity
    sizes,       ///< of the coefficients alone
    pair,        ///< a conjugate pair of singularities
    recurrence,  ///< a recurrence fitted to the coefficients
};

/// The factor of the uncertainty of a test whose own one is not that of its assumption: straight lines through ratios
/// look more certain than they are if singularities are confluent, essential or close to each other. Calibrated.
inline int caution_of(radius_test_kind kind) { return kind == radius_test_kind::ratios ? 8 : 2; }

/// A test: its name, and how far it is trusted.
template <rounding_scalar T>
struct radius_test {
    std::string method;
    radius_estimate<T> (*run)(const strided_series<T>&);
    radius_test_kind kind;
    /// Its uncertainty follows the error even if its assumption is wrong.
    bool is_self_validating = false;
    bool as_given = false;  ///< on all coefficients, zeros included, rather than on the class that symmetry leaves
};

/// All tests, starting with the simplest.
template <rounding_scalar T>
std::vector<radius_test<T>> all_radius_tests() {
    using enum radius_test_kind;
    return {{"ratio", ratio_test<T>, ratios, false, true},
            {"ratio-in-power", ratio_test_in_power<T>, ratios},
            {"domb-sykes", domb_sykes<T>, ratios},
            {"root", root_test<T>, sizes},
            {"root-corrected", corrected_root_test<T>, sizes},
            {"top-line", top_line_test<T>, sizes},
            {"three-term", three_term_test<T>, pair},
            {"six-term", six_term_test<T>, pair},
            {"mercer-roberts", mercer_roberts<T>, pair},
            {"hunter-guerrieri", hunter_guerrieri<T>, pair},
            {"pole", pole_test<T>, recurrence, true},
            {"pole-of-derivative", pole_test_of_derivative<T>, recurrence, true},
            {"differential-approximant", differential_approximants<T>, recurrence, true},
            {"differential-approximant-2", second_order_approximants<T>, recurrence, true}};
}

/// The analysis of a list of coefficients.
template <rounding_scalar T>
struct radius_report {
    coefficient_pattern pattern;
    coefficient_growth<T> growth;
    std::vector<radius_estimate<T>> tests;  ///< in the order of all_radius_tests()
};

/// The reason why the growth of the coefficients rules out a radius; empty if it does not.
inline std::string reason_for_no_radius(const coefficient_pattern& pattern, growth kind) {
    const std::string so_far = " radius seen up to N = " + std::to_string(pattern.order) + ": ";
    if (pattern.last < 0 || pattern.polynomial) {
        return "no finite" + so_far + pattern.text();
    }
    if (kind == growth::entire) {
        return "no finite" + so_far + "the coefficients fall faster than any power R^-n";
    }
    if (kind == growth::divergent) {
        return "no positive" + so_far + "the coefficients grow faster than any power R^-n";
    }
    return "";
}

/// Whether a self-validating test has at least six digits: then a radius exists, whatever the growth looks like.
/// Coefficients of one singularity and a stronger one further out grow as if there were none.
template <rounding_scalar T>
bool has_certain_radius(const radius_report<T>& report) {
    const auto tests = all_radius_tests<T>();
    for (std::size_t i = 0; i < report.tests.size(); ++i) {
        const radius_estimate<T>& each = report.tests[i];
        if (tests[i].is_self_validating && each.radius && each.uncertainty * 1'000'000 <= *each.radius) {
            return true;
        }
    }
    return false;
}

/// All tests on a_0 .. a_N, known to a relative accuracy `noise` and scaled so that the radius is about 1: coefficients
/// a_n u^n for a unit u; the results are in that unit (in_unit() converts them). O(N^2) and the cost of the tests.
template <rounding_scalar T>
radius_report<T> report_on_radius(const series::power_series<T>& a, const T& noise) {
    radius_report<T> report;
    report.pattern = pattern_of(a, noise);
    const list_quality<T> quality{report.pattern.order, noise};
    const auto tests = all_radius_tests<T>();
    report.tests.reserve(tests.size());
    const bool regular = report.pattern.last >= 0 && !report.pattern.polynomial;
    if (regular) {
        const strided_series<T> all(a, 0, 1);
        const strided_series<T> part = regular_part(a, report.pattern);
        if (!report.pattern.lacunary) {
            report.growth = growth_of(part);
        }
        for (const auto& test : tests) {
            report.tests.push_back(test.run(test.as_given ? all : part));
            add_position_to_exponent(report.tests.back(), quality);
            radius_estimate<T>& found = report.tests.back();
            found.uncertainty *= test.is_self_validating ? 1 : caution_of(test.kind);
            if (found.radius && found.uncertainty >= *found.radius) {
                found = no_estimate<T>(test.method, "its uncertainty is larger than the radius");
            }
        }
    }
    const std::string reason = reason_for_no_radius(report.pattern, report.growth.kind);
    if (!reason.empty() && !has_certain_radius(report)) {
        report.tests.clear();
        for (const auto& test : tests) {
            report.tests.push_back(no_estimate<T>(test.method, reason));
        }
    }
    return report;
}

/// An estimate for a_n u^n as one for a_n: lengths times u.
template <rounding_scalar T>
radius_estimate<T> in_unit(radius_estimate<T> estimate, const T& unit) {
    if (estimate.radius) {
        *estimate.radius *= unit;
        estimate.uncertainty *= unit;
        estimate.nearer *= unit;
    }
    if (estimate.position) {
        *estimate.position = *estimate.position * unit;
    }
    return estimate;
}

// Compiled once, in libration::libration.
#ifdef LIBRATION_COMPILED
#define LIBRATION_DECLARE(T) \
    extern template radius_report<T> report_on_radius(const series::power_series<T>&, const T&);
LIBRATION_FOR_ROUNDING_SCALARS(LIBRATION_DECLARE)
#undef LIBRATION_DECLARE
#endif

}  // namespace libration::convergence
