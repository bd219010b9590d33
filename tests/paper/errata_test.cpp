// The letter to the authors: that it names claims, and that its table is what the bounds give. all_claims_test.cpp sees
// that it leaves out none.
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>

#include "libration/pendulum/error_norm.hpp"
#include "paper/claims/claim.hpp"
#include "paper/claims/printed_numbers.hpp"
#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace paper_errata_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

std::string letter() {
    std::ifstream file(LIBRATION_SOURCE_DIR "/studies/errata.md.in");
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace

TEST_CASE("errata: every placeholder is the name of a claim or a label of the paper", "[paper][errata]") {
    const std::string text = letter();
    const auto all = all_claims();
    const std::regex placeholder(R"(\{\{([^}]*)\}\})");
    for (std::sregex_iterator at(text.begin(), text.end(), placeholder); at != std::sregex_iterator(); ++at) {
        const std::string name = (*at)[1];
        INFO(name);
        const bool prints = name.starts_with("printed ") && printed_place(name.substr(8)) != name.substr(8);
        CHECK((prints || std::any_of(all.begin(), all.end(), [&](const claim& c) { return c.name == name; })));
    }
}

TEST_CASE("errata: the table of bounds over errors is right to its last digit", "[paper][errata]") {
    const std::string text = letter();
    const std::regex row(R"(\| ([0-9.]+) \| ([0-9]+) \| ([0-9.e]+) \| ([0-9.e]+) \|)");
    int rows = 0;
    for (std::sregex_iterator at(text.begin(), text.end(), row); at != std::sregex_iterator(); ++at) {
        const std::string energy = (*at)[1];
        const int order = std::stoi((*at)[2]);
        INFO("E = " << energy << ", N = " << order);
        const motion m = with_energy(energy);
        const precision_scope precision(20 + digits_below(m, order));
        arc_errors errors(m);
        const mpfr series = errors.bounds().series_norm(order) / errors.norm(arc_method::series, order).norm;
        const mpfr resummed = errors.bounds().resummation_norm(order) / errors.norm(arc_method::resummed, order).norm;
        CHECK(to_decimal(series, 3) == (*at)[3]);
        CHECK(to_decimal(resummed, 3) == (*at)[4]);
        ++rows;
    }
    CHECK(rows == 10);
}

}  // namespace paper_errata_test
