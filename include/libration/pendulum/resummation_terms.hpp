// All that the paper's section IV and its appendix name for a motion, at every truncation up to an order, by two routes.
#pragma once

#include <vector>

#include "libration/pendulum/motion.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration::pendulum {

/// The formulas of the resummation: with the corrections of the errata, or letter by letter: omega* = +sqrt(2E) for
/// libration (omegab), no theta* in (resummation), (b), alpha and beta, and sigma_N(t) = sum a_n t^N (efficient).
enum class resummation_formulas { corrected, printed };

/// The quantities of index n = 0 .. N, in dimensionless time about the top.
struct resummation_terms {
    mpfr effective_period;          ///< T*
    mpfr angle;                     ///< theta*, 0 in the printed formulas
    mpfr speed;                     ///< omega*
    std::vector<mpfr> a;            ///< a_n (seriesrec)
    std::vector<mpfr> s;            ///< s_n, of sin theta (cosseriesrec)
    std::vector<mpfr> c;            ///< c_n, of cos theta (sinseriesrec)
    std::vector<mpfr> b;            ///< b_n (b)
    std::vector<mpfr> a_hat;        ///< ahat_n (approxcoeffs)
    std::vector<mpfr> sigma;        ///< sigma_n(T*)
    std::vector<mpfr> sigma_slope;  ///< sigma_n'(T*)
    std::vector<mpfr> alpha;        ///< alpha of the truncation n, the coefficient of t^(n+1)
    std::vector<mpfr> beta;         ///< beta of the truncation n, the coefficient of t^(n+2)
};

/// By the paper's own recurrences and its Cauchy product at the current working precision: a rotation by `m.direction()`
/// from pi, a libration from arccos(1-E). O(N^2). Throws error at E = 2 and for a negative order.
resummation_terms terms_of_resummation(const motion& m, int order, resummation_formulas by);

/// The corrected ones by another route: a_n as sums over the singularities, s_n from theta'' = -sin theta, c_n from
/// cos theta = 1 - E + theta'^2/2, ahat_n by running sums, alpha and beta from the polynomial that they complete.
resummation_terms terms_by_another_route(const motion& m, int order);

/// Decimal digits that ahat_n loses at the order N: the double zero of b(t) at T* cancels as theta - theta_N decreases.
long digits_lost_in_terms(const motion& m, int order);

}  // namespace libration::pendulum
