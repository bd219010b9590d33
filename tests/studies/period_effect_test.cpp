// The study period_effect: periods against other arithmetic, values against (newseries) as printed, and what they mean.
#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <vector>

#include "libration/problem/known/pendulum.hpp"
#include "studies/study_rows.hpp"

namespace studies_period_effect_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

const study& period_effect() { return study_of("period_effect"); }

std::vector<table_row> rows_for(study_words words, std::size_t table = 0) {
    words.emplace("--step", "1e-2");
    return csv_rows(to_csv(tables_of(order_of(period_effect(), words, 2)).at(table).data));
}

}  // namespace

TEST_CASE("periods and angles are those of (Kold), (Knew) and (newseries) as printed", "[studies][period_effect]") {
    // mpmath at 60 digits, theta at t = 10 with N = 20: a_n by (pendseries), ahat_n by (b) and (approxcoeffs) with the
    // sign of (omegab) as it must be, T* and T from the partial sum, (newseries) at t + 3 T* (rotation t + T*, less 2
    // pi).
    struct expected_row {
        std::string energy, rule, period, theta, error;
    };
    const std::vector<expected_row> all{
        {"1.999800005", "series:100", "15.905202172886026387771086026425588", "-3.0713226736817947973462712857208518",
         "5.6656367028449829846054057755676"},
        {"1.999800005", "resummed:10", "23.921090332767661319338615139912558", "2.588167274725040694778422517772234",
         "0.0061467544381474924807119720745203"},
        {"2.000200005", "resummed:1", "11.856908998381627327393872768464784", "3.724097842234257402919648428611001",
         "0.035339691513241063346108481944807"},
        {"2.000200005", "series:100", "7.9522039675389432698394445766670677", "9.3574502331728600078022540083740321",
         "5.6686920824518436682287140617078"},
    };
    for (const expected_row& each : all) {
        INFO("E = " << each.energy << ", T* by " << each.rule);
        const auto rows = rows_for(
            {{"--energies", each.energy}, {"--period-by", each.rule}, {"--times", "10"}, {"--scalar", "mpfr:25"}});
        REQUIRE(rows.size() == 1);
        CHECK_THAT(rows[0].at("period"), right_to_the_last_digit(each.period));
        CHECK_THAT(rows[0].at("theta"), right_to_the_last_digit(each.theta));
        CHECK_THAT(rows[0].at("error"), right_to_the_last_digit(each.error));
    }
}

TEST_CASE("the usual energies are those of omega0 = 1.9999 and 2.0001 at the bottom", "[studies][period_effect]") {
    const auto request = order_of(period_effect(), {}, 1).request;
    const pendulum_sweep sweep(request.values);
    REQUIRE(sweep.energies.size() == 2);
    CHECK(sweep.energies[0].value.coefficient * 2 == rational(19999, 10000) * rational(19999, 10000));
    CHECK(sweep.energies[1].value.coefficient * 2 == rational(20001, 10000) * rational(20001, 10000));
}

TEST_CASE("an inexact T* puts the motion out of step by its error in every period", "[studies][period_effect]") {
    // At a bottom omega is 2 and next to constant over the shift p dT, of which dT^2 and the resummation are left out.
    const auto rows = rows_for({{"--energies", "1.9998"}, {"--period-by", "resummed:40"}, {"--times", "0:4T:5"}});
    REQUIRE(rows.size() == 5);
    const precision_scope scope(40);
    CHECK(rows[0].at("error") == "0");
    for (int p = 1; p <= 4; ++p) {
        const table_row& row = rows[static_cast<std::size_t>(p)];
        const mpfr predicted = number_of(row.at("period_error")) * p * 2;
        CHECK(abs(number_of(row.at("error")) / predicted - 1) < mpfr("1e-2"));
        CHECK(number_of(row.at("period_error")) > mpfr("1e-4"));
    }
}

TEST_CASE("with the exact T* only the resummation errs, and the numerical table is beside it",
          "[studies][period_effect]") {
    const auto rows = rows_for({{"--period-by", "agm"}, {"--times", "0:3T:61"}, {"--energies", "2.000200005"}});
    const precision_scope scope(40);
    for (const table_row& row : rows) {
        CHECK(row.at("period_error") == "0");
        CHECK(number_of(row.at("error")) < mpfr("1.5e-3"));
    }
    CHECK(rows[20].at("error") == "0");  // a bottom
    const auto numerical = rows_for({{"--times", "0:3T:61"}}, 1);
    CHECK(numerical.size() == 2 * 41);
    CHECK(numerical[0].at("method") == "rk4");
    CHECK(numerical[0].at("theta") == "0");
}

TEST_CASE("the effect of the period has no meaning at E = 0 and E = 2", "[studies][period_effect]") {
    for (const std::string energy : {"0", "2"}) {
        CHECK_THROWS_AS(rows_for({{"--energies", energy}}), libration::error);
    }
}

}  // namespace studies_period_effect_test
