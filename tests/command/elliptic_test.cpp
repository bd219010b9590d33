// The proved digits of `libration elliptic` against the reference tables, mpmath, exact values and identities.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "command/printed.hpp"

namespace command_elliptic_test {

using namespace libration;
using namespace libration::tests;

namespace {

std::vector<table_row> elliptic_of(words line) {
    line.insert(line.begin(), "elliptic");
    return rows_of(line);
}

std::string elliptic_value(const words& line) {
    const auto rows = elliptic_of(line);
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].at("rigour") == "proved");
    return rows[0].at("value");
}

// The tables give k'; the command takes m1 = k'^2 as a fraction.
std::string complement_of(const std::string& kc) {
    const rational root = read_exact(kc).coefficient;
    return rational(root * root).str();
}

// The rows of a table with the same k', arguments joined.
struct arguments_at {
    std::string kc;
    std::string list;
    std::vector<table_row> rows;
};
std::vector<arguments_at> grouped(const std::string& table, const std::string& argument) {
    std::vector<arguments_at> groups;
    for (const table_row& row : reference_table(table)) {
        if (groups.empty() || groups.back().kc != row.at("kc")) {
            groups.push_back({row.at("kc"), "", {}});
        }
        arguments_at& group = groups.back();
        group.list += (group.list.empty() ? "" : ",") + row.at(argument);
        group.rows.push_back(row);
    }
    return groups;
}

void check_refused(const words& line, const std::string& mentioned) {
    const temporary_folder folder;
    const finished_process done = run_libration(words{"elliptic"} + line, folder.path());
    INFO(command_line(line) << "\n" << done.err);
    CHECK(done.exit_code == 2);
    CHECK(done.out.empty());
    CHECK(done.err.find(mentioned) != std::string::npos);
}

}  // namespace

TEST_CASE("am, sn, cn and dn have the digits of the reference table", "[command][elliptic]") {
    for (const arguments_at& group : grouped("jacobi.csv", "u")) {
        for (const std::string function : {"am", "sn", "cn", "dn"}) {
            INFO(function << " at k' = " << group.kc);
            const auto rows = elliptic_of({function, "--u=" + group.list, "--m1", complement_of(group.kc)});
            REQUIRE(rows.size() == group.rows.size());
            for (std::size_t i = 0; i < rows.size(); ++i) {
                INFO("u = " << rows[i].at("argument"));
                CHECK_THAT(rows[i].at("value"), right_to_the_last_digit(group.rows[i].at(function)));
            }
        }
    }
}

TEST_CASE("F and K have the digits of the reference table", "[command][elliptic]") {
    for (const arguments_at& group : grouped("incomplete.csv", "phi")) {
        INFO("k' = " << group.kc);
        const auto rows = elliptic_of({"F", "--phi=" + group.list, "--m1", complement_of(group.kc)});
        REQUIRE(rows.size() == group.rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            INFO("phi = " << rows[i].at("argument"));
            CHECK_THAT(rows[i].at("value"), right_to_the_last_digit(group.rows[i].at("F")));
        }
    }
    for (const table_row& row : reference_table("complete.csv")) {
        INFO("k' = " << row.at("kc"));
        CHECK_THAT(elliptic_value({"K", "--m1", complement_of(row.at("kc"))}), right_to_the_last_digit(row.at("K")));
        CHECK_THAT(elliptic_value({"K", "--m", complement_of(row.at("kc"))}),
                   right_to_the_last_digit(row.at("K_complementary")));
    }
}

TEST_CASE("a complementary parameter of 1e-30 keeps its digits", "[command][elliptic]") {
    // mpmath, mp.dps = 120, m = 1 - mpf('1e-30'): sn = ellipfun('sn', u, m=m), am(1.5) = asin(sn(1.5)), ellipk(m),
    // ellipf(1.5, m).
    const words parameter{"--m1", "1e-30"};
    CHECK_THAT(elliptic_value(words{"am", "--u", "1.5"} + parameter),
               right_to_the_last_digit("1.13172834525050909374296939069601703268288911115997434443763"));
    CHECK_THAT(elliptic_value(words{"sn", "--u", "1.5"} + parameter),
               right_to_the_last_digit("0.905148253644866438242303696456654119301455983569368334445685"));
    CHECK_THAT(elliptic_value(words{"cn", "--u", "40"} + parameter),
               right_to_the_last_digit("-2.94146616461169149979968303674214728300497182284077959913104e-14"));
    CHECK_THAT(elliptic_value(words{"dn", "--u", "40"} + parameter),
               right_to_the_last_digit("2.94316550631380813539781473065420437116017569194193996522435e-14"));
    CHECK_THAT(elliptic_value(words{"K"} + parameter),
               right_to_the_last_digit("35.9250707560305758791043360631905475178565302421218812327571"));
    CHECK_THAT(elliptic_value(words{"F", "--phi", "1.5"} + parameter),
               right_to_the_last_digit("3.34067754279831100332081266898868657537007845874054920924997"));
}

TEST_CASE("huge arguments and other forms of the modulus agree with mpmath", "[command][elliptic]") {
    // mpmath, mp.dps = 200: ellipfun('sn', mpf('1e20'), m=mpf('0.64')); ellipf(3*pi/4, mpf('0.64')).
    const std::string sn = "-0.533673950861330381426750756987710942534671167603986448454561";
    for (const words& form : {words{"--k", "0.8"}, words{"--k", "4/5"}, words{"--m", "0.64"}, words{"--m1", "0.36"}}) {
        CHECK_THAT(elliptic_value(words{"sn", "--u", "1e20"} + form), right_to_the_last_digit(sn));
    }
    const std::string f = "3.15098320852537765655773963851607310230942019040726327848957";
    CHECK_THAT(elliptic_value({"F", "--phi", "135deg", "--k", "0.8"}), right_to_the_last_digit(f));
    CHECK_THAT(elliptic_value({"F", "--phi", "3pi/4", "--k", "0.8"}), right_to_the_last_digit(f));
}

TEST_CASE("both ends of the parameter are the circle and the hyperbola", "[command][elliptic]") {
    const precision_scope scope(100);
    const mpfr u("0.7");
    CHECK_THAT(elliptic_value({"sn", "--u", "0.7", "--m", "0"}), right_to_the_last_digit_of(sin(u)));
    CHECK_THAT(elliptic_value({"am", "--u", "0.7", "--m", "0"}), right_to_the_last_digit_of(u));
    CHECK_THAT(elliptic_value({"sn", "--u", "0.7", "--m", "1"}), right_to_the_last_digit_of(tanh(u)));
    CHECK_THAT(elliptic_value({"cn", "--u", "0.7", "--m", "1"}), right_to_the_last_digit_of(1 / cosh(u)));
    CHECK_THAT(elliptic_value({"dn", "--u", "0.7", "--k", "1"}), right_to_the_last_digit_of(1 / cosh(u)));
    CHECK_THAT(elliptic_value({"am", "--u", "0.7", "--m1", "0"}), right_to_the_last_digit_of(atan(sinh(u))));
    CHECK_THAT(elliptic_value({"F", "--phi", "0.7", "--m", "1"}), right_to_the_last_digit_of(asinh(tan(u))));
    CHECK(elliptic_value({"K", "--m", "1"}) == "inf");
    const auto ends = elliptic_of({"F", "--phi=90deg,2,-2,-pi/2", "--m", "1"});
    REQUIRE(ends.size() == 4);
    CHECK((ends[0].at("value") == "inf" && ends[1].at("value") == "inf"));
    CHECK((ends[2].at("value") == "-inf" && ends[3].at("value") == "-inf"));
}

TEST_CASE("exact zeros are printed as 0", "[command][elliptic]") {
    CHECK(elliptic_value({"cn", "--u", "pi/2", "--m", "0"}) == "0");
    CHECK(elliptic_value({"sn", "--u", "1000000pi", "--m", "0"}) == "0");
    CHECK(number_of(elliptic_value({"sn", "--u=-7pi/2", "--m", "0"})) == 1);
    for (const std::string parameter : {"0", "0.5", "1"}) {
        CHECK(elliptic_value({"am", "--u", "0", "--m", parameter}) == "0");
        CHECK(elliptic_value({"sn", "--u", "0", "--m", parameter}) == "0");
        CHECK(elliptic_value({"F", "--phi", "0", "--m", parameter}) == "0");
    }
}

TEST_CASE("F of quarter turns is a multiple of K", "[command][elliptic]") {
    const precision_scope scope(100);
    const mpfr k = number_of(elliptic_value({"K", "--m", "1/3", "--digits", "80"}));
    CHECK_THAT(elliptic_value({"F", "--phi", "90deg", "--m", "1/3"}), right_to_the_last_digit_of(k));
    CHECK_THAT(elliptic_value({"F", "--phi=-3pi/2", "--m", "1/3"}), right_to_the_last_digit_of(-k * 3));
}

TEST_CASE("what is no elliptic function, modulus or argument is refused", "[command][elliptic]") {
    check_refused({"sc", "--u", "1", "--m", "0.5"}, "'sc'");
    check_refused({"sn", "--u", "1"}, "--m1");
    check_refused({"sn", "--m", "0.5"}, "--u");
    check_refused({"sn", "--phi", "1", "--m", "0.5"}, "--phi '1'");
    check_refused({"F", "--u", "1", "--m", "0.5"}, "--u '1'");
    check_refused({"K", "--u", "1", "--m", "0.5"}, "--u '1'");
    check_refused({"sn", "--u", "T/4", "--m", "0.5"}, "T/4");
    check_refused({"sn", "--u", "1", "--m", "0.5", "--k", "0.5"}, "one of");
    for (const std::string option : {"--k", "--m", "--m1"}) {
        for (const std::string value : {"-0.1", "1.0000000000000000000001", "pi/4", "x"}) {
            check_refused({"sn", "--u", "1", option, value}, option + " '" + value + "'");
        }
    }
}

}  // namespace command_elliptic_test
