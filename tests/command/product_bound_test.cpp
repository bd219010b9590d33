// Problems whose series FLINT up to 3.6.0 multiplies incorrectly (scalar/ball/product_guard.hpp), compared with
// closed forms in fractions: y' = c/(1-t) c/(t-1), y(0) = 0 has the solution y = -c^2 t/(1-t), whose coefficients are
// all -c^2.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "command/printed.hpp"

namespace command_product_bound_test {

using namespace libration;
using namespace libration::tests;

namespace {

std::string problem_of(const std::string& c) { return "y' = (c/(1-t))*(c/(t-1)); y(0)=0; c = " + c; }

rational value_of(const std::string& text) { return read_exact(text).coefficient; }

rational power(const rational& base, long n) {
    rational result = 1;
    for (long i = 0; i < n; ++i) {
        result *= base;
    }
    return result;
}

}  // namespace

TEST_CASE("proved values of the product of two quotients are right", "[command][product_bound]") {
    for (const long bits : {349L, 509L}) {
        const rational c = 1 - power(rational(1, 2), bits);
        for (const long digits : {100L, 197L, 198L, 230L}) {
            INFO("c = 1 - 2^-" << bits << ", " << digits << " digits");
            const auto rows = rows_of({"reference", "--problem", problem_of("1 - 2^(-" + std::to_string(bits) + ")"),
                                       "--time", "1/16", "--digits", std::to_string(digits)});
            REQUIRE(rows.size() == 1);
            CHECK(rows[0].at("rigour") == "proved");
            CHECK(abs(value_of(rows[0].at("y")) + c * c / 15) < power(rational(1, 10), digits + 1));
        }
    }
}

TEST_CASE("proved coefficients of the product of two quotients are right", "[command][product_bound]") {
    struct request {
        const char* c;
        const char* order;
        long digits;
    };
    for (const request& each : {request{"0.99999999999999999999", "255", 152}, request{"1 - 10^(-30)", "255", 60},
                                request{"1 - 10^(-30)", "127", 100}, request{"1 - 2^(-349)", "255", 200},
                                request{"1 - 2^(-96)", "511", 70}, request{"1 - 2^(-285)", "127", 172}}) {
        INFO("c = " << each.c << ", order " << each.order << ", " << each.digits << " digits");
        const std::string digits = std::to_string(each.digits);
        const auto rows = rows_of({"coefficients", "--problem", problem_of(each.c), "--order", each.order, "--scalar",
                                   "ball:" + digits, "--digits", digits});
        REQUIRE(rows.size() == std::stoul(each.order) + 1);
        const rational c = value_of(each.c);
        for (std::size_t n = 1; n < rows.size(); ++n) {
            INFO("coefficient " << n << ": " << rows[n].at("y"));
            CHECK(abs(value_of(rows[n].at("y")) + c * c) < power(rational(1, 10), each.digits - 1));
        }
    }
}

// If the archives of both are linked into the program, the dynamic linker uses them for FLINT and Arb as well, though
// it also loads the shared ones: there is one MPFR with one range of exponents and one set of constants.
TEST_CASE("FLINT calls the MPFR that the program calls", "[command][product_bound]") {
    const temporary_folder folder;
    const std::string command = "LD_DEBUG=bindings LD_BIND_NOW=1 LD_DEBUG_OUTPUT='" +
                                (folder.path() / "bindings").string() +
                                "' '" LIBRATION_COMMAND "' --version > /dev/null";
    REQUIRE(std::system(command.c_str()) == 0);  // NOLINT(concurrency-mt-unsafe)
    std::map<std::string, std::set<std::string>> owners;
    const std::regex binding("binding file ([^ ]*) .* to ([^ ]*) .*symbol `mpfr_");
    for (const auto& file : std::filesystem::directory_iterator(folder.path())) {
        for (const std::string& line : lines_of(text_of_file(file.path()))) {
            std::smatch found;
            if (line.find("symbol `mpfr_") != std::string::npos && std::regex_search(line, found, binding) &&
                found[1] != found[2]) {
                owners[std::filesystem::path(found[1].str()).filename().string()].insert(found[2]);
            }
        }
    }
    std::set<std::string> all;  // empty if the dynamic linker does not report
    for (const auto& [user, from] : owners) {
        INFO(user);
        CHECK(from.size() == 1);
        all.insert(from.begin(), from.end());
    }
    CHECK(all.size() <= 1);
}

}  // namespace command_product_bound_test
