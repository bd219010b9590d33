// The place of a file that a command writes.
#pragma once

#include <string>

namespace libration {

/// Throws input_error of the option if the path is that of a folder, or in a folder that does not exist or is not
/// writable: before a long computation, not after it.
void require_output_place(const std::string& option, const std::string& path);

}  // namespace libration
