#include "libration/problem/catalogue.hpp"

#include <algorithm>

#include "libration/scalar/error.hpp"

namespace libration {

std::string_view problem_text(std::string_view name) {
    const auto found = std::ranges::find(catalogue(), name, &catalogue_entry::name);
    if (found == catalogue().end()) {
        throw error(
            error_kind::argument, "problem", std::string(name),
            "is not in the catalogue (`libration problems` lists it); a file has a / or ends in .ode, a text has =");
    }
    return found->text;
}

std::string title_of(const catalogue_entry& entry) {
    const std::string_view first = entry.text.substr(0, entry.text.find('\n'));
    const auto begin = first.find_first_not_of("# ");
    return begin == std::string_view::npos ? std::string(entry.name) : std::string(first.substr(begin));
}

}  // namespace libration
