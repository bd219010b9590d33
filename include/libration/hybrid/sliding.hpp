// Where a solution would slide along a switching surface, or may leave it on both sides: theorem H, "Step functions".
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace libration::ode {

/// Why the values of step functions at the beginning of a branch are not known.
enum class mode_failure {
    undecided,       ///< it is not decided what one of them is
    sliding,         ///< on both sides of its surface the solutions lead back to it
    several,         ///< solutions leave the surface on both sides, or on one while another remains on it
    not_continuous,  ///< the slopes of a branch are not proved to be continuous about the surface
    together         ///< it is on several surfaces at once, and what their signs decide is not proved to be a sum
};

/// A branch at the surface u = 0 of a sign: the side on which it holds, or 0 for the surface itself, and the sign of the
/// derivative of u along it; std::nullopt if that is not decided.
struct side_of_surface {
    int side = 0;
    std::optional<int> sign;
};

/// What the derivatives of order `order` of u mean, those of lower orders being 0. It is sliding only if, for the first
/// derivative, u decreases on each branch above the surface and increases on each below, and several only if it is
/// `alone`, that is if no other step function is open, and u increases above and decreases below.
mode_failure failure_at_surface(const std::vector<side_of_surface>& branches, int order, bool alone);

/// "the solution slides along the surface of `sign(x)`: ...", for messages; the text is that of the step function, empty if
/// it is named before.
std::string reason_of(mode_failure failure, const std::string& text);

}  // namespace libration::ode
