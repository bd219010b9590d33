// Events against closed forms from starts on a section, next to it and far away: polynomials with chosen roots, where
// every zero is a fraction, and harmonic oscillators, where it is an inverse cosine.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>
#include <string>
#include <vector>

#include "corner_numbers.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/query/proved_events.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/error.hpp"
#include "proved.hpp"

namespace query_event_laws_test {

using namespace libration;
using namespace libration::ode;

namespace {

constexpr long digits = 20;

rational ten_to(long exponent) {
    const integer power = pow(integer(10), static_cast<unsigned>(std::abs(exponent)));
    return exponent < 0 ? rational(1, power) : rational(power);
}

std::string text_of(const rational& x) { return "(" + x.str() + ")"; }

rational read(const std::string& decimal) { return *parse_constant(decimal).constant().fraction(); }

// Less than one unit of the last digit away; 0 is printed as 0.
bool printed_well(const proved_decimal& printed, const rational& number) {
    const rational value = read(printed.text);
    return number == 0 ? value == 0 : abs(rational(value - number)) < abs(value) * ten_to(1 - digits);
}

// A root: 0, which is the start, powers of ten and two, next to 1, or a small fraction.
rational chosen_root(tests::corner_numbers& random, long far) {
    const int sign = random.one_in(3) ? -1 : 1;
    return sign * random.half(
                      [&]() -> rational {
                          switch (random.below(5)) {
                              case 0: return 0;
                              case 1: return ten_to(random.between(-far, far));
                              case 2: return 1 - ten_to(-random.between(1, 40));
                              case 3: return 1 + ten_to(-random.between(1, 40));
                              default: return rational(random.positive(100), random.positive(100));
                          }
                      },
                      [&]() -> rational { return rational(random.between(1, 1000), random.between(1, 1000)); });
}

// y = (t - a)(t - b) .. of degree 1 to 3, by its derivatives at t = 0.
std::string polynomial_problem(const std::vector<rational>& roots) {
    std::vector<rational> coefficients{1};
    for (const rational& root : roots) {
        coefficients.insert(coefficients.begin(), 0);
        for (std::size_t k = 0; k + 1 < coefficients.size(); ++k) {
            coefficients[k] -= root * coefficients[k + 1];
        }
    }
    std::string text;
    std::string name = "y";
    rational factorial = 1;
    for (std::size_t k = 0; k < roots.size(); ++k) {
        text += "; " + name + "(0) = " + text_of(rational(coefficients[k] * factorial));
        name += "'";
        factorial *= k + 1;
    }
    return name + " = " + text_of(factorial) + text;
}

struct expected_event {
    rational time;
    crossing way;
};

// The roots on one side of the start, in the order of the search.
std::vector<expected_event> expected_events(const std::vector<rational>& roots, int direction) {
    std::vector<expected_event> events;
    for (const rational& root : roots) {
        rational slope = 1;
        for (const rational& other : roots) {
            slope *= other == root ? rational(1) : rational(root - other);
        }
        if (root * direction > 0) {
            events.push_back({root, slope > 0 ? crossing::up : crossing::down});
        }
    }
    std::ranges::sort(events, [&](const expected_event& a, const expected_event& b) {
        return a.time * direction < b.time * direction;
    });
    return events;
}

// All roots on one side of the start, no more and no others, and each way alone.
void check_polynomial(const std::vector<rational>& roots, int direction) {
    const std::string problem = polynomial_problem(roots);
    INFO(problem << ", direction " << direction);
    const auto system = parse(problem);
    const auto all = expected_events(roots, direction);
    event_request request;
    request.g = parse_condition(system, "y = 0");
    request.direction = direction;
    request.before = number(rational(all.empty() ? rational(direction) : rational(all.back().time * 2)));
    request.count = 5;
    for (const crossing way : {crossing::any, crossing::up, crossing::down}) {
        request.way = way;
        std::vector<expected_event> expected;
        std::ranges::copy_if(all, std::back_inserter(expected),
                             [&](const expected_event& each) { return way == crossing::any || each.way == way; });
        const auto report = searched_events(explicit_system(system), request, digits);
        REQUIRE(report.missing);
        CHECK_THAT(report.missing->what(), Catch::Contains(std::to_string(expected.size()) + " were found"));
        REQUIRE(report.events.size() == expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            CHECK(printed_well(report.events[i].time.decimal.value(), expected[i].time));
            CHECK(report.events[i].values[0].decimal.value().text == "0");
        }
    }
}

void check_polynomials(int cases, long far) {
    tests::corner_numbers random(7);
    for (int i = 0; i < cases; ++i) {
        std::set<rational> roots;
        const std::size_t degree = 1 + random.below(3);
        while (roots.size() < degree) {
            roots.insert(chosen_root(random, far));
        }
        check_polynomial({roots.begin(), roots.end()}, random.one_in(3) ? -1 : 1);
    }
}

// The times 0 < t < T at which A cos t + B sin t = c: phi -+ acos(c/R) + 2 pi k, A = R cos phi, B = R sin phi.
// std::nullopt where the closed form does not tell how many there are.
std::optional<std::vector<ball>> oscillator_events(const rational& a, const rational& b, const rational& c,
                                                   const rational& end) {
    std::vector<ball> times;
    const rational above = c * c - a * a - b * b;
    if (above >= 0) {
        return above == 0 ? std::nullopt : std::optional(times);
    }
    const ball x = from_rational<ball>(a);
    const ball y = from_rational<ball>(b);
    const ball phi = atan2(y, x);
    const ball half = acos(from_rational<ball>(c) / sqrt(x * x + y * y));
    const ball last = from_rational<ball>(end);
    for (int k = -1; k < 4; ++k) {
        for (const int side : {-1, 1}) {
            const ball time = phi + half * side + pi<ball>() * (2 * k);
            if (c == a && contains_zero(time)) {
                continue;  // the start itself
            }
            if (contains_zero(time) || overlaps(time, last)) {
                return std::nullopt;
            }
            if (certainly_less(ball(0), time) && certainly_less(time, last)) {
                times.push_back(time);
            }
        }
    }
    std::ranges::sort(times, [](const ball& s, const ball& t) { return certainly_less(s, t); });
    return times;
}

bool printed_well(const proved_decimal& printed, const ball& number) {
    const ball value = from_rational<ball>(read(printed.text));
    return certainly_less(abs(value - number), abs(value) * pow(ball(10), 1 - digits));
}

void check_oscillator(const rational& a, const rational& b, const rational& c) {
    const precision_scope scope(400);
    const rational end = 13;
    const auto expected = oscillator_events(a, b, c, end);
    if (!expected) {
        return;
    }
    const std::string problem = "y'' = -y; y(0) = " + text_of(a) + "; y'(0) = " + text_of(b);
    INFO(problem << "; y = " << text_of(c));
    const auto system = parse(problem);
    event_request request;
    request.g = parse_condition(system, "y = " + text_of(c));
    request.before = number(end);
    request.count = 9;
    const auto report = searched_events(explicit_system(system), request, digits);
    REQUIRE(report.missing);
    CHECK_THAT(report.missing->what(), Catch::Contains(std::to_string(expected->size()) + " were found"));
    REQUIRE(report.events.size() == expected->size());
    for (std::size_t i = 0; i < expected->size(); ++i) {
        CHECK(printed_well(report.events[i].time.decimal.value(), (*expected)[i]));
    }
}

void check_oscillators(int cases) {
    tests::corner_numbers random(11);
    for (int i = 0; i < cases; ++i) {
        const rational a = random.below(3) == 0 ? rational(0) : chosen_root(random, 20);
        const rational b = chosen_root(random, 20);
        if (a == 0 && b == 0) {
            continue;
        }
        // On the start, next to it, or anywhere.
        const rational c =
            random.half([&] { return rational(a + (random.one_in(2) ? rational(0) : ten_to(-random.between(1, 60)))); },
                        [&] { return chosen_root(random, 3); });
        check_oscillator(a, b, c);
    }
}

}  // namespace

TEST_CASE("the events of polynomials are their roots", "[ode][proved][events]") { check_polynomials(12, 60); }

TEST_CASE("the events of polynomials are their roots, at all scales", "[ode][proved][events][.long]") {
    check_polynomials(1000, 300);
}

// y = (t - a)(t + b)(t + c): the root a is the only one behind the start, and pieces are often halved exactly there.
TEST_CASE("the event of a cubic without an end is its positive root", "[ode][proved][events]") {
    for (int a = 1; a <= 3; ++a) {
        for (int b = 1; b <= 3; ++b) {
            for (int c = 1; c <= b; ++c) {
                const int square = b + c - a;
                const int linear = b * c - a * (b + c);
                const std::string problem = "y' = 3*t^2 + 2*(" + std::to_string(square) + ")*t + (" +
                                            std::to_string(linear) + "); y(0) = " + std::to_string(-a * b * c);
                INFO(problem);
                const auto system = parse(problem);
                event_request request;
                request.g = parse_condition(system, "y = 0");
                const auto report = searched_events(explicit_system(system), request, digits);
                REQUIRE(report.events.size() == 1);
                CHECK(printed_well(report.events[0].time.decimal.value(), rational(a)));
            }
        }
    }
}

TEST_CASE("the events of harmonic oscillators are inverse cosines", "[ode][proved][events]") { check_oscillators(12); }

TEST_CASE("the events of harmonic oscillators are inverse cosines, in many cases", "[ode][proved][events][.long]") {
    check_oscillators(1000);
}

// A turn at the start itself, which Newton's method encloses ever more narrowly: the zero is at sqrt(2 h/g).
TEST_CASE("a body is dropped from any height with an acceleration that is no fraction", "[ode][proved]") {
    const precision_scope scope(60);
    for (const char* acceleration : {"(1 - exp(-155))", "pi", "exp(-155)"}) {
        for (const char* height : {"2^(-35)", "1e-1000", "1", "1e1000"}) {
            CAPTURE(acceleration, height);
            const equation_system problem =
                parse("y'' = -" + std::string(acceleration) + "; y(0) = " + height + "; y'(0) = 0");
            event_request request;
            request.g = ode::unknown("y");
            const auto events = proved_events(explicit_system(problem), request, digits);
            const auto ball_of = [](const std::string& text) {
                return constant_value<ball>::of(parse_constant(text).constant());
            };
            const ball truth = sqrt(ball(2) * ball_of(height) / ball_of(acceleration));
            CHECK(certainly_less(abs(ball_of(events[0].time.text) - truth), abs(truth) * pow(ball(10), 1 - digits)));
        }
    }
}

// w = y - x^2 obeys w' = c w^2, so that 1/w = 1/w(0) - c t, beside an x that is larger than w by many orders: on a set
// of times x^2 varies far more than w does.
TEST_CASE("events of what is left where large terms cancel", "[ode][proved]") {
    const rational c = 1 + ten_to(-13);
    const auto events_at = [&](const rational& from, const rational& level, const rational& before) {
        const equation_system problem =
            parse("x' = -x; y' = " + text_of(c) + "*(y - x^2)^2 - 2*x^2; x(0) = 1; y(0) = 1 + " + text_of(from));
        event_request request;
        request.g = ode::unknown("y") - ode::unknown("x") * ode::unknown("x") - ode::expression(number(level));
        request.before = number(before);
        return searched_events(explicit_system(problem), request, digits).events;
    };
    for (const int exponent : {8, 26, 60}) {
        CAPTURE(exponent);
        const rational w(1, pow(integer(2), static_cast<unsigned>(exponent)));
        CHECK(events_at(w, w, rational(7, 4)).empty());
        const rational level = w + w * w / 3;
        const auto events = events_at(w, level, rational(7, 4));
        REQUIRE(events.size() == 1);
        CHECK(printed_well(events[0].time.decimal.value(), rational((1 / w - 1 / level) / c)));
        CHECK(events_at(w, level, rational(1, 4)).empty());
    }
}

}  // namespace query_event_laws_test
