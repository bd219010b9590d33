// A motion from the top to the bottom, in the paper's own coordinates, with constants at the bottom that may be
// perturbed: the basis of the claims about the resummation.
#pragma once

#include <algorithm>
#include <vector>

#include "judging.hpp"
#include "libration/approximant/difference_norm.hpp"
#include "libration/approximant/endpoint_approximant.hpp"
#include "libration/approximant/truncated_series.hpp"
#include "libration/pendulum/bounds.hpp"
#include "libration/pendulum/expansion.hpp"

namespace libration::judging {

/// theta and its series from the top to the bottom, t = x T*, by the exact solution and without mirror images: a
/// clockwise rotation runs from pi to 0. At the current working precision; throws error at E = 2.
class sampled_arc {
public:
    explicit sampled_arc(const pendulum::motion& m)
        : truth_(m),
          level_(energy_level_of<mpfr>(m)),
          period_(effective_period(level_)),
          height_(singularity_height(level_)) {}

    const pendulum::energy_level<mpfr>& of() const { return level_; }
    const mpfr& period() const { return period_; }  ///< T*
    const mpfr& height() const { return height_; }  ///< K~'
    mpfr radius() const { return sqrt(period_ * period_ + height_ * height_); }
    mpfr rho() const { return period_ / radius(); }
    mpfr fastest() const { return sqrt(level_.pair.energy * 2); }  ///< |omega*|

    /// Theorem A2.
    mpfr bound(int order) const { return pendulum::top_bounds<mpfr>::of(level_).resummation_norm(order); }

    /// theta and d theta/dx, at any x.
    series::jet<mpfr> exact(const mpfr& x) const {
        const auto state = truth_.from_top(x);
        return {state.theta, state.omega * period_};
    }

    /// a_n T*^n.
    series::power_series<mpfr> series(int order) const {
        const auto about_top = expand(truth_, {pendulum::expansion_point::place::top, {}}, order);
        return rescale(about_top.scaled, mpfr(period_ / about_top.scale));
    }
    truncated_series<mpfr> cut(int order) const { return {series(order), mpfr(1)}; }

    /// The resummation with the end values theta* and omega*, and the one with the end values of the motion.
    endpoint_approximant<mpfr> resummed(int order, const mpfr& angle, const mpfr& speed) const {
        return {series(order), {angle, speed * period_}};
    }
    endpoint_approximant<mpfr> resummed(int order) const {
        const series::jet<mpfr> bottom = exact(mpfr(1));
        return {series(order), {bottom.value, bottom.slope}};
    }

    /// The norm of the error on [0, T*].
    template <class F>
    mpfr error_norm(const F& approximation) const {
        const auto points = chebyshev_points(std::max(41, 2 * approximation.order() + 11));
        const auto truth = [this](const mpfr& x) { return exact(x); };
        return difference_norm<mpfr>(difference(approximation, truth), points).norm;
    }
    /// The error at one point.
    template <class F>
    mpfr error_at(const F& approximation, const mpfr& x) const {
        return abs(approximation(x).value - exact(x).value);
    }

private:
    pendulum::exact_solution<mpfr> truth_;
    pendulum::energy_level<mpfr> level_;
    mpfr period_;
    mpfr height_;
};

}  // namespace libration::judging
