// The facts stated by the message of an error.
#pragma once

#include <optional>
#include <string>

namespace libration::attack {

/// The facts that a message states as proved, in its decimals; a message without any of them states no proved fact.
struct refusal_facts {
    std::optional<std::string> exists_up_to;  ///< "is proved to exist up to X"
    std::optional<std::string> none_up_to;    ///< "is not found within N steps, from time T up to X"
    std::optional<std::string> lies_above;    ///< "lies in [A, B]"
    std::optional<std::string> lies_below;
    std::optional<long> found;                   ///< "is not found before that time: K were found"
    std::optional<std::string> nothing_within;   ///< "shows no singularity within X"
    std::optional<std::string> radius_at_least;  ///< "of at most U and at least L, both proved"
    std::optional<std::string> radius_at_most;
    bool touches = false;  ///< "the function touches 0 there"
    bool slides = false;   ///< "the solution slides along"
};

refusal_facts facts_of(const std::string& message);

}  // namespace libration::attack
