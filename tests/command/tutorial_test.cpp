// The tutorial of the pendulum: the program prints the output shown after "$ ./run", and its pictures exist.
#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>

#include "command/printed.hpp"

namespace command_tutorial_test {

using namespace libration::tests;

namespace {

const std::filesystem::path page_of_pendulum = LIBRATION_SOURCE_DIR "/docs/tutorials/pendulum.md";

struct shown_command {
    words order;
    std::string output;
};

// The commands of the ```console blocks, each with the lines up to the next one or to the end of the block.
std::vector<shown_command> commands_of(const std::string& page) {
    const std::string prompt = "$ ./run ";
    std::vector<shown_command> commands;
    bool shown = false;
    for (const std::string& line : lines_of(page)) {
        if (line.starts_with("```")) {
            shown = false;
        } else if (line.starts_with(prompt)) {
            std::istringstream in(line.substr(prompt.size()));
            commands.emplace_back();
            for (std::string word; in >> word;) {
                commands.back().order.push_back(word);
            }
            shown = true;
        } else if (shown) {
            commands.back().output += line + "\n";
        }
    }
    return commands;
}

}  // namespace

TEST_CASE("the answers of the tutorial are what its commands print", "[command][tutorial]") {
    const auto commands = commands_of(text_of_file(page_of_pendulum));
    CHECK(commands.size() >= 6);
    for (const shown_command& each : commands) {
        INFO(command_line(each.order));
        CHECK(output_of(each.order) == each.output);
    }
}

TEST_CASE("the pictures of the tutorial are there and whole", "[command][tutorial]") {
    const std::string page = text_of_file(page_of_pendulum);
    const std::regex picture(R"re(!\[[^\]]*\]\(([^)]+)\))re");
    std::size_t count = 0;
    for (std::sregex_iterator at(page.begin(), page.end(), picture); at != std::sregex_iterator(); ++at) {
        const std::string svg = text_of_file(page_of_pendulum.parent_path() / (*at)[1].str());
        CHECK(svg.find("</svg>") != std::string::npos);
        CHECK(svg.find('\xd6') == std::string::npos);  // a root sign of the Symbol font: no UTF-8
        ++count;
    }
    CHECK(count == 2);
}

TEST_CASE("the numbers that the tutorial states by itself are right", "[command][tutorial]") {
    using libration::mpfr;
    const libration::precision_scope scope(30);
    const auto tau = mpfr(libration::pi<mpfr>() * 2);
    CHECK(abs(tau * mpfr("1.01") - mpfr("6.34602")) < mpfr("5e-6"));
    CHECK(abs(tau / sqrt(mpfr("9.81")) - mpfr("2.00607")) < mpfr("5e-6"));
    CHECK(abs(sqrt(mpfr("9.81")) - mpfr("3.13209")) < mpfr("5e-6"));
    CHECK(abs(log(mpfr(100)) * 2 - mpfr("9.21034")) < mpfr("5e-6"));
    const mpfr k = 1 / sqrt(mpfr(2));
    const mpfr half_way = asin(mpfr(k / sqrt(mpfr(1 + k)))) * 2;
    CHECK(abs(half_way - mpfr("1.14371774040")) < mpfr("5e-12"));
    CHECK(abs(half_way * 360 / tau - mpfr("65.5")) < mpfr("0.05"));
}

}  // namespace command_tutorial_test
