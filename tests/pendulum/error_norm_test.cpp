#include "libration/pendulum/error_norm.hpp"

#include "scalars.hpp"

namespace pendulum_error_norm_test {

using namespace libration;
using namespace libration::elliptic;
using namespace libration::pendulum;
using libration::tests::near;

namespace {

// The error of an approximation at x, by the definition: a polynomial minus the sum over separatrix solutions.
template <class F>
mpfr error_at(const motion& m, const F& approximation, const mpfr& x) {
    const separatrix_sum<mpfr> sum(m);
    const mpfr from_bottom = (x - 1) * arc_of<mpfr>(m).effective_period();
    return approximation(x).value - sum.at({2, from_bottom, decided_sign(from_bottom)}).value;
}

}  // namespace

TEST_CASE("the norm of the series is its error at T*, where it grows monotonically", "[error_norm]") {
    const precision_scope scope(60);
    const motion m = motion::of_energy(rational(171, 100));
    arc_errors errors(m);
    const norm_at<mpfr> found = errors.norm(arc_method::series, 10);
    CHECK(found.place == 1);
    // 60 digits of theta leave 1e-60/0.07 of the norm: 2^6 epsilon with the rounding of both routes.
    CHECK_THAT(found.norm, near<mpfr>(mpfr(abs(error_at(m, series_from_top(errors.arc(), 10), mpfr(1)))), 64));
}

TEST_CASE("no point of a fine grid exceeds the norm, and a neighbour of its place comes close", "[error_norm]") {
    const precision_scope scope(60);
    for (const char* energy : {"0.5", "1.9998", "2.02", "4"}) {
        const motion m = motion::of_energy(read_exact(energy).coefficient);
        arc_errors errors(m);
        const fundamental_arc<mpfr> arc = arc_of<mpfr>(m);
        const auto approximation = resummation_from_top(arc, 20);
        const exact_solution<mpfr> truth(m);
        const norm_at<mpfr> found = errors.norm(arc_method::resummed, 20);
        mpfr largest = 0;
        for (int i = 0; i <= 2000; ++i) {
            const mpfr x = mpfr(i) / 2000;
            largest = std::max(largest, mpfr(abs(approximation(x).value - truth.from_top(x).theta)));
        }
        INFO("E = " << energy);
        CHECK(largest <= found.norm);
        // The grid misses a smooth maximum by less than a thousandth: (1/4000)^2 e''/(2 e) with e''/e below 2 N^2.
        CHECK(largest >= found.norm * mpfr(999) / 1000);
        // Both routes round theta to 2^-200; relative to a norm of 1e-5 to 1e-9 that is at most 2^30 epsilon.
        CHECK_THAT(found.norm, near<mpfr>(errors.second_opinion(arc_method::resummed, 20, found.place), 1L << 30));
    }
}

TEST_CASE("a clockwise rotation has the norms of the counterclockwise one", "[error_norm]") {
    const precision_scope scope(60);
    arc_errors forward(motion::of_energy(rational(4), 1));
    arc_errors backward(motion::of_energy(rational(4), -1));
    const auto a = forward.norm(arc_method::resummed, 12);
    const auto b = backward.norm(arc_method::resummed, 12);
    CHECK_THAT(a.norm, near<mpfr>(b.norm, 1L << 30));  // the mirror image rounds at 2 pi instead of pi: eps pi/norm
}

TEMPLATE_TEST_CASE("a fixed scalar stops at its rounding floor", "[error_norm]", double, long double, quad) {
    const precision_scope scope(80);
    const motion m = motion::of_energy(rational(1, 2));
    arc_errors errors(m);
    const int order = 160;  // far below the floor of quad: 1e-45
    const auto exact = errors.norm(arc_method::resummed, order);
    const auto rounded = errors.norm_in<TestType>(arc_method::resummed, order, m, exact.place);
    CHECK(exact.norm < widen(epsilon<TestType>()) / 1000);
    CHECK(rounded.norm > 0);
    CHECK(rounded.norm < widen(epsilon<TestType>()) * 8);  // theta <= pi/3, and T* and theta* are each within 4 epsilon
}

TEMPLATE_TEST_CASE("points that the exact error leaves out do not change a rounded norm", "[error_norm]", double,
                   long double, quad) {
    const precision_scope scope(80);
    for (const char* energy : {"1e-3", "0.5", "1.71", "1.9999", "2.001", "3", "8"}) {
        const motion m = motion::of_energy(read_exact(energy).coefficient);
        for (const int order : {1, 5, 10, 20, 40, 80}) {
            for (const auto method : {arc_method::series, arc_method::resummed}) {
                arc_errors errors(m);
                // Before norm() all points count.
                const auto whole = errors.norm_in<TestType>(method, order, m, mpfr(1));
                errors.norm(method, order);
                const auto left = errors.norm_in<TestType>(method, order, m, mpfr(1));
                INFO("E = " << energy << ", N = " << order << ", " << name_of(method));
                CHECK(left.place == whole.place);
                CHECK(left.norm == whole.norm);
            }
        }
    }
}

TEST_CASE("theta is asked for where the error of a low order may be largest", "[error_norm]") {
    const precision_scope scope(40);
    const motion m = motion::of_energy(rational(171, 100));
    arc_errors errors(m);
    const auto approximation = resummation_from_top(errors.arc(), 10);
    const sampled_error error = errors.error_of(approximation, 65);
    const rounded_grid grid;
    const auto places = grid.places_above(&error, mpfr(error.largest.norm * mpfr(99) / 100));
    CHECK(places.size() < grid.points().size() / 3);
    // They include all points where the error is above the level.
    std::size_t next = 0;
    for (std::size_t i = 0; i < grid.points().size(); ++i) {
        next += next < places.size() && places[next] < i ? 1 : 0;
        const mpfr x(grid.points()[i]);
        const bool above = abs(error_at(m, approximation, x)) > error.largest.norm * mpfr(99) / 100;
        CHECK((!above || (next < places.size() && places[next] == i)));
    }
    CHECK(grid.places_above(nullptr, mpfr(1)).size() == grid.points().size());
}

TEST_CASE("the norms carry the digits that the order takes away", "[error_norm]") {
    const motion m = motion::of_energy(rational(1, 2));
    // At E = 1/2 the rate is 10^-0.24 per power: N = 80 is about 1e-23.
    CHECK(digits_below(m, 80) > 23);
    CHECK(digits_below(m, 80) < 60);
}

}  // namespace pendulum_error_norm_test
