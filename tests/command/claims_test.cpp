// `libration claims`: the verdicts on the paper, and the commands that reproduce them.
#include <algorithm>
#include <catch2/catch.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "command/printed.hpp"
#include "command/refusal.hpp"
#include "paper/claims/claim.hpp"
#include "sweep/study_order.hpp"

namespace command_claims_test {

using namespace libration;
using namespace libration::tests;

namespace {

// The arguments after ./run.
words words_of(const std::string& command) {
    std::istringstream in(command);
    words result;
    for (std::string word; in >> word;) {
        result.push_back(word);
    }
    return {result.begin() + 1, result.end()};
}

// Parses the options of a study; the study itself is run by the tests of studies.
void check_study(const words& given) {
    const auto studies = all_studies();
    const auto what =
        std::find_if(studies.begin(), studies.end(), [&](const study* each) { return each->name == given.at(1); });
    REQUIRE(what != studies.end());
    study_words said;
    for (std::size_t i = 2; i < given.size(); ++i) {
        const auto equals = given[i].find('=');
        if (equals != std::string::npos) {
            said[given[i].substr(0, equals)] = given[i].substr(equals + 1);
        } else {
            said[given[i]] = given.at(i + 1);
            ++i;
        }
    }
    said.erase("--out");
    said.erase("--jobs");
    CHECK_NOTHROW(order_of(**what, said, 1));
}

}  // namespace

TEST_CASE("the command beside each claim runs", "[.long][command][claims]") {
    std::set<std::string> run;
    for (const claim& each : all_claims()) {
        INFO(each.name << ": " << each.command);
        if (!run.insert(each.command).second) {
            continue;
        }
        const words given = words_of(each.command);
        if (given.front() == "study") {
            check_study(given);
            continue;
        }
        const finished_process done = run_libration(given);
        INFO(done.err);
        CHECK(done.exit_code == 0);
        CHECK_FALSE(done.out.empty());
    }
}

TEST_CASE("claims are chosen by name, and printed in any format", "[command][claims]") {
    const std::string name = all_claims().front().name;
    const auto rows = from_csv(output_of({"claims", name, "--format", "csv"}));
    REQUIRE(rows.rows().size() == 1);
    CHECK(rows.rows().front().front().text() == name);
    CHECK(output_of({"claims", name}).starts_with(name + "  "));
    CHECK(output_of({"claims", name, "--format", "latex"}).starts_with("\\begin{tabular}"));
}

TEST_CASE("claims are chosen by the label of a figure and by its printed number alike", "[command][claims]") {
    const std::string by_label = output_of({"claims", "fig:subcrit", "--format", "csv"});
    CHECK(by_label == output_of({"claims", "Figure 4", "--format", "csv"}));
    const auto rows = from_csv(by_label);
    REQUIRE(rows.rows().size() == 3);
    for (const auto& row : rows.rows()) {
        CHECK(row.at(1).text().find("fig:subcrit") != std::string::npos);
        CHECK(row.at(9).text().find("figure 4") != std::string::npos);
        CHECK(row.at(8).is_empty() == (row.at(3).text() == "holds"));
    }
}

TEST_CASE("a claim that there is not is refused", "[command][claims]") {
    check_refused({"claims", "nonsense"},
                  {"claims 'nonsense' is not a claim, nor a label or a printed number that claims concern: see "
                   "'libration claims'; labels are as fig:subcrit, numbers as 'Figure 4' or '(16c)'"});
}

TEST_CASE("cite prints BibTeX for the program and the paper", "[command]") {
    const std::string text = output_of({"cite"});
    CHECK(text.starts_with("@software{libration,\n"));
    CHECK(text.find("@misc{pendulum_series,\n") != std::string::npos);
    CHECK(text.find("eprint        = {2108.09395}") != std::string::npos);
    CHECK(std::regex_search(text, std::regex("year +=")));
    CHECK(std::count(text.begin(), text.end(), '{') == std::count(text.begin(), text.end(), '}'));
}

}  // namespace command_claims_test
