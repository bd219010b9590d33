// The two approximations of theta that the paper compares, by name.
#pragma once

#include <string_view>

namespace libration::pendulum {

/// The approximations of theta on [0, T*]: the partial sum of the series from the top, and its resummation.
enum class arc_method { series, resummed };

/// series | resummed.
constexpr std::string_view name_of(arc_method method) { return method == arc_method::series ? "series" : "resummed"; }

}  // namespace libration::pendulum
