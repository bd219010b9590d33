// Numbers given as formulas, in every command: values of mpmath at 160 digits (theta by Landen's fundamental arc from K
// + t, K by the arithmetic-geometric mean), and the exit codes of invalid ones.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "command/printed.hpp"

namespace command_expressions_test {

using namespace libration;
using namespace libration::tests;

namespace {

finished_process run(const words& line) {
    const temporary_folder folder;
    return run_libration(line, folder.path());
}

void check_exit(const words& line, int code, const words& mentioned) {
    const finished_process done = run(line);
    INFO(command_line(line) << "\n" << done.err);
    CHECK(done.exit_code == code);
    CHECK(done.out.empty());
    CHECK(std::count(done.err.begin(), done.err.end(), '\n') == 1);
    for (const std::string& mention : mentioned) {
        INFO(mention);
        CHECK(done.err.find(mention) != std::string::npos);
    }
}

}  // namespace

TEST_CASE("a start next to the top keeps all its digits", "[command][expressions]") {
    const std::string theta = "1.8625852524063007511665525872726192601433616399859611032753082";
    const std::string omega = "-1.1935945763604075150118768727294082940781793452499898941016939";
    for (const words& how : {words{"--digits", "60"}, words{"--scalar", "ball:60"}}) {
        const auto rows = rows_of(words{"trajectory", "--theta0", "pi-1e-10", "--omega0", "0", "--times", "24"} + how);
        CHECK_THAT(rows.at(0).at("theta"), right_to_the_last_digit(theta));
        CHECK_THAT(rows.at(0).at("omega"), right_to_the_last_digit(omega));
    }
    const auto typed = rows_of({"reference", "--theta0", "pi-1e-5", "--omega0", "1e-5", "--time", "60"});
    CHECK(typed.at(0).at("regime") == "rotation");
    CHECK_THAT(typed.at(0).at("gap").substr(0, 22), right_to_the_last_digit("-4.16666666665277777778"));
    CHECK_THAT(typed.at(0).at("theta"),
               right_to_the_last_digit("9.424777954044410428519665167503591954506126181612304"));
}

TEST_CASE("energies, gaps and moduli are formulas", "[command][expressions]") {
    const auto root = rows_of({"period", "--energy", "sqrt(2)", "--digits", "30"});
    CHECK(root.at(0).at("energy") == "1.41421356237309504880168872421");
    CHECK_THAT(root.at(0).at("gap"), right_to_the_last_digit("0.585786437626904951198311275790301921430328"));
    CHECK_THAT(root.at(0).at("period"), right_to_the_last_digit("8.343894792779746367563546578233124387715"));
    CHECK(rows_of({"period", "--gap", "2-sqrt(2)", "--digits", "30"}).at(0).at("period") == root.at(0).at("period"));
    const auto folded = rows_of({"period", "--energy", "2-1e-10", "--digits", "40"});
    CHECK(folded.at(0).at("energy") == "1.9999999999");
    auto plain = rows_of({"period", "--energy", "1.9999999999", "--digits", "40"});
    CHECK(folded.at(0).at("energy_typed") == "2-1e-10");
    plain.at(0).at("energy_typed") = "2-1e-10";
    CHECK(folded == plain);
    CHECK_THAT(folded.at(0).at("period"), right_to_the_last_digit("52.9831736660926564453676411649430586989771"));
    const auto proved = rows_of({"reference", "--energy", "sqrt(2)", "--time", "1", "--digits", "30", "--check"});
    CHECK_THAT(proved.at(0).at("theta"), right_to_the_last_digit("1.53022958279182238608449461321290303966875"));
    const auto elliptic = [](const words& line) { return rows_of(words{"elliptic"} + line).at(0).at("value"); };
    CHECK_THAT(elliptic({"K", "--m", "1-1e-30", "--digits", "40"}),
               right_to_the_last_digit("35.9250707560305758791043360631905475178565"));
    CHECK_THAT(elliptic({"K", "--m", "sqrt(1/2)", "--digits", "40"}),
               right_to_the_last_digit("2.0859736981949365918908866445582810969287"));
    CHECK_THAT(elliptic({"sn", "--u", "pi-3", "--m", "sqrt(1/2)", "--digits", "38"}),
               right_to_the_last_digit("0.140790357415502107321368302317427029788107"));
}

TEST_CASE("the energies of a sweep are formulas", "[command][expressions]") {
    const temporary_folder folder;
    const auto done = run_libration({"study", "error_norm", "--energies", "sqrt(2),2-1e-3", "--gaps", "2-sqrt(3)",
                                     "--orders", "5", "--scalar", "ball:20", "--out", folder.path().string()},
                                    folder.path());
    REQUIRE(done.exit_code == 0);
    const auto rows = read_table((folder.path() / "error_norm" / "error_norm.csv").string());
    REQUIRE(rows.size() == 6);
    CHECK(rows.at(0).at("energy_typed") == "sqrt(2)");
    // T* = K(1/sqrt 2) and K(sqrt 3/2), where the error of the series is largest.
    CHECK_THAT(rows.at(0).at("time_of_maximum"),
               right_to_the_last_digit("2.08597369819493659189088664455828109692870187"));
    CHECK(rows.at(2).at("gap_typed") == "2-sqrt(3)");
    CHECK_THAT(rows.at(2).at("time_of_maximum"),
               right_to_the_last_digit("2.44134162189969172102105919094250513001668463"));
    check_exit({"study", "error_norm", "--energies", "sqrt(4)", "--out", folder.path().string()}, 2,
               {"sqrt(4)", "infinite"});
    check_exit({"study", "error_norm", "--energies", "90deg", "--out", folder.path().string()}, 2,
               {"--energies", "90deg"});
    check_exit({"study", "audit_gsl", "--energies", "sqrt(2)", "--out", folder.path().string()}, 2,
               {"--energies", "fraction"});
}

TEST_CASE("times are multiples of T and a number", "[command][expressions]") {
    const std::string theta = "-0.00184932389267006090338250544779013909225625";
    for (const words& how : {words{"--digits", "30"}, words{"--scalar", "ball:30"}, words{"--scalar", "double"}}) {
        const auto rows = rows_of(words{"trajectory", "--energy", "1.71", "--times", "T/4+1e-3,0:T+1/2:3"} + how);
        REQUIRE(rows.size() == 4);
        const mpfr error = abs(mpfr(number_of(rows[0].at("theta")) - number_of(theta)));
        CHECK(error < (how.back() == "double" ? mpfr("1e-15") : mpfr("1e-31")));
    }
    const auto reference =
        rows_of({"reference", "--energy", "1.71", "--time", "T/4+1e-3", "--digits", "40", "--check"});
    CHECK_THAT(reference.at(0).at("theta"), right_to_the_last_digit(theta));
}

TEST_CASE("a bad formula is exit 2, an undecidable one exit 1", "[command][expressions]") {
    const words period{"period", "--energy"};
    check_exit(period + words{"2*(1+foo)"}, 2,
               {"--energy '2*(1+foo)'", "unknown name \"foo\" at column 6", ": write "});
    check_exit(period + words{"sqrt(2"}, 2, {"--energy", "does not end: a ) is missing"});
    check_exit(period + words{"sqrt(-1)"}, 2, {"--energy", "root of a negative number"});
    check_exit(period + words{"1/(1-1)"}, 2, {"--energy", "divides by zero"});
    check_exit(period + words{"1/2pi"}, 2, {"--energy", "ambiguous"});
    check_exit(period + words{"1-sqrt(2)"}, 2, {"--energy '1-sqrt(2)' is a negative energy"});
    check_exit(period + words{"2*\x1b[31m"}, 2, {R"(2*\x1b[31m)"});
    check_exit(period + words{"exp(log(2)/2)^2"}, 1, {"exp(log(2)/2)^2", "no precision"});
    check_exit({"trajectory", "--theta0", "1", "--omega0", "sin(1)^2+cos(1)^2-1", "--times", "1"}, 1,
               {"--omega0", "no precision"});
    check_exit({"trajectory", "--theta0", "acos(2)", "--omega0", "0", "--times", "1"}, 2, {"--theta0", "beyond 1"});
    check_exit({"trajectory", "--energy", "1", "--times", "1,T*T"}, 2, {"--times", "'T*T'"});
    check_exit({"elliptic", "K", "--m", "sqrt(2)"}, 2, {"--m 'sqrt(2)' is above 1", ": write "});
}

TEST_CASE("what formulas fold to decides exactly", "[command][expressions]") {
    CHECK(rows_of({"reference", "--energy", "2+sin(pi)", "--time", "1"}).at(0).at("regime") == "separatrix");
    CHECK(rows_of({"reference", "--energy", "1-cos(1)", "--theta0", "1", "--time", "0"}).at(0).at("omega") == "0");
}

}  // namespace command_expressions_test
