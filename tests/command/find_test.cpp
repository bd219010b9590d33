// libration find: conditions at several times, several first guesses, and what is not accepted.
#include <catch2/catch.hpp>

#include "command/printed.hpp"
#include "command/refusal.hpp"

namespace command_find_test {

using namespace libration::tests;

namespace {

const words bratu{"find",        "--problem", "y'' = -e^y; y(0) = 0; y'(0) = 1/2",
                  "--unknown",   "y'(0)",     "--such-that",
                  "y(0) = y(1)", "--digits",  "20"};

// The rows of a command that also prints a line on stderr.
std::vector<table_row> rows_with_a_remark(words line) {
    line.insert(line.end(), {"--format", "csv"});
    const auto done = run_libration(line);
    REQUIRE(done.exit_code == 0);
    return csv_rows(done.out);
}

}  // namespace

TEST_CASE("several first guesses lead to several solutions", "[command][find]") {
    const auto both = rows_with_a_remark(bratu + words{"--guess", "y'(0)=0.5,1,10"});
    REQUIRE(both.size() == 2);
    CHECK(both[0].at("solution") == "1");
    CHECK(both[0].at("value") == "0.54935272877527081902");
    CHECK(both[1].at("solution") == "2");
    CHECK(both[1].at("value").starts_with("10.8"));
    const auto lines = run_libration(bratu + words{"--guess", "y'(0)=0.5,1"});
    CHECK(lines.exit_code == 0);
    CHECK(lines.err == "libration: the first guess y'(0) = 1 leads to solution 1 again\n");
}

TEST_CASE("the first eigenvalues of a well, and what is not accepted", "[command][find]") {
    const words well{"find", "--problem", "psi'' = (x^2 - E)*psi; psi(-inf) = 0; psi(inf) = 0", "--digits", "20"};
    const auto rows = rows_with_a_remark(well + words{"--eigenvalue", "E", "--count", "2"});
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].at("name") == "E_0");
    CHECK(rows[0].at("value") == "1.0000000000000000000");
    CHECK(rows[1].at("value") == "3.0000000000000000000");
    check_refused(well + words{"--eigenvalue", "E", "--count", "0"}, {"--count '0'", "1 or more"});
    check_refused(well + words{"--eigenvalue", "F"}, {"--eigenvalue 'F'", "choose one of its own, E"});
    check_refused(well + words{"--eigenvalue", "E", "--unknown", "E"}, {"--eigenvalue", "leave one of them out"});
    check_refused(well + words{"--unknown", "E", "--count", "2"}, {"--count '2'", "add --eigenvalue E"});
}

// y(1) = 1 + s + k: what the text leaves open has the first guess and the first value of the branch.
TEST_CASE("first guesses and branches give values to what the problem leaves open", "[command][find]") {
    const words open{"find", "--problem", "y' = s + k; y(0) = 1", "--unknown", "s", "--such-that", "y(1) = 0"};
    const auto found = rows_with_a_remark(open + words{"--guess", "s=0", "--set", "k=3"});
    REQUIRE(found.size() == 1);
    CHECK(found[0].at("value").starts_with("-4.000"));
    const auto branch = rows_with_a_remark(open + words{"--guess", "s=0", "--along", "k = 1:2:2"});
    REQUIRE(branch.size() == 2);
    CHECK(branch[1].at("s").starts_with("-3.000"));
}

TEST_CASE("a first guess without a solution is named with its last iterate", "[command][find]") {
    const words none{"find", "--problem", "y' = a^2 - 1; y(0) = 0; a = 3", "--unknown", "a", "--such-that", "y(1) = 0"};
    const auto some = run_libration(none + words{"--guess", "a=3,0"});
    CHECK(some.exit_code == 1);
    CHECK(some.out.starts_with("a         1.0000"));
    CHECK(some.err.find("the first guess a = 0 leads to no solution: it is not isolated") != std::string::npos);
    const auto alone = run_libration(
        {"find", "--problem", "y' = a^2 + 1; y(0) = 0; a = 3", "--unknown", "a", "--such-that", "y(1) = 0"});
    CHECK(alone.exit_code == 1);
    CHECK(alone.err.find("; the last iterate is a = ") != std::string::npos);
    CHECK(alone.err.find(", with residual ") != std::string::npos);
    CHECK(alone.err.find("or several with --guess \"a=0:10:11\"") != std::string::npos);
}

// y(1) = k - 3 s + s^3.
TEST_CASE("a branch is followed past its turning points", "[command][find]") {
    const words cubic{"find",      "--problem", "y' = k - 3*s + s^3; y(0) = 0; s = 2; k = 1",
                      "--unknown", "s",         "--such-that",
                      "y(1) = 0",  "--digits",  "15"};
    const auto branch = rows_with_a_remark(cubic + words{"--along", "k = -3:3:3", "--guess", "s=2"});
    REQUIRE(branch.size() == 7);
    CHECK(branch[0].at("branch") == "1");
    CHECK(branch[2].at("point") == "turning point");
    CHECK(branch[2].at("k") == "2.00000000000000");
    CHECK(branch[2].at("s") == "1.00000000000000");
    CHECK(branch[3].at("s").empty());
    CHECK(branch[3].at("undecided").starts_with("|s| < "));
    CHECK(branch[4].at("k") == "-2.00000000000000");
    CHECK(branch[6].at("rigour") == "proved");
    const auto ended = run_libration(cubic + words{"--along", "k=-3:3:3"});
    CHECK(ended.exit_code == 0);
    CHECK(ended.err.starts_with("libration: the branch leaves the range at k = 3."));
}

TEST_CASE("what find does not accept is shown as it would be accepted", "[command][find][bad input]") {
    const words find{"find", "--problem", "y'' = -k*y; y(0) = 0; y'(0) = 1; k = 1", "--unknown", "y'(0)"};
    check_refused(find + words{"--such-that", "y' = 1"}, {"--such-that", "write y'(1) = 1 with the time"});
    check_refused(find + words{"--such-that", "y(1) + y'(1)"}, {"--such-that", "write y(1) + y'(1) = 0"});
    check_refused(find + words{"--unknown", "k", "--such-that", "y(1) = 2"},
                  {"--unknown \"y'(0),k\" --such-that \"y(1) = 2\" --such-that \"y(1) = 0\""});
    const words given = find + words{"--such-that", "y(1) = 2"};
    check_refused(given + words{"--guess", "k=1,2"}, {"--guess 'k=1,2'", "write --guess \"y'(0)=1,2\""});
    check_refused(given + words{"--guess", "y'(0)"}, {"--guess", "write --guess \"y'(0)=0,1\""});
    check_refused(given + words{"--guess", "y'(0)=a"}, {"--guess", "\"y'(0)=0:5:11\""});
    check_refused(given + words{"--guess", "y'(0)=1", "--guess", "y'(0)=2"}, {"--guess", "in one list"});
    check_refused(given + words{"--along", "q=0:1:3"}, {"--along 'q'", "choose one of its own, k"});
    check_refused(given + words{"--along", "k"}, {"--along 'k'", "write --along \"k=0:1:11\""});
    check_refused(given + words{"--along", "k=1"}, {"--along 'k=1'", "write \"k=1:LAST:11\""});
    check_refused(given + words{"--along", "k=0,2,1"}, {"--along 'k'", "in one direction"});
    check_refused(given + words{"--along", "y'(0)=0:1:3"}, {"--along", "leave it out there"});
    check_refused({"find", "--problem", "lorenz", "--along", "r=0:1:3"}, {"nothing to find", "--unknown"});
    check_refused({"find", "--problem", "van_der_pol", "--periodic", "--guess", "x(0)=1"}, {"--guess", "--set"});
}

TEST_CASE("an unknown without a first value is reported with the option that gives one", "[command][find]") {
    check_refused({"find", "--problem", "x' = k*x; x(0) = 1", "--unknown", "k", "--such-that", "x(1) = 2"},
                  {"--unknown 'k' has no first value from which the search begins: add --guess k=1"});
}

// On the curve y^2 = x^2 - x^3 the last term vanishes, and it is an orbit for c = 1/3 alone.
TEST_CASE("a homoclinic orbit is found from the equilibrium near the initial values", "[command][find]") {
    const words orbit{"find", "--problem",
                      "x' = y; y' = x - 3/2*x^2 + (c - 1/3)*y - y*(y^2 - x^2 + x^3); x(0) = 0.1; y(0) = 0; c = 0.32",
                      "--homoclinic"};
    const auto found = run_libration(orbit + words{"--unknown", "c", "--digits", "20"});
    CHECK(found.out.find("0.33333333333333333333") != std::string::npos);
    CHECK(found.err.find("rate 1: 1.000000000000000000") != std::string::npos);
    CHECK(found.err.find("--homoclinic: x(-inf) = 0, x(inf) = 0, y(-inf) = 0") != std::string::npos);
    check_refused(orbit, {"--unknown"});
    check_refused(orbit + words{"--unknown", "c", "--such-that", "x(1) = 2"}, {"--homoclinic", "--such-that"});
    check_refused({"find", "--problem", "x' = y; y' = x^2 - 2 + c*y; x(0) = 1.4; y(0) = 0; c = 0.32", "--homoclinic",
                   "--unknown", "c"},
                  {"1.41421", "x(-inf) = VALUE"});
}

TEST_CASE("an orbit that a reversal of time maps to itself is found without --unknown", "[command][find]") {
    const auto separatrix =
        run_libration({"find", "--problem", "y'' = -sin(y); y(-inf) = -pi; y(inf) = pi", "--digits", "20"});
    CHECK(separatrix.out.find("y'(0)     2.0000000000000000000") != std::string::npos);
    CHECK(separatrix.err.find("phase: y(-t) = -y(t), which fixes t = 0") != std::string::npos);
    const words loop{"find", "--problem", "x' = y; y' = x - x^2; x(0) = 0.1; y(0) = 0", "--homoclinic"};
    CHECK(run_libration(loop + words{"--digits", "12"}).out.find("x(0)      1.50000000000") != std::string::npos);
    check_refused({"find", "--problem", "x'' = x - x^2; x(-inf) = 0; x(inf) = 0", "--homoclinic"},
                  {"--homoclinic", "together with conditions at infinity"});
    check_refused({"find", "--problem", "u'' + 3*u' + u*(1-u) = 0; u(-inf) = 1; u(inf) = 0"}, {"libration reference"});
}

// Every orbit of the harmonic oscillator has the period 2 pi.
TEST_CASE("the period of an orbit may be a parameter of the problem", "[command][find]") {
    const words oscillator{"find",       "--problem", "x' = y; y' = -x; x(0) = 1; y(0) = 0; T = 2*pi; a = 3",
                           "--periodic", "--digits",  "20",
                           "--period"};
    const auto done = run_libration(oscillator + words{"T"});
    CHECK(done.exit_code == 0);
    CHECK(done.out.find("6.2831853071795864769") != std::string::npos);
    CHECK(done.err.find("'T'") == std::string::npos);
    CHECK(done.err.find("defines 'a', which is not used") != std::string::npos);
    for (const auto& [typed, reason] : {std::pair{"T - 3*pi", "is not positive"}, {"x", "is not constant"}}) {
        const auto refused = run_libration(oscillator + words{typed});
        CHECK(refused.exit_code == 2);
        CHECK(refused.err.find("--period '" + std::string(typed) + "' " + reason +
                               ": give a time after which the orbit returns") != std::string::npos);
    }
}

}  // namespace command_find_test
