// The conditions of a periodic orbit, reduced by integrals and by a reversal of time, as a map in balls.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "../../equation/first_integrals.hpp"
#include "libration/algebra/krawczyk.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/query/states.hpp"

namespace libration::ode {

/// Which components of the initial state and of the conditions take part.
///
/// Theorem O. Let I = (I_1, .., I_m) be integrals of y' = f(y), x an initial state, z = Phi_T(x), and let all components
/// but m, J, of z and x agree. If I is continuously differentiable on the segment from x to z and the matrix
/// G = int_0^1 dI/dx_J (x + s (z - x)) ds is regular, then z = x: 0 = I(z) - I(x) = G (z - x)_J.
///
/// With a reversal R = diag(+-1), f(R y) = -R f(y), x = R x, and the components N with the sign -1: if all of them are 0
/// at T/2, the orbit has the period T, since Phi_T(x) = R Phi_-T(R x) and Phi_T/2(x) = R Phi_T/2(x) = Phi_-T/2(x). If all
/// but m of them are 0 and I(R y) = -I(y), the same holds with the segment from z to (z + R z)/2, where I = 0.
struct orbit_conditions {
    std::vector<std::size_t> free;          ///< the components of x that are unknown, in ascending order
    bool is_period_free = true;             ///< the last unknown
    std::vector<std::size_t> rows;          ///< the conditions, in ascending order
    std::vector<std::size_t> dropped;       ///< the set J
    std::vector<first_integral> integrals;  ///< as many
    std::vector<int> reversal;              ///< the signs of R; empty without one: T instead of T/2
};

/// The state, its derivative and its slope at T, or at T/2 with a reversal.
struct orbit_end {
    std::vector<ball> start, state, slope;
    ball_matrix flow;
};

class orbit_map {
public:
    orbit_map(const explicit_system& system, const first_order_form& form, orbit_conditions conditions,
              const number& period, const proof_route& route, march_watch watch)
        : system_(system),
          form_(form),
          conditions_(std::move(conditions)),
          period_(period),
          route_(route),
          watch_(std::move(watch)) {}

    const orbit_conditions& conditions() const { return conditions_; }
    /// F and its derivative by the unknowns, as map_of_unknowns.
    std::optional<enclosed_map> operator()(const std::vector<ball>& x, long bits, long error_bits) const;
    /// All components, for a box of the unknowns.
    std::optional<orbit_end> end_at(const std::vector<ball>& x, long bits, long error_bits) const;
    /// The same at T.
    std::optional<orbit_end> end_of_period(const std::vector<ball>& x, long bits, long error_bits) const;
    std::vector<ball> start_at(const std::vector<ball>& x) const;
    ball period_at(const std::vector<ball>& x) const;
    /// Whether the conditions that are left out follow from the others, by theorem O.
    bool all_conditions_follow(const orbit_end& end) const;
    /// Whether no shorter time is a period: a component has a nonzero slope up to some time, x is avoided from then on up
    /// to some s, and not reached at T/p for the primes p up to T/s.
    bool is_shortest_period(const std::vector<ball>& x, long bits) const;

private:
    std::optional<orbit_end> end_after(const std::vector<ball>& start, const ball& time, long bits,
                                       long error_bits) const;
    void require_near_guess(const ball& period) const;
    ball time_away(step_sequence& along, const std::vector<ball>& start, const ball& period) const;

    const explicit_system& system_;
    const first_order_form& form_;
    orbit_conditions conditions_;
    number period_;
    proof_route route_;
    march_watch watch_;
};

}  // namespace libration::ode
