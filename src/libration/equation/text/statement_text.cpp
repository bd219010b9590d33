// The text of statements, for messages.
#include <algorithm>

#include "character.hpp"
#include "statement.hpp"

namespace libration::ode {

namespace {

// The last characters of a text, with "..." for those before.
std::string end_of(std::string_view text) {
    constexpr std::size_t shown = 60;
    std::string_view rest = text;
    for (std::size_t left_out = std::max(characters_in(text), shown) - shown; left_out > 0; --left_out) {
        rest.remove_prefix(first_character(rest).source.size());
    }
    return (rest.size() < text.size() ? "..." : "") + std::string(rest);
}

}  // namespace

std::string text_of(const statement& words, std::size_t first, std::size_t last) {
    if (first >= last) {
        return "";
    }
    const std::string_view from = words[first].source;
    const std::string_view end = words[last - 1].source;
    return {from.data(), end.data() + end.size()};
}

std::string whole(const statement& words) { return text_of(words, 0, words.size()); }

std::string corrected(const statement& words, std::size_t first, std::size_t last, const std::string& by) {
    const auto end_of_token = [&](std::size_t i) { return words[i].source.data() + words[i].source.size(); };
    const char* const from = first < last ? words[first].source.data() : end_of_token(first - 1);
    const char* const to = first < last ? end_of_token(last - 1) : words[first].source.data();
    return end_of({words.front().source.data(), from}) + by + beginning_of({to, end_of_token(words.size() - 1)});
}

}  // namespace libration::ode
