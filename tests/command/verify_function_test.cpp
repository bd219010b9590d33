// `libration verify`: elliptic functions, compared with mpmath and tables.
#include <catch2/catch.hpp>
#include <string>

#include "command/verified.hpp"

namespace command_verify_function_test {

using namespace libration;
using namespace libration::tests;
using namespace libration::tests::verifying;

TEST_CASE("verify compares elliptic functions", "[command][verify]") {
    // mpmath, mp.dps = 40: ellipfun('sn', 0.7, m=0.3), 'cd'; ellipk(0.3), ellipe(-3), ellippi(0.25, 0.3),
    // ellipe(2, 0.3), asin(ellipfun('sn', ...)).
    const auto jacobi =
        verify_rows("u,m,sn,cd,am\n0.7,0.3,0.63230477631086454908,0.825827174402893594,0.6845246\n").rows;
    CHECK(jacobi.at(0).at("verdict") == "ok");
    CHECK_THAT(jacobi.at(0).at("reference"), right_to_the_last_digit("0.6845245936612939594588310516786254909193"));
    CHECK_THAT(jacobi.at(0).at("cd_reference"), right_to_the_last_digit("0.8258271744028935938916755988440416300621"));
    CHECK(verdict_of("k,K\n0.54772255750516611346,1.71388944817879\n") == "ok");
    CHECK(verdict_of("m1,E\n4,2.422112055136919050\n") == "ok");
    CHECK(verdict_of("m,n,Pi\n0.3,0.25,1.99173885354569\n") == "ok");
    CHECK(verdict_of("m,phi,E\n0.3,2,1.808964725363331\n") == "ok");
    CHECK(verdict_of("m,phi,E\n0.3,2,1.808964725363332\n", {"--relative", "1e-16"}) == "miss");
    CHECK(verdict_of("m,K\n1,inf\n") == "ok");
    CHECK(verdict_of("m,K\n1,1e300\n") == "miss");
    CHECK(verdict_of("parameter,K\n0.3,1.71388944817879\n", {"--columns", "parameter=m"}) == "ok");
    CHECK(verdict_of("u,m,sn\n0,0.3,1e-17\n", {"--relative", "1e-15"}) == "ok");
    CHECK(verify_rows("u,m,am\n0.7,0,0.7\n").rows.at(0).at("correct_digits") == "inf");
    CHECK(says(verify("m,sn\n0.3,0.6\n"), "f.csv has no column 'u', the argument of sn"));
    CHECK(says(verify("m,Pi\n0.3,0.6\n"), "f.csv has no column 'n'"));
    CHECK(says(verify("m,k,K\n0.3,0.6,1\n"), "f.csv has both 'k' and 'm'"));
    CHECK(says(verify("m,K\n2,1\n"), "f.csv:2: m '2' is above 1, where K is not real"));
    CHECK(says(verify("m,K\n0.3,1\n", {"--energy", "1"}), "--energy '1' has no meaning for elliptic functions"));
    CHECK(says(verify("u,m,sn\nx,0.3,1\n"), "f.csv:2: u 'x' is not a number"));
    CHECK(says(verify("u,m,sn\n1,0.3,?\n"), "f.csv:2: sn '?' is not a number"));
}

TEST_CASE("verify compares elliptic functions of complex arguments", "[command][verify]") {
    // mpmath, mp.dps = 45: ellipfun('sn', mpc('0.7', '1.2'), m=mpf('0.3')), 'dc'; at m = 2, K(2) is complex, and
    // sn(1.2i|0.3) = i sc(1.2|0.7).
    const std::string head = "u_re,u_im,m,sn_re,sn_im,dc_im\n";
    const auto row =
        verify_rows(head + "0.7,1.2,0.3,1.28667283558101798,0.928044558960483513,0.235787434610773460\n").rows.at(0);
    CHECK(row.at("verdict") == "ok");
    CHECK_THAT(row.at("reference"), right_to_the_last_digit("1.28667283558101798180149601441822329971371"));
    CHECK_THAT(row.at("sn_im_reference"), right_to_the_last_digit("0.928044558960483512883160300913089008960405"));
    CHECK_THAT(row.at("dc_im_reference"), right_to_the_last_digit("0.23578743461077345982139872203072922884816"));
    CHECK(verdict_of(head + "0.7,1.2,0.3,1.28667283558101798,0.928044558960483513,0.235787434610773462\n") == "miss");
    CHECK(verdict_of("u,m,sn_re\n0.7+1.2i,0.3,1.286672835581018\n") == "ok");
    CHECK(verdict_of("u,m,sn_re\n0.7-1.2i,0.3,1.286672835581018\n") == "ok");
    CHECK(verdict_of("u,m,sn_im\n0.7-1.2i,0.3,0.928044558960484\n") == "miss");
    // Exact zeros, measured by the size of the value; poles; a real argument.
    CHECK(verify_rows("u,m,sn_re,sn_im\ni,0.5,0,1.34737147138541895\n").rows.at(0).at("correct_digits") == "inf");
    CHECK(verdict_of("u,m,sn_re\ni,0.5,1e-17\n", {"--relative", "1e-15"}) == "ok");
    CHECK(verdict_of("u,m,sn_re\npi/2*i,1,inf\n") == "ok");
    CHECK(verdict_of("u,m,sn_re\npi/2*i,1,1e300\n") == "miss");
    CHECK(verdict_of("u,m,sn_re,sn_im\n0.7,0.3,0.63230477631086454908,0\n") == "ok");
    // The doubles next to the arguments.
    CHECK(verdict_of("u_re,u_im,m,sn_re\n0.7,1.2,0.3,1.28667283558101798180\n", {"--inputs", "double"}) == "miss");
    CHECK(says(verify("u,m,sn\n1+2i,0.5,1\n"), "f.csv:2: u '1+2i' is complex: give the columns sn_re and sn_im"));
    CHECK(says(verify("u,m,am\n1+2i,0.5,1\n"), "f.csv:2: u '1+2i' is complex, which am does not take"));
    CHECK(says(verify("u,m,sn_re\n1+2x,0.5,1\n"), "f.csv:2: u '1+2x' is not a number"));
    CHECK(says(verify("u_im,m,sn_re\n1,0.5,1\n"), "f.csv has 'u_im' alone of u_re and u_im"));
    CHECK(says(verify("u,m,sn,sn_im\n1,0.5,1,1\n"), "f.csv has both 'sn' and 'sn_im'"));
    CHECK(says(verify("u,m,am_re\n1,0.5,1\n"), "f.csv has no column"));
}

// K(sin 30deg) is that of m = 1/4 [Abramowitz, table 17.2].
TEST_CASE("verify reads the modular angle of Abramowitz and Stegun", "[command][verify]") {
    for (const char* const file : {"alpha,K\n30deg,1.68575035481260\n", "alpha (deg),K\n30,1.68575035481260\n",
                                   "Alpha,K\npi/6,1.68575035481260\n", "m,K\n1/4,1.68575035481260\n"}) {
        CAPTURE(file);
        CHECK(verdict_of(file) == "ok");
    }
    CHECK(verdict_of("alpha,K\n30,1.68575035481260\n") == "miss");
    CHECK(output_of({"elliptic", "K", "--alpha", "30deg"}).find("1.6857503548125960") != std::string::npos);
}

}  // namespace command_verify_function_test
