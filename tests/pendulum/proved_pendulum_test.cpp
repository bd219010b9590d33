// The pendulum on balls: every value of the tables is contained, two routes overlap, and the balls are narrow.
#include <catch2/catch.hpp>
#include <string>

#include "libration/pendulum/bounds.hpp"
#include "libration/pendulum/expansion.hpp"
#include "libration/pendulum/resummation.hpp"
#include "libration/pendulum/separatrix_sum.hpp"
#include "libration/pendulum/vanishing_coefficients.hpp"
#include "pendulum/typed.hpp"
#include "proved.hpp"

namespace pendulum_proved_pendulum_test {

using namespace libration;
using namespace libration::series;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

// Contains the table's value up to the last digit of the table.
bool contains_table(const ball& x, const std::string& text) {
    const expected_value expected = decimal(text);
    return contains(enclose(x, ball(expected.uncertainty)), ball(expected.value));
}

}  // namespace

TEST_CASE("balls of the exact solution contain the table of motions", "[pendulum][ball]") {
    for (const long asked : {20L, 50L}) {
        const precision_scope scope(asked);
        for (const table_row& row : reference_table("motions.csv")) {
            INFO(row.at("energy") << " " << row.at("gap") << " " << row.at("theta0") << " " << row.at("omega0")
                                  << " at " << row.at("time"));
            const motion m = motion_of(row);
            const auto state = state_of<ball>(m, row.at("time"));
            // A few roundings at each of up to 20 levels; theta has them relative to itself if it counts turns.
            CHECK_THAT(state.theta,
                       encloses(decimal(row.at("theta")), 2'000, mpfr(1 + abs(decimal(row.at("theta")).value))));
            CHECK_THAT(state.omega,
                       encloses(decimal(row.at("omega")), 2'000, mpfr(1 + abs(decimal(row.at("omega")).value))));
            if (!at_critical_energy(m.regime())) {
                const ball tstar = effective_period(energy_level_of<ball>(m));
                CHECK_THAT(tstar, encloses(decimal(row.at("tstar")), 100));
                CHECK(contains_table(tstar * quarters_per_period(m.regime()), row.at("period")));
                const auto lattice = singularities<ball>(m);
                if (lattice && row.at("radius") != "inf") {
                    CHECK(contains_table(lattice->radius(phase_map<ball>::at_quarter(1)), row.at("radius")));
                }
            }
        }
    }
}

TEST_CASE("two routes to the exact solution overlap as balls", "[pendulum][ball]") {
    const precision_scope scope(40);
    for (const auto& [name, m] : periodic_motions()) {
        const exact_solution<ball> first(m);
        const separatrix_sum<ball> second(m);
        for (const std::string time : {"0", "0.7", "-3.3", "T/4", "2T/3", "1e15"}) {
            INFO(name << " at " << time);
            const auto state = first(read_exact(time));
            const auto sum = second(read_exact(time));
            CHECK(overlaps(state.theta, sum.value));
            CHECK(overlaps(state.omega, sum.slope));
            // E = omega^2/2 + 2 sin^2(theta/2).
            const ball energy = energies<ball>(m).energy;
            CHECK(contains_zero(state.omega * state.omega / 2 + state.half_sine * state.half_sine * 2 - energy));
        }
    }
}

TEST_CASE("balls of the coefficients contain the table", "[pendulum][ball]") {
    for (const auto by : {recurrence::symmetric_squares, recurrence::sine_cosine}) {
        const precision_scope scope(50);
        std::string place;
        expansion<ball> series;
        for (const table_row& row : reference_table("coefficients.csv")) {
            if (place != row.at("energy") + row.at("at")) {
                place = row.at("energy") + row.at("at");
                const motion m = with_energy(row.at("energy"));
                series = expand_by(by, exact_solution<ball>(m), read_expansion_point(row.at("at")), 40);
            }
            INFO(place << ", n = " << row.at("n"));
            const int n = std::stoi(row.at("n"));
            const ball coefficient = series.scaled[n] / pow(series.scale, n);
            CHECK(contains_table(coefficient, row.at("coefficient")));
            // In units of 8/n the radius stays below the 20 bits that the recurrence loses by N = 4000.
            CHECK_FALSE(certainly_less(epsilon<ball>() * 1'000'000, radius_of(series.scaled[n])));
        }
    }
}

TEST_CASE("proved bounds of the tail and of the resummation hold between balls", "[pendulum][ball]") {
    const precision_scope scope(50);
    for (const std::string energy : {"0.5", "1.71", "1.9998", "2.02", "4"}) {
        const motion m = with_energy(energy);
        const exact_solution<ball> truth(m);
        const auto arc = arc_of<ball>(m);
        const auto bounds = top_bounds<ball>::of(arc.level());
        for (const int order : {4, 11, 30}) {
            const auto series = series_from_top(arc, order);
            const auto resummed = resummation_from_top(arc, order);
            for (const int tenths : {0, 3, 7, 10}) {
                INFO("E = " << energy << ", order " << order << ", x = " << tenths << "/10");
                const ball x = ball(tenths) / 10;
                const ball theta = truth.from_top(x).theta;
                CHECK(overlaps(enclose(series.value(x), bounds.series_norm(order)), theta));
                CHECK_FALSE(certainly_less(bounds.series_norm(order), abs(series.value(x) - theta)));
                CHECK(overlaps(enclose(resummed.value(x), bounds.resummation_norm(order)), theta));
                CHECK_FALSE(certainly_less(bounds.resummation_norm(order), abs(resummed.value(x) - theta)));
            }
        }
    }
}

TEST_CASE("a time next to a quarter is decided with more digits or refused", "[pendulum][ball]") {
    const precision_scope scope(30);
    // T* of E = 1 to 40 digits: the distance of the typed time to the top is 1e-40.
    const motion m = with_energy("1");
    const std::string near = "1.854074677301371918433850347195260046218";
    CHECK(exact_solution<ball>(m).phases().at(read_exact(near)).side != 0);
    const exact beyond = read_exact("1.8540746773013719184338503471952600462175988235217669055859488");
    CHECK(std::abs(exact_solution<ball>(m).phases().at(beyond).side) == 1);
}

TEST_CASE("coefficients that vanish are found by fractions", "[pendulum][ball]") {
    const auto from = [](const std::string& energy, int quarter, int order) {
        const motion m = with_energy(energy);
        return vanishing_coefficients(*m.energy(), rational_cosine_at(m, integer(quarter)).value(), order);
    };
    // At E = 1 from the top theta(i t) - pi/2 = -(theta(t) - pi/2): only n = 2 mod 4 survives [DESIGN 3].
    const auto lemniscate = from("1", 1, 41);
    for (int n = 1; n <= 41; ++n) {
        CHECK(lemniscate[static_cast<std::size_t>(n)] == (n % 4 != 2));
    }
    // From the top of rotation the fifth derivative is omega (1 - omega^2), omega^2 = 2E - 4: 0 at E = 5/2.
    CHECK(from("2.5", 1, 5)[5]);
    CHECK_FALSE(from("2.6", 1, 5)[5]);
    // The symmetries: even powers of libration from the top, odd ones of everything else.
    const auto even = from("1.71", 1, 20);
    const auto odd = from("1.71", 0, 20);
    for (int n = 1; n <= 20; ++n) {
        CHECK(even[static_cast<std::size_t>(n)] == (n % 2 == 1));
        CHECK(odd[static_cast<std::size_t>(n)] == (n % 2 == 0));
    }
    CHECK_FALSE(rational_cosine_at(with_state("2.5", "-0.3"), integer(0)));
}

TEST_CASE("the fractions agree with balls about a point without symmetry", "[pendulum][ball]") {
    const precision_scope scope(60);
    // cos theta0 = 0, 1/2, -1/2, 0: where it is 0, a_3 = -cos(theta0) omega0/6 vanishes.
    for (const auto& [theta0, omega0] :
         {std::pair{"90deg", "0.5"}, {"60deg", "0.5"}, {"120deg", "-1/3"}, {"-270deg", "3"}}) {
        const motion m = with_state(theta0, omega0);
        const auto series = expand(exact_solution<ball>(m), read_expansion_point("start"), 24);
        const auto vanishes = vanishing_coefficients(*m.energy(), rational_cosine_at_start(m).value(), 24);
        for (int n = 1; n <= 24; ++n) {
            INFO(theta0 << ", " << omega0 << ", n = " << n);
            CHECK(vanishes[static_cast<std::size_t>(n)] == contains_zero(series.scaled[n]));
        }
    }
    CHECK_FALSE(rational_cosine_at_start(with_state("1", "0.5")));
}

}  // namespace pendulum_proved_pendulum_test
