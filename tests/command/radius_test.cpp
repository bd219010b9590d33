// `libration radius`: its contract, motions compared with the lattice of singularities, lists from files, and errors.
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "command/printed.hpp"
#include "command/refusal.hpp"
#include "libration/pendulum/singularities.hpp"

namespace command_radius_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

const std::string header =
    "method,radius,uncertainty,exact,relative_error,position_re,position_im,kind,count,note,exponent,"
    "exponent_uncertainty,rigour,bound,gevrey,action,action_uncertainty,suspect,suspect_predicted,suspect_uncertainty,"
    "prediction,amplitude,amplitude_uncertainty";

// T* and K~' of an energy to 80 digits.
singularity_lattice<mpfr> lattice_of(const std::string& energy) {
    return *singularities<mpfr>(motion::of_energy(read_exact(energy).coefficient, 1));
}

// |a - b| in units of the radius.
void check_close(const std::string& printed, const mpfr& truth, const mpfr& radius, const std::string& allowed) {
    INFO(printed << " is not " << to_decimal(truth, 60));
    CHECK(abs(number_of(printed) - truth) <= radius * mpfr(allowed));
}

// The verdict about a point whose nearest column of singularities is `along` away, to 45 digits.
void check_verdict(const std::string& energy, const std::string& at, const mpfr& along, const std::string& count) {
    const auto rows = rows_of({"radius", "--energy", energy, "--at", at, "--order", "200", "--scalar", "mpfr:60"});
    const table_row& verdict = rows.at(0);
    INFO("E = " << energy << " at " << at << ": " << verdict.at("radius"));
    const mpfr height = lattice_of(energy).height;
    const mpfr radius = sqrt(along * along + height * height);
    CHECK(verdict.at("method") == "verdict");
    CHECK_THAT(verdict.at("exact"), right_to_the_last_digit_of(radius));
    check_close(verdict.at("radius"), radius, radius, "1e-45");
    check_close(verdict.at("position_re"), along, radius, "1e-45");
    check_close(verdict.at("position_im"), height, radius, "1e-45");
    CHECK(number_of(verdict.at("relative_error")) < mpfr("1e-45"));
    CHECK(abs(number_of(verdict.at("radius")) - radius) <= number_of(verdict.at("uncertainty")));
    CHECK((verdict.at("kind") == "logarithm" || verdict.at("kind").empty()));
    CHECK(abs(number_of(verdict.at("exponent"))) <= number_of(verdict.at("exponent_uncertainty")));
    CHECK(verdict.at("count") == count);
}

const std::vector<std::string> shown_energies{"0.5", "1.9998", "2.02", "10"};

void write_file(const temporary_folder& folder, const std::string& name, const std::string& text) {
    std::ofstream(folder.path() / name, std::ios::binary) << text;
}

// The rows about a list in a file.
std::vector<table_row> rows_about(const std::string& text, const words& options) {
    const temporary_folder folder;
    write_file(folder, "list.csv", text);
    const auto done =
        run_libration(words{"radius", "--coefficients", "list.csv", "--format", "csv"} + options, folder.path());
    INFO(done.err);
    REQUIRE(done.exit_code == 0);
    CHECK(done.err.empty());
    return csv_rows(done.out);
}

// tan x from y' = 1 + y^2, as n,fraction.
std::string tangent(std::size_t count) {
    std::vector<rational> a(count, rational(0));
    std::string text = "n,coefficient\n0,0\n";
    for (std::size_t n = 0; n + 1 < count; ++n) {
        rational sum = n == 0 ? 1 : 0;
        for (std::size_t k = 0; k <= n; ++k) {
            sum += a[k] * a[n - k];
        }
        a[n + 1] = sum / static_cast<long>(n + 1);
        text += std::to_string(n + 1) + "," + a[n + 1].str() + "\n";
    }
    return text;
}

// 1/n! as fractions.
std::string exponential(int count) {
    std::string text;
    integer factorial = 1;
    for (int n = 0; n < count; ++n) {
        factorial *= n == 0 ? 1 : n;
        text += "1/" + factorial.str() + "\n";
    }
    return text;
}

}  // namespace

TEST_CASE("radius prints the columns of the contract, the verdict first", "[command][radius]") {
    const words line{"radius", "--energy", "1.71", "--order", "60", "--scalar", "mpfr:30"};
    const std::string csv = output_of(line + words{"--format", "csv"});
    CHECK(lines_of(csv).front() == header);
    CHECK(csv.find('"') == std::string::npos);
    const auto rows = csv_rows(csv);
    REQUIRE(rows.size() > 4);
    CHECK(rows.front().at("method") == "verdict");
    for (const table_row& row : rows) {
        INFO(row.at("method"));
        CHECK(row.at("rigour") == "heuristic");
        CHECK(row.at("exact") == rows.front().at("exact"));
        CHECK(row.at("radius").empty() == row.at("uncertainty").empty());
        CHECK((!row.at("radius").empty() || !row.at("note").empty()));
    }
    const auto json = nlohmann::ordered_json::parse(output_of(line + words{"--format", "json"}));
    REQUIRE(json.size() == rows.size());
    CHECK(json[0]["radius"] == rows.front().at("radius"));
    const std::string text = output_of(line);
    CHECK(text.find("only even n are nonzero") != std::string::npos);
    CHECK(text.find(rows.front().at("radius")) != std::string::npos);
    CHECK(text.ends_with("heuristic estimate: finitely many coefficients cannot prove a radius\n"));
    CHECK(output_of(line + words{"--format", "latex"}).find("\\begin") != std::string::npos);
}

TEST_CASE("about the top the verdict is the lattice's radius and position to 45 digits", "[command][radius]") {
    const precision_scope scope(80);
    for (const std::string& energy : shown_energies) {
        check_verdict(energy, "top", lattice_of(energy).effective_period, "4");
    }
}

TEST_CASE("about the bottom the verdict is the lattice's radius and position to 45 digits", "[command][radius]") {
    const precision_scope scope(80);
    for (const std::string& energy : std::vector<std::string>{"1.9998", "10"}) {
        check_verdict(energy, "bottom", mpfr(0), "2");
    }
}

TEST_CASE("about a time without symmetry the verdict is the lattice's radius and position to 45 digits",
          "[.long][command][radius]") {
    const precision_scope scope(80);
    for (const std::string energy : {"1.71"}) {
        check_verdict(energy, "1.1", lattice_of(energy).effective_period - mpfr(11) / 10, "2");
    }
}

TEST_CASE("with a length and a gravity the radius is in seconds", "[command][radius]") {
    const words line{"radius", "--energy", "1", "--order", "80", "--digits", "30"};
    const auto plain = rows_of(line).at(0);
    const auto seconds = rows_of(line + words{"--length", "2", "--gravity", "8"}).at(0);
    const precision_scope scope(60);
    CHECK_THAT(seconds.at("exact"), right_to_the_last_digit(to_decimal(mpfr(number_of(plain.at("exact")) / 2), 31)));
    const mpfr difference = number_of(plain.at("radius")) / 2 - number_of(seconds.at("radius"));
    CHECK(abs(difference) <= number_of(plain.at("uncertainty")));
}

TEST_CASE("the equilibria and the separatrix have what coefficients say", "[command][radius]") {
    const auto rest = rows_of({"radius", "--energy", "0", "--order", "40"}).at(0);
    CHECK(rest.at("exact") == "inf");
    CHECK(rest.at("radius").empty());
    CHECK(rest.at("relative_error").empty());
    const auto critical = rows_of({"radius", "--energy", "2", "--at", "bottom", "--order", "120"}).at(0);
    const precision_scope scope(80);
    CHECK_THAT(critical.at("exact"), right_to_the_last_digit_of(pi<mpfr>() / 2));
    check_close(critical.at("radius"), pi<mpfr>() / 2, mpfr(1), "1e-30");
}

TEST_CASE("every fixed scalar gives its verdict, also where the coefficients are far below its range",
          "[command][radius]") {
    // At the energy 10^-6 the last of 360 coefficients is 4e-342.
    for (const auto& [scalar, energy, order] :
         {std::tuple("double", "1e-6", "360"), {"long-double", "1.71", "150"}, {"quad", "1.71", "100"}}) {
        INFO(scalar);
        const auto verdict = rows_of({"radius", "--energy", energy, "--order", order, "--scalar", scalar}).at(0);
        CHECK(number_of(verdict.at("relative_error")) < mpfr("1e-12"));
    }
}

// C_n = (2n)!/(n! (n+1)!) are the coefficients of (1 - sqrt(1 - 4x))/(2x).
TEST_CASE("ten Catalan numbers have the radius 1/4 by their equation, ten random digits none", "[command][radius]") {
    const auto list = [](const std::vector<int>& values) {
        std::string text;
        for (std::size_t n = 0; n < values.size(); ++n) {
            text += std::to_string(n) + "," + std::to_string(values[n]) + "\n";
        }
        return text;
    };
    const auto verdict = rows_about(list({1, 1, 2, 5, 14, 42, 132, 429, 1430, 4862}), {}).at(0);
    check_close(verdict.at("radius"), mpfr(1) / 4, mpfr(1), "1e-45");
    check_close(verdict.at("exponent"), mpfr(1) / 2, mpfr(1), "1e-45");
    CHECK(rows_about(list({3, 1, 4, 1, 5, 9, 2, 6, 5, 3}), {}).at(0).at("radius").empty());
}

// -x_c is a weaker singularity on the same circle, with another exponent.
TEST_CASE("the count of a verdict is that of the singularities of its kind", "[command][radius]") {
    const auto done = run_libration(
        {"radius", "--coefficients", LIBRATION_LISTS "walks_square.csv", "--order", "40", "--format", "csv"});
    REQUIRE(done.exit_code == 0);
    const auto verdict = csv_rows(done.out).at(0);
    CHECK(verdict.at("kind") == "algebraic");
    CHECK(verdict.at("count") == "1");
}

TEST_CASE("the tangent in a file has two simple poles at pi/2 and -pi/2", "[command][radius]") {
    const auto verdict = rows_about(tangent(120), {"--scalar", "mpfr:40"}).at(0);
    const precision_scope scope(80);
    check_close(verdict.at("radius"), pi<mpfr>() / 2, mpfr(1), "1e-30");
    check_close(verdict.at("position_re"), pi<mpfr>() / 2, mpfr(1), "1e-30");
    CHECK(verdict.at("position_im") == "0");
    CHECK(verdict.at("kind") == "pole");
    CHECK(verdict.at("count") == "2");
    CHECK(verdict.at("exact").empty());
    CHECK(verdict.at("relative_error").empty());
    CHECK(verdict.at("note").find("only odd n are nonzero") != std::string::npos);
}

TEST_CASE("the exponential in a file has no finite radius", "[command][radius]") {
    for (const table_row& row : rows_about(exponential(80), {})) {
        INFO(row.at("method"));
        CHECK(row.at("radius") == (row.at("method") == "verdict" ? "inf" : ""));
        CHECK((row.at("method") == "verdict" ||
               row.at("note").find("no finite radius seen up to N = 79") != std::string::npos));
    }
}

TEST_CASE("a hundred coefficients with the digits of double give twelve digits", "[command][radius]") {
    const std::string list =
        output_of({"coefficients", "--energy", "1.71", "--order", "99", "--scalar", "mpfr:17", "--format", "csv"});
    const auto verdict = rows_about(list, {"--scalar", "mpfr:60"}).at(0);
    const precision_scope scope(80);
    const auto lattice = lattice_of("1.71");
    const mpfr radius = sqrt(lattice.effective_period * lattice.effective_period + lattice.height * lattice.height);
    check_close(verdict.at("radius"), radius, radius, "1e-12");
    CHECK(number_of(verdict.at("uncertainty")) < mpfr("1e-9"));
}

TEST_CASE("coefficients that no double holds have a radius in double", "[command][radius]") {
    // 1/(1 - x/10^30) times 10^5000.
    std::string list;
    for (int n = 0; n < 60; ++n) {
        list += "1e" + std::to_string(5000 - 30 * n) + "\n";
    }
    const auto verdict = rows_about(list, {"--scalar", "double"}).at(0);
    const precision_scope scope(40);
    check_close(verdict.at("radius"), mpfr("1e30"), mpfr("1e30"), "1e-14");
    CHECK(verdict.at("kind") == "pole");
}

TEST_CASE("an apparent singularity is not taken for the nearest one", "[command][radius]") {
    // (1-x)^(2/3) + (1+x)^(-5/2), exactly: an equation fitted to it is also singular at 0.5789.
    std::string list;
    rational near = 1;
    rational left = 1;
    for (int n = 0; n <= 40; ++n) {
        if (n > 0) {
            near *= rational(3 * (n - 1) - 2, 3 * n);
            left *= rational(-(2 * (n - 1) + 5), 2 * n);
        }
        list += rational(near + left).str() + "\n";
    }
    const auto verdict = rows_about(list, {"--scalar", "mpfr:50"}).at(0);
    const precision_scope scope(60);
    check_close(verdict.at("radius"), mpfr(1), mpfr(1), "1e-30");
    CHECK(abs(number_of(verdict.at("radius")) - 1) <= number_of(verdict.at("uncertainty")));
    CHECK(number_of(verdict.at("exponent_uncertainty")) > 0);
}

TEST_CASE("a list with an absolute floor is used above it, and the floor is named", "[command][radius]") {
    // (1 - x/2)^(3/2) with errors of up to 1e-16, as produced by an FFT.
    const precision_scope scope(40);
    std::string list;
    mpfr a(1);
    unsigned state = 5;
    for (int n = 0; n < 128; ++n) {
        a *= n == 0 ? mpfr(1) : mpfr(mpfr(2 * n - 5) / (4 * n));
        state = state * 1103515245U + 12345U;
        const mpfr error = mpfr(static_cast<int>(state >> 16U) % 2001 - 1000) / mpfr("1e19");
        list += to_decimal(mpfr(a + error), 20) + "\n";
    }
    for (const std::string scalar : {"double", "mpfr:30"}) {
        const auto verdict = rows_about(list, {"--scalar", scalar}).at(0);
        INFO(verdict.at("note"));
        CHECK(abs(number_of(verdict.at("radius")) - 2) <= number_of(verdict.at("uncertainty")));
        CHECK(number_of(verdict.at("uncertainty")) < mpfr("0.2"));
        CHECK(verdict.at("note").find("a noise floor of about") != std::string::npos);
    }
}

TEST_CASE("a list comes from stdin too, and --order cuts it", "[command][radius]") {
    const temporary_folder folder;
    write_file(folder, "tan.csv", tangent(80));
    const words options{"--scalar", "mpfr:30", "--format", "csv"};
    const auto by_name = run_libration(words{"radius", "--coefficients", "tan.csv"} + options, folder.path());
    const auto by_stdin = run_libration(words{"radius", "--coefficients", "-"} + options, folder.path(),
                                        (folder.path() / "tan.csv").string());
    CHECK(by_stdin.exit_code == 0);
    CHECK(by_stdin.out == by_name.out);
    CHECK(rows_about(tangent(80), {"--order", "59"}) == rows_about(tangent(60), {}));
}

TEST_CASE("a list on one line, and one without the line of an n", "[command][radius]") {
    const temporary_folder folder;
    std::string one_line;
    std::string lines;
    std::string with_gap;
    for (int n = 0; n <= 20; ++n) {  // 1/(1 - 2 x)
        const std::string value = std::to_string(1 << n);
        one_line += (n == 0 ? "" : ", ") + value;
        lines += value + "\n";
        with_gap += n == 7 ? "" : std::to_string(n) + " " + value + "\n";
    }
    write_file(folder, "one.txt", one_line + "\n");
    write_file(folder, "lines.txt", lines);
    write_file(folder, "gap.txt", with_gap);
    const auto from = [&](const char* name) {
        return run_libration({"radius", "--coefficients", name, "--format", "csv"}, folder.path());
    };
    CHECK(from("one.txt").out == from("lines.txt").out);
    CHECK(from("one.txt").exit_code == 0);
    CHECK(from("lines.txt").err.find("read as 0") == std::string::npos);
    CHECK(from("gap.txt").err.find("'gap.txt' has no line for n = 7: read as 0") != std::string::npos);
    write_file(folder, "even.txt", "0 1\n2 1\n4 1\n6 1\n8 1\n10 1\n12 1\n14 1\n");
    CHECK(from("even.txt").err.find("read as 0") == std::string::npos);
}

TEST_CASE("complex coefficients have their singularity on its own side", "[command][radius]") {
    // 1/(1 - x/(1+2i)) and (1 - x/(1+2i))^(1/2): at distance sqrt 5, without a conjugate.
    const precision_scope scope(60);
    for (const bool root : {false, true}) {
        rational re = 1;
        rational im = 0;
        std::string whole = "n,coefficient\n";
        std::string parts = "n,f_re,f_im\n";
        std::string json;
        for (int n = 0; n < 60; ++n) {
            if (n > 0) {  // times (n - 1 - nu)/n /(1 + 2i), nu = -1 or 1/2
                const rational factor = root ? rational(2 * n - 3, 2 * n) : rational(1);
                const rational next_re = (re + 2 * im) / 5 * factor;
                im = (im - 2 * re) / 5 * factor;
                re = next_re;
            }
            whole += std::to_string(n) + "," + re.str() + (im < 0 ? "" : "+") + im.str() + "i\n";
            parts += std::to_string(n) + "," + re.str() + "," + im.str() + "\n";
            json += (n == 0 ? "[[\"" : ",[\"") + re.str() + "\",\"" + im.str() + "\"]";
        }
        const auto verdict = rows_about(whole, {"--scalar", "mpfr:30"}).at(0);
        check_close(verdict.at("radius"), sqrt(mpfr(5)), mpfr(1), "1e-20");
        check_close(verdict.at("position_re"), mpfr(1), mpfr(1), "1e-20");
        check_close(verdict.at("position_im"), mpfr(2), mpfr(1), "1e-20");
        CHECK(verdict.at("count") == "1");
        CHECK(verdict.at("kind") == (root ? "algebraic" : "pole"));
        CHECK(rows_about(parts, {"--scalar", "mpfr:30"}).at(0).at("radius") == verdict.at("radius"));
        CHECK(rows_about(json + "]", {"--scalar", "mpfr:30"}).at(0).at("radius") == verdict.at("radius"));
    }
}

TEST_CASE("of several columns each has its rows, and the verdict is the nearest of all", "[command][radius]") {
    std::string list = "n,u,v,v_uncertainty\n";
    std::string json;
    integer far = 1;
    integer near = 1;
    for (int n = 0; n < 40; ++n, far *= 3, near *= 2) {
        list += std::to_string(n) + ",1/" + far.str() + ",1/" + near.str() + ",0\n";
        json += std::string(n == 0 ? "[" : ",") + "{\"n\":" + std::to_string(n) + ",\"u\":\"1/" + far.str() +
                "\",\"v\":\"1/" + near.str() + "\"}";
    }
    const auto rows = rows_about(list, {"--scalar", "mpfr:30"});
    const precision_scope scope(60);
    check_close(rows.at(0).at("radius"), mpfr(2), mpfr(1), "1e-25");
    CHECK(rows.at(0).at("unknown") == "v");
    CHECK(rows.at(1).at("method") == "verdict");
    CHECK(rows.at(1).at("unknown") == "u");
    check_close(rows.at(1).at("radius"), mpfr(3), mpfr(1), "1e-25");
    CHECK(rows.size() % 2 == 1);
    CHECK(rows_about(json + "]", {"--scalar", "mpfr:30"}) == rows);
}

TEST_CASE("numbers of JSON are read with all their digits", "[command][radius]") {
    std::string json = "[";
    std::string lines;
    for (int n = 0; n < 50; ++n) {
        // 2^-n/(n+1) to 30 digits.
        const precision_scope scope(60);
        const std::string number = to_decimal(mpfr(ldexp(mpfr(1), -n) / (n + 1)), 30);
        json += (n == 0 ? "" : ", ") + number;
        lines += number + "\n";
    }
    CHECK(rows_about(json + "]\n", {"--scalar", "mpfr:30"}) == rows_about(lines, {"--scalar", "mpfr:30"}));
}

TEST_CASE("a malformed line of coefficients is named with its number", "[command][radius][bad input]") {
    const temporary_folder folder;
    write_file(folder, "bad.csv", "n,coefficient\r\n0,1\r\n\r\n1,1.2.3\r\n");
    write_file(folder, "empty.csv", "# nothing\n\n");
    write_file(folder, "good.csv", "1\n1/2\n1/3\n");
    const words file{"radius", "--coefficients"};
    check_refused(file + words{"bad.csv"}, {"--coefficients 'bad.csv'", "line 4", "'1,1.2.3'"}, folder);
    check_refused(file + words{"empty.csv"}, {"--coefficients 'empty.csv'", "no coefficient"}, folder);
    check_refused(file + words{"missing.csv"}, {"--coefficients 'missing.csv'"}, folder);
    check_refused(file + words{"."}, {"--coefficients '.'", "folder"}, folder);
    check_refused(file + words{"-"}, {"--coefficients '-'", "no coefficient"}, folder);
    write_file(folder, "bad.json", "[1, [2, 3]");
    write_file(folder, "deep.json", "[{\"n\": [1]}]");
    write_file(folder, "columns.csv", "n,u,v\n0,1,2\n1,3\n");
    check_refused(file + words{"bad.json"}, {"--coefficients 'bad.json'", "JSON"}, folder);
    check_refused(file + words{"deep.json"}, {"--coefficients 'deep.json'", "row 1"}, folder);
    check_refused(file + words{"columns.csv"}, {"--coefficients 'columns.csv'", "line 3", "cells"}, folder);
    check_refused(file + words{"good.csv", "--order", "3"}, {"--order '3'", "is 2"}, folder);
    check_refused(file + words{"good.csv", "--at", "top"}, {"--at 'top'"}, folder);
    check_refused(file + words{"good.csv", "--energy", "1"}, {"--coefficients", "--energy '1'"}, folder);
    check_refused(file + words{"good.csv", "--length", "1"}, {"--coefficients", "--length '1'"}, folder);
}

TEST_CASE("radius refuses what is no motion, no order and no point", "[command][radius][bad input]") {
    const temporary_folder folder;
    check_refused({"radius"}, {"--energy", "--coefficients"}, folder);
    check_refused({"radius", "--order", "3"}, {"--energy", "--coefficients"}, folder);
    check_refused({"radius", "--energy", "1"}, {"--order"}, folder);
    check_refused({"radius", "--energy", "1", "--order", "x"}, {"--order 'x'"}, folder);
    check_refused({"radius", "--energy", "2", "--order", "30", "--at", "top"}, {"--at 'top'"}, folder);
    check_refused({"radius", "--energy", "1", "--order", "30", "--at", "left"}, {"--at 'left'"}, folder);
    check_refused({"radius", "--energy", "1", "--order", "30", "--scalar", "float"}, {"--scalar 'float'"}, folder);
    // e^x in its unit, N = 1200: a_0 is e^-750 of the largest.
    write_file(folder, "exp.csv", exponential(1200));
    check_refused({"radius", "--coefficients", "exp.csv", "--scalar", "double"}, {"range", "use --scalar mpfr:"},
                  folder);
}

}  // namespace command_radius_test
