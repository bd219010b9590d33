// Enclosures of the solution about a regular singular initial point, and the first step away from it.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/expansion/ball_expansion.hpp"
#include "libration/expansion/tail_bound.hpp"
#include "libration/integration/lohner_set.hpp"
#include "libration/integration/proof_route.hpp"

namespace libration::ode {

/// y(t0 + s) = p(s) + e(s) about a regular singular initial point t0, p of degree N and e bounded by theorem S
/// (tail_bound.hpp).
class singular_series {
public:
    /// In the largest disc that was found, with so many bits. Throws error if the series is not in integer powers of
    /// the distance, or if the right-hand sides take more than products, quotients, powers, exp, log, sin, cos, sinh and
    /// cosh of the unknowns and their first derivatives;
    /// precision_exhausted if no radius is proved.
    singular_series(const explicit_system& system, long bits, int degree, const proof_route& route = {});
    singular_series(const singular_series&) = delete;
    singular_series& operator=(const singular_series&) = delete;
    ~singular_series() = default;

    /// The solution is analytic in |s| < radius().
    const magnitude& radius() const { return tail_.radius; }
    int degree() const { return tail_.degree; }
    /// Enclosures of the unknowns and their lower derivatives, in order, at real or complex s, |s| < radius() except
    /// near the edge: throws precision_exhausted if a derivative of e is not bounded by its first term.
    template <field R>
    std::vector<R> at(const R& distance) const;

private:
    magnitude bound(std::size_t unknown, const magnitude& distance, unsigned long derivative) const;

    tape of_;
    taylor_expansion<ball> expansion_;
    tail_bound tail_;
};

/// The solution of a system with a singular initial point shortly after that point, where its right-hand sides have
/// values.
struct singular_step {
    explicit_system beyond;                         ///< the first-order system, at a point after the initial one
    std::shared_ptr<const singular_series> series;  ///< about the initial point
    ball length;                                    ///< from there to that point, exact
    std::vector<ball> state;                        ///< the unknowns and their lower derivatives there, in order
};

/// By a singular_series with a remainder below 2^-bits of the unknowns, whose errors it throws.
singular_step proved_singular_step(const explicit_system& system, long bits, const proof_route& route = {});

/// The derivatives of the unknowns and lower derivatives at t0 + distance with respect to the initial values, in order,
/// with so many bits: theorem S for the system together with the variational equations of one initial value, whose
/// initial values are a unit vector. An initial value that the equation fixes, such as y'(0) = 0 of t y'' + 2 y' + ..,
/// is not varied: 0. Throws like singular_series, and error if such a value is nonzero.
ball_matrix derivative_beyond_start(const explicit_system& system, const ball& distance, long bits,
                                    const proof_route& route = {});

}  // namespace libration::ode
