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
    explicit asked_by_gnuplot(const std::string& script) {
        fs::create_directory(folder_.path() / "points");
        std::ofstream(folder_.path() / "t.csv") << "group,order,x,y\n"
                                                   "a,1,1/4,-2\n"
                                                   "a,2,0.5,3\n"
                                                   "b,1,2,-inf\n"
                                                   "b,3,4,1e-7\n"
                                                   "a,1,0.75,\n";
        std::ofstream(folder_.path() / "script.gp") << "load scripts.'/style.gp'\nt = 't.csv'\n" << script;
        const std::string setting = "cd '" + folder_.path().string() +
                                    "'; data = '.'; target = '.'; scratch = 'points'; scripts = '" + studies_folder() +
                                    "'; set print 'said'";
        REQUIRE(run_program({"gnuplot", "-e", setting, (folder_.path() / "script.gp").string()}) == 0);
    }

    std::string said() const { return text_of_file(folder_.path() / "said"); }
    std::string file(const std::string& name) const { return text_of_file(folder_.path() / name); }

private:
    temporary_folder folder_;
};

}  // namespace

TEST_CASE("a script of figures asks the shell each question once", "[sweep][figures]") {
    const asked_by_gnuplot script(
        "first = 'echo first >> runs; echo 5'\nsecond = 'echo second >> runs; echo \"two words\"'\n"
        "do for [kind in terminals] { print ask(first); print ask(second); print ask(first) }\n"
        "print points_by('echo points >> runs; echo 1,2') eq points_by('echo points >> runs; echo 1,2')\n");
    CHECK(script.said() == "5\ntwo words\n5\n5\ntwo words\n5\n5\ntwo words\n5\n1\n");
    CHECK(script.file("runs") == "first\nsecond\npoints\n");
}

TEST_CASE("a script of figures is told the ends of columns and single cells", "[sweep][figures]") {
    const asked_by_gnuplot script(
        "print least(t, '4', '1', 9)\nprint greatest(t, '3 4', '1', 9)\nprint greatest(t, '3', '$1 == \"a\"', 9)\n"
        "print least(t, '4', '$1 == \"c\"', 9)\n"
        "print cell_at(t, 4, '1 2', 'b,3', '1')\nprint cell_at(t, 2, '1', 'a', '$2 > 1')\n"
        "print '<'.cell_at(t, 4, '1', 'c', '1').'>'\nprint or_0(cell_at(t, 4, '1', 'c', '1'))\n");
    CHECK(script.said() == "-2.0\n4.0\n0.75\n9.0\n1e-7\n2\n<>\n0\n");
}

TEST_CASE("the rows of many curves are told apart by their cells in one reading", "[sweep][figures]") {
    const asked_by_gnuplot script(
        "print rows_at(t, 3, 4, '1', 'a', '1')\nprint rows_at(t, 3, 4, '1', 'b', '1')\n"
        "print rows_at(t, 3, 4, '1', 'c', '1')\nprint rows_at(t, 3, 4, '1 2', 'a,1', '1')\n"
        "print broken_at(t, 3, 4, '1', 'b')\nprint parts_at(t, '$2', '-$2', '1', 'b', '$1 == \"b\" && $2 < 3')\n"
        "print rows(t, 3, 4, '$1 == \"a\"')\n");
    const std::string rows_of_a = "x,y\n0.25,-2\n0.5,3\n";
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

}  // namespace sweep_style_test
