// `libration verify`: what a file may contain, what is written of it, and errors.
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "command/verified.hpp"

namespace command_verify_file_test {

using namespace libration;
using namespace libration::tests;
using namespace libration::tests::verifying;

TEST_CASE("verify keeps quoted cells and reads CRLF and a byte-order mark", "[command][verify]") {
    const std::string csv = "\xEF\xBB\xBF\"time\",theta , energy,note\r\n0.7,\"2.18\", 1.71 ,\"a, \"\"b\"\"\nc\"\r\n";
    const auto done = verify(csv);
    CHECK(done.exit_code == 0);
    const auto lines = lines_of(done.out);
    REQUIRE(lines.size() == 3);
    CHECK(lines[0] == "time,theta,energy,note,reference,error,correct_digits,verdict,condition");
    CHECK(lines[1] == "0.7,\"2.18\", 1.71 ,\"a, \"\"b\"\"");
    CHECK(lines[2].starts_with("c\",2.18288787151768773795,0.00289,"));
}

TEST_CASE("verify names malformed rows, marks them and goes on", "[command][verify]") {
    const std::string csv =
        "time,theta,energy\n0.7,2.18,1.71\n0.7,two,1.71\n0.7,2.18\n\nT/0,2.18,1.71\n0.7,2.18,-1\n0.7,2.18,\n"
        "0.7,\"2.18,1.71\n0.7,3.18,1.71\n0.7,,1.71\n0.7,1/2,1.71\n0.7,2.18,1.71\n";
    const auto done = verify(csv);
    CHECK(done.exit_code == 2);
    CHECK(says(done, "f.csv:3: theta 'two' is not a number"));
    CHECK(says(done, "f.csv:4: has 2 cells, the header has 3"));
    CHECK(says(done, "f.csv:6: time 'T/0' divides by zero"));
    CHECK(says(done, "f.csv:7: energy '-1' is a negative energy"));
    CHECK(says(done, "f.csv:8: the row has no motion"));
    CHECK(says(done, "f.csv:9: 'theta': a quote is not closed"));
    CHECK(says(done, "f.csv:10: theta misses by 0.997"));
    CHECK(says(done, "f.csv:11: theta is empty"));
    CHECK(says(done, "f.csv:12: theta '1/2' is not a number"));
    CHECK(says(done, "11 rows, 2 ok, 1 miss, 8 malformed"));
    const auto lines = lines_of(done.out);
    REQUIRE(lines.size() == 12);
    CHECK(lines[2] == "0.7,two,1.71,,,,malformed,");
    CHECK(lines[3] == "0.7,2.18,,,,,malformed,");
    CHECK(lines[7] == "\"0.7,\"\"2.18,1.71\",,,,,,malformed,");
    CHECK(lines[11].starts_with("0.7,2.18,1.71,2.18288787151768773795,"));
}

TEST_CASE("verify says which columns are missing", "[command][verify][bad input]") {
    refuses("when,where\n1,2\n", {"--energy", "1"},
            "f.csv has no column 'time', 'theta': its columns are 'when', 'where'");
    refuses("time,theta\n1,2\n", {}, "f.csv has no motion: its columns are 'time', 'theta'");
    refuses("time,theta,theta\n1,2,2\n", {}, "f.csv has two columns 'theta'");
    refuses("m,sn\n0,0\n", {}, "f.csv has no column 'u', the argument of sn: its columns are 'm', 'sn'");
    refuses("u,q,sn\n0,0.1,0\n", {}, "f.csv has no modulus: its columns are 'u', 'q', 'sn'");
    refuses("u,sn\n0,0\n", {}, "f.csv has no modulus: its columns are 'u', 'sn'");
    refuses("u,m,value\n0,0,0\n", {}, "f.csv has no column of an elliptic function: its columns are 'u', 'm', 'value'");
    refuses("when,x\n0,0\n", {"--problem", "dx/ds = 1; x(0) = 0"}, "f.csv has no column 's' or 'time'");
    refuses("", {}, "f.csv has no header");
    refuses("time,theta,energy\n", {}, "f.csv has no row to compare");
    refuses("time,theta,energy\n", {"--format", "json"}, "f.csv has no row to compare");
    check_refused({"verify", "none.csv"}, {"FILE 'none.csv'"});
}

TEST_CASE("verify refuses tolerances, inputs and formats that are none", "[command][verify][bad input]") {
    const std::string csv = "time,theta,energy\n0,1,1\n";
    refuses(csv, {"--ulp", "1", "--tolerance", "1"}, "--ulp '1' is given together with --tolerance or --relative");
    refuses(csv, {"--relative", "1e-9", "--ulp", "1"}, "--ulp '1' is given together with --tolerance or --relative");
    refuses(csv, {"--rounding", "--ulp", "1"}, "--ulp '1' is given together with --rounding");
    refuses(csv, {"--tolerance", "x"}, "--tolerance 'x'");
    refuses(csv, {"--inputs", "float"}, "--inputs 'float'");
    refuses(csv, {"--format", "xml"}, "--format 'xml' is not a format");
    refuses("u,m,sn\n0,0,0\n", {"--modulo-2pi"}, "--modulo-2pi has no meaning");
}

TEST_CASE("verify reads hexadecimal floats as numbers and inputs", "[command][verify]") {
    // 0x1.8p+1 = 3; float.hex(2.1828878715176877) = 0x1.1768dea89e8e9p+1, its last digit worth 2^-51.
    CHECK(verdict_of("time,theta,energy\n0x1.8p+1,-1.57,0x1p0\n", {"--tolerance", "10"}) == "ok");
    const std::string by_hex = verify_rows("time,theta,energy\n0x1.8p+1,-1.57,0x1p0\n").rows.at(0).at("reference");
    CHECK(by_hex == verify_rows("time,theta,energy\n3,-1.57,1\n").rows.at(0).at("reference"));
    CHECK(verdict_of("time,theta,energy\n0,0x1.921fb54442d18p+0,1\n") == "ok");
    CHECK(verdict_of("time,theta,energy\n0,0x1.921fb54442d19p+0,1\n") == "ok");
    CHECK(verdict_of("time,theta,energy\n0,0x1.921fb54442d1ap+0,1\n") == "miss");
}

TEST_CASE("verify knows columns by common spellings and by --columns", "[command][verify]") {
    const std::string row = "0.7," + theta_at_seven_tenths + ",1.71\n";
    for (const std::string header : {"t,Theta,E", "Time [s],theta (rad),ENERGY", " T , \xCE\xB8 , energy"}) {
        INFO(header);
        CHECK(verdict_of(header + "\n" + row) == "ok");
    }
    CHECK(verdict_of("when,where,what\n" + row, {"--columns", "when=time,where=theta,what=energy"}) == "ok");
    // A redundant column: the energy is wrong, the gap is right.
    const std::string both = "time,theta,energy,gap\n0.7," + theta_at_seven_tenths + ",1,0.29\n";
    CHECK(verify(both).exit_code == 2);
    CHECK(verdict_of(both, {"--columns", "energy=-"}) == "ok");
    const auto refused = [&](const std::string& header, const std::string& mapping, const std::string& reason) {
        refuses(header + "\n" + row, {"--columns", mapping}, reason);
    };
    refused("a,b,c", "x=time",
            "--columns 'x=time' has 'x', which is not a column of 'f.csv': choose among 'a', 'b', 'c'");
    refused("a,b,c", "a=tme", "has 'tme', which is not a quantity: write time, ");
    refused("a,b,c", "a", "has 'a', which is not THEIRS=OURS");
    refused("t,T,theta", "theta=theta", "f.csv has two columns 'time': 't' and 'T'");
    // A message uses the column's name in the file.
    CHECK(says(verify("t,phi,E\n0.7,x,1.71\n", {"--columns", "phi=theta"}), "f.csv:2: phi 'x' is not a number"));
    CHECK(says(verify("t (s),theta,E\n1..0,1,1.71\n"), "f.csv:2: t (s) '1..0'"));
    CHECK(says(verify("t,theta,E\n1,2,-3\n"), "f.csv:2: E '-3' is a negative energy"));
    CHECK(says(verify("t,theta,E,th0\n1,2,1,3\n", {"--columns", "th0=theta0"}), "f.csv:2: th0 '3' is not reached"));
}

TEST_CASE("verify reads what radius reads, and what numpy.savetxt writes", "[command][verify]") {
    const std::string t = "7.000000000000000000e-01";
    const std::string theta = "2.182887871517687738e+00";
    for (const std::string csv :
         {"time;theta;energy\n0.7;2.18;1.71\n", "time\ttheta\tenergy\n0.7\t2.18\t1.71\n",
          "\xEF\xBB\xBF"
          "time theta  energy\r\n  0.7   2.18 \t 1.71\r\n",
          "# time theta energy\n0.7 2.18 1.71\n", "# made by us\n# time, theta, energy\n0.7 2.18 1.71\n# the end\n"}) {
        INFO(csv);
        const auto [done, rows] = verify_rows(csv);
        REQUIRE(rows.size() == 1);
        CHECK(rows[0].at("verdict") == "ok");
        CHECK(rows[0].at("theta") == "2.18");
    }
    const words named{"--columns", "time,theta", "--energy", "1.71"};
    CHECK(verdict_of(t + " " + theta + "\n", named) == "ok");
    CHECK(verdict_of(t + ";" + theta + "\n", named) == "ok");
    CHECK(says(verify(t + " " + theta + "\n", {"--energy", "1.71"}), "f.csv has no header: name its 2 columns"));
    CHECK(says(verify(t + " " + theta + "\n", {"--columns", "time"}), "has 1 names, and f.csv has 2 columns"));
}

TEST_CASE("verify writes JSON", "[command][verify]") {
    const auto done =
        verify("time,theta,energy,note\n0.7,2.18,1.71,\"a \"\"b\"\"\"\n0.7,two,1.71,\n", {"--format", "json"});
    CHECK(done.exit_code == 2);
    const auto rows = nlohmann::json::parse(done.out);
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].at("note") == "a \"b\"");
    CHECK((rows[0].at("verdict") == "ok" && rows[0].at("error") == "0.00289"));
    CHECK((rows[1].at("verdict") == "malformed" && rows[1].at("error").is_null()));
}

TEST_CASE("verify shows what it quotes short and without control characters", "[command][verify]") {
    const std::string head = "time,theta,energy\n";
    CHECK(says(verify(head + "0.7,\x1b[2J" + std::string(1, '\0') + "x,1.71\n"),
               "f.csv:2: theta '\\x1b[2J\\0x' is not a number"));
    const auto done = verify(head + "0.7,2.18," + std::string(100'000, '9') + "x\n");
    CHECK(says(done, "f.csv:2: energy '" + std::string(60, '9') + "...' "));
    CHECK(done.err.size() < 1000);
    CHECK(verify(std::string(1'000'000, 'a') + "\n1\n").err.size() < 1000);
}

TEST_CASE("verify writes the same bytes with any number of threads", "[command][verify]") {
    std::string csv = "time,theta,energy\n";
    for (int i = 0; i < 1000; ++i) {
        csv += std::to_string(i) + "e-2,0.5,1." + std::to_string(i / 3) + "\n";
    }
    CHECK(verify(csv, {"--jobs", "1"}).out == verify(csv, {"--jobs", "3"}).out);
    const temporary_folder folder;
    std::ofstream(folder.path() / "f.csv", std::ios::binary) << csv;
    const auto piped = run_libration({"verify", "-", "--out", "o.csv"}, folder.path(), folder.path() / "f.csv");
    CHECK(piped.out.empty());
    CHECK(text_of_file(folder.path() / "o.csv") == verify(csv).out);
}

}  // namespace command_verify_file_test
