// Every study, with few parameters: it runs, it keeps the contract of its columns, and its bytes depend neither on the
// number of threads nor on the other cells. A new study is in here by itself.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "studies/study_rows.hpp"

namespace studies_all_studies_test {

using namespace libration;
using namespace libration::tests;

namespace {

// The study's own quick parameters.
study_order few_parameters(const study& what, int jobs) {
    study_words words;
    for (const study_parameter& parameter : what.quick) {
        words[parameter.option] = parameter.usual;
    }
    return order_of(what, words, jobs);
}

// The first columns of each study by DESIGN section 4; those of other studies are free.
std::string promised_columns(const std::string& name) {
    static const std::map<std::string, std::string> promised{
        {"error_norm", "energy,order,method,norm,time_of_maximum,scalar,rigour"},
        {"period_error", "energy,order,method,error"}};
    const auto found = promised.find(name);
    return found == promised.end() ? "" : found->second;
}

std::vector<std::filesystem::path> files_in_studies(const std::string& extension) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(LIBRATION_SOURCE_DIR "/studies")) {
        if (entry.path().extension() == extension) {
            files.push_back(entry.path());
        }
    }
    return files;
}

// NAME of each `const study& NAME() {`.
std::vector<std::string> studies_defined_in(const std::filesystem::path& file) {
    std::vector<std::string> names;
    std::ifstream source(file);
    const std::string start = "const study& ";
    for (std::string line; std::getline(source, line);) {
        if (line.starts_with(start) && line.ends_with("() {")) {
            names.push_back(line.substr(start.size(), line.size() - start.size() - 4));
        }
    }
    return names;
}

}  // namespace

TEST_CASE("each file of studies/ and its folders defines studies, and no other is known", "[studies]") {
    std::set<std::string> defined;
    for (const auto& file : files_in_studies(".cpp")) {
        INFO(file);
        const auto names = studies_defined_in(file);
        CHECK_FALSE(names.empty());
        // A file of one study has its name.
        CHECK((names.size() != 1 || names.front() == file.stem()));
        defined.insert(names.begin(), names.end());
    }
    std::set<std::string> names;
    for (const study* each : all_studies()) {
        names.insert(each->name);
    }
    CHECK(names == defined);
    CHECK(names.size() == all_studies().size());
    CHECK(names.contains("error_norm"));
}

TEST_CASE("each study has a figure script, a title, a question, a text for the report and a cost", "[studies]") {
    std::set<std::string> scripts;
    for (const auto& file : files_in_studies(".gp")) {
        scripts.insert(file.stem());
    }
    for (const study* each : all_studies()) {
        INFO(each->name);
        CHECK(scripts.contains(each->script.empty() ? each->name : each->script));
        CHECK_FALSE(each->title.empty());
        CHECK(each->question.ends_with("?"));
        CHECK(each->reading.ends_with("."));
        CHECK((each->needs_equation() || each->seconds > 0));
    }
}

TEST_CASE("scripts of figures plot columns: no other program computes, and each is short", "[studies][figures]") {
    for (const auto& file : files_in_studies(".gp")) {
        INFO(file);
        std::ifstream source(file);
        long lines = 0;
        for (std::string line; std::getline(source, line); ++lines) {
            INFO(line);
            CHECK((line.starts_with("#") ||
                   (line.find("awk") == std::string::npos && line.find("system(") == std::string::npos)));
        }
        CHECK((lines <= 100 || file.stem() == "style"));
    }
}

TEST_CASE("each study describes its parameters, and their usual words are understood", "[studies]") {
    for (const study* each : studies_of_own_problems()) {
        INFO(each->name);
        study_words usual;
        for (const study_parameter& parameter : each->parameters) {
            CHECK_FALSE(parameter.meaning.empty());
            if (parameter.option != "--scalar" && !parameter.usual.empty()) {
                usual[parameter.option] = parameter.usual;
            }
        }
        CHECK_NOTHROW(order_of(*each, usual, 1));
        CHECK_NOTHROW(order_of(*each, {}, 1));
    }
}

TEST_CASE("each study makes rectangular tables under the columns that it promised, the same by one cell at a time",
          "[studies][journal]") {
    for (const study* each : studies_of_own_problems()) {
        INFO(each->name);
        const auto tables = tables_of(few_parameters(*each, 2));
        REQUIRE_FALSE(tables.empty());
        if (!each->alone) {  // otherwise its rows are times
            const auto by_cells = tables_cell_by_cell(few_parameters(*each, 1));
            REQUIRE(tables.size() == by_cells.size());
            for (std::size_t i = 0; i < tables.size(); ++i) {
                INFO(tables[i].suffix);
                CHECK(tables[i].suffix == by_cells[i].suffix);
                CHECK((tables[i].timed || to_csv(tables[i].data) == to_csv(by_cells[i].data)));
            }
        }
        std::set<std::string> suffixes;
        for (const study_table& part : tables) {
            suffixes.insert(part.suffix);
            const std::string header = to_csv(table(part.data.columns()));
            if (part.suffix.empty()) {
                CHECK(header.starts_with(promised_columns(each->name)));
            }
            std::set<std::string> names;
            for (const column& c : part.data.columns()) {
                names.insert(c.name);
                CHECK_FALSE(c.meaning.empty());
            }
            CHECK(names.size() == part.data.columns().size());
            CHECK_FALSE(part.data.rows().empty());
            CHECK(std::all_of(part.data.rows().begin(), part.data.rows().end(),
                              [&](const auto& row) { return row.size() == part.data.columns().size(); }));
        }
        CHECK(suffixes.size() == tables.size());  // each table has a file of its own
        CHECK(suffixes.contains(""));             // and one of them is NAME.csv, which the figure reads
    }
}

TEST_CASE("no two cells of a study have the same key", "[studies][journal]") {
    for (const study* each : studies_of_own_problems()) {
        INFO(each->name);
        CHECK(has_different_keys(order_of(*each, {}, 1)));
    }
}

}  // namespace studies_all_studies_test
