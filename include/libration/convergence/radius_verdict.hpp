// The answer that a careful reader would draw from all radius tests, and why.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "libration/convergence/list/coefficient_pattern.hpp"
#include "libration/scalar/text/decimal.hpp"

namespace libration::convergence {

/// The exponent nu as a hypothesis: the fraction p/q, q <= 6, that lies within the uncertainty of the estimate, with
/// the smallest q. Nothing where there is none, or where the uncertainty is too large to tell one from another.
template <rounding_scalar T>
std::optional<rational> simple_exponent(const radius_estimate<T>& estimate) {
    using std::abs;
    constexpr int largest_denominator = 6;
    if (!estimate.exponent || estimate.exponent_uncertainty * (4 * largest_denominator * largest_denominator) > 1) {
        return std::nullopt;
    }
    for (int q = 1; q <= largest_denominator; ++q) {
        const integer p = nearest_integer(widen(T(*estimate.exponent * q)));
        const rational nearest(p, q);
        if (abs(T(*estimate.exponent - from_rational<T>(nearest))) <= estimate.exponent_uncertainty) {
            return nearest;
        }
    }
    return std::nullopt;
}

/// pole for a negative integer, logarithm for 0 and other integers, algebraic otherwise.
template <rounding_scalar T>
singularity_kind kind_of(const radius_estimate<T>& estimate) {
    if (!estimate.exponent) {
        return singularity_kind::unknown;
    }
    const auto simple = simple_exponent(estimate);
    if (!simple || boost::multiprecision::denominator(*simple) != 1) {
        return estimate.exponent_uncertainty * 8 > 1 ? singularity_kind::unknown : singularity_kind::algebraic;
    }
    return *simple < 0 ? singularity_kind::pole : singularity_kind::logarithm;
}

/// The root test's answer for a lacunary series, which has its whole circle of convergence as a boundary if its
/// gaps go on growing [Hadamard1892].
template <rounding_scalar T>
radius_estimate<T> lacunary_verdict(const std::vector<radius_estimate<T>>& tests) {
    for (const auto& each : tests) {
        if (each.method == "root" && each.radius) {
            radius_estimate<T> verdict = each;
            verdict.method = "verdict";
            verdict.kind = singularity_kind::boundary;
            verdict.note = "by root: no other test is meant for growing gaps";
            return verdict;
        }
    }
    return no_estimate<T>("verdict", "a lacunary series, of which the root test gives no radius");
}

/// The answers of the tests that may decide, or of all to a factor of 3/2 where these have none, by growing relative
/// uncertainty.
template <rounding_scalar T>
std::vector<radius_estimate<T>> answers_by_certainty(const std::vector<radius_estimate<T>>& tests) {
    std::vector<radius_estimate<T>> answers;
    const auto take = [&](bool all) {
        std::copy_if(tests.begin(), tests.end(), std::back_inserter(answers), [&](const auto& each) {
            return each.radius && (each.may_decide || (all && each.uncertainty * 2 < *each.radius));
        });
    };
    take(false);
    if (answers.empty()) {
        take(true);
    }
    std::stable_sort(answers.begin(), answers.end(), [](const auto& a, const auto& b) {
        return a.uncertainty * *b.radius < b.uncertainty * *a.radius;
    });
    return answers;
}

/// The most certain answer, confirmed by another one: where it differs from all others by more than both allow, the
/// least difference is the uncertainty.
template <rounding_scalar T>
radius_estimate<T> verdict_of(const std::vector<radius_estimate<T>>& tests, const coefficient_pattern& pattern) {
    using std::abs;
    if (pattern.lacunary) {
        return lacunary_verdict(tests);
    }
    const auto answers = answers_by_certainty(tests);
    if (answers.empty()) {
        return no_estimate<T>("verdict", "no test gives a radius to a factor of 3/2: " + pattern.text());
    }
    radius_estimate<T> verdict = answers.front();
    verdict.method = "verdict";
    verdict.note = "by " + answers.front().method;
    const radius_estimate<T>* witness = nullptr;
    T doubt(0);
    for (std::size_t i = 1; i < answers.size(); ++i) {
        const T apart = abs(*verdict.radius - *answers[i].radius);
        const T left = apart <= verdict.uncertainty + answers[i].uncertainty ? verdict.uncertainty : apart;
        if (witness == nullptr || left < doubt) {
            witness = &answers[i];
            doubt = left;
        }
    }
    if (witness != nullptr) {
        verdict.note += (doubt > verdict.uncertainty ? ", contradicted by " : ", confirmed by ") + witness->method;
        verdict.uncertainty = doubt > verdict.uncertainty ? doubt : verdict.uncertainty;
    }
    verdict.kind = kind_of(verdict);
    return verdict;
}

}  // namespace libration::convergence
