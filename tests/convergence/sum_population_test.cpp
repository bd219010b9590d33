// How often the known value of a series is within its uncertainty, and how many digits are certain, over random closed
// forms: a sample, and all of them with `./run test --long`.
#include <algorithm>
#include <catch2/catch.hpp>
#include <iostream>
#include <map>

#include "../studies/population/known_values.hpp"
#include "libration/convergence/sum.hpp"

namespace convergence_sum_population_test {

using namespace libration;
using namespace libration::convergence;
using namespace libration::tests;

namespace {

struct tally {
    int lists = 0, values = 0, held = 0;
    std::vector<double> digits = {};  // certain ones

    double median() {
        std::ranges::sort(digits);
        return digits.empty() ? 0 : digits[digits.size() / 2];
    }
};

std::map<std::string, tally> tallies(unsigned first, unsigned end) {
    std::map<std::string, tally> all;
    for (unsigned seed = first; seed < end; ++seed) {
        const precision_scope scope(400);
        const known_sum known = known_value_of(seed);
        const std::vector<mpfr> points{known.x};
        const auto found = sums_of_list({.values = known.a}, {}, points).front();
        tally& here = all[known.region];
        ++here.lists;
        if (!found.value) {
            continue;
        }
        ++here.values;
        const bool held = abs(mpfr(*found.value - known.truth)) <= found.uncertainty;
        here.held += held ? 1 : 0;
        here.digits.push_back(-mpfr(log10(mpfr(found.uncertainty / abs(known.truth)))).convert_to<double>());
        INFO(known.family << ", seed " << seed);
        CHECK(abs(mpfr(*found.value - known.truth)) <= found.uncertainty * 10);
    }
    return all;
}

int count(const std::map<std::string, tally>& all, int tally::*of) {
    int sum = 0;
    for (const auto& [region, each] : all) {
        sum += each.*of;
    }
    return sum;
}

}  // namespace

TEST_CASE("of a sample of random series all values are within their uncertainties", "[convergence][sum population]") {
    const auto all = tallies(0, 8);
    CHECK(count(all, &tally::held) == count(all, &tally::values));
    CHECK(count(all, &tally::values) >= 7);
}

TEST_CASE("of random series at least 97 in 100 values are within their uncertainties, with as many digits as designed",
          "[.long][convergence][sum population]") {
    auto all = tallies(1000, 1600);
    for (auto& [region, each] : all) {
        std::cout << region << ": " << each.lists << " lists, " << each.values << " values, " << each.held
                  << " within the uncertainty, median of certain digits " << each.median() << '\n';
    }
    CHECK(count(all, &tally::held) * 100 >= count(all, &tally::values) * 97);
    CHECK(count(all, &tally::values) * 10 >= count(all, &tally::lists) * 9);
    CHECK(all["inside"].median() >= 18);
    CHECK(all["beyond"].median() >= 10);
    CHECK(all["divergent"].median() >= 12);
    CHECK(all["pole beyond"].median() >= 12);
}

}  // namespace convergence_sum_population_test
