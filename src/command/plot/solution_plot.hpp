// The figure of `libration trajectory --plot` and `libration reference --plot`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plot/figure_file.hpp"
#include "plot/plot_options.hpp"
#include "problem/problem_options.hpp"
#include "problem/solution_table.hpp"
#include "text/table.hpp"

namespace libration {

/// The states of one solution of a family, in the order of a curve.
struct drawn_solution {
    std::string name;  ///< in the key: "k = 1"; empty if there is only one
    table states;
};

/// States to be marked, such as events: their name in the key, and a row for each.
struct drawn_marks {
    std::string name;
    table states;
};

/// Curves of the named quantities of these tables. One solution: all in one panel, a colour for each quantity. A
/// family: a panel for each quantity, a colour for each solution. The first quantity is on the horizontal axis; if that
/// is not the time, the initial point of each curve is marked. A value that is missing breaks its line. Throws
/// input_error for names that the tables do not have.
figure_content solution_plot(const std::vector<drawn_solution>& family, const plot_axes& axes,
                             const std::optional<drawn_marks>& marks, const std::string& problem);

/// The same of the tables of a family, or of motions, which have no names.
figure_content family_plot(const std::vector<family_member>& family, const std::vector<partial_table>& parts,
                           const plot_axes& axes, const std::string& problem);

/// The curve of a solution from its initial point to the last of these events, at least one, with the events marked.
figure_content event_plot(const problem_options& problem, const table& events, const std::string& condition,
                          const plot_axes& axes);

}  // namespace libration
