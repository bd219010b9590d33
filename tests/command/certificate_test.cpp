// reference --certificate: check/libration_check.py, a program in integers for Python's standard library, proves the
// printed values from the file, and refuses it if a digit is changed.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "certificates/checked.hpp"
#include "command/refusal.hpp"
#include "libration/query/certificate/certificate.hpp"
#include "problem/certificate_file.hpp"

namespace command_certificate_test {

using namespace libration;
using namespace libration::tests;

TEST_CASE("the values of a certificate are proved by the checker", "[command][reference][certificate]") {
    const temporary_folder folder;
    const words certified{"--certificate", "a.cert"};
    const auto lorenz = run_libration(
        words{"reference", "--problem", "lorenz", "--time", "1/4,1/2", "--digits", "8"} + certified, folder.path());
    CHECK(lorenz.exit_code == 0);
    const auto proved = checked(folder.path() / "a.cert");
    INFO(proved.out);
    CHECK(proved.exit_code == 0);
    CHECK(contains(proved.out, "exists on [0, 1/2]"));
    CHECK(contains(proved.out, "y' = x*(-z + 28) - y"));
    CHECK(contains(proved.out, "x(1/4) lies in ["));
    CHECK(contains(proved.out, "z(1/2) lies in ["));
    // A constant, sines, quotients, powers and explicit time; theta(0) = pi/3 is enclosed by the checker.
    const std::string mixed =
        "x'' = -sin(x) + exp(-t)/(2 + cos(x)) - log(3 + t)*sqrt(2 + x^2)/7; x(1/10) = pi/3; x'(1/10) = -1/5";
    const auto done = run_libration(
        words{"reference", "--problem", mixed, "--time", "3/10", "--digits", "8"} + certified, folder.path());
    INFO(done.err);
    REQUIRE(done.exit_code == 0);
    const auto also = checked(folder.path() / "a.cert");
    INFO(also.out);
    CHECK(also.exit_code == 0);
}

// The jump at t = 0.807 takes 1e-5, and x' is 7e5 there: after it the rounding of a step must not keep steps as short.
TEST_CASE("a relaxation oscillation has a certificate beyond its jump", "[.long][command][reference][certificate]") {
    const temporary_folder folder;
    const auto done = run_libration({"reference", "--problem", "x' = z; z' = 1e6*((1 - x^2)*z - x); x(0) = 2; z(0) = 0",
                                     "--time", "1", "--digits", "20", "--certificate", "a.cert"},
                                    folder.path());
    INFO(done.err);
    REQUIRE(done.exit_code == 0);
    CHECK(std::filesystem::file_size(folder.path() / "a.cert") < 40'000);
    const auto proved = checked(folder.path() / "a.cert");
    INFO(proved.out);
    CHECK(proved.exit_code == 0);
    CHECK(contains(proved.out, "x(1) lies in [-1.86364625480813388"));
}

// x = sin(t) at 1 and 2; the second value misses. check/compare.py reads the table beside the certificate.
TEST_CASE("a table is compared with the certificate of verify", "[command][verify][certificate]") {
    const temporary_folder folder;
    std::ofstream(folder.path() / "theirs.csv") << "time,x\n1,0.841471\n2,0.909397\n";
    const auto done = run_libration({"verify", "theirs.csv", "--problem", "x'' = -x; x(0) = 0; x'(0) = 1",
                                     "--tolerance", "1e-7", "--certificate", "a.cert"},
                                    folder.path());
    INFO(done.err);
    CHECK(done.exit_code == 1);
    const auto proved = checked(folder.path() / "a.cert");
    INFO(proved.out);
    CHECK(proved.exit_code == 0);
    CHECK(contains(proved.out, "x(2) lies in [0.909297426"));
    const auto compared = [&](const std::string& table, const std::string& tolerance) {
        const std::string line = "cd '" + folder.path().string() +
                                 "' && python3 -I " LIBRATION_SOURCE_DIR "/check/compare.py a.cert " + table + " " +
                                 tolerance + " >out 2>&1";
        return WEXITSTATUS(std::system(line.c_str()));
    };
    CHECK(compared("theirs.csv", "1e-7") == 1);
    CHECK(contains(text_of_file((folder.path() / "out")), "miss: x(2) = 0.909397 has an error of at least 9.96e-05"));
    CHECK(compared("theirs.csv", "1e-4") == 0);
    std::ofstream(folder.path() / "more.csv") << "time,x,v\n1,0.841471,5\n";
    CHECK(compared("more.csv", "") == 2);
    CHECK(contains(text_of_file((folder.path() / "out")), "the column v is none of x, x'"));
    std::ofstream(folder.path() / "later.csv") << "time,x\n3,0.1\n";
    CHECK(compared("later.csv", "") == 2);
}

TEST_CASE("a changed certificate is refused by the checker", "[command][reference][certificate]") {
    const temporary_folder folder;
    const auto done = run_libration(
        {"reference", "--problem", "y' = y; y(0) = 1", "--time=-1/2", "--digits", "6", "--certificate", "a.cert"},
        folder.path());
    REQUIRE(done.exit_code == 0);
    CHECK(checked(folder.path() / "a.cert").exit_code == 0);
    const std::string edit =
        "import zlib, sys; f = sys.argv[1]; t = zlib.decompress(open(f, 'rb').read()); "
        "open(f, 'wb').write(zlib.compress(t.replace(b'start 1', b'start 2')))";
    const std::string line = "python3 -c \"" + edit + "\" " + (folder.path() / "a.cert").string();
    REQUIRE(std::system(line.c_str()) == 0);
    const auto refused = checked(folder.path() / "a.cert");
    CHECK(refused.exit_code == 1);
    CHECK(contains(refused.out, "Not proved: step 1: start or joint: radius of block 1"));
}

// x = sin t has its zeros at pi and 2 pi: the one at the initial point does not count.
TEST_CASE("the events of a certificate are all that there are", "[command][reference][certificate]") {
    const temporary_folder folder;
    const auto done = run_libration({"reference", "--problem", "x'' = -x; x(0) = 0; x'(0) = 1", "--until", "x = 0",
                                     "--count", "2", "--digits", "10", "--certificate", "a.cert"},
                                    folder.path());
    REQUIRE(done.exit_code == 0);
    const auto proved = checked(folder.path() / "a.cert");
    INFO(proved.out);
    CHECK(proved.exit_code == 0);
    CHECK(contains(proved.out, "x = 0 from 0, excluded, to 6.283185307"));
    CHECK(contains(proved.out, "only at #1, #2"));
    CHECK(contains(proved.out, "#1 lies in [3.14159265"));
    CHECK(contains(proved.out, "x'(#2) lies in [0.99999999"));
    // Those that rise are every second one; the others are listed, or the checker would not see that they are no more.
    const auto rising = run_libration({"reference", "--problem", "x'' = -x; x(0) = 0; x'(0) = 1", "--until", "x = 0",
                                       "--crossing", "up", "--digits", "6", "--certificate", "a.cert"},
                                      folder.path());
    REQUIRE(rising.exit_code == 0);
    const auto second = checked(folder.path() / "a.cert");
    CHECK(second.exit_code == 0);
    CHECK(contains(second.out, "x'(#2) lies in [0.9999"));
    CHECK_FALSE(contains(second.out, "x'(#1)"));
}

// libration-check is built beside the command.
TEST_CASE("with --check the checker proves the certificate", "[command][reference][find][certificate]") {
    const temporary_folder folder;
    const std::string orbit = "x' = x - y - x*(x^2 + y^2); y' = x + y - y*(x^2 + y^2); x(0) = 1; y(0) = 0";
    for (const words& line : {words{"reference", "--problem", "y' = -y; y(0) = 1", "--time", "1"},
                              words{"reference", "--problem", "x'' = -x; x(0) = 0; x'(0) = 1", "--until", "x = 0"},
                              words{"find", "--problem", orbit, "--periodic"}}) {
        const auto done =
            run_libration(line + words{"--digits", "6", "--check", "--certificate", "a.cert"}, folder.path());
        INFO(done.err);
        CHECK(done.exit_code == 0);
        CHECK(contains(done.err, "libration-check proves the certificate 'a.cert', in integers"));
    }
}

TEST_CASE("a certificate that the checker rejects is an error", "[command][certificate]") {
    const temporary_folder folder;
    const auto file = folder.path() / "a.cert";
    std::ofstream(file) << "no certificate";
    CHECK_THROWS_WITH(check_certificate(file.string()), Catch::Contains("is rejected by libration-check: Not proved"));
}

TEST_CASE("a certificate without one of its events is refused by the checker", "[command][reference][certificate]") {
    const temporary_folder folder;
    const auto done = run_libration({"reference", "--problem", "y' = 2 - t - y/9; y(0) = -1", "--until", "y*t = 1/2",
                                     "--count", "2", "--digits", "6", "--certificate", "a.cert"},
                                    folder.path());
    REQUIRE(done.exit_code == 0);
    CHECK(checked(folder.path() / "a.cert").exit_code == 0);
    const std::string edit =
        "import zlib, sys, re; f = sys.argv[1]; t = zlib.decompress(open(f, 'rb').read()).decode(); "
        "t = re.sub(r'\\nclaim #1.*|\\nzero.*(?=\\nzero)', '', t).replace('#2', '#1'); "
        "open(f, 'wb').write(zlib.compress(t.encode()))";
    const std::string line = "python3 -c \"" + edit + "\" " + (folder.path() / "a.cert").string();
    REQUIRE(std::system(line.c_str()) == 0);
    const auto refused = checked(folder.path() / "a.cert");
    CHECK(refused.exit_code == 1);
    CHECK(contains(refused.out, "the sign of the condition in its interval 1"));
}

// y = s sin t with y(1) = 1: s = 1/sin 1.
TEST_CASE("a root has a certificate of its solution and of the derivatives near it", "[command][find][certificate]") {
    const temporary_folder folder;
    const words asked{"find", "--problem", "y'' = -y; y(0) = 0; y'(0) = s; s = 1", "--unknown", "s"};
    const words certified{"--digits", "8", "--certificate", "a.cert"};
    const auto done = run_libration(asked + words{"--such-that", "y(1) = 1"} + certified, folder.path());
    INFO(done.err);
    REQUIRE(done.exit_code == 0);
    const auto proved = checked(folder.path() / "a.cert");
    INFO(proved.out);
    CHECK(proved.exit_code == 0);
    CHECK(contains(proved.out, "For exactly one choice of y'(0) in [118839"));
    CHECK(contains(proved.out, "y(1) = 1."));
    // The parameter of an equation, and functions of a start that is an interval.
    for (const auto& [problem, unknown] : {std::pair("y'' = -k*sin(y); y(0) = 1; y'(0) = 0; k = 1", "k"),
                                           std::pair("y'' = -exp(y)/(2 + cos(y)); y(0) = 0; y'(0) = 1", "y(0)")}) {
        const auto other = run_libration(
            words{"find", "--problem", problem, "--unknown", unknown, "--such-that", "y(1/2) = 3/4"} + certified,
            folder.path());
        INFO(other.err);
        REQUIRE(other.exit_code == 0);
        CHECK(checked(folder.path() / "a.cert").exit_code == 0);
    }
    const auto several = run_libration(asked + words{"--such-that", "y(1) + y'(1) = 1"} + certified, folder.path());
    CHECK(several.exit_code == 2);
    CHECK(contains(several.err, "roots of conditions such as y(1) = 1/2"));
    check_refused(asked + words{"--such-that", "y(1) = 1", "--guess", "s=1,2"} + certified,
                  {"--certificate", "several guesses"}, folder);
}

// x = cos(t - 1).
TEST_CASE("a periodic orbit has a certificate", "[command][find][certificate]") {
    const temporary_folder folder;
    const auto done = run_libration(
        {"find", "--problem", "van_der_pol", "--periodic", "--digits", "8", "--certificate", "a.cert"}, folder.path());
    INFO(done.err);
    REQUIRE(done.exit_code == 0);
    const auto proved = checked(folder.path() / "a.cert");
    INFO(proved.out);
    CHECK(proved.exit_code == 0);
    CHECK(contains(proved.out, "t in [6.66328685"));
    CHECK(contains(proved.out, "x(t) = x(0),\n    x'(t) = x'(0)."));
    const std::string edit =
        "import zlib, sys; f = sys.argv[1]; t = zlib.decompress(open(f, 'rb').read()).decode(); "
        "t = t.replace('root x start', 'root x 2'); open(f, 'wb').write(zlib.compress(t.encode()))";
    const std::string line = "python3 -c \"" + edit + "\" " + (folder.path() / "a.cert").string();
    REQUIRE(std::system(line.c_str()) == 0);
    const auto refused = checked(folder.path() / "a.cert");
    CHECK(refused.exit_code == 1);
    CHECK(contains(refused.out, "the condition for a root"));
}

// The values are those of the closed form.
TEST_CASE("a certificate with too many steps is refused before they are taken", "[command][reference][certificate]") {
    const temporary_folder folder;
    const auto done = run_libration(
        {"reference", "--problem", "pendulum", "--time", "1e12", "--digits", "10", "--certificate", "a.cert"},
        folder.path());
    CHECK(done.exit_code == 2);
    CHECK(contains(done.out, "-1.289775660"));
    CHECK(contains(done.err, "--certificate 'a.cert' contains at most 99999 steps"));
    CHECK(contains(done.err, "choose an earlier time, or leave it out and compare two proofs with --check"));
}

TEST_CASE("problems without a certificate are refused", "[command][reference][certificate]") {
    const temporary_folder folder;
    const words certified{"--digits", "5", "--certificate", "a.cert"};
    check_refused({"reference", "--problem", "lorenz", "--time", "1000", "--certificate", "missing/a.cert"},
                  {"--certificate 'missing/a.cert'", "does not exist"}, folder);
    check_refused(words{"reference", "--problem", "y'=k*y; y(0)=1", "--set", "k=1,2", "--time", "1"} + certified,
                  {"--certificate", "--set chooses several"}, folder);
    check_refused(words{"reference", "--energy", "1", "--time", "1"} + certified, {"--certificate", "--problem"},
                  folder);
    check_refused(words{"reference", "--problem", "lorenz", "--until", "x = 0", "--from-start"} + certified,
                  {"--certificate", "--from-start"}, folder);
    const auto irrational = run_libration(
        words{"reference", "--problem", "y' = 1; y(0) = 0", "--until", "y = pi"} + certified, folder.path());
    CHECK(irrational.exit_code == 2);
    CHECK(contains(irrational.err, "contains only fractions as constants"));
}

TEST_CASE("the interval of a decimal is one unit of its last digit on each side", "[certificate]") {
    const auto in = ode::within_one_unit("-1.250", 4);
    CHECK(in.lower == "-1.251");
    CHECK(in.upper == "-1.249");
    CHECK(in.low == rational(-1251, 1000));
    const auto small = ode::within_one_unit("2.50e-8", 3);
    CHECK(small.high == rational(251) / pow(integer(10), 10));
    CHECK(small.upper == "2.51e-8");
    CHECK(ode::within_one_unit("9.99e12", 3).high == rational(integer(10) * pow(integer(10), 12)));
    CHECK(ode::within_one_unit("0", 3).low == rational(-1, 1000));
}

}  // namespace command_certificate_test
