// Values of series with their uncertainties: the anharmonic oscillator, symmetries, noise, and lists and points that have
// no value.
#include "libration/convergence/sum.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "../studies/population/known_values.hpp"
#include "libration/convergence/written_list.hpp"
#include "libration/number/exact.hpp"
#include "libration/scalar/decimal.hpp"

namespace convergence_sum_test {

using namespace libration;
using namespace libration::convergence;
using namespace libration::tests;

namespace {

constexpr long digits = 400;

std::vector<series_value> sums(const coefficients& a, const std::vector<mpfr>& points) {
    return sums_of_list({.values = a}, {}, points);
}

series_value sum(const coefficients& a, const mpfr& point) { return sums(a, {point}).front(); }

// Holds the truth, to so many digits.
void check_value(const series_value& found, const mpfr& truth, int certain) {
    INFO(found.note);
    REQUIRE(found.value);
    CHECK(abs(mpfr(*found.value - truth)) <= found.uncertainty);
    CHECK(found.uncertainty <= abs(truth) * pow(mpfr(10), -certain));
}

void check_no_value(const series_value& found, const std::string& reason) {
    CHECK(!found.value);
    CHECK_THAT(found.note, Catch::Contains(reason));
}

coefficients exponential(int count) {
    coefficients a{mpfr(1)};
    for (int n = 1; n < count; ++n) {
        a.push_back(a.back() / n);
    }
    return a;
}

// E_0 .. E_order of p^2/2 + x^2/2 + g x^4 in powers of g: with psi'/psi = -sum f_n g^n, f_n = sum_j c_nj x^(2j+1), the
// equation of Riccati f' = f^2 - x^2 - 2 g x^4 + 2 E.
coefficients anharmonic_oscillator(int order) {
    std::vector<coefficients> c{{mpfr(1)}};
    coefficients energy{mpfr(1) / 2};
    for (int n = 1; n <= order; ++n) {
        const auto size = static_cast<std::size_t>(n) + 1;
        coefficients f(size + 1, mpfr(0));
        for (std::size_t j = size; j-- > 0;) {
            mpfr rest = f[j + 1] * static_cast<int>(2 * j + 3) + (n == 1 && j == 1 ? 2 : 0);
            for (std::size_t k = 1; k < size - 1; ++k) {
                for (std::size_t i = 0; i <= std::min(k, j); ++i) {
                    const auto& other = c[size - 1 - k];
                    rest -= j - i < other.size() ? mpfr(c[k][i] * other[j - i]) : mpfr(0);
                }
            }
            f[j] = rest / 2;
        }
        f.pop_back();
        energy.push_back(f[0] / 2);
        c.push_back(std::move(f));
    }
    return energy;
}

}  // namespace

TEST_CASE("the ground state of the anharmonic oscillator at g = 1 and 1/10", "[convergence][sum]") {
    const precision_scope scope(digits);
    // tests/reference/quartic_oscillator.py.
    const mpfr at_one("0.803770651234273769354086");
    const mpfr at_tenth("0.5591463271835195767154066");
    const auto energy = anharmonic_oscillator(40);
    CHECK(energy[3] == mpfr(333) / 16);
    const auto found = sums(energy, {mpfr(1), mpfr(1) / 10});
    check_value(found[0], at_one, 7);
    check_value(found[1], at_tenth, 15);
    CHECK(found[0].note == "the Borel sum");
    check_value(sum(coefficients(energy.begin(), energy.begin() + 21), mpfr(1)), at_one, 4);
    check_no_value(sum(energy, mpfr(-1) / 10), "Stokes line");
}

TEST_CASE("one equation that the whole list satisfies gives all digits beyond the radius", "[convergence][sum]") {
    const precision_scope scope(digits);
    const auto a = logarithm_of(polynomial({mpfr(1), mpfr(1)}, 24));
    const auto found = sums(a, {mpfr(1) / 2, mpfr(5), mpfr(100), mpfr(-1), mpfr(-2)});
    check_value(found[0], log(mpfr(3) / 2), 45);
    check_value(found[1], log(mpfr(6)), 45);
    check_value(found[2], log(mpfr(101)), 45);
    CHECK(found[0].note.empty());
    CHECK_THAT(found[1].note, Catch::Contains("branch reached along the real axis"));
    check_no_value(found[3], "the singularity at -1.000");
    check_no_value(found[4], "is between 0 and this point");
}

TEST_CASE("zeros of a symmetry do not count as convergence", "[convergence][sum]") {
    const precision_scope scope(digits);
    coefficients arctangent;
    coefficients eighth;  // 1/2 + x/(1 - x^8)
    for (int n = 0; n <= 40; ++n) {
        arctangent.push_back(n % 2 == 0 ? mpfr(0) : mpfr(n % 4 == 1 ? 1 : -1) / n);
    }
    for (int n = 0; n <= 120; ++n) {
        eighth.push_back(n == 0 ? mpfr(1) / 2 : mpfr(n % 8 == 1 ? 1 : 0));
    }
    const auto found = sums(arctangent, {mpfr(1) / 2, mpfr(-1), mpfr(10)});
    check_value(found[0], atan(mpfr(1) / 2), 15);
    check_value(found[1], -atan(mpfr(1)), 15);
    check_value(found[2], atan(mpfr(10)), 2);
    const mpfr x = mpfr(1) / 2;
    check_value(sum(eighth, x), mpfr(1) / 2 + x / (1 - pow(x, 8)), 10);
}

TEST_CASE("short lists have no false value", "[convergence][sum]") {
    const precision_scope scope(digits);
    const mpfr x = mpfr(1) / 2;
    for (int count = 1; count <= 14; ++count) {
        INFO(count);
        const auto found = sum(exponential(count), x);
        CHECK((!found.value || abs(mpfr(*found.value - exp(x))) <= found.uncertainty));
        CHECK((count >= 5 || !found.value));
        CHECK((count < 12 || found.value));
    }
}

TEST_CASE("a polynomial, zeros and the point 0", "[convergence][sum]") {
    const precision_scope scope(digits);
    const auto cubic = polynomial({mpfr(1), mpfr(2), mpfr(-3), mpfr(1)}, 20);
    check_value(sum(cubic, mpfr(7)), mpfr(1 + 14 - 147 + 343), 40);
    check_no_value(sum(polynomial({mpfr(1), mpfr(2)}, 4), mpfr(7)), "too many coefficients are 0");
    check_no_value(sum(coefficients(20, mpfr(0)), mpfr(1)), "all coefficients are 0");
    coefficients gaps(34, mpfr(0));  // x + x^2 + x^4 + ..
    for (std::size_t n = 1; n < gaps.size(); n *= 2) {
        gaps[n] = 1;
    }
    check_no_value(sum(gaps, mpfr(1) / 2), "gaps");
    const auto at_zero = sum(exponential(3), mpfr(0));
    REQUIRE(at_zero.value);
    CHECK(*at_zero.value == 1);
    CHECK(at_zero.uncertainty == 0);
}

TEST_CASE("an entire function at large arguments, and beyond all digits", "[convergence][sum]") {
    const precision_scope scope(digits);
    const auto found = sums(exponential(30), {mpfr(-20), mpfr(20)});
    check_value(found[0], exp(mpfr(-20)), 30);
    check_value(found[1], exp(mpfr(20)), 30);
    // exp(-e^x) satisfies no linear equation.
    auto iterated = exponential_of(scaled(exponential(25), mpfr(-1)));
    check_value(sum(iterated, mpfr(-1)), exp(mpfr(-exp(mpfr(-1)))), 5);
    const auto far = sum(iterated, mpfr(60));
    CHECK(!far.value);
}

TEST_CASE("rounded decimals limit the uncertainty", "[convergence][sum]") {
    const precision_scope scope(digits);
    const auto a = power_of(polynomial({mpfr(1), mpfr(1)}, 30), mpfr(1) / 3);
    std::vector<exact> decimals;
    for (const mpfr& each : a) {
        decimals.push_back(read_exact(to_decimal(each, 12)));
    }
    const auto written = written_list_of(decimals);
    const std::vector<mpfr> points{mpfr(1) / 2, mpfr(2)};
    const auto found = sums_of_list(written.list, written.rounding, points);
    check_value(found[0], exp(mpfr(log(mpfr(3) / 2) / 3)), 6);
    check_value(found[1], exp(mpfr(log(mpfr(3)) / 3)), 2);
    CHECK(found[0].uncertainty > mpfr("1e-13"));
}

TEST_CASE("the errors of decimals follow from their last digits", "[convergence][sum]") {
    const precision_scope scope(40);
    const auto exact_list = written_list_of({read_exact("1"), read_exact("1/3"), read_exact("sqrt(2.5)")});
    CHECK(exact_list.rounding.empty());
    CHECK(exact_list.list.noise == 0);
    const auto floating = written_list_of({read_exact("3"), read_exact("1.25e-2"), read_exact("-4.50e3")});
    REQUIRE(floating.rounding.size() == 3);
    CHECK(floating.rounding[0] == 0);
    // Three digits, and four places behind the point: 4500/200 + 1/20000.
    CHECK(abs(mpfr(floating.rounding[2] - mpfr(45) / 2 - mpfr(1) / 20000)) < mpfr("1e-30"));
}

}  // namespace convergence_sum_test
