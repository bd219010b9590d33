// Taylor coefficients of theta about a point in the motion's own unit of time, and which of them vanish.
#pragma once

#include <string>
#include <vector>

#include "libration/digits/memory_need.hpp"
#include "libration/pendulum/expansion.hpp"

namespace libration::pendulum {

/// a_first .. a_last about a point, in the motion's unit of time. The scaled coefficients are rounded in T; the result,
/// in its wide arithmetic, may be outside the range of T. Cost and exceptions as coefficients_about; throws
/// memory_shortage if the list alone needs more memory than available.
template <scalar T>
std::vector<wide_t<T>> point_coefficients(const motion& m, const expansion_point& point, long first, long last) {
    using W = wide_t<T>;
    require_memory("power " + std::to_string(last),
                   static_cast<double>(last - first + 1) * static_cast<double>(bytes_of<W>()));
    const exact_solution<T> solution(m);
    const T scale = midpoint(radius_about(solution, point).value_or(T(1)));
    const auto scaled = coefficients_about(solution, point, scale, first, last);
    const W unit = widen(scale) * time_unit<W>(m);
    std::vector<W> values;
    values.reserve(scaled.size());
    W power = pow(unit, first);
    for (const T& a : scaled) {
        values.push_back(W(widen(a) / power));
        power *= unit;
    }
    return values;
}

/// Which of a_first .. a_last are exactly 0, if fractions decide it; empty if they do not: the initial point of the
/// series has no rational cosine, or the powers are beyond those whose fractions are affordable.
std::vector<bool> vanishing_at(const motion& m, const expansion_point& point, long first, long last);

/// The point of a name, top, bottom, start or a time; for an empty name the top, at E = 2 the bottom. Throws error of
/// the kind argument if it is not a point of this motion.
expansion_point point_of_motion(const motion& m, const std::string& name);

}  // namespace libration::pendulum
