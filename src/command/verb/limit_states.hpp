// The states of a solution that conditions at infinity determine, printed and drawn.
#pragma once

#include <optional>
#include <string>

#include "limit_options.hpp"
#include "option/options.hpp"
#include "plot/plot_options.hpp"
#include "problem/problem_options.hpp"

namespace libration {

struct limit_states_request {
    std::optional<std::string> times;  ///< of --times, with inf and -inf; else as far as the solution moves visibly
    long digits;
    bool check = false;
    bool as_lines = false;  ///< readable text instead of a table
};

/// The table of the states, with a figure if one is requested, and on stderr the unknowns and what is proved. The exit code.
int write_limit_states(const taken_limits& of, const limit_states_request& asked, const problem_options& problem,
                       const output_options& output, plot_axes plot);

}  // namespace libration
