// The catalogue: problems as text (equation/text/parse.hpp), each with its sources and defaults, embedded in the library.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace libration {

/// problems/NAME.ode, of a stiff problem problems/stiff/NAME.ode, of one with events or a piecewise right-hand side
/// problems/hybrid/NAME.ode, of one with delays problems/delay/NAME.ode.
struct catalogue_entry {
    std::string_view name;
    std::string_view text;
};

/// All of them, by name.
const std::vector<catalogue_entry>& catalogue();

/// The text of a problem. Throws error for a name that is not in the catalogue.
std::string_view problem_text(std::string_view name);

/// Published lists of coefficients, problems/series/NAME.csv, by name; `published` is a table of what is known of them.
const std::vector<catalogue_entry>& series_catalogue();

/// A one-line description of a problem: its first comment.
std::string title_of(const catalogue_entry& entry);

}  // namespace libration
