#include "libration/approximant/pade_error.hpp"

#include "proved.hpp"

namespace approximant_pade_error_test {

using namespace libration;
using namespace libration::series;

namespace {

power_series<ball> series_of(const std::vector<long>& coefficients) {
    std::vector<ball> balls;
    balls.reserve(coefficients.size());
    for (const long c : coefficients) {
        balls.emplace_back(c);
    }
    return power_series<ball>(std::move(balls));
}

// A polynomial in s, without a tail.
enclosed_panel exact_panel(const std::vector<long>& coefficients, const rational& from = -1, const rational& to = 1) {
    return {series_of(coefficients), ball(0), ball(1) / 4, from, to};
}

ball fraction(long above, long below) { return ball(above) / below; }

// Contains the truth, with a radius of at most 2^-bits.
void check_encloses(const ball& found, const ball& truth, long bits) {
    INFO(tests::text_of(found));
    CHECK(overlaps(found, truth));
    CHECK(certainly_less(radius_of(found), ldexp(ball(1), -bits)));
}

}  // namespace

TEST_CASE("the largest value inside is enclosed with its place", "[proved_maximum]") {
    const precision_scope scope(50);
    // (1+s)^2 (1-s) = 1 + s - s^2 - s^3 has 32/27 at 1/3, which is 2 on [0, 3].
    const auto found = largest_magnitude({exact_panel({1, 1, -1, -1}, 0, 3)});
    // Horner's rule rounds four times, and the halvings add nothing.
    check_encloses(found.value, fraction(32, 27), digits<ball>() - 6);
    // f' is 0 within its rounding, |f''| is 4 there.
    check_encloses(found.place, ball(2), digits<ball>() - 8);
}

TEST_CASE("a piece is not left out by digits that its coefficients lose in few of them", "[proved_maximum]") {
    const precision_scope scope(50);
    // 1 + e + e (s - s^3)/4, e = 2^-80: at the ends and in the middle 1 + e, at 1/sqrt(3) more by e/(6 sqrt(3)).
    const ball e = ldexp(ball(1), -80);
    const ball quarter = e / 4;
    const power_series<ball> f(std::vector<ball>{1 + e, quarter, ball(0), -quarter});
    const auto found = largest_magnitude({enclosed_panel(f, ball(0), ball(1) / 4, -1, 1)});
    check_encloses(found.value, 1 + e + e / (6 * sqrt(ball(3))), digits<ball>() - 6);
}

TEST_CASE("the largest value at an end is exact where the polynomial is", "[proved_maximum]") {
    const precision_scope scope(50);
    const auto found = largest_magnitude({exact_panel({2, 1})});
    CHECK(contains(found.value, ball(3)));
    CHECK(contains(found.place, ball(1)));
    CHECK(is_exact(found.place));
}

TEST_CASE("it is the magnitude that is sought", "[proved_maximum]") {
    const precision_scope scope(50);
    // -(1+s)^2 (1-s) + 1/2 from -1/2 - 32/54 ... : the least value counts.
    const auto found = largest_magnitude({exact_panel({-10, -8, 8, 8}, -1, 1)});
    // -8 (1 + s - s^2 - s^3) - 2 = -8*32/27 - 2.
    check_encloses(found.value, fraction(310, 27), digits<ball>() - 10);
    check_encloses(found.place, fraction(1, 3), digits<ball>() - 10);
}

TEST_CASE("Chebyshev polynomials have magnitude 1, and no place for it", "[proved_maximum]") {
    const precision_scope scope(60);
    // T_(n+1) = 2 s T_n - T_(n-1).
    std::vector<long> before{1};
    std::vector<long> now{0, 1};
    for (int n = 1; n < 12; ++n) {
        std::vector<long> next(now.size() + 1, 0);
        for (std::size_t i = 0; i < now.size(); ++i) {
            next[i + 1] = 2 * now[i];
        }
        for (std::size_t i = 0; i < before.size(); ++i) {
            next[i] -= before[i];
        }
        before = std::exchange(now, next);
    }
    const auto found = largest_magnitude({exact_panel(now)});
    // The coefficients of T_12 are up to 6912 = 2^12.8.
    check_encloses(found.value, ball(1), digits<ball>() - 20);
    CHECK(contains(found.place, ball(1)));
    CHECK(contains(found.place, ball(-1)));
}

TEST_CASE("panels are searched together", "[proved_maximum]") {
    const precision_scope scope(40);
    // x (3 - x) on [0, 3] in three panels, x = i + 1/2 + s/2: four times it is 5 + 4s - s^2, 9 - s^2, 5 - 4s - s^2.
    const auto found = largest_magnitude(
        {exact_panel({5, 4, -1}, 0, 1), exact_panel({9, 0, -1}, 1, 2), exact_panel({5, -4, -1}, 2, 3)});
    check_encloses(found.value, ball(9), digits<ball>() - 8);
    check_encloses(found.place, fraction(3, 2), digits<ball>() - 8);
}

TEST_CASE("what a tail may add is in the enclosure", "[proved_maximum]") {
    const precision_scope scope(40);
    // 1/(1 - s/4) = sum (s/4)^n cut after n = 10; its largest value is 4/3 at 1, its tail there 4^-11 4/3.
    power_series<ball> kept(std::vector<ball>{ball(1)});
    for (int n = 1; n <= 10; ++n) {
        kept.push_back(ldexp(ball(1), -2 * n));
    }
    const auto found = largest_magnitude({enclosed_panel(kept, ball(1), ball(1) / 4, -1, 1)});
    check_encloses(found.value, fraction(4, 3), 20);
    CHECK_FALSE(contains(evaluate_value(kept, ball(1)), ball(4) / 3));
    const auto jet = enclosed_panel(kept, ball(1), ball(1) / 4, -1, 1).at(ball(1));
    // The derivatives of 1/(1 - s/4) at 1 are (1/4)/(3/4)^2 = 4/9 and 2 (1/16)/(3/4)^3 = 8/27.
    CHECK(overlaps(jet.slope, fraction(4, 9)));
    CHECK(overlaps(jet.curvature, fraction(8, 27)));
    // Without the tail they are not those.
    const auto bare = enclosed_panel(kept, ball(0), ball(1) / 4, -1, 1).at(ball(1));
    CHECK_FALSE(overlaps(bare.slope, fraction(4, 9)));
    CHECK_FALSE(overlaps(bare.curvature, fraction(8, 27)));
}

TEST_CASE("what cannot be parted is refused", "[proved_maximum]") {
    const precision_scope scope(20);
    CHECK_THROWS_AS(largest_magnitude({exact_panel({0})}), precision_exhausted);
    CHECK_THROWS_AS(enclosed_panel(series_of({1}), ball(1), ball(1), -1, 1), precision_exhausted);
}

}  // namespace approximant_pade_error_test
