// The pendulum's own series as one of known radius, with which radius tests are checked.
#pragma once

#include <string>
#include <utility>

#include "libration/convergence/known_singularity.hpp"
#include "libration/pendulum/series_on_arc.hpp"

namespace libration::pendulum {

/// theta about the fraction x of T* after the top, in dimensionless time: logarithms at (1-x) T* + i K~' and the points
/// symmetric to it, four about the top (at E = 1 in one power of t) and two elsewhere; about the bottom they are on the
/// imaginary axis. Throws error at E = 0 and 2.
inline convergence::known_series<mpfr> known_arc_series(std::string name, const motion& m, const rational& x) {
    const auto expand = [m, x](int order) {
        const auto cover = coverage_from<mpfr>(m, x);
        const auto scaled = taylor_coefficients(start_at(exact_solution<mpfr>(m), cover.place), order, cover.radius);
        return rescale(scaled, mpfr(1 / cover.radius));
    };
    const auto position = [m, x] { return nearest_on_arc(coverage_from<mpfr>(m, x), x); };
    return convergence::singular_series<mpfr>(
        std::move(name), expand,
        {position, nearest_count_on_arc(x), convergence::singularity_kind::logarithm, rational(0)});
}

}  // namespace libration::pendulum
