// Taylor models against the functions that they stand for, at points of the box, in exact arithmetic and in balls.
#include "libration/integration/model/taylor_model.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "corner_numbers.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/integration/model/lifted_models.hpp"
#include "libration/integration/model/model_range.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proved.hpp"

namespace integration_model_taylor_model_test {

using namespace libration;
using namespace libration::ode;
using tests::text_of;

namespace {

constexpr long digits_of_values = 1'200;

ball exactly(double x) {
    ball result;
    arf_set_d(arb_midref(result.handle()), x);
    return result;
}

// x(a): the polynomial and the rest.
ball value_at(const taylor_model& of, const std::vector<ball>& a) {
    ball sum(0);
    if (!of.size().is_finite()) {
        arb_zero_pm_inf(sum.handle());
        return sum;
    }
    for (std::size_t i = 0; i < of.in().size(); ++i) {
        ball term = exactly(of.coefficient(i));
        for (std::size_t j = 0; j < a.size(); ++j) {
            term *= pow(a[j], static_cast<long>(of.in().exponents(i)[j]));
        }
        sum += term;
    }
    return widened(sum, of.rest());
}

// A corner of the box, or a dyadic point in it.
std::vector<ball> point_in(tests::corner_numbers& from, std::size_t variables) {
    std::vector<ball> a;
    for (std::size_t j = 0; j < variables; ++j) {
        a.push_back(from.half([&] { return ball(from.one_in(2) ? 1 : -1); },
                              [&] { return exact_multiple(ball(from.between(-1024, 1024)), 1, -10); }));
    }
    return a;
}

// Coefficients of all ones, powers of two and others, mostly near 1, sometimes near the ends of double.
taylor_model model_from(tests::corner_numbers& from, const monomial_set& in) {
    const long far = from.one_in(4) ? 700 : 4;
    std::vector<ball> linear;
    for (std::size_t j = 0; j < in.variables(); ++j) {
        linear.push_back(from.exact(53, far));
    }
    return {in, from.wide(53, far), linear};
}

// A value that has left the range of double is enclosed by all numbers.
void check_contains(const taylor_model& found, const std::vector<ball>& a, const ball& value) {
    if (!is_finite(value)) {
        return;
    }
    const ball here = value_at(found, a);
    INFO(text_of(here) << " should contain " << text_of(value));
    CHECK(contains(here, value));
    CHECK(contains(found.range(), value));
}

ball member_at(tests::corner_numbers& from, const taylor_model& of, const std::vector<ball>& a) {
    return from.member(value_at(of, a));
}

}  // namespace

TEST_CASE("Taylor models contain the results of their operations", "[ode][proved][sets][models]") {
    const precision_scope scope(digits_of_values);
    tests::corner_numbers from(1);
    for (int trial = 0; trial < 200; ++trial) {
        const monomial_set in(static_cast<std::size_t>(from.between(1, 3)), static_cast<int>(from.between(2, 5)));
        taylor_model x = model_from(from, in);
        taylor_model y = model_from(from, in);
        for (int times = static_cast<int>(from.between(0, 2)); times > 0; --times) {
            x = product_coefficient({x}, {y}, 0);
        }
        const std::vector<ball> a = point_in(from, in.variables());
        const ball u = member_at(from, x, a);
        const ball v = member_at(from, y, a);
        const ball factor = from.wide(53, 4);
        const ball f = from.member(factor);
        check_contains(x + y, a, u + v);
        check_contains(x - y, a, u - v);
        check_contains(factor * x, a, f * u);
        check_contains(x + factor, a, u + f);
        check_contains(product_coefficient({x, y}, {y, x}, 1), a, u * u + v * v);
        check_contains(product_coefficient({x}, {y}, 0), a, u * v);
        check_contains(linear_combination({factor, ball(1)}, {x, y}), a, f * u + v);
        check_contains(x.truncated(monomial_set(in.variables(), 1)), a, u);
        CHECK_FALSE(x.size() < magnitude::below(u));
    }
}

TEST_CASE("products of Taylor models below the range of double are in their rests", "[ode][proved][sets][models]") {
    const precision_scope scope(digits_of_values);
    const monomial_set in(1, 2);
    const ball small = exact_multiple(ball(1), 1, -600);
    const taylor_model x(in, small, std::vector<ball>{small});
    check_contains(product_coefficient({x}, {x}, 0), {ball(1)}, small * small * 4);
    check_contains(small * x, {ball(1)}, small * small * 2);
}

TEST_CASE("a Taylor model on half of its box", "[ode][proved][sets][models]") {
    const precision_scope scope(digits_of_values);
    tests::corner_numbers from(2);
    for (int trial = 0; trial < 100; ++trial) {
        const monomial_set in(2, 6);
        taylor_model x = model_from(from, in);
        for (int times = 0; times < 3; ++times) {
            x = product_coefficient({x}, {model_from(from, in)}, 0);
        }
        const std::vector<ball> b = point_in(from, 2);
        for (const bool upper : {false, true}) {
            std::vector<ball> a = b;
            a[1] = (b[1] + (upper ? 1 : -1)) / 2;
            const ball value = member_at(from, x, a);
            check_contains(x.on_half(1, upper), b, value);
        }
    }
}

TEST_CASE("rests of exact operations are rounding errors", "[ode][proved][sets][models]") {
    const precision_scope scope(50);
    const monomial_set in(2, 4);
    const taylor_model x(in, ball(1), std::vector<ball>{ball(1), ball(2)});
    const taylor_model square = product_coefficient({x}, {x}, 0);
    CHECK(square.rest() <= magnitude::of(1, -40));
    CHECK(square.coefficient(in.products_of(1)[2]) == 4);  // a_1 a_2
    // A term beyond the degree is in the rest.
    const taylor_model power = product_coefficient({square}, {product_coefficient({square}, {x}, 0)}, 0);
    CHECK(power.rest() <= magnitude(243U + 1));
    CHECK(magnitude(1U) <= power.rest());
    CHECK(monomial_set::of_cost(7, 40'000).degree() == 6);
    CHECK(monomial_set::of_cost(32, 40).degree() == 2);
}

TEST_CASE("the range of a polynomial is found by halving", "[ode][proved][sets][models]") {
    const precision_scope scope(50);
    const monomial_set in(2, 4);
    const taylor_model a(in, ball(0), std::vector<ball>{ball(1), ball(0)});
    const taylor_model b(in, ball(0), std::vector<ball>{ball(0), ball(1)});
    const auto check = [](const taylor_model& of, const rational& lower, const rational& upper) {
        const ball found = narrow_range(of, -12, std::nullopt);
        const ball tolerance = exact_multiple(ball(1), 1, -9);
        CHECK_FALSE(certainly_less(from_rational<ball>(lower), lower_bound(found)));
        CHECK_FALSE(certainly_less(upper_bound(found), from_rational<ball>(upper)));
        CHECK(certainly_less(from_rational<ball>(lower) - tolerance, lower_bound(found)));
        CHECK(certainly_less(upper_bound(found), from_rational<ball>(upper) + tolerance));
    };
    check(product_coefficient({a}, {a}, 0) - a, rational(-1, 4), rational(2));
    check(a - product_coefficient({a}, {a}, 0), rational(-2), rational(1, 4));
    // (a + b)^2 - 2 a b = a^2 + b^2; a b + a.
    check(product_coefficient({a, b}, {b, a}, 1), rational(0), rational(2));
    check(product_coefficient({a}, {b}, 0) + a, rational(-2), rational(2));
}

TEST_CASE("a bound of a range that is narrow enough is not improved", "[ode][proved][sets][models]") {
    const precision_scope scope(50);
    const monomial_set in(1, 4);
    const taylor_model a(in, ball(0), std::vector<ball>{ball(1)});
    const taylor_model of = product_coefficient({a}, {a}, 0) - a;  // from -1/4 to 2, at first from -1 to 2
    const ball tolerance = exact_multiple(ball(1), 1, -9);
    const auto lower_of = [&](const ball& enough) {
        const ball found = narrow_range(of, -12, enough_bounds{enough, ball(0)});
        CHECK_FALSE(certainly_less(upper_bound(found), ball(2)));  // beyond what is enough, hence attained
        CHECK(certainly_less(upper_bound(found), ball(2) + tolerance));
        CHECK_FALSE(certainly_less(-ball(1) / 4, lower_bound(found)));
        return lower_bound(found);
    };
    CHECK(certainly_less(lower_of(ball(-2)), ball(-1) + tolerance));
    const ball half = lower_of(-ball(1) / 2);
    CHECK_FALSE(certainly_less(half, -ball(1) / 2));
    CHECK(certainly_less(-ball(1) / 4 - tolerance, lower_of(ball(0))));
}

TEST_CASE("functions of Taylor models", "[ode][proved][sets][models]") {
    const precision_scope scope(40);
    tests::corner_numbers from(3);
    const explicit_system system(
        parse("x' = sin(x) + exp(x*y) + 1/(2 + x) + sqrt(3 + y) + log(2 + x)*cos(t); y' = 0; x(1) = 0; y(1) = 0"));
    const polynomial_form form = lifted(system);
    for (const long width : {1, 3}) {
        const monomial_set in(2, 12);
        const ball half = ball(width) / 4;
        const std::vector<taylor_model> given{{in, ball(0), std::vector<ball>{half, ball(0)}},
                                              {in, ball(1), std::vector<ball>{ball(0), half}}};
        const auto found = lifted_models(form, given);
        REQUIRE(found);
        REQUIRE(found->size() == form.leaves.size());
        for (int trial = 0; trial < 20; ++trial) {
            const std::vector<ball> a = point_in(from, 2);
            const auto values = lifted_values(form, ball(1), {half * a[0], ball(1) + half * a[1]});
            for (std::size_t i = 0; i < values.size(); ++i) {
                const ball here = value_at((*found)[i], a);
                INFO(i << ": " << text_of(here) << " should contain " << text_of(values[i]));
                CHECK(contains(here, values[i]));
                CHECK((*found)[i].rest() <= magnitude::of(1, width == 1 ? -16 : -3));
            }
        }
    }
    // Powers beyond those of the path: 1/(2 + 0.45 a) has the coefficient 0.5 (0.225)^17 = 2^-37.6 of a^17.
    const monomial_set many(1, 20);
    const polynomial_form inverse = lifted(explicit_system(parse("x' = 1/(2 + x); x(0) = 0")));
    const auto far = lifted_models(inverse, {{many, ball(0), std::vector<ball>{ball(9) / 20}}});
    REQUIRE(far);
    for (const long end : {-1, 1}) {
        CHECK(contains(value_at(far->back(), {ball(end)}), ball(1) / (ball(2) + ball(9 * end) / 20)));
    }
    // 1/(x + 2) is singular on the way.
    const monomial_set in(2, 4);
    CHECK_FALSE(lifted_models(form, {{in, ball(0), std::vector<ball>{ball(3), ball(0)}}, {in, ball(1)}}));
}

// c a^16 with c = 3/2 2^-1058: c/2^16 is half-way between two of the least doubles, and (b + 1)^16 is 2^16 at b = 1.
TEST_CASE("an underflow on half of a box is multiplied by the coefficients of a power", "[ode][proved][sets][models]") {
    const precision_scope scope(digits_of_values);
    const monomial_set in(1, 16);
    taylor_model power(in, ball(0), std::vector<ball>{ball(1)});
    for (int doublings = 0; doublings < 4; ++doublings) {
        power = product_coefficient({power}, {power}, 0);
    }
    const ball c = exact_multiple(ball(3), 1, -1059);
    check_contains((c * power).on_half(0, true), {ball(1)}, c);
    check_contains((c * power).on_half(0, false), {ball(-1)}, c);
}

}  // namespace integration_model_taylor_model_test
