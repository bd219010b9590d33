// The word that a mistyped one was perhaps to be.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace libration {

/// Letters to insert, leave out, replace, or neighbours to exchange, to make one word of the other: the distance of
/// optimal string alignment. O(a b).
std::size_t letters_apart(std::string_view a, std::string_view b);

/// The nearest of the words, the first of equally near ones; nothing where none is within a third of the letters typed
/// (two at least), or where nothing was typed.
std::optional<std::string> near_word(std::string_view typed, const std::vector<std::string>& words);

/// The words that a remedy offers, "write exact, series or rk4": those of letters, digits, - and _ that begin with a
/// letter, and none of a remedy in other words.
std::vector<std::string> words_offered(std::string_view remedy);

/// " (did you mean period?)", or nothing.
std::string suggestion(std::string_view typed, const std::vector<std::string>& words);

}  // namespace libration
