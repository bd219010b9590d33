// The shared library shows what its header declares, and nothing else; the Fortran module has the same names.

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

namespace c_symbols_test {

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

// All first groups of a pattern.
std::set<std::string> found(const std::string& text, const char* pattern) {
    const std::regex names(pattern);
    std::set<std::string> all;
    for (auto at = std::sregex_iterator(text.begin(), text.end(), names); at != std::sregex_iterator(); ++at) {
        all.insert((*at)[1]);
    }
    return all;
}

TEST_CASE("the shared library shows the names of its header alone", "[c][house]") {
    const auto module = std::filesystem::path(LIBRATION_SYMBOLS).parent_path() / "libration.f90";
    const auto declared =
        found(text_of(LIBRATION_SOURCE_DIR "/include/libration.h"), R"((?:[ *])(libration_\w+)\([^)]*\);)");
    REQUIRE(declared.size() > 40);
    CHECK(found(text_of(module), R"((?:function|subroutine) (libration_\w+)\()") == declared);
    const auto symbols = found(text_of(LIBRATION_SYMBOLS), R"( [B-Zuvw] (\w+))");
    CHECK(symbols == declared);
}

}  // namespace c_symbols_test
