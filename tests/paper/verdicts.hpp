// What a test says of a claim: the verdict, and the range its number lies in.
#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "libration/number/exact.hpp"
#include "paper/judged.hpp"
#include "scalars.hpp"

namespace libration::tests {

/// Checks the verdict of a claim and low <= number <= high (decimals).
inline void check_claim(const std::string& name, verdict expected, const std::string& low, const std::string& high) {
    const finding found = measured(name);
    const precision_scope precision(60);
    INFO(name << ": " << to_decimal(found.number, 20));
    CHECK(name_of(found.verdict) == name_of(expected));
    CHECK(found.number >= from_exact<mpfr>(read_exact(low)));
    CHECK(found.number <= from_exact<mpfr>(read_exact(high)));
}

/// An identity that holds: its error is below 1e-40, ten digits of fifty being what a measurement may lose.
inline void check_identity(const std::string& name) { check_claim(name, verdict::holds, "0", "1e-40"); }

/// A number known by other means to `digits` digits: the claim has it within a unit in the last.
inline void check_number(const std::string& name, verdict expected, const std::string& known) {
    const finding found = measured(name);
    CHECK(name_of(found.verdict) == name_of(expected));
    CHECK_THAT(found.number, near<mpfr>(decimal(known), 0));
}

}  // namespace libration::tests
