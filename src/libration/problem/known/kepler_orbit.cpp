#include <boost/math/tools/roots.hpp>
#include <cstdint>
#include <utility>

#include "libration/problem/known/kepler_orbit.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/mpfr.hpp"
#include "libration/scalar/precision.hpp"

namespace libration::ode {

namespace {

ball require_positive(const ball& x, const char* what) {
    if (!certainly_less(ball(0), x)) {
        throw precision_exhausted(what);
    }
    return x;
}

// F of the theorem, and its derivative.
template <class T>
T kepler_function(const T& u, const T& c, const T& s, const T& mean) {
    using std::cos;
    using std::sin;
    return u + s * (1 - cos(u)) - c * sin(u) - mean;
}
template <class T>
T kepler_slope(const T& u, const T& c, const T& s) {
    using std::cos;
    using std::sin;
    return 1 - c * cos(u) + s * sin(u);
}

// A number near the root of F, which is within |S| + e < 2 of the mean anomaly. Nothing is proved by it.
mpfr near_root(const mpfr& c, const mpfr& s, const mpfr& mean) {
    constexpr std::uintmax_t most_steps = 500;  // bisections, far from a root in orbits that are nearly straight
    std::uintmax_t steps = most_steps;
    const auto value_and_slope = [&](const mpfr& u) {
        return std::pair(kepler_function(u, c, s, mean), kepler_slope(u, c, s));
    };
    return boost::math::tools::newton_raphson_iterate(value_and_slope, mean, mpfr(mean - 2), mpfr(mean + 2),
                                                      digits<mpfr>() - 8, steps);
}

}  // namespace

ball kepler_equation::root_from(const mpfr& near) const {
    const ball at(near);
    const ball value = kepler_function(at, c, s, mean);
    const ball around = enclose(at, ball(value / least_slope));
    ball root = at - value / kepler_slope(around, c, s);
    if (!is_finite(root)) {
        throw precision_exhausted("the root of Kepler's equation");
    }
    return root;
}

kepler_orbit::kepler_orbit(const ball& m, planar_state start) : start_(std::move(start)) {
    const auto& [x, y, vx, vy] = start_;
    distance_ = sqrt(ball(x * x + y * y));
    inverse_axis_ = require_positive(2 / distance_ - (vx * vx + vy * vy) / m, "the energy of an elliptic orbit");
    root_ = sqrt(ball(m / inverse_axis_));
    mean_motion_ = inverse_axis_ * root_ * inverse_axis_;
    cosine_part_ = 1 - distance_ * inverse_axis_;
    sine_part_ = (x * vx + y * vy) / root_;
    const ball momentum = (x * vy - y * vx) / root_;
    least_slope_ = require_positive(lower_bound(ball(momentum * momentum / 2)), "the slope of Kepler's equation");
}

// u, up to a multiple of 2 pi.
ball kepler_orbit::anomaly(const ball& time) const {
    const ball turn = 2 * pi<ball>();
    ball mean = mean_motion_ * time;
    mean -= from_rational<ball>(rational(nearest_integer(ball(mean / turn)))) * turn;
    const mpfr near = near_root(midpoint_of(cosine_part_), midpoint_of(sine_part_), midpoint_of(mean));
    return kepler_equation{cosine_part_, sine_part_, mean, least_slope_}.root_from(near);
}

planar_state kepler_orbit::after(const ball& time) const {
    const ball u = anomaly(time);
    const ball sine = sin(u);
    const ball half_sine = sin(ldexp(u, -1));
    const ball versine = 2 * half_sine * half_sine;
    const ball of_distance = distance_ * inverse_axis_;          // r0/a
    const ball now = kepler_slope(u, cosine_part_, sine_part_);  // r/a
    const ball f = 1 - versine / of_distance;
    const ball g = (sine_part_ * versine + of_distance * sine) / mean_motion_;
    const ball f_slope = -mean_motion_ * sine / (now * of_distance);
    const ball g_slope = 1 - versine / now;
    return {f * start_.x + g * start_.vx, f * start_.y + g * start_.vy, f_slope * start_.x + g_slope * start_.vx,
            f_slope * start_.y + g_slope * start_.vy};
}

}  // namespace libration::ode
