// Lists of names on the command line, where `all` means all of them.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "libration/problem/axis.hpp"
#include "libration/scalar/error.hpp"

namespace libration::studies {

/// Names that an option accepts.
struct named_choice {
    std::string axis;    ///< of the study
    std::string option;  ///< --problems
    std::string help;
    std::string forms;  ///< what may be written
    std::string remedy;
    std::string what;  ///< completes "has 'x', which is ...": "not a problem of this set"
    std::vector<std::string> names;
};

/// The axis of a study that accepts them.
inline axis axis_of(const named_choice& of) {
    return {.name = of.axis,
            .option = of.option,
            .help = of.help,
            .forms = of.forms,
            .form = axis_form::words,
            .remedy = of.remedy,
            .check =
                [of](const exact& each) {
                    if (each.text != "all" && std::ranges::find(of.names, each.text) == of.names.end()) {
                        throw error(error_kind::argument, "list", "", "has '" + each.text + "', which is " + of.what);
                    }
                },
            .coordinate = of.axis};
}

/// The requested names.
inline std::vector<std::string> chosen_names(const named_choice& of, const axis_values& asked) {
    std::vector<std::string> chosen;
    for (const exact& each : asked.of(of.axis)) {
        std::ranges::copy_if(of.names, std::back_inserter(chosen),
                             [&](const std::string& name) { return each.text == "all" || each.text == name; });
    }
    return chosen;
}

/// The element of a list that has this name.
template <class T>
const T& named(const std::vector<T>& all, const std::string& name) {
    return *std::ranges::find(all, name, &T::name);
}

}  // namespace libration::studies
