// `libration study`, `studies` and `figure`: the files of a study, which depend only on its parameters.
#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command/printed.hpp"
#include "command/refusal.hpp"

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
                      "out/error_norm/error_norm.journal",
                      "out/error_norm/error_norm.json",
                      "out/error_norm/error_norm.pdf",
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
    for (const std::string library : {"libration", "commit", "Boost", "MPFR", "GMP", "vectors"}) {
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
    // The baseline has different columns, so it is mentioned and not printed.
    CHECK(lines_of(done.err) == words{"libration: error_norm makes more tables (baseline): see them with --out DIR"});
    words scalars;
    for (const table_row& row : csv_rows(done.out)) {
        CHECK(row.at("energy") == "1");
        scalars.push_back(row.at("scalar"));
    }
    CHECK(scalars == words{"ball:50", "ball:50", "double", "double", "long-double", "long-double", "quad", "quad"});
}

TEST_CASE("one study is listed at length, and all of them as JSON", "[command][study]") {
    const std::string one = output_of({"studies", "error_norm"});
    for (const std::string part : {"error_norm  [paper fig:error]\n", "libration study error_norm --out out\n",
                                   "the period is infinite", "--energies 1.71,2.02"}) {
        INFO(part);
        CHECK(one.find(part) != std::string::npos);
    }
    CHECK(one.find("period_error") == std::string::npos);
    const auto json = nlohmann::json::parse(output_of({"studies", "--format", "json"}));
    std::string names;
    for (const auto& each : json) {
        CHECK(names.find("\n" + each.at("name").get<std::string>() + "\n") == std::string::npos);  // once
        names += each.at("name").get<std::string>() + "\n";
        CHECK(each.at("seconds").get<double>() > 0);
        CHECK((each.at("figure").is_null() || each.at("figure").get<std::string>().starts_with("fig:")));
        for (const auto& parameter : each.at("parameters")) {
            CHECK(parameter.at("option").get<std::string>().starts_with("--"));
            CHECK(parameter.at("usual") != "");
        }
    }
    CHECK(names.find("error_norm\n") != std::string::npos);
    CHECK(one.find("  with --problem P\n") != std::string::npos);
    const auto coefficients = nlohmann::json::parse(output_of({"studies", "coefficients", "--format", "json"})).at(0);
    CHECK(coefficients.at("parameters").empty());
    CHECK(coefficients.at("with problem").at("example").get<std::string>().find(" --problem ") != std::string::npos);
    CHECK(nlohmann::json::parse(output_of({"studies", "cost", "--format", "json"})).size() == 1);
    CHECK(run_libration({"studies", "--format", "csv"}).exit_code == 2);
}

TEST_CASE("studies are listed with question, parameters and cost", "[command][study]") {
    const std::string list = output_of({"studies"});
    for (const std::string part :
         {"error_norm  [paper fig:error]\n", "?\n", "--energies ", "--gaps ", "--orders ", "--scalar ", "cost "}) {
        INFO(part);
        CHECK(list.find(part) != std::string::npos);
    }
}

namespace {

namespace fs = std::filesystem;

const words small{"study", "error_norm", "--energies", "1.71", "--orders", "2,4,8", "--out", "out"};

// The content of out/error_norm, relative to that directory.
words files_of(const temporary_folder& folder) {
    words names;
    for (const auto& entry : fs::directory_iterator(folder.path() / "out" / "error_norm")) {
        names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

const words files_of_one_table{"error_norm.csv", "error_norm.journal", "error_norm.json", "error_norm.pdf",
                               "error_norm.png", "error_norm.svg",     "error_norm.tex"};

// A replacement of gnuplot, found before the real one: /bin/sh runs these commands after it or instead of it.
class gnuplot_in_place {
public:
    gnuplot_in_place(const fs::path& folder, const std::string& script) : before_(::getenv("PATH")) {
        fs::create_directory(folder / "bin");
        std::ofstream(folder / "bin" / "gnuplot") << "#!/bin/sh\n" << script << "\n";
        fs::permissions(folder / "bin" / "gnuplot", fs::perms::owner_all);
        ::setenv("PATH", ((folder / "bin").string() + ":" + before_).c_str(), 1);
    }
    gnuplot_in_place(const gnuplot_in_place&) = delete;
    gnuplot_in_place& operator=(const gnuplot_in_place&) = delete;
    ~gnuplot_in_place() { ::setenv("PATH", before_.c_str(), 1); }

private:
    std::string before_;
};

}  // namespace

TEST_CASE("a run leaves exactly its files, also where an earlier one left others", "[command][study]") {
    const temporary_folder folder;
    const auto run = [&](const words& more) { return run_libration(small + more, folder.path()).exit_code; };
    REQUIRE(run({"--step", "1e-3"}) == 0);  // tables of four arithmetics and the Runge-Kutta solution
    CHECK(fs::exists(folder.path() / "out/error_norm/error_norm_quad.csv"));
    std::ofstream(folder.path() / "out/error_norm/notes.txt") << "the user's own";
    REQUIRE(run({"--scalar", "double"}) == 0);
    words expected = files_of_one_table;
    expected.push_back("notes.txt");
    CHECK(files_of(folder) == expected);
}

TEST_CASE("the option --columns chooses the columns of LaTeX tables and of stdout", "[command][study]") {
    const temporary_folder folder;
    const words chosen{"--scalar", "double", "--columns", "order,method,norm"};
    REQUIRE(run_libration(small + chosen, folder.path()).exit_code == 0);
    const auto own = folder.path() / "out" / "error_norm";
    CHECK(text_of_file(own / "error_norm.tex").find("\n$N$ & method & \\multicolumn{2}{c}{$\\max|") !=
          std::string::npos);
    CHECK(lines_of(text_of_file(own / "error_norm.csv")).front().starts_with("energy,order,method,norm,"));
    const words energy{"--energy", "1", "--format", "csv", "--columns", "period,energy"};
    CHECK(lines_of(output_of(words{"period"} + energy)).front() == "period,energy");
    const finished_process refused = run_libration(small + words{"--scalar", "double", "--columns", "nrom"});
    CHECK(refused.exit_code == 2);
    CHECK(refused.err.starts_with(
        "libration: --columns 'nrom' is not a column of this table: choose from energy, order"));
}

TEST_CASE("the JSON of a study names every file with the SHA-256 that sha256sum prints", "[command][study]") {
    const temporary_folder folder;
    REQUIRE(run_libration(small + words{"--scalar", "double"}, folder.path()).exit_code == 0);
    const auto own = folder.path() / "out" / "error_norm";
    const auto json = nlohmann::json::parse(text_of_file(own / "error_norm.json"));
    words named{"error_norm.journal", "error_norm.json"};
    std::ofstream sums(own / "sums");
    for (const auto& [name, sum] : json.at("files").items()) {
        named.push_back(name);
        sums << sum.get<std::string>() << "  " << name << "\n";
    }
    sums.close();
    CHECK(std::system(("cd '" + own.string() + "' && sha256sum --quiet -c sums").c_str()) == 0);
    fs::remove(own / "sums");
    std::sort(named.begin(), named.end());
    CHECK(files_of(folder) == named);
}

TEST_CASE("figure draws the tables of its run and no others", "[command][study]") {
    const temporary_folder folder;
    REQUIRE(run_libration(small + words{"--scalar", "double"}, folder.path()).exit_code == 0);
    const auto own = folder.path() / "out" / "error_norm";
    const std::string svg = text_of_file(own / "error_norm.svg");
    const auto figure = [&] { return run_libration({"figure", "error_norm", "--out", "out"}, folder.path()); };
    // A table that the JSON does not list is ignored.
    fs::copy(own / "error_norm.csv", own / "error_norm_quad.csv");
    CHECK(figure().exit_code == 0);
    CHECK(text_of_file(own / "error_norm.svg") == svg);
    fs::remove(own / "error_norm_quad.csv");
    // A table that it lists, but with other content, is rejected.
    std::ofstream(own / "error_norm.csv", std::ios::app) << "1.71,9,series,1,1,double,heuristic,0.29,1,0,0,0\n";
    const finished_process done = figure();
    CHECK(done.exit_code == 2);
    CHECK(
        done.err.starts_with("libration: --out 'out/error_norm/error_norm.csv' is not the table that error_norm.json "
                             "describes: run 'libration study error_norm --energies 1.71 "));
    CHECK(text_of_file(own / "error_norm.svg") == svg);
    CHECK(files_of(folder) == files_of_one_table);
    fs::remove(own / "error_norm.csv");
    CHECK(figure().err.find("is missing, which error_norm.json describes") != std::string::npos);
}

TEST_CASE("a drawing that is cut short is told, and no figure of another run stays beside the tables",
          "[command][study]") {
    const temporary_folder folder;
    REQUIRE(run_libration(small + words{"--scalar", "double"}, folder.path()).exit_code == 0);
    // As on a full disk: the real gnuplot, after which one of its drawings is truncated.
    const gnuplot_in_place full(folder.path(),
                                "PATH=${PATH#*:} gnuplot \"$@\" || exit; for f in out/error_norm/.drawing.*/*.svg; do "
                                "head -c 1000 \"$f\" >cut && mv cut \"$f\"; done");
    const finished_process done = run_libration(small + words{"--scalar", "quad"}, folder.path());
    CHECK(done.exit_code == 1);
    CHECK(done.err.find("error_norm.svg was cut short while it was drawn: is the disk full?") != std::string::npos);
    CHECK(done.err.find("wrote") == std::string::npos);
    CHECK(files_of(folder) == words{"error_norm.csv", "error_norm.journal", "error_norm.json", "error_norm.tex"});
}

TEST_CASE("a study that is ended while it draws leaves no folder of its own, and the earlier run as it was",
          "[command][study]") {
    const temporary_folder folder;
    REQUIRE(run_libration(small + words{"--scalar", "double"}, folder.path()).exit_code == 0);
    const std::string csv = text_of_file(folder.path() / "out/error_norm/error_norm.csv");
    const gnuplot_in_place slow(folder.path(), "kill -$(cat signal) $PPID; exec sleep 1");
    for (const int signal : {SIGHUP, SIGINT, SIGTERM, SIGKILL}) {
        INFO(signal);
        std::ofstream(folder.path() / "signal") << signal;
        const finished_process done = run_libration(small + words{"--scalar", "quad"}, folder.path());
        CHECK(done.exit_code == 128 + signal);
        CHECK((files_of(folder) == files_of_one_table) == (signal != SIGKILL));
    }
    // The next run removes the remains of the last one.
    std::ofstream(folder.path() / "signal") << SIGTERM;
    run_libration(small + words{"--scalar", "quad"}, folder.path());
    CHECK(files_of(folder) == files_of_one_table);
    CHECK(text_of_file(folder.path() / "out/error_norm/error_norm.csv") == csv);
}

TEST_CASE("several arithmetics are in one run of a study", "[command][study]") {
    const temporary_folder folder;
    const auto done = run_libration({"study", "error_norm", "--energies", "1.71", "--orders", "4", "--step", "1e-2",
                                     "--scalar", "double,mpfr:20", "--out", "out"},
                                    folder.path());
    INFO(done.err);
    REQUIRE(done.exit_code == 0);
    const auto first = csv_rows(text_of_file((folder.path() / "out/error_norm/error_norm.csv")));
    const auto second = csv_rows(text_of_file((folder.path() / "out/error_norm/error_norm_double.csv")));
    REQUIRE(first.size() == second.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        CHECK(first[i].at("scalar") == "mpfr:20");
        CHECK(second[i].at("scalar") == "double");
        // Norms near 1e-2 in double, whose operations number some hundreds.
        CHECK(abs(number_of(first[i].at("norm")) - number_of(second[i].at("norm"))) < number_of("1e-12"));
    }
    check_refused({"study", "domb_sykes", "--scalar", "double,mpfr:20"},
                  {"--scalar 'double,mpfr:20' is a list, and this study takes one arithmetic at a time"});
}

}  // namespace command_study_test
