// The study singularities against mpmath, the lattice and the residues of omega.
#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "studies/study_rows.hpp"
#include "text/input_error.hpp"

namespace studies_singularities_test {

using namespace libration;
using namespace libration::tests;

namespace {

using tables_by_suffix = std::map<std::string, std::vector<table_row>>;

tables_by_suffix run(const study_words& words) { return rows_by_suffix("singularities", words); }

std::vector<table_row> of_kind(const std::vector<table_row>& rows, const std::string& kind) {
    std::vector<table_row> found;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(found),
                 [&](const table_row& row) { return row.at("kind") == kind; });
    return found;
}

struct tabulated_pole {
    std::string re, im, residue_re, residue_im;
};

// mpmath: pade(f, 4, 5) and polyroots at 120 digits, f the series of omega/t (E = 1.71) or omega (E = 2.02) in s = t^2
// from 20 coefficients by (pendseries), t = sqrt(s), residue p(s)/q'(s) times 1/2 or 1/(2t).
const std::map<std::string, std::vector<tabulated_pole>> tabulated{
    {"1.71",
     {{"2.40473734855649488432960524469529547280289367", "1.63291502354056552602577107149676320561702429",
       "0.00027554542228897", "2.0005684649144"},
      {"2.38348013896484309513394197550559481863681825", "4.66247915206542148209907375280191331668556745",
       "-0.18580740335532", "-1.4044403652741"},
      {"5.30967025628912384361681308937394494464181321", "0", "-0.36621668696059", "0"}}},
    {"2.02",
     {{"3.68306763832818614933774371710958848072776775", "1.56532594750604762373450950073727355223455334",
       "-0.013989474637848", "-2.0022609011773"},
      {"3.47193491883267128370499176603587301881292056", "4.73820407817416996564855523609853184880148886",
       "-0.48983563045783", "1.5827074687263"},
      {"5.98772640144988736876519331489777193587614803", "0", "-0.22910384402872", "0"}}}};

}  // namespace

TEST_CASE("the Pade poles are those of mpmath to the last digit", "[studies][singularities]") {
    for (const auto& [energy, expected] : tabulated) {
        const auto poles = of_kind(run({{"--energies", energy}, {"--orders", "20"}}).at(""), "pade_pole");
        REQUIRE(poles.size() == expected.size());
        for (std::size_t i = 0; i < poles.size(); ++i) {
            INFO("E = " << energy << ", pole " << i);
            CHECK_THAT(poles[i].at("re"), right_to_the_last_digit(expected[i].re));
            CHECK_THAT(poles[i].at("im"), right_to_the_last_digit(expected[i].im));
            CHECK_THAT(poles[i].at("residue_re"), right_to_the_last_digit(expected[i].residue_re));
            CHECK_THAT(poles[i].at("residue_im"), right_to_the_last_digit(expected[i].residue_im));
        }
    }
}

TEST_CASE("the lattice and the circles are those of the elliptic integrals", "[studies][singularities]") {
    // mpmath: ellipk(E/2), ellipk(1-E/2) at E = 1.71, sqrt(2/E) times ellipk(2/E), ellipk(1-2/E) at E = 2.02.
    const std::map<std::string, std::pair<std::string, std::string>> sides{
        {"1.71", {"2.40468555010205243703926226209743624324724074", "1.63290849095910067916538977551587693207326797"}},
        {"2.02", {"3.68219248609141032919857172173162608185989227", "1.56689127306819635838384657341142323770881034"}}};
    const precision_scope scope(60);
    for (const auto& [energy, side] : sides) {
        INFO("E = " << energy);
        const mpfr tstar = number_of(side.first);
        const mpfr height = number_of(side.second);
        const auto rows = run({{"--energies", energy}, {"--orders", "4"}}).at("");
        std::set<std::pair<int, int>> seen;
        for (const table_row& row : of_kind(rows, "singularity")) {
            const integer m = nearest_integer(number_of(row.at("re")) / tstar);
            const integer n = nearest_integer(number_of(row.at("im")) / height);
            CHECK_THAT(row.at("re"), right_to_the_last_digit_of(tstar * mpfr(m)));
            CHECK_THAT(row.at("im"), right_to_the_last_digit_of(height * mpfr(n)));
            seen.emplace(static_cast<int>(m), static_cast<int>(n));
        }
        // Three odd multiples fit neither 4 T* nor 4 K~' nor 1.5 R: those of 1 and 3 with both signs.
        const std::set<std::pair<int, int>> all{{-3, -3}, {-3, -1}, {-3, 1}, {-3, 3}, {-1, -3}, {-1, -1},
                                                {-1, 1},  {-1, 3},  {1, -3}, {1, -1}, {1, 1},   {1, 3},
                                                {3, -3},  {3, -1},  {3, 1},  {3, 3}};
        CHECK(seen == all);
        const auto top = of_kind(rows, "expansion_top");
        REQUIRE(top.size() == 1);
        CHECK_THAT(top[0].at("radius"), right_to_the_last_digit_of(sqrt(tstar * tstar + height * height)));
        const auto bottoms = of_kind(rows, "expansion_bottom");
        REQUIRE(bottoms.size() == 2);
        CHECK_THAT(bottoms[1].at("re"), right_to_the_last_digit_of(tstar));
        CHECK_THAT(bottoms[1].at("radius"), right_to_the_last_digit_of(height));
    }
}

TEST_CASE("poles on the lattice have the residues 2i and -2i in turn", "[studies][singularities]") {
    const precision_scope scope(50);
    int settled = 0;
    const auto rows = run({{"--energies", "0.5,1.71,2.02,8"}, {"--orders", "60"}}).at("");
    for (const table_row& row : rows) {
        if (row.at("kind") != "pade_pole" || number_of(row.at("log10_distance")) > -6) {
            continue;
        }
        ++settled;
        const long column =
            static_cast<long>(nearest_integer(number_of(row.at("nearest_re")) / number_of(row.at("tstar"))));
        const long up =
            static_cast<long>(nearest_integer(number_of(row.at("nearest_im")) / number_of(row.at("height"))));
        const bool rotates = row.at("gap").front() == '-';
        // Half a period of sn, cn or dn changes their signs: columns in turn for libration, rows in turn for both.
        const int sign = ((up / 2 + (rotates ? 1 : column / 2)) % 2 == 0) ? 1 : -1;
        INFO(row.at("energy") << ": " << column << " T*, " << up << " K~'");
        CHECK(abs(number_of(row.at("residue_re"))) < mpfr("1e-3"));
        CHECK(abs(number_of(row.at("residue_im")) - 2 * sign) < mpfr("1e-3"));
    }
    CHECK(settled >= 8);  // at least two an energy
}

TEST_CASE("twice the order gives more than twice the digits of the first singularity", "[studies][singularities]") {
    const auto rows = run({{"--energies", "0.5,1,1.71,2.02,4"}, {"--orders", "60"}}).at("convergence");
    std::map<std::string, std::map<std::string, mpfr>> distance;
    const precision_scope scope(30);
    for (const table_row& row : rows) {
        if (row.at("order") == "60") {
            CHECK(number_of(row.at("log10_root_error")) > -2);
        }
        if (!row.at("log10_distance").empty()) {
            distance[row.at("energy")][row.at("order")] = number_of(row.at("log10_distance"));
        }
    }
    CHECK(distance.size() == 5);
    for (auto& [energy, at] : distance) {
        INFO("E = " << energy);
        CHECK(at.at("60") < at.at("30") * 2);
        CHECK(at.at("60") < -15);
    }
}

TEST_CASE("what has no lattice or no pole is refused", "[studies][singularities]") {
    CHECK_THROWS_AS(run({{"--energies", "0"}}), libration::error);
    CHECK_THROWS_AS(run({{"--energies", "1,2"}}), libration::error);
    CHECK_THROWS_AS(run({{"--orders", "3,20"}}), input_error);
}

}  // namespace studies_singularities_test
