// Newton's method for one unknown by a map in balls, from a first guess.
#pragma once

#include <cmath>
#include <optional>

#include "../../algebra/dense_matrix.hpp"
#include "libration/algebra/ball_matrix.hpp"
#include "libration/algebra/krawczyk.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

/// What becomes of a step that is longer than permitted.
enum class long_step { refused, shortened };

/// Whether the steps become smaller than 1e-13 of x, in at most `most_steps`; none longer than `longest`, relative to 0.1 + |x|. `f` is the
/// enclosed map at a number, std::nullopt or an error where it is not known.
template <class Map>
bool improved_by_newton(ball& x, int most_steps, double longest, long_step longer, const Map& f) {
    for (int k = 0; k < most_steps; ++k) {
        std::optional<enclosed_map> at;
        try {
            at = f(x);
        } catch (const error&) {
            return false;
        }
        if (!at) {
            return false;
        }
        const double step = as_double(at->value.front()) / as_double(at->derivative.front().front());
        const double size = std::fabs(step) / (0.1 + std::fabs(as_double(x)));
        if (!std::isfinite(step) || (size > longest && longer == long_step::refused)) {
            return false;
        }
        x = exact_midpoint(x - exactly(size > longest ? step * longest / size : step));
        if (size < 1e-13) {
            return true;
        }
    }
    return false;
}

}  // namespace libration::ode
