// Derivatives of solutions with events by initial values and parameters, against closed forms computed here in mpfr.
#include <catch2/catch.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "libration/problem/solution.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/mpfr.hpp"

namespace query_hybrid_derivatives_test {

using namespace libration;

namespace {

constexpr long digits = 30;

// Values and derivatives at one time, by the names of their columns.
class differentiated {
public:
    differentiated(const std::string& text, const std::string& time, std::vector<std::string> by) {
        request how = proved_digits(digits);
        how.derivatives = std::move(by);
        found_ = solve(problem(text))->states(time, how);
    }

    mpfr value(const std::string& name) const { return mpfr(text(name)); }
    std::string text(const std::string& name) const {
        INFO(name << (found_.missing ? found_.missing->what() : ""));
        return found_.at(0, name);
    }
    // Within one unit of the last digit. The exact value, of 80 digits, is a difference of numbers up to 10^10 of it.
    void check(const std::string& name, const mpfr& exact) const {
        INFO(name << " = " << text(name) << ", exact " << exact.str(40));
        CHECK(abs(mpfr(value(name) - exact)) <= abs(exact) * pow(mpfr(10), -(digits - 1)));
    }

private:
    answer found_;
};

std::string refused(const std::string& text, const std::string& by) {
    try {
        differentiated(text, "1", {by});
    } catch (const error& problem) {
        return problem.subject() + " " + problem.value() + " " + problem.reason();
    }
    return "";
}

// Bounce n is at T = tau (1 + 2 (k + ... + k^(n-1))) with the speed V = g tau k^n after it, tau = sqrt(2 h/g).
struct bounce {
    mpfr time, speed;  // T and V
    mpfr time_by_k, speed_by_k;

    bounce(const mpfr& g, const mpfr& h, const mpfr& k, int n) {
        const mpfr tau = sqrt(mpfr(2 * h / g));
        mpfr sum = 1;
        mpfr sum_by_k = 0;
        for (int i = 1; i < n; ++i) {
            sum += 2 * pow(k, i);
            sum_by_k += 2 * i * pow(k, i - 1);
        }
        time = tau * sum;
        time_by_k = tau * sum_by_k;
        speed = g * tau * pow(k, n);
        speed_by_k = g * tau * n * pow(k, n - 1);
    }
};

}  // namespace

// y = V (t - T) - g (t - T)^2/2 after a bounce. T is proportional to sqrt(h/g), V to sqrt(g h).
TEST_CASE("derivatives of a bouncing ball", "[problem][hybrid][derivatives]") {
    const precision_scope scope(80);
    const mpfr g = mpfr(981) / 100;
    const mpfr h = 10;
    for (const auto& [t, n, condition] :
         {std::tuple(5, 2, "y = 0 down"), std::tuple(11, 5, "y = 0 down"), std::tuple(5, 2, "y < 0 and y' < 0")}) {
        const std::string text = "y'' = -g; y(0) = h; y'(0) = 0; when " + std::string(condition) +
                                 ": y' = -k*y'; g = 981/100; h = 10; k = 9/10";
        const differentiated found(text, std::to_string(t), {"h", "g", "k", "y(0)"});
        const bounce of(g, h, mpfr(9) / 10, n);
        const mpfr s = t - of.time;
        const mpfr speed = of.speed - g * s;
        found.check("y", mpfr(of.speed * s - g * s * s / 2));
        const auto by = [&](const std::string& number, const mpfr& time, const mpfr& velocity, int of_g) {
            found.check("dy(t)/d" + number, mpfr(velocity * s - speed * time - of_g * s * s / 2));
            found.check("dy'(t)/d" + number, mpfr(velocity + g * time - of_g * s));
        };
        by("h", mpfr(of.time / (2 * h)), mpfr(of.speed / (2 * h)), 0);
        by("g", mpfr(-of.time / (2 * g)), mpfr(of.speed / (2 * g)), 1);
        by("k", of.time_by_k, of.speed_by_k, 0);
        CHECK(found.text("dy(t)/dy(0)") == found.text("dy(t)/dh"));
    }
}

// x'' = -sign x. By scaling x(t; a) = a X(t/sqrt a) from a at rest, so 2 a dx/da = 2 x - t x'; and the flow carries the
// velocity along: x'(t) = x'(0) dx/dx(0) + x''(0) dx/dx'(0).
TEST_CASE("derivatives of a relay oscillator", "[problem][hybrid][derivatives]") {
    const precision_scope scope(80);
    const differentiated found("x'' = -sign(x); x(0) = 2; x'(0) = 0", "31", {"x(0)", "x'(0)"});
    const mpfr x = found.value("x");
    const mpfr velocity = found.value("x'");
    const mpfr slope = x > 0 ? -1 : 1;
    // From x and x' of 30 digits, 30 times as large as the differences here at most.
    const auto near = [&](const std::string& name, const mpfr& exact) {
        INFO(name << " " << exact);
        CHECK(abs(mpfr(found.value(name) - exact)) <= 100 * pow(mpfr(10), -(digits - 1)));
    };
    near("dx(t)/dx(0)", mpfr((2 * x - 31 * velocity) / 4));
    near("dx'(t)/dx(0)", mpfr((velocity - 31 * slope) / 4));
    near("dx(t)/dx'(0)", mpfr(-velocity));
    near("dx'(t)/dx'(0)", mpfr(-slope));
}

TEST_CASE("derivatives by the time of an event, its level and the branches", "[problem][hybrid][derivatives]") {
    const precision_scope scope(80);
    // x = t up to T, then T^2 + t - T.
    const differentiated timed("x' = 1; x(0) = 0; when t = T: x = x^2; T = 2", "3", {"T", "x(0)"});
    timed.check("dx(t)/dT", 3);
    timed.check("dx(t)/dx(0)", 4);
    // x = e^t/L^n after n resets from L to 1.
    const differentiated spikes("x' = x; x(0) = 1; when x = L up: x = 1; L = 2", "3", {"L", "x(0)"});
    spikes.check("x", mpfr(exp(mpfr(3)) / 16));
    spikes.check("dx(t)/dL", mpfr(-exp(mpfr(3)) / 8));
    spikes.check("dx(t)/dx(0)", mpfr(exp(mpfr(3)) / 16));
    // x = p + t^2/2 up to 2 at u = sqrt(4 - 2 p), then 2 u + (t^2 - u^2)/2.
    const differentiated clocked("x' = t; x(0) = p; when x = 2 up: x = t*x; p = 1", "2", {"p"});
    clocked.check("dx(t)/dp", mpfr(1 - sqrt(mpfr(2))));
    // x = a t up to 1, then 1 + b (t - 1/a).
    const differentiated bent("x' = if(x < 1, a, b); x(0) = 0; a = 2; b = 3", "5", {"a", "b", "x(0)"});
    bent.check("dx(t)/da", mpfr(3) / 4);
    bent.check("dx(t)/db", mpfr(9) / 2);
    bent.check("dx(t)/dx(0)", mpfr(3) / 2);
    // At a known time: x = e^-t + d e^(1 - t).
    const differentiated dose("x' = -x; x(0) = 1; when t = 1: x = x + d; d = 2", "3", {"d", "x(0)"});
    dose.check("dx(t)/dd", mpfr(exp(mpfr(-2))));
    dose.check("dx(t)/dx(0)", mpfr(exp(mpfr(-3))));
}

TEST_CASE("an event makes an unknown depend on what it did not", "[problem][hybrid][derivatives]") {
    const precision_scope scope(80);
    // z = e^-t + e^(u - t), u = 1 - x(0) = 1.
    const std::string text = "x' = 1; z' = -z; w' = w; x(0) = 0; z(0) = 1; w(0) = 1; when x = 1: z = z + 1";
    const differentiated before(text, "1/2", {"x(0)", "w(0)"});
    CHECK(before.text("dz(t)/dx(0)") == "0");
    const differentiated after(text, "2", {"x(0)", "w(0)"});
    after.check("dz(t)/dx(0)", mpfr(-exp(mpfr(-1))));
    CHECK(after.text("dz(t)/dw(0)") == "0");
    CHECK(after.text("dw(t)/dx(0)") == "0");
    after.check("dw(t)/dw(0)", mpfr(exp(mpfr(2))));
    const differentiated combined("x' = 1; z' = -z; x(0) = 0; z(0) = 1; when x > 1 and t > 1/2: z = z + 1", "2",
                                  {"x(0)"});
    combined.check("dz(t)/dx(0)", mpfr(-exp(mpfr(-1))));
    // z = e^u for good.
    const differentiated kept("x' = 1; w' = w; z' = 0; x(0) = 0; w(0) = 1; z(0) = 0; when x = 1: z = w", "2", {"x(0)"});
    kept.check("dz(t)/dx(0)", mpfr(-exp(mpfr(1))));
    // z = u + 2 (t - u).
    const differentiated bent("x' = 1; z' = if(x < 1, 1, 2); x(0) = 0; z(0) = 0", "3", {"x(0)"});
    bent.check("dz(t)/dx(0)", 1);
}

TEST_CASE("a second proof of derivatives across events agrees", "[problem][hybrid][derivatives]") {
    request how = proved_digits(15);
    how.derivatives = {"x(0)"};
    how.check = true;
    const auto x = solve(problem("x'' = -sin(x); x(0) = 1; x'(0) = 0; when x = 0 down: x' = x'/2"));
    CHECK_FALSE(x->states("5", how).missing);
    how.scalar = {scalar_kind::arbitrary, 15};
    CHECK_THROWS_WITH(x->states("5", how), Catch::Contains("is for proved digits"));
}

// Just before the reset, x = 1 + p; just after it, x = 3: for p != 0 the time 1 is on one side of it or the other.
TEST_CASE("there is no derivative of a value at the time at which it jumps", "[problem][hybrid][derivatives]") {
    request how = proved_digits(10);
    how.derivatives = {"x(0)", "x'(0)"};
    const auto no_derivative = [](const answer& found, std::size_t column) {
        CHECK(found.rows[0][column].text.empty());
        CHECK(found.rows[0][column].bound.empty());
    };
    const answer jump = solve(problem("x' = 1; x(0) = 0; when x = 1: x = 3"))
                            ->states("1", {.scalar = how.scalar, .derivatives = {"x(0)"}});
    CHECK(jump.missing);
    no_derivative(jump, 1);
    // At sqrt 2 a relay switches: its velocity does not jump, but the derivative of the velocity does.
    const answer bend = solve(problem("x'' = -sign(x - 1); x(0) = 2; x'(0) = 0"))->states("sqrt(2)", how);
    REQUIRE(bend.missing);
    CHECK_THAT(bend.missing->what(), Catch::Contains("derivatives may not exist"));
    CHECK(bend.at(0, "x'").starts_with("-1.41421356"));
    CHECK(bend.at(0, "dx(t)/dx(0)") == "1.000000000");
    no_derivative(bend, 4);
}

TEST_CASE("derivatives that differ on two sides are rejected", "[problem][hybrid][derivatives]") {
    const std::string surface = "is not supported for a solution that begins on the surface of `";
    const std::string relay = "x'' = -sign(x); x(0) = 0; x'(0) = 1";
    CHECK_THAT(refused(relay, "x(0)"), Catch::Contains("derivatives x(0) " + surface + "sign(x)`"));
    CHECK(refused(relay, "x'(0)").empty());
    CHECK(refused("x'' = -sign(x); x(0) = 1e-50; x'(0) = 1", "x(0)").empty());
    // At rest at the level: a small velocity downwards would reach it again.
    const std::string at_rest = "x'' = 1; x(0) = 0; x'(0) = v; when x = 0 up: x = 5; v = 0";
    CHECK_THAT(refused(at_rest, "v"), Catch::Contains("derivatives v " + surface + "when x = 0 up`"));
    const std::string moving = "x'' = 1; x(0) = p^2; x'(0) = 1; when x = 0 down: x = 5; p = 0";
    CHECK_THAT(refused(moving, "p"), Catch::Contains("derivatives p " + surface));
    CHECK_THAT(refused(relay, "y(0)"), Catch::Contains("is neither a parameter nor an initial value"));
    CHECK_THAT(refused(relay, "r"), Catch::Contains("is neither a parameter nor an initial value"));
    const std::string later = "x' = x; x(p) = 1; p = 1; when x = 100 up: x = 1";
    CHECK_THAT(refused(later, "p"), Catch::Contains("derivatives p determines the initial point"));
    CHECK_THAT(refused("x' = floor(t/T); x(0) = 0; T = 2", "T"),
               Catch::Contains("begins on the surface of `floor(t/T)`"));
    const std::string remaining = "x' = 1; z' = 1; y' = if(x > z, 1, 0); x(0) = 0; z(0) = 0; y(0) = 0";
    CHECK_THAT(refused(remaining, "x(0)"), Catch::Contains("remains on the surface of `if(x > z, 1, 0)`"));
    CHECK(refused(remaining, "y(0)").empty());
}

}  // namespace query_hybrid_derivatives_test
