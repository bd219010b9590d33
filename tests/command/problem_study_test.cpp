// Studies, verify and table of any equation on the command line: files, axes, shards, failures and bad input.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command/printed.hpp"
#include "command/refusal.hpp"

namespace command_problem_study_test {

using namespace libration;
using namespace libration::tests;

TEST_CASE("a study of an equation writes NAME-P with the text of the equation and figures",
          "[command][problem][study]") {
    const temporary_folder folder;
    const auto done = run_libration({"study", "error_norm", "--problem", "blasius", "--times", "0:3:7", "--orders",
                                     "5:20:4", "--set", "k=1/3,1", "--out", "out"},
                                    folder.path());
    INFO(done.err);
    REQUIRE(done.exit_code == 0);
    CHECK(lines_of(done.err) == words{"libration: wrote out/error_norm-blasius"});
    const auto own = folder.path() / "out" / "error_norm-blasius";
    for (const std::string ending : {".csv", ".json", ".svg", ".pdf", ".png", ".tex", ".journal"}) {
        CHECK(std::filesystem::exists(own / ("error_norm-blasius" + ending)));
    }
    const auto json = nlohmann::json::parse(text_of_file(own / "error_norm-blasius.json"));
    CHECK(json.at("command") ==
          "libration study error_norm --problem blasius --set k=1/3,1 --times 0:3:7 --orders 5:20:4");
    CHECK(json.at("problem").get<std::string>().find("f''' + f*f''/2 = 0") != std::string::npos);
    const auto rows = csv_rows(text_of_file(own / "error_norm-blasius.csv"));
    REQUIRE(rows.size() == 40);  // of five methods
    CHECK(rows.front().at("k_typed") == "1/3");
    CHECK(rows.front().at("unknown") == "f");
    CHECK(text_of_file(own / "error_norm-blasius.svg").find("k = 0.333333") != std::string::npos);
    std::filesystem::remove(own / "error_norm-blasius.svg");
    CHECK(run_libration({"figure", "error_norm-blasius", "--out", "out"}, folder.path()).exit_code == 0);
    CHECK(std::filesystem::exists(own / "error_norm-blasius.svg"));
}

TEST_CASE("the norms of an equation in several arithmetics are in one run and one figure",
          "[command][problem][study]") {
    const temporary_folder folder;
    // y = exp(t): the partial sum of order 4 is 65/24 at t = 1, where the error is largest.
    const auto done = run_libration({"study", "error_norm", "--problem", "y' = y; y(0) = 1", "--times", "0:1:5",
                                     "--orders", "4,20", "--scalar", "double,mpfr:30,quad", "--out", "out"},
                                    folder.path());
    INFO(done.err);
    REQUIRE(done.exit_code == 0);
    const auto own = folder.path() / "out" / "error_norm-typed";
    CHECK(std::filesystem::exists(own / "error_norm-typed.svg"));
    const std::string figure = text_of_file(own / "error_norm-typed.svg");
    CHECK(figure.find("with 30 digits") != std::string::npos);
    const precision_scope scope(40);
    const mpfr truth = exp(mpfr(1)) - mpfr(65) / 24;
    struct arithmetic {
        std::string suffix, name, tolerance;
    };
    for (const auto& [suffix, name, tolerance] :
         {arithmetic{"", "mpfr:30", "1e-28"}, {"_quad", "quad", "1e-32"}, {"_double", "double", "1e-15"}}) {
        INFO(name);
        const auto rows = csv_rows(text_of_file(own / ("error_norm-typed" + suffix + ".csv")));
        CHECK(rows.front().at("method") == "series");
        CHECK(rows.front().at("scalar") == name);
        CHECK(abs(number_of(rows.front().at("norm")) - truth) < number_of(tolerance));
        CHECK((suffix.empty() || figure.find("in " + name) != std::string::npos));
    }
    check_refused({"study", "error_norm", "--problem", "y'' = y; y(0) = 1; y(inf) = 0", "--scalar", "mpfr:20,mpfr:30"},
                  {"--scalar 'mpfr:30,mpfr:20' is a list", "at a time: write mpfr:30"});
}

TEST_CASE("shards of a study of a typed equation make the tables of the whole run", "[command][problem][journal]") {
    const words order{"study", "radius_map", "--problem", "y' = y^2 + c; y(0) = 0; c = 1",
                      "--set", "c=1,2,4",    "--orders",  "20,30"};
    const temporary_folder folder;
    REQUIRE(run_libration(order + words{"--out", "whole"}, folder.path()).exit_code == 0);
    for (const std::string which : {"1", "2"}) {
        const auto done = run_libration(order + words{"--shard", which + "/2", "--out", "s" + which}, folder.path());
        INFO(done.err);
        REQUIRE(done.exit_code == 0);
    }
    const auto merged = run_libration({"journal", "merge", "s1", "s2", "--out", "merged"}, folder.path());
    INFO(merged.err);
    REQUIRE(merged.exit_code == 0);
    const auto table = [&](const std::string& run) {
        return text_of_file(folder.path() / run / "radius_map-typed" / "radius_map-typed.csv");
    };
    CHECK(table("merged") == table("whole"));
    CHECK(run_libration({"journal", "merged", "--check", "100%"}, folder.path()).exit_code == 0);
    // y = sqrt(c) tan(sqrt(c) t): the radius is pi/(2 sqrt(c)).
    const precision_scope scope(40);
    for (const table_row& row : csv_rows(table("whole"))) {
        const mpfr truth = pi<mpfr>() / (2 * sqrt(number_of(row.at("c"))));
        CHECK(abs(number_of(row.at("radius")) - truth) <= number_of(row.at("uncertainty")) + truth * mpfr("1e-28"));
    }
}

TEST_CASE("another equation has other cells in the same journal", "[command][problem][journal]") {
    const temporary_folder folder;
    const auto radius_of = [&](const std::string& problem) {
        const auto done = run_libration({"study", "radius_map", "--problem", problem, "--orders", "20", "--out", "out"},
                                        folder.path());
        INFO(done.err);
        REQUIRE(done.exit_code == 0);
        return number_of(csv_rows(text_of_file(folder.path() / "out" / "radius_map-typed" / "radius_map-typed.csv"))
                             .front()
                             .at("radius"));
    };
    CHECK(abs(radius_of("y' = y^2; y(0) = 1") - 1) < mpfr("1e-20"));
    CHECK(abs(radius_of("y' = y^2; y(0) = 1/2") - 2) < mpfr("1e-20"));
}

TEST_CASE("a parameter without a solution is said and the others stand", "[command][problem][study]") {
    const auto done = run_libration(
        {"study", "radius_map", "--problem", "y' = sqrt(y); y(0) = c; c = 1", "--set", "c=-1,1", "--orders", "20"});
    CHECK(done.exit_code == 1);
    CHECK(lines_of(done.out).size() == 2);
    CHECK(done.err.find("c=-1 order=20") != std::string::npos);
}

TEST_CASE("what a study of an equation cannot be asked is refused", "[command][problem][study][bad input]") {
    const words base{"study", "error_norm", "--problem", "blasius", "--times", "0:1:3", "--orders", "5"};
    check_refused(base + words{"--set", "kk=1"}, {"--set", "kk"});
    check_refused(base + words{"--set", "k"}, {"--set", "'k'", "k=1/3"});
    check_refused(base + words{"--set", "k=1", "--set", "k=2"}, {"--set", "twice"});
    check_refused(base + words{"--set", "k=one"}, {"--set k", "one"});
    check_refused(base + words{"--set", "k=T"}, {"--set k", "period"});
    check_refused(base + words{"--energies", "1"}, {"--energies"});
    check_refused(base + words{"--unknowns", "g"}, {"--unknowns", "'g'"});
    check_refused({"study", "error_norm", "--problem", "blasius"}, {"--times"});
    check_refused({"study", "error_norm", "--problem", "blasus", "--times", "0:1:3"}, {"--problem", "blasius"});
    check_refused({"study", "surface", "--problem", "blasius"}, {"--problem", "surface", "error_norm", "radius_map"});
    check_refused({"study", "error_norm", "--set", "k=1"}, {"--set", "--problem"});
    check_refused({"study", "coefficients"}, {"coefficients", "--problem"});
    check_refused({"study", "radius_map", "--problem", "y' = y; y(0) = 1", "--orders", "2"}, {"--orders", "2"});
}

// sin(t)/t for n = 1, which is even; Thomas and Fermi's solution is proved in powers of sqrt(t), and that of Lane and Emden
// for n = 3/2 is not.
TEST_CASE("verify proves from regular singular starts, of powers too, and after them alone",
          "[command][problem][verify]") {
    const temporary_folder folder;
    std::ofstream(folder.path() / "file.csv") << "t,y\n0,1\n1,0.84147098480789650665\n2,0.4546487134128408477\n";
    const words verify{"verify", "file.csv", "--problem"};
    const auto proved = run_libration(verify + words{"lane_emden", "--set", "n=1"}, folder.path());
    INFO(proved.err);
    CHECK(proved.exit_code == 0);
    CHECK(proved.err.find("not proved") == std::string::npos);
    std::ofstream(folder.path() / "file.csv") << "t,y\n-1,0.84147098480789650665\n";
    const auto before = run_libration(verify + words{"lane_emden", "--set", "n=1"}, folder.path());
    CHECK(before.exit_code == 0);
    CHECK(before.err.find("1 rows are compared with values on which two computations agree") != std::string::npos);
    std::ofstream(folder.path() / "file.csv") << "t,y\n1,0.424\n";
    const auto atom = run_libration(verify + words{"thomas_fermi", "--tolerance", "1e-3"}, folder.path());
    CHECK(atom.exit_code == 0);
    CHECK(atom.err.find("not proved") == std::string::npos);
    std::ofstream(folder.path() / "file.csv") << "t,y\n1,0.845\n";
    const auto agreed =
        run_libration(verify + words{"lane_emden", "--set", "n=3/2", "--tolerance", "1e-3"}, folder.path());
    CHECK(agreed.exit_code == 0);
    CHECK(agreed.err.find("not proved") == std::string::npos);
}

TEST_CASE("verify judges columns of a problem against proved values", "[command][problem][verify]") {
    const temporary_folder folder;
    std::ofstream(folder.path() / "file.csv") << "t,y,y'\n0,0,1\n1,0.8414709848,0.5403023059\n"
                                                 "-2,-0.90929742682568,-0.4161468365\n1,0.8414709850,0.54030\n";
    const auto done = run_libration(
        {"verify", "file.csv", "--problem", "y'' = -w^2*y; y(0) = 0; y'(0) = 1; w = 2", "--set", "w=1"}, folder.path());
    INFO(done.err);
    CHECK(done.exit_code == 1);
    CHECK(lines_of(done.out).front() ==
          "t,y,y',reference,error,correct_digits,verdict,condition,y'_reference,y'_error,"
          "y'_correct_digits");
    const auto rows = csv_rows(done.out);
    REQUIRE(rows.size() == 4);
    CHECK(rows[0].at("verdict") == "ok");
    CHECK(rows[1].at("verdict") == "ok");
    CHECK(rows[1].at("reference").starts_with("0.84147098480789650"));
    CHECK(rows[1].at("condition") == "2.22");  // of y': cos 1 by its initial value, sin 1 by w and sin 1 by time
    CHECK(rows[2].at("verdict") == "ok");
    CHECK(rows[3].at("verdict") == "miss");
    check_refused({"verify", "file.csv", "--problem", "y' = y; z(0) = 1", "--energy", "1"}, {"--energy"}, folder);
    check_refused({"verify", "file.csv", "--problem", "z' = z; z(0) = 1"}, {"'y'", "'z'"}, folder);
    check_refused({"verify", "file.csv", "--set", "w=1"}, {"--set", "--problem"}, folder);
}

TEST_CASE("a table of a problem is written in every format", "[command][problem][table]") {
    const words line{"table", "--problem", "y'' = -y; y(0) = 0; y'(0) = 1", "--times", "0,1/3,2", "--digits", "25"};
    const auto rows = csv_rows(output_of(line));
    REQUIRE(rows.size() == 3);
    CHECK(rows[0].at("y") == "0");
    const precision_scope scope(40);
    CHECK(abs(number_of(rows[1].at("y")) - sin(mpfr(mpfr(1) / 3))) <= last_place(rows[1].at("y")));
    CHECK(rows[1].at("time_typed") == "1/3");
    CHECK(rows[1].at("rigour") == "proved");
    for (const std::string format : {"text", "json", "latex", "cpp", "ipp", "numpy", "c", "fortran", "julia", "pari"}) {
        INFO(format);
        const std::string text = output_of(line + words{"--format", format});
        // LaTeX groups the digits.
        CHECK((format == "latex" || text.find(rows[2].at("y")) != std::string::npos));
        const bool has_comment = format != "text" && format != "json" && format != "latex";
        CHECK(
            (!has_comment || (text.find("proved") != std::string::npos && text.find("y'' = -y") != std::string::npos)));
    }
    CHECK(output_of(line + words{"--format", "cpp"}).find("y_d1") != std::string::npos);
    check_refused({"table", "--problem", "blasius"}, {"--times"});
    check_refused({"table"}, {"table"});
    check_refused(line + words{"--energies", "1"}, {"--energies"});
    check_refused({"table", "sn", "--problem", "blasius", "--times", "1"}, {"--problem", "sn"});
    check_refused({"table", "--problem", "y' = y^2; y(0) = 1", "--times", "2"}, {"--times", "2"});
}

// Results of SciPy 1.10.1: solve_ivp(..., method="DOP853", rtol=1e-12, atol=1e-14, t_eval=...), by numpy.savetxt with
// fmt="%.17g". Chaos and the passages by the moon amplify roundings by the condition number, and the errors of steps at
// this tolerance by at most a thousand times as much.
TEST_CASE("verify judges the output of SciPy and says the condition number of each miss",
          "[command][verify][problem]") {
    const temporary_folder folder;
    const auto judged = [&](const std::string& rows, const words& options) {
        std::ofstream(folder.path() / "scipy.txt") << rows;
        return run_libration(words{"verify", "scipy.txt", "--tolerance", "1e-11"} + options, folder.path());
    };
    const auto lorenz = judged(
        "# t x y z\n"
        "1 -9.408450567055759 -9.0961990711899841 28.581627624389252\n"
        "5 -6.9745704726802966 -7.0210608908107268 25.119616492127314\n",
        {"--problem", "lorenz"});
    CHECK(lorenz.exit_code == 1);
    const auto rows = csv_rows(lorenz.out);
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].at("verdict") == "ok");
    CHECK(rows[1].at("verdict") == "miss");
    CHECK(std::stod(rows[1].at("condition")) > 1);
    CHECK(lorenz.err.find(", condition " + rows[1].at("condition")) != std::string::npos);

    const auto other = judged(
        "# t x y z\n"
        "1 11.1667997083283 0.5996181048276723 98.137941384726034\n"
        "5 -23.645185490113537 0.4384777061958956 127.71663530474706\n",
        {"--problem", "lorenz", "--set", "r=100.5"});
    CHECK(other.exit_code == 1);
    const auto other_rows = csv_rows(other.out);
    REQUIRE(other_rows.size() == 2);
    CHECK(other_rows[1].at("verdict") == "miss");
    CHECK(std::stod(other_rows[1].at("condition")) > 1000);

    const auto arenstorf = judged(
        "# t x x' y y'\n"
        "1 0.31328459555412697 -1.0426165112753192 0.3480089746767388 0.67338411410340615\n",
        {"--problem", "arenstorf"});
    CHECK(arenstorf.exit_code == 0);
    REQUIRE(csv_rows(arenstorf.out).size() == 1);
    CHECK(std::stod(csv_rows(arenstorf.out)[0].at("condition")) > 1000);
}

}  // namespace command_problem_study_test
