// JSON as lines of comma-separated cells, each number as it is written.
#pragma once

#include <string>

namespace libration {

/// An array of numbers or strings: one per line; of pairs: a line re,im, and the pairs below it; of objects: a line of
/// their keys, and their values below it. null is an empty cell. Throws std::runtime_error for anything else.
std::string lines_of_json(const std::string& text);

}  // namespace libration
