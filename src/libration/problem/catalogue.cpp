#include "libration/problem/catalogue.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "libration/scalar/error.hpp"
#include "libration/scalar/near_word.hpp"

namespace libration {

std::string_view problem_text(std::string_view name) {
    const auto found = std::ranges::find(catalogue(), name, &catalogue_entry::name);
    if (found == catalogue().end()) {
        std::vector<std::string> names;
        std::ranges::transform(catalogue(), std::back_inserter(names),
                               [](const catalogue_entry& each) { return std::string(each.name); });
        throw error(error_kind::argument, error_subject::problem, std::string(name),
                    "is not in the catalogue" + suggestion(name, names) +
                        ": `libration problems` lists it; a file contains / or ends in .ode, a text contains =");
    }
    return found->text;
}

std::string title_of(const catalogue_entry& entry) {
    const std::string_view first = entry.text.substr(0, entry.text.find('\n'));
    const auto begin = first.find_first_not_of("# ");
    return begin == std::string_view::npos ? std::string(entry.name) : std::string(first.substr(begin));
}

}  // namespace libration
