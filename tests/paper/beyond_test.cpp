// The claims of this program's own, judged again in other words.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "libration/pendulum/error_norm.hpp"
#include "libration/pendulum/singularities.hpp"
#include "libration/pendulum/uniform_resummation.hpp"
#include "paper/judged.hpp"
#include "paper/verdicts.hpp"
#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace paper_beyond_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

TEST_CASE("claim uniform_rate_below_third: holds, the nearest singularities left are three T* away",
          "[paper][claims]") {
    check_claim("uniform_rate_below_third", verdict::holds, "0.2", "0.333");
    // T*/|3 T* + i K~'| by T* and R alone, K~'^2 = R^2 - T*^2.
    const precision_scope precision(250);
    for (const std::string gap : {"1.99999999", "1", "1e-100", "-1e-100", "-2", "-1e6"}) {
        const auto lattice = singularities<mpfr>(with_gap(gap));
        const mpfr along = lattice->effective_period * 3;
        const mpfr distance = sqrt(along * along + lattice->height * lattice->height);
        CHECK(lattice->effective_period / distance < mpfr(1) / 3);
    }
}

TEST_CASE("claim sixteen_coefficients: holds, below theorem U's 1.4e-16", "[paper][claims]") {
    check_claim("sixteen_coefficients", verdict::holds, "1e-17", "1.4e-16");
    // In double itself, at one energy of each kind: within two units in the last place of max(1, theta).
    for (const std::string gap : {"1.99999999", "0.29", "1e-12", "-1e-12", "-2"}) {
        const motion m = with_gap(gap);
        const auto uniform = uniform_from_top<double>(m, m.regime() == regime::rotation ? 31 : 32);
        const precision_scope precision(60);
        const exact_solution<mpfr> truth(m);
        for (int i = 0; i <= 32; ++i) {
            const double x = i / 32.0;
            const mpfr theta = truth.from_top(mpfr(x)).theta;
            CHECK(abs(mpfr(uniform.value(x)) - theta) < std::max(mpfr(1), theta) * mpfr("1.4e-15"));
        }
    }
}

TEST_CASE("claim uniform_bound: holds, theorem U is above every error", "[paper][claims]") {
    check_claim("uniform_bound", verdict::holds, "1", "3");
}

TEST_CASE("claim two_columns_are_the_motion: holds, what is left is |2-E|/8", "[paper][claims]") {
    check_claim("two_columns_are_the_motion", verdict::holds, "0", "1e-6");
    // At the bottom of libration, where theta = 0, the two columns are 2 gd(2y) - pi = -2 atan(1/sinh 2y), and |2-E| is
    // 32 exp(-2y) there.
    const precision_scope precision(60);
    const auto o = energy_level_of<mpfr>(with_gap("1e-20"));
    const mpfr y = half_column_distance(o);
    CHECK(abs(atan(1 / sinh(y * 2)) * 2 / mpfr("1.25e-21") - 1) < mpfr("1e-3"));
}

TEST_CASE("claim resummation_keeps_the_rate: holds, the gain is a power of N", "[paper][claims]") {
    check_claim("resummation_keeps_the_rate", verdict::holds, "0.99", "1.01");
}

TEST_CASE("claim two_point_diverges: holds, below 7.74e-5", "[paper][claims]") {
    check_claim("two_point_diverges", verdict::holds, "10", "1e9");
}

}  // namespace paper_beyond_test
