// Linear differential equations with polynomial coefficients.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "libration/algebra/rational_polynomial.hpp"
#include "libration/equation/explicit_system.hpp"

namespace libration::ode {

/// sum over i <= r of p_i(t - t0) y^(i)(t) = 0, p_i polynomials with rational coefficients and without a common factor. An equation
/// with a polynomial G of degree k - 1 on the right is differentiated k times, by which p_r remains. p_r(0) = 0 only if the initial point is singular.
class linear_equation {
public:
    /// Of one equation in one unknown whose coefficients are rational functions, with rational coefficients, of t; t0 must be rational.
    /// Returns std::nullopt for others, also for solutions in powers of a root of t - t0.
    static std::optional<linear_equation> of(const explicit_system& system);

    std::size_t order() const { return coefficients_.size() - 1; }
    const std::vector<rational_polynomial>& coefficients() const { return coefficients_; }
    const rational_polynomial& leading() const { return coefficients_.back(); }
    /// y^(k)(t0)/k! for k < r, in the working precision; p_r(0) != 0.
    std::vector<ball> start() const;

private:
    std::vector<rational_polynomial> given_, coefficients_;
    rational_polynomial right_;
    std::vector<number> starts_;
};

}  // namespace libration::ode
