// Numbers in prose come from tables, and every placeholder of a study finds its number in the published ones.
#include "text/measured_text.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "sweep/study.hpp"

namespace text_measured_text_test {

using namespace libration;
using Catch::Contains;

namespace {

std::optional<table> example(const std::string& stem) {
    if (stem != "errors") {
        return std::nullopt;
    }
    return from_csv("order,method,error\n2,series,0.3242\n2,resummed,0.01\n4,series,0.37\n4,resummed,\n");
}

std::optional<table> published(const std::string& stem) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(LIBRATION_SOURCE_DIR "/results")) {
        if (entry.path().filename() == stem + ".csv") {
            std::ifstream file(entry.path(), std::ios::binary);
            return from_csv({std::istreambuf_iterator<char>(file), {}});
        }
    }
    return std::nullopt;
}

}  // namespace

TEST_CASE("a placeholder is a number of a table, rounded", "[report]") {
    const auto text = [](const std::string& words) { return measured_text(words, example); };
    CHECK(text("no number") == "no number");
    CHECK(text("{{max error of errors where order=2 to 2}}, {{min error of errors to 1}}") == "0.32, 0.01");
    CHECK(text("at {{the error of errors where order=2.0 method=series to 4}} radians") == "at 0.3242 radians");
    CHECK(text("{{max error of errors where order=4 / min error of errors to 3}} times") == "37.0 times");
}

TEST_CASE("what was not measured is said, what cannot be meant is refused", "[report]") {
    const auto text = [](const std::string& words) { return measured_text(words, example); };
    CHECK(text("{{max error of others to 2}}") == not_measured);
    CHECK(text("{{max error of errors where order=7 to 2}}") == not_measured);
    CHECK_THROWS_WITH(text("{{max speed of errors to 2}}"), Contains("no column speed"));
    CHECK_THROWS_WITH(text("{{the error of errors to 2}}"), Contains("several values"));
    CHECK_THROWS_WITH(text("{{mean error of errors to 2}}"), Contains("max|min|the"));
    CHECK_THROWS_WITH(text("{{max error of errors}}"), Contains("to DIGITS"));
    CHECK_THROWS_WITH(text("{{max error of errors to 0}}"), Contains("number of digits"));
    CHECK_THROWS_WITH(text("{{max error of errors where order to 2}}"), Contains("COLUMN=VALUE"));
    CHECK_THROWS_WITH(text("{{max error"), Contains("without"));
}

TEST_CASE("every placeholder of a study finds its number in the published tables", "[report][studies]") {
    int measured = 0;
    for (const study* each : all_studies()) {
        // The set `problems` is made on demand.
        if (!std::filesystem::exists(std::string(LIBRATION_SOURCE_DIR "/results/") + each->name)) {
            continue;
        }
        INFO(each->name);
        const std::string text = measured_text(each->reading, published);
        CHECK(text.find(not_measured) == std::string::npos);
        CHECK(text.find("{{") == std::string::npos);
        measured += text != each->reading ? 1 : 0;
    }
    CHECK(measured >= 5);
}

}  // namespace text_measured_text_test
