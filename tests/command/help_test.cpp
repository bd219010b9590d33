// --help of the program, of every subcommand and of every study: the width of its lines, and its examples.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "command/printed.hpp"
#include "command/refusal.hpp"
#include "sweep/study.hpp"

namespace command_help_test {

using namespace libration::tests;

namespace {

// The names of the list "Subcommands:" of `libration --help`.
words subcommands() {
    words names;
    bool listed = false;
    for (const std::string& line : lines_of(output_of({"--help"}))) {
        listed = line == "Subcommands:" || (listed && !line.empty());
        if (listed && line.starts_with("  ") && line[2] != ' ') {
            names.push_back(line.substr(2, line.find(' ', 2) - 2));
        }
    }
    return names;
}

// The command lines under "Examples:".
words examples_in(const std::string& help) {
    words examples;
    const words lines = lines_of(help);
    for (auto line = std::find(lines.begin(), lines.end(), "Examples:"); line != lines.end(); ++line) {
        if (line->starts_with("    libration ")) {
            examples.push_back(line->substr(4));
        }
    }
    return examples;
}

// The words of a text, with one blank between them.
std::string one_line(const std::string& text) {
    std::istringstream items(text);
    std::string line;
    for (std::string item; items >> item;) {
        line += (line.empty() ? "" : " ") + item;
    }
    return line;
}

void require_narrow(const std::string& help) {
    for (const std::string& line : lines_of(help)) {
        INFO(line);
        CHECK(line.size() <= 100);
    }
}

}  // namespace

TEST_CASE("every --help ends with two examples, which run, in lines of at most 100 columns", "[command][help]") {
    const auto names = subcommands();
    CHECK(names.size() >= 19);
    const std::string program = std::filesystem::path(LIBRATION_COMMAND).parent_path().string();
    for (const std::string& name : names + words{""}) {
        INFO(name);
        const std::string help = output_of(name.empty() ? words{"--help"} : words{name, "--help"});
        require_narrow(help);
        const words examples = examples_in(help);
        REQUIRE(examples.size() == 2);
        CHECK(help.ends_with(examples.back() + "\n"));
        const temporary_folder folder;
        std::filesystem::copy_file(std::string(LIBRATION_SOURCE_DIR) + "/docs/examples/model.xml",
                                   folder.path() / "model.xml");
        for (const std::string& example : examples) {
            INFO(example);
            const std::string line = "cd '" + folder.path().string() + "' && PATH='" + program + "':$PATH; " + example +
                                     " > printed 2> said";
            CHECK(std::system(line.c_str()) == 0);
        }
    }
}

TEST_CASE("the help of a study has its options only, with their defaults", "[command][help]") {
    for (const libration::study* each : libration::all_studies()) {
        INFO(each->name);
        const std::string help = output_of({"study", each->name, "--help"});
        require_narrow(help);
        CHECK(help.starts_with(each->name + ": "));
        CHECK(examples_in(help).size() == 2);
        CHECK(help.find("\n\n\n") == std::string::npos);
        for (const libration::study_parameter& parameter : each->parameters) {
            CHECK(help.find("  " + parameter.option + " ") != std::string::npos);
        }
        CHECK((help.find("  --problem P") != std::string::npos) == each->any_equation.has_value());
    }
    const std::string sir = output_of({"study", "sir_radius", "--help"});
    CHECK(sir.find("r S(0)/a (default: 1/2,1,3/2,2,3,4,6,8)") != std::string::npos);
    CHECK(sir.find("--energies") == std::string::npos);
}

TEST_CASE("the help of a study says which forms an option accepts and what is required", "[command][help]") {
    // As one line: where it is wrapped depends on the defaults.
    const auto help_of = [](const std::string& name) { return one_line(output_of({"study", name, "--help"})); };
    const std::string norm = help_of("error_norm");
    CHECK(norm.find("energies E, in m g l (default: 1e-3,1e-2,0.02:1.98:99,2.02:2.98:49,3:8:51): LIST, a:b:count "
                    "or a:b:COUNTlog") != std::string::npos);
    CHECK(norm.find("with --problem (required): LIST") != std::string::npos);
    CHECK(norm.find("ball:DIGITS (proved)") != std::string::npos);
    const std::string root = help_of("root_test");
    CHECK(root.find("--scalar S arithmetic of the lists under test (default: mpfr:30): double, long-double, quad or "
                    "mpfr:DIGITS --problem P any equation") != std::string::npos);
    const std::string coefficients = help_of("coefficients");
    CHECK(coefficients.find("--problem P the equation (required): ") != std::string::npos);
    CHECK(coefficients.find("with --problem") == std::string::npos);
    CHECK(help_of("solvers").find("LIST of odeint, gsl, sundials, scipy and mpmath, or all") != std::string::npos);
    CHECK(help_of("divergence")
              .find("multiples of T allowed; times at which the sums are taken, with --problem "
                    "(required): LIST, a:b:count or a:b:COUNTlog") != std::string::npos);
}

TEST_CASE("the help of an unknown study is refused with a similar name", "[command][help]") {
    check_refused({"study", "eror_norm", "--help"}, {"study 'eror_norm' is not a study", "error_norm"});
}

}  // namespace command_help_test
