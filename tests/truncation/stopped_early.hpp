// A truncation stopped long before the precision requires it, so that only its bound makes the ball an enclosure.
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

/// Many more digits than any truncation here attains: the radius is the bound, without visible rounding.
inline constexpr long many_digits = 150;

/// The ratio of the bound to the truncation error: the radius over the distance of the midpoint from the true value,
/// which the ball must contain.
inline double times_wider(const ball& stopped, const ball& truth) {
    INFO(text_of(stopped) << " for " << text_of(truth));
    REQUIRE(is_finite(stopped));
    CHECK(contains(stopped, truth));
    const ball left_out = abs(ball(midpoint(stopped) - truth));
    REQUIRE_FALSE(contains_zero(left_out));
    return midpoint_of(ball(radius_of(stopped) / left_out)).convert_to<double>();
}

/// Factors within 2 percent of the expected ones: a halved bound, or one of another power, has different factors.
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
