#include "ray_state.hpp"

namespace libration::ode {

namespace {

constexpr int most_ray_steps = 400;
constexpr double ray_step = 0.4;

}  // namespace

std::vector<complex_ball> state_on_ray(const explicit_system& system, const chart_atlas& atlas,
                                       std::complex<double> base, int order) {
    complex_ball here(0);
    std::vector<complex_ball> state = carried_start(system, atlas.chart(0));
    for (int k = 0; k < most_ray_steps; ++k) {
        const series_disc disc(atlas.chart(0), here, state, order);
        const std::complex<double> rest = base - rounded_midpoint(here);
        const double longest = ray_step * mag_get_d(disc.radius().handle());
        const bool last = std::abs(rest) <= longest;
        here = last ? exact_point(base) : exact_point(rounded_midpoint(here) + rest * (longest / std::abs(rest)));
        state = disc.at(here);
        if (last) {
            return state;
        }
    }
    throw precision_exhausted("a path to a singularity");
}

}  // namespace libration::ode
