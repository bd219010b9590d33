// The verdict on a list of coefficients: radius of convergence, nearest singularities and their exponents, or how fast the
// coefficients grow or fall if there is no radius; from the vote of a family of differential approximants (vote.hpp).
//
// Heuristic: finitely many coefficients prove nothing about the others. The uncertainties are calibrated on lists of
// random functions with known singularities (tests/convergence/verdict_population_test.cpp), and depend on N so that a
// longer list does not give a less certain answer unless its further coefficients contradict the shorter one.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/convergence/coefficient_pattern.hpp"
#include "libration/convergence/list.hpp"
#include "libration/convergence/radius_estimate.hpp"
#include "libration/convergence/vote.hpp"

namespace libration::convergence {

/// How a list behaves: with a positive finite radius, with radius 0, as an entire function, or not decided.
enum class growth_class { finite, zero, infinite, unknown };

/// Whether a radius is only a bound.
enum class radius_bound { none, at_least, at_most };

/// A singularity on the circle of convergence, im >= 0.
struct ring_member {
    complex_number<mpfr> position;
    mpfr uncertainty;  ///< of the position, absolute
    std::optional<mpfr> exponent = std::nullopt;
    mpfr exponent_uncertainty = mpfr(0);
    singularity_kind kind = singularity_kind::unknown;
};

/// An exponent or another number, and its uncertainty.
struct exponent_estimate {
    mpfr value, uncertainty;
};

/// The radius from the coefficients up to `order` alone.
struct shorter_answer {
    int order;
    mpfr radius;
    mpfr uncertainty;
};

/// A coefficient that the others contradict.
struct suspect_coefficient {
    int index;
    mpfr predicted;
    mpfr uncertainty;  ///< of the prediction
    double deviation;  ///< of the coefficient from it, relative
    bool confirmed;    ///< later coefficients fit again once it is replaced
};

/// The verdict; what it does not determine is absent.
struct list_verdict {
    coefficient_pattern pattern;
    growth_class growth = growth_class::unknown;
    std::optional<mpfr> radius = std::nullopt;  ///< positive and finite
    mpfr uncertainty = mpfr(0);                 ///< of the radius, absolute
    radius_bound bound = radius_bound::none;
    std::optional<complex_number<mpfr>> position = std::nullopt;  ///< of the singularity that gives the radius
    std::optional<mpfr> exponent = std::nullopt;
    mpfr exponent_uncertainty = mpfr(0);
    /// A of A (1 - x/x0)^exponent, for a logarithm times log(1 - x/x0), if one real x0 is the only singularity on the circle
    /// of the class of nonzero coefficients.
    std::optional<exponent_estimate> amplitude = std::nullopt;
    std::optional<double> second_exponent = std::nullopt;
    double slope = 0;     ///< of the exponent against the relative position, over the family
    double residual = 0;  ///< of the exponents about the line of that slope
    singularity_kind kind = singularity_kind::unknown;
    /// The modulus of another place that may be the nearest singularity: one that the uncertainty reaches.
    std::optional<mpfr> rival = std::nullopt;
    int count = 0;                       ///< singularities seen on the circle, symmetric ones included
    bool exact = false;                  ///< by a linear differential equation that the whole list satisfies
    std::vector<ring_member> ring = {};  ///< all singularities seen on the circle, the one of the radius first
    std::optional<rational> gevrey = std::nullopt;  ///< a_n ~ Gamma(s n - t) A^-n; negative for an entire function
    std::optional<complex_number<mpfr>> action = std::nullopt;  ///< A
    mpfr action_uncertainty = mpfr(0);
    std::optional<suspect_coefficient> suspect = std::nullopt;
    std::optional<double> prediction = std::nullopt;  ///< log10 of the relative error in a_N predicted from the others
    /// (n, log10 of the relative error in a_n predicted from those before), as far as it is computed.
    std::vector<std::pair<int, double>> predictions = {};
    std::vector<shorter_answer> history = {};
    std::vector<std::complex<double>> family = {};  ///< (position, exponent) of the fits that agree, if both are real
    int used = 0;                                   ///< the last coefficient that the radius is based on
    std::string note;                               ///< the reason, in words
};

/// A further coefficient.
struct predicted_coefficient {
    int index;
    mpfr value;
    mpfr uncertainty;  ///< ten times the median distance of nine tracks from their median
};

/// a_(N+1) .. a_(N+count), as far as three tracks predict them; exactly 0 where the pattern of the list has a zero.
std::vector<predicted_coefficient> predictions_for(const series_list& list, int count,
                                                   const task_runner& run = run_in_order);

/// The exponent if the singularity on the real axis is known to be at x: the value of the line through the exponents of
/// the family against their positions; std::nullopt if the verdict has no exponent at a real position.
std::optional<exponent_estimate> biased_exponent(const list_verdict& verdict, const mpfr& x);

/// The verdict on a list. O(tracks U^3) operations in 384 + 2 N bits: a second for 80 coefficients.
list_verdict verdict_on(const series_list& list, const task_runner& run = run_in_order);

}  // namespace libration::convergence
