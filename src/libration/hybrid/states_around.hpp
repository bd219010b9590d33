// Enclosures of solutions over a short ball of times.
#pragma once

#include <optional>
#include <vector>

#include "libration/equation/first_order_form.hpp"
#include "libration/scalar/ball/ball.hpp"

namespace libration::ode {

/// A box that contains, at all times of a ball, the solution through each state of a set at each time of the ball; that
/// solution exists there. It is a box Z with A + [-w, w] f(T, Z) in Z, A the set, T the ball, w its diameter: Picard's
/// operator maps the functions with values in Z into themselves. std::nullopt if none is found.
std::optional<std::vector<ball>> states_around(const first_order_form& form, const std::vector<ball>& states,
                                               const ball& times);

/// The states at an exact time of the ball, given the box of states_around.
std::vector<ball> states_moved(const first_order_form& form, const std::vector<ball>& states, const ball& times,
                               const std::vector<ball>& around, const ball& to);

}  // namespace libration::ode
