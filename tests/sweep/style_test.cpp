// What scripts of figures ask of tables through studies/style.gp.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>

#include "command/temporary_folder.hpp"
#include "run/child_program.hpp"
#include "sweep/study_figures.hpp"

namespace sweep_style_test {

namespace fs = std::filesystem;
using libration::run_program;
using libration::studies_folder;
using libration::tests::temporary_folder;
using libration::tests::text_of_file;

namespace {

const std::string out_of_sight = "\n1e99,1e99\n";

// What a script prints after style.gp, the table "t.csv" standing in the folder.
class asked_by_gnuplot {
public:
    explicit asked_by_gnuplot(const std::string& script, const std::string& scratch = "points") {
        fs::create_directory(folder_.path() / "points");
        std::ofstream(folder_.path() / "t.csv") << "group,order,x,y\n"
                                                   "a,1,1/4,-2\n"
                                                   "a,2,0.5,3\n"
                                                   "b,1,2,-inf\n"
                                                   "b,3,4,1e-7\n"
                                                   "a,1,0.75,\n";
        std::ofstream(folder_.path() / "script.gp") << "load scripts.'/style.gp'\nt = 't.csv'\n" << script;
        const std::string setting = "cd '" + folder_.path().string() + "'; data = '.'; target = '.'; scratch = '" +
                                    scratch + "'; scripts = '" + studies_folder() + "'; set print 'said'";
        code_ = run_program({"gnuplot", "-e", setting, (folder_.path() / "script.gp").string()});
    }

    int code() const { return code_; }
    std::string said() const { return text_of_file(folder_.path() / "said"); }
    std::string file(const std::string& name) const { return text_of_file(folder_.path() / name); }

private:
    temporary_folder folder_;
    int code_ = -1;
};

}  // namespace

TEST_CASE("a script of figures asks the shell each question once", "[sweep][figures]") {
    const asked_by_gnuplot script(
        "first = 'echo first >> runs; echo 5'\nsecond = 'echo second >> runs; echo \"two words\"'\n"
        "do for [kind in terminals] { print ask(first); print ask(second); print ask(first) }\n"
        "print points_by('echo points >> runs; echo 1,2') eq points_by('echo points >> runs; echo 1,2')\n");
    CHECK(script.code() == 0);
    CHECK(script.said() == "5\ntwo words\n5\n5\ntwo words\n5\n5\ntwo words\n5\n1\n");
    CHECK(script.file("runs") == "first\nsecond\npoints\n");
}

TEST_CASE("a script of figures is told the ends of columns and single cells", "[sweep][figures]") {
    const asked_by_gnuplot script(
        "print least(t, '4', '1', 9)\nprint greatest(t, '3 4', '1', 9)\nprint greatest(t, '3', '$1 == \"a\"', 9)\n"
        "print least(t, '4', '$1 == \"c\"', 9)\n"
        "print cell_at(t, 4, '1 2', 'b,3', '1')\nprint cell_at(t, 2, '1', 'a', '$2 > 1')\n"
        "print '<'.cell_at(t, 4, '1', 'c', '1').'>'\nprint or_0(cell_at(t, 4, '1', 'c', '1'))\n");
    CHECK(script.code() == 0);
    CHECK(script.said() == "-2.0\n4.0\n0.75\n9.0\n1e-7\n2\n<>\n0\n");
}

TEST_CASE("the rows of many curves are told apart by their cells in one reading", "[sweep][figures]") {
    const asked_by_gnuplot script(
        "print rows_at(t, 3, 4, '1', 'a', '1')\nprint rows_at(t, 3, 4, '1', 'b', '1')\n"
        "print rows_at(t, 3, 4, '1', 'c', '1')\nprint rows_at(t, 3, 4, '1 2', 'a,1', '1')\n"
        "print broken_at(t, 3, 4, '1', 'b')\nprint parts_at(t, '$2', '-$2', '1', 'b', '$1 == \"b\" && $2 < 3')\n"
        "print rows(t, 3, 4, '$1 == \"a\"')\n");
    const std::string rows_of_a = "x,y\n0.25,-2\n0.5,3\n";
    CHECK(script.code() == 0);
    CHECK(script.said() ==
          "points/1-1.csv\npoints/1-2.csv\npoints/1-0.csv\npoints/2-1.csv\npoints/3-2.csv\npoints/4-1.csv\n"
          "points/5.csv\n");
    CHECK(script.file("points/1-1.csv") == rows_of_a + out_of_sight);
    CHECK(script.file("points/1-2.csv") == "x,y\n4,1e-7\n" + out_of_sight);
    CHECK(script.file("points/1-0.csv") == "x,y\n" + out_of_sight);
    CHECK(script.file("points/2-1.csv") == "x,y\n0.25,-2\n" + out_of_sight);
    CHECK(script.file("points/3-2.csv") == "x,y\n2,-inf\n4,1e-7\n" + out_of_sight);
    CHECK(script.file("points/4-1.csv") == "x,y\n1,-1\n" + out_of_sight);
    CHECK(script.file("points/5.csv") == rows_of_a + out_of_sight);
}

TEST_CASE("a table of more curves than a process may have files open is read as well", "[sweep][figures]") {
    const asked_by_gnuplot script(
        "system(\"awk 'BEGIN { print \\\"c,x,y\\\"; for (x = 0; x < 2; ++x) for (c = 0; c < 3000; ++c) print c "
        "\\\",\\\" x \\\",\\\" c + x }' > many.csv\")\n"
        "print rows_at('many.csv', 2, 3, '1', '7', '1')\nprint rows_at('many.csv', 2, 3, '1', '2999', '1')\n");
    CHECK(script.code() == 0);
    CHECK(script.said() == "points/1-8.csv\npoints/1-3000.csv\n");
    CHECK(script.file("points/1-8.csv") == "x,y\n0,7\n1,8\n" + out_of_sight);
    CHECK(script.file("points/1-3000.csv") == "x,y\n0,2999\n1,3000\n" + out_of_sight);
}

TEST_CASE("a script of figures prints numbers and words of tables as a reader writes them", "[sweep][figures]") {
    const asked_by_gnuplot numbers(
        "do for [s in '2e-7 1e-20 -1.5 0.43714285714 -0.00001234567'] { print number_name(s) }\n"
        "print energy_name('1.9998', '0.0002')\nprint energy_name('1.999800005', '0.000199995')\n"
        "print energy_name('1.99999999999999999999', '1e-20')\nprint energy_name('2.0000000001', '-1e-10')\n");
    CHECK(numbers.code() == 0);
    CHECK(numbers.said() ==
          "2·10^{−7}\n10^{−20}\n−1.5\n0.43714\n−1.2346·10^{−5}\n1.9998\n2 − 1.99995·10^{−4}\n2 − 10^{−20}\n"
          "2 + 10^{−10}\n");
    const asked_by_gnuplot names(
        "do for [s in 'long-double mpfr:40 ball:40'] { print arithmetic_name(s) }\nprint in_arithmetic('mpfr:40')\n"
        "do for [s in 'agm series:100 resummed:10'] { print rule_name(s) }\n"
        "do for [s in 'domb-sykes pole-of-derivative differential-approximant-2'] { print test_name(s) }\n"
        "do for [s in 'falkner_skan sir sir_japan detest_a1 van_der_pol_10 my_problem'] { print problem_name(s) }\n");
    CHECK(names.code() == 0);
    CHECK(names.said() ==
          "long double\n40 digits\nproved, 40 digits\nwith 40 digits\nexact T*\nseries, N = 100\nresummation, N = 10\n"
          "Domb-Sykes\npole of derivative\ndifferential approximant 2\nFalkner-Skan\nSIR\nSIR Japan\nDETEST A1\n"
          "van der Pol 10\nmy problem\n");
}

TEST_CASE("the line of a Domb-Sykes plot follows from a verdict", "[sweep][figures]") {
    // t0 = 2 and -2 in t; the three roots of -8 in t^3, of which one is given; a pair; no radius.
    const asked_by_gnuplot script(
        "load scripts.'/shared/ratio_fit.gp'\nprint fit_of(1, '2', '2', '', '1')\nprint fit_of(1, '2', '-2', '0', "
        "'1')\n"
        "print fit_of(3, '2', '1', '1.7320508075688772', '3')\nprint fit_of(1, '2', '0', '2', '2') == 1\n"
        "print fit_of(1, '', '', '', '') == 1\nprint fit_slope(3, -0.125, '-2')\n"
        "print fit_uncertainty(1, 0.5, '2', '1e-6')\nprint with_uncertainty('3.9402114990', '0.00000597')\n"
        "print with_uncertainty('1.57079632679489661923', '1.9e-19')\n");
    CHECK(script.code() == 0);
    CHECK(script.said() ==
          "0.5\n-0.5\n-0.125\n0\n0\n3.0\n2.5e-07\nR = 3.940211 ± 6·10^{−6}\n"
          "R ≈ 1.5707963267949, uncertainty 1.9·10^{−19}\n");
}

TEST_CASE("points that cannot be written end a script of figures", "[sweep][figures]") {
    const std::string nowhere = "no such folder";
    CHECK(asked_by_gnuplot("print points_by('echo 1,2')\n").code() == 0);
    CHECK(asked_by_gnuplot("print points_by('echo 1,2')\n", nowhere).code() != 0);
    CHECK(asked_by_gnuplot("print rows_at(t, 3, 4, '1', 'a', '1')\n", nowhere).code() != 0);
}

}  // namespace sweep_style_test
