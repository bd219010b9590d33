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

// What a script prints after style.gp, the table "t.csv" standing in the folder.
class asked_by_gnuplot {
public:
    explicit asked_by_gnuplot(const std::string& script) {
        std::ofstream(folder_.path() / "t.csv") << "group,order,x,y\n"
                                                   "a,1,1/4,-2\n"
                                                   "a,2,0.5,3\n"
                                                   "b,1,2,-inf\n"
                                                   "b,3,4,1e-7\n"
                                                   "a,1,0.75,\n";
        std::ofstream(folder_.path() / "script.gp") << "load scripts.'/style.gp'\nt = 't.csv'\n" << script;
        const std::string setting = "cd '" + folder_.path().string() +
                                    "'; data = '.'; target = '.'; tables = 't.csv '; scripts = '" + studies_folder() +
                                    "'; set print 'said'";
        code_ = run_program({"gnuplot", "-e", setting, (folder_.path() / "script.gp").string()});
    }

    int code() const { return code_; }
    std::string said() const { return text_of_file(folder_.path() / "said"); }

private:
    temporary_folder folder_;
    int code_ = -1;
};

}  // namespace

TEST_CASE("a script of figures is told the values and ends of columns and single cells", "[sweep][figures]") {
    const asked_by_gnuplot script(
        "eval seen('list', t, 'group', '1')\nprint words(list), listed(list, 'b') > 0, listed(list, 'c')\n"
        "eval seen_together('list', t, 'group order', \"has('y')\")\nprint list\n"
        "eval extent('y', t, 'y', '1')\nprint y_low, y_high\neval extent('y', t, 'x y', '1')\nprint y_low, y_high\n"
        "eval extent('y', t, '3', \"is('group', 'a')\")\nprint y_low, y_high\n"
        "eval extent('y', t, 'y', \"is('group', 'c')\")\nprint y_low, y_high\n"
        "eval first_cell('cell', t, 'y', \"is('group', 'b') && is('order', '3')\")\nprint cell\n"
        "eval last_cell('cell', t, 'order', \"is('group', 'a')\")\nprint cell\n"
        "eval first_cell('cell', t, 'y', \"is('group', 'c')\")\nprint '<'.cell.'>'\n"
        "eval count_of('n', t, \"at('x') < 1\")\nprint n\neval has_column('has_it', t, 'y')\nprint has_it\n"
        "eval has_column('has_it', t, 'z')\nprint has_it, exists_file('./t.csv'), exists_file('./u.csv')\n");
    CHECK(script.code() == 0);
    CHECK(
        script.said() ==
        "2 1 0\n \"a,1\" \"a,2\" \"b,1\" \"b,3\"\n-2.0 3.0\n-2.0 4.0\n0.25 0.75\n0.0 1.0\n1e-7\n1\n<>\n3\n1\n0 1 0\n");
}

TEST_CASE("the rows of a curve are those with its cells", "[sweep][figures]") {
    const std::string drawn =
        "set terminal dumb\nset output 'plot'\nset table 'points'\nset xrange [0:9]\nset yrange [-9:9]\n"
        "eval 'plot '.rows(t, 'x', 'y', \"is('group', '%s')\").' with points'\nunset table\n"
        "lines = system(\"grep ' i$' points\")\nprint lines\n";
    const auto points_of = [&](const std::string& group) {
        std::string script = drawn;
        script.replace(script.find("%s"), 2, group);
        return asked_by_gnuplot(script).said();
    };
    CHECK(points_of("a") == " 0.25 -2  i\n 0.5  3  i\n");
    CHECK(points_of("b") == " 4  1e-07  i\n");
    CHECK(points_of("c") == "\n");
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

}  // namespace sweep_style_test
