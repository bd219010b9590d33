// One integration from a box of initial values and parameters, by theorem V.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "libration/ode/first_order_form.hpp"
#include "libration/ode/proved/proved_march.hpp"
#include "set_problem.hpp"

namespace libration::ode {

/// What all solutions of a box have in common during a span.
struct enclosed_span {
    std::vector<closed_interval> values;  ///< of the unknowns of the problem
    /// Of each value with respect to each number of the box, over the whole span; rows are empty if not requested.
    ball_matrix derivatives;
};

/// The result of a run: an entry for each span, empty if it is not reached.
struct set_run_result {
    std::vector<std::optional<enclosed_span>> spans;
    bool complete = true;
    /// If it is not complete: the time up to which all solutions of the box are proved to exist, and the derivatives
    /// there.
    ball reached;
    bool forward = true;
    ball_matrix derivatives = {};
    long steps = 0;  ///< in both directions
};

struct set_run_request {
    const set_problem& of;
    const std::vector<time_span>& spans;
    long bits;
    bool with_derivatives;
    const march_watch& watch;
    const proof_route& route;
};

/// The solutions of a box in both directions from the initial point, as far as the spans require.
set_run_result enclosed_from(const number_box& box, const set_run_request& how);

}  // namespace libration::ode
