// Formulas of plain text as a reader of a page expects them.
#pragma once

#include <string>

namespace libration {

/// Plain text as HTML with symbols and indices: theta and omega0 are written in Greek, a_n and T*^(N+1) with subscripts
/// and superscripts, 2.5e-7 as a power of ten, sqrt as a root, <= and +- as one sign, and a minus between blanks as
/// one. Everything else is unchanged, with & < > " escaped.
std::string html_mathematics(const std::string& text);

}  // namespace libration
