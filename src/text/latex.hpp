// Tables for papers: LaTeX with the rules of booktabs, on as many pages as they need (longtable).
#pragma once

#include <string>

#include "text/table.hpp"

namespace libration {

/// Text as LaTeX prints it: the special characters escaped.
std::string latex_text(const std::string& text);

/// A cell: a number as $-1.5\times10^{-3}$, rounded to `digits` significant digits where it has more (to nearest, from
/// its decimal), a whole number with all of them; inf as $\infty$; anything else as text.
std::string latex_cell(const cell& content, long digits = 8);

/// What stands around a table.
struct latex_frame {
    std::string caption;  ///< LaTeX
    std::string label;    ///< the table is \ref{tab:LABEL}
};

/// The same without a frame, every digit kept: a tabular for short tables. Needs \usepackage{booktabs}.
std::string to_latex(const table& data);

/// A longtable: needs \usepackage{booktabs,longtable}. Columns named log10_... are left out: they serve the figures.
std::string to_latex(const table& data, const latex_frame& frame);

}  // namespace libration
