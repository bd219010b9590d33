// The axes of studies of the whole catalogue: a selection of its problems.
#pragma once

#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/problem/problem_family.hpp"

namespace libration {

/// Its only axis: --problems.
inline const problem_family& catalogue_as_problem() {
    static const problem_family result{"catalogue",
                                       {{.name = "problem",
                                         .option = "--problems",
                                         .help = "names of the catalogue",
                                         .forms = "a,b,c, or all",
                                         .form = axis_form::words,
                                         .remedy = "write names of `libration problems`, or all",
                                         .check =
                                             [](const exact& word) {
                                                 if (word.text != "all") {
                                                     static_cast<void>(problem_text(word.text));
                                                 }
                                             },
                                         .coordinate = "problem"}}};
    return result;
}

/// The names given by the values of that axis: all means the whole catalogue, except problems with events, piecewise
/// right-hand sides and delays.
inline std::vector<std::string> problem_names_of(const std::vector<exact>& words) {
    std::vector<std::string> names;
    for (const exact& word : words) {
        if (word.text != "all") {
            names.push_back(word.text);
            continue;
        }
        for (const catalogue_entry& each : catalogue()) {
            if (ode::parse(each.text).is_ordinary()) {
                names.emplace_back(each.name);
            }
        }
    }
    return names;
}

}  // namespace libration
