// Many random solutions with events and piecewise right-hand sides against closed forms: no proved statement is false.
#include <catch2/catch.hpp>
#include <random>
#include <string>

#include "libration/problem/solution.hpp"
#include "libration/scalar/mpfr.hpp"

namespace problem_hybrid_attack_test {

using namespace libration;

namespace {

constexpr int cases_of_each_kind = 12;

// Fractions with few digits, as text and as numbers, reproducible.
class random_fractions {
public:
    struct fraction {
        std::string text;
        mpfr value;
    };
    // a/b with least <= a/b <= most.
    fraction between(long least, long most) {
        const long denominator = std::uniform_int_distribution<long>(1, 97)(engine_);
        const long numerator = std::uniform_int_distribution<long>(least * denominator, most * denominator)(engine_);
        return {std::to_string(numerator) + "/" + std::to_string(denominator), mpfr(numerator) / denominator};
    }
    long whole(long least, long most) { return std::uniform_int_distribution<long>(least, most)(engine_); }
    long digits() { return whole(3, 40); }

private:
    std::mt19937_64 engine_{20260101};
};

// |exact - decimal| is at most the printed bound; "0" for an exact 0 has the bound 0.
void check_true(const answer_value& proved, const mpfr& exact) {
    INFO(proved.text << " +- " << proved.bound << ", exact " << exact.str(50));
    REQUIRE_FALSE(proved.text.empty());
    const mpfr bound(proved.bound.empty() ? "0" : proved.bound);
    // The closed form has 90 digits, with an error far below any bound of 40 digits.
    CHECK(abs(mpfr(mpfr(proved.text) - exact)) <= bound + abs(exact) * pow(mpfr(10), -80));
}

answer_value value_at(const std::string& text, const std::string& time, const std::string& name, long digits) {
    INFO(text << " at " << time);
    const answer found = solve(problem(text))->states(time, proved_digits(digits));
    REQUIRE_FALSE(found.missing);
    for (std::size_t k = 0; k < found.names.size(); ++k) {
        if (found.names[k] == name) {
            return found.rows[0][k];
        }
    }
    return {};
}

}  // namespace

TEST_CASE("random bouncing balls", "[problem][hybrid][attack]") {
    const precision_scope scope(90);
    random_fractions any;
    for (int i = 0; i < cases_of_each_kind; ++i) {
        const auto g = any.between(1, 20);
        const auto h = any.between(1, 50);
        const long tenths = any.whole(3, 9);
        const long bounce = any.whole(1, 12);
        const std::string text = "y'' = -" + g.text + "; y(0) = " + h.text + "; y'(0) = 0; when y = 0 down: y' = -" +
                                 std::to_string(tenths) + "/10*y'";
        INFO(text << ", bounce " << bounce);
        const mpfr k = mpfr(tenths) / 10;
        const mpfr first = sqrt(mpfr(2 * h.value / g.value));
        const mpfr time = first * (1 + 2 * k * (1 - pow(k, bounce - 1)) / (1 - k));
        const answer found = solve(problem(text))->events("y = 0", bounce, proved_digits(any.digits()));
        REQUIRE_FALSE(found.missing);
        check_true(found.rows.back()[0], time);
        check_true(found.rows.back()[2], mpfr(-g.value * first * pow(k, bounce - 1)));
    }
}

TEST_CASE("random doses at known times, and thresholds", "[problem][hybrid][attack]") {
    const precision_scope scope(90);
    random_fractions any;
    for (int i = 0; i < cases_of_each_kind; ++i) {
        const auto rate = any.between(1, 3);
        const auto dose = any.between(1, 5);
        const auto when = any.between(1, 3);
        const std::string text =
            "x' = -" + rate.text + "*x; x(0) = 1; when t = " + when.text + ": x = x + " + dose.text;
        check_true(value_at(text, "4", "x", any.digits()),
                   mpfr(exp(mpfr(-4 * rate.value)) + dose.value * exp(mpfr(-rate.value * (4 - when.value)))));
        // Integrate and fire: x = c (1 - exp(-r t)) up to 1, c > 1.
        const auto more = any.between(1, 4);
        const std::string neuron = "x' = " + rate.text + "*(1 + " + more.text + " - x); x(0) = 0; when x = 1 up: x = 0";
        const mpfr c = 1 + more.value;
        const mpfr period = log(mpfr(c / (c - 1))) / rate.value;
        const mpfr count = floor(mpfr(2 / period));
        check_true(value_at(neuron, "2", "x", any.digits()),
                   mpfr(c * (1 - exp(mpfr(-rate.value * (2 - count * period))))));
    }
}

TEST_CASE("random switching by the state and by time", "[problem][hybrid][attack]") {
    const precision_scope scope(90);
    random_fractions any;
    for (int i = 0; i < cases_of_each_kind; ++i) {
        const auto a = any.between(1, 5);
        const auto b = any.between(1, 5);
        const auto level = any.between(1, 3);
        // x' = a below the level and b x/level above it.
        const std::string text =
            "x' = if(x < " + level.text + ", " + a.text + ", " + b.text + "*x/(" + level.text + ")); x(0) = 0";
        const mpfr reached = level.value / a.value;
        const mpfr at = 4;
        check_true(
            value_at(text, "4", "x", any.digits()),
            at < reached ? mpfr(a.value * at) : mpfr(level.value * exp(mpfr(b.value / level.value * (at - reached)))));
        // A relay: y'' = -f sign(y), parabolas between the zeros, with the period 4 sqrt(2 h/f).
        const std::string relay = "y'' = -" + a.text + "*sign(y); y(0) = " + b.text + "; y'(0) = 0";
        const mpfr quarter = sqrt(mpfr(2 * b.value / a.value));
        const mpfr turns = floor(mpfr((5 + quarter) / (2 * quarter)));  // extrema before time 5, from the nearest
        const mpfr rest = 5 - turns * 2 * quarter;
        const mpfr sign = mpfr(turns / 2) == floor(mpfr(turns / 2)) ? mpfr(1) : mpfr(-1);
        check_true(value_at(relay, "5", "y", any.digits()), mpfr(sign * (b.value - a.value * rest * rest / 2)));
    }
}

TEST_CASE("random steps of time", "[problem][hybrid][attack]") {
    const precision_scope scope(90);
    random_fractions any;
    for (int i = 0; i < cases_of_each_kind; ++i) {
        const auto slope = any.between(1, 4);
        const auto end = any.between(1, 5);
        // The integral of floor(s t): n(n - 1)/2 full steps of 1/s, and the rest.
        const mpfr n = floor(mpfr(slope.value * end.value));
        const std::string text = "x' = floor(" + slope.text + "*t); x(0) = 1";
        check_true(value_at(text, end.text, "x", any.digits()),
                   mpfr(1 + n * (n - 1) / 2 / slope.value + n * (end.value - n / slope.value)));
        // The integral of a square wave of period 2 pi/s is a triangle.
        const mpfr phase = slope.value * end.value / pi<mpfr>();
        const mpfr half = floor(phase);
        const mpfr part = phase - half;
        const bool even = mpfr(half / 2) == floor(mpfr(half / 2));
        const std::string wave = "x' = square(" + slope.text + "*t); x(0) = 1";
        check_true(value_at(wave, end.text, "x", any.digits()),
                   mpfr(1 + (even ? part : mpfr(1 - part)) * pi<mpfr>() / slope.value));
    }
}

}  // namespace problem_hybrid_attack_test
