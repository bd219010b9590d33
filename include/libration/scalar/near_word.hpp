// The word closest to a mistyped one.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace libration {

/// The number of letters to insert, leave out or replace, or neighbours to exchange, to turn one word into the other:
/// the distance of optimal string alignment. O(a b).
std::size_t letters_apart(std::string_view a, std::string_view b);

/// The nearest of the words, the first of equally near ones; std::nullopt if none is within a third of the letters
/// typed (at least two), or if nothing was typed.
std::optional<std::string> near_word(std::string_view typed, const std::vector<std::string>& words);

/// The words offered by a remedy, "write exact, series or rk4": those of letters, digits, - and _ that begin with a
/// letter; empty for a remedy of another form.
std::vector<std::string> words_offered(std::string_view remedy);

/// " (did you mean period?)", or an empty string.
std::string suggestion(std::string_view typed, const std::vector<std::string>& words);

}  // namespace libration
