// The solution of the pendulum in closed form, of a motion and of equations that are recognised as the pendulum's.
#pragma once

#include <memory>
#include <optional>

#include "libration/equation/equation_system.hpp"
#include "libration/pendulum/given_motion.hpp"
#include "libration/pendulum/motion.hpp"
#include "libration/problem/solution.hpp"

namespace libration {

/// theta and omega of a motion, in its units: Jacobi's elliptic functions. Times may be multiples of the period, 3T/4.
/// It supports no limits at infinity, no events and no fixed scalars.
std::unique_ptr<solution> solution_of(const pendulum::motion& m);
/// The same of a motion given as text; throws error as exact_motion().
std::unique_ptr<solution> solution_of(const pendulum::given_motion& given);

/// Equations that are those of a pendulum, x'' = -k sin(x), k > 0 a number, or x' = y, y' = -k sin(x), with any names,
/// order of the equations and initial time.
struct recognised_pendulum {
    pendulum::motion of;
    exact start;        ///< the time of the equations at which the motion has its time 0
    bool swapped;       ///< whether the angular velocity is the first quantity
    bool second_order;  ///< whether x is the only unknown
    std::string angle;  ///< its name
};

/// std::nullopt for other equations, and for initial values of which no precision shows the regime.
std::optional<recognised_pendulum> recognise_pendulum(const ode::equation_system& equations);

}  // namespace libration
