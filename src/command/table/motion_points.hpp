// The request of a table of motions: each motion with its times, from lists or from the rows of a file.
#pragma once

#include <string>
#include <vector>

#include "table/motion_grid.hpp"

namespace libration {

/// A motion with some of its times.
struct motion_block {
    grid_motion motion;
    std::vector<exact> times;
    std::string said;       ///< what named the times, for complaints
    std::string direction;  ///< + or - where it was given
};

/// Blocks in the order of the rows, and which columns the table has for them.
struct motion_points {
    std::vector<motion_block> blocks;
    bool theta0 = false, omega0 = false, direction = false;
    bool seconds = false;  ///< whether a length and a gravity were given
};

/// Every motion of the lists at every time; or with --points the motions of the rows of a file, each at its own time or
/// at every one of --times. In decimals every row has to have the same numbers. Throws input_error.
motion_points points_of(const option_words& said, bool decimals);

}  // namespace libration
