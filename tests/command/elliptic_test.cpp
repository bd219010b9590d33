// The proved digits of `libration elliptic` compared with the reference tables, mpmath, exact values and identities; at
// any real parameter also with the theta functions of Arb.
#include <array>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "command/printed.hpp"
#include "command/refusal.hpp"

namespace command_elliptic_test {

using namespace libration;
using namespace libration::tests;

namespace {

std::vector<table_row> elliptic_of(words line) {
    line.insert(line.begin(), "elliptic");
    return rows_of(line);
}

std::string elliptic_value(const words& line) {
    const auto rows = elliptic_of(line);
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].at("rigour") == "proved");
    return rows[0].at("value");
}

// The tables contain k'; the command accepts m1 = k'^2 as a fraction.
std::string complement_of(const std::string& kc) {
    const rational root = read_exact(kc).coefficient;
    return rational(root * root).str();
}

// The rows of a table with the same k', arguments joined.
struct arguments_at {
    std::string kc;
    std::string list;
    std::vector<table_row> rows;
};
std::vector<arguments_at> grouped(const std::string& table, const std::string& argument) {
    std::vector<arguments_at> groups;
    for (const table_row& row : reference_table(table)) {
        if (groups.empty() || groups.back().kc != row.at("kc")) {
            groups.push_back({row.at("kc"), "", {}});
        }
        arguments_at& group = groups.back();
        group.list += (group.list.empty() ? "" : ",") + row.at(argument);
        group.rows.push_back(row);
    }
    return groups;
}

void check_refused(const words& line, const std::string& mentioned) {
    tests::check_refused(words{"elliptic"} + line, {mentioned});
}

}  // namespace

TEST_CASE("am, sn, cn and dn have the digits of the reference table", "[command][elliptic]") {
    for (const arguments_at& group : grouped("jacobi.csv", "u")) {
        for (const std::string function : {"am", "sn", "cn", "dn"}) {
            INFO(function << " at k' = " << group.kc);
            const auto rows = elliptic_of({function, "--u=" + group.list, "--m1", complement_of(group.kc)});
            REQUIRE(rows.size() == group.rows.size());
            for (std::size_t i = 0; i < rows.size(); ++i) {
                INFO("u = " << rows[i].at("argument"));
                CHECK_THAT(rows[i].at("value"), right_to_the_last_digit(group.rows[i].at(function)));
            }
        }
    }
}

TEST_CASE("F and K have the digits of the reference table", "[command][elliptic]") {
    for (const arguments_at& group : grouped("incomplete.csv", "phi")) {
        INFO("k' = " << group.kc);
        const auto rows = elliptic_of({"F", "--phi=" + group.list, "--m1", complement_of(group.kc)});
        REQUIRE(rows.size() == group.rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            INFO("phi = " << rows[i].at("argument"));
            CHECK_THAT(rows[i].at("value"), right_to_the_last_digit(group.rows[i].at("F")));
        }
    }
    for (const table_row& row : reference_table("complete.csv")) {
        INFO("k' = " << row.at("kc"));
        CHECK_THAT(elliptic_value({"K", "--m1", complement_of(row.at("kc"))}), right_to_the_last_digit(row.at("K")));
        CHECK_THAT(elliptic_value({"K", "--m", complement_of(row.at("kc"))}),
                   right_to_the_last_digit(row.at("K_complementary")));
    }
}

TEST_CASE("a complementary parameter of 1e-30 keeps its digits", "[command][elliptic]") {
    // mpmath, mp.dps = 120, m = 1 - mpf('1e-30'): sn = ellipfun('sn', u, m=m), am(1.5) = asin(sn(1.5)), ellipk(m),
    // ellipf(1.5, m).
    const words parameter{"--m1", "1e-30"};
    CHECK_THAT(elliptic_value(words{"am", "--u", "1.5"} + parameter),
               right_to_the_last_digit("1.13172834525050909374296939069601703268288911115997434443763"));
    CHECK_THAT(elliptic_value(words{"sn", "--u", "1.5"} + parameter),
               right_to_the_last_digit("0.905148253644866438242303696456654119301455983569368334445685"));
    CHECK_THAT(elliptic_value(words{"cn", "--u", "40"} + parameter),
               right_to_the_last_digit("-2.94146616461169149979968303674214728300497182284077959913104e-14"));
    CHECK_THAT(elliptic_value(words{"dn", "--u", "40"} + parameter),
               right_to_the_last_digit("2.94316550631380813539781473065420437116017569194193996522435e-14"));
    CHECK_THAT(elliptic_value(words{"K"} + parameter),
               right_to_the_last_digit("35.9250707560305758791043360631905475178565302421218812327571"));
    CHECK_THAT(elliptic_value(words{"F", "--phi", "1.5"} + parameter),
               right_to_the_last_digit("3.34067754279831100332081266898868657537007845874054920924997"));
}

TEST_CASE("huge arguments and other forms of the modulus agree with mpmath", "[command][elliptic]") {
    // mpmath, mp.dps = 200: ellipfun('sn', mpf('1e20'), m=mpf('0.64')); ellipf(3*pi/4, mpf('0.64')).
    const std::string sn = "-0.533673950861330381426750756987710942534671167603986448454561";
    for (const words& form : {words{"--k", "0.8"}, words{"--k", "4/5"}, words{"--m", "0.64"}, words{"--m1", "0.36"}}) {
        CHECK_THAT(elliptic_value(words{"sn", "--u", "1e20"} + form), right_to_the_last_digit(sn));
    }
    const std::string f = "3.15098320852537765655773963851607310230942019040726327848957";
    CHECK_THAT(elliptic_value({"F", "--phi", "135deg", "--k", "0.8"}), right_to_the_last_digit(f));
    CHECK_THAT(elliptic_value({"F", "--phi", "3pi/4", "--k", "0.8"}), right_to_the_last_digit(f));
}

TEST_CASE("both ends of the parameter are the circle and the hyperbola", "[command][elliptic]") {
    const precision_scope scope(100);
    const mpfr u("0.7");
    CHECK_THAT(elliptic_value({"sn", "--u", "0.7", "--m", "0"}), right_to_the_last_digit_of(sin(u)));
    CHECK_THAT(elliptic_value({"am", "--u", "0.7", "--m", "0"}), right_to_the_last_digit_of(u));
    CHECK_THAT(elliptic_value({"sn", "--u", "0.7", "--m", "1"}), right_to_the_last_digit_of(tanh(u)));
    CHECK_THAT(elliptic_value({"cn", "--u", "0.7", "--m", "1"}), right_to_the_last_digit_of(1 / cosh(u)));
    CHECK_THAT(elliptic_value({"dn", "--u", "0.7", "--k", "1"}), right_to_the_last_digit_of(1 / cosh(u)));
    CHECK_THAT(elliptic_value({"am", "--u", "0.7", "--m1", "0"}), right_to_the_last_digit_of(atan(sinh(u))));
    CHECK_THAT(elliptic_value({"F", "--phi", "0.7", "--m", "1"}), right_to_the_last_digit_of(asinh(tan(u))));
    CHECK(elliptic_value({"K", "--m", "1"}) == "inf");
    const auto ends = elliptic_of({"F", "--phi=90deg,2,-2,-pi/2", "--m", "1"});
    REQUIRE(ends.size() == 4);
    CHECK((ends[0].at("value") == "inf" && ends[1].at("value") == "inf"));
    CHECK((ends[2].at("value") == "-inf" && ends[3].at("value") == "-inf"));
}

TEST_CASE("exact zeros are printed as 0", "[command][elliptic]") {
    CHECK(elliptic_value({"cn", "--u", "pi/2", "--m", "0"}) == "0");
    CHECK(elliptic_value({"sn", "--u", "1000000pi", "--m", "0"}) == "0");
    CHECK(number_of(elliptic_value({"sn", "--u=-7pi/2", "--m", "0"})) == 1);
    for (const std::string parameter : {"0", "0.5", "1"}) {
        CHECK(elliptic_value({"am", "--u", "0", "--m", parameter}) == "0");
        CHECK(elliptic_value({"sn", "--u", "0", "--m", parameter}) == "0");
        CHECK(elliptic_value({"F", "--phi", "0", "--m", parameter}) == "0");
    }
}

TEST_CASE("F of quarter turns is a multiple of K", "[command][elliptic]") {
    const precision_scope scope(100);
    const mpfr k = number_of(elliptic_value({"K", "--m", "1/3", "--digits", "80"}));
    CHECK_THAT(elliptic_value({"F", "--phi", "90deg", "--m", "1/3"}), right_to_the_last_digit_of(k));
    CHECK_THAT(elliptic_value({"F", "--phi=-3pi/2", "--m", "1/3"}), right_to_the_last_digit_of(-k * 3));
}

TEST_CASE("the twelve functions have the digits of mpmath at any real parameter", "[command][elliptic]") {
    // mpmath, mp.dps = 40: ellipfun('sn', mpf('0.7'), m=mpf(m)), 'cn', 'dn'.
    struct at_parameter {
        std::string m, sn, cn, dn;
    };
    const precision_scope scope(60);
    for (const at_parameter& at :
         {at_parameter{"0.3", "0.6323047763108645490812191825821323185345",
                       "0.7747197363269297438229956056194779720777", "0.938113639681430206912692089169479477682"},
          {"-3", "0.7591134204870377003709223641806748036971", "0.6509583818006108836985725839095074477156",
           "1.651895745950872750505358025381992096943"},
          {"1.5", "0.5843406259594525761768376741064387187518", "0.811508492163400060889741311633158422313",
           "0.6984404407535210206959679278007175326193"}}) {
        const auto letter = [&](char c) {
            return c == 's' ? number_of(at.sn) : c == 'c' ? number_of(at.cn) : c == 'd' ? number_of(at.dn) : mpfr(1);
        };
        const words line{"table", "sn,cn,dn,cd,sd,nd,dc,nc,sc,ns,ds,cs", "--u", "0.7", "--m=" + at.m, "--digits"};
        const auto rows = csv_rows(output_of(line + words{"36"}));
        const auto precise = csv_rows(output_of(line + words{"60"}));
        REQUIRE((rows.size() == 12 && precise.size() == 12));
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const std::string f = rows[i].at("function");
            INFO(f << " at m = " << at.m);
            CHECK_THAT(rows[i].at("value"), right_to_the_last_digit_of(letter(f[0]) / letter(f[1])));
            // The inverse function returns the argument within the first quarter period (K = 1.078 at m = -3).
            const words inverse{"arc" + f, "--x", precise[i].at("value"), "--m=" + at.m};
            CHECK(abs(number_of(elliptic_value(inverse)) - number_of("0.7")) < number_of("1e-48"));
        }
    }
}

TEST_CASE("integrals of all kinds, zeta and nome have the digits of mpmath", "[command][elliptic]") {
    // mpmath, mp.dps = 40: ellipe, ellipf, ellipk, ellippi, D = (F - E)/m, Z = E(phi) - E/K F(phi), qfrom(m=m).
    const std::vector<std::pair<words, std::string>> known{
        {{"E", "--m", "0.3"}, "1.44536306441266526201161760148028223038"},
        {{"E", "--m=-3"}, "2.422112055136919049607125799097957352988"},
        {{"E", "--phi", "2", "--m", "0.3"}, "1.808964725363331210483607136494605765325"},
        {{"E", "--phi", "0.5", "--m", "1.5"}, "0.4684807444890465423055998429195413363823"},
        {{"F", "--phi", "2", "--m=-3"}, "1.29792783928044045759951652125128228189"},
        {{"F", "--phi", "0.5", "--m", "1.5"}, "0.5356824613735428840332613026498975380982"},
        {{"K", "--m=-3"}, "1.078257823749821617719337499400161014432"},
        {{"Pi", "--n", "0.25", "--m", "0.3"}, "1.991738853545691506820146806438801909036"},
        {{"Pi", "--n=-2", "--phi", "1.2", "--m", "0.3"}, "0.8154111218319485640428559826059874537078"},
        {{"D", "--m", "0.3"}, "0.8950879458870860000910574785451180590951"},
        {{"D", "--m=-3"}, "0.4479514104623658106292627665659321128521"},
        {{"D", "--phi", "2", "--m", "0.3"}, "1.372086089217143455000576793200255357134"},
        {{"D", "--phi", "0.5", "--m", "1.5"}, "0.04480114458966422781844097315357080114392"},
        {{"Zeta", "--phi", "1.2", "--m", "0.3"}, "0.05709704233238921807702805088847625467311"},
        {{"Zeta", "--phi", "1.2", "--m=-3"}, "-0.3052443989859671235113265890037843295666"},
        {{"nome", "--m", "0.3"}, "0.02227743615715350822901627011198294308948"},
        {{"nome", "--m=-3"}, "-0.08579573370219476651684045332013664996847"},
        {{"arcsn", "--x", "0.5", "--m", "0.3"}, "0.5306368995398674250127088603949237317458"},
        {{"arccn", "--x=-0.5", "--m", "0.3"}, "2.328643673265539114442582329298148382642"}};
    for (const auto& [line, expected] : known) {
        INFO(command_line(line));
        CHECK_THAT(elliptic_value(line + words{"--digits", "36"}), right_to_the_last_digit(expected));
    }
}

TEST_CASE("the twelve functions at complex arguments have the digits of mpmath", "[command][elliptic]") {
    // mpmath, mp.dps = 45: ellipfun('sn', mpc('0.7', '1.2'), m=mpf(m)), 'dc'.
    struct known_value {
        std::string function, m, real, imaginary;
    };
    for (const known_value& each :
         {known_value{"sn", "0.3", "1.28667283558101798180149601441822329971371",
                      "0.928044558960483512883160300913089008960405"},
          {"dc", "0.3", "0.616977230258932568230426348525898443775347", "0.23578743461077345982139872203072922884816"},
          {"sn", "-3", "-0.806534909469170546969304114697964672552538", "0.71558069722900058290427375427480087703159"},
          {"dc", "-3", "-0.793195550865023385171990026295523902010915", "1.40286968528436444614828763610460141196449"},
          {"sn", "1.5", "1.29776547220736190043604384250261584327443", "0.261170253177050688446214501989991256723306"},
          {"dc", "1.5", "1.37430696076014098811709915591039555144698",
           "-0.146983476353898909842150860926049579215071"}}) {
        const auto rows = elliptic_of({each.function, "--u", "0.7+1.2i", "--m=" + each.m, "--digits", "36"});
        CHECK_THAT(rows.at(0).at("value"), right_to_the_last_digit(each.real));
        CHECK_THAT(rows.at(0).at("imaginary"), right_to_the_last_digit(each.imaginary));
    }
    // sn(iy|m) = i sc(y|1-m), cn(iy|m) = nc(y|1-m) [DLMF 22.6.19]; the other parts are 0. Together with poles and real
    // arguments.
    const auto on_axis = elliptic_of({"sn", "--u=-1.2i,0.7,0.7-1e-1*i,i", "--m", "0.3"});
    REQUIRE(on_axis.size() == 4);
    CHECK(on_axis[0].at("value") == "0");
    CHECK(on_axis[0].at("imaginary") == "-" + elliptic_value({"sc", "--u", "1.2", "--m1", "0.3"}));
    CHECK((on_axis[1].at("imaginary") == "0" &&
           on_axis[1].at("value") == elliptic_value({"sn", "--u", "0.7", "--m", "0.3"})));
    CHECK(on_axis[2].at("imaginary").starts_with("-0.0"));
    const auto secant = elliptic_of({"cn", "--u", "1.2i", "--m", "0.3"}).at(0);
    CHECK((secant.at("imaginary") == "0" && secant.at("value") == elliptic_value({"nc", "--u", "1.2", "--m1", "0.3"})));
    CHECK(elliptic_of({"sn", "--u", "pi/2*i", "--m", "1"}).at(0).at("value") == "inf");
    check_refused({"sn", "--u", "1+xi", "--m", "0.3"}, "--u '1+xi'");
    check_refused({"am", "--u", "1+2i", "--m", "0.3"}, "--u '1+2i'");
}

TEST_CASE("theta functions have the digits of mpmath and their zeros", "[command][elliptic]") {
    // mpmath, mp.dps = 45: jtheta(j, mpf('0.5'), mpf(q)).
    const std::vector<std::array<std::string, 3>> known{
        {"theta1", "0.1", "0.527983605456447412474452275120940595310534"},
        {"theta2", "0.1", "0.987796549635890838119452277857836056248134"},
        {"theta3", "0.1", "1.10797722982633339107317277730960374557794"},
        {"theta4", "0.1", "0.891856311439047490514579849953830097719558"},
        {"theta1", "0.9", "0.00010255294415899876935084359043504742523265"},
        {"theta2", "0.9", "0.509025691789701288889677621165240615636109"},
        {"theta3", "0.9", "0.509025691789701288889677621353607747276387"},
        {"theta4", "0.9", "0.000102552944159021803906252763262719961863008"},
        {"theta3", "-0.3", "0.669116004144182651417310396645177637679034"}};
    for (const auto& [function, q, expected] : known) {
        INFO(function << " " << q);
        CHECK_THAT(elliptic_value({function, "--z", "0.5", "--q=" + q, "--digits", "36"}),
                   right_to_the_last_digit(expected));
    }
    CHECK((elliptic_value({"theta1", "--z", "3pi", "--q", "0.1"}) == "0" &&
           elliptic_value({"theta2", "--z=-pi/2", "--q", "0.1"}) == "0"));
    CHECK((elliptic_value({"theta1", "--z", "1", "--q", "0"}) == "0" &&
           number_of(elliptic_value({"theta3", "--z", "1", "--q", "0"})) == 1));
    check_refused({"theta1", "--z", "1", "--q", "1"}, "q '1' is not between -1 and 1");
    check_refused({"theta1", "--z", "1", "--q=-0.1"}, "q '-0.1' is negative");
    check_refused({"theta1", "--z", "1", "--m", "0.5"}, "--m '0.5'");
    check_refused({"theta1", "--z", "1"}, "--q");
    check_refused({"sn", "--u", "1", "--q", "0.5"}, "--q '0.5'");
}

TEST_CASE("the integrals satisfy Legendre's relation and their limits", "[command][elliptic]") {
    const precision_scope scope(120);
    for (const std::string m1 : {"0.5", "1e-30", "0.999"}) {
        INFO(m1);
        const auto at = [&](const std::string& function, const std::string& option) {
            return number_of(elliptic_value({function, option, m1, "--digits", "90"}));
        };
        const mpfr e = at("E", "--m1");
        const mpfr k = at("K", "--m1");
        const mpfr e_prime = at("E", "--m");
        const mpfr k_prime = at("K", "--m");
        CHECK(abs(e * k_prime + e_prime * k - k * k_prime - pi<mpfr>() / 2) < number_of("1e-85"));
        CHECK_THAT(elliptic_value({"D", "--m1", m1}), right_to_the_last_digit_of((k - e) / (1 - number_of(m1))));
        CHECK_THAT(elliptic_value({"nome", "--m1", m1}), right_to_the_last_digit_of(exp(-pi<mpfr>() * k_prime / k)));
        // The same integral to a whole turn, and Pi at n = 0 and n = m [DLMF 19.6.2].
        CHECK_THAT(elliptic_value({"E", "--phi", "360deg", "--m1", m1}), right_to_the_last_digit_of(e * 4));
        CHECK_THAT(elliptic_value({"D", "--phi=-90deg", "--m1", m1}),
                   right_to_the_last_digit_of((e - k) / (1 - number_of(m1))));
        CHECK_THAT(elliptic_value({"Pi", "--n", "0", "--m1", m1}), right_to_the_last_digit_of(k));
        CHECK_THAT(elliptic_value({"Pi", "--n", "1-" + m1, "--m1", m1}), right_to_the_last_digit_of(e / number_of(m1)));
    }
    const auto value = [](const words& line) { return elliptic_value(line + words{"--digits", "5"}); };
    CHECK((value({"E", "--m", "1"}) == "1.0000" && value({"D", "--m", "1"}) == "inf" &&
           value({"nome", "--m", "1"}) == "1.0000"));
    CHECK((value({"nome", "--m", "0"}) == "0" && value({"Zeta", "--phi", "3pi/2", "--m", "0.3"}) == "0"));
    CHECK((value({"D", "--m", "0"}) == "0.78540" && value({"E", "--phi", "0.5", "--m", "0"}) == "0.50000"));
    CHECK((value({"ns", "--u", "0", "--m", "0.3"}) == "inf" && value({"nc", "--u", "pi/2", "--m", "0"}) == "inf"));
    CHECK((value({"sd", "--u", "0", "--m", "2"}) == "0" && value({"cd", "--u", "3", "--m", "1"}) == "1.0000"));
    CHECK((value({"Pi", "--n", "1", "--m", "0.3"}) == "inf" && value({"arcsn", "--x=-1", "--m", "1"}) == "-inf"));
    CHECK((value({"Pi", "--n", "0.5", "--phi=-2", "--m", "1"}) == "-inf" &&
           value({"F", "--phi", "1", "--m", "1"}) == "1.2262"));
}

TEST_CASE("what is not real is refused with the parameter", "[command][elliptic]") {
    check_refused({"K", "--m", "1.5"}, "m '1.5' is above 1, where K is not real");
    check_refused({"E", "--phi", "2", "--m", "1.5"}, "m '1.5'");
    check_refused({"E", "--phi", "1.2", "--m", "1.5"}, "m '1.5'");
    check_refused({"Pi", "--n", "1.5", "--m", "0.5"}, "n '1.5' makes the integral pass a pole");
    check_refused({"Pi", "--m", "0.5"}, "add --n N");
    check_refused({"E", "--n", "1", "--m", "0.5"}, "--n '1'");
    check_refused({"arcsn", "--x", "1.01", "--m", "0.5"}, "x '1.01' is not a value of sn");
    check_refused({"arcnd", "--x", "0", "--m", "0.5"}, "x '0'");
    check_refused({"arcsn", "--u", "0.5", "--m", "0.5"}, "--u '0.5'");
    check_refused({"sn", "--u", "1", "--k=-0.5"}, "--k '-0.5'");
}

TEST_CASE("what is no elliptic function, modulus or argument is refused", "[command][elliptic]") {
    check_refused({"sm", "--u", "1", "--m", "0.5"}, "'sm'");
    check_refused({"sn", "--u", "1"}, "--m1");
    check_refused({"sn", "--m", "0.5"}, "--u");
    check_refused({"sn", "--phi", "1", "--m", "0.5"}, "--phi '1'");
    check_refused({"F", "--u", "1", "--m", "0.5"}, "--u '1'");
    check_refused({"K", "--u", "1", "--m", "0.5"}, "--u '1'");
    check_refused({"sn", "--u", "T/4", "--m", "0.5"}, "T/4");
    check_refused({"sn", "--u", "1", "--m", "0.5", "--k", "0.5"}, "one of");
    for (const std::string option : {"--k", "--m", "--m1"}) {
        for (const std::string value : {"pi/4", "x"}) {
            check_refused({"sn", "--u", "1", option, value}, option + " '" + value + "'");
        }
    }
}

TEST_CASE("complex arguments have condition numbers", "[command][elliptic]") {
    // At m = 0, which is exact, sn = sin and cn = cos: (|x| + |y|) |cos z/sin z| at 1 + 2i, by
    // |cot z|^2 = (cos^2 x + sinh^2 y)/(sin^2 x + sinh^2 y) = 0.969980.
    CHECK(elliptic_of({"sn", "--u", "1+2i", "--m", "0"})[0].at("condition") == "2.95");
    CHECK(elliptic_of({"cn", "--u", "1+2i", "--m", "0"})[0].at("condition") == "3.05");
    // Near the real axis it is that of the real argument plus |y f'/f|, a thousandth.
    const auto rows = elliptic_of({"sn", "--u", "1,1+0.001i", "--m", "1/2"});
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].at("condition").substr(0, 3) == rows[1].at("condition").substr(0, 3));
}

}  // namespace command_elliptic_test
