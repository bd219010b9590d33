#include "attack/facts.hpp"

#include <regex>

namespace libration::attack {

namespace {

std::optional<std::string> found_in(const std::string& message, const std::string& pattern, std::size_t group = 1) {
    std::smatch match;
    return std::regex_search(message, match, std::regex(pattern)) ? std::optional(match[group].str()) : std::nullopt;
}

constexpr const char* number_pattern = R"(([-+]?[0-9]+(?:\.[0-9]+)?(?:e[-+]?[0-9]+)?))";

}  // namespace

refusal_facts facts_of(const std::string& message) {
    refusal_facts facts;
    const std::string number = number_pattern;
    facts.exists_up_to = found_in(message, "proved to exist up to " + number);
    facts.none_up_to =
        found_in(message, "is not found within [0-9]+ steps, from time " + number + " up to " + number, 2);
    facts.lies_above = found_in(message, R"(lies in \[)" + number);
    facts.lies_below = found_in(message, R"(lies in \[\S+, )" + number);
    if (const auto found = found_in(message, "([0-9]+) (?:were|was) found")) {
        facts.found = std::stol(*found);
    }
    facts.nothing_within = found_in(message, "no singularity within " + number);
    facts.radius_at_most = found_in(message, "at most " + number + " and at least " + number + ", both proved");
    facts.radius_at_least = found_in(message, R"(at most \S+ and at least )" + number + ", both proved");
    facts.touches = message.find("touches 0") != std::string::npos;
    facts.slides = message.find("solution slides along") != std::string::npos;
    return facts;
}

}  // namespace libration::attack
