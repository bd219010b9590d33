#include "libration/number/grid.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/scalar/decimal.hpp"
#include "libration/scalar/error.hpp"

namespace sweep_grid_test {

using namespace libration;

namespace {

using words = std::vector<std::string>;

words texts_of(const std::string& grid) {
    words texts;
    for (const exact& value : read_grid(grid)) {
        texts.push_back(value.text);
    }
    return texts;
}

std::vector<rational> values_of(const std::string& grid) {
    std::vector<rational> values;
    for (const exact& value : read_grid(grid)) {
        values.push_back(value.coefficient);
    }
    return values;
}

// What a function says that refuses; "accepted" when it does not.
template <class Read>
std::string complaint(const Read& read) {
    try {
        read();
    } catch (const libration::error& problem) {
        return problem.reason();
    }
    return "accepted";
}

std::string complaint_about(const std::string& grid) {
    return complaint([&] { return read_grid(grid); });
}

}  // namespace

TEST_CASE("a list keeps its items as typed and in order", "[sweep][grid]") {
    CHECK(texts_of("0, 1/2 , 2 : 3 : 2") == words{"0", "1/2", "2", "3"});
    CHECK(texts_of(" 300") == words{"300"});
    CHECK(texts_of("1.71") == words{"1.71"});
    CHECK(texts_of("2.50,-1e6,+0.5,1/3,T/4,3pi/4,150deg,0") ==
          words{"2.50", "-1e6", "+0.5", "1/3", "T/4", "3pi/4", "150deg", "0"});
    const auto values = read_grid("1/3,-3T/4,pi,90deg");
    REQUIRE(values.size() == 4);
    CHECK(values[0].coefficient == rational(1, 3));
    CHECK(values[1].coefficient == rational(-3, 4));
    CHECK(values[1].measure == unit::period);
    CHECK(values[2].measure == unit::pi);
    CHECK(values[3].measure == unit::degree);
}

TEST_CASE("an even range is exact, both ends included", "[sweep][grid]") {
    CHECK(values_of("0:1:4") == std::vector<rational>{0, rational(1, 3), rational(2, 3), 1});
    CHECK(texts_of("0:1:4") == words{"0", "1/3", "2/3", "1"});
    CHECK(texts_of("-1:1:5") == words{"-1", "-0.5", "0", "0.5", "1"});
    CHECK(texts_of("3:1:3") == words{"3", "2", "1"});
    CHECK(texts_of("5:7:1") == words{"5"});
    CHECK(texts_of("2:2:3") == words{"2", "2", "2"});
    CHECK(texts_of("1/3:2/3:3") == words{"1/3", "0.5", "2/3"});
    CHECK(values_of("1e-300:3e-300:3") == std::vector<rational>{read_exact("1e-300").coefficient,
                                                                read_exact("2e-300").coefficient,
                                                                read_exact("3e-300").coefficient});
    const auto fine = values_of("0:20:401");
    REQUIRE(fine.size() == 401);
    for (int i = 0; i <= 400; ++i) {
        CHECK(fine[static_cast<std::size_t>(i)] == rational(i, 20));
    }
}

TEST_CASE("a range of multiples keeps its unit, which 0 does not need", "[sweep][grid]") {
    CHECK(texts_of("-3T/4:3T/4:3") == words{"-0.75T", "0", "0.75T"});
    CHECK(texts_of("0:T:5") == words{"0", "0.25T", "0.5T", "0.75T", "1T"});
    CHECK(texts_of("T:0:2") == words{"1T", "0"});
    CHECK(texts_of("0:2pi:4") == words{"0", "2pi/3", "4pi/3", "2pi"});
    CHECK(texts_of("-90deg:90deg:3") == words{"-90deg", "0", "90deg"});
    for (const exact& value : read_grid("-T:T:7")) {
        CHECK(value.measure == (value.is_zero() ? unit::one : unit::period));
    }
}

TEST_CASE("every text of a grid reads back as the same exact number", "[sweep][grid]") {
    for (const std::string grid : {"0:1:8", "-T:T:7", "-2pi/3:pi/7:5", "-90deg:45deg:8", "1e-2:1e-10:17log",
                                   "-3:-7e5:6log", "0.1,1/3,2T/3", "1e-30:1e30:4"}) {
        for (const exact& value : read_grid(grid)) {
            INFO(grid << ": " << value.text);
            const exact again = read_exact(value.text);
            CHECK(again.coefficient == value.coefficient);
            CHECK(again.measure == value.measure);
        }
    }
}

TEST_CASE("ranges and numbers mix in one list", "[sweep][grid]") {
    CHECK(texts_of("1e-3,0.5:1.5:3,2.02,1:100:3log") == words{"1e-3", "0.5", "1", "1.5", "2.02", "1", "10", "100"});
}

TEST_CASE("a logarithmic range meets its powers of ten and its ends exactly", "[sweep][grid]") {
    const auto values = values_of("1e-1:1e-12:12log");
    REQUIRE(values.size() == 12);
    rational power(1, 10);
    for (const rational& value : values) {
        CHECK(value == power);
        power /= 10;
    }
    CHECK(texts_of("1:1000:4log") == words{"1", "10", "100", "1000"});
    CHECK(values_of("1e-5000:1e5000:3log")[1] == 1);

    const auto negative = values_of("-1e-2:-1e-10:17log");
    REQUIRE(negative.size() == 17);
    rational next(-1, 100);
    for (std::size_t i = 0; i < negative.size(); i += 2) {
        CHECK(negative[i] == next);
        next /= 10;
    }
    const auto ends = read_grid("1/3:22/7:5log");
    CHECK(ends.front().text == "1/3");
    CHECK(ends.front().coefficient == rational(1, 3));
    CHECK(ends.back().text == "22/7");
    CHECK(ends.back().coefficient == rational(22, 7));
    CHECK(texts_of("7:8:1log") == words{"7"});
}

TEST_CASE("between its ends a logarithmic range is even in the logarithm to six digits", "[sweep][grid]") {
    CHECK(texts_of("1:10:3log") == words{"1", "3.16228", "10"});  // sqrt 10 = 3.162277660...
    CHECK(texts_of("-10:-1:3log") == words{"-10", "-3.16228", "-1"});
    CHECK(texts_of("1:2:4log") ==
          words{"1", "1.25992", "1.5874", "2"});                   // cube roots of 2 and 4: 1.259921.., 1.587401..
    CHECK(values_of("1:10:3log")[1] == rational(316228, 100000));  // exact from then on
}

TEST_CASE("a grid that is none is refused with the reason", "[sweep][grid]") {
    struct refusal {
        std::string grid;
        std::string reason;
    };
    for (const refusal& r : std::vector<refusal>{
             {"", "is empty"},
             {"0,,2", "has an empty item"},
             {",1", "has an empty item"},
             {"1,", "has an empty item"},
             {"abc", "is not a number"},
             {"1,abc,2", "has the item 'abc', which is not a number"},
             {"1,1/0", "has the item '1/0', which divides by zero"},
             {"nan", "is not a number"},
             {"0:1", "is not a range FIRST:LAST:COUNT"},
             {"0:1:2:3", "is not a range FIRST:LAST:COUNT"},
             {"0:1:0", "has the count '0'"},
             {"0:1:-3", "has the count '-3'"},
             {"0:1:2.5", "has the count '2.5'"},
             {"0:1:x", "has the count 'x'"},
             {"0:1:", "has the count ''"},
             {"0:1:log", "has the count 'log'"},
             {"0:1:3lin", "has the count '3lin'"},
             {"0:1:10000001", "has the count '10000001'"},
             {"0:1:99999999999999999999", "has the count '99999999999999999999'"},
             {"5,0:1:0", "has the item '0:1:0', which has the count '0'"},
             {":1:3", "is empty"},
             {"0:x:3", "is not a number"},
             {"1:T:3", "mixes units"},
             {"pi:180deg:3", "mixes units"},
             {"-1:1:5log", "one sign"},
             {"0:1:5log", "one sign"},
             {"T:2T:5log", "one sign"},
         }) {
        INFO("'" << r.grid << "' " << complaint_about(r.grid));
        CHECK(complaint_about(r.grid).find(r.reason) != std::string::npos);
    }
    CHECK(complaint_about("0:1:0").find("between 1 and 10000000") != std::string::npos);
}

TEST_CASE("a count is a whole number from 0 to the largest allowed", "[sweep][grid]") {
    CHECK(read_count("0", 10) == 0);
    CHECK(read_count("7", 10) == 7);
    CHECK(read_count("10", 10) == 10);
    CHECK(read_count("0010", 10) == 10);
    CHECK(read_count("1e1", 10) == 10);
    CHECK(read_count("0e99", 10) == 0);
    const auto about = [](const std::string& text) { return complaint([&] { return read_count(text, 10); }); };
    for (const std::string text : {"", "abc", "2.5", "1e-1", "1e", "+3", " 3", "3 ", "3,4", "-"}) {
        INFO("'" << text << "'");
        CHECK(about(text) == "is not a whole number");
    }
    for (const std::string text : {"11", "-1", "-99999999999999999999", "99999999999999999999", "4294967297", "2e1",
                                   "1e30", "1e99999999999999999999"}) {
        INFO("'" << text << "'");
        CHECK(about(text) == "is not between 0 and 10");
    }
}

}  // namespace sweep_grid_test
