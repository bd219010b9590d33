// `libration reproduce`: the directory it fills, and the pages generated from it.
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "command/printed.hpp"
#include "text/table.hpp"

namespace command_report_test {

using namespace libration::tests;

namespace {

// The number of occurrences of a text.
std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) {
        ++count;
    }
    return count;
}

std::string without_images(std::string page) {
    const std::string begin = "src=\"data:";
    for (std::size_t at = page.find(begin); at != std::string::npos; at = page.find(begin, at)) {
        page.erase(at, page.find('"', at + begin.size()) - at);
    }
    return page;
}

}  // namespace

TEST_CASE("reproduce makes the chosen studies, the claims, and pages of both", "[command][report]") {
    const temporary_folder folder;
    const finished_process done =
        run_libration({"reproduce", "--only", "period_error,claims", "--out", "out"}, folder.path());
    INFO(done.err);
    REQUIRE(done.exit_code == 0);
    CHECK(done.out.empty());
    CHECK(lines_of(done.err).front().starts_with("libration: part 1 of 2, claims"));
    CHECK(lines_of(done.err).back() == "libration: wrote out; open out/index.html");
    const auto out = folder.path() / "out";

    const std::string page = text_of_file(out / "index.html");
    CHECK(page.starts_with("<!DOCTYPE html>"));
    CHECK(page.ends_with("</html>\n"));
    // It requires no network and no other file: images are embedded, and nothing is loaded.
    CHECK(count_of(page, "<img ") == count_of(page, "src=\"data:image/svg+xml,"));
    CHECK(count_of(page, "<img ") == 1);
    // http: occurs only within the images, in the names of their XML.
    const std::string around = without_images(page);
    for (const std::string loaded : {"http:", "https:", "<script", "@import", "url(", "src=\"/"}) {
        INFO(loaded);
        CHECK(around.find(loaded) == std::string::npos);
    }
    // The targets of its links exist.
    const std::regex link(R"re(href="([^"#:]+)")re");
    for (std::sregex_iterator at(page.begin(), page.end(), link); at != std::sregex_iterator(); ++at) {
        INFO((*at)[1]);
        CHECK(std::filesystem::exists(out / (*at)[1].str()));
    }
    const std::regex anchor(R"re(href="#([^"]+)")re");
    for (std::sregex_iterator at(page.begin(), page.end(), anchor); at != std::sregex_iterator(); ++at) {
        INFO((*at)[1]);
        CHECK(page.find("id=\"" + (*at)[1].str() + "\"") != std::string::npos);
    }

    // The menu links to every chapter.
    const std::string menu = page.substr(page.find("<nav>"), page.find("</nav>") - page.find("<nav>"));
    const std::regex chapter(R"re(<h2 id="([^"]+)")re");
    for (std::sregex_iterator at(page.begin(), page.end(), chapter); at != std::sregex_iterator(); ++at) {
        INFO((*at)[1]);
        CHECK(menu.find("href=\"#" + (*at)[1].str() + "\"") != std::string::npos);
    }

    const auto claims = libration::from_csv(text_of_file(out / "claims.csv"));
    CHECK(count_of(page, "<article ") == claims.rows().size());
    const std::string index = text_of_file(out / "README.md");
    for (const auto& row : claims.rows()) {
        CHECK(index.find("\n| " + row.front().text() + " | ") != std::string::npos);
    }
    CHECK(text_of_file(out / "errata.md").find("{{") == std::string::npos);
}

TEST_CASE("without claims the pages are made of the studies alone", "[command][report]") {
    const temporary_folder folder;
    REQUIRE(run_libration({"reproduce", "--only", "period_error", "--out", "out"}, folder.path()).exit_code == 0);
    const auto out = folder.path() / "out";
    CHECK(text_of_file(out / "index.html").find("Does the paper hold?") == std::string::npos);
    CHECK_FALSE(std::filesystem::exists(out / "errata.md"));
    CHECK(text_of_file(out / "README.md").find("[period_error](period_error)") != std::string::npos);
}

TEST_CASE("reproduce makes the reference values, and both pages lead to their files", "[command][report][table]") {
    const temporary_folder folder;
    REQUIRE(run_libration({"reproduce", "--only", "reference", "--out", "out"}, folder.path()).exit_code == 0);
    const auto out = folder.path() / "out";
    const std::string page = text_of_file(out / "index.html");
    const std::string index = text_of_file(out / "README.md");
    const auto tables = nlohmann::json::parse(text_of_file(out / "reference" / "reference.json"));
    std::size_t bytes = 0;
    for (const auto& each : tables) {
        const std::string name = each.at("name");
        INFO(name);
        CHECK(each.at("files").size() == 4);
        for (const std::string file : each.at("files")) {
            CHECK(page.find("href=\"reference/" + file + "\"") != std::string::npos);
            CHECK(index.find("(reference/" + file + ")") != std::string::npos);
            bytes += std::filesystem::file_size(out / "reference" / file);
        }
        const std::string csv = text_of_file(out / "reference" / (name + ".csv"));
        CHECK(lines_of(csv).size() == each.at("rows").get<std::size_t>() + 1);
    }
    CHECK(tables.size() >= 6);
    CHECK(bytes < 1'500'000);
}

TEST_CASE("a study that fails does not stop the others, is named at the end, and ends in exit code 1",
          "[command][report]") {
    const temporary_folder folder;
    // A directory with the name of a table makes the first study fail.
    std::filesystem::create_directories(folder.path() / "out" / "libration_series" / "libration_series.csv" /
                                        "in the way");
    const finished_process done =
        run_libration({"reproduce", "--only", "libration_series,period_error", "--out", "out"}, folder.path());
    CHECK(done.exit_code == 1);
    const auto lines = lines_of(done.err);
    INFO(done.err);
    CHECK(lines[lines.size() - 2].starts_with("libration: failed: libration_series: "));
    CHECK(std::filesystem::exists(folder.path() / "out" / "period_error" / "period_error.svg"));
    CHECK(std::filesystem::exists(folder.path() / "out" / "index.html"));
}

TEST_CASE("a damaged results folder is said to be one", "[command][report]") {
    const temporary_folder folder;
    const auto own = folder.path() / "out" / "period_error";
    std::filesystem::create_directories(own);
    std::ofstream(own / "period_error.json") << "{\"no\": \"command\"}";
    const finished_process done =
        run_libration({"reproduce", "--only", "libration_series", "--out", "out"}, folder.path());
    CHECK(done.exit_code == 1);
    CHECK(done.err.find("libration: failed: report: out/period_error: ") != std::string::npos);
}

}  // namespace command_report_test
