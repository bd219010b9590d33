// The C interface: what it answers, against closed forms.

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "c/called.hpp"
#include "certificates/checked.hpp"
#include "command/temporary_folder.hpp"

namespace c_interface_test {

using namespace c_test;

// Gamma(1/4)^2/sqrt(pi), the lemniscate constant, sqrt(2), pi/2, tan(1) by mpmath.
constexpr const char* period_of_90_degrees = "7.4162987092054876737354013887810401848";
constexpr const char* lemniscate = "2.6220575542921198104648395898911194137";
constexpr const char* root_of_2 = "1.4142135623730950488016887242096980786";
constexpr const char* half_pi = "1.5707963267948966192313216916397514421";
constexpr const char* tangent_of_1 = "1.5574077246549022305069748074583601731";

// Of so many digits all but the last two, which may round.
bool agrees(const std::string& printed, const std::string& truth, std::size_t digits) {
    return printed.size() >= digits && printed.substr(0, digits - 1) == truth.substr(0, digits - 1);
}

TEST_CASE("numbers come out as decimals, doubles and exact parts", "[c]") {
    const auto root = made<number>([](auto** to) { return libration_number_read("sqrt(2)", 30, to); });
    CHECK(agrees(digits_of(root), root_of_2, 30));
    CHECK(libration_number_rigour(root.get()) == LIBRATION_PROVED);
    double nearest = 0;
    double lower = 0;
    double upper = 0;
    REQUIRE(libration_number_double(root.get(), &nearest) == LIBRATION_OK);
    REQUIRE(libration_number_bounds(root.get(), &lower, &upper) == LIBRATION_OK);
    CHECK(nearest == std::sqrt(2.0));  // IEEE 754 rounds a root correctly
    CHECK(lower < upper);
    CHECK(std::nextafter(lower, 2.0) == upper);
    // (m 2^e - r 2^f)^2 < 2 < (m 2^e + r 2^f)^2, in whole numbers.
    std::vector<char> text(libration_number_mantissa_size(root.get()));
    long e = 0;
    long f = 0;
    unsigned long r = 0;
    REQUIRE(libration_number_exact(root.get(), text.data(), text.size(), &e, &r, &f) == LIBRATION_OK);
    using boost::multiprecision::cpp_int;
    const long common = std::min(e, f);
    REQUIRE(common < 0);
    const cpp_int m = cpp_int(text.data()) << static_cast<unsigned>(e - common);
    const cpp_int radius = cpp_int(r) << static_cast<unsigned>(f - common);
    const cpp_int two = cpp_int(2) << static_cast<unsigned>(-2 * common);
    CHECK((m - radius) * (m - radius) < two);
    CHECK(two < (m + radius) * (m + radius));
}

TEST_CASE("a double is refused where the digits do not tell it", "[c]") {
    const auto third = made<number>([](auto** to) { return libration_number_read("1/3", 3, to); });
    double nearest = 7;
    CHECK(libration_number_double(third.get(), &nearest) == LIBRATION_UNDECIDED);
    CHECK(nearest == 7);
    const auto zero = made<number>([](auto** to) { return libration_number_read("pi-pi", 3, to); });
    CHECK(digits_of(zero) == "0");
    CHECK(libration_number_double(zero.get(), &nearest) == LIBRATION_OK);
    CHECK(nearest == 0);
}

TEST_CASE("a number that was written down comes back", "[c]") {
    const auto third =
        made<number>([](auto** to) { return libration_number_of("0.333", "0.000334", LIBRATION_PROVED, to); });
    double lower = 0;
    double upper = 0;
    REQUIRE(libration_number_bounds(third.get(), &lower, &upper) == LIBRATION_OK);
    CHECK(lower < 1.0 / 3);
    CHECK(upper > 1.0 / 3);
    CHECK(upper - lower < 0.00067);
    libration_number* none = nullptr;
    CHECK(libration_number_of("much", "0", LIBRATION_PROVED, &none) == LIBRATION_ARGUMENT);
    CHECK(libration_number_of("1", "-1", LIBRATION_PROVED, &none) == LIBRATION_ARGUMENT);
    CHECK(libration_number_of("1", "0", 3, &none) == LIBRATION_ARGUMENT);
}

TEST_CASE("exact binary numbers go in as mantissa and exponent", "[c]") {
    char text[64];
    REQUIRE(libration_exact_text("3602879701896397", -55, text, sizeof text) == LIBRATION_OK);
    // 0.1 in double is 0.1000000000000000055511151231257827...
    const auto tenth = made<number>([&](auto** to) { return libration_number_read(text, 30, to); });
    CHECK(digits_of(tenth) == "0.100000000000000005551115123126");
    const auto as_written =
        made<number>([](auto** to) { return libration_number_read("3602879701896397*2^-55", 30, to); });
    CHECK(digits_of(as_written) == digits_of(tenth));
    const auto swing = motion_of(std::string("energy = ") + text);
    const auto energy =
        made<number>([&](auto** to) { return libration_motion_energy(swing.get(), 60, LIBRATION_PROVED, to); });
    CHECK(digits_of(energy) == "0.1000000000000000055511151231257827021181583404541015625");
}

TEST_CASE("motions have their closed forms", "[c]") {
    const auto swing = motion_of("theta0 = 90deg; omega0 = 0");
    CHECK(libration_motion_regime(swing.get()) == std::string("libration"));
    for (const int rigour : {LIBRATION_ROUNDED, LIBRATION_PROVED}) {
        const auto period =
            made<number>([&](auto** to) { return libration_motion_period(swing.get(), 35, rigour, to); });
        CHECK(agrees(digits_of(period), period_of_90_degrees, 35));
        CHECK(libration_number_rigour(period.get()) == rigour);
        const auto radius =
            made<number>([&](auto** to) { return libration_motion_radius(swing.get(), nullptr, 35, rigour, to); });
        CHECK(agrees(digits_of(radius), lemniscate, 35));
        const auto zero =
            made<number>([&](auto** to) { return libration_motion_theta(swing.get(), "T/4", 35, rigour, to); });
        CHECK(digits_of(zero) == "0");
        // theta = pi/2 - t^2/2 + t^6/240 + ..., omega(T/4) = -sqrt(2).
        const auto terms = made<table>(
            [&](auto** to) { return libration_motion_coefficients(swing.get(), "top", 0, 6, 20, rigour, to); });
        CHECK(libration_table_rows(terms.get()) == 7);
        CHECK(cell(terms, 2, 1) == "-0.50000000000000000000");
        CHECK(cell(terms, 4, 1) == "0");
        CHECK(cell(terms, 6, 1) == "0.0041666666666666666667");
        const auto states = made<table>([&](auto** to) {
            return libration_motion_states(swing.get(), "0, T/4", 30, rigour, nullptr, nullptr, to);
        });
        CHECK(agrees(cell(states, 1, 2), std::string("-") + root_of_2, 30));
        CHECK(libration_table_name(states.get(), 2) == std::string("omega"));
    }
    const auto critical = motion_of("theta0 = 120deg; omega0 = 1");
    CHECK(libration_motion_regime(critical.get()) == std::string("separatrix"));
    const auto infinite = made<number>(
        [&](auto** to) { return libration_motion_effective_period(critical.get(), 20, LIBRATION_PROVED, to); });
    double value = 0;
    CHECK(libration_number_double(infinite.get(), &value) == LIBRATION_OK);
    CHECK(value == HUGE_VAL);
}

TEST_CASE("the tangent is known by its equation", "[c]") {
    const auto tangent = problem_of("x' = a + x^2; x(0) = 0; a = 2", "a = 1");
    CHECK(libration_problem_size(tangent.get()) == 1);
    CHECK(libration_problem_name(tangent.get(), 0) == std::string("x"));
    for (const int rigour : {LIBRATION_ROUNDED, LIBRATION_PROVED}) {
        const auto states = made<table>([&](auto** to) {
            return libration_problem_states(tangent.get(), "1,pi/4", 35, rigour, nullptr, nullptr, to);
        });
        CHECK(agrees(cell(states, 0, 1), tangent_of_1, 35));
        const auto terms = made<table>([&](auto** to) {
            return libration_problem_coefficients(tangent.get(), nullptr, nullptr, 3, 3, 20, rigour, to);
        });
        CHECK(cell(terms, 0, 0) == "3");
        CHECK(cell(terms, 0, 1) == "0.33333333333333333333");
    }
    const auto fractions = made<table>([&](auto** to) { return libration_problem_fractions(tangent.get(), 0, 7, to); });
    CHECK(cell(fractions, 7, 1) == "17/315");
    // tan(i) = i tanh(1).
    const auto complex = made<table>([&](auto** to) {
        return libration_problem_coefficients(tangent.get(), "i", nullptr, 0, 0, 20, LIBRATION_ROUNDED, to);
    });
    CHECK(libration_table_name(complex.get(), 2) == std::string("x_im"));
    CHECK(agrees(cell(complex, 0, 2), "0.761594155955764888119458", 20));
}

TEST_CASE("what is proved of a solution is kept where something is not", "[c]") {
    // x has a pole at 1, y = tan t goes on to pi/2, and w = -cos t is 0 there.
    const auto mixed = problem_of(
        "x' = x^2; y' = 1 + y^2; x(0) = 1; y(0) = 0; z'' = -z + z^3; z(0) = 0; z'(0) = 1; "
        "w' = sin(t); w(0) = -1; v' = cos(t); v(0) = 0");
    libration_table* found = nullptr;
    CHECK(libration_problem_states(mixed.get(), "1/2,1", 20, LIBRATION_PROVED, nullptr, nullptr, &found) ==
          LIBRATION_UNDECIDED);
    CHECK(found == nullptr);
    CHECK(libration_problem_known_states(mixed.get(), "1/2,1,pi/2", 20, LIBRATION_PROVED, nullptr, nullptr, &found) ==
          LIBRATION_UNDECIDED);
    CHECK(std::string(libration_error_reason()).find("is not reached") != std::string::npos);
    REQUIRE(found != nullptr);
    const table known(found);
    REQUIRE(libration_table_rows(found) == 3);
    CHECK(cell(known, 0, 0) == "1/2");
    CHECK(cell(known, 0, 1) == "2.0000000000000000000");
    CHECK(libration_table_number(found, 1, 1) == nullptr);
    CHECK(cell(known, 1, 1).empty());
    CHECK(agrees(cell(known, 1, 2), tangent_of_1, 20));
    // w = -cos t at pi/2: 0, which no precision decides; its bound is a proved number around 0, and not the exact one.
    const libration_number* const zero = libration_table_number(found, 2, 5);
    REQUIRE(zero != nullptr);
    CHECK(libration_number_decimal(zero) == std::string("0"));
    CHECK(libration_number_rigour(zero) == LIBRATION_PROVED);
    const long double bound = std::stold(libration_number_uncertainty(zero));  // beyond the range of double
    CHECK(bound > 0);
    CHECK(bound < 1e-20L);
    CHECK(cell(known, 2, 6) == "1.0000000000000000000");
    found = nullptr;
    CHECK(libration_problem_known_states(mixed.get(), "1/2", 20, LIBRATION_PROVED, nullptr, nullptr, &found) ==
          LIBRATION_OK);
    CHECK(cell(table(found), 0, 1) == "2.0000000000000000000");
    found = nullptr;
    CHECK(libration_problem_known_states(mixed.get(), "1/2,", 20, LIBRATION_PROVED, nullptr, nullptr, &found) ==
          LIBRATION_ARGUMENT);
    CHECK(found == nullptr);
}

// x = x(0) cos wt + x'(0)/w sin wt at wt = pi/3, and the times at which it is 0.
TEST_CASE("derivatives and events are those of a spring", "[c]") {
    const auto spring = problem_of("x'' = -w^2*x; x(0) = 1; x'(0) = 0; w = 2");
    const auto found = made<table>([&](auto** to) {
        return libration_problem_derivatives(spring.get(), "pi/6", "x(0), x'(0), w", 20, nullptr, nullptr, to);
    });
    REQUIRE(libration_table_columns(found.get()) == 9);
    CHECK(libration_table_name(found.get(), 4) == std::string("dx(t)/dx'(0)"));
    CHECK(cell(found, 0, 3) == "0.50000000000000000000");
    CHECK(agrees(cell(found, 0, 4), "0.43301270189221932338", 20));   // sqrt(3)/4
    CHECK(agrees(cell(found, 0, 5), "-0.45344984105855446126", 20));  // -pi/6 sqrt(3)/2
    CHECK(agrees(cell(found, 0, 6), "-1.7320508075688772935", 20));   // dx'/dx(0)
    libration_table* none = nullptr;
    CHECK(libration_problem_derivatives(spring.get(), "1", "z", 20, nullptr, nullptr, &none) == LIBRATION_ARGUMENT);
    CHECK(libration_error_subject() == std::string("derivatives"));
    CHECK(none == nullptr);
    const auto zeros =
        made<table>([&](auto** to) { return libration_problem_events(spring.get(), "x = 0", 2, 20, to); });
    CHECK(agrees(cell(zeros, 1, 0), "2.3561944901923449288", 20));  // 3 pi/4
    CHECK(libration_problem_events(spring.get(), "x = 0", 0, 20, &none) == LIBRATION_ARGUMENT);
}

// x = t - 1 and u = tan(t - 1), which is 0 at the first event.
TEST_CASE("what is proved of an event is kept where a number of it is not", "[c]") {
    const auto problem = problem_of("x' = 1; u' = 1 + u^2; x(0) = -1; u(0) = -tan(1)");
    libration_table* found = nullptr;
    CHECK(libration_problem_events(problem.get(), "x = 0", 1, 20, &found) == LIBRATION_UNDECIDED);
    CHECK(libration_error_subject() == std::string("event"));
    CHECK(std::string(libration_error_reason()).find("has a value of u that ") != std::string::npos);
    REQUIRE(found != nullptr);
    const table event(found);
    CHECK(cell(event, 0, 0) == "1.0000000000000000000");
    CHECK(cell(event, 0, 1) == "0");
    CHECK(std::stold(libration_number_uncertainty(libration_table_number(found, 0, 1))) == 0);
    CHECK(cell(event, 0, 2) == "0");
    const libration_number* const zero = libration_table_number(found, 0, 2);
    CHECK(libration_number_rigour(zero) == LIBRATION_PROVED);
    const long double bound = std::stold(libration_number_uncertainty(zero));  // beyond the range of double
    CHECK(bound > 0);
    CHECK(bound < 1e-60L);
}

TEST_CASE("a certificate of proved values is checked by another program", "[c][certificate]") {
    const libration::tests::temporary_folder folder;
    const std::string file = (folder.path() / "a.cert").string();
    const auto spring = problem_of("x'' = -x; x(0) = 1/2; x'(0) = 0");
    const auto states = made<table>([&](auto** to) {
        return libration_problem_certificate(spring.get(), "1, 1/2", 15, file.c_str(), nullptr, nullptr, to);
    });
    const auto same = made<table>([&](auto** to) {
        return libration_problem_states(spring.get(), "1, 1/2", 15, LIBRATION_PROVED, nullptr, nullptr, to);
    });
    CHECK(cell(states, 1, 2) == cell(same, 1, 2));
    const auto proved = libration::tests::checked(file);
    INFO(proved.out);
    CHECK(proved.exit_code == 0);
    CHECK(libration::tests::contains(proved.out, "x'(1/2) lies in [-0.23971276930"));  // -sin(1/2)/2
    made<table>([&](auto** to) {
        return libration_problem_event_certificate(spring.get(), "x = 0", 1, 15, file.c_str(), nullptr, nullptr, to);
    });
    CHECK(libration::tests::contains(libration::tests::checked(file).out, "#1 lies in [1.5707963267948"));
    libration_table* none = nullptr;
    CHECK(libration_problem_certificate(spring.get(), "pi/3", 15, file.c_str(), nullptr, nullptr, &none) ==
          LIBRATION_ARGUMENT);
    CHECK(libration_error_subject() == std::string("certificate"));
    CHECK(libration_problem_certificate(spring.get(), "1", 15, "/missing/a.cert", nullptr, nullptr, &none) ==
          LIBRATION_ARGUMENT);
    CHECK(libration_error_subject() == std::string("path"));
    CHECK(none == nullptr);
}

// x(1) = cos(1)/2 + s sin(1) = 1 for s = (1 - cos(1)/2)/sin(1).
TEST_CASE("a certificate of a root is checked by another program", "[c][certificate]") {
    const libration::tests::temporary_folder folder;
    const std::string file = (folder.path() / "a.cert").string();
    const auto spring = problem_of("x'' = -x; x(0) = 1/2; x'(0) = 1");
    const auto root = made<table>([&](auto** to) {
        return libration_problem_find_certificate(spring.get(), "x'(0)", "x(1) = 1", 12, file.c_str(), nullptr, nullptr,
                                                  to);
    });
    CHECK(agrees(cell(root, 0, 1), "0.86734879781095586", 12));
    const auto proved = libration::tests::checked(file);
    INFO(proved.out);
    CHECK(proved.exit_code == 0);
    CHECK(libration::tests::contains(proved.out, "x(1) = 1."));
    libration_table* none = nullptr;
    CHECK(libration_problem_find_certificate(spring.get(), "x'(0)", "x(1) + x'(1) = 1", 12, file.c_str(), nullptr,
                                             nullptr, &none) == LIBRATION_ARGUMENT);
    CHECK(libration_problem_find_certificate(spring.get(), "x'(0), x(0)", "x(1) = 1", 12, file.c_str(), nullptr,
                                             nullptr, &none) == LIBRATION_ARGUMENT);
    const auto cycle = problem_of("van_der_pol");
    const auto orbit = made<table>([&](auto** to) {
        return libration_problem_orbit_certificate(cycle.get(), 8, file.c_str(), nullptr, nullptr, to);
    });
    CHECK(agrees(cell(orbit, 2, 1), "6.6632868593231301897", 8));
    const auto closed = libration::tests::checked(file);
    INFO(closed.out);
    CHECK(closed.exit_code == 0);
    CHECK(libration::tests::contains(closed.out, "x'(t) = x'(0)."));
    CHECK(libration_problem_orbit_certificate(spring.get(), 8, file.c_str(), nullptr, nullptr, &none) ==
          LIBRATION_ARGUMENT);
    CHECK(none == nullptr);
}

// x' = 1 + x^2: the tangent, from any start, up to its pole. Doubles: some operations per step, few steps.
TEST_CASE("solutions in double are those of the tangent", "[c]") {
    constexpr double tolerance = 1000 * std::numeric_limits<double>::epsilon();
    const auto tangent = problem_of("x' = 1 + x^2; x(0) = 1/2");
    const std::array<double, 2> starts{0, 1};
    const std::array<double, 3> times{-0.5, 0.5, 1.5};
    std::array<double, 6> values{};
    REQUIRE(libration_problem_flow(tangent.get(), 0, 2, starts.data(), 3, times.data(), nullptr, nullptr,
                                   values.data()) == LIBRATION_OK);
    const double quarter = std::atan(1.0);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(std::abs(values[i] - std::tan(times[i])) <= tolerance * (1 + values[i] * values[i]));
    }
    CHECK(std::abs(values[4] - std::tan(0.5 + quarter)) <= tolerance * values[4] * values[4]);
    CHECK(std::isnan(values[5]));
    REQUIRE(libration_problem_flow(tangent.get(), 0, 1, nullptr, 1, times.data(), nullptr, nullptr, values.data()) ==
            LIBRATION_OK);
    CHECK(std::abs(values[0] - std::tan(std::atan(0.5) - 0.5)) <= tolerance);
    const double infinite = HUGE_VAL;
    CHECK(libration_problem_flow(tangent.get(), 0, 1, &infinite, 1, times.data(), nullptr, nullptr, values.data()) ==
          LIBRATION_ARGUMENT);
    double time = 1;
    REQUIRE(libration_problem_start(tangent.get(), &time, values.data()) == LIBRATION_OK);
    CHECK(time == 0);
    CHECK(values[0] == 0.5);
}

TEST_CASE("solutions in double with many values of parameters", "[c]") {
    constexpr double tolerance = 1000 * std::numeric_limits<double>::epsilon();
    const auto growth = problem_of("x' = a*x; x(0) = 2*a; y' = x; y(0) = b; a = 1; b = 0");
    const std::array<double, 6> numbers{1, 0, -1, 5, 0.5, 7};
    const double time = 2;
    std::array<double, 6> values{};
    REQUIRE(libration_problem_varied_flow(growth.get(), "a, y(0)", numbers.data(), 0, 3, nullptr, 1, &time, nullptr,
                                          nullptr, values.data()) == LIBRATION_OK);
    for (std::size_t i = 0; i < 3; ++i) {
        const double a = numbers[2 * i];
        const double grown = std::exp(a * time);
        CHECK(std::abs(values[2 * i] - 2 * a * grown) <= tolerance * grown);
        CHECK(std::abs(values[2 * i + 1] - numbers[2 * i + 1] - 2 * (grown - 1)) <= tolerance * (1 + grown));
    }
    const std::array<double, 6> starts{1, 2, 3, 4, 5, 6};
    REQUIRE(libration_problem_varied_flow(growth.get(), "b,a", numbers.data(), 2, 3, starts.data(), 1, &time, nullptr,
                                          nullptr, values.data()) == LIBRATION_OK);
    CHECK(values == starts);
    CHECK(libration_problem_varied_flow(growth.get(), "c", numbers.data(), 0, 3, nullptr, 1, &time, nullptr, nullptr,
                                        values.data()) == LIBRATION_ARGUMENT);
    CHECK(libration_problem_varied_flow(growth.get(), "a", numbers.data(), 0, 0, nullptr, 0, nullptr, nullptr, nullptr,
                                        nullptr) == LIBRATION_OK);
}

TEST_CASE("solutions in lock step are the same as alone", "[c]") {
    const auto tangent = problem_of("x' = 1 + x^2; x(0) = 1/2");
    std::vector<double> starts;
    for (int i = 0; i < 50; ++i) {
        starts.push_back(0.1 * i);
    }
    const std::array<double, 3> times{-0.5, 1, 0.25};
    std::vector<double> together(starts.size() * times.size());
    std::vector<double> alone(together.size());
    REQUIRE(libration_problem_flow(tangent.get(), 0, starts.size(), starts.data(), 3, times.data(), nullptr, nullptr,
                                   together.data()) == LIBRATION_OK);
    for (std::size_t i = 0; i < starts.size(); ++i) {
        REQUIRE(libration_problem_flow(tangent.get(), 0, 1, &starts[i], 3, times.data(), nullptr, nullptr,
                                       &alone[3 * i]) == LIBRATION_OK);
    }
    for (std::size_t i = 0; i < together.size(); ++i) {
        CHECK((together[i] == alone[i] || (std::isnan(together[i]) && std::isnan(alone[i]))));
    }
    const auto stop = [](double, void*) { return 1; };
    CHECK(libration_problem_flow(tangent.get(), 0, starts.size(), starts.data(), 3, times.data(), stop, nullptr,
                                 together.data()) == LIBRATION_CANCELLED);
}

TEST_CASE("the steps of a solution in double are its polynomials", "[c]") {
    constexpr double tolerance = 1000 * std::numeric_limits<double>::epsilon();
    const auto spring = problem_of("x'' = -x; x(0) = 1; x'(0) = 0");
    const std::array<double, 2> start{1, 0};
    libration_steps* found = nullptr;
    REQUIRE(libration_steps_new(spring.get(), 0, start.data(), -10, &found) == LIBRATION_OK);
    const std::unique_ptr<libration_steps, void (*)(libration_steps*)> owned(found, libration_steps_free);
    const std::size_t count = libration_steps_count(found);
    const std::size_t powers = libration_steps_order(found) + 1;
    const double* const times = libration_steps_times(found);
    REQUIRE(count > 1);
    CHECK(times[0] == 0);
    CHECK(times[count] == -10);
    for (std::size_t i = 0; i < count; ++i) {
        const double* const of_x = libration_steps_coefficients(found) + i * 2 * powers;
        CHECK(std::abs(of_x[0] - std::cos(times[i])) <= tolerance);
        CHECK(std::abs(of_x[1] + std::sin(times[i])) <= tolerance);
        CHECK(std::abs(of_x[powers] + std::sin(times[i])) <= tolerance);
    }
    const auto pole = problem_of("x' = x^2; x(0) = 1");
    libration_steps* short_of_it = nullptr;
    REQUIRE(libration_steps_new(pole.get(), 0, start.data(), 2, &short_of_it) == LIBRATION_OK);
    CHECK(libration_steps_times(short_of_it)[libration_steps_count(short_of_it)] <= 1);
    libration_steps_free(short_of_it);
    CHECK(libration_steps_count(nullptr) == 0);
}

// Blasius: f''(0) k = 0.332... of the literature; van der Pol's period; the end of the epidemic of Eyam [PROBLEMS].
TEST_CASE("unknowns, orbits and limits are those of the command", "[c]") {
    const auto blasius = problem_of("blasius");
    const auto shear = made<table>(
        [&](auto** to) { return libration_problem_find(blasius.get(), "k", "f'(inf) = 1", 32, nullptr, nullptr, to); });
    CHECK(std::string(libration_table_text(shear.get(), 0, 0)) == "k");
    CHECK(agrees(cell(shear, 0, 1), "0.33205733621519629893718006201058", 32));
    const auto spring = problem_of("y'' = -y; y(0) = 0; y'(0) = 1");
    const auto speed = made<table>([&](auto** to) {
        return libration_problem_find(spring.get(), "y'(0)", "y(pi/6) = 1", 20, nullptr, nullptr, to);
    });
    CHECK(cell(speed, 0, 1) == "2.0000000000000000000");
    CHECK(libration_number_rigour(libration_table_number(speed.get(), 0, 1)) == LIBRATION_PROVED);
    const auto cycle = problem_of("van_der_pol");
    const auto orbit =
        made<table>([&](auto** to) { return libration_problem_orbit(cycle.get(), 15, nullptr, nullptr, to); });
    REQUIRE(libration_table_rows(orbit.get()) == 3);
    CHECK(agrees(cell(orbit, 2, 1), "6.6632868593231301897", 15));
    const auto epidemic = problem_of("sir");
    const auto end = made<table>([&](auto** to) { return libration_problem_limits(epidemic.get(), 12, to); });
    CHECK(cell(end, 0, 0) == "76.0563587703");
    libration_table* none = nullptr;
    CHECK(libration_problem_limits(spring.get(), 12, &none) == LIBRATION_UNDECIDED);
    CHECK(libration_problem_find(spring.get(), "k", "y(1) = 1", 12, nullptr, nullptr, &none) == LIBRATION_ARGUMENT);
    // y' = 1 is no constant solution.
    CHECK(libration_problem_find(spring.get(), "y'(0)", "y'(inf) = 1", 12, nullptr, nullptr, &none) ==
          LIBRATION_ARGUMENT);
}

// x(1) = s + s^3/3 - s with x(0) = s is k: the turning points of x^3/3 - x are at -1 and 1, k = 2/3 and -2/3.
TEST_CASE("a branch passes its turning points", "[c]") {
    const auto cubic = problem_of("x' = s^3/3 - 2*s - k; x(0) = s; s = -2; k = -2");
    const auto branch = made<table>([&](auto** to) {
        return libration_problem_branch(cubic.get(), "s", "x(1) = 0", "k = -2:2:3", 20, nullptr, nullptr, to);
    });
    REQUIRE(libration_table_columns(branch.get()) == 4);
    CHECK(std::string(libration_table_name(branch.get(), 1)) == "k");
    std::vector<std::string> turns;
    for (size_t row = 0; row < libration_table_rows(branch.get()); ++row) {
        const bool is_last = row + 1 == libration_table_rows(branch.get());
        const std::string note = libration_table_text(branch.get(), row, 3);
        CHECK(note.starts_with("leaves the range at k = 2.") == is_last);
        if (libration_table_text(branch.get(), row, 0) == std::string("turning point")) {
            turns.push_back(cell(branch, row, 1));
        }
    }
    CHECK(turns == std::vector<std::string>{"0.66666666666666666667", "-0.66666666666666666667"});
    libration_table* none = nullptr;
    for (const char* const wrong : {"k", "q = 0, 1", "k = 0, 2, 1", "k = 0:1", "s = 0, 1"}) {
        CHECK(libration_problem_branch(cubic.get(), "s", "x(1) = 0", wrong, 20, nullptr, nullptr, &none) ==
              LIBRATION_ARGUMENT);
    }
    CHECK(none == nullptr);
    CHECK(libration_error_subject() == std::string("unknowns"));
}

TEST_CASE("the radius of the tangent is pi/2", "[c]") {
    const auto tangent = problem_of("x' = 1 + x^2; x(0) = 0");
    const auto tests = made<table>([&](auto** to) { return libration_problem_radius(tangent.get(), 80, 20, to); });
    CHECK(agrees(cell(tests, 0, 2), half_pi, 19));
    CHECK(libration_number_rigour(libration_table_number(tests.get(), 0, 2)) == LIBRATION_HEURISTIC);
    libration_number* lower = nullptr;
    libration_number* upper = nullptr;
    REQUIRE(libration_problem_radius_bounds(tangent.get(), 12, &lower, &upper) == LIBRATION_OK);
    const number below(lower);
    const number above(upper);
    CHECK(digits_of(below) < std::string(half_pi));
    CHECK(digits_of(above) > std::string(half_pi));
    CHECK(agrees(digits_of(below), half_pi, 12));
    CHECK(agrees(digits_of(above), half_pi, 12));
    int complete = 0;
    const auto map = made<table>([&](auto** to) {
        return libration_problem_singularities(tangent.get(), nullptr, 12, LIBRATION_PROVED, to, &complete);
    });
    CHECK(complete == 1);
    REQUIRE(libration_table_rows(map.get()) == 2);
    CHECK(cell(map, 0, 3) == "pole of order 1");
    CHECK(libration_number_rigour(libration_table_number(map.get(), 0, 0)) == LIBRATION_PROVED);
    CHECK(agrees(cell(map, 0, 2), half_pi, 12));
    // 1/(1 - x/2).
    const auto list = made<table>(
        [](auto** to) { return libration_list_radius("1,1/2,1/4,1/8,1/16,1/32,1/64,1/128,1/256,1/512", 15, to); });
    double radius = 0;
    double highest = 0;
    REQUIRE(libration_number_bounds(libration_table_number(list.get(), 0, 2), &radius, &highest) == LIBRATION_OK);
    CHECK(radius <= 2);
    CHECK(highest >= 2);
}

TEST_CASE("values are judged by proved ones", "[c]") {
    const auto tangent = problem_of("x' = 1 + x^2; x(0) = 0");
    const auto typed = made<table>([&](auto** to) {
        return libration_problem_verify(tangent.get(), "x", "1, 1", "1.5574077, 1.5574079", nullptr, nullptr, nullptr,
                                        to);
    });
    CHECK(cell(typed, 0, 1) == "ok");
    CHECK(cell(typed, 1, 1) == "miss");
    CHECK(agrees(cell(typed, 0, 3), tangent_of_1, 10));
    const auto swing = motion_of("theta0 = 90deg; omega0 = 0");
    // theta and omega after three periods and half a turn more or less; sqrt(2) in double is off by 9.7e-17.
    const double times[] = {0.0, 0.0};
    const double values[] = {1.5707963267948966 + 2 * 3.141592653589793, 0.0, 1.6, 0.0};
    const auto doubles = made<table>([&](auto** to) {
        return libration_motion_verify_doubles(swing.get(), "theta,omega", 2, times, values,
                                               "tolerance = 1e-12; modulo = 2pi", nullptr, nullptr, to);
    });
    CHECK(cell(doubles, 0, 1) == "ok");
    CHECK(cell(doubles, 1, 1) == "miss");
    CHECK(libration_table_name(doubles.get(), 6) == std::string("omega_reference"));
    CHECK(cell(doubles, 0, 6) == "0");
}

TEST_CASE("the sampler serves arrays of doubles", "[c]") {
    const auto swing = motion_of("theta0 = 90deg; omega0 = 0");
    const auto fast = made<sampler>([&](auto** to) { return libration_sampler_new(swing.get(), to); });
    const std::vector<double> times{0, 0.7, -3.5, 1e9};
    std::vector<double> theta(times.size());
    std::vector<double> omega(times.size());
    REQUIRE(libration_sampler_at(fast.get(), times.size(), times.data(), theta.data(), omega.data()) == LIBRATION_OK);
    const char* const texts[] = {"0", "7/10", "-7/2", "1e9"};
    for (std::size_t i = 0; i < times.size(); ++i) {
        const auto truth = made<number>(
            [&](auto** to) { return libration_motion_theta(swing.get(), texts[i], 30, LIBRATION_PROVED, to); });
        double nearest = 0;
        // 7/10 is not the double 0.7: theta' < sqrt(2), so that the angle moves by less than half a unit in the last
        // place of 1.
        REQUIRE(libration_number_double(truth.get(), &nearest) == LIBRATION_OK);
        // 4 units of the sampler, that half, and half a unit of the nearest double.
        CHECK(std::abs(theta[i] - nearest) <= 5 * 0x1p-52);
    }
    CHECK(libration_sampler_at(fast.get(), 0, nullptr, nullptr, nullptr) == LIBRATION_OK);
    const double infinite = HUGE_VAL;
    CHECK(libration_sampler_at(fast.get(), 1, &infinite, theta.data(), omega.data()) == LIBRATION_ARGUMENT);
}

TEST_CASE("a watch hears of a proof and ends it", "[c]") {
    const auto lorenz = problem_of("lorenz");
    const auto watch = [](double part, void* context) {
        auto& last = *static_cast<double*>(context);
        last = part;
        return part > 0.2 ? 1 : 0;
    };
    double last = -1;
    libration_table* states = nullptr;
    CHECK(libration_problem_states(lorenz.get(), "5", 20, LIBRATION_PROVED, watch, &last, &states) ==
          LIBRATION_CANCELLED);
    CHECK(states == nullptr);
    CHECK(last > 0.2);
    CHECK(libration_error_message() == std::string("the call was cancelled"));
}

TEST_CASE("a watch ends the search for unknowns and orbits", "[c]") {
    const auto cycle = problem_of("van_der_pol");
    const auto watch = [](double part, void* context) {
        ++*static_cast<int*>(context);
        return part == 0 ? 1 : 0;
    };
    int calls = 0;
    libration_table* found = nullptr;
    CHECK(libration_problem_orbit(cycle.get(), 15, watch, &calls, &found) == LIBRATION_CANCELLED);
    const auto spring = problem_of("y'' = -y; y(0) = 0; y'(0) = 1");
    CHECK(libration_problem_find(spring.get(), "y'(0)", "y(1000) = 1", 15, watch, &calls, &found) ==
          LIBRATION_CANCELLED);
    CHECK(found == nullptr);
    CHECK(calls == 2);
}

}  // namespace c_interface_test
