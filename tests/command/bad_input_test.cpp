// Options shared by all subcommands are rejected as described in refusal.hpp.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "command/refusal.hpp"
#include "option/exclusions.hpp"

namespace command_bad_input_test {

using namespace libration::tests;

namespace {

// `before OPTION VALUE` is rejected with OPTION and VALUE in the message.
void check_value(const words& before, const std::string& option, const std::string& value) {
    check_refused(before + words{option, value}, {option, "'" + value + "'"});
}

const words series_study{"study", "error_norm", "--orders", "5", "--scalar", "double"};

}  // namespace

TEST_CASE("the tables of combinations that are refused name options that exist", "[command][bad input]") {
    const std::string help = run_libration({"--help-all"}).out;
    for (const std::string& option : libration::options_in_tables()) {
        INFO(option);
        CHECK(help.find("  " + option) != std::string::npos);
    }
}

TEST_CASE("an energy that is no number of 0 or more is refused", "[command][bad input]") {
    for (const std::string value : {"abc",
                                    "-1",
                                    "-1e-300",
                                    "1/0",
                                    "1e999999999999",
                                    "-1e999999999999",
                                    "nan",
                                    "inf",
                                    "",
                                    " 1",
                                    "1 ",
                                    "1,5",
                                    "0x10",
                                    "1e",
                                    "--",
                                    "pi",
                                    "90deg",
                                    "T",
                                    "1.7.1",
                                    "1/2pi"}) {
        check_value({"period"}, "--energy", value);
    }
    for (const std::string value : {"abc", "3", "2.0000000000000000000000000001", "1/0", "pi"}) {
        check_value({"period"}, "--gap", value);
    }
}

TEST_CASE("a state that is no angle and no speed is refused", "[command][bad input]") {
    for (const std::string value : {"nan", "inf", "x", "T/4", "pi/0", "90 deg"}) {
        check_refused({"period", "--theta0", value, "--omega0", "0"}, {"--theta0", "'" + value + "'"});
    }
    for (const std::string value : {"nan", "inf", "x", "pi", "pi/2", "10deg", "T"}) {
        check_value({"period", "--theta0", "1"}, "--omega0", value);
    }
}

TEST_CASE("too few digits, too many and more than the scalar has are refused", "[command][bad input]") {
    for (const std::string value : {"0", "-5", "1000000", "99999999999999999999", "abc", "5.5", ""}) {
        check_value({"period", "--energy", "1"}, "--digits", value);
    }
    check_value({"period", "--energy", "1", "--scalar", "double"}, "--digits", "30");
    check_value({"period", "--energy", "1", "--scalar", "mpfr:20"}, "--digits", "21");
}

TEST_CASE("a scalar that this program does not have is refused", "[command][bad input]") {
    for (const std::string value : {"mpfr:0", "mpfr:-1", "mpfr:", "mpfr", "mpfr:1000000", "mpfr:x", "float", "Double",
                                    "ball", "ball:", "ball:0", ""}) {
        check_value({"period", "--energy", "1"}, "--scalar", value);
        check_value({"study", "error_norm", "--energies", "1"}, "--scalar", value);
    }
}

TEST_CASE("proved arithmetic is refused where there are no proofs", "[command][bad input]") {
    check_value({"trajectory", "--energy", "1", "--times", "0", "--method", "rk4"}, "--scalar", "ball:50");
    check_value({"radius", "--energy", "1", "--order", "20"}, "--scalar", "ball:50");
    check_value({"study", "surface", "--energies", "1"}, "--scalar", "ball:50");
}

TEST_CASE("an order that is no whole number of 0 or more is refused", "[command][bad input]") {
    for (const std::string value : {"-3", "1000001", "99999999999999999999", "abc", "2.5", "+3", ""}) {
        check_value({"coefficients", "--energy", "1"}, "--order", value);
        check_value({"trajectory", "--energy", "1", "--times", "0", "--method", "series"}, "--order", value);
        check_value({"period", "--energy", "1", "--method", "series"}, "--order", value);
    }
}

TEST_CASE("a first power that is none, or beyond the last, is refused", "[command][bad input]") {
    for (const std::string value : {"-1", "4", "x", "1.5", "", "99999999999999999999"}) {
        check_value({"coefficients", "--energy", "1", "--order", "3"}, "--from", value);
    }
    check_value({"coefficients", "--energy", "1", "--from", "5"}, "--order", "1000007");
    check_value({"coefficients", "--energy", "1", "--from", "5"}, "--order", "1000000000000001");
}

TEST_CASE("times that are no list and no range are refused", "[command][bad input]") {
    for (const std::string value :
         {"0,,2", "0:1:0", "", ",", "0,", "0:1", "0:1:2:3", "0:1:-2", "0:1:x", "0:1:99999999999", "abc", "0,nan", "1/0",
          "90deg", "0:90deg:3", "1:T:3", "0:1:5log", "T:2T:3log"}) {
        check_value({"trajectory", "--energy", "1"}, "--times", value);
    }
}

TEST_CASE("no motion, half a motion and two motions at once are refused", "[command][bad input]") {
    for (const words& command :
         {words{"period"}, words{"coefficients", "--order", "3"}, words{"trajectory", "--times", "0"}}) {
        check_refused(command, {"--energy", "--gap", "--theta0", "--omega0"});
        check_refused(command + words{"--theta0", "1"}, {"--theta0 '1'", "--omega0"});
        check_refused(command + words{"--omega0", "2"}, {"--omega0 '2'", "--theta0"});
        check_refused(command + words{"--energy", "1", "--gap", "0.5"}, {"--energy '1'", "--gap '0.5'"});
        check_refused(command + words{"--energy", "1", "--omega0", "0.5"}, {"--energy", "--omega0 '0.5'"});
        check_refused(command + words{"--gap", "1", "--theta0", "1", "--omega0", "0.5"}, {"--gap", "--omega0 '0.5'"});
    }
    check_refused({"period", "--theta0", "1", "--omega0", "1", "--direction", "-"}, {"--direction '-'", "--omega0"});
}

TEST_CASE("an angle that the energy does not reach is refused", "[command][bad input]") {
    check_refused({"period", "--energy", "1", "--theta0", "3"}, {"--theta0 '3'"});
    check_refused({"trajectory", "--energy", "0.5", "--theta0", "60.0000000001deg", "--times", "0"},
                  {"--theta0 '60.0000000001deg'"});
    check_refused({"period", "--gap", "1e-30", "--theta0", "pi"}, {"--theta0 'pi'"});
}

TEST_CASE("a direction, a length and a gravity that are none are refused", "[command][bad input]") {
    for (const std::string value : {"up", "1", "+-", ""}) {
        check_value({"period", "--energy", "3"}, "--direction", value);
    }
    check_refused({"period", "--energy", "3", "--length", "2"}, {"--length '2'", "--gravity"});
    check_refused({"period", "--energy", "3", "--gravity", "9.81"}, {"--gravity '9.81'", "--length"});
    for (const std::string value : {"0", "-1", "abc", "1/0", "pi"}) {
        check_value({"period", "--energy", "3", "--gravity", "1"}, "--length", value);
        check_value({"period", "--energy", "3", "--length", "1"}, "--gravity", value);
    }
}

TEST_CASE("what does not exist at E = 2 is refused there", "[command][bad input]") {
    const words states[] = {{"--energy", "2"},
                            {"--gap", "0"},
                            {"--theta0", "120deg", "--omega0", "1"},
                            {"--theta0", "180deg", "--omega0", "0"}};
    for (const words& state : states) {
        const words trajectory = words{"trajectory"} + state;
        for (const std::string method : {"series", "resummed"}) {
            check_refused(trajectory + words{"--times", "0", "--method", method, "--order", "3"},
                          {"--method '" + method});
            check_refused(words{"period"} + state + words{"--method", method, "--order", "3"}, {"--method '" + method});
        }
        for (const std::string time : {"T", "0,T/4", "0:T:3"}) {
            check_refused(trajectory + words{"--times", time}, {"--times '" + time + "'"});
        }
        check_refused(words{"coefficients"} + state + words{"--order", "3", "--at", "top"}, {"--at 'top'"});
        check_refused(words{"coefficients"} + state + words{"--order", "3", "--at", "T/8"}, {"--at 'T/8'"});
    }
    check_refused(series_study + words{"--energies", "1,2"}, {"error_norm", "energy 2", "--energies"});
    check_refused(series_study + words{"--gaps", "0"}, {"error_norm", "energy 2", "--gaps"});
    check_refused(series_study + words{"--energies", "0"}, {"error_norm", "energy 0", "--energies"});
}

TEST_CASE("methods, points and formats that are none, or not in this version, are refused", "[command][bad input]") {
    for (const std::string value : {"agm", "Exact", "Uniform", ""}) {
        check_value({"trajectory", "--energy", "1", "--times", "0"}, "--method", value);
    }
    check_value({"period", "--energy", "1"}, "--method", "exact");
    for (const std::string value : {"left", "30deg", "", "1,2"}) {
        check_value({"coefficients", "--energy", "1", "--order", "3"}, "--at", value);
    }
    for (const std::string value : {"xml", "CSV", ""}) {
        check_value({"period", "--energy", "1"}, "--format", value);
    }
    check_refused({"trajectory", "--energy", "1", "--times", "0", "--method", "series"},
                  {"--method 'series'", "--order"});
    check_refused({"trajectory", "--energy", "1", "--times", "0", "--method", "uniform"},
                  {"--method 'uniform'", "--order"});
    check_refused({"trajectory", "--energy", "2", "--times", "0", "--method", "uniform", "--order", "3"},
                  {"--method 'uniform'", "E = 2", "exact"});
    check_refused({"trajectory", "--energy", "0", "--times", "0", "--method", "uniform", "--order", "3"},
                  {"--method 'uniform'", "E = 0", "columns", "series"});
    check_refused({"study", "uniform", "--energies", "1", "--orders", "0"}, {"--orders '0'", "coefficients"});
    check_refused({"study", "resummations", "--energies", "1", "--orders", "0"}, {"--orders '0'", "coefficients"});
    check_refused({"trajectory", "--energy", "1", "--times", "0", "--order", "3"}, {"--order '3'", "exact"});
    check_refused({"period", "--energy", "1", "--method", "resummed"}, {"--method 'resummed'", "--order"});
    check_refused({"period", "--energy", "1", "--order", "3"}, {"--order '3'", "agm"});
}

TEST_CASE("a Runge-Kutta step that is not positive, or that takes forever, is refused", "[command][bad input]") {
    const words rk4{"trajectory", "--energy", "1", "--method", "rk4"};
    for (const std::string value : {"0", "-1e-3", "x", "T/100"}) {
        check_value(rk4 + words{"--times", "1"}, "--step", value);
    }
    check_value({"trajectory", "--energy", "1", "--times", "1"}, "--step", "1e-3");
    check_value(rk4, "--times", "1e12");
}

TEST_CASE("words that nothing expects, and words that are missing, are refused", "[command][bad input]") {
    check_refused({"find", "lorenz", "--periodic"}, {"'lorenz'", "write --problem lorenz"});
    check_refused({"reference", "y'=y; y(0)=1", "--time", "1"}, {"write --problem \"y'=y; y(0)=1\""});
    check_refused({"--bogus"}, {"'--bogus'"});
    check_refused({"bogus"}, {"'bogus'"});
    check_refused({}, {"subcommand", "--help"});
    check_refused({"period", "--energy", "1", "--bogus"}, {"'--bogus'"});
    check_refused({"period", "--energy", "1", "--bogus", "7"}, {"'--bogus'"});
    check_refused({"period", "--energy", "1", "extra"}, {"'extra'"});
    check_refused({"period", "--energy"}, {"--energy", "missing"});
    check_refused({"trajectory", "--energy", "1"}, {"--times LIST"});
    check_refused({"coefficients", "--energy", "1"}, {"--order", "required"});
    check_refused({"period", "--energy", "1", "--energy", "2"}, {"--energy"});
    check_refused({"study"}, {"NAME"});
}

TEST_CASE("a study that there is not, and parameters that are none, are refused", "[command][bad input]") {
    check_refused({"study", "nonsense"}, {"'nonsense'", "error_norm"});
    check_refused({"study", "nonsense", "--out", "made"}, {"'nonsense'", "error_norm"});
    check_refused({"figure", "nonsense"}, {"'nonsense'", "error_norm"});
    check_refused({"figure", "error_norm", "--out", "empty"}, {"--out 'empty'", "libration study error_norm"});
    check_refused({"reproduce", "--only", "nonsense", "--out", "made"}, {"--only 'nonsense'", "error_norm"});
    check_refused({"reproduce", "--skip", "nonsense", "--out", "made"}, {"--skip 'nonsense'", "error_norm"});
    for (const std::string value : {"abc", "-1", "0.5,,1", "1:2:0", "pi", "1/0", ""}) {
        check_value({"study", "error_norm", "--out", "made"}, "--energies", value);
    }
    check_value({"study", "error_norm", "--out", "made"}, "--gaps", "3");
    for (const std::string value : {"-3", "5,,10", "5,x", "99999999999", ""}) {
        check_value({"study", "error_norm", "--out", "made"}, "--orders", value);
    }
    for (const std::string value : {"0", "-1", "many", "100000"}) {
        check_value({"study", "error_norm", "--out", "made"}, "--jobs", value);
    }
    check_refused(series_study + words{"--energies", "1,2", "--out", "made/deep"}, {"energy 2"});
}

TEST_CASE("an --out that cannot be written is refused before anything is written", "[command][bad input]") {
    const temporary_folder folder;
    std::ofstream(folder.path() / "file") << "kept";
    std::filesystem::create_directory(folder.path() / "folder");
    for (const words& command :
         {words{"period", "--energy", "1"}, words{"coefficients", "--energy", "1", "--order", "3"},
          words{"trajectory", "--energy", "1", "--times", "0"}}) {
        for (const std::string target : {"file/x", "missing/x", "folder", "folder/", ".", "/proc/x", ""}) {
            check_refused(command + words{"--out", target}, {"--out '" + target + "'"}, folder);
        }
    }
    const words study = series_study + words{"--energies", "1"};
    for (const std::string target : {"file", "file/deep", "/proc/x"}) {
        check_refused(study + words{"--out", target}, {"--out '" + target}, folder);
        check_refused({"reproduce", "--out", target}, {"--out '" + target}, folder);
    }
    CHECK(text_of_file(folder.path() / "file") == "kept");
}

TEST_CASE("an energy or a gap below the range of the scalar is refused with the scalar that holds it",
          "[command][bad input]") {
    check_refused({"period", "--energy", "1e-400", "--scalar", "double"},
                  {"--energy '1e-400'", "range of double", "--scalar mpfr:DIGITS"});
    check_refused({"period", "--gap", "1e-400", "--scalar", "double"},
                  {"--gap '1e-400'", "range of double", "--scalar mpfr:DIGITS"});
}

TEST_CASE("a time or a step that the scalar rounds to 0 or infinity is refused", "[command][bad input]") {
    const words march{"trajectory", "--energy", "1", "--method", "rk4", "--scalar", "double"};
    check_refused(march + words{"--times", "1e400"}, {"--times '1e400'", "range of double"});
    check_refused(march + words{"--times", "1", "--step", "1e400"}, {"--step '1e400'", "range of double"});
    check_refused(march + words{"--times", "1", "--step", "1e-400"}, {"--step '1e-400'", "range of double"});
}

TEST_CASE("a line end in a value does not break the one line of the message", "[command][bad input]") {
    check_refused({"period", "--energy", "1\n2"}, {"--energy '1\\n2'"});
}

TEST_CASE("inputs are quoted without control characters and to 60 characters", "[command][bad input]") {
    check_refused({"period", "--energy", "\x1b[2J\t\x7f\xff\xc2\x9b"}, {"--energy '\\x1b[2J\\t\\x7f\\xff\\xc2\\x9b'"});
    check_refused({"period", "--energy", "1µ"}, {"--energy '1µ'"});
    const std::string cut = "'" + std::string(60, '7') + "...'";
    const std::string seven(100'000, '7');
    check_refused({"period", "--energy", seven + "x"}, {"--energy " + cut});
    check_refused({"period", "--gap", seven}, {"--gap " + cut});
    check_refused({"trajectory", "--energy", "1", "--times", "1," + seven + "x"}, {"the item " + cut});
    check_refused({"period", "--energy", "1", "--format", seven}, {"--format " + cut});
    check_refused({"period", "--energy", "1", "--out", seven}, {"--out " + cut});
    check_refused({"study", seven}, {cut});
    check_refused({seven}, {cut});
    check_refused({"period", "--" + seven, "1"}, {"'--" + std::string(58, '7') + "...'"});
    for (const words& command : {words{"period", "--energy"}, words{"period", "--energy", "1", "--gap"}, words{"cite"},
                                 words{"table"}, words{"elliptic"}, words{"claims"}, words{"studies"}, words{"figure"},
                                 words{"reproduce", "--only"}, words{"verify"}, words{"radius", "--coefficients"}}) {
        const auto done = run_libration(command + words{seven + "x"});
        INFO(command_line(command));
        CHECK(done.exit_code == 2);
        CHECK(done.err.size() < 1000);
    }
    const temporary_folder folder;
    std::ofstream(folder.path() / "list", std::ios::binary) << std::string("1\n1\0\x1b[2J\n", 10);
    check_refused({"radius", "--coefficients", "list"}, {"line 2: '1\\0\\x1b[2J' is not"}, folder);
}

TEST_CASE("advice names options that the subcommand has", "[command][bad input]") {
    for (const std::string function : {"cn", "dn"}) {
        const auto done = run_libration({"elliptic", function, "--u", "1e20", "--m", "1"});
        INFO(done.err);
        CHECK(done.exit_code == 2);
        CHECK(done.err.find("--scalar") == std::string::npos);
        CHECK(done.err.find("u '1e20' makes " + function + " too large or too small to be printed: write") !=
              std::string::npos);
    }
}

TEST_CASE("reproduce refuses its parameters before it says what it runs", "[command][bad input]") {
    const temporary_folder folder;
    check_refused({"reproduce", "--jobs", "0", "--out", (folder.path() / "out").string()}, {"--jobs '0'"}, folder);
}

TEST_CASE("a mistyped name is the one that is named, with the near one", "[command][bad input]") {
    check_refused({"perod", "--energy", "1"}, {"'perod'", "did you mean period?"});
    check_refused({"period", "--enrgy", "1"}, {"'--enrgy'", "did you mean --energy?"});
    check_refused({"period", "--enrgy=1"}, {"'--enrgy=1'", "did you mean --energy?"});
    check_refused({"study", "eror_norm"}, {"'eror_norm'", "did you mean error_norm?"});
    check_refused({"studies", "surfac"}, {"'surfac'", "did you mean surface?"});
    check_refused({"figure", "teams"}, {"'teams'", "did you mean terms?"});
    check_refused({"reproduce", "--only", "uniforn"}, {"'uniforn'", "did you mean uniform?"});
    const finished_process far = run_libration({"xyzzy"});
    CHECK(far.exit_code == 2);
    CHECK(far.err.find("did you mean") == std::string::npos);
}

TEST_CASE("what does not fit onto stdout ends in 1, help and lists too", "[command][bad input]") {
    for (const words& order : {words{"--help"},
                               {"--version"},
                               {"--help-all"},
                               {"period", "--help"},
                               {"studies"},
                               {"studies", "--format", "json"},
                               {"cite"},
                               {"period", "--energy", "1"}}) {
        INFO(command_line(order));
        std::string line = std::string(LIBRATION_COMMAND);
        for (const std::string& word : order) {
            line += " " + word;
        }
        const int status = std::system((line + " >/dev/full 2>/dev/null").c_str());
        REQUIRE(WIFEXITED(status));
        CHECK(WEXITSTATUS(status) == 1);
    }
}

}  // namespace command_bad_input_test
