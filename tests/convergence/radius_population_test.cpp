// How often the true radius and the true exponent lie within the uncertainties of the verdict, over a population of 46
// families of series and of solutions of differential equations: a sample of it, and all of it with `./run test
// --long`, where 6 families and 11 solutions that nothing was calibrated on are judged too.
#include <algorithm>
#include <catch2/catch.hpp>
#include <iostream>

#include "../studies/population/logarithmic_families.hpp"
#include "../studies/population/radius_families.hpp"
#include "convergence/equation_families.hpp"
#include "libration/convergence/coefficient_noise.hpp"
#include "libration/convergence/radius_answers.hpp"
#include "libration/scalar/decimal.hpp"

namespace convergence_radius_population_test {

using namespace libration;
using namespace libration::tests;

namespace {

// Distances from the truth in uncertainties; nothing without an answer, or where nothing is known.
struct misses {
    bool answered = false;
    std::optional<double> radius;
    std::optional<double> exponent;
    singularity_kind kind = singularity_kind::unknown;
    int count = 0;
};

// Of several singularities on the circle the one nearest to a position.
const drawn_singularity& meant_by(const std::optional<complex_number<mpfr>>& position, const drawn_series& drawn) {
    if (!position) {
        return drawn.nearest.front();
    }
    return *std::min_element(drawn.nearest.begin(), drawn.nearest.end(), [&](const auto& a, const auto& b) {
        return modulus_of(a.at - *position) < modulus_of(b.at - *position);
    });
}

misses misses_of(const listed_function& function, const scalar_spec& scalar, const drawn_series& drawn) {
    const auto answers = answers_of(function, scalar);
    const precision_scope scope(100);
    const auto& verdict = answers.rows.front();
    if (!verdict.radius) {
        return {};
    }
    misses all{true, std::nullopt, std::nullopt, verdict.kind, verdict.count};
    if (drawn.radius > 0) {
        const mpfr away = abs(*verdict.radius - drawn.radius) - drawn.radius_error;
        all.radius = mpfr(std::max(away, mpfr(0)) / verdict.uncertainty).convert_to<double>();
    }
    if (verdict.exponent && !drawn.nearest.empty()) {
        const mpfr away = abs(*verdict.exponent - meant_by(verdict.position, drawn).exponent);
        all.exponent = mpfr(away / verdict.exponent_uncertainty).convert_to<double>();
    }
    return all;
}

// A list of so many digits, 16 standing for doubles.
misses judged(const drawn_series& drawn, int digits) {
    if (digits == 16) {
        return misses_of({{{drawn.a, {}}}}, read_scalar("double"), drawn);
    }
    auto list = drawn.a;
    std::vector<exact> written;
    for (int n = 0; n <= drawn.a.order(); ++n) {
        written.push_back(read_exact(to_decimal(drawn.a[n], digits)));
        list[n] = from_exact<mpfr>(written.back());
    }
    return misses_of({{{list, written}}}, {scalar_kind::arbitrary, std::max(digits, 30)}, drawn);
}

// One list: N and the digits of its coefficients by chance.
misses draw(const series_family& family, std::uint64_t seed, const std::vector<int>& orders,
            const std::vector<int>& digits_of_lists) {
    const precision_scope scope(160);
    dice random(seed);
    const int order = random.one_of(orders);
    const int digits = random.one_of(digits_of_lists);
    return judged(family.draw(random, order), digits);
}

struct coverage {
    int judged = 0, covered = 0, by_ten = 0;
    double worst = 0;

    void add(const std::optional<double>& miss) {
        judged += miss ? 1 : 0;
        covered += miss && *miss <= 1 ? 1 : 0;
        by_ten += miss && *miss > 10 ? 1 : 0;
        worst = std::max(worst, miss.value_or(0));
    }
    bool is_enough() const { return covered * 100 >= judged * 95; }
};

std::ostream& operator<<(std::ostream& out, const coverage& c) {
    return out << c.covered << " of " << c.judged << " covered, " << c.by_ten
               << " missed by ten uncertainties and more, "
               << "the largest miss is " << c.worst;
}

struct census {
    int lists = 0, answers = 0;
    coverage radius, exponent;

    void add(const misses& miss) {
        ++lists;
        answers += miss.answered ? 1 : 0;
        radius.add(miss.radius);
        exponent.add(miss.exponent);
    }
};

std::ostream& operator<<(std::ostream& out, const census& c) {
    return out << c.lists << " lists, " << c.answers << " answers; radius: " << c.radius
               << "; exponent: " << c.exponent;
}

// Some lists of every family.
census census_of(const std::vector<series_family>& families, std::uint64_t first, int lists_of_a_family) {
    census all;
    for (const auto& family : families) {
        census here;
        for (int k = 0; k < lists_of_a_family; ++k) {
            const auto miss =
                draw(family, first + static_cast<std::uint64_t>(k), {20, 30, 40, 60, 80}, {6, 10, 16, 16, 30, 60});
            here.add(miss);
            all.add(miss);
        }
        first += 1000;
        std::cout << family.name << ": " << here << '\n';
    }
    return all;
}

// Doubles and 30 digits of every solution.
census census_of(const std::vector<solution_of_problem>& solutions, const std::vector<int>& orders) {
    const precision_scope scope(100);
    census all;
    for (const auto& solution : solutions) {
        census here;
        const drawn_series longest = series_of_solution(solution, orders.back());
        for (const int order : orders) {
            drawn_series drawn = longest;
            drawn.a = longest.a.truncated(order);
            for (const int digits : {16, 30}) {
                const auto miss = judged(drawn, digits);
                here.add(miss);
                all.add(miss);
            }
        }
        std::cout << solution.problem << " " << solution.unknown << ": " << here << '\n';
    }
    return all;
}

const std::vector<int> orders_of_solutions{20, 30, 40, 60, 80, 100};

void check_census(const std::string& name, const census& all) {
    std::cout << "all " << name << ": " << all << '\n';
    INFO(name << ": " << all);
    CHECK(all.radius.is_enough());
    CHECK(all.exponent.is_enough());
    CHECK(all.radius.by_ten == 0);
    CHECK(all.exponent.by_ten == 0);
}

}  // namespace

TEST_CASE(
    "of a sample of all families at least 95 in 100 radii and exponents are covered and none misses by ten "
    "uncertainties",
    "[convergence][radius_population]") {
    census all;
    coverage of_powers;  // exponents without logarithmic corrections, which are effective ones
    std::uint64_t seed = 0;
    auto families = all_series_families();
    const auto logarithmic = logarithmic_families();
    families.insert(families.end(), logarithmic.begin(), logarithmic.end());
    for (const auto& family : families) {
        const auto miss = draw(family, 700 + 1000 * seed++, {20, 30, 40}, {10, 16, 30});
        INFO(family.name << " misses by " << miss.radius.value_or(0) << " and " << miss.exponent.value_or(0));
        CHECK(miss.radius.value_or(0) <= 10);
        CHECK(miss.exponent.value_or(0) <= 10);
        all.add(miss);
        if (family.name.find("log") == std::string::npos) {
            of_powers.add(miss.exponent);
        }
    }
    INFO(all << "; exponents of powers: " << of_powers);
    CHECK(all.radius.is_enough());
    CHECK(of_powers.is_enough());
    CHECK(all.answers * 10 >= all.lists * 8);  // and it does answer
    CHECK(all.exponent.judged * 3 >= all.lists);
}

TEST_CASE("exponents of psi series and of confluent powers are covered", "[convergence][radius_population]") {
    const precision_scope scope(100);
    census all;
    for (const auto& [solution, orders] : std::vector<std::pair<solution_of_problem, std::vector<int>>>{
             {{"blasius", 0, -1, "3.940211469127"}, {60, 100}},
             {{"double_pendulum", 0, {2, 3}}, {60}},
             {{"lorenz", 0, -1, "0.233580684733"}, {60}},
             {{"lorenz", 1, -2, "0.233580684733"}, {80}},
             {{"sir", 1, -1, "1.803693978974"}, {60}}}) {
        const drawn_series longest = series_of_solution(solution, orders.back());
        for (const int order : orders) {
            drawn_series drawn = longest;
            drawn.a = longest.a.truncated(order);
            const auto miss = judged(drawn, 16);
            INFO(solution.problem << " N = " << order);
            CHECK(miss.radius.value_or(0) <= 1);
            CHECK(miss.exponent.value_or(0) <= 1);
            CHECK(miss.kind != singularity_kind::pole);
            CHECK(miss.kind != singularity_kind::logarithm);
            all.add(miss);
        }
    }
    CHECK(all.exponent.judged * 3 >= all.lists);
}

TEST_CASE("logarithms upon a power are one singularity, and neither a pole nor a pure logarithm",
          "[convergence][radius_population]") {
    const precision_scope scope(100);
    const mpfr one(1);
    constexpr int order = 32;
    const auto l = population::logarithm_at(one, order);
    const auto x = population::polynomial({one}, order);
    for (const auto& drawn :
         {population::at_point(population::whole_power(l, 3), one, mpfr(0)),
          population::at_point(x / population::shifted_logarithm(one, order), one, mpfr(0)),
          population::at_point(population::power_at(one, mpfr(mpfr(1) / 2), order) * l, one, mpfr(mpfr(1) / 2))}) {
        const auto miss = judged(drawn, 16);
        CHECK(miss.radius.value_or(2) <= 1);
        CHECK(miss.kind != singularity_kind::pole);
        CHECK(miss.kind != singularity_kind::logarithm);
        CHECK(miss.count <= 1);
    }
}

TEST_CASE(
    "of the whole population at least 95 in 100 radii and exponents are covered and none misses by ten "
    "uncertainties",
    "[.long][convergence][radius_population]") {
    constexpr int lists_of_a_family = 20;
    check_census("families", census_of(all_series_families(), 0, lists_of_a_family));
    check_census("solutions", census_of(calibrating_solutions(), orders_of_solutions));
    check_census("held-out solutions", census_of(held_out_solutions(), orders_of_solutions));
}

TEST_CASE("of families with logarithms upon powers at least 95 in 100 radii and exponents are covered",
          "[.long][convergence][radius_population]") {
    constexpr int lists_of_a_family = 60;
    auto families = logarithmic_families();
    const auto held_out = held_out_logarithmic_families();
    families.insert(families.end(), held_out.begin(), held_out.end());
    const census all = census_of(families, 100'000, lists_of_a_family);
    std::cout << "all with logarithms: " << all << '\n';
    CHECK(all.radius.is_enough());
    CHECK(all.exponent.is_enough());
    CHECK(all.exponent.by_ten == 0);
}

}  // namespace convergence_radius_population_test
