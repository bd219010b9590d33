#include "libration/pendulum/proved_norm.hpp"

#include "proved.hpp"

namespace pendulum_proved_norm_test {

using namespace libration;
using namespace libration::pendulum;

namespace {

constexpr std::array both{arc_method::series, arc_method::resummed};

rational energy_of(const char* text) { return read_exact(text).coefficient; }

}  // namespace

TEST_CASE("proved norms hold those of refined samples", "[proved_norm]") {
    constexpr long wanted = 30;
    for (const char* text :
         {"1e-6", "0.5", "1", "1.71", "1.9998", "1.9999999999", "2.0000000001", "2.02", "4", "1e6"}) {
        const rational energy = energy_of(text);
        const motion m = motion::of_energy(energy);
        const long below = digits_below(m, 21);
        const precision_scope scope(wanted + below + 20);
        const proved_arc_errors proved(libration::exactly(energy));
        arc_errors sampled(m);
        for (const auto method : both) {
            for (const int order : {0, 1, 8, 21}) {
                INFO("E = " << text << ", N = " << order << ", resummed " << (method == arc_method::resummed));
                const proved_maximum found = proved.norm(method, order);
                const norm_at<mpfr> other = sampled.norm(method, order);
                // The sampled maximum is correct to the added digits, and its position to half of them.
                const ball unit = ball(other.norm) * pow(ball(10), -wanted);
                CHECK(overlaps(found.value, enclose(ball(other.norm), unit)));
                CHECK(certainly_less(radius_of(found.value), unit));
                CHECK(overlaps(found.place, enclose(ball(other.place), pow(ball(10), -wanted / 2))));
            }
        }
    }
}

TEST_CASE("proved norms are below the bounds A and A2, by theorem and by number", "[proved_norm]") {
    for (const char* text : {"0.5", "1.71", "1.999999", "2.000001", "4"}) {
        const rational energy = energy_of(text);
        const precision_scope scope(60);
        const proved_arc_errors proved(libration::exactly(energy));
        const auto bounds = top_bounds<ball>::of(energy_level_of<ball>(motion::of_energy(energy)));
        for (const int order : {4, 11, 30}) {
            INFO("E = " << text << ", N = " << order);
            CHECK(certainly_less(proved.norm(arc_method::series, order).value, bounds.series_norm(order)));
            CHECK(certainly_less(proved.norm(arc_method::resummed, order).value, bounds.resummation_norm(order)));
        }
    }
}

TEST_CASE("a polynomial of higher order than the panels has its norm too", "[proved_norm]") {
    const rational energy = energy_of("0.5");
    const motion m = motion::of_energy(energy);
    // 60 digits make panels of the order 110 or so; the polynomial has the degree 150 and is 1e-36 away from theta.
    const precision_scope scope(60);
    const proved_arc_errors proved(libration::exactly(energy));
    const proved_maximum found = proved.norm(arc_method::series, 150);
    const auto bounds = top_bounds<ball>::of(energy_level_of<ball>(m));
    CHECK(certainly_less(found.value, bounds.series_norm(150)));
    CHECK(certainly_less(radius_of(found.value), found.value * pow(ball(10), -15)));
}

TEST_CASE("equilibria have no norm", "[proved_norm]") {
    const precision_scope scope(30);
    CHECK_THROWS_AS(proved_arc_errors(libration::exactly(0)), libration::error);
    CHECK_THROWS_AS(proved_arc_errors(libration::exactly(2)), libration::error);
    CHECK_THROWS_AS(proved_arc_errors(libration::exactly(1)).norm(arc_method::series, -1), libration::error);
}

}  // namespace pendulum_proved_norm_test
