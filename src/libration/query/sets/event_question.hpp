// The events of all solutions from a box of initial values and parameters: theorems V and E.
#pragma once

#include <optional>
#include <vector>

#include "libration/equation/first_order_form.hpp"
#include "libration/event/zero_search.hpp"
#include "libration/query/sets/set_events.hpp"
#include "set_query.hpp"

namespace libration::ode {

/// The first events for the condition of the problem: an image each, of the time and the unknowns then. Event k of every
/// solution is the kth zero of the condition after the initial point, a simple one, so that it depends on the numbers of
/// the box like the solution does, with dt/dp = -Dg y_p/g', and dy/dp = y_p + f dt/dp for the unknowns at that time.
class event_question : public set_query {
public:
    event_question(const set_problem& of, const set_event_request& asked, long bits, const march_watch& watch,
                   const proof_route& route);

    set_run_result enclosed_from(const number_box& box, bool with_derivatives) const override;
    bool is_narrowed(std::size_t /*image*/) const override { return true; }

private:
    set_start start_from(const number_box& box) const;
    set_image image_of(const proved_event& event, const ball_matrix& of_start, bool with_derivatives) const;
    ball_matrix derivatives_of(const proved_event& event, const ball_matrix& of_start) const;
    ball by_condition(std::size_t place, const proved_event& event) const;
    bool note_event(const proved_event& event, const ball_matrix& of_start, bool with_derivatives, std::size_t index,
                    set_run_result& result) const;
    void note_end(const zero_search& search, std::size_t index, set_run_result& result) const;

    const set_event_request& asked_;
    int direction_;
    first_order_form form_;
    expression g_, slope_;  // in leaves
    std::vector<expression> gradient_;
    /// The constant coefficient of an unknown in the condition, if that has no other unknowns but constant ones, and not
    /// the time: x = a.
    std::vector<std::optional<number>> coefficient_;
};

}  // namespace libration::ode
