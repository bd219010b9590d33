// The claims table as a whole: what every row has to have. Each claim has a test of its own beside this file.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "paper/claims/claim.hpp"
#include "paper/claims/printed_numbers.hpp"
#include "paper/claims/severity.hpp"
#include "paper/judged.hpp"
#include "text/table.hpp"

namespace paper_all_claims_test {

using namespace libration;

namespace {

// All sources of tests/paper as one text.
std::string tests_of_the_paper() {
    std::string text;
    for (const auto& entry : std::filesystem::directory_iterator(LIBRATION_SOURCE_DIR "/tests/paper")) {
        std::ifstream file(entry.path());
        text.append(std::istreambuf_iterator<char>(file), {});
    }
    return text;
}

std::string text_of(const std::string& path) {
    std::ifstream file(std::string(LIBRATION_SOURCE_DIR "/") + path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("the paper is judged by forty claims and more, each with all that a reader needs", "[paper][claims]") {
    const auto claims = all_claims();
    CHECK(claims.size() >= 40);
    std::set<std::string> names;
    for (const claim& each : claims) {
        INFO(each.name);
        CHECK(names.insert(each.name).second);
        CHECK(std::all_of(each.name.begin(), each.name.end(),
                          [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; }));
        CHECK_FALSE(each.label.empty());
        CHECK_FALSE(each.statement.empty());
        CHECK_FALSE(each.number.empty());
        CHECK(each.command.starts_with("./run "));
    }
}

TEST_CASE("each claim has a test of its own", "[paper][claims]") {
    const std::string tests = tests_of_the_paper();
    for (const claim& each : all_claims()) {
        INFO(each.name);
        CHECK(tests.find("TEST_CASE(\"claim " + each.name + ": ") != std::string::npos);
    }
}

// That each row is what is measured is a check of the claim's own test (judged.hpp).
TEST_CASE("claims are the published ones, corrected and in the letter where they do not hold",
          "[paper][claims][errata][results]") {
    const auto claims = all_claims();
    const auto published = from_csv(published_claims()).rows();
    REQUIRE(published.size() == claims.size());
    const std::string letter = text_of("studies/errata.md.in");
    for (std::size_t i = 0; i < claims.size(); ++i) {
        INFO(claims[i].name);
        CHECK(published[i].at(0).text() == claims[i].name);
        const bool holds = published[i].at(3).text() == "holds";
        CHECK(claims[i].correction.empty() == holds);
        CHECK((holds || letter.find(claims[i].name) != std::string::npos));
        CHECK(severity_of(claims[i].name).has_value() != holds);
    }
}

// Counted in the paper's source, equations with parts by their letters.
TEST_CASE("labels are replaced by the numbers that the paper prints", "[paper][claims]") {
    CHECK(printed_place("fig:subcrit, text") == "figure 4, text");
    CHECK(printed_place("cosseriesrec, sinseriesrec") == "(16c), (16d)");
    CHECK(printed_place("sec:convergence, text; Knew") == "section III C, text; (28)");
    CHECK(printed_place("truncation2") == "(A1b)");
    CHECK(printed_place("abstract") == "abstract");
    for (const claim& each : all_claims()) {
        INFO(each.name << ": " << each.label);
        CHECK((is_own(each.label) || each.label == "abstract" || printed_place(each.label) != each.label));
    }
}

TEST_CASE("claims concern a label, its number in several spellings, and the parts of an equation or section",
          "[paper][claims]") {
    for (const char* asked : {"fig:subcrit", "figure 4", "Figure 4", "Fig. 4"}) {
        CHECK(concerns("fig:subcrit, fig:supercrit", asked));
        CHECK_FALSE(concerns("fig:supercrit, text", asked));
    }
    CHECK(concerns("cosseriesrec", "(16c)"));
    CHECK(concerns("cosseriesrec", "Eq. 16"));
    CHECK_FALSE(concerns("cosseriesrec", "1"));
    CHECK_FALSE(concerns("fig:period", "figure 1"));
    CHECK(concerns("sec:sing, text", "section III"));
    CHECK_FALSE(concerns("sec:sing, text", "section I"));
    CHECK(concerns("abstract", "Abstract"));
    CHECK_FALSE(concerns("sec:sing, text", "text"));
    CHECK_FALSE(concerns("libration: theorem U", "T"));
}

TEST_CASE("a measurement that throws is named", "[paper][claims]") {
    const claim broken{"broken",
                       "none",
                       "it breaks",
                       "nothing",
                       "",
                       "./run",
                       []() -> finding { throw std::domain_error("no number"); }};
    CHECK_THROWS_WITH(judge({broken}, 1), Catch::Contains("claim broken") && Catch::Contains("no number"));
}

}  // namespace paper_all_claims_test
