// `libration import`: models in SBML as problems, whose solutions have closed forms.
#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "command/printed.hpp"
#include "command/refusal.hpp"
#include "libration/equation/hybrid_system.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/problem/solution.hpp"
#include "libration/query/trajectory.hpp"
#include "libration/scalar/scalar.hpp"

namespace import_test {

using namespace libration;
using namespace libration::tests;

namespace {

std::string model(const std::string& name) { return std::string(LIBRATION_SOURCE_DIR) + "/" + name; }

// A model of level 3 version 2 with this content.
std::string file_with(const temporary_folder& folder, const std::string& content) {
    const std::string file = (folder.path() / "model.xml").string();
    std::ofstream(file)
        << R"(<?xml version="1.0" encoding="UTF-8"?>)"
        << R"(<sbml xmlns="http://www.sbml.org/sbml/level3/version2/core" level="3" version="2"><model>)" << content
        << "</model></sbml>";
    return file;
}

// A rate rule of x with this formula in MathML.
std::string with_rate(const std::string& formula) {
    return R"(<listOfParameters><parameter id="x" value="1" constant="false"/></listOfParameters><listOfRules>)"
           R"(<rateRule variable="x"><math xmlns="http://www.w3.org/1998/Math/MathML">)" +
           formula + "</math></rateRule></listOfRules>";
}

}  // namespace

TEST_CASE("reactions and rules of a model have the solution in closed form", "[import]") {
    const precision_scope scope(40);
    const ode::explicit_system system(ode::parse(output_of({"import", model("tests/import/reactions.xml")})));
    std::map<std::string, mpfr> at;
    const auto states = ode::trajectory(system, {ode::number(rational(2))}, 30);
    for (std::size_t i = 0; i < system.unknowns().size(); ++i) {
        at[system.unknowns()[i].name] = states.front()[i][0];
    }
    const mpfr a = mpfr(3) / 2 * exp(mpfr(-1) / 2);  // A' = -A/4, in the volume 2
    const mpfr tolerance = pow(mpfr(10), -29);       // 30 digits of numbers below 10
    CHECK(abs(at["A"] - a) < tolerance);
    CHECK(abs(at["B"] - (6 - 4 * a)) < tolerance);  // 2 of B, an amount, for each A
    CHECK(abs(at["w"] - 2 * a) < tolerance);        // an algebraic rule
    CHECK(abs(at["v"] - exp(mpfr(-2))) < tolerance);
    CHECK(abs(at["amount_e"] - 3) < tolerance);  // its concentration is 3/v
}

TEST_CASE("events and piecewise functions of a model are those of a problem", "[import]") {
    CHECK(output_of({"import", model("docs/examples/model.xml")}) ==
          "# A ramp that is reset, and a charge with two rates\nx' = 1\nresets' = 0\ny' = if(t < 1, 2, -1)*y\n"
          "x(0) = 0.5\nresets(0) = 0\ny(0) = 1\nwhen x >= 1: x = x - 1; resets = resets + 1\n");
}

TEST_CASE("combined conditions of a model are those of a problem", "[import]") {
    const std::string time =
        R"(<csymbol encoding="text" definitionURL="http://www.sbml.org/sbml/symbols/time">t</csymbol>)";
    const auto apply = [](const std::string& word, const std::string& operands) {
        return "<apply><" + word + "/>" + operands + "</apply>";
    };
    const std::string math = R"(<math xmlns="http://www.w3.org/1998/Math/MathML">)";
    const std::string inside =
        apply("and", apply("lt", "<cn>1</cn>" + time + "<cn>2</cn>") + apply("not", apply("eq", time + "<cn>3</cn>")));
    const std::string content =
        with_rate("<piecewise><piece><cn>4</cn>" + inside + "</piece><otherwise><cn>0</cn></otherwise></piecewise>") +
        "<listOfEvents><event useValuesFromTriggerTime=\"true\"><trigger initialValue=\"true\" persistent=\"true\">" +
        math +
        apply("or", apply("and", apply("geq", "<ci>x</ci><cn>4</cn>") + apply("lt", time + "<cn>5</cn>")) +
                        apply("neq", time + time)) +
        "</math></trigger><listOfEventAssignments><eventAssignment variable=\"x\">" + math +
        "<cn>0</cn></math></eventAssignment></listOfEventAssignments></event></listOfEvents>";
    const temporary_folder folder;
    const std::string printed = output_of({"import", file_with(folder, content)});
    CHECK(printed.find("x' = if(1 < t < 2 and not (t == 3), 4, 0)\n") != std::string::npos);
    CHECK(printed.find("when (x >= 4 and t < 5) or t != t: x = 0\n") != std::string::npos);
    // 1 up to t = 1, then 4 t - 3, which is 4 at 7/4, and again from 0.
    const answer found = solve(problem(printed))->states("3", proved_digits(20));
    CHECK(mpfr(found.at(0, "x")) == 1);
}

// x' = 1 where an odd number of t < 1, t < 2, t < 4 holds: on [0, 1] and [2, 4].
TEST_CASE("an odd number of operands of an exclusive or holds", "[import]") {
    const auto before = [](const std::string& time) {
        return R"(<apply><lt/><csymbol encoding="text" definitionURL="http://www.sbml.org/sbml/symbols/time">t</csymbol>)"
               "<cn>" +
               time + "</cn></apply>";
    };
    const temporary_folder folder;
    const std::string printed =
        output_of({"import", file_with(folder, with_rate("<piecewise><piece><cn>1</cn><apply><xor/>" + before("1") +
                                                         before("2") + before("4") +
                                                         "</apply></piece><otherwise><cn>0</cn></otherwise>"
                                                         "</piecewise>"))});
    const answer found = solve(problem(printed))->states("0,1/2,3/2,3,5", proved_digits(20));
    const mpfr start(found.at(0, "x"));
    CHECK(mpfr(found.at(1, "x")) == start + 0.5);
    CHECK(mpfr(found.at(2, "x")) == start + 1);
    CHECK(mpfr(found.at(3, "x")) == start + 2);
    CHECK(mpfr(found.at(4, "x")) == start + 3);
}

TEST_CASE("formulas of a model keep their order of operations", "[import]") {
    const std::vector<std::pair<std::string, std::string>> formulas{
        {"<apply><minus/><ci>x</ci><apply><minus/><ci>x</ci><cn>2</cn></apply></apply>", "x - (x - 2)"},
        {"<apply><divide/><cn>1</cn><apply><divide/><ci>x</ci><cn>2</cn></apply></apply>", "1/(x/2)"},
        {"<apply><power/><apply><minus/><ci>x</ci></apply><apply><power/><cn>2</cn><cn>3</cn></apply></apply>",
         "(-x)^(2^3)"},
        {"<apply><times/><apply><plus/><ci>x</ci><cn>-1.5</cn></apply><cn type=\"e-notation\">2<sep/>-400</cn></apply>",
         "(x + (-1.5))*2e-400"},
        {"<apply><root/><degree><cn>3</cn></degree><ci>x</ci></apply>", "x^(1/3)"},
        {"<apply><log/><logbase><cn>2</cn></logbase><ci>x</ci></apply>", "log(x)/log(2)"},
    };
    for (const auto& [mathml, text] : formulas) {
        const temporary_folder folder;
        const std::string printed = output_of({"import", file_with(folder, with_rate(mathml))});
        CHECK(printed.find("x' = " + text + "\n") != std::string::npos);
        CHECK_NOTHROW(ode::parse(printed));
    }
}

TEST_CASE("values of a test suite are compared with proved ones", "[import]") {
    const temporary_folder folder;
    const auto add = [&](const std::string& number, const std::string& variables, const std::string& results) {
        const auto place = folder.path() / number;
        std::filesystem::create_directory(place);
        std::filesystem::copy_file(model("tests/import/reactions.xml"), place / (number + "-sbml-l3v2.xml"));
        std::ofstream(place / (number + "-settings.txt"))
            << "start: 0\nduration: 2\nsteps: 1\nvariables: " + variables + "\nabsolute: 1e-9\nrelative: 1e-6\n";
        std::ofstream(place / (number + "-results.csv")) << results;
    };
    // A(2) = 3/2 exp(-1/2), s = A + B = 6 - 3 A, and e = 3 exp(2), a concentration in a volume that shrinks.
    add("00001", "A, s", "time,A,s\n0,1.5,1.5\n2,0.9097959896,3.270612031\n");
    add("00002", "A", "time,A\n0,1.5\n2,0.9098\n");
    const std::string line = "python3 -B '" + std::string(LIBRATION_SOURCE_DIR) + "/peers/sbml_suite.py' '" +
                             folder.path().string() + "' --program '" + LIBRATION_COMMAND + "' > '" +
                             (folder.path() / "printed").string() + "'";
    CHECK(WEXITSTATUS(std::system(line.c_str())) == 1);
    std::ifstream printed(folder.path() / "printed");
    std::string first;
    std::string second;
    std::getline(printed, first);
    std::getline(printed, second);
    CHECK(first == "00001  4 values agree");
    CHECK(second == "00002  beyond its tolerance  A(2) = 0.9098, proved 0.909795989568950");
}

// x' = -x(t - 1) and x = 1 before: x(2) = -1/2. Reactions and assignments are delayed by what they stand for.
TEST_CASE("delays of a model are those of a problem", "[import]") {
    const std::string delay =
        R"(<csymbol encoding="text" definitionURL="http://www.sbml.org/sbml/symbols/delay">delay</csymbol>)";
    const std::string time =
        R"(<csymbol encoding="text" definitionURL="http://www.sbml.org/sbml/symbols/time">t</csymbol>)";
    const auto delayed = [&](const std::string& of, const std::string& by) {
        return "<apply>" + delay + of + by + "</apply>";
    };
    const auto rule = [](const std::string& kind, const std::string& of, const std::string& formula) {
        return "<" + kind + " variable=\"" + of + R"("><math xmlns="http://www.w3.org/1998/Math/MathML">)" + formula +
               "</math></" + kind + ">";
    };
    const std::string parameters =
        R"(<listOfParameters><parameter id="x" value="1" constant="false"/><parameter id="z" value="2" constant="false"/>)"
        R"(<parameter id="u" value="0" constant="false"/>)"
        R"(<parameter id="tau" value="1" constant="true"/><parameter id="y" constant="false"/></listOfParameters>)";
    const temporary_folder folder;
    file_with(folder,
              parameters + "<listOfRules>" +
                  rule("rateRule", "x", "<apply><minus/>" + delayed("<ci>x</ci>", "<ci>tau</ci>") + "</apply>") +
                  rule("assignmentRule", "y", "<apply><times/><ci>x</ci>" + time + "</apply>") +
                  rule("rateRule", "z", delayed(delayed("<ci>y</ci>", "<cn>0.5</cn>"), "<ci>tau</ci>")) +
                  rule("rateRule", "u", "<ci>y</ci>") + "</listOfRules>");
    const std::string text = output_of({"import", (folder.path() / "model.xml").string()});
    CHECK(text ==
          "# A model in SBML\nx' = -x(t - tau)\nz' = x(t - (tau + 0.5))*(t - (tau + 0.5))\nu' = y\nx(t <= 0) = 1\n"
          "z(0) = 2\nu(0) = 0\ntau = 1\ny = x*t\n");
    const std::string values = output_of({"reference", "--problem", text, "--time", "2", "--digits", "12"});
    CHECK(values.find("x         -0.500000000000\n") != std::string::npos);
    CHECK(values.find("z         0.958333333333\n") != std::string::npos);  // 2 - 9/8 + 1/8 - 1/24
    CHECK(values.find("u         -0.375000000000\n") != std::string::npos);

    file_with(folder, with_rate(delayed("<ci>x</ci>", "<ci>x</ci>")));
    check_refused({"import", "model.xml"}, {"contains a delay that varies, which is not supported"}, folder);
}

// x' = twice(k) in a reaction with its own k = 3, although the model has another k; y = 0 from t = 1 on.
TEST_CASE("functions, local parameters, units and open piecewise functions of a model are imported", "[import]") {
    const std::string math = R"(<math xmlns="http://www.w3.org/1998/Math/MathML">)";
    const std::string time =
        R"(<csymbol encoding="text" definitionURL="http://www.sbml.org/sbml/symbols/time">t</csymbol>)";
    const temporary_folder folder;
    file_with(
        folder,
        "<listOfFunctionDefinitions><functionDefinition id=\"twice\">" + math +
            "<lambda><bvar><ci>x</ci></bvar><apply><times/><cn>2</cn><ci>x</ci></apply></lambda></math>"
            "</functionDefinition></listOfFunctionDefinitions>"
            "<listOfCompartments><compartment id=\"c\" size=\"1\" constant=\"true\"/></listOfCompartments>"
            "<listOfSpecies><species id=\"x\" compartment=\"c\" initialAmount=\"0\" hasOnlySubstanceUnits=\"true\" "
            "boundaryCondition=\"false\" constant=\"false\" substanceUnits=\"mole\"/></listOfSpecies>"
            "<listOfParameters><parameter id=\"k\" value=\"100\" constant=\"true\"/>"
            "<parameter id=\"y\" value=\"0\" constant=\"false\" units=\"second\"/></listOfParameters>"
            "<listOfRules><rateRule variable=\"y\">" +
            math + "<piecewise><piece><cn>1</cn><apply><lt/>" + time +
            "<cn>1</cn></apply></piece></piecewise></math></rateRule></listOfRules>"
            "<listOfReactions><reaction id=\"r\" reversible=\"false\"><listOfProducts><speciesReference species=\"x\" "
            "stoichiometry=\"1\" constant=\"true\"/></listOfProducts><kineticLaw>" +
            math +
            "<apply><ci>twice</ci><ci>k</ci></apply></math><listOfLocalParameters><localParameter id=\"k\" "
            "value=\"3\"/>"
            "</listOfLocalParameters></kineticLaw></reaction></listOfReactions>");
    const std::string text = output_of({"import", (folder.path() / "model.xml").string()});
    INFO(text);
    CHECK(text.find("# units: x in mole, y in second\n") != std::string::npos);
    CHECK(text.find("# piecewise functions without a value for all other cases are 0 there\n") != std::string::npos);
    CHECK(text.find("r = 2*r_k\n") != std::string::npos);
    const std::string values =
        run_libration({"reference", "--problem", text, "--time", "2", "--digits", "12"}).out;  // warns of k
    CHECK(values.find("x         12.0000000000\n") != std::string::npos);
    CHECK(values.find("y         1.00000000000\n") != std::string::npos);
}

// At x = 1 the value 10 x = 10 is kept, and assigned at 1 + 1/2, when x is 3/2.
TEST_CASE("an event with a delay is executed later", "[import]") {
    const std::string math = R"(<math xmlns="http://www.w3.org/1998/Math/MathML">)";
    const auto model = [&](const std::string& use) {
        return "<listOfParameters><parameter id=\"x\" value=\"0\" constant=\"false\"/><parameter id=\"y\" value=\"0\" "
               "constant=\"false\"/></listOfParameters><listOfRules><rateRule variable=\"x\">" +
               math +
               "<cn>1</cn></math></rateRule></listOfRules><listOfEvents><event id=\"late\" "
               "useValuesFromTriggerTime=\"" +
               use + "\"><trigger initialValue=\"true\" persistent=\"true\">" + math +
               "<apply><gt/><ci>x</ci><cn>1</cn></apply></math></trigger><delay>" + math +
               "<cn>0.5</cn></math></delay><listOfEventAssignments><eventAssignment variable=\"y\">" + math +
               "<apply><times/><cn>10</cn><ci>x</ci></apply></math></eventAssignment></listOfEventAssignments></event>"
               "</listOfEvents>";
    };
    const temporary_folder folder;
    const auto y_at = [&](const std::string& use, const std::string& time) {
        file_with(folder, model(use));
        const std::string text = output_of({"import", (folder.path() / "model.xml").string()});
        INFO(text);
        const auto rows = rows_of({"reference", "--problem", text, "--time", time, "--digits", "12"});
        return rows.at(0).at("y");
    };
    CHECK(y_at("true", "1.25") == "0");
    CHECK(number_of(y_at("true", "2")) == 10);
    CHECK(number_of(y_at("false", "2")) == 15);
}

TEST_CASE("what a problem cannot express is reported", "[import]") {
    const temporary_folder folder;
    check_refused({"import", "none.xml"}, {"FILE 'none.xml' is not read"}, folder);
    file_with(folder, with_rate("<apply><factorial/><ci>x</ci></apply>"));
    check_refused({"import", "model.xml"}, {"contains the function factorial, which is not supported"}, folder);
    file_with(folder,
              "<listOfParameters><parameter id=\"x\" constant=\"false\"/></listOfParameters>"
              "<listOfRules><algebraicRule><math xmlns=\"http://www.w3.org/1998/Math/MathML\"><cn>1</cn></math>"
              "</algebraicRule></listOfRules>");
    check_refused({"import", "model.xml"}, {"1 algebraic rules for 0 quantities"}, folder);
}

}  // namespace import_test
