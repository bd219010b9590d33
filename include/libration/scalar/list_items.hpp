// Lists in text.
#pragma once

#include <string_view>
#include <vector>

namespace libration {

/// A part of a text without the blanks around it.
inline std::string_view without_blanks(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blanks);
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

/// The parts of a text between separators outside parentheses, without the blanks around them: "1, bessel_j(0, 2)" has
/// two. At least one part, which may be empty.
inline std::vector<std::string_view> list_items(std::string_view text, char separator = ',') {
    std::vector<std::string_view> items;
    int open = 0;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        open += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
        if (text[i] == separator && open <= 0) {
            items.push_back(without_blanks(text.substr(begin, i - begin)));
            begin = i + 1;
        }
    }
    items.push_back(without_blanks(text.substr(begin)));
    return items;
}

}  // namespace libration
