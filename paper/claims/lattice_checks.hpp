// Checks of the lattice of singularities of theta(t), by circuits in the complex t-plane and by coefficients.
#pragma once

#include <algorithm>
#include <initializer_list>

#include "judging.hpp"
#include "libration/convergence/test/pole_pair.hpp"
#include "libration/pendulum/resummation.hpp"

namespace libration::judging {

// The increments of theta and omega along a square path once around a point of the complex t-plane, of half the given
// side, reached along the real axis and then straight up or down.
struct circuit {
    complex_number<mpfr> theta;
    complex_number<mpfr> omega;
};

inline circuit around(const series::jet<mpfr>& start, const complex_number<mpfr>& centre, const mpfr& half) {
    // Counterclockwise, starting at the side that faces the real axis: the path to it must not meet the point itself.
    const mpfr side = centre.im < 0 ? mpfr(-half) : half;
    flow<mpfr> along(start.value, start.slope);
    along.advance_to(centre.re);
    const mpfr near = centre.im - side;
    const mpfr far = centre.im + side;
    const flow_state<mpfr> before = along.advance_to(centre.re, near);
    along.advance_to(centre.re + side, near);
    along.advance_to(centre.re + side, far);
    along.advance_to(centre.re - side, far);
    along.advance_to(centre.re - side, near);
    const flow_state<mpfr>& after = along.advance_to(centre.re, near);
    return {after.theta - before.theta, after.omega - before.omega};
}

// The deviation of a circuit from that of a logarithm 2i sign log(t - centre): theta increases by -4 pi sign, omega by
// 0.
inline mpfr distance_from_logarithm(const circuit& c, int sign) {
    const complex_number<mpfr> expected{mpfr(pi<mpfr>() * (-4 * sign)), mpfr(0)};
    return std::max(modulus_of(c.theta - expected), modulus_of(c.omega));
}

struct lattice_steps {
    mpfr along;  // T*
    mpfr up;     // K~'
};

inline lattice_steps lattice_of(const char* energy) {
    const pendulum::energy_level<mpfr> o = pendulum::energy_level_of<mpfr>(of_energy(energy));
    return {pendulum::effective_period(o), pendulum::singularity_height(o)};
}

inline series::jet<mpfr> bottom_of(const char* energy) { return {mpfr(0), mpfr(sqrt(number(energy) * 2))}; }

// R/T* from the top, from four coefficients alone.
inline mpfr top_radius(const char* energy, int order = 600) {
    const auto arc = pendulum::arc_of<mpfr>(of_energy(energy));
    const auto a = pendulum::arc_series(arc, order, pendulum::recurrence::sine_cosine);
    const int first = order - 8 + (number(energy) > 2 ? 1 : 0);
    return convergence::pole_pair_radius(a, first, 2);
}

// R/T* from the bottom, from a_397 and a_399 alone.
inline mpfr bottom_radius(const char* energy, const mpfr& theta0 = mpfr(0)) {
    const auto a = printed_series({theta0, bottom_of(energy).slope}, 399, effective_period_of(energy));
    return convergence::single_pole_radius(a, 397, 2);
}

// sqrt(x^2 + (K~'/T*)^2): the distance, in T*, of a singularity x T* ahead.
inline mpfr lattice_distance(const char* energy, const mpfr& x) {
    const auto [along, up] = lattice_of(energy);
    return sqrt(x * x + up * up / (along * along));
}

inline finding radius_formula(std::initializer_list<const char*> energies) {
    mpfr largest(0);
    for (const char* energy : energies) {
        largest = std::max(largest, mpfr(abs(top_radius(energy) / lattice_distance(energy, mpfr(1)) - 1)));
    }
    return by_error(largest);
}

}  // namespace libration::judging
