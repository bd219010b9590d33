// The test problems for which reference values are published: problems of the catalogue, some with other parameters,
// and the last of their times.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "../shared/catalogue_system.hpp"

namespace libration::studies::proved {

/// The times are end k/8, k = 1 .. 8, after the initial time; for stiff problems end/factor^k, k = 10 .. 0.
inline constexpr int times_of_each = 8;
inline constexpr int times_of_stiff = 11;
/// More are not computed for these.
inline constexpr long most_stiff_digits = 30;

struct test_problem {
    std::string name;
    std::string end;
    std::string catalogue = {};             ///< its name there; empty: the same
    std::vector<std::string> changes = {};  ///< of parameters and initial values
    int seconds = 1;                        ///< approximate, on one core
    int factor = 0;                         ///< of a stiff problem, of which condition numbers are not computed

    std::string in_catalogue() const { return catalogue.empty() ? name : catalogue; }

    ode::equation_system equations() const { return catalogue_system(in_catalogue(), changes); }

    bool is_stiff() const { return factor > 0; }
    long digits_of(long asked) const { return is_stiff() ? std::min(asked, most_stiff_digits) : asked; }

    std::vector<ode::number> times() const {
        const ode::number start = ode::explicit_system(equations()).point();
        const ode::number whole = ode::parse_constant(end).constant();
        std::vector<ode::number> all;
        for (int k = 1; !is_stiff() && k <= times_of_each; ++k) {
            all.push_back(start + whole * ode::number(rational(k, times_of_each)));
        }
        rational part = 1;
        for (int k = 0; is_stiff() && k < times_of_stiff; ++k) {
            all.insert(all.begin(), start + whole * ode::number(part));
            part /= factor;
        }
        return all;
    }
};

/// By name.
inline const std::vector<test_problem>& test_problems() {
    static const std::vector<test_problem> all{
        {.name = "arenstorf", .end = "17.0652165601579625588917206249", .seconds = 20},
        {.name = "blasius", .end = "8"},
        {.name = "brusselator", .end = "20"},
        {.name = "detest_a1", .end = "20"},
        {.name = "detest_a2", .end = "20"},
        {.name = "detest_a3", .end = "20"},
        {.name = "detest_a4", .end = "20"},
        {.name = "detest_a5", .end = "20"},
        {.name = "detest_b1", .end = "20"},
        {.name = "detest_b2", .end = "20"},
        {.name = "detest_b3", .end = "20"},
        {.name = "detest_b4", .end = "20"},
        {.name = "detest_b5", .end = "20"},
        {.name = "detest_c1", .end = "20"},
        {.name = "detest_c2", .end = "20"},
        {.name = "detest_c3", .end = "20"},
        {.name = "detest_c4", .end = "20", .seconds = 20},
        {.name = "detest_c5", .end = "20", .seconds = 40},
        {.name = "detest_d1", .end = "20"},
        {.name = "detest_d2", .end = "20"},
        {.name = "detest_d3", .end = "20"},
        {.name = "detest_d4", .end = "20"},
        {.name = "detest_d5", .end = "20"},
        {.name = "detest_e1", .end = "20"},
        {.name = "detest_e2", .end = "20"},
        {.name = "detest_e3", .end = "20"},
        {.name = "detest_e4", .end = "20"},
        {.name = "detest_e5", .end = "20"},
        {.name = "double_pendulum", .end = "10"},
        {.name = "duffing", .end = "20"},
        {.name = "falkner_skan", .end = "8"},
        {.name = "falkner_skan_flat",
         .end = "8",
         .catalogue = "falkner_skan",
         .changes = {"b = 0", "s = 0.469599988361"}},
        {.name = "falkner_skan_stagnation",
         .end = "4",
         .catalogue = "falkner_skan",
         .changes = {"b = 1", "s = 1.2325876568202810"}},
        {.name = "fitzhugh_nagumo", .end = "40"},
        {.name = "flierl_petviashvili", .end = "10"},
        {.name = "harmonic", .end = "20"},
        {.name = "henon_heiles", .end = "40"},
        {.name = "henon_heiles_chaos",
         .end = "40",
         .catalogue = "henon_heiles",
         .changes = {"x'(0) = sqrt(1/3 - 0.01)", "y'(0) = 0.1"}},
        {.name = "hires", .end = "321.8122", .seconds = 120},
        {.name = "hires_421", .end = "421.8122", .catalogue = "hires", .seconds = 6, .factor = 2},
        {.name = "kepler", .end = "20"},
        {.name = "lane_emden", .end = "6"},
        {.name = "lane_emden_5", .end = "20", .catalogue = "lane_emden", .changes = {"n = 5"}},
        {.name = "logistic", .end = "20"},
        {.name = "lorenz", .end = "20", .seconds = 10},
        {.name = "lorenz_periodic", .end = "10", .catalogue = "lorenz", .changes = {"r = 100.5"}, .seconds = 10},
        {.name = "lotka_volterra", .end = "20"},
        {.name = "oregonator", .end = "20"},
        {.name = "oregonator_360", .end = "360", .catalogue = "oregonator", .seconds = 6, .factor = 2},
        {.name = "painleve_1", .end = "2"},
        {.name = "painleve_2", .end = "2"},
        {.name = "pendulum", .end = "20"},
        {.name = "pendulum_179deg",
         .end = "20",
         .catalogue = "pendulum",
         .changes = {"theta(0) = 179/180*pi", "theta'(0) = 0"}},
        {.name = "pleiades", .end = "0.5", .seconds = 60},
        {.name = "pollu", .end = "60", .seconds = 50, .factor = 2},
        {.name = "rayleigh", .end = "0.8"},
        {.name = "riccati", .end = "1.5"},
        {.name = "robertson", .end = "40", .seconds = 40},
        {.name = "robertson_1e11", .end = "1e11", .catalogue = "robertson", .seconds = 3, .factor = 10},
        {.name = "sakiadis", .end = "8"},
        {.name = "seir", .end = "40"},
        {.name = "sir", .end = "4"},
        {.name = "sir_japan", .end = "40"},
        {.name = "stiff_a1", .end = "20", .factor = 2},
        {.name = "stiff_a2", .end = "120", .factor = 2},
        {.name = "stiff_a3", .end = "20", .factor = 2},
        {.name = "stiff_a4", .end = "1", .factor = 2},
        {.name = "stiff_b1", .end = "20", .factor = 2},
        {.name = "stiff_b2", .end = "20", .factor = 2},
        {.name = "stiff_b3", .end = "20", .factor = 2},
        {.name = "stiff_b4", .end = "20", .factor = 2},
        {.name = "stiff_b5", .end = "20", .factor = 2},
        {.name = "stiff_c1", .end = "20", .factor = 2},
        {.name = "stiff_c2", .end = "20", .factor = 2},
        {.name = "stiff_c3", .end = "20", .factor = 2},
        {.name = "stiff_c4", .end = "20", .factor = 2},
        {.name = "stiff_c5", .end = "20", .factor = 2},
        {.name = "stiff_d1", .end = "400", .factor = 2},
        {.name = "stiff_d2", .end = "40", .factor = 2},
        {.name = "stiff_d3", .end = "20", .factor = 2},
        {.name = "stiff_d4", .end = "50", .factor = 2},
        {.name = "stiff_d5", .end = "100", .factor = 2},
        {.name = "stiff_d6", .end = "1", .factor = 2},
        {.name = "stiff_e1", .end = "1", .factor = 2},
        {.name = "stiff_e2", .end = "10", .factor = 2},
        {.name = "stiff_e3", .end = "500", .factor = 2},
        {.name = "stiff_e4", .end = "1000", .factor = 2},
        {.name = "stiff_e5", .end = "1000", .factor = 2},
        {.name = "stiff_f1", .end = "1000", .factor = 2},
        {.name = "stiff_f2", .end = "240", .factor = 2},
        {.name = "stiff_f3", .end = "100", .factor = 2},
        {.name = "stiff_f4", .end = "300", .factor = 2},
        {.name = "stiff_f5", .end = "100", .factor = 2},
        {.name = "stiff_e5_1e13", .end = "1e13", .catalogue = "stiff_e5", .seconds = 10, .factor = 10},
        {.name = "three_body_figure_8", .end = "6"},
        {.name = "toda", .end = "20"},
        {.name = "van_der_pol", .end = "40"},
        {.name = "van_der_pol_10", .end = "40", .catalogue = "van_der_pol", .changes = {"m = 10"}},
        {.name = "van_der_pol_100", .end = "200", .catalogue = "van_der_pol", .changes = {"m = 100"}, .seconds = 10},
        {.name = "van_der_pol_1000",
         .end = "1000",
         .catalogue = "van_der_pol",
         .changes = {"m = 1000"},
         .seconds = 500},
        {.name = "van_der_pol_1000_2000",
         .end = "2000",
         .catalogue = "van_der_pol",
         .changes = {"m = 1000"},
         .seconds = 5,
         .factor = 2},
        {.name = "weierstrass", .end = "0.9"},
    };
    return all;
}

}  // namespace libration::studies::proved
