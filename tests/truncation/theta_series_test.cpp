// The theta series with few terms: in the Taylor coefficients, at the small nome of a descent, and for the nome.
#include <utility>
#include <vector>

#include "libration/elliptic/theta_taylor.hpp"
#include "libration/elliptic/theta_values.hpp"
#include "libration/pendulum/exact_solution.hpp"
#include "libration/pendulum/landen_motion.hpp"
#include "libration/pendulum/proved_libration.hpp"
#include "truncation/arb_theta.hpp"
#include "truncation/stopped_early.hpp"

namespace truncation_theta_series_test {

using namespace libration;
using namespace libration::elliptic;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

// Coefficient j from its definition, the sum over all m: at imaginary x of e^(i f (at + step t)), for the first over i.
ball coefficient(const theta_kind& kind, const theta_argument<ball>& argument, int j) {
    const auto& [nome, at, step, real, shift] = argument;
    ball sum(0);
    for (long m = kind.odd ? -81 : -80; m <= 81; m += 2) {
        const long f = m - shift;
        const ball term = pow(nome, (m * m - (kind.odd ? 1 : 0)) / 4) * pow(ball(step * f), j) * kind.sign(m);
        const ball turned = at * f + pi<ball>() * j / 2;
        sum += term * (real ? exp(ball(at * f)) : kind.is_first() ? sin(turned) : cos(turned));
    }
    for (int n = 2; n <= j; ++n) {
        sum /= n;
    }
    return sum;
}

// sqrt of a nome, P and M from complete integrals by Arb: k = sqrt(1 - k'^2).
struct descent_truth {
    ball mean;
    ball nome;
};
descent_truth truth_after(int levels, const ball& complement) {
    const ball k = sqrt(ball(1 - complement * complement));
    const ball mean = arb_mean(complement);
    return {mean, exp(ball(-pi<ball>() * ldexp(mean / arb_mean(k), levels)))};
}

const ball half = ldexp(ball(1), -1);

}  // namespace

TEST_CASE("few pairs of a theta series hold its Taylor coefficients", "[truncation][theta_taylor]") {
    const precision_scope scope(many_digits);
    std::vector<double> factors;
    for (const theta_kind& kind : {first_theta, second_theta, third_theta, fourth_theta}) {
        for (const bool real : {false, true}) {
            const theta_argument<ball> argument{ball(1) / 20, ball(1) / 3, ball(1) / 2, real, real && kind.odd ? 1 : 0};
            for (const long pairs : {1, 2, 5}) {
                const int j = kind.is_first() ? 1 : 2;
                const ball found = theta_taylor<ball>(kind, argument, pairs).coefficients(0, 1, j + 1).back();
                factors.push_back(times_wider(found, coefficient(kind, argument, j)));
            }
        }
    }
    // 4 q^P e^(f H) bounds two terms and all following ones, at any power of t: a single one has f^j/j! of it.
    CHECK_THAT(factors,
               are_factors({11.06, 101.8, 102.8, 41.75, 212.7, 9.33e+04, 14.75, 81.45, 37.39, 81.31, 212.7, 3.732e+04,
                            13.83, 31.41, 24.19, 17.2,  13.82, 47.43,    13.84, 31.41, 24.19, 17.22, 13.82, 47.43}));
}

TEST_CASE("as few pairs as are asked for are no fewer than the bound needs", "[truncation][theta_taylor]") {
    // Near the nome 1 pairs grow before they decrease: 2 would omit far more than twice the first of the others.
    const precision_scope scope(many_digits);
    std::vector<double> factors;
    for (const ball& nome : {ball(ball(1) / 2), ball(ball(9) / 10)}) {
        const theta_argument<ball> argument{nome, ball(2), half, true};
        const ball found = theta_taylor<ball>(third_theta, argument, 1).coefficients(0, 1, 1).front();
        factors.push_back(times_wider(found, coefficient(third_theta, argument, 0)));
    }
    // The pairs grow up to f = 4 log(e^H)/log(1/q), and are kept that far.
    CHECK_THAT(factors, are_factors({196.8, 1.787e+12}));
}

TEST_CASE("few terms of the series of a nome hold it", "[truncation][landen_nome]") {
    const precision_scope scope(many_digits);
    std::vector<double> factors;
    for (const int levels : {1, 2, 3}) {
        for (const int series : {1, 2, 5}) {
            const landen_nome nome(ball(1), half, ball(3) / 16, {levels, 4, series});
            const auto truth = truth_after(nome.levels(), half);
            factors.push_back(times_wider(nome.square_power(1), truth.nome));
        }
    }
    // |p_j| <= 4^(2j+1) is 16 times 4 at j = 1, more after it; 2^-l is up to twice e.
    CHECK_THAT(factors, are_factors({36.05, 76.46, 286.7, 40.61, 96.99, 519.2, 51.53, 156.2, 1708}));
}

TEST_CASE("few terms of the theta series at the nome of a descent hold the mean and the functions",
          "[truncation][theta_values]") {
    const precision_scope scope(many_digits);
    std::vector<double> factors;
    for (const int terms : {1, 2, 4}) {
        const landen_nome nome(ball(1), half, ball(3) / 16, {2, terms, 18});
        const auto truth = truth_after(nome.levels(), half);
        factors.push_back(times_wider(nome.mean(), truth.mean));
        const ball ratio = -log(truth.nome) / pi<ball>();
        const ball power = sqrt(sqrt(truth.nome)) * 2;
        const auto at_zero = arb_thetas(ball(0), ratio);
        factors.push_back(times_wider(nome.scale(), ball(truth.mean * at_zero[1] * at_zero[2] / power)));
        const ball x = ball(2) / 9;  // z = pi x
        const ball angle = x * pi<ball>();
        const ball cosine = cos(angle);
        const ball sine = sin(angle);
        const auto found = thetas_at(nome, cosine, &sine);
        const auto [first, second, third, fourth] = arb_thetas(x, ratio);
        factors.push_back(times_wider(found.first, ball(first / power)));
        factors.push_back(times_wider(found.second, ball(second / power)));
        factors.push_back(times_wider(found.third, third));
        factors.push_back(times_wider(found.fourth, fourth));
    }
    // Up to twice P for its power of two, to the power of P; 4 P^((N+1)^2) for one term of 2, and 32 for up to 2N+3.
    CHECK_THAT(factors, are_factors({3.22, 3.22, 122.9, 53.3, 3.427, 3.427, 5.841, 5.841, 87.19, 589.3, 11.68, 11.68,
                                     39.26, 39.26, 743.7, 5026, 51.25, 51.25}));
}

TEST_CASE("descents of few levels hold the motion", "[truncation][landen_motion]") {
    const precision_scope scope(many_digits);
    std::vector<double> factors;
    for (const rational& energy : {rational(3, 2), rational(5, 2)}) {
        const exact_solution<ball> solution(motion::of_energy(energy));
        const auto truth = solution(read_exact("1.3"));
        for (const int levels : {1, 2, 3}) {
            const landen_motion motion(energy, rational(2 - energy), {levels, 1, 2});
            const auto found = motion.state_at(motion.phase_at(rational(13, 10)));
            factors.push_back(times_wider(found.theta, truth.theta));
            factors.push_back(times_wider(found.omega, truth.omega));
        }
    }
    // Both truncations at once, and radii that add in the ascent.
    CHECK_THAT(factors,
               are_factors({16.64, 147.7, 6.698, 69.68, 19.92, 219.1, 174.9, 365, 19.04, 45.88, 86.61, 209.7}));
}

TEST_CASE("descents of few levels hold the motion in fixed point", "[truncation][proved_libration]") {
    // One limb: its division takes radii up to 2^40 units, and a level less than usual leaves some 2^30.
    const precision_scope scope(many_digits);
    std::vector<double> factors;
    for (const auto& [energy, levels] :
         {std::pair(rational(1, 64), 0U), {rational(1, 10), 0U}, {rational(19, 10), 2U}}) {
        const auto truth = exact_solution<ball>(motion::of_energy(energy))(read_exact("0.7"));
        const ball mean = arb_mean(sqrt(from_rational<ball>(rational(1 - energy / 2))));
        const proved_libration motion(energy, rational(2 - energy), 64, levels);
        factors.push_back(times_wider(motion.mean(), mean));
        const ball z = mean * 7 / 10;
        factors.push_back(times_wider(motion.theta_at(z).value(), truth.theta));
        factors.push_back(times_wider(motion.state_at(z).value().omega, truth.omega));
    }
    // 2^-l is up to four times e, to the fourth power and more.
    CHECK_THAT(factors, are_factors({5.93, 4.415, 18.36, 260.9, 235.9, 1207, 7.652, 22.71, 94.13}));
    CHECK_THROWS_AS(proved_libration(rational(1, 2), rational(3, 2), 1000, 0), precision_exhausted);
}

TEST_CASE("few terms of the arctangent hold it", "[truncation][ball_arctangent]") {
    const precision_scope scope(many_digits);
    std::vector<double> factors;
    for (const ball& r : {ball(ball(1) / 3), ball(ball(1) / 100)}) {
        for (const slong terms : {1, 2, 5, 30}) {
            factors.push_back(times_wider(small_arctangent(r, ball::working_bits(), terms).value(), atan(r)));
        }
    }
    // The rest has a denominator 2N+1, and r^2 is up to twice smaller than 2^-small, to the power N.
    CHECK_THAT(factors, are_factors({7.195, 27.31, 693.8, 2.484e+12, 7.325, 29.8, 954.2, 2.598e+13}));
}

}  // namespace truncation_theta_series_test
