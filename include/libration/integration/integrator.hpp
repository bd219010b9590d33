// The choice of the integrator of proofs at times, and what is reported of its steps.
#pragma once

#include <functional>

namespace libration::ode {

/// The integrator of the steps to a time.
enum class integrator_choice {
    automatic,    ///< the exponential of the matrix for linear systems with constant coefficients; else collocation
                  ///< if the steps of Taylor series are much shorter than the scale of the solution; for many
                  ///< unknowns theorem G instead of theorem V where it costs less
    taylor,       ///< Taylor series with the derivative of the flow (theorem V) alone
    collocation,  ///< collocation (theorem K) from the start on; Taylor series where no step of it is proved
    comparison    ///< Taylor series with a comparison system for the errors (theorem G) alone
};

/// `exponential`: of the matrix of a linear system with constant coefficients, one step to each time.
enum class step_method { taylor, collocation, exponential, comparison };

/// One step of a proof, as doubles: infinite where the range of double ends. No proof depends on them.
struct step_report {
    double time;    ///< at the beginning of the step
    double length;  ///< with the sign of the direction; the last step may extend beyond the last time
    long bits;      ///< working precision
    int order;      ///< degree of the polynomials; 0 for an exponential
    step_method method;
    /// log2 of the largest radius of the enclosure of an unknown at the beginning, relative to its midpoint: infinite
    /// if a midpoint is 0, -infinity if the enclosure is exact.
    double log2_of_width;
};

/// Called once for each step that is used, in order. Every run, with its own precision, begins at the initial point.
using step_observer = std::function<void(const step_report&)>;

/// The part of an integration that is made by collocation.
struct collocation_use {
    double first = 0, last = 0;  ///< the times between which its steps lie
    long steps = 0;
    long periods = 0;    ///< the number of times it replaced Taylor series
    bool proved = true;  ///< by theorem K; else in rounded arithmetic
};

}  // namespace libration::ode
