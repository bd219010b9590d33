// Records of cells as text, as one rank sends them to another.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "journal.hpp"

namespace libration {

std::string to_record_text(const std::vector<journal_record>& records);

/// Throws std::runtime_error for what to_record_text did not write.
std::vector<journal_record> records_from(std::string_view text);

}  // namespace libration
