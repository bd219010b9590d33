// The two approximations of theta that the paper compares, by name.
#pragma once

namespace libration::pendulum {

/// The approximations of theta on [0, T*]: the partial sum of the series from the top, and its resummation.
enum class arc_method { series, resummed };

}  // namespace libration::pendulum
