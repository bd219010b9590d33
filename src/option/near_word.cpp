#include "option/near_word.hpp"

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
    constexpr std::size_t longest = 40;  // no name of ours is longer
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

std::string suggestion(std::string_view typed, const std::vector<std::string>& words) {
    const auto near = near_word(typed, words);
    return near ? " (did you mean " + *near + "?)" : "";
}

}  // namespace libration
