#include "libration/convergence/recurrence_fit.hpp"

#include <catch2/catch.hpp>

#include "convergence/singular_series.hpp"
#include "scalars.hpp"

namespace convergence_recurrence_fit_test {

using namespace libration;
using namespace libration::series;
using namespace libration::convergence;
using namespace libration::tests;

TEST_CASE("a fitted recurrence is the one that made the coefficients", "[convergence][recurrence_fit]") {
    const precision_scope scope(60);
    // Poles at 5/4, -2, 3: Q = (1 - 4w/5)(1 + w/2)(1 - w/3).
    const auto poles = fitting::widened(strided_series<mpfr>(three_poles<mpfr>(20), 0, 1));
    const auto q = fitting::fit_recurrence(poles, {0, 0}, 3, 20);
    REQUIRE(q);
    // Differences of coefficients that are R^20 apart lose 3^20, 10 digits.
    const long lost = 1L << 40;
    CHECK_THAT(q->top[1], near(mpfr(mpfr(-19) / 30), lost));
    CHECK_THAT(q->top[2], near(mpfr(mpfr(-3) / 10), lost));
    CHECK_THAT(q->top[3], near(mpfr(mpfr(2) / 15), lost));
    // One degree too many is not determined.
    CHECK_FALSE(fitting::fit_recurrence(poles, {0, 0}, 4, 20));
    // (1 - x)^nu + x^2: n a_n = (n - 1 - nu) a_{n-1}, so Q_1 = 1 - w and Q_0 = nu w.
    const mpfr nu = mpfr(1) / 3;
    const auto power = fitting::widened(strided_series<mpfr>(power_at<mpfr>(mpfr(1), nu, 30), 0, 1));
    const auto first_order = fitting::fit_recurrence(power, {0, 1}, 1, 30);
    REQUIRE(first_order);
    CHECK_THAT(first_order->top[1], near(mpfr(-1), 100000));
    CHECK_THAT(first_order->below[0], near(mpfr(0), 10000000, mpfr(1)));
    CHECK_THAT(first_order->below[1], near(nu, 10000000));
}

TEST_CASE("lists of different lengths have the recurrences that each has alone", "[convergence][recurrence_fit]") {
    const precision_scope scope(60);
    fitting::wide_series list{{}, 0, 1};
    for (int n = 0; n <= 60; ++n) {
        list.c.push_back(cos(mpfr(n * n)));  // which no recurrence makes
    }
    const recurrence_form form{0, 2};
    constexpr int degree = 3;
    const std::vector<int> lasts{60, 59, 58, 57, 53, 46};
    const auto together = fitting::recurrence_fits(list, form).up_to(lasts, degree);
    REQUIRE(together);
    REQUIRE(together->size() == lasts.size());
    for (std::size_t i = 0; i < lasts.size(); ++i) {
        // Alone in solve_linear, by the definition: sum of q_ij n^i c over j and i is 0, the first q of n^2 being 1.
        std::vector<std::vector<mpfr>> a;
        std::vector<mpfr> b;
        for (int k = lasts[i] - 10; k <= lasts[i]; ++k) {
            std::vector<mpfr> row;
            for (int j = 0; j <= degree; ++j) {
                for (int power = 0; power <= 2; ++power) {
                    const mpfr term = list.c[static_cast<std::size_t>(k - j)] * pow(mpfr(mpfr(k - j) / 60), power);
                    (j == 0 && power == 2) ? b.push_back(-term) : row.push_back(term);
                }
            }
            a.push_back(row);
        }
        const auto alone = solve_linear(std::move(a), std::move(b), mpfr(epsilon<mpfr>() * 100));
        REQUIRE(alone);
        // The 11 unknowns are determined to half of the 60 digits.
        CHECK_THAT((*together)[i].top[1], near((*alone)[4], 1L << 62));
        CHECK_THAT((*together)[i].below[0], near(mpfr((*alone)[1] * 60), 1L << 62));
    }
}

TEST_CASE("a recurrence counts its unknowns and the coefficients it takes", "[convergence][recurrence_fit]") {
    CHECK(unknowns_of({0, 0}, 8) == 8);
    CHECK(unknowns_of({1, 1}, 8) == 8);
    CHECK(unknowns_of({0, 1}, 8) == 17);
    CHECK(unknowns_of({0, 2}, 8) == 26);
    CHECK(coefficients_needed({0, 0}, 1) == 6);
    CHECK(coefficients_needed({0, 1}, 1) == 8);
}

}  // namespace convergence_recurrence_fit_test
