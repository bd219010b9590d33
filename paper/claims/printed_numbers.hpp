// The numbers that the paper prints for the labels of its LaTeX source.
#pragma once

#include <string>
#include <vector>

namespace libration {

/// The place of a claim in print: every LaTeX label in its label is replaced by the printed number, as in
/// "(16c), (16d)" for "cosseriesrec, sinseriesrec" and "figure 4, text" for "fig:subcrit, text". Other words
/// remain. Labels of equations without a number become "unnumbered equation before (24c)".
std::string printed_place(const std::string& label);

/// Whether a claim with this label concerns a LaTeX label (fig:subcrit) or a printed number (figure 4,
/// section III B, equation 16 or (16c); upper case, "Fig.", "Eq." and "Sec." are understood). An equation with parts
/// concerns all of them, (16) each of (16a) to (16d), and a section its subsections.
bool concerns(const std::string& label, const std::string& asked);

}  // namespace libration
