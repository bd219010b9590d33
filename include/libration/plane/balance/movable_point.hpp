// A movable singularity of a solution of a polynomial system with its local expansion, proved: poles, branch points and psi series.
#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <vector>

#include "libration/plane/chart_atlas.hpp"
#include "libration/scalar/ball/magnitude.hpp"

namespace libration::ode {

/// x^exponent times a polynomial in log x, and the exponent if it is rational.
struct movable_term {
    complex_ball exponent;
    std::optional<rational> exact;
    std::vector<complex_ball> by_logarithm;  ///< coefficient of log(x)^k
};

/// |theta| of a variable of the expansion: |x|^rate times the largest of the moduli of a polynomial in log x.
struct movable_variable {
    ball rate;                      ///< Re r
    ball turn;                      ///< exp(pi |Im r|)
    std::vector<magnitude> moduli;  ///< of the coefficients of log(x)^k
    ball radius;                    ///< of the polydisc of the bound
};

/// The solution, continued from t0 along the ray to `place` = t* - t0, is in 0 < |x| < reach, x = 1 - (t - t0)/place, with the principal
/// powers and logarithms,
///     y = sum of the terms + rest,
/// by theorem D [docs/asymptotics.md].
struct movable_point {
    complex_ball place;
    bool real = false;
    std::complex<double> base;  ///< t - t0 on the ray where the expansion is that of the path
    double reach = 0;
    std::vector<movable_term> terms;  ///< by the real part of the exponent
    /// Whether the terms and the rest have one value about the point: whole exponents and no logarithm, by exact arithmetic.
    bool single_valued = false;
    /// Whether it is decided, by exact arithmetic, that no term has a logarithm.
    bool without_logarithms = false;
    std::vector<movable_variable> variables;
    rational order;           ///< m of y = x^-m ..
    magnitude rest;           ///< a bound of |x^m rest| on the polydisc
    double least_weight = 0;  ///< the rest has only weights of at least this real part
    /// A bound of the degree of the logarithms of weight W, divided by Re W.
    rational logarithms;

    /// A bound of |y| for |x| in a ball of positive numbers below `reach`, |arg x| <= pi; infinite outside.
    magnitude bound_over(const ball& x) const;
    /// A bound of |x^m rest|/kappa^least_weight at |x| = w with `size` >= |log x|, and kappa; throws precision_exhausted if the
    /// variables are not inside the polydisc.
    ball kappa_at(const ball& w, const ball& size) const;
};

/// 1/h in |log u| <= max(u, 1/u)^h/(e h), by which the polydisc includes powers of logarithms.
inline constexpr int parts_of_movable_logarithm = 8;

/// The expansion of the unknown or lower derivative `shown` at the movable singularity near a place, at the working precision. The
/// leading behaviour is observed there and decided by exact arithmetic (dominant balance); the place, the free leading coefficients and the
/// coefficients at the resonances are the only solution, by Krawczyk's test, for which the expansion has the state of the path at the
/// base. Throws error of the kind undecided with the reason for a leading behaviour of another form, precision_exhausted if the precision is not
/// sufficient.
movable_point movable_point_near(const explicit_system& system, const chart_atlas& atlas, std::size_t shown,
                                 const complex_ball& near);

}  // namespace libration::ode
