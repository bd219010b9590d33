// The header of a column in a paper.
#pragma once

#include <string>

namespace libration {

/// The head of a column by its CSV name: energy is $E$, tstar $T^*$; other names as words, time_of_maximum being
/// "time of maximum".
std::string latex_head(const std::string& name);

/// Text as LaTeX prints it: the special characters escaped.
std::string latex_text(const std::string& text);

}  // namespace libration
