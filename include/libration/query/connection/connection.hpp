// Solutions with given limits at infinity, proved by theorems W, X and Y.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "libration/equation/text/limit_condition.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/printed_number.hpp"

namespace libration::ode {

/// The solution that is requested.
struct connection_question {
    equation_system system;               ///< the values of the unknowns are the first guess
    std::vector<std::string> unknowns;    ///< parameters, or initial values as f''(0)
    std::vector<limit_condition> limits;  ///< at one end or at both; see proved_connection()
    std::vector<std::string> open = {};   ///< the unknowns without a first guess
    long digits = 50;
};

/// A number that the proof yields together with the unknowns.
struct connection_number {
    std::string name;  ///< H(inf), rate 1, amplitude of y
    proved_decimal value;
    std::string kind;  ///< limit, rate, amplitude or angle
};

class connection_orbit;

/// The unknowns, in order, and what is proved of them.
struct connection {
    std::vector<proved_decimal> values;
    std::string proved;       ///< a sentence
    std::string not_claimed;  ///< empty if no other value exists
    std::string phase = {};   ///< of an orbit with two ends: what fixes t = 0
    /// Free limits; the rates of decay d_j, minus the real parts of the eigenvalues that are followed, the slowest first; and for one slowest
    /// rate d, a real one, the amplitudes A of the unknowns with limits, y = y(inf) + A exp(-d |t|) + smaller terms. With two ends also the
    /// rates at -inf and the angle of intersection (connection_orbit.hpp). With as many digits as are proved; none for a boundary layer.
    std::vector<connection_number> more;
    double time = 0;  ///< from where on the solution is on the manifold
    /// The solution on the whole line, if it tends to equilibria; not of boundary layers.
    std::shared_ptr<const connection_orbit> orbit = {};
};

/// Connecting orbits [docs/theorems/infinity.md; vandenBerg2011]: with the flow Phi_T from the initial values, or
/// from the unstable manifold P^- of the equilibrium at -inf, at a fixed size of theta^-, and with the stable manifold P^+
/// of the equilibrium at inf (theorem W, manifold/invariant_manifold.hpp), Krawczyk's test for
///     Phi_T(x, theta^-) = P^+(theta^+; x)
/// proves that exactly one (x, theta) in a box solves it: that solution tends to the equilibrium exponentially. The
/// equilibria are those of far_state_of(). Boundary layers, quantities that they carry, decay like a power, equations with 1/t and linear equations in the time have limits of
/// other kinds [docs/theorems/infinity.md]. With limits at both ends the initial values have no effect, unless a reversal of
/// time maps the orbit through them to itself: then it is the half that ends at inf. An amplitude determines all initial
/// values. Throws error of the subject "conditions" for limits that are not those of an
/// equilibrium, of "unknowns" for another number of unknowns than the dimensions of the manifolds require, and of "first
/// guess" where no solution is found.
connection proved_connection(const connection_question& question, const proof_route& route = {},
                             const march_watch& watch = {});

}  // namespace libration::ode
