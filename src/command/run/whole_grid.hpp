// Lists and ranges of whole numbers.
#pragma once

#include <string_view>
#include <vector>

#include "libration/number/exact.hpp"

namespace libration {

/// An item of a list: its values, and whether it was a range.
struct grid_item {
    std::vector<exact> values;
    bool is_range;
};

/// The items of a list of exact numbers, with the syntax and the errors of read_grid.
std::vector<grid_item> read_grid_items(std::string_view text);

/// The items of a list of whole numbers from 0 on, at most `largest` (0: no bound). The values of a range must come
/// out whole. Throws error saying which item is wrong, and for a range that does not come out whole the
/// nearest counts that do.
std::vector<grid_item> read_whole_items(std::string_view text, long largest);

}  // namespace libration
