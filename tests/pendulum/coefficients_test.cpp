#include "libration/pendulum/coefficients.hpp"

#include <catch2/catch.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/pendulum/expansion.hpp"
#include "libration/series/exponential.hpp"
#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_coefficients_test {

using namespace libration;
using namespace libration::series;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

template <class T>
expansion<T> expanded(const std::string& energy, const std::string& at, int order,
                      recurrence by = recurrence::symmetric_squares) {
    return expand_by(by, exact_solution<T>(with_energy(energy)), read_expansion_point(at), order);
}

// The points of the tables: symmetric ones and one without symmetry, both sides of E = 2.
struct place {
    std::string energy;
    std::string at;
};
const std::vector<place> places{{"0.5", "top"},  {"1.71", "top"},    {"1.71", "bottom"}, {"1.71", "1.1"},
                                {"2.02", "top"}, {"2.02", "bottom"}, {"2.02", "1.1"},    {"10", "bottom"},
                                {"2", "bottom"}, {"2", "-0.7"},      {"1e-20", "T/3"},   {"1e6", "top"}};

// In units of 8/n (a_n R^n has this size): 4 ulps of the state at which the series starts, and one for every power of
// R, which is itself off by about one.
long allowed(int n) { return 4 + n; }

}  // namespace

TEMPLATE_LIST_TEST_CASE("theta'' + sin theta = 0, coefficient by coefficient", "[coefficients]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& [energy, at] : places) {
        for (const auto by : {recurrence::symmetric_squares, recurrence::sine_cosine}) {
            const auto e = expanded<T>(energy, at, 40, by);
            const auto sine = sine_cosine(e.scaled).first;
            for (int n = 0; n + 2 <= 40; ++n) {
                INFO("E = " << energy << " about " << at << ", n = " << n);
                // theta'' in scaled time is a_(n+2) (n+1)(n+2), of size 8 n; its two terms cancel to the errors of
                // both.
                const T acceleration = e.scaled[n + 2] * (n + 1) * (n + 2);
                const T force = sine[n] * e.scale * e.scale;
                CHECK_THAT(T(-force), near<T>(acceleration, 16, T((n + 8) * (e.scale > 8 ? e.scale : T(8)))));
            }
        }
    }
}

TEMPLATE_LIST_TEST_CASE("both recurrences agree", "[coefficients]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& [energy, at] : places) {
        const auto squares = expanded<T>(energy, at, 60);
        const auto sines = expanded<T>(energy, at, 60, recurrence::sine_cosine);
        CHECK(squares.scaled[0] == sines.scaled[0]);
        for (int n = 1; n <= 60; ++n) {
            INFO("E = " << energy << " about " << at << ", n = " << n);
            CHECK_THAT(sines.scaled[n], near<T>(squares.scaled[n], allowed(n), T(T(8) / n)));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("a series of lower order is a prefix, digit for digit", "[coefficients]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& [energy, at] : places) {
        for (const auto by : {recurrence::symmetric_squares, recurrence::sine_cosine}) {
            const auto whole = expanded<T>(energy, at, 30, by).scaled;
            for (const int order : {0, 1, 2, 3, 7, 29}) {
                INFO("E = " << energy << " about " << at << ", N = " << order);
                CHECK(expanded<T>(energy, at, order, by).scaled.coefficients() ==
                      whole.truncated(order).coefficients());
            }
        }
    }
}

TEMPLATE_LIST_TEST_CASE("libration from the top is even, every other symmetric point is odd", "[coefficients]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& [energy, at] : places) {
        if (at != "top" && at != "bottom") {
            continue;
        }
        const int kept = at == "top" && fraction(energy) < 2 ? 0 : 1;
        for (const auto by : {recurrence::symmetric_squares, recurrence::sine_cosine}) {
            const auto a = expanded<T>(energy, at, 40, by).scaled;
            for (int n = 1; n <= 40; ++n) {
                INFO("E = " << energy << " about " << at << ", n = " << n);
                CHECK((a[n] == 0) == (n % 2 != kept));
            }
        }
    }
}

TEMPLATE_LIST_TEST_CASE("at E = 1 the series from the top has a_0 and every fourth power", "[coefficients]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::abs;
    const auto squares = expanded<T>("1", "top", 60).scaled;
    const auto sines = expanded<T>("1", "top", 60, recurrence::sine_cosine).scaled;
    for (int n = 1; n <= 60; ++n) {
        INFO(n);
        CHECK((squares[n] == 0) == (n % 4 != 2));  // k = k' digit for digit, so the zeros are exact
        CHECK((abs(sines[n]) * n < 8 * epsilon<T>() * n) == (n % 4 != 2));
    }
}

TEMPLATE_LIST_TEST_CASE("the separatrix has the Taylor series of the Gudermannian", "[coefficients]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // theta = 2 gd(t): a_1 = 2, a_3 = -1/3, a_5 = 1/12, a_7 = -61/2520 [DLMF 4.23(viii), secant numbers 1, 1, 5, 61].
    const std::vector<std::pair<int, rational>> known{
        {1, 2}, {3, rational(-1, 3)}, {5, rational(1, 12)}, {7, rational(-61, 2520)}};
    const auto start = start_at(exact_solution<T>(with_energy("2")), phase_map<T>::at_quarter(0));
    const auto a = taylor_coefficients(start, 7, T(1));
    for (const auto& [n, value] : known) {
        CHECK_THAT(a[n], near<T>(from_rational<T>(value), n));
    }
}

TEMPLATE_LIST_TEST_CASE("a negative order is refused", "[coefficients]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto start = start_at(exact_solution<T>(with_energy("1")), phase_map<T>::at_quarter(1));
    CHECK_THROWS_AS(taylor_coefficients(start, -1, T(1)), libration::error);
    CHECK_THROWS_AS(taylor_coefficients(start, -1, T(1), recurrence::sine_cosine), libration::error);
}

TEMPLATE_LIST_TEST_CASE("coefficients agree with the table", "[coefficients][reference]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    std::string energy;
    std::string at;
    std::optional<expansion<T>> e;
    T power(1);
    for (const auto& row : reference_table("coefficients.csv")) {
        if (!e || row.at("energy") != energy || row.at("at") != at) {
            energy = row.at("energy");
            at = row.at("at");
            e = expanded<T>(energy, at, 40);
        }
        const int n = std::stoi(row.at("n"));
        power = n == 0 ? T(1) : T(power * e->scale);
        INFO("E = " << energy << " about " << at << ", n = " << n);
        const expected_value a_n = decimal(row.at("coefficient"));
        // The table has a_n: its scale is 8/(n R^n).
        const T unit = n == 0 ? T(8) : T(8 / (power * n));
        CHECK_THAT(T(e->scaled[n] / power), near<T>(a_n, allowed(n), unit));
        if (row.at("coefficient") == "0") {
            CHECK(e->scaled[n] == 0);
        }
    }
}

}  // namespace pendulum_coefficients_test
