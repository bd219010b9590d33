#include "libration/scalar/near_word.hpp"

#include <catch2/catch.hpp>

namespace scalar_near_word_test {

using namespace libration;

TEST_CASE("the distance of words counts letters left out, too many, wrong and exchanged", "[option][near word]") {
    CHECK(letters_apart("", "") == 0);
    CHECK(letters_apart("period", "period") == 0);
    CHECK(letters_apart("perod", "period") == 1);
    CHECK(letters_apart("perriod", "period") == 1);
    CHECK(letters_apart("pariod", "period") == 1);
    CHECK(letters_apart("peroid", "period") == 1);
    CHECK(letters_apart("", "abc") == 3);
    CHECK(letters_apart("kitten", "sitting") == 3);  // Levenshtein's original example
    CHECK(letters_apart("sitting", "kitten") == 3);
}

TEST_CASE("the nearest word is found where one is near", "[option][near word]") {
    const std::vector<std::string> words{"period", "radius", "reference", "cite"};
    CHECK(near_word("perod", words) == "period");
    CHECK(near_word("refrence", words) == "reference");
    CHECK(near_word("sight", words) == std::nullopt);
    CHECK(near_word("", words) == std::nullopt);
    CHECK(near_word(std::string(10'000'000, 'a'), words) == std::nullopt);
    CHECK(suggestion("raduis", words) == " (did you mean radius?)");
    CHECK(suggestion("xyzzy", words).empty());
}

TEST_CASE("the words that a remedy offers are known from what cannot be one", "[option][near word]") {
    using words = std::vector<std::string>;
    CHECK(words_offered("write exact, series, resummed or rk4") == words{"exact", "series", "resummed", "rk4"});
    CHECK(words_offered("write double, long-double, mpfr:DIGITS or ball:DIGITS (proved)") ==
          words{"double", "long-double"});
    CHECK(words_offered("write top, start or a time such as 1.1 or T/8") == words{"top", "start"});
    CHECK(words_offered("write 1.71, 171/100 or 1e-3").empty());
    CHECK(words_offered("see libration --help").empty());
    CHECK(words_offered("").empty());
}

}  // namespace scalar_near_word_test
