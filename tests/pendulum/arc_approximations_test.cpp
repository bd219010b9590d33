// The approximations in comparison: each uses the stated coefficients.
#include "libration/pendulum/arc_approximations.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_descent_approximations_test {

using namespace libration;
using namespace libration::series;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

// The nonzero coefficients of powers of t, from the series of both ends themselves.
int numbers_taken(const fundamental_arc<mpfr>& arc, const approximation_size& size) {
    const auto counted = [](const mpfr& x) { return x != 0; };
    const auto top = arc_series(arc, size.order).coefficients();
    const auto bottom = arc_endpoint(arc, size.conditions);
    const auto of_top = std::count_if(top.begin() + 1, top.end(), counted);
    const auto of_bottom = bottom.empty() ? 0 : std::count_if(bottom.begin() + 1, bottom.end(), counted);
    return static_cast<int>(of_top + of_bottom);
}

}  // namespace

TEST_CASE("a size takes as many numbers as asked for", "[descent_approximations]") {
    const precision_scope precision(30);
    for (const std::string energy : {"1.71", "4"}) {
        const fundamental_arc<mpfr> arc = arc_of<mpfr>(with_energy(energy));
        const int parity = parity_from_top(arc.level().regime);
        for (const approximation a : all_approximations) {
            for (int count = 1; count <= 12; ++count) {
                INFO("E = " << energy << ", " << name_of(a) << ", " << count);
                const auto size = size_for(a, count, parity);
                if (size) {
                    CHECK(numbers_taken(arc, *size) == count);
                } else {
                    const bool two_ends = a == approximation::two_point && parity == 1 && count % 2 == 1;
                    CHECK((two_ends || count <= fixed_conditions(a) / 2));
                }
            }
        }
    }
}

TEST_CASE("proved norms are above the norms of all approximations that have one", "[descent_approximations]") {
    const precision_scope precision(100);
    for (const std::string gap : {"1.5", "0.29", "1e-6", "-0.02", "-98"}) {
        const motion m = with_gap(gap);
        arc_errors errors(m);
        for (const approximation a : all_approximations) {
            for (const int count : {4, 10, 16}) {
                const auto size = size_for(a, count, errors.bounds().parity);
                const auto bound = size ? proved_norm(a, *size, errors.bounds()) : std::nullopt;
                if (bound) {
                    INFO("gap " << gap << ", " << name_of(a) << ", " << count);
                    with_approximation(a, m, errors.arc(), count,
                                       [&](const auto& f) { CHECK(errors.norm_of(f, 2 * count).norm <= *bound); });
                }
            }
        }
    }
}

TEST_CASE("rates a coefficient are those of the headers", "[descent_approximations]") {
    const precision_scope precision(30);
    const auto bounds = top_bounds<mpfr>::of(energy_level_of<mpfr>(with_energy("1.71")));
    CHECK_FALSE(convergence_rate(approximation::pade, bounds));
    CHECK(*convergence_rate(approximation::eighth, bounds) == bounds.rho * bounds.rho);
    CHECK(*convergence_rate(approximation::uniform, bounds) < mpfr(1) / 9);
    CHECK(*convergence_rate(approximation::two_point, bounds) == two_point_rate(bounds));
    // The two-point expansion has a better rate than the uniform resummation where the header states so.
    const auto better = [](const std::string& energy) {
        const auto b = top_bounds<mpfr>::of(energy_level_of<mpfr>(with_energy(energy)));
        return *convergence_rate(approximation::two_point, b) < *convergence_rate(approximation::uniform, b);
    };
    CHECK(better("0.233"));
    CHECK_FALSE(better("0.234"));
    CHECK_FALSE(better("17.1"));
    CHECK(better("17.2"));
}

}  // namespace pendulum_descent_approximations_test
