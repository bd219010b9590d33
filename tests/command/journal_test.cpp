// `libration journal`, and studies that are killed, resumed, split in shards and merged.
#include "sweep/journal.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "command/child_process.hpp"
#include "command/printed.hpp"
#include "text/table.hpp"

namespace command_journal_test {

using namespace libration;
using namespace libration::tests;
using Catch::Contains;

namespace {

const words small{"study", "error_norm", "--energies", "0.5,1.71,2.5", "--orders", "5,10", "--scalar", "mpfr:20"};

std::string csv_in(const temporary_folder& folder, const std::string& out, const std::string& study = "error_norm") {
    return text_of_file(folder.path() / out / study / (study + ".csv"));
}

std::filesystem::path journal_in(const temporary_folder& folder, const std::string& out) {
    return folder.path() / out / "error_norm" / "error_norm.journal";
}

// Starts `libration WORDS` in a folder, with its messages in the file err there.
pid_t start(words given, const temporary_folder& folder) {
    std::string program = LIBRATION_COMMAND;
    std::vector<char*> arguments{program.data()};
    for (std::string& word : given) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    const std::string err = (folder.path() / "err").string();
    const pid_t child = ::fork();
    if (child == 0) {
        const int file = ::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        if (::dup2(file, STDERR_FILENO) >= 0 && ::chdir(folder.path().c_str()) == 0) {
            ::alarm(time_limit_seconds);
            ::execv(arguments.front(), arguments.data());
        }
        ::_exit(127);
    }
    return child;
}

int end_of(pid_t child) {
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

// A run creates the file first and its tables then, and may be queried, or killed, in between.
long cells_in(const std::filesystem::path& path) {
    if (!std::filesystem::exists(path)) {
        return 0;
    }
    try {
        return journal(path, journal::access::read).counts().done;
    } catch (const journal_error& error) {
        REQUIRE(error.kind() == journal_error::fault::unbegun);
        return 0;
    }
}

}  // namespace

TEST_CASE("a study goes on where it ended: only new cells are computed", "[command][journal]") {
    const temporary_folder folder;
    REQUIRE(run_libration(small + words{"--out", "a"}, folder.path()).exit_code == 0);
    const finished_process again = run_libration(small + words{"--out", "a"}, folder.path());
    CHECK(lines_of(again.err) ==
          words{"libration: 6 of 6 cells are in a/error_norm/error_norm.journal", "libration: wrote a/error_norm"});
    words more = small;
    more[5] = "5,10,15";
    const finished_process grown = run_libration(more + words{"--out", "a"}, folder.path());
    CHECK(lines_of(grown.err).front() == "libration: 6 of 9 cells are in a/error_norm/error_norm.journal");
    REQUIRE(run_libration(more + words{"--out", "b"}, folder.path()).exit_code == 0);
    CHECK(csv_in(folder, "a") == csv_in(folder, "b"));
    // The tables contain the cells of the last command, the journal all of them.
    REQUIRE(run_libration(small + words{"--out", "a"}, folder.path()).exit_code == 0);
    CHECK(csv_rows(csv_in(folder, "a")).size() == 12);
    CHECK(cells_in(journal_in(folder, "a")) == 9);
    CHECK(csv_in(folder, "a") == output_of(small));
}

TEST_CASE("a study that is killed at any moment ends in the same bytes when it is run again", "[command][journal]") {
    const words order{"study", "error_norm", "--energies", "0.1:1.9:19", "--orders", "5:40:8", "--scalar", "mpfr:30"};
    const temporary_folder folder;
    REQUIRE(run_libration(order + words{"--out", "whole"}, folder.path()).exit_code == 0);
    std::mt19937 random(16);  // the moments differ from run to run anyway
    std::uniform_int_distribution<int> milliseconds(5, 250);
    long before = 0;
    for (int i = 0; i < 10; ++i) {
        const pid_t child = start(order + words{"--out", "killed"}, folder);
        std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds(random)));
        ::kill(child, SIGKILL);
        const int code = end_of(child);
        CHECK((code == 128 + SIGKILL || code == 0));
        const long now = cells_in(journal_in(folder, "killed"));
        CHECK(now >= before);
        before = now;
    }
    REQUIRE(run_libration(order + words{"--out", "killed"}, folder.path()).exit_code == 0);
    CHECK(csv_in(folder, "killed") == csv_in(folder, "whole"));
    for (const auto& name : folder.content()) {
        CHECK_THAT(name, !Contains(".drawing."));
    }
}

TEST_CASE("Ctrl-C ends a study within a second and says what is kept and what goes on", "[command][journal]") {
    const words order{"study", "error_norm", "--energies", "0.01:1.99:2000", "--orders", "80", "--scalar", "mpfr:50"};
    const temporary_folder folder;
    const pid_t child = start(order + words{"--out", "out"}, folder);
    const auto path = journal_in(folder, "out");
    for (int i = 0; i < 300 && cells_in(path) == 0; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    const auto asked = std::chrono::steady_clock::now();
    ::kill(child, SIGINT);
    CHECK(end_of(child) == 128 + SIGINT);
    CHECK(std::chrono::steady_clock::now() - asked < std::chrono::seconds(5));  // a second on an idle machine
    const std::string said = text_of_file(folder.path() / "err");
    const long kept = cells_in(path);
    CHECK(kept > 0);
    CHECK_THAT(said, Contains("interrupted: " + std::to_string(kept) +
                              " cells saved in out/error_norm/error_norm.journal; to resume, "
                              "run: " +
                              command_line(order) + " --out out"));
}

TEST_CASE("shards that are merged make the tables of the whole run", "[command][journal]") {
    const words order{"study", "radius_map", "--energies", "0.5,1.71", "--points", "0,1/4,1/2,1", "--orders", "12,20"};
    const temporary_folder folder;
    REQUIRE(run_libration(order + words{"--out", "whole"}, folder.path()).exit_code == 0);
    for (const std::string which : {"1", "2", "3"}) {
        const auto done = run_libration(order + words{"--shard", which + "/3", "--out", "s" + which}, folder.path());
        REQUIRE(done.exit_code == 0);
        CHECK_THAT(done.err, Contains("journal merge"));
        CHECK_FALSE(std::filesystem::exists(folder.path() / ("s" + which) / "radius_map" / "radius_map.csv"));
    }
    const auto lacking = run_libration({"journal", "merge", "s1", "s3", "--out", "two"}, folder.path());
    CHECK(lacking.exit_code == 1);
    CHECK_THAT(lacking.err, Contains("of 16 cells of radius_map are missing from the journals") &&
                                Contains(command_line(order) + " --out two"));
    // A shard of a different split overlaps with these.
    REQUIRE(run_libration(order + words{"--shard", "1/2", "--out", "half"}, folder.path()).exit_code == 0);
    const auto merged = run_libration({"journal", "merge", "s1", "half", "s2", "s3", "--out", "merged"}, folder.path());
    INFO(merged.err);
    REQUIRE(merged.exit_code == 0);
    for (const std::string file : {"radius_map.csv", "radius_map_optimum.csv", "radius_map.tex", "radius_map.svg"}) {
        CHECK(text_of_file(folder.path() / "merged" / "radius_map" / file) ==
              text_of_file(folder.path() / "whole" / "radius_map" / file));
    }
}

TEST_CASE("a cell that fails is named, and the others are kept", "[command][journal]") {
    const temporary_folder folder;
    const words order{"study", "error_norm", "--energies", "1e-400,1", "--orders", "5", "--scalar", "double"};
    for (const int attempts : {1, 2}) {
        const auto done = run_libration(order + words{"--out", "out"}, folder.path());
        CHECK(done.exit_code == 1);
        CHECK_THAT(done.err, Contains("a cell failed: energy=") && Contains("order=5"));
        CHECK((done.err.find("2 attempts") != std::string::npos) == (attempts == 2));
    }
    CHECK(csv_rows(csv_in(folder, "out")).size() == 2);
    const auto json = nlohmann::json::parse(text_of_file(folder.path() / "out" / "error_norm" / "error_norm.json"));
    REQUIRE(json.at("failed").size() == 1);
    CHECK(json.at("failed").at(0).at("attempts") == 2);
    const auto listed = run_libration({"journal", "out"}, folder.path());
    CHECK(listed.exit_code == 0);
    CHECK_THAT(listed.err, Contains("a cell failed"));
    const auto none = run_libration(
        {"study", "error_norm", "--energies", "1e-400", "--orders", "5", "--scalar", "double", "--out", "none"},
        folder.path());
    CHECK(none.exit_code == 2);
    CHECK_FALSE(std::filesystem::exists(folder.path() / "none"));
}

TEST_CASE("cells of another version are refused, or computed anew as asked", "[command][journal]") {
    const temporary_folder folder;
    REQUIRE(run_libration(small + words{"--out", "a"}, folder.path()).exit_code == 0);
    const std::string csv = csv_in(folder, "a");
    journal(journal_in(folder, "a"), journal::access::write).set_stamp({"error_norm", "0", "0.1 (of old)"});
    const auto refused = run_libration(small + words{"--out", "a"}, folder.path());
    CHECK(refused.exit_code == 2);
    CHECK_THAT(refused.err, Contains("0.1 (of old)") && Contains("--fresh"));
    CHECK(run_libration({"journal", "a", "--check", "100%"}, folder.path()).exit_code == 2);
    const auto fresh = run_libration(small + words{"--out", "a", "--fresh"}, folder.path());
    CHECK(fresh.exit_code == 0);
    CHECK(lines_of(fresh.err) == words{"libration: wrote a/error_norm"});
    CHECK(csv_in(folder, "a") == csv);
}

TEST_CASE("a journal in use, and a damaged one, are told", "[command][journal]") {
    const temporary_folder folder;
    REQUIRE(run_libration(small + words{"--out", "a"}, folder.path()).exit_code == 0);
    const std::string csv = csv_in(folder, "a");
    {
        const journal held(journal_in(folder, "a"), journal::access::write);
        const auto second = run_libration(small + words{"--out", "a"}, folder.path());
        CHECK(second.exit_code == 2);
        CHECK_THAT(second.err, Contains("is in use by another run"));
        CHECK(run_libration({"journal", "a"}, folder.path()).exit_code == 0);
        CHECK(run_libration({"journal", "a", "--drop"}, folder.path()).exit_code == 2);
    }
    const std::string whole = text_of_file(journal_in(folder, "a"));
    std::ofstream(journal_in(folder, "a"), std::ios::binary) << whole.substr(0, whole.size() / 3);
    const auto damaged = run_libration(small + words{"--out", "a"}, folder.path());
    CHECK(damaged.exit_code == 2);
    CHECK_THAT(damaged.err, Contains("is damaged") && Contains("--fresh"));
    CHECK(run_libration({"journal", "a"}, folder.path()).exit_code == 2);
    CHECK(csv_in(folder, "a") == csv);
    CHECK(run_libration(small + words{"--out", "a", "--fresh"}, folder.path()).exit_code == 0);
    CHECK(csv_in(folder, "a") == csv);
}

TEST_CASE("a disk that is full ends a study with one line, and what was finished is kept", "[command][journal]") {
    const temporary_folder folder;
    const words order{"study", "error_norm", "--energies", "0.1:1.9:60", "--orders", "5:40:8", "--scalar", "mpfr:20"};
    const pid_t child = ::fork();
    if (child == 0) {
        const rlimit small_files{150'000, 150'000};
        ::setrlimit(RLIMIT_FSIZE, &small_files);
        ::_exit(end_of(start(order + words{"--out", "out"}, folder)));
    }
    CHECK(end_of(child) == 1);
    const std::string said = text_of_file(folder.path() / "err");
    INFO(said);
    CHECK(lines_of(said).size() == 1);
    CHECK_THAT(said, Contains("error_norm.journal cannot be written") && Contains("to resume"));
    CHECK_FALSE(std::filesystem::exists(folder.path() / "out" / "error_norm" / "error_norm.csv"));
    REQUIRE(run_libration(order + words{"--out", "out"}, folder.path()).exit_code == 0);
    CHECK(csv_in(folder, "out") == output_of(order));
}

TEST_CASE("journals are listed, checked, exported and dropped", "[command][journal]") {
    const temporary_folder folder;
    REQUIRE(run_libration(small + words{"--out", "a"}, folder.path()).exit_code == 0);
    const table listed = from_csv(run_libration({"journal", "a", "--format", "csv"}, folder.path()).out);
    REQUIRE(listed.rows().size() == 1);
    const auto& row = listed.rows().front();
    CHECK(listed.columns()[0].name == "study");
    CHECK(row[0].text() == "error_norm");
    CHECK(listed.columns()[1].name == "cells");
    CHECK(row[1].text() == "6");
    CHECK(listed.columns()[2].name == "failed");
    CHECK(row[2].text() == "0");
    CHECK(listed.columns().back().name == "commands");
    CHECK(row.back().text() == command_line(small));
    CHECK(run_libration({"journal", "a/error_norm", "--format", "csv"}, folder.path()).exit_code == 0);

    const auto good = run_libration({"journal", "a", "--check", "100%"}, folder.path());
    CHECK(good.exit_code == 0);
    CHECK(good.out == "a/error_norm/error_norm.journal: 6 cells recomputed, all equal\n");

    REQUIRE(run_libration({"journal", "a", "--export", "cells.jsonl"}, folder.path()).exit_code == 0);
    const auto lines = lines_of(text_of_file(folder.path() / "cells.jsonl"));
    REQUIRE(lines.size() == 6);
    const auto first = nlohmann::json::parse(lines.front());
    CHECK(first.at("study") == "error_norm");
    CHECK(first.at("tables").at(0).size() == 2);

    // A wrong digit in the journal is detected.
    {
        journal cells(journal_in(folder, "a"), journal::access::write);
        std::vector<journal_record> wrong;
        cells.for_each([&](const journal_record& each) { wrong.push_back(each); });
        wrong.resize(1);
        const auto digit = wrong.front().content.find("1.");
        wrong.front().content[digit] = '2';
        cells.add(wrong);
    }
    const auto bad = run_libration({"journal", "a", "--check", "100%"}, folder.path());
    CHECK(bad.exit_code == 1);
    CHECK_THAT(bad.out, Contains("1 differ"));

    CHECK(run_libration({"journal", "a", "--drop"}, folder.path()).exit_code == 0);
    CHECK_FALSE(std::filesystem::exists(journal_in(folder, "a")));
    CHECK(run_libration({"journal", "a"}, folder.path()).exit_code == 2);
}

TEST_CASE("bad options of journals and shards are refused", "[command][journal]") {
    const std::vector<words> wrong{{"journal", "nowhere"},
                                   {"journal", "nowhere", "--check", "0%"},
                                   {"journal", "nowhere", "--check", "many"},
                                   {"journal", "nowhere", "--check", "1%", "--drop"},
                                   {"journal", "merge", "nowhere"},
                                   {"journal", "merge", "nowhere", "--out", "out"},
                                   small + words{"--out", "/proc/out"},
                                   small + words{"--shard", "1/3"},
                                   small + words{"--shard", "0/3", "--out", "out"},
                                   small + words{"--shard", "4/3", "--out", "out"},
                                   small + words{"--shard", "one", "--out", "out"},
                                   small + words{"--fresh"}};
    for (const words& each : wrong) {
        const temporary_folder folder;
        const auto done = run_libration(each, folder.path());
        INFO(command_line(each) << "\n" << done.err);
        CHECK(done.exit_code == 2);
        CHECK(lines_of(done.err).size() == 1);
        CHECK(folder.content().empty());
    }
}

}  // namespace command_journal_test
