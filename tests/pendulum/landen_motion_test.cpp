#include "libration/pendulum/landen_motion.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <string>
#include <vector>

#include "pendulum/typed.hpp"
#include "reference_table.hpp"
#include "scalars.hpp"

namespace pendulum_landen_motion_test {

using namespace libration;
using namespace libration::elliptic;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

ball around(const expected_value& expected) { return enclose(ball(expected.value), ball(expected.uncertainty)); }

// The radius in units of the working precision times max(1, |x|, scale).
long lost_bits(const ball& x, const ball& scale) {
    const ball size = abs(x) + abs(scale) + 1;
    return binary_exponent(radius_of(x) / size) + digits<ball>();
}

struct typed_case {
    rational energy;
    rational gap;
    rational time;
};

// Energies and gaps of all sizes on both sides of 2, times of either sign.
std::vector<typed_case> random_cases(int count) {
    std::mt19937_64 engine(20);
    const auto below = [&engine](long n) { return static_cast<long>(engine() % static_cast<unsigned long>(n)); };
    const auto sized = [&](long exponent) {
        return fraction(std::to_string(1 + below(9)) + "." + std::to_string(below(100000)) + "e" +
                        std::to_string(exponent));
    };
    std::vector<typed_case> cases;
    for (int i = 0; i < count; ++i) {
        typed_case at;
        switch (i % 4) {
            case 0: at.energy = rational(1 + below(199'999), 100'000); break;
            case 1: at.energy = sized(-1 - below(60)); break;
            case 2: at.energy = 2 + sized(below(6)); break;
            default: at.energy = 2 + sized(-1 - below(80)) * (below(2) == 0 ? 1 : -1); break;
        }
        at.gap = 2 - at.energy;
        at.time = sized(i % 5 == 0 ? below(25) : below(4) - 2) * (below(2) == 0 ? 1 : -1);
        cases.push_back(at);
    }
    return cases;
}

}  // namespace

TEST_CASE("the Landen motion encloses the rows of the table", "[landen_motion]") {
    // The rows are correct to a unit of their 60th digit. The time uses as many of the 80 digits as it has before its
    // point, and the quotients near E = 2 the size of 1/k' < 10^11.
    const precision_scope scope(100);
    int rows = 0;
    for (const table_row& row : reference_table("motions.csv")) {
        const bool canonical = row.at("theta0").empty() && row.at("direction").empty();
        if (!canonical || row.at("energy") == "2" || row.at("time").find('T') != std::string::npos) {
            continue;
        }
        const rational gap = row.at("gap").empty() ? rational(2 - fraction(row.at("energy"))) : fraction(row.at("gap"));
        const rational energy = 2 - gap;
        INFO("E " << row.at("energy") << " gap " << row.at("gap") << " time " << row.at("time"));
        const landen_motion motion(energy, gap);
        const ball z = motion.phase_at(fraction(row.at("time")));
        const auto state = motion.state_at(z);
        CHECK(overlaps(state.theta, around(decimal(row.at("theta")))));
        CHECK(overlaps(state.omega, around(decimal(row.at("omega")))));
        CHECK(overlaps(motion.theta_at(z), state.theta));
        CHECK(certainly_less(radius_of(state.theta), ldexp(abs(state.theta) + 1, -220)));
        ++rows;
    }
    CHECK(rows > 40);
}

TEST_CASE("the Landen motion encloses what twice the precision encloses", "[landen_motion]") {
    for (const typed_case& at : random_cases(300)) {
        INFO("E " << at.energy << " at " << at.time);
        enclosed_state rough;
        ball angle;
        long lost = 0;
        {
            const precision_scope scope(40);
            const landen_motion motion(at.energy, at.gap);
            const ball z = motion.phase_at(at.time);
            rough = motion.state_at(z);
            angle = motion.theta_at(z);
            lost = std::max(lost_bits(rough.theta, z), lost_bits(angle, z));
        }
        const precision_scope scope(200);
        const landen_motion motion(at.energy, at.gap);
        const auto fine = motion.state_at(motion.phase_at(at.time));
        CHECK(contains(rough.theta, fine.theta));
        CHECK(contains(rough.omega, fine.omega));
        CHECK(contains(angle, fine.theta));
        // log2 K <= 7 levels at gaps of 1e-80, each of which doubles the slope, and 5 units for the operations of each.
        CHECK(lost <= 20);
    }
}

TEST_CASE("the Landen motion conserves the energy within its own radius", "[landen_motion]") {
    const precision_scope scope(120);
    for (const typed_case& at : random_cases(200)) {
        INFO("E " << at.energy << " at " << at.time);
        const landen_motion motion(at.energy, at.gap);
        const auto state = motion.state_at(motion.phase_at(at.time));
        const ball half = sin(state.theta / 2);
        CHECK(overlaps(half * half * 2 + state.omega * state.omega / 2, from_rational<ball>(at.energy)));
    }
}

TEST_CASE("the Landen motion agrees with the exact solution in many digits", "[landen_motion]") {
    // 400 and 1500 digits take two and three terms of the theta series.
    for (const long count : {20L, 60L, 400L, 1500L}) {
        const precision_scope scope(count);
        for (const std::string energy : {"1.71", "0.3", "1.9999", "2.0001", "7"}) {
            INFO(count << " digits, E " << energy);
            const rational e = fraction(energy);
            const landen_motion motion(e, rational(2 - e));
            const auto state = motion.state_at(motion.phase_at(rational(7, 10)));
            expected_value theta;
            expected_value omega;
            {
                const precision_scope more(count + 30);
                const auto truth = exact_solution<mpfr>(with_energy(energy))(read_exact("0.7"));
                const mpfr uncertainty = pow(mpfr(10), -static_cast<int>(count) - 10);
                theta = {truth.theta, uncertainty};
                omega = {truth.omega, uncertainty};
            }
            CHECK(overlaps(state.theta, around(theta)));
            CHECK(overlaps(state.omega, around(omega)));
            CHECK(lost_bits(state.theta, ball(1)) <= 16);  // 2 units for each of the operations of 7 levels
        }
    }
}

TEST_CASE("the nome and the mean of the descent are those of the complete integrals", "[landen_motion]") {
    // M = pi/(2K) and P = exp(-pi K'/K 2^r) with K from the rounding scalar at 20 more digits.
    for (const std::string complement : {"0.9999", "0.7", "0.38", "0.01", "1e-12", "1e-40"}) {
        for (const long count : {16L, 60L, 700L}) {
            INFO("k' " << complement << ", " << count << " digits");
            const rational b = fraction(complement);
            expected_value mean;
            expected_value ratio;
            {
                const precision_scope scope(count + 60);
                const auto m = modulus<mpfr>::from_complement(from_rational<mpfr>(b));
                const mpfr integral = complete_integral(m);
                mean = {mpfr(pi<mpfr>() / (integral * 2)), mpfr(0)};
                ratio = {mpfr(complete_integral(m.swapped()) / integral), mpfr(0)};
                mean.uncertainty = ratio.uncertainty = pow(mpfr(10), -static_cast<int>(count) - 10);
            }
            const precision_scope scope(count);
            const landen_nome nome(ball(1), from_rational<ball>(b), from_rational<ball>(rational((1 - b * b) / 4)));
            CHECK(overlaps(nome.mean(), around(mean)));
            const ball exponent = around(ratio) * pi<ball>() * ldexp(ball(1), nome.levels());
            CHECK(overlaps(nome.square_power(1), exp(-exponent)));
            CHECK(lost_bits(nome.mean(), ball(1)) <= 8);
        }
    }
}

TEST_CASE("the Landen motion refuses what has no period", "[landen_motion]") {
    const precision_scope scope(30);
    CHECK_THROWS_AS(landen_motion(rational(2), rational(0)), libration::error);
    CHECK_THROWS_AS(landen_motion(rational(0), rational(2)), libration::error);
    CHECK_THROWS_AS(landen_motion(rational(1), rational(2)), libration::error);
    // A turn cannot be determined if the time has more digits than the precision.
    const landen_motion rotation(rational(3), rational(-1));
    CHECK_THROWS_AS(rotation.state_at(rotation.phase_at(fraction("1e60"))), precision_exhausted);
}

}  // namespace pendulum_landen_motion_test
