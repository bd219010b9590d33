// Names of tests that CMake supports: an unclosed bracket silently hides every later test, a semicolon splits a list,
// and a leading hyphen becomes an option of the test program.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

namespace house_test_names_test {

namespace {

std::vector<std::string> names_of_tests() {
    static const std::regex declared(
        R"re((?:TEST_CASE|TEMPLATE_LIST_TEST_CASE|TEMPLATE_TEST_CASE)\(\s*"((?:[^"\\]|\\.)*)")re");
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(LIBRATION_SOURCE_DIR "/tests")) {
        if (entry.path().extension() != ".cpp") {
            continue;
        }
        std::ifstream file(entry.path());
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        for (std::sregex_iterator at(text.begin(), text.end(), declared); at != std::sregex_iterator(); ++at) {
            names.push_back((*at)[1]);
        }
    }
    return names;
}

}  // namespace

TEST_CASE("names of tests hold no bracket and no semicolon, and begin without a hyphen", "[house]") {
    const auto names = names_of_tests();
    CHECK(names.size() > 100);
    for (const std::string& name : names) {
        INFO(name);
        CHECK(name.find_first_of("[];") == std::string::npos);
        CHECK_FALSE(name.starts_with("-"));
    }
}

}  // namespace house_test_names_test
