// `libration study`, `studies` and `figure`: the files of a study, which depend on its parameters alone.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command/printed.hpp"

namespace command_study_test {

using namespace libration::tests;

namespace {}  // namespace

TEST_CASE("a study with --out writes its table, its description and its figures", "[command][study]") {
    const words order{"study",    "error_norm",    "--energies", "0.5,1.71,1.9998,2.02",
                      "--orders", "5,10,20,40,80", "--scalar",   "mpfr:50"};
    const temporary_folder folder;
    const finished_process done = run_libration(order + words{"--out", "out", "--jobs", "2"}, folder.path());
    INFO(done.err);
    REQUIRE(done.exit_code == 0);
    CHECK(done.out.empty());
    CHECK(lines_of(done.err) == words{"libration: wrote out/error_norm"});
    const words files{"out",
                      "out/error_norm",
                      "out/error_norm/error_norm.csv",
                      "out/error_norm/error_norm.json",
                      "out/error_norm/error_norm.png",
                      "out/error_norm/error_norm.svg",
                      "out/error_norm/error_norm.tex"};
    REQUIRE(folder.content() == files);

    const auto own = folder.path() / "out" / "error_norm";
    const std::string csv = text_of_file(own / "error_norm.csv");
    CHECK(csv == output_of(order + words{"--jobs", "1"}));
    const auto rows = csv_rows(csv);
    REQUIRE(rows.size() == 40);
    for (const table_row& row : rows) {
        CHECK(row.at("scalar") == "mpfr:50");
        CHECK(row.at("rigour") == "two-method");
        CHECK(significant_digits(row.at("norm")) == 50);
    }

    const auto json = nlohmann::ordered_json::parse(text_of_file(own / "error_norm.json"));
    CHECK(json.at("command") == command_line(order));  // without --out and --jobs
    CHECK(json.at("tables").at(0).at("file") == "error_norm.csv");
    words described;
    for (const auto& [name, meaning] : json.at("columns").items()) {
        described.push_back(name);
        CHECK_FALSE(meaning.get<std::string>().empty());
    }
    CHECK(described == split_cells(lines_of(csv).front()));
    for (const std::string library : {"libration", "commit", "Boost", "MPFR", "GMP"}) {
        CHECK(json.at("made with").contains(library));
    }

    CHECK(text_of_file(own / "error_norm.png").starts_with("\x89PNG"));
    const std::string svg = text_of_file(own / "error_norm.svg");
    CHECK(svg.find("</svg>") != std::string::npos);

    std::filesystem::remove(own / "error_norm.svg");
    CHECK(run_libration({"figure", "error_norm", "--out", "out"}, folder.path()).exit_code == 0);
    CHECK(folder.content() == files);
    CHECK(text_of_file(own / "error_norm.svg") == svg);
}

TEST_CASE("a study takes energies and gaps in any order and sorts them", "[command][study]") {
    const words base{"study", "error_norm", "--orders", "5", "--scalar", "mpfr:20"};
    words energies;
    words gaps;
    for (const table_row& row : csv_rows(output_of(base + words{"--energies", "2.02,0.5", "--gaps=-1e-30,1e-30"}))) {
        energies.push_back(row.at("energy"));
        gaps.push_back(row.at("gap"));
    }
    CHECK(energies == words{"0.5", "0.5", "1.999999999999999999999999999999", "1.999999999999999999999999999999",
                            "2.000000000000000000000000000001", "2.000000000000000000000000000001", "2.02", "2.02"});
    CHECK(gaps == words{"1.5", "1.5", "1e-30", "1e-30", "-1e-30", "-1e-30", "-0.02", "-0.02"});
}

TEST_CASE("all scalars of a study are one table on stdout, with one header line", "[command][study]") {
    const auto done = run_libration({"study", "error_norm", "--energies", "1", "--orders", "5", "--step", "1e-3"});
    REQUIRE(done.exit_code == 0);
    // The baseline has columns of its own, so it is named and not printed.
    CHECK(lines_of(done.err) == words{"libration: error_norm makes more tables (baseline): see them with --out DIR"});
    words scalars;
    for (const table_row& row : csv_rows(done.out)) {
        CHECK(row.at("energy") == "1");
        scalars.push_back(row.at("scalar"));
    }
    CHECK(scalars == words{"ball:50", "ball:50", "double", "double", "long-double", "long-double", "quad", "quad"});
}

TEST_CASE("studies are listed with question, parameters and cost", "[command][study]") {
    const std::string list = output_of({"studies"});
    for (const std::string part :
         {"error_norm  [paper fig:error]\n", "?\n", "--energies ", "--gaps ", "--orders ", "--scalar ", "cost "}) {
        INFO(part);
        CHECK(list.find(part) != std::string::npos);
    }
}

}  // namespace command_study_test
