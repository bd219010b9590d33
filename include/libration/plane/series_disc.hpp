// The Taylor polynomial of a solution about a point of the complex plane in balls, with the bound of theorem T: the piece
// of coverings with several charts, and the carrier of the constants of a singularity.
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "libration/equation/polynomial_form.hpp"
#include "libration/expansion/ball_expansion.hpp"
#include "libration/expansion/tail_bound.hpp"
#include "libration/plane/complex_disc.hpp"

namespace libration::ode {

/// A system for expansions about points given with their states: its polynomial form for paths (path_form), which continues
/// functions of several values.
class plane_system {
public:
    /// Initial values are not used. Throws error as lifted_for_paths().
    explicit plane_system(const explicit_system& of);

    const path_form& form() const { return form_; }
    const tape& points() const { return tape_; }
    const number& origin() const { return origin_; }
    /// Number of carried unknowns: the given ones, and functions of several values.
    std::size_t carried() const { return form_.lifted.given; }

private:
    path_form form_;
    tape tape_;
    number origin_;
};

/// The carried unknowns of a system at its initial point, enclosed at the working precision.
std::vector<complex_ball> carried_start(const explicit_system& of, const plane_system& as);

/// Theorem T about a point: every solution with a state in these balls there is analytic in |z - centre| < radius(), and
/// |y_i - p_i| <= error_i (|z - centre|/radius)^(N+1). Unlike complex_disc it keeps the coefficients, which contain those of
/// all these solutions. Offsets are from the initial point of the system.
class series_disc {
public:
    /// The centre is exact. Throws precision_exhausted if no radius is found.
    series_disc(const plane_system& of, complex_ball centre, const std::vector<complex_ball>& carried, int order);

    const complex_ball& centre() const { return centre_; }
    const magnitude& radius() const { return tail_.radius; }
    int order() const { return tail_.degree; }
    /// Coefficients 0 .. order() of a carried unknown.
    const std::vector<complex_ball>& coefficients(std::size_t unknown) const { return coefficients_[unknown]; }
    /// error_i.
    const magnitude& error(std::size_t unknown) const { return tail_.error[unknown]; }

    /// The carried unknowns at an offset, which may be a narrow ball. Throws precision_exhausted outside the disc.
    std::vector<complex_ball> at(const complex_ball& offset) const;
    /// The same over a wide ball, in 64 bits: p(m) and |p(z) - p(m)| <= w |p'(m)| + w^2/2 sum n (n - 1) |a_n| r^(n-2), m the
    /// midpoint, |z - m| <= w, r the largest distance.
    std::vector<complex_ball> over(const complex_ball& offset) const;

private:
    magnitude distance_of(const complex_ball& from_centre) const;

    complex_ball centre_;
    std::vector<std::vector<complex_ball>> coefficients_;
    tail_bound tail_;
};

/// An exact complex double.
complex_ball exact_point(const std::complex<double>& z);
/// The midpoint, rounded to double.
std::complex<double> rounded_midpoint(const complex_ball& z);

}  // namespace libration::ode
