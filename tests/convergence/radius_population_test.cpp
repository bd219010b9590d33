// How often the true radius lies within the uncertainty of the verdict, over a population of 39 families of series: a
// sample of it, and all of it with `./run test --long`.
#include <algorithm>
#include <catch2/catch.hpp>
#include <iostream>

#include "convergence/radius_families.hpp"
#include "libration/convergence/list/coefficient_noise.hpp"
#include "libration/convergence/list_report.hpp"

namespace convergence_radius_population_test {

using namespace libration;
using namespace libration::tests;

namespace {

// What a list gave: |radius - truth| in uncertainties; nothing without an answer.
template <class T>
std::optional<double> miss_of(const power_series<mpfr>& list, const T& noise, const mpfr& truth) {
    const auto found = report_on_list(list, noise);
    const precision_scope scope(100);
    const auto verdict = in_unit(widened(found.report.verdict), narrow<mpfr>(found.unit.length));
    if (!verdict.radius) {
        return std::nullopt;
    }
    return mpfr(abs(*verdict.radius - truth) / verdict.uncertainty).convert_to<double>();
}

// One list: N and the digits of its coefficients by chance, 16 standing for doubles.
std::optional<double> draw(const series_family& family, std::uint64_t seed, const std::vector<int>& orders,
                           const std::vector<int>& digits_of_lists) {
    const precision_scope scope(160);
    dice random(seed);
    const int order = random.one_of(orders);
    const int digits = random.one_of(digits_of_lists);
    const drawn_series drawn = family.draw(random, order);
    if (digits == 16) {
        return miss_of(drawn.a, epsilon<double>(), drawn.radius);
    }
    auto list = drawn.a;
    std::vector<exact> written;
    for (int n = 0; n <= order; ++n) {
        written.push_back(read_exact(to_decimal(drawn.a[n], digits)));
        list[n] = from_exact<mpfr>(written.back());
    }
    const precision_scope judging(std::max(digits, 30));
    return miss_of(list, noise_of<mpfr>(written), drawn.radius);
}

struct coverage {
    int lists = 0, answers = 0, covered = 0;
    double worst = 0;

    void add(const std::optional<double>& miss) {
        ++lists;
        answers += miss ? 1 : 0;
        covered += miss && *miss <= 1 ? 1 : 0;
        worst = std::max(worst, miss.value_or(0));
    }
};

std::ostream& operator<<(std::ostream& out, const coverage& c) {
    return out << c.lists << " lists, " << c.answers << " answers, " << c.covered << " covered, largest miss "
               << c.worst << " uncertainties";
}

}  // namespace

TEST_CASE("of a sample of all families at least 95 in 100 radii are covered and none misses by ten uncertainties",
          "[convergence][radius_population]") {
    coverage all;
    std::uint64_t seed = 0;
    for (const auto& family : all_series_families()) {
        const auto miss = draw(family, 700 + 1000 * seed++, {20, 30, 40}, {10, 16, 30});
        INFO(family.name);
        CHECK(miss.value_or(0) <= 10);
        all.add(miss);
    }
    INFO(all);
    CHECK(all.covered * 100 >= all.answers * 95);
    CHECK(all.answers * 10 >= all.lists * 8);  // and it does answer
}

TEST_CASE("of the whole population at least 95 in 100 radii are covered and none misses by ten uncertainties",
          "[.long][convergence][radius_population]") {
    constexpr int lists_of_a_family = 20;
    coverage all;
    std::uint64_t first = 0;
    for (const auto& family : all_series_families()) {
        coverage here;
        for (int k = 0; k < lists_of_a_family; ++k) {
            const auto miss = draw(family, first + static_cast<std::uint64_t>(k), {20, 30, 40, 60, 80, 120, 200},
                                   {6, 10, 16, 16, 30, 60});
            here.add(miss);
            all.add(miss);
        }
        first += 1000;
        std::cout << family.name << ": " << here << '\n';
    }
    std::cout << "all: " << all << '\n';
    CHECK(all.covered * 100 >= all.answers * 95);
    CHECK(all.worst <= 10);
}

}  // namespace convergence_radius_population_test
