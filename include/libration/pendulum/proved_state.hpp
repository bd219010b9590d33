// Proved values of a motion at one time.
#pragma once

#include "libration/scalar/ball/ball.hpp"

namespace libration::pendulum {

/// An enclosure of the state.
struct enclosed_state {
    ball theta;
    ball omega;
};

}  // namespace libration::pendulum
