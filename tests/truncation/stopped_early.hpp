// A truncation stopped long before the precision would stop it, so that its bound alone is what keeps the ball a proof.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "libration/scalar/ball/ball.hpp"
#include "proved.hpp"

namespace libration::tests {

/// Many more digits than any truncation here leaves: what is seen of a radius is the bound, and no rounding.
inline constexpr long many_digits = 150;

/// How many times wider than what was left out the bound is: the radius over the distance of the midpoint from the
/// truth, which the ball has to hold.
inline double times_wider(const ball& stopped, const ball& truth) {
    INFO(text_of(stopped) << " for " << text_of(truth));
    REQUIRE(is_finite(stopped));
    CHECK(contains(stopped, truth));
    const ball left_out = abs(ball(midpoint(stopped) - truth));
    REQUIRE_FALSE(contains_zero(left_out));
    return midpoint_of(ball(radius_of(stopped) / left_out)).convert_to<double>();
}

/// Factors within 2 percent of the expected ones: a bound that was halved, or is of another power, has others.
class factors_matcher : public Catch::MatcherBase<std::vector<double>> {
public:
    explicit factors_matcher(std::vector<double> expected) : expected_(std::move(expected)) {}
    bool match(const std::vector<double>& found) const override {
        return std::equal(found.begin(), found.end(), expected_.begin(), expected_.end(),
                          [](double a, double b) { return std::fabs(a - b) <= b / 50; });
    }
    std::string describe() const override {
        std::ostringstream text;
        text << "are within 2 percent of";
        for (const double each : expected_) {
            text << " " << each;
        }
        return text.str();
    }

private:
    std::vector<double> expected_;
};

inline factors_matcher are_factors(std::vector<double> expected) { return factors_matcher(std::move(expected)); }

}  // namespace libration::tests
