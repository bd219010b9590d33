// Another program as a part of a study: text in, text out.
#pragma once

#include <string>

namespace libration {

/// Runs a program without words, gives it `input` as its stdin, and returns its stdout. Throws std::runtime_error when
/// it cannot be started or ends with another code than 0.
std::string output_of_program(const std::string& path, const std::string& input);

}  // namespace libration
