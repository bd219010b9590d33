// The numbers of `libration trajectory` compared with the reference table, and its errors with a true value computed
// here.
#include <sys/resource.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "command/printed.hpp"
#include "command/reference_motion.hpp"
#include "libration/pendulum/bounds.hpp"
#include "libration/pendulum/separatrix_sum.hpp"
#include "libration/pendulum/uniform_resummation.hpp"

namespace command_trajectory_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

std::vector<table_row> trajectory_of(const words& options) { return rows_of(words{"trajectory"} + options); }

// Processor time of one run of the program.
double processor_seconds_of(const words& given) {
    const auto spent = [] {
        rusage used{};
        ::getrusage(RUSAGE_CHILDREN, &used);
        const auto seconds = [](const timeval& t) {
            return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) / 1'000'000;
        };
        return seconds(used.ru_utime) + seconds(used.ru_stime);
    };
    const double before = spent();
    output_of(given);
    return spent() - before;
}

void check_state(const table_row& printed, const table_row& expected) {
    INFO("t = " << expected.at("time"));
    CHECK(printed.at("time_typed") == expected.at("time"));
    CHECK_THAT(printed.at("theta"), right_to_the_last_digit(expected.at("theta")));
    CHECK_THAT(printed.at("omega"), right_to_the_last_digit(expected.at("omega")));
}

// Each printed error is |theta - truth| of the printed theta, with the true value by the sum over separatrix solutions:
// to the six digits printed and the rounding of theta. Returns the largest one.
mpfr check_errors(const std::vector<table_row>& rows, const motion& m) {
    const precision_scope scope(70);
    const separatrix_sum<mpfr> truth(m);
    mpfr largest(0);
    for (const table_row& row : rows) {
        INFO("t = " << row.at("time") << ", theta " << row.at("theta") << ", error " << row.at("error"));
        const mpfr error = abs(number_of(row.at("theta")) - truth(read_exact(row.at("time_typed"))).value);
        CHECK(abs(error - number_of(row.at("error"))) <= last_place(row.at("error")) + last_place(row.at("theta")));
        largest = error > largest ? error : largest;
    }
    return largest;
}

}  // namespace

TEST_CASE("every state of the reference table is printed to 50 right digits", "[command][trajectory]") {
    std::size_t states = 0;
    for (const reference_motion& motion : reference_motions()) {
        INFO(command_line(motion.options));
        const auto rows = trajectory_of(motion.options + words{motion.times(), "--digits", "50"});
        REQUIRE(rows.size() == motion.rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            check_state(rows[i], motion.rows[i]);
            ++states;
        }
    }
    CHECK(states == 250);
}

TEST_CASE("from (2.5, -0.3) 60 digits are right after a million units of time back and 1e12 on",
          "[command][trajectory]") {
    // Computed by Motion('', '', '2.5', '-0.3', '').state(time) of tests/reference/generate.py at 450 and 560 digits.
    const std::vector<table_row> expected{
        {{"time", "-1e6"},
         {"theta", "2.56832318081403876605483889948819920623602454250553891949327"},
         {"omega", "-0.109648978652718236460957523701493736594293295578092375383969"}},
        {{"time", "0"}, {"theta", "2.5"}, {"omega", "-0.3"}},
        {{"time", "1e12"},
         {"theta", "-1.28977566036974826206862501873454425528011995252167718066505"},
         {"omega", "-1.49898634884458713628342549286887911733377680699932312698501"}},
        {{"time", "T/4"},
         {"theta", "-0.991527648484907468634267310090394370456277310277234398118285"},
         {"omega", "-1.66946439468732990645674263903525647872425123839236689559329"}},
        {{"time", "T"}, {"theta", "2.5"}, {"omega", "-0.3"}},
        {{"time", "-3T/4"},
         {"theta", "-0.991527648484907468634267310090394370456277310277234398118285"},
         {"omega", "-1.66946439468732990645674263903525647872425123839236689559329"}}};
    const words state{"--theta0", "2.5", "--omega0", "-0.3", "--method", "exact"};
    const auto rows = trajectory_of(state + words{"--times=-1e6,0,1e12,T/4,T,-3T/4", "--scalar", "mpfr:60"});
    REQUIRE(rows.size() == expected.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        CHECK(rows[i].at("time_typed") == expected[i].at("time"));
        for (const std::string name : {"theta", "omega"}) {
            const std::string& printed = rows[i].at(name);
            INFO(name << " at " << rows[i].at("time"));
            CHECK(significant_digits(printed) == 60);
            const precision_scope scope(100);
            const std::string& right = expected[i].at(name);
            const mpfr allowed = last_place(printed) * (right.size() > 10 ? 2 : 1);  // both are rounded
            CHECK(abs(number_of(printed) - number_of(right)) <= allowed);
        }
    }
}

TEST_CASE("released from rest the pendulum passes the bottom at exactly T/4", "[command][trajectory]") {
    for (const words& motion : {words{"--energy", "1.71"}, words{"--theta0", "90deg", "--omega0", "0"},
                                words{"--theta0", "-2.5", "--omega0", "0"}, words{"--gap", "1e-40"}}) {
        INFO(command_line(motion));
        const words times{"--times=T/4,-3T/4,3T/4,1000001T/4,T/2,0"};
        for (const words& method : {words{"--method", "exact"}, words{"--method", "resummed", "--order", "7"}}) {
            const auto rows = trajectory_of(motion + times + method);
            REQUIRE(rows.size() == 6);
            for (std::size_t i = 0; i < 4; ++i) {
                CHECK(rows[i].at("theta") == "0");
            }
            CHECK(rows[4].at("omega") == "0");
            CHECK(rows[5].at("omega") == "0");
        }
    }
}

TEST_CASE("a range of multiples of T prints what its list prints, the 0 without a unit", "[command][trajectory]") {
    const words line{"trajectory", "--energy", "1.71", "--digits", "20"};
    CHECK(output_of(line + words{"--times=-T/2:T/2:5"}) ==
          output_of(line + words{"--times=-0.5T,-0.25T,0,0.25T,0.5T"}));
}

TEST_CASE("the resummation at 401 times is as far from the motion as it says, and within its bound",
          "[command][trajectory]") {
    struct shown {
        std::string energy;
        std::string direction;
        int sign;
    };
    for (const shown& s : {shown{"1.71", "+", 1}, shown{"2.02", "+", 1}, shown{"2.02", "-", -1}}) {
        INFO("E = " << s.energy << " " << s.direction);
        const auto rows = trajectory_of({"--energy", s.energy, "--direction", s.direction, "--method", "resummed",
                                         "--order", "20", "--times", "0:20:401"});
        REQUIRE(rows.size() == 401);
        CHECK(rows.front().at("time") == "0");
        CHECK(rows[7].at("time") == "0.35");
        CHECK(rows.back().at("time") == "20");
        const motion m = motion::of_energy(read_exact(s.energy).coefficient, s.sign);
        const precision_scope scope(50);
        const mpfr largest = check_errors(rows, m);
        const mpfr bound = top_bounds<mpfr>::of(energy_level_of<mpfr>(m)).resummation_norm(20);
        CHECK(largest <= bound);
        CHECK(largest > bound / 10'000);  // an error of that order is visible
    }
}

TEST_CASE("the series and the Runge-Kutta solution are as far from the motion as they say", "[command][trajectory]") {
    const words times{"--times=-3:20:24"};
    for (const std::string energy : {"0.5", "1.71", "2.02", "4"}) {
        INFO("E = " << energy);
        const motion m = motion::of_energy(read_exact(energy).coefficient);
        const words motion_words{"--energy", energy};
        const precision_scope scope(50);
        const mpfr bound = top_bounds<mpfr>::of(energy_level_of<mpfr>(m)).series_norm(10);
        const mpfr series =
            check_errors(trajectory_of(motion_words + times + words{"--method", "series", "--order", "10"}), m);
        CHECK(series <= bound);
        CHECK(series > bound / 10'000);
        const mpfr rk4 = check_errors(
            trajectory_of(motion_words + times + words{"--method", "rk4", "--step", "1e-2", "--digits", "20"}), m);
        CHECK(rk4 < mpfr("1e-6"));  // of the order step^4 times the duration, 1e-8 * 20
        CHECK(rk4 > mpfr("1e-12"));
    }
}

TEST_CASE("the uniform resummation is within theorem U of the motion at every energy", "[command][trajectory]") {
    const words method{"--method", "uniform", "--order", "12", "--times=-3:20:24"};
    for (const words& energy : {words{"--energy", "1e-3"}, words{"--energy", "1.71"}, words{"--energy", "2.02"},
                                words{"--gap", "1e-12"}, words{"--gap=-1e-12"}, words{"--gap", "1e-20"}}) {
        INFO(command_line(energy));
        const bool by_gap = energy.front().starts_with("--gap");
        const std::string number = energy.size() == 2 ? energy.back() : energy.front().substr(6);
        const rational given = read_exact(number).coefficient;
        const motion m = motion::of_energy(by_gap ? rational(2 - given) : given);
        const precision_scope scope(50);
        const mpfr error = check_errors(trajectory_of(energy + method), m);
        CHECK(error <= uniform_bounds<mpfr>{parity_from_top(m.regime()), 1}.norm(12));
        CHECK(error > mpfr("1e-30"));
    }
}

TEST_CASE("in double the uniform resummation with 16 coefficients errs by its rounding next to E = 2",
          "[command][trajectory]") {
    for (const std::string gap : {"1e-12", "1e-40"}) {
        const auto rows = trajectory_of(
            {"--gap", gap, "--method", "uniform", "--order", "32", "--times", "0:14:601", "--scalar", "double"});
        REQUIRE(rows.size() == 601);
        const precision_scope scope(30);
        for (const table_row& row : rows) {
            INFO("t = " << row.at("time") << ", theta " << row.at("theta"));
            CHECK(number_of(row.at("error")) < mpfr("1e-15"));  // theta is below pi, whose last place is 4.4e-16
        }
    }
}

TEST_CASE("from a state the approximations follow the shifted clock", "[command][trajectory]") {
    const motion m = motion::of_state(read_exact("2.5"), read_exact("-0.3"));
    const words state{"--theta0", "2.5", "--omega0", "-0.3", "--times=-7:7:15"};
    check_errors(trajectory_of(state + words{"--method", "series", "--order", "12"}), m);
    check_errors(trajectory_of(state + words{"--method", "resummed", "--order", "12"}), m);
    check_errors(trajectory_of(state + words{"--method", "uniform", "--order", "12"}), m);
    check_errors(trajectory_of(state + words{"--method", "rk4", "--step", "1/50"}), m);
}

TEST_CASE("in double the exact motion is right to a few units, after a million periods too", "[command][trajectory]") {
    const precision_scope scope(50);
    const reference_motion motion = reference_motion_of("1.71");
    const auto rows = trajectory_of(motion.options + words{motion.times(), "--scalar", "double"});
    REQUIRE(rows.size() == motion.rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        INFO("t = " << rows[i].at("time"));
        const mpfr error = abs(number_of(rows[i].at("theta")) - number_of(motion.rows[i].at("theta")));
        // theta is below 2.4; the elliptic functions and the arctangent are a few units in the last place each.
        CHECK(error <= mpfr("2.4") * ldexp(mpfr(1), -52) * 8);
        CHECK(abs(error - number_of(rows[i].at("error"))) <=
              last_place(rows[i].at("error")) + last_place(rows[i].at("theta")));
    }
}

TEST_CASE("no rounding scalar takes longer than the proof of as many digits", "[command][trajectory]") {
    // Processor times, the least of three, because the machine is shared. Before, mpfr took 23 times as long and double
    // 5 times; now they take as long, or less, up to the noise of 30 ms.
    const words order{"trajectory", "--energy", "1.71", "--times", "0:20:2001", "--jobs", "1", "--scalar"};
    const auto seconds = [&](const std::string& scalar) {
        double least = 60;
        for (int i = 0; i < 3; ++i) {
            least = std::min(least, processor_seconds_of(order + words{scalar}));
        }
        return least;
    };
    const double proof = seconds("ball:50");
    for (const std::string scalar : {"double", "long-double", "mpfr:50"}) {
        INFO(scalar);
        CHECK(seconds(scalar) < 2 * proof);
    }
}

TEST_CASE("the bytes of a trajectory do not depend on the number of threads", "[command][trajectory]") {
    for (const std::string scalar : {"double", "mpfr:30"}) {
        const words order{"trajectory", "--theta0", "2.5",      "--omega0", "-0.3",
                          "--times",    "0:20:300", "--scalar", scalar};
        CHECK(output_of(order + words{"--jobs", "1"}) == output_of(order + words{"--jobs", "3"}));
    }
}

TEST_CASE("at whole periods theta is the start again, and its error is 0", "[command][trajectory]") {
    for (const std::string start : {"2.5", "0.1"}) {
        for (const std::string scalar : {"mpfr:40", "ball:40"}) {
            const auto rows =
                trajectory_of({"--theta0", start, "--omega0", "0.2", "--times", "0,T,-3T", "--scalar", scalar});
            for (const table_row& row : rows) {
                CHECK(number_of(row.at("theta")) == number_of(start));
                CHECK(row.at("error") == "0");
            }
        }
    }
}

TEST_CASE("omega is 0 where the pendulum turns and nowhere else", "[command][trajectory]") {
    // On the separatrix omega = 2/cosh t, log10 of it (log 4 - 10^9)/log 10 = -434294481.30...: 4.998..e-434294482.
    const auto far = trajectory_of({"--theta0", "0", "--omega0", "2", "--times", "1e9", "--scalar", "mpfr:20"});
    const auto proved = trajectory_of({"--theta0", "0", "--omega0", "2", "--times", "1e9", "--scalar", "ball:20"});
    CHECK(far.at(0).at("omega").starts_with("4.998"));
    CHECK(far.at(0).at("omega") == proved.at(0).at("omega"));
    // As typed, at the initial time and after a period; exactly 0 if it is released from rest.
    for (const std::string omega0 : {"-1e-106", "3e-300"}) {
        const auto slow =
            trajectory_of({"--theta0=-1.455078119", "--omega0=" + omega0, "--times", "0,T", "--scalar", "mpfr:30"});
        CHECK_THAT(slow.at(0).at("omega"), right_to_the_last_digit(omega0));
        CHECK_THAT(slow.at(1).at("omega"), right_to_the_last_digit(omega0));
    }
    const auto rest = trajectory_of({"--theta0", "1", "--omega0", "0", "--times", "0,T/2,1", "--scalar", "mpfr:30"});
    CHECK(rest.at(0).at("omega") == "0");
    CHECK(rest.at(1).at("omega") == "0");
    CHECK(rest.at(2).at("omega") != "0");
}

TEST_CASE("a time without an answer loses no other", "[command][trajectory]") {
    for (const std::string scalar : {"ball:20", "mpfr:20"}) {
        const finished_process done = run_libration({"trajectory", "--theta0", "0", "--omega0", "2", "--times",
                                                     "1e20,1", "--scalar", scalar, "--format", "csv"});
        INFO(done.err);
        CHECK(done.exit_code == 1);
        CHECK(done.err.find("no state at '1e20'") != std::string::npos);
        const auto lines = lines_of(done.out);
        REQUIRE(lines.size() == 3);
        CHECK(lines[1] == "1e20,,,,1e20");
        // 2 gd(1) and 2/cosh 1 [DLMF 4.23.39].
        CHECK(lines[2].starts_with("1,1.7315389664"));
        CHECK(lines[2].find(",1.2961085473") != std::string::npos);
    }
}

}  // namespace command_trajectory_test
