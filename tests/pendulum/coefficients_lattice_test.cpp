// The coefficients against their other closed form, the sum over all singularities (DESIGN section 3):
//     a_n = (8/n) sum_{p,q >= 0} (-1)^(p+q) Im z^-n below E = 2,  -(8/n) sum (-1)^q Im z^-n above,
// z = (2p+1) T* + i (2q+1) K~', n of the right parity.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include "libration/pendulum/expansion.hpp"
#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_coefficients_lattice_test {

using namespace libration;
using namespace libration::series;
using namespace libration::elliptic;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

struct complex_number {
    mpfr re;
    mpfr im;
};
complex_number times(const complex_number& a, const complex_number& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

// n a_n scale^n / 8 for n = 0 .. N, summed over p, q < box, at the working precision. The scale is the radius as the
// scalar under test has it.
std::vector<mpfr> lattice_sum(const std::string& energy, int order, int box, const mpfr& scale) {
    const auto lattice = singularities<mpfr>(with_energy(energy)).value();
    const bool rotates = fraction(energy) > 2;
    std::vector<mpfr> sums(static_cast<std::size_t>(order) + 1, mpfr(0));
    for (int p = 0; p < box; ++p) {
        for (int q = 0; q < box; ++q) {
            const mpfr re = lattice.effective_period * (2 * p + 1) / scale;
            const mpfr im = lattice.height * (2 * q + 1) / scale;
            const mpfr square = re * re + im * im;
            const complex_number inverse{re / square, -im / square};
            complex_number power{mpfr(1), mpfr(0)};
            const int sign = rotates ? (q % 2 == 0 ? -1 : 1) : ((p + q) % 2 == 0 ? 1 : -1);
            for (int n = 0; n <= order; ++n) {
                sums[static_cast<std::size_t>(n)] += power.im * sign;
                power = times(power, inverse);
            }
        }
    }
    return sums;
}

// The contribution of the poles outside the box to n a_n R^n/8: at most 8 m poles of index sum m at distance m *
// shortest.
mpfr left_out(const std::string& energy, int n, int box) {
    const auto lattice = singularities<mpfr>(with_energy(energy)).value();
    const mpfr radius = lattice.radius(phase_map<mpfr>::at_quarter(1));
    const mpfr shortest = std::min(lattice.effective_period, lattice.height) * 2 * box / radius;
    return pow(shortest, -n) * (8 * box);
}

expected_value expected_coefficient(const std::string& energy, int n, int box, const mpfr& scale) {
    const precision_scope wide(140);
    return {lattice_sum(energy, n, box, scale).back() * 8 / n, left_out(energy, n, box)};
}

template <class T>
expansion<T> from_top(const std::string& energy, int order) {
    return expand(exact_solution<T>(with_energy(energy)), {}, order);
}

bool has_power(const std::string& energy, int n) { return (n % 2 == 0) == (fraction(energy) < 2); }

const std::vector<std::string> energies_with_a_top{"0.5", "1.71", "1.9998", "2.02", "4", "10"};

}  // namespace

TEMPLATE_LIST_TEST_CASE("coefficients are sums over all singularities", "[coefficients]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const int box = 12;
    for (const auto& energy : energies_with_a_top) {
        const auto e = from_top<T>(energy, 81);
        for (const int n : {24, 25, 40, 41, 80, 81}) {
            if (has_power(energy, n)) {
                INFO("E = " << energy << ", n = " << n);
                const expected_value expected = expected_coefficient(energy, n, box, widen(e.scale));
                // 4 ulps of the initial value and one per power, as for the table.
                CHECK_THAT(e.scaled[n], near<T>(expected, 4 + n, T(T(8) / n)));
            }
        }
    }
}

TEMPLATE_LIST_TEST_CASE("far out a coefficient is that of the nearest four singularities", "[coefficients]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::abs;
    using std::atan2;
    using std::max;
    using std::pow;
    using std::sin;
    using std::sqrt;
    for (const auto& energy : energies_with_a_top) {
        const auto lattice = singularities<T>(with_energy(energy)).value();
        const T period = lattice.effective_period;
        const T height = lattice.height;
        const T radius = sqrt(period * period + height * height);
        const T angle = atan2(height, period);
        const T up = radius / sqrt(period * period + height * height * 9);
        const T along = radius / sqrt(period * period * 9 + height * height);
        const auto a = from_top<T>(energy, 60).scaled;
        const int sign = fraction(energy) < 2 ? -1 : 1;
        for (int n = 8; n <= 60; ++n) {
            if (has_power(energy, n)) {
                INFO("E = " << energy << ", n = " << n);
                // The next two poles, and the rest of the lattice less than once more.
                const T correction = pow(max(up, along), n) * 3;
                const T rounding = epsilon<T>() * (4 + 2 * n);  // of a_n R^n, and of n phi
                CHECK(abs(T(a[n] * n / 8 - sin(angle * n) * sign)) <= correction + rounding);
            }
        }
    }
}

TEMPLATE_LIST_TEST_CASE("on the separatrix the coefficients are those of +-i pi/2", "[coefficients]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::pow;
    // a_n = (-1)^((n-1)/2) (4/n) (2/pi)^n [1 - 3^-n + 5^-n - ...]; the scale is R = pi/2.
    const auto a = expand(exact_solution<T>(with_energy("2")), read_expansion_point("bottom"), 61).scaled;
    for (int n = 9; n <= 61; n += 2) {
        T beta(0);
        for (int q = 20; q >= 0; --q) {
            beta += pow(T(2 * q + 1), -n) * (q % 2 == 0 ? 1 : -1);
        }
        const T expected = beta * 4 / n * (n % 4 == 1 ? 1 : -1);
        INFO(n);
        // 41^-n is omitted.
        CHECK_THAT(a[n], near<T>(expected_value{widen(expected), pow(mpfr(41), -n)}, 4 + n));
    }
}

TEST_CASE("in double the coefficients to order 1000 stay below 2e-13 of 8/(n R^n)", "[coefficients]") {
    const precision_scope precision(60);
    for (const auto& energy : energies_with_a_top) {
        const auto e = from_top<double>(energy, 1000);
        const auto sums = lattice_sum(energy, 1000, 12, widen(e.scale));
        double worst = 0;
        for (int n = 24; n <= 1000; ++n) {  // the box is good to 1e-20 from there
            const mpfr expected = has_power(energy, n) ? sums[static_cast<std::size_t>(n)] : mpfr(0);
            const mpfr error = abs(widen(e.scaled[n]) * n / 8 - expected);
            worst = std::max(worst, error.convert_to<double>());
        }
        INFO("E = " << energy << ", " << worst);
        CHECK(worst < 2e-13);  // DESIGN section 3
        CHECK(worst > 1e-15);  // it is nonzero
    }
}

}  // namespace pendulum_coefficients_lattice_test
