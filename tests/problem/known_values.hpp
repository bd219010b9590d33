// Proved values of problems against values by hand, and reasons why there is no value.
#pragma once

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/problem/solution.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration::tests {

struct known_case {
    std::string text;
    std::string time;
    std::string name;
    mpfr value;
};

// Whether a proved decimal of 20 digits is within one unit of its last digit of the value; 0 is printed as 0.
inline void check_values(const std::vector<known_case>& all) {
    for (const known_case& each : all) {
        INFO(each.text << " at " << each.time << ": " << each.name);
        const answer found = solve(problem(each.text))->states(each.time, proved_digits(20));
        CHECK(abs(mpfr(mpfr(found.at(0, each.name)) - each.value)) <= abs(each.value) * pow(mpfr(10), -19));
    }
}

// Why there is no value; empty if there is one.
inline std::string refusal(const std::string& text, const std::string& time) {
    try {
        const answer found = solve(problem(text))->states(time, proved_digits(10));
        return found.missing ? found.missing->what() : "";
    } catch (const error& none) {
        return none.what();
    }
}

}  // namespace libration::tests
