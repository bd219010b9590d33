// Any equation on the command line: coefficients --problem and the catalogue.
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <string>
#include <thread>
#include <utility>

#include "command/printed.hpp"
#include "command/refusal.hpp"
#include "libration/number/exact.hpp"
#include "libration/scalar/precision_scope.hpp"

namespace command_problem_test {

using namespace libration;
using namespace libration::tests;

namespace {

const std::string blasius = "f''' + f*f''/2 = 0; f(0)=0; f'(0)=0; f''(0)=1";

words coefficients(const std::string& problem, const words& more = {}) {
    return words{"coefficients", "--problem", problem} + more;
}

}  // namespace

TEST_CASE("coefficients of a typed problem are printed in every arithmetic", "[command][problem]") {
    const auto rounded = rows_of(coefficients(blasius, {"--order", "11", "--digits", "20"}));
    REQUIRE(rounded.size() == 12);
    CHECK(rounded[0].at("f") == "0");
    CHECK(rounded[2].at("f") == "0.50000000000000000000");
    CHECK(rounded[5].at("f") == "-0.0041666666666666666667");
    const auto fractions = rows_of(coefficients(blasius, {"--order", "11", "--scalar", "rational"}));
    CHECK(fractions[5].at("f") == "-1/240");
    CHECK(fractions[8].at("f") == "11/161280");
    const auto proved = rows_of(coefficients(blasius, {"--order", "120", "--scalar", "ball:50", "--from", "119"}));
    REQUIRE(proved.size() == 2);
    CHECK(proved[0].at("n") == "119");
    CHECK(significant_digits(proved[0].at("f")) == 50);
    CHECK(proved[0].at("f_uncertainty") != "0");
    CHECK(proved[1].at("f") == "0");
    CHECK(proved[1].at("f_uncertainty") == "0");
    CHECK(rows_of(coefficients("y' = y; y(0) = 1", {"--order", "3", "--scalar", "double"}))[3].at("y") ==
          "0.16666666666666666");
}

TEST_CASE("problems come from the catalogue and from files, and are changed by --set", "[command][problem]") {
    CHECK(rows_of(coefficients("lane_emden", {"--set", "n=5", "--order", "4", "--scalar", "rational"}))[4].at("y") ==
          "1/24");
    CHECK(rows_of(coefficients("blasius", {"--set", "f''(0)=2", "--order", "2", "--digits", "5"}))[2].at("f") ==
          "1.0000");
    const auto atom = rows_of(coefficients("thomas_fermi", {"--order", "3", "--digits", "10"}));
    CHECK(atom[3].at("y") == "1.333333333");
    CHECK(atom[3].at("power") == "3/2");
    CHECK(atom[2].at("power") == "1");
    const temporary_folder folder;
    std::ofstream(folder.path() / "mine.ode") << "# mine\nx' = y\ny' = -x\nx(0) = 0; y(0) = 1\n";
    const auto done = run_libration(
        coefficients("mine.ode", {"--order", "3", "--scalar", "rational", "--format", "csv"}), folder.path());
    CHECK(done.out == "n,x,y\n0,0,1\n1,1,0\n2,0,-1/2\n3,-1/6,0\n");
}

TEST_CASE("coefficients about other points are those of the continued solution", "[command][problem]") {
    const std::string tangent = "y' = 1 + y^2; y(0) = 0";
    const auto there = rows_of(coefficients(tangent, {"--order", "1", "--at", "pi/4", "--digits", "30"}));
    CHECK(there[0].at("y") == "1.00000000000000000000000000000");
    CHECK(there[1].at("y") == "2.00000000000000000000000000000");
    // tan(i) = i tanh(1).
    const auto turned = rows_of(coefficients(tangent, {"--order", "1", "--at", "1/10+i", "--digits", "20"}));
    CHECK(turned[0].at("y_im").starts_with("0.76"));
    const auto shown =
        rows_of({"coefficients", "--theta0", "5/2", "--omega0", "-3/10", "--order", "20", "--digits", "30"});
    const auto by_tape =
        rows_of(coefficients("x' = y; y' = -sin(x); x(0)=5/2; y(0)=-3/10", {"--order", "20", "--digits", "30"}));
    for (std::size_t n = 0; n < shown.size(); ++n) {
        CHECK(by_tape[n].at("x") == shown[n].at("coefficient"));
    }
}

TEST_CASE("a problem is marched to times, and the pendulum agrees with its own command", "[command][problem]") {
    const words problem{"trajectory", "--general", "--problem", "x' = y; y' = -sin(x); x(0)=5/2; y(0)=-3/10"};
    const auto rows = rows_of(problem + words{"--times", "10,-1,0", "--digits", "40"});
    const auto own =
        rows_of({"trajectory", "--theta0", "5/2", "--omega0", "-3/10", "--times", "10,-1,0", "--digits", "40"});
    REQUIRE(rows.size() == 3);
    REQUIRE(own.size() == 3);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        CHECK(rows[i].at("time") == own[i].at("time"));
        CHECK(rows[i].at("x") == own[i].at("theta"));
        CHECK(rows[i].at("y") == own[i].at("omega"));
        CHECK(rows[i].at("digits") == "40");
        CHECK(rows[i].at("rigour") == "two-method");
    }
    const auto rough = rows_of(problem + words{"--times", "10", "--scalar", "double"});
    CHECK(rough[0].at("rigour") == "heuristic");
    CHECK(rough[0].at("x").substr(0, 10) == own[0].at("theta").substr(0, 10));
    // Derivatives below the highest are columns: y = sin, y' = cos at pi/6.
    const auto second =
        rows_of({"trajectory", "--problem", "y'' = -y; y(0)=0; y'(0)=1", "--times", "pi/6", "--digits", "20"});
    CHECK(second[0].at("y") == "0.50000000000000000000");
    CHECK(second[0].at("y'") == "0.86602540378443864676");
}

// tan about pi/4: 1 + 2 s + 2 s^2 + 8/3 s^3; proved and rounded digits agree.
TEST_CASE("coefficients about other times are proved in balls", "[command][problem]") {
    const words about{"coefficients", "--problem", "y' = 1 + y^2; y(0) = 0", "--order", "3", "--at", "pi/4"};
    const auto proved = rows_of(about + words{"--scalar", "ball:30"});
    CHECK(proved[0].at("y") == "1.00000000000000000000000000000");
    CHECK(proved[3].at("y") == "2.66666666666666666666666666667");
    CHECK(proved[3].at("y_uncertainty") != "0");
}

// y = sqrt(y0^2 + t/2), whose fractions double in length with every power, together with z = 1/3 - atanh(t)/6, of whose
// even powers only the first coefficient is nonzero.
TEST_CASE("coefficients of a system with long fractions keep the exact zeros of its independent parts",
          "[command][problem]") {
    const auto rows =
        rows_of(coefficients("y' = (1/2)/(2*y); z' = (1/(1+t))*((1/6)/(t-1)); y(0) = 1 - 10^(-143); z(0) = 1/3",
                             {"--order", "259", "--scalar", "ball:20"}));
    REQUIRE(rows.size() == 260);
    for (std::size_t n = 2; n < rows.size(); n += 2) {
        CHECK(rows[n].at("z") == "0");
        CHECK(rows[n].at("z_uncertainty") == "0");
    }
    CHECK(rows[257].at("z") == "-0.00064850843060959792477");  // -1/1542
    CHECK(rows[1].at("y") == "0.25000000000000000000");
}

TEST_CASE("reference proves the digits of any problem, at times and at events", "[command][problem]") {
    const std::string swing = "x'' = -sin(x); x(0)=5/2; x'(0)=-3/10";
    const auto own =
        rows_of({"reference", "--theta0", "5/2", "--omega0", "-3/10", "--time", "10,-1", "--digits", "40"});
    const auto rows = rows_of({"reference", "--general", "--problem", swing, "--time", "10,-1", "--digits", "40"});
    REQUIRE(rows.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(rows[i].at("x") == own[i].at("theta"));
        CHECK(rows[i].at("x'") == own[i].at("omega"));
        CHECK(rows[i].at("rigour") == "proved");
        CHECK(rows[i].at("digits") == "40");
    }
    const auto marched =
        rows_of({"trajectory", "--general", "--problem", swing, "--times", "10", "--scalar", "ball:40"});
    CHECK(marched[0].at("x") == rows[0].at("x"));
    const auto quarters =
        rows_of({"reference", "--theta0", "2", "--omega0", "0", "--time", "T/4,3T/4", "--digits", "30"});
    const auto events = rows_of({"reference", "--problem", "x'' = -sin(x); x(0)=2; x'(0)=0", "--until", "x = 0",
                                 "--count", "2", "--digits", "30"});
    REQUIRE(events.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(events[i].at("time") == quarters[i].at("time"));
        CHECK(events[i].at("x'") == quarters[i].at("omega"));
        CHECK(events[i].at("x") == "0");
        CHECK(events[i].at("count") == std::to_string(i + 1));
    }
}

// The order of the unknowns is x, z, y; x - y is 0, which cannot be proved at any precision.
// y = c/(1 - c t): dy/dc = 1/(1 - c t)^2 = 4 at 1/2, and y does not reach 2.
TEST_CASE("reference prints derivatives in every format", "[command][problem]") {
    const words pole{"reference",     "--problem", "y' = y^2; y(0) = c; c = 1", "--digits", "10",
                     "--derivatives", "y(0), c"};
    const auto rows = rows_of(pole + words{"--time", "1/2"});
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].at("dy(t)/dy(0)") == "4.000000000");
    CHECK(rows[0].at("dy(t)/dc") == "4.000000000");
    const auto json = run_libration(pole + words{"--time", "1/2", "--format", "json", "--check"});
    CHECK(json.exit_code == 0);
    CHECK(json.out.find("\"dy(t)/dc\": \"4.000000000\"") != std::string::npos);
    const auto part = run_libration(pole + words{"--time", "1/2,2"});
    CHECK(part.exit_code == 1);
    CHECK(part.out.find("dy(t)/dy(0) 4.000000000\n") != std::string::npos);
    CHECK(part.err.find("is not reached") != std::string::npos);
    // The equations of the pendulum instead of its closed form: dx/dx(0) = cos t at rest.
    const auto rest = run_libration({"reference", "--problem", "x'' = -sin(x); x(0) = 0; x'(0) = 0", "--time", "1",
                                     "--digits", "10", "--derivatives", "x(0)"});
    CHECK(rest.out.find("\ndx(t)/dx(0)  0.5403023059\ndx'(t)/dx(0) ") != std::string::npos);
    const temporary_folder folder;
    check_refused({"reference", "--problem", "y' = y; y(0) = 1", "--time", "1", "--derivatives", "z"},
                  {"--derivatives 'z'", "neither a parameter nor an initial value"}, folder);
    check_refused({"reference", "--problem", "y' = y; y(0) = 1", "--time", "1", "--derivatives", "y(0),,"},
                  {"--derivatives 'y(0),,'", "empty item"}, folder);
    check_refused({"reference", "--theta0", "1", "--omega0", "0", "--time", "1", "--derivatives", "y(0)"},
                  {"--derivatives", "without --problem"}, folder);
}

TEST_CASE("one value or time that is not proved leaves the others", "[command][problem]") {
    const auto ended = run_libration(
        {"reference", "--problem", "y' = y^2; y(0)=1", "--time", "0.5,2,-1", "--digits", "10", "--format", "csv"});
    CHECK(ended.exit_code == 1);
    CHECK(ended.out ==
          "time,y,digits,rigour,time_typed\n0.5,2.000000000,10,proved,0.5\n-1,0.5000000000,10,proved,-1\n");
    CHECK(ended.err.find("time '2' is not reached") != std::string::npos);
    const words open{"reference", "--problem", "x' = -x + z^2; y' = -y + z^2; z' = x - y; x(0)=1/3; y(0)=1/3; z(0)=0",
                     "--time",    "0,1",       "--digits",
                     "10"};
    const auto text = run_libration(open);
    CHECK(text.exit_code == 1);
    CHECK(text.out.find("z         0\n") != std::string::npos);
    CHECK(text.out.find("y         0.1226264804\nz         |z| < ") != std::string::npos);
    words as_csv = open;
    as_csv.insert(as_csv.end(), {"--format", "csv"});
    const auto csv = run_libration(as_csv);
    CHECK(csv.exit_code == 1);
    const auto rows = csv_rows(csv.out);
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].at("undecided").empty());
    CHECK(rows[1].at("z").empty());
    CHECK(rows[1].at("y") == "0.1226264804");
    CHECK(rows[1].at("undecided").starts_with("|z| < "));
    CHECK(lines_of(csv.err).size() == 1);
}

TEST_CASE("equations that are the pendulum's are answered by its closed form, which is said", "[command][problem]") {
    const words asked{"reference", "--time", "1e12", "--digits", "30", "--format", "csv"};
    const auto own = rows_of({"reference", "--theta0", "5/2", "--omega0", "-3/10", "--time", "1e12", "--digits", "30"});
    for (const char* text : {"pendulum", "q'' = -sin(q); q(0) = 5/2; q'(0) = -3/10"}) {
        const auto found = run_libration(asked + words{"--problem", text});
        CHECK(found.exit_code == 0);
        CHECK(found.err.find("the equations are those of the pendulum") != std::string::npos);
        CHECK(lines_of(found.err).size() == 1);
        CHECK(found.out.find(own[0].at("theta") + "," + own[0].at("omega") + ",30,proved,1e12\n") != std::string::npos);
    }
    const auto checked = run_libration({"reference", "--problem", "pendulum", "--time", "10", "--check"});
    CHECK(checked.exit_code == 0);
    check_refused({"reference", "--general", "--theta0", "1", "--omega0", "0", "--time", "1"},
                  {"--general", "--problem"});
}

// y = 1/(1 - t) does not influence z = tan t.
TEST_CASE("an unknown that ends leaves those that it does not influence", "[command][problem]") {
    const words asked{"reference", "--problem", "y' = y^2; z' = 1 + z^2; y(0)=1; z(0)=0", "--time", "0.5,1",
                      "--digits",  "10"};
    const auto text = run_libration(asked);
    CHECK(text.exit_code == 1);
    CHECK(text.out.find("y         y is not reached\nz         1.557407725\n") != std::string::npos);
    CHECK(text.err.find("is not reached: the solution is proved to exist up to 0.99999") != std::string::npos);
    const auto csv = run_libration(asked + words{"--format", "csv"});
    CHECK(csv.out ==
          "time,y,z,digits,rigour,time_typed,undecided\n"
          "0.5,2.000000000,0.5463024898,10,proved,0.5,\n"
          "1,,1.557407725,10,proved,1,y is not reached\n");
}

TEST_CASE("trajectory continues the unknowns that do not depend on one that has ended", "[command][problem]") {
    const words asked{"trajectory", "--problem",  "y' = y^2; z' = 1 + z^2; y(0)=1; z(0)=0",
                      "--times",    "-1,0.5,1,2", "--format",
                      "csv",        "--digits",   "10"};
    const auto agreed = run_libration(asked);
    CHECK(agreed.exit_code == 1);
    CHECK(agreed.err.find("time '1.0") != std::string::npos);
    CHECK(lines_of(agreed.err).size() == 1);
    CHECK(agreed.out ==
          "time,y,z,digits,rigour,time_typed,undecided\n"
          "-1,0.5000000000,-1.557407725,10,two-method,-1,\n"
          "0.5,2.000000000,0.5463024898,10,two-method,0.5,\n"
          "1,,1.557407725,10,two-method,1,y is not reached\n");
    const auto rounded = csv_rows(run_libration(asked + words{"--scalar", "double"}).out);
    REQUIRE(rounded.size() == 3);
    CHECK(rounded[1].at("y").starts_with("2.00000000"));
    CHECK(rounded[2].at("y").empty());
    CHECK(rounded[2].at("z").starts_with("1.55740772"));
    check_refused({"trajectory", "--problem", "y' = y^2; y(0)=1", "--times", "2"}, {"--times '2.0"});
}

TEST_CASE("a reference that cannot be proved ends with 1, says why, and prints nothing", "[command][problem]") {
    const auto blown = run_libration({"reference", "--problem", "y' = y^2; y(0)=1", "--time", "2", "--digits", "20"});
    CHECK(blown.exit_code == 1);
    CHECK(blown.out.empty());
    CHECK(blown.err.find("the solution is proved to exist up to 0.99999") != std::string::npos);
    const auto touching =
        run_libration({"reference", "--problem", "y'' = -y; y(0)=1; y'(0)=0", "--until", "y = 1", "--digits", "20"});
    CHECK(touching.exit_code == 1);
    CHECK(touching.out.empty());
    const auto typed = run_libration({"find", "--problem", "f''' + f*f'' = 0; f(0)=0; f'(0)=0; f''(0)=k; k=1",
                                      "--unknown", "k", "--such-that", "f'(inf) = 1"});
    CHECK(typed.exit_code == 0);
    CHECK(typed.out.find("0.469599988361013304509333653447588458721334") != std::string::npos);
    CHECK(typed.err.find("not claimed: ") != std::string::npos);
}

TEST_CASE("events that are found are printed also where others are not", "[command][problem]") {
    const words reference{"reference", "--problem", "y'' = -y; y(0)=0; y'(0)=1", "--format", "csv", "--digits", "20"};
    const auto some = run_libration(reference + words{"--until", "y = 1/2", "--before", "1", "--count", "2"});
    CHECK(some.exit_code == 1);
    CHECK(some.out.find("\n0.52359877559829887308,") != std::string::npos);
    CHECK(some.err.find("event '2' is not found before that time: 1 were found") != std::string::npos);
    const auto none = run_libration(reference + words{"--until", "y = 2", "--horizon", "10"});
    CHECK(none.exit_code == 1);
    CHECK(none.out.empty());
    CHECK(none.err.find("within 10 steps, from time 0 up to ") != std::string::npos);
    const auto start = rows_of({"reference", "--problem", "y' = 1; y(1)=1", "--until", "y = 1", "--from-start"});
    CHECK(start[0].at("y").substr(0, 5) == "1.000");
    check_refused({"reference", "--problem", "lorenz", "--time", "1", "--horizon", "2"}, {"--horizon", "--until"});
    check_refused({"reference", "--problem", "lorenz", "--time", "1", "--from-start"}, {"--from-start", "--until"});
    check_refused({"reference", "--problem", "lorenz", "--until", "x = 0", "--horizon", "0"}, {"--horizon"});
}

// At half the period x = -(1 + e), x' = 0 and y' = -sqrt((1 - e)/(1 + e)).
TEST_CASE("a number of an event that is exactly 0 does not lose the others", "[command][problem]") {
    const words events{"reference", "--problem", "kepler", "--until", "y = 0", "--digits", "10"};
    const auto text = run_libration(events);
    CHECK(text.exit_code == 1);
    CHECK_THAT(text.out, Catch::StartsWith("time      3.141592654\nx         -1.600000000\nx'        |x'| < "));
    CHECK_THAT(text.out, Catch::EndsWith("\ny         0\ny'        -0.5000000000\n"));
    CHECK_THAT(text.err, Catch::StartsWith("libration: event '1' has a value of x' that ") &&
                             Catch::Contains(" bits do not distinguish from 0: |x'| < "));
    CHECK(std::ranges::count(text.err, '\n') == 1);
    const words tangent{"reference", "--problem",       "x' = 1; u' = 1 + u^2; x(0) = -1; u(0) = -tan(1)",
                        "--until",   "x*(2*x - 1) = 0", "--count",
                        "2",         "--digits",        "12",
                        "--check"};
    const auto csv = run_libration(tangent + words{"--format", "csv"});
    CHECK(csv.exit_code == 1);
    CHECK_THAT(csv.out,
               Catch::StartsWith("time,x,u,digits,rigour,count,undecided\n1.00000000000,0,,12,proved,1,|u| < "));
    CHECK_THAT(csv.out, Catch::EndsWith("\n1.50000000000,0.500000000000,0.546302489844,12,proved,2,\n"));
    const auto json = run_libration(tangent + words{"--format", "json"});
    CHECK_THAT(json.out, Catch::Contains("\"undecided\": \"|u| < "));
}

// A long-running search, ended after a second.
TEST_CASE("a search that is interrupted prints the events that it knows", "[command][problem]") {
    const temporary_folder folder;
    const auto ended = run_libration({"reference", "--problem", "lorenz", "--until", "z = 30", "--count", "100000",
                                      "--digits", "10", "--format", "csv"},
                                     folder.path(), "/dev/null", [](pid_t search) {
                                         std::this_thread::sleep_for(std::chrono::seconds(1));
                                         ::kill(search, SIGINT);
                                     });
    CHECK(ended.exit_code == 1);
    CHECK(ended.out.starts_with("time,x,y,z,digits,rigour,count\n0."));
    CHECK(ended.err.starts_with("libration: the search for events was interrupted about time "));
    CHECK(std::ranges::count(ended.err, '\n') == 1);
}

TEST_CASE("find proves parameters, starts and periodic orbits", "[command][problem]") {
    const auto shear =
        rows_of({"find", "--problem", "blasius", "--unknown", "k", "--such-that", "f'(inf) = 1", "--digits", "32"});
    CHECK(shear[0].at("value") == "0.33205733621519629893718006201058");
    CHECK(shear[0].at("rigour") == "proved");
    const auto shot = rows_of({"find", "--problem", "y'' = -y; y(0)=0; y'(0)=1", "--unknown", "y'(0)", "--such-that",
                               "y(pi/6) = 1", "--digits", "20"});
    CHECK(shot[0].at("name") == "y'(0)");
    CHECK(shot[0].at("value") == "2.0000000000000000000");
    const auto cycle = rows_of({"find", "--problem", "van_der_pol", "--periodic", "--digits", "20"});
    REQUIRE(cycle.size() == 3);
    CHECK(cycle[2].at("name") == "period");
    CHECK(cycle[2].at("value") == "6.6632868593231301897");
}

TEST_CASE("what reference and find of a problem do not understand is refused", "[command][problem][bad input]") {
    const words reference{"reference", "--problem", "lorenz"};
    check_refused(reference, {"--times"});
    check_refused(reference + words{"--time", "1", "--energy", "1"}, {"--energy", "--problem"});
    check_refused(reference + words{"--time", "T"}, {"--times"});
    check_refused(reference + words{"--time", "1", "--count", "2"}, {"--count", "--until"});
    check_refused(reference + words{"--until", "x' = 0"}, {"x'"});
    check_refused(reference + words{"--until", "x"}, {"--until", "="});
    check_refused(reference + words{"--until", "x = 0", "--time", "1"}, {"--times", "--until"});
    check_refused(reference + words{"--until", "x = 0", "--crossing", "left"}, {"--crossing", "'left'"});
    check_refused(reference + words{"--until", "x = 0", "--count", "0"}, {"--count"});
    check_refused(reference + words{"--until", "1 = 2"}, {"--until"});
    check_refused({"reference", "--problem", "t*y'' + 2*y' + t*erf(y) = 0; y(0) = 1; y'(0) = 0", "--time", "1"},
                  {"--problem", "singular"});
    check_refused({"find"}, {"--problem"});
    check_refused({"find", "--problem", "lorenz"}, {"--unknown"});
    check_refused({"find", "--problem", "blasius", "--unknown", "k"}, {"--such-that"});
    check_refused({"find", "--problem", "blasius", "--unknown", "q", "--such-that", "f'(5) = 1"}, {"'q'"});
    check_refused({"find", "--problem", "blasius", "--unknown", "k", "--such-that", "f' = 1"}, {"--such-that"});
    check_refused({"find", "--problem", "blasius", "--unknown", "k", "--such-that", "f'''(5) = 1"}, {"f'''"});
    check_refused({"find", "--problem", "van_der_pol", "--periodic", "--such-that", "x"}, {"--such-that", "'x'"});
    check_refused({"find", "--problem", "blasius", "--unknown", "k,k", "--such-that", "f'(inf) = 1"},
                  {"--unknown", "twice"});
    check_refused(
        {"find", "--problem", "blasius", "--unknown", "k", "--such-that", "f'(inf) = 1", "--such-that", "f(5) = 3"},
        {"--such-that", "'f(5) = 3'", "infinity"});
}

TEST_CASE("conditions at infinity in the text of a problem and as options are the same", "[command][problem]") {
    const auto prints = [](const words& question, const std::string& line) {
        const auto found = run_libration(question + words{"--digits", "20", "--format", "csv"});
        CHECK(found.exit_code == 0);
        CHECK(found.out.find(line) != std::string::npos);
        CHECK(found.err.find("proved: ") != std::string::npos);
        CHECK(found.err.find("not claimed: ") != std::string::npos);
    };
    prints({"find", "--problem", "u'' + c*u' + u*(1-u)*(u-a) = 0; a = 1/4; u(-inf) = 1; u(inf) = 0", "--unknown", "c"},
           "c,0.35355339059327376220,20,proved");  // 1/(2 sqrt 2)
    const words last{"--unknown", "y(0)", "--guess", "y(0)=1.4"};
    prints(words{"find", "--problem", "y'' = y - y^3; y'(0) = 0; y(inf) = 0"} + last, "y(0),1.4142135623730950488,20");
    prints(words{"find", "--problem", "y'' = y - y^3; y'(0) = 0", "--such-that", "y(inf) = 0"} + last,
           "y(0),1.4142135623730950488,20");
    check_refused({"find", "--problem", "x'' = -sin(x); x(0) = 0; x(inf) = 3.14159", "--unknown", "x'(0)"},
                  {"x(inf) = 3.14159", "equilibrium"});
    check_refused({"find", "--problem", "y'' = -3*y' - 2*y; y(0) = 1; y(inf) = 0", "--unknown", "y'(0)"},
                  {"--unknown", "too many"});
}

TEST_CASE("the radius of a problem is that of its nearest singularity", "[command][problem]") {
    const auto verdict = [](const words& problem) {
        const auto row = rows_of(words{"radius", "--problem"} + problem).front();
        return std::pair(std::stod(row.at("radius")), std::stod(row.at("uncertainty")));
    };
    // Painleve I: the first pole on z > 0 at 2.38416876956881664; tan: pi/2, and about 1+i the distance from there.
    const auto painleve = verdict({"painleve_1", "--order", "200"});
    CHECK(std::abs(painleve.first - 2.38416876956881664) <= painleve.second + 1e-15);
    const auto tangent = verdict({"y' = 1 + y^2; y(0) = 0", "--order", "60"});
    CHECK(std::abs(tangent.first - 1.5707963267948966) <= tangent.second + 1e-15);
    const auto moved = verdict({"y' = 1 + y^2; y(0) = 0", "--order", "60", "--at", "1+i"});
    CHECK(std::abs(moved.first - std::hypot(1.5707963267948966 - 1, 1)) <= moved.second + 1e-15);
    // Blasius with the slope of a plate: 5.6900380545.
    const auto blasius_radius = verdict({"blasius", "--set", "k=0.33205733621519629893718", "--order", "150"});
    CHECK(std::abs(blasius_radius.first - 5.6900380545) <= blasius_radius.second + 1e-9);
}

TEST_CASE("the catalogue is listed, and a problem shown", "[command][problem]") {
    CHECK(lines_of(output_of({"problems", "--format", "csv"})).size() == 116);
    CHECK(output_of({"problems", "blasius"}).find("f''' + f*f''/2 = 0\n") != std::string::npos);
    check_refused({"problems", "blasus"}, {"'blasus'", "blasius"});
}

TEST_CASE("wrong problems are refused with the place and the remedy", "[command][problem][bad input]") {
    const words order{"--order", "5"};
    check_refused(coefficients("y' = x y; y(0)=1", order), {"--problem", "'x y'", "column 6", "write y' = x*y"});
    check_refused(coefficients("y' = y, y(0)=0,5", order), {"--problem", "'0,5'", "write 0.5"});
    check_refused(coefficients("y'' = y; y(0)=1", order), {"--problem", "y'(0)"});
    check_refused(coefficients("y' = log(y); y(0)=0", order), {"--problem", "logarithm"});
    check_refused(coefficients("sin(y') = y; y(0)=0", order), {"--problem", "function"});
    check_refused(coefficients("t^2*y' = y - t; y(0)=0", order), {"--problem", "irregular"});
    check_refused(coefficients("y' = 1/t; y(0)=0", order), {"logarithm"});
    check_refused(coefficients("blasus", order), {"--problem", "'blasus'", "blasius"});
    check_refused(coefficients("none/such.ode", order), {"--problem", "'none/such.ode'"});
    check_refused(coefficients("blasius", words{"--set", "m=1"} + order),
                  {"--set", "'m=1'", "choose one of its own, k"});
    check_refused(coefficients("blasius", words{"--set", "kk=1"} + order), {"--set", "'kk=1'", "did you mean k?"});
    check_refused(coefficients("blasius", words{"--set", "f'''(0)=1"} + order),
                  {"--set", "'f'''(0)=1'", "did you mean f''(0)?", "choose one of its own, f(0), f'(0), f''(0)"});
    check_refused(coefficients("blasius", words{"--set", "g''(0) = 1"} + order), {"--set", "did you mean f''(0)?"});
    check_refused(coefficients("y' = rate*y; y(0)=1; rate=2", words{"--set", "raet=1"} + order),
                  {"--set", "did you mean rate?"});
    check_refused(coefficients("y' = y; y(0)=1", words{"--set", "k=1"} + order), {"--set", "there is no parameter"});
    check_refused(coefficients("blasius", words{"--set", "k=1/0"} + order), {"--set", "zero"});
    check_refused(coefficients("blasius", words{"--energy", "1"} + order), {"--energy", "--problem"});
    check_refused(coefficients("blasius", words{"--at", "f(1)"} + order), {"--at", "'f(1)'"});
    check_refused(coefficients("blasius", words{"--at", "1+i", "--scalar", "ball:20"} + order),
                  {"--scalar", "ball:20"});
    check_refused(coefficients("riccati", words{"--at", "2"} + order), {"--at", "'2'"});
    check_refused(coefficients("pendulum", words{"--scalar", "rational"} + order), {"fraction"});
    check_refused({"coefficients", "--set", "k=1", "--order", "3"}, {"--set", "--problem"});
}

TEST_CASE("what a march and a radius cannot do is refused", "[command][problem][bad input]") {
    const words march{"trajectory", "--problem", "y' = y^2; y(0) = 1", "--times"};
    for (const words& each :
         {march + words{"2"}, march + words{"T"}, march + words{"90deg"}, march + words{"x"},
          march + words{"1/2", "--method", "exact"}, march + words{"1/2", "--order", "5"},
          march + words{"1/2", "--energy", "1"}, words{"trajectory", "--set", "k=1", "--energy", "1", "--times", "1"},
          words{"radius", "--problem", "blasius", "--energy", "1"},
          words{"radius", "--problem", "blasius", "--coefficients", "file"}}) {
        const temporary_folder folder;
        check_refused(each, {}, folder);
    }
}

TEST_CASE("ways through the complex plane of time lead around singularities", "[command][problem]") {
    const std::string pole = "y' = y^2; y(0) = 1";
    // 1/(1 - t) beyond its pole, on both sides; 1/(1-t) about 2 is -1 + s - s^2 + ..
    for (const char* via : {"1+i", "1-i"}) {
        const auto rows =
            rows_of({"trajectory", "--problem", pole, "--times", "2,2+i", "--via", via, "--digits", "20"});
        CHECK(rows[0].at("y_re") == "-1.0000000000000000000");
        CHECK(rows[0].at("y_im") == "0");
        CHECK(rows[1].at("time_im") == "1");
        CHECK(rows[1].at("y_im") == "0.50000000000000000000");
        CHECK(rows[1].at("rigour") == "two-method");
        const auto about = rows_of(coefficients(pole, {"--at", "2", "--via", via, "--order", "3", "--digits", "10"}));
        CHECK(about[1].at("y_re") == "1.000000000");
        CHECK(about[2].at("y_re") == "-1.000000000");
        CHECK(about[2].at("y_im") == "0");
    }
    // Once around the branch point of sqrt(1 + t).
    const words around{"trajectory", "--problem", "y' = 1/(2*y); y(0) = 1", "--times", "0", "--via=-1+i,-2,-1-i"};
    CHECK(rows_of(around + words{"--digits", "15"})[0].at("y_re") == "-1.00000000000000");
    for (const char* scalar : {"double", "quad"}) {
        const auto row = rows_of(around + words{"--scalar", scalar})[0];
        CHECK(std::stod(row.at("y_re")) == Approx(-1));
        CHECK(row.at("rigour") == "heuristic");
    }
    // A range along a line.
    const auto line = rows_of({"trajectory", "--problem", "y' = y; y(0) = 1", "--times", "0:i:3", "--digits", "5"});
    CHECK(line[1].at("time_typed") == "1/2*i");
    CHECK(line[1].at("y_re") == "0.87758");
    check_refused({"trajectory", "--problem", pole, "--times", "2+0*i"}, {"--times", "straight line", "--via"});
    check_refused({"trajectory", "--problem", pole, "--times", "2", "--via", "1+"}, {"--via", "'1+'"});
    check_refused({"trajectory", "--problem", pole, "--times", "i", "--scalar", "ball:20"}, {"ball:20", "mpfr:20"});
    check_refused({"trajectory", "--energy", "1", "--times", "1", "--via", "i"}, {"--via", "--problem"});
    check_refused(coefficients(pole, {"--via", "1+i", "--order", "3"}), {"--via", "--at"});
}

TEST_CASE("trajectories tell of approximants, and of invariants", "[command][problem]") {
    const auto by = [](const std::string& problem, const char* method, const words& more = {}) {
        return rows_of(words{"trajectory", "--problem", problem, "--method", method, "--order", "20", "--times",
                             "0:3:4", "--digits", "20"} +
                       more);
    };
    // The errors of Blasius' layer at 3, within R = 3.13: the more information a method uses, the smaller its error.
    const auto error_at_3 = [&](const char* method) { return std::stod(by("blasius", method)[3].at("f_error")); };
    CHECK(error_at_3("series") == Approx(0.00597).epsilon(0.01));
    CHECK(error_at_3("pade") < 1e-6);
    CHECK(error_at_3("asymptotic") < 1e-4);
    CHECK(by("blasius", "endpoint")[3].at("f") ==
          rows_of({"trajectory", "--problem", "blasius", "--times", "3", "--digits", "20"})[0].at("f"));
    CHECK(by("blasius", "series")[0].at("f_error") == "0");
    CHECK(by("sir", "asymptotic")[1].contains("S_error"));
    check_refused({"trajectory", "--problem", "lorenz", "--method", "asymptotic", "--order", "9", "--times", "1"},
                  {"asymptotic", "asymptotic behaviour", "blasius"});
    check_refused({"trajectory", "--problem", "lorenz", "--method", "pade", "--times", "1"}, {"--order"});
    check_refused({"trajectory", "--problem", "lorenz", "--method", "series", "--order", "9", "--times", "1",
                   "--scalar", "ball:20"},
                  {"ball:20", "taylor"});
    check_refused({"trajectory", "--problem", "lorenz", "--method", "endpoint", "--order", "9", "--times=-1,1"},
                  {"endpoint", "one side"});
    check_refused({"trajectory", "--problem", "lorenz", "--method", "euler", "--order", "9", "--times=-1,1"},
                  {"euler", "one side"});
    check_refused(
        {"trajectory", "--problem", "lorenz", "--method", "pade", "--order", "9", "--times", "1", "--scale", "1"},
        {"--scale", "pade"});
    check_refused({"trajectory", "--problem", "y' = y; y(0) = 1", "--method", "gauge", "--order", "9", "--times", "1"},
                  {"gauge", "--scale"});
    // Kepler's energy and angular momentum.
    // log(1 + t) is -log(1 - w) in Euler's variable w = t/(1 + t), and e^-t is 1 - z in the gauge function z.
    const auto mapped = [](const std::string& problem, const char* method, const char* order) {
        return rows_of({"trajectory", "--problem", problem, "--method", method, "--order", order, "--scale", "1",
                        "--times", "1/2,3", "--digits", "20"});
    };
    const precision_scope scope(40);
    for (const auto& row : mapped("y' = 1/(1 + t); y(0) = 0", "euler", "12")) {
        const mpfr t = from_exact<mpfr>(read_exact(row.at("time_typed")));
        mpfr sum(0);
        for (int n = 12; n > 0; --n) {
            sum = (sum + mpfr(1) / n) * t / (1 + t);
        }
        CHECK(abs(mpfr(mpfr(row.at("y")) - sum)) < mpfr("1e-19"));
    }
    for (const auto& row : mapped("y' = -y; y(0) = 1", "gauge", "3")) {
        CHECK(abs(mpfr(mpfr(row.at("y")) - exp(mpfr(-from_exact<mpfr>(read_exact(row.at("time_typed"))))))) <
              mpfr("1e-19"));
    }
    const auto planet =
        rows_of({"trajectory", "--problem", "kepler", "--general", "--times", "1,10", "--digits", "20"});
    CHECK(std::stod(planet[1].at("invariant_drift")) < 1e-30);
    CHECK(std::stod(rows_of({"trajectory", "--problem", "kepler", "--times", "10", "--scalar", "double"})[0].at(
              "invariant_drift")) < 1e-13);
}

TEST_CASE("the radius of a series in powers of a root is that of the variable", "[command][problem]") {
    // The closed form y = 1/(1 - s), s = sqrt(t), has y' = y^2/(2 s).
    const auto rows = rows_of({"radius", "--problem", "sqrt(t)*y' = y^2/2; y(0) = 1", "--order", "60"});
    CHECK(std::stod(rows[0].at("radius")) == Approx(1));
    CHECK(rows[0].at("kind") == "pole");
    CHECK(rows[0].at("note").find("t^(1/2)") != std::string::npos);
    // y = 1/(2 - s): R = 4.
    CHECK(std::stod(rows_of({"radius", "--problem", "sqrt(t)*y' = y^2/2; y(0) = 1/2", "--order", "60"})[0].at(
              "radius")) == Approx(4));
}

}  // namespace command_problem_test
