// The solution about a regular singular start, enclosed, and the first step away from it.
#pragma once

#include <cstddef>
#include <vector>

#include "libration/ode/ball/taylor_expansion.hpp"
#include "libration/ode/explicit_system.hpp"
#include "libration/ode/proved/frame.hpp"
#include "libration/ode/proved/proof_route.hpp"
#include "libration/ode/proved/tail_bound.hpp"

namespace libration::ode {

/// y(t0 + s) = p(s) + e(s) about a regular singular start t0, p of degree N and e bounded by theorem S
/// (tail_bound.hpp).
class singular_series {
public:
    /// In the largest disc that was found, on so many bits. Throws error where the series is not in whole powers of the
    /// distance, where the right sides are no polynomials in the unknowns and their first derivatives;
    /// precision_exhausted where no radius is proved.
    singular_series(const explicit_system& system, long bits, int degree, const proof_route& route = {});
    singular_series(const singular_series&) = delete;
    singular_series& operator=(const singular_series&) = delete;
    ~singular_series() = default;

    /// The solution is analytic in |s| < radius().
    const magnitude& radius() const { return tail_.radius; }
    /// Enclosures of the unknowns and their lower derivatives, in order, at real or complex s, |s| < radius() but for
    /// the last parts of it: throws precision_exhausted where a derivative of e is not bounded by its first term.
    template <field R>
    std::vector<R> at(const R& distance) const;

private:
    magnitude bound(std::size_t unknown, const magnitude& distance, unsigned long derivative) const;

    tape of_;
    taylor_expansion<ball> expansion_;
    tail_bound tail_;
};

/// The solution of a system with a singular start a little after it, where its right sides have values.
struct singular_step {
    explicit_system beyond;        ///< the system of first order, at a point behind the start
    std::vector<ball> state;       ///< the unknowns and their lower derivatives there, in order
    std::vector<ball> on_the_way;  ///< enclosures of all that they are between the start and there
};

/// By a series with a remainder below 2^-bits of the unknowns, whose errors it throws.
singular_step proved_singular_step(const explicit_system& system, long bits, const proof_route& route = {});

/// The derivatives of the unknowns and lower derivatives at t0 + distance by the starts, in order, on so many bits:
/// theorem S for the system and what its right sides say of the derivative by one start, which starts as a unit vector.
/// A start that the equation fixes, such as y'(0) = 0 of t y'' + 2 y' + .., does not move: 0. Throws as
/// singular_series, and error where such a start is not 0.
ball_matrix derivative_beyond_start(const explicit_system& system, const ball& distance, long bits,
                                    const proof_route& route = {});

}  // namespace libration::ode
