#include "libration/pendulum/singularities.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_singularities_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

template <class T>
singularity_lattice<T> lattice_of(const std::string& energy) {
    return singularities<T>(with_energy(energy)).value();
}

template <class T>
T radius_at(const motion& m, const std::string& time) {
    return singularities<T>(m).value().radius(phase_map<T>(m).at(read_exact(time)));
}

template <class T>
T radius_at_top(const std::string& energy) {
    return radius_at<T>(with_energy(energy), "0");
}

// T* and K~' are correct to 4 ulps each (period_test); the hypotenuse averages them and adds half an ulp of the sum and
// of the root.
constexpr long radius_ulps = 5;

}  // namespace

TEMPLATE_LIST_TEST_CASE("the radius is the same at E and 2-E", "[singularities]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const std::string energy : {"1e-40", "1e-10", "0.25", "0.9"}) {
        INFO(energy);
        const T mirrored = radius_at<T>(with_gap(energy), "0");
        CHECK_THAT(radius_at_top<T>(energy), near<T>(mirrored, 2));  // the same two numbers in the other order
    }
}

TEMPLATE_LIST_TEST_CASE("at E = 1 the radius is the lemniscate constant", "[singularities]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    expected_value lemniscate;  // Gamma(1/4)^2 / (2 sqrt(2 pi)) = 2.62205755429211981...
    {
        const precision_scope wide(220);
        mpfr gamma = mpfr(1) / 4;
        mpfr_gamma(handle(gamma), handle(gamma), MPFR_RNDN);
        lemniscate = {gamma * gamma / (sqrt(pi<mpfr>() * 2) * 2), mpfr(0)};
    }
    CHECK_THAT(radius_at_top<T>("1"), near<T>(lemniscate, radius_ulps));
}

TEMPLATE_LIST_TEST_CASE("at E = 4 the radius about the bottom is T*", "[singularities]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto lattice = lattice_of<T>("4");
    CHECK(lattice.height == lattice.effective_period);
    CHECK(radius_at<T>(with_energy("4"), "T/2") == lattice.effective_period);
}

TEMPLATE_LIST_TEST_CASE("from the top the series covers T*, from the bottom it does for E < 1 and E > 4 alone",
                        "[singularities]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const std::string energy :
         {"1e-6", "0.5", "0.99", "1.01", "1.71", "1.9998", "2.02", "3.99", "4.01", "10", "1e6"}) {
        INFO(energy);
        const motion m = with_energy(energy);
        const auto lattice = lattice_of<T>(energy);
        CHECK(radius_at<T>(m, "0") > lattice.effective_period);
        const bool covers = fraction(energy) < 1 || fraction(energy) > 4;
        CHECK((radius_at<T>(m, m.regime() == regime::rotation ? "T/2" : "T/4") > lattice.effective_period) == covers);
    }
}

TEMPLATE_LIST_TEST_CASE("halfway down the nearest singularity is half T* away along the time axis", "[singularities]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::sqrt;
    for (const std::string energy : {"0.5", "1.71"}) {
        const auto lattice = lattice_of<T>(energy);
        const T half = lattice.effective_period / 2;
        const T expected = sqrt(half * half + lattice.height * lattice.height);
        CHECK_THAT(radius_at<T>(with_energy(energy), "T/8"), near<T>(expected, 2));
        CHECK_THAT(radius_at<T>(with_energy(energy), "-3T/8"), near<T>(expected, 2));
    }
}

TEMPLATE_LIST_TEST_CASE("the separatrix has one column of singularities, at the bottom", "[singularities]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::sqrt;
    const T right_angle = pi<T>() / 2;
    CHECK(radius_at<T>(with_energy("2"), "0") == right_angle);
    const T away = sqrt(right_angle * right_angle + 49);
    CHECK_THAT(radius_at<T>(with_energy("2"), "7"), near<T>(away, 2));
    CHECK_THAT(radius_at<T>(with_energy("2", -1), "-7"), near<T>(away, 2));
}

TEMPLATE_LIST_TEST_CASE("equilibria have no singularities", "[singularities]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    CHECK_FALSE(singularities<T>(with_energy("0")));
    CHECK_FALSE(singularities<T>(with_state("180deg", "0")));
}

TEMPLATE_LIST_TEST_CASE("radii about the top agree with the table", "[singularities][reference]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& row : reference_table("motions.csv")) {
        if (row.at("radius").empty()) {
            continue;
        }
        INFO(row.at("energy") << row.at("gap") << " " << row.at("theta0") << " " << row.at("omega0"));
        const auto lattice = singularities<T>(motion_of(row)).value();
        const T radius = lattice.radius(phase_map<T>::at_quarter(1));
        CHECK_THAT(radius, near<T>(decimal(row.at("radius")), radius_ulps));
    }
}

}  // namespace pendulum_singularities_test
