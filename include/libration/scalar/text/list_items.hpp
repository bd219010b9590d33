// Lists in text.
#pragma once

#include <string_view>
#include <vector>

namespace libration {

/// The parts of a text between separators outside parentheses, with their blanks: "1, bessel_j(0, 2)" has two. At least
/// one part, which may be empty.
inline std::vector<std::string_view> list_items(std::string_view text, char separator = ',') {
    std::vector<std::string_view> items;
    int open = 0;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        open += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
        if (text[i] == separator && open <= 0) {
            items.push_back(text.substr(begin, i - begin));
            begin = i + 1;
        }
    }
    items.push_back(text.substr(begin));
    return items;
}

}  // namespace libration
