// Values of a solution that are exactly 0 at a time, which no ball shows.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/scalar/ball/ball.hpp"

namespace libration::ode {

/// The zeros of harmonic oscillations at exact times: let the equations of two values of the state be y_i' = a y_i + b y_j,
/// y_j' = c y_i - a y_j with exact numbers, and d = -a^2 - b c > 0. The matrix has the square -d, so that
///     y_i(t) = y_i(t0) cos(w s) + (a y_i(t0) + b y_j(t0)) sin(w s)/w, w = sqrt(d), s = t - t0,
/// an exact number, whose sign exact arithmetic decides. Values that remain 0 because a plane is invariant are exactly 0 in
/// the balls of every step, and need no decision.
class exact_zeros {
public:
    explicit exact_zeros(const explicit_system& of);

    /// Replaces balls that contain 0 by 0 where the values at this time are proved to be 0. With `trusted` only those.
    void put(std::vector<ball>& state, const number& time, const std::vector<bool>& trusted = {});

private:
    bool is_zero(std::size_t k, const number& time) const;

    struct oscillation {
        number start, slope, square;  ///< y_i, y_i' at the initial point, and d
    };

    number point_;
    std::map<std::size_t, oscillation> known_;
    std::map<std::pair<std::size_t, std::string>, bool> decided_;
};

}  // namespace libration::ode
