// The matcher for proved scalars: a ball has to contain the truth, and to be narrow enough to be of use.
#pragma once

#include <catch2/catch.hpp>
#include <string>
#include <utility>

#include "libration/scalar/ball/ball.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/printed_number.hpp"
#include "scalars.hpp"

namespace libration::tests {

inline std::string text_of(const ball& x) {
    return is_finite(x) ? to_decimal(midpoint_of(x), 60) + " +/- " + to_decimal(midpoint_of(radius_of(x)), 3)
                        : "all numbers";
}

/// The printed decimal is less than one unit of its last digit away from the number.
inline bool within_a_unit(const proved_decimal& printed, const ball& number, long digits) {
    const precision_scope scope(digits + 30);
    mpfr value;
    mpfr_set_str(handle(value), printed.text.c_str(), 10, MPFR_RNDN);
    return certainly_less(abs(ball(value) - number), abs(number) * pow(ball(10), 1 - digits));
}

/// The ball contains the expected value, up to the uncertainty of that one, and its radius is at most ulps * epsilon *
/// scale; scale is |expected| unless given.
class encloses_matcher : public Catch::MatcherBase<ball> {
public:
    encloses_matcher(expected_value expected, long ulps, const std::optional<mpfr>& scale)
        : expected_(std::move(expected)) {
        const mpfr size = scale ? *scale : expected_.value;
        allowed_ = abs(ball(size) * epsilon<ball>() * ulps);
    }
    bool match(const ball& actual) const override {
        const precision_scope scope(220);
        return contains(enclose(actual, ball(expected_.uncertainty)), ball(expected_.value)) &&
               !certainly_less(allowed_, radius_of(actual));
    }
    std::string describe() const override {
        return "contains " + to_decimal(expected_.value, 60) + " with a radius of at most " +
               to_decimal(midpoint_of(allowed_), 3);
    }

private:
    expected_value expected_;
    ball allowed_;
};

inline encloses_matcher encloses(const expected_value& expected, long ulps) { return {expected, ulps, std::nullopt}; }
template <class S>
encloses_matcher encloses(const expected_value& expected, long ulps, const S& scale) {
    return {expected, ulps, widen(scale)};
}

}  // namespace libration::tests

namespace Catch {
template <>
struct StringMaker<libration::ball> {
    static std::string convert(const libration::ball& x) { return libration::tests::text_of(x); }
};
}  // namespace Catch
