// Where to expand: the claims about top, bottom and the points between.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "libration/pendulum/expansion.hpp"
#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace paper_expansion_point_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

// The largest |a_n| T*^n for n from 200 to 203, about a point.
mpfr far_term(const std::string& energy, const std::string& at) {
    const motion m = with_energy(energy);
    const auto e = expand(exact_solution<mpfr>(m), read_expansion_point(at), 203);
    const mpfr ratio = effective_period(energy_level_of<mpfr>(m)) / e.scale;
    mpfr largest(0);
    for (int n = 200; n <= 203; ++n) {
        largest = std::max(largest, mpfr(abs(e.scaled[n]) * pow(ratio, n)));
    }
    return largest;
}

mpfr radius_at(const std::string& energy, const std::string& time) {
    const motion m = with_energy(energy);
    return singularities<mpfr>(m)->radius(phase_map<mpfr>(m).at(read_exact(time)));
}

}  // namespace

TEST_CASE("from the top the series reaches the bottom at every energy", "[paper]") {
    const precision_scope precision(40);
    for (const std::string energy : {"0.1", "0.5", "1", "1.71", "2.02", "4", "10"}) {
        INFO(energy);
        CHECK(far_term(energy, "top") < mpfr(1) / 1000);
    }
}

TEST_CASE("from the bottom it fails to reach T* for 1 < E < 4 alone, not for every E < 2", "[paper]") {
    const precision_scope precision(40);
    for (const std::string energy : {"1.2", "1.71", "2.02", "3.5"}) {
        INFO(energy);
        CHECK(far_term(energy, "bottom") > 1000);
    }
    for (const std::string energy : {"0.1", "0.5", "0.8", "4.6", "10"}) {
        INFO(energy);
        CHECK(far_term(energy, "bottom") < mpfr(1) / 1000);
    }
}

TEST_CASE("the radius falls all the way from the top to the bottom", "[paper]") {
    const precision_scope precision(40);
    for (const std::string energy : {"0.5", "1.71", "2.02", "10"}) {
        const motion m = with_energy(energy);
        const int quarters = quarters_per_period(m.regime());
        mpfr before;
        for (int i = 0; i <= 10; ++i) {
            const exact time{rational(i, 10 * quarters), unit::period, ""};
            const mpfr radius = singularities<mpfr>(m)->radius(phase_map<mpfr>(m).at(time));
            INFO("E = " << energy << ", " << i << "/10 of the way");
            CHECK((i == 0 || radius < before));
            before = radius;
        }
    }
}

TEST_CASE("an expansion half way covers the descent at a better rate a power than one at the top", "[paper]") {
    const precision_scope precision(40);
    for (const std::string energy : {"0.1", "0.5", "1", "1.71", "1.9998", "2.02", "4", "10"}) {
        const motion m = with_energy(energy);
        const mpfr period = effective_period(energy_level_of<mpfr>(m));
        const mpfr top_rate = period / radius_at(energy, "0");
        const mpfr half_rate = period / 2 / radius_at(energy, m.regime() == regime::rotation ? "T/4" : "T/8");
        INFO(energy);
        CHECK(half_rate < top_rate);
    }
}

}  // namespace paper_expansion_point_test
