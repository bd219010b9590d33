// An integrator for stiff systems: collocation of high degree, proved by theorem K.
#pragma once

#include <memory>
#include <vector>

#include "libration/ode/lifted_system.hpp"
#include "libration/ode/rigorous/tube.hpp"

namespace libration::ode {

/// Steps of theorem K for the polynomial form of a system, in sequence: where each begins in the set in which the last
/// one ended, its tube holds every solution that began in the first set.
///
/// A step: Newton's method for the polynomials that satisfy the equation in Chebyshev-Radau nodes, with the eigenvalues
/// of f_y in the middle; those that die within the step are fast. V has constant fast columns, the eigenvectors, and slow
/// ones that solve v' = f_y v, kept from step to step as long as their number and their angles permit. The length is
/// such that the last coefficients are below what the bits are worth, and that no unknown decays by more than about
/// 10^-5, so that each has its digits relative to itself. None of this is relied on: the tube is proved from the
/// polynomials alone.
class collocation_integrator {
public:
    /// `more_terms` is added to the degree of the polynomials, for a second proof.
    collocation_integrator(const lifted_system& of, long bits, int more_terms = 0);
    ~collocation_integrator();

    /// Whether explicit steps of this length are far too short: the solution from this state is smooth over some 20 of
    /// them, as a method that stiffness does not limit finds in double. No proof depends on it.
    bool is_smooth_over(const ball& time, const std::vector<ball>& state, const ball& length) const;

    /// Where it begins, `length` the first length that is tried, its sign the direction.
    void begin(const ball& time, tube_set start, const ball& length);
    /// Makes a step from reached() ready; false where none is proved, however short.
    bool prepare();
    /// Over which the step that is ready holds, exact; of the sign of the direction.
    const ball& length() const;
    /// The unknowns at a distance from reached(), between 0 and length(); after prepare().
    std::vector<ball> values_at(const ball& distance) const;
    /// Takes the step that is ready.
    void step();

    const ball& reached() const;
    const tube_set& set() const;
    /// In so many steps behind each other no mode was fast.
    int steps_without_fast_modes() const;

private:
    struct parts;
    std::unique_ptr<parts> parts_;
};

}  // namespace libration::ode
