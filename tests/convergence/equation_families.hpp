// Solutions of differential equations about their starts, with the exponent of the nearest singularities from the
// leading-order balance of the equation and the radius as `libration radius --problem NAME --prove --digits 12` proves
// it, which uses no list of coefficients. Most have psi series: a leading power with logarithms or complex powers of
// higher order, so that estimates from coefficients settle slowly.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "../studies/population/radius_population.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/expansion/taylor_expansion.hpp"
#include "libration/number/exact.hpp"
#include "libration/problem/catalogue.hpp"

namespace libration::tests {

/// An unknown of a problem of the catalogue.
struct solution_of_problem {
    std::string problem;
    int unknown;
    rational exponent;
    std::string radius = "";  ///< to a unit of the last place; empty where it is not proved
};

/// a_0 .. a_N in the working precision.
inline drawn_series series_of_solution(const solution_of_problem& of, int order) {
    const ode::explicit_system system(ode::parse(problem_text(of.problem)));
    const ode::tape made = ode::tape::about_start(system);
    ode::taylor_expansion<mpfr> expansion(made, order);
    expansion.about_start();
    drawn_series drawn{expansion.series_of(of.unknown), mpfr(0)};
    if (!of.radius.empty()) {
        drawn.radius = from_exact<mpfr>(read_exact(of.radius));
        drawn.radius_error = drawn.radius / pow(mpfr(10), 11);
    }
    drawn.nearest = {{{drawn.radius, mpfr(0)}, from_rational<mpfr>(of.exponent)}};
    return drawn;
}

/// The solutions that uncertainties are calibrated on. Balances, u the distance: f''' = -f f''/2 and f = 6/u; Lorenz' x
/// = +-2i/u and y, z like u^-2; x'' = -2 x y, y'' = y^2 - x^2 like u^-2; S' = -r S I and I' = r S I like 1/u, the same
/// for x' = -b x y, y' = d x y; u' = u^2 v = -v' and x' = -m x^3/3, v' = -v^3/3 like u^(-1/2); R R'' = -3/2 R'^2 and R
/// = u^(2/5); x'' = -b x^3 like 1/u; and 2 - cos^2(a - b) = 0, where the mass matrix of the double pendulum is
/// singular, the square root of which times its derivative is 1: u^(2/3).
inline std::vector<solution_of_problem> calibrating_solutions() {
    return {{"blasius", 0, -1, "3.940211469127"},
            {"lorenz", 0, -1, "0.233580684733"},
            {"lorenz", 1, -2, "0.233580684733"},
            {"lorenz", 2, -2, "0.233580684733"},
            {"henon_heiles", 1, -2, "3.541390261673"},
            {"sir", 0, -1, "1.803693978974"},
            {"sir", 1, -1, "1.803693978974"},
            {"double_pendulum", 0, {2, 3}},
            {"double_pendulum", 1, {2, 3}},
            {"lotka_volterra", 0, -1, "2.036866201199"},
            {"lotka_volterra", 1, -1, "2.036866201199"},
            {"brusselator", 0, {-1, 2}, "0.568712685243"},
            {"van_der_pol", 0, {-1, 2}, "0.920313027707"},
            {"rayleigh", 0, {2, 5}, "0.914681356502"},
            {"fitzhugh_nagumo", 0, {-1, 2}, "1.900091293006"},
            {"duffing", 0, -1, "1.524886838082"}};
}

/// Solutions that no uncertainty was calibrated on. Painleve's transcendents and Weierstrass' function have double and
/// simple poles; Kepler's x and y with r = 0 at cos E = 1/e and the radius arcosh(5/3) - 4/5, and bodies that meet at
/// complex times, r^2 = x^2 + y^2 = 0 there, u^(1/2); log u of Toda's chain and of the pendulum; SEIR's S like u^-2,
/// for I like 1/u follows from E, and E from S I, by a derivative each; Falkner and Skan's and Sakiadis' equations are
/// Blasius' in the leading order.
inline std::vector<solution_of_problem> held_out_solutions() {
    return {{"painleve_1", 0, -2, "2.384168769569"},  {"painleve_2", 0, -1, "2.938182501733"},
            {"weierstrass", 0, -2, "1.000000000000"}, {"kepler", 0, {1, 2}, "0.298612288668"},
            {"kepler", 1, {1, 2}, "0.298612288668"},  {"three_body_figure_8", 0, {1, 2}},
            {"pendulum", 0, 0, "2.690646261056"},     {"toda", 0, 0, "1.682324171595"},
            {"seir", 0, -2, "0.533734830149"},        {"falkner_skan", 0, -1, "3.527264464222"},
            {"sakiadis", 0, -1, "4.072166860802"}};
}

}  // namespace libration::tests
