// Events in the text of a problem: when y = 0 down: y' = -0.9*y'.
#pragma once

#include <string>
#include <vector>

#include "libration/equation/equation_system.hpp"
#include "statement.hpp"

namespace libration::ode {

/// when CONDITION up|down|both: RESET; RESET ..., or stop among the resets; `both` may be left out.
struct event_statement {
    statement condition;
    crossing way = crossing::any;
    std::vector<statement> resets;  ///< y' = -0.9*y'
    bool stop = false;
    std::string text;  ///< without the resets
    place at;
};

/// Whether the statement begins an event: with `when`, and with a colon in it.
bool is_event(const statement& words);

/// Whether the token is the direction of an event: down in `0 down:`.
bool is_direction(const statement& words, std::size_t at);

/// Takes the events out of the statements of a problem. The resets of an event are in its own statement and in those
/// that follow it, as long as their left-hand side is an unknown or a derivative that is lower than another one in the
/// problem. Throws error for a colon elsewhere, and for an event without a condition or an action.
std::vector<event_statement> take_events(std::vector<statement>& all);

/// All statements in events: conditions and resets.
std::vector<statement> statements_in(const std::vector<event_statement>& events);

}  // namespace libration::ode
