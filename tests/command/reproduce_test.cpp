// `libration reproduce`: where it writes, the comparison with published results, resuming, and what it replaces.
#include <catch2/catch.hpp>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "command/printed.hpp"

namespace command_reproduce_test {

using namespace libration::tests;

namespace {

namespace fs = std::filesystem;

const words quick{"reproduce", "--only", "period_error"};

// A directory in which period_error was computed and published as results/.
class published_folder {
public:
    published_folder() {
        const finished_process done = run_libration(quick + words{"--publish"}, folder_.path());
        INFO(done.err);
        REQUIRE(done.exit_code == 0);
    }
    const fs::path& path() const { return folder_.path(); }
    fs::path file(const std::string& name) const { return path() / "results" / "period_error" / name; }

private:
    temporary_folder folder_;
};

void write(const fs::path& file, const std::string& content) { std::ofstream(file, std::ios::binary) << content; }

// Changes the last digit of a text before `end`.
std::string with_another_digit(std::string text, std::size_t end) {
    const std::size_t at = text.find_last_of("0123456789", end);
    text[at] = text[at] == '0' ? '1' : '0';
    return text;
}

std::size_t lines_with(const std::string& text, const std::string& part) {
    const auto lines = lines_of(text);
    return static_cast<std::size_t>(std::count_if(
        lines.begin(), lines.end(), [&](const std::string& line) { return line.find(part) != std::string::npos; }));
}

}  // namespace

TEST_CASE("reproduce writes into reproduced/ and leaves what is published alone", "[command][reproduce]") {
    const temporary_folder folder;
    const finished_process done = run_libration(quick, folder.path());
    INFO(done.err);
    CHECK(done.exit_code == 0);
    CHECK(fs::exists(folder.path() / "reproduced" / "period_error" / "period_error.csv"));
    CHECK_FALSE(fs::exists(folder.path() / "results"));
    CHECK_FALSE(fs::exists(folder.path() / "reproduced" / "unfinished.json"));
    // With the results of the source tree.
    CHECK(lines_with(done.err, "/results: the one table of mpfr or of balls is the same") == 1);
}

TEST_CASE("reproduce says that the tables are the same, and ends in 1 where one of mpfr is not",
          "[command][reproduce]") {
    const published_folder results;
    const finished_process same = run_libration(quick, results.path());
    CHECK(same.exit_code == 0);
    CHECK(lines_with(same.err, "compared with results: the one table of mpfr or of balls is the same") == 1);
    CHECK(lines_with(same.err, "differ") == 0);

    const std::string csv = text_of_file(results.file("period_error.csv"));
    write(results.file("period_error.csv"), with_another_digit(csv, csv.size()));
    const finished_process other = run_libration(quick, results.path());
    CHECK(other.exit_code == 1);
    CHECK(lines_with(other.err, "differs: period_error/period_error.csv line ") == 1);
    CHECK(lines_with(other.err, "(1 difference)") == 1);
    // The published file is unchanged.
    CHECK(text_of_file(results.file("period_error.csv")) != csv);

    fs::remove(results.file("period_error.csv"));
    const finished_process missing = run_libration(quick, results.path());
    CHECK(missing.exit_code == 1);
    CHECK(lines_with(missing.err, "period_error/period_error.csv is not published") == 1);
}

TEST_CASE("a figure and a table of double that differ are told, and no failure", "[command][reproduce]") {
    const temporary_folder folder;
    const words order{"reproduce", "--only", "rotation_series"};
    REQUIRE(run_libration(order + words{"--publish"}, folder.path()).exit_code == 0);
    const fs::path own = folder.path() / "results" / "rotation_series";
    const std::string csv = text_of_file(own / "rotation_series_numerical.csv");
    write(own / "rotation_series_numerical.csv", with_another_digit(csv, csv.size()));
    write(own / "rotation_series.svg", text_of_file(own / "rotation_series.svg") + "<!-- older -->");
    const finished_process done = run_libration(order, folder.path());
    INFO(done.err);
    CHECK(done.exit_code == 0);
    CHECK(lines_with(done.err, "all 2 tables of mpfr and of balls are the same") == 1);
    CHECK(lines_with(done.err, "1 of 3 tables of rounded values (double, long double, quad) or of times differ") == 1);
    CHECK(lines_with(done.err, "figures differ: rotation_series/rotation_series.svg") == 1);
}

TEST_CASE("reproduce --publish replaces the parts that were made, and nothing else", "[command][reproduce]") {
    const published_folder results;
    write(results.path() / "results" / "bench.md", "kept\n");
    write(results.file("left_over.csv"), "of an older version\n");
    const std::string csv = text_of_file(results.file("period_error.csv"));
    write(results.file("period_error.csv"), with_another_digit(csv, csv.size()));
    const finished_process done = run_libration(quick + words{"--publish"}, results.path());
    INFO(done.err);
    CHECK(done.exit_code == 0);
    CHECK(lines_with(done.err, "differs: ") == 2);
    CHECK(text_of_file(results.file("period_error.csv")) == csv);
    CHECK_FALSE(fs::exists(results.file("left_over.csv")));
    CHECK(text_of_file(results.path() / "results" / "bench.md") == "kept\n");
    CHECK(fs::exists(results.path() / "results" / "index.html"));
    for (const auto& entry : fs::directory_iterator(results.path() / "results")) {
        CHECK_FALSE(entry.path().filename().string().starts_with("."));
    }
    const finished_process onto_itself = run_libration(quick + words{"--publish", "--out", "results"}, results.path());
    CHECK(onto_itself.exit_code == 2);
}

TEST_CASE("an interrupted reproduce goes on with what is missing", "[command][reproduce]") {
    const temporary_folder folder;
    const words order{"reproduce", "--only", "period_error,libration_series"};
    const fs::path in_the_way = folder.path() / "reproduced" / "libration_series" / "libration_series.csv" / "x";
    fs::create_directories(in_the_way);  // makes one part fail, so that the run is unfinished
    const finished_process first = run_libration(order, folder.path());
    CHECK(first.exit_code == 1);
    const fs::path record = folder.path() / "reproduced" / "unfinished.json";
    const auto made = nlohmann::json::parse(text_of_file(record)).at("made");
    REQUIRE(made.size() == 1);
    CHECK(made.at("period_error").front() == "period_error/period_error.csv");
    fs::remove_all(in_the_way.parent_path());

    const finished_process second = run_libration(order, folder.path());
    INFO(second.err);
    CHECK(second.exit_code == 0);
    CHECK(lines_with(second.err, "resuming an interrupted run: 1 of 2 parts are done") == 1);
    CHECK(lines_with(second.err, "part 1 of 1, libration_series") == 1);
    CHECK_FALSE(fs::exists(record));

    // Parts computed by another program are recomputed.
    write(record, R"({"program": "another", "made": {"period_error": [], "libration_series": []}})");
    CHECK(lines_with(run_libration(order, folder.path()).err, ", period_error") == 1);
}

TEST_CASE("an interrupted reproduce makes a part again that lacks a file", "[command][reproduce]") {
    const temporary_folder folder;
    const words order{"reproduce", "--only", "period_error,libration_series"};
    const fs::path in_the_way = folder.path() / "reproduced" / "libration_series" / "libration_series.csv" / "x";
    fs::create_directories(in_the_way);
    CHECK(run_libration(order, folder.path()).exit_code == 1);
    fs::remove_all(in_the_way.parent_path());
    const fs::path figure = folder.path() / "reproduced" / "period_error" / "period_error.svg";
    REQUIRE(fs::remove(figure));

    const finished_process second = run_libration(order, folder.path());
    INFO(second.err);
    CHECK(second.exit_code == 0);
    CHECK(lines_with(second.err, "resuming an interrupted run") == 0);
    CHECK(lines_with(second.err, "of 2, period_error") == 1);
    CHECK(fs::exists(figure));
}

TEST_CASE("the comparison names a part that was not made", "[command][reproduce]") {
    const published_folder results;
    fs::create_directories(results.path() / "reproduced");
    // Files where directories are required: neither part can be computed.
    fs::remove_all(results.path() / "reproduced" / "period_error");
    write(results.path() / "reproduced" / "period_error", "in the way\n");
    write(results.path() / "reproduced" / "reference", "in the way\n");
    const finished_process done =
        run_libration({"reproduce", "--only", "period_error,reference,libration_series"}, results.path());
    INFO(done.err);
    CHECK(done.exit_code == 1);
    CHECK(lines_with(done.err, "failed: period_error: ") == 1);
    CHECK(lines_with(done.err, "failed: reference: ") == 1);
    CHECK(lines_with(done.err, "failed: comparison") == 0);
    CHECK(lines_with(done.err, "not compared, because not made: period_error, reference") +
              lines_with(done.err, "not compared, because not made: reference, period_error") ==
          1);
    CHECK(lines_with(done.err, "results does not have yet: libration_series") == 1);
}

TEST_CASE("the set problems holds studies of any equation, which stand on the page", "[command][reproduce][problem]") {
    const temporary_folder folder;
    const finished_process done =
        run_libration({"reproduce", "problems", "--only", "error_norm-blasius", "--jobs", "2"}, folder.path());
    INFO(done.err);
    CHECK(done.exit_code == 0);
    CHECK(fs::exists(folder.path() / "reproduced" / "error_norm-blasius" / "error_norm-blasius.svg"));
    const std::string page = text_of_file(folder.path() / "reproduced" / "index.html");
    CHECK(page.find("id=\"error_norm-blasius\"") != std::string::npos);
    CHECK(page.find("./run study error_norm --problem blasius --times 0:3:61") != std::string::npos);
}

TEST_CASE("the sets of reproduce: the paper's is fixed, and one that there is not is refused", "[command][reproduce]") {
    const temporary_folder empty;
    const finished_process refused = run_libration({"reproduce", "nonsense"}, empty.path());
    CHECK(refused.exit_code == 2);
    CHECK(refused.err.starts_with("libration: set 'nonsense'"));
    CHECK(empty.content().empty());
    const temporary_folder folder;
    const finished_process proved = run_libration(
        {"reproduce", "proved", "--skip",
         "complex_plane,error_norm,published,reference_problems,scenarios,sir_radius,solvers,stiff,stiff_solvers",
         "--jobs", "2"},
        folder.path());
    INFO(proved.err);
    CHECK(proved.exit_code == 0);
    CHECK(lines_with(proved.err, "part 1 of 1, reference") == 1);
}

TEST_CASE("drawing says nothing of broken pipes where its caller ignores them", "[command][reproduce]") {
    const temporary_folder folder;
    const auto before = std::signal(SIGPIPE, SIG_IGN);
    const finished_process done = run_libration({"reproduce", "--only", "period_effect"}, folder.path());
    std::signal(SIGPIPE, before);
    CHECK(done.exit_code == 0);
    CHECK(lines_with(done.err, "write error") == 0);
}

}  // namespace command_reproduce_test
