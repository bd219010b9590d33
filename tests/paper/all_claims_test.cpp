// The claims table as a whole: what every row has to have. Each claim has a test of its own beside this file.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "claims/claim.hpp"
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

TEST_CASE("a correction stands beside exactly those claims that need one", "[paper][claims]") {
    const auto claims = all_claims();
    for (const judged_claim& each : judge(claims, 2)) {
        INFO(each.of->name);
        CHECK(each.of->correction.empty() == (each.found.verdict == verdict::holds));
    }
}

TEST_CASE("the claims table does not depend on the number of threads", "[paper][claims]") {
    const auto claims = all_claims();
    CHECK(to_csv(claims_table(judge(claims, 1))) == to_csv(claims_table(judge(claims, 2))));
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
