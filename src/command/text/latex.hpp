// Tables for papers: LaTeX with the rules of booktabs, as wide as a page and on as many as they need (longtable).
#pragma once

#include <string>

#include "text/latex_symbol.hpp"
#include "text/table.hpp"

namespace libration {

/// A cell: a number as $-1.5\times10^{-3}$, rounded to `digits` significant digits where it has more (to nearest, from
/// its decimal), a whole number with all of them; inf as $\infty$; anything else as text.
std::string latex_cell(const cell& content, long digits = 8);

/// Caption and label of a table.
struct latex_frame {
    std::string caption;  ///< LaTeX
    std::string label;    ///< the table is \ref{tab:LABEL}
};

/// A table without a frame, every digit kept: a tabular, or several with a part of the columns each where one would be
/// wider than the text of an article in 10 points. Heads are symbols, numbers stand with their decimal points below
/// each other, and a single row of more than two columns stands upright. A column without a value is left out; more
/// rows than a page holds are a longtable. Needs \usepackage{booktabs,longtable}.
std::string to_latex(const table& data);

/// The same with a frame: a longtable of \footnotesize with numbers of 8 digits or, where that makes it fit, fewer, but
/// at least 5, and those that identify the row up to 12. A column with a constant value is moved to the
/// caption, and columns named log10_..., which are for the figures, are omitted. Needs \usepackage{booktabs,longtable}.
std::string to_latex(const table& data, const latex_frame& frame);

}  // namespace libration
