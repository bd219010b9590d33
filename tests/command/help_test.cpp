// --help of the program, of every subcommand and of every study: the width of its lines, and its examples.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "command/printed.hpp"
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
        for (const libration::study_parameter& parameter : each->parameters) {
            CHECK(help.find("  " + parameter.option + " ") != std::string::npos);
        }
        CHECK((help.find("  --problem P") != std::string::npos) == each->any_equation.has_value());
    }
    const std::string sir = output_of({"study", "sir_radius", "--help"});
    CHECK(sir.find("r S(0)/a (default: 1/2,1,3/2,2,3,4,6,8)") != std::string::npos);
    CHECK(sir.find("--energies") == std::string::npos);
}

}  // namespace command_help_test
