#include "libration/scalar/near_word.hpp"

#include <algorithm>
#include <cstddef>

namespace libration {

std::size_t letters_apart(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> now(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) {
        last[j] = j;
    }
    for (std::size_t i = 1; i <= a.size(); ++i) {
        now[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            now[j] = std::min({replaced, last[j] + 1, now[j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                now[j] = std::min(now[j], before[j - 2] + 1);
            }
        }
        std::swap(before, last);
        std::swap(last, now);
    }
    return last[b.size()];
}

std::optional<std::string> near_word(std::string_view typed, const std::vector<std::string>& words) {
    constexpr std::size_t longest = 40;  // none of our names is longer
    const std::size_t allowed = std::max<std::size_t>(2, typed.size() / 3);
    if (typed.empty() || typed.size() > longest) {
        return std::nullopt;
    }
    std::optional<std::string> nearest;
    std::size_t least = std::min(allowed, typed.size() - 1) + 1;
    for (const std::string& word : words) {
        const std::size_t apart = letters_apart(typed, word);
        if (apart < least) {
            least = apart;
            nearest = word;
        }
    }
    return nearest;
}

std::vector<std::string> words_offered(std::string_view remedy) {
    constexpr std::string_view beginning = "write ";
    if (!remedy.starts_with(beginning)) {
        return {};
    }
    remedy.remove_prefix(beginning.size());
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const auto belongs = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '_'; };
    std::vector<std::string> words;
    while (!remedy.empty()) {
        const std::size_t comma = std::min(remedy.find(", "), remedy.size());
        const std::size_t either = std::min(remedy.find(" or "), remedy.size());
        const std::string_view item = remedy.substr(0, std::min(comma, either));
        if (!item.empty() && is_letter(item.front()) && std::all_of(item.begin(), item.end(), belongs)) {
            words.emplace_back(item);
        }
        const std::size_t behind = comma < either ? comma + 2 : either + 4;
        remedy.remove_prefix(std::min(behind, remedy.size()));
    }
    return words;
}

std::string suggestion(std::string_view typed, const std::vector<std::string>& words) {
    const auto near = near_word(typed, words);
    return near ? " (did you mean " + *near + "?)" : "";
}

}  // namespace libration
