// Studies of any equation: each runs on its example, keeps the contract of its columns, and its rows follow from the
// inputs of a cell alone. A new one is in here by itself.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "studies/study_rows.hpp"
#include "sweep/named_order.hpp"
#include "sweep/study_files.hpp"
#include "text/input_error.hpp"

namespace studies_equation_studies_test {

using namespace libration;
using namespace libration::tests;

namespace {

study_order quick_order(const study& what, int jobs) {
    return order_asked("study", what.name, what.any_equation->example, what.any_equation->quick, jobs);
}

std::vector<table_row> rows_about(const std::string& name, const equation_words& asked, const study_words& words,
                                  std::size_t table = 0) {
    return rows_of_table(tables_of(order_asked("study", name, asked, words, 2)).at(table));
}

std::string header_of(const study_table& part) { return to_csv(table(part.data.columns())); }

}  // namespace

TEST_CASE("each study of any equation says what it is then, and has an example", "[studies][equation]") {
    for (const study* each : studies_of_equations()) {
        INFO(each->name);
        const auto about = order_asked("study", each->name, each->any_equation->example, {}, 1).made;
        CHECK(about->question.ends_with("?"));
        CHECK(about->reading.ends_with("."));
        CHECK(about->seconds > 0);
        CHECK(about->title.ends_with(": " + about->equation->name));
        CHECK_NOTHROW(example_of(*each, 1));
        CHECK(order_from(example_of(*each, 1).command, 1).command == example_of(*each, 1).command);
    }
}

TEST_CASE("a study without --problem and with it is one of the registry", "[studies][equation]") {
    const study_words words{{"--times", "0:2:41"}, {"--orders", "4"}};
    const auto order = order_asked("study", "error_norm", equation_words{"x''=-sin(x); x(0)=2; x'(0)=0", {}}, words, 1);
    CHECK(order.what->script == study_named("study", "error_norm").name);
    CHECK_THROWS_WITH(order_asked("study", "coefficients", std::nullopt, {}, 1), Catch::Contains("add --problem P"));
    CHECK_THROWS_WITH(order_asked("study", "surface", equation_words{"lorenz", {}}, {}, 1),
                      Catch::Contains("is not supported by the study surface"));
}

TEST_CASE("each study of any equation makes tables that depend on its inputs alone", "[studies][equation]") {
    for (const study* each : studies_of_equations()) {
        INFO(each->name);
        const study_order order = quick_order(*each, 2);
        const auto tables = tables_of(order);
        CHECK(has_different_keys(order));
        const auto again = tables_cell_by_cell(order);
        std::set<std::string> suffixes;
        for (std::size_t i = 0; i < tables.size(); ++i) {
            const study_table& part = tables[i];
            INFO(part.suffix);
            suffixes.insert(part.suffix);
            CHECK_FALSE(part.data.rows().empty());
            std::set<std::string> columns;
            for (const column& c : part.data.columns()) {
                columns.insert(c.name);
                CHECK_FALSE(c.meaning.empty());
            }
            CHECK(columns.size() == part.data.columns().size());
            CHECK(columns.contains("unknown"));
            CHECK((part.timed || each->alone || to_csv(part.data) == to_csv(again.at(i).data)));
        }
        CHECK(suffixes.size() == tables.size());
        CHECK(suffixes.contains(""));
    }
}

TEST_CASE("parameters and starts of an equation are axes in front of the columns", "[studies][equation]") {
    const equation_words asked{"y'' = 3/2*w*y^2; y(0) = 1; y'(0) = 0; w = 1; n = 2; order = 1",
                               {"y'(0)=1/3", "order=1", "w=1:2:2"}};
    const auto tables =
        tables_of(order_asked("study", "error_norm", asked, {{"--times", "0:1:3"}, {"--orders", "4"}}, 1));
    const std::string header = header_of(tables.front());
    CHECK(header.starts_with("w,set_order,y'(0),order,method,norm,"));
    CHECK(header.ends_with(",unknown,y'(0)_typed\n"));
    const auto rows = rows_of_table(tables.front());
    REQUIRE(rows.size() == 10);  // of five methods
    CHECK(rows.front().at("w") == "1");
    CHECK(rows.back().at("w") == "2");
    CHECK(rows.back().at("y'(0)_typed") == "1/3");
    CHECK(rows.back().at("y'(0)").starts_with("0.33333333"));
}

TEST_CASE("norms of an equation with a closed solution are those of the closed form", "[studies][equation]") {
    // y = 1/(2 - t): the rest of the geometric series at t = 1 is 2^-(N+1); its Pade approximant is exact.
    const equation_words asked{"y' = y^2; y(0) = 1/2", {}};
    for (const table_row& row : rows_about("error_norm", asked, {{"--times", "0:1:5"}, {"--orders", "3,8"}})) {
        INFO(row.at("method") << " " << row.at("order"));
        if (row.at("method") == "series") {
            CHECK(number_of(row.at("norm")) == (row.at("order") == "3" ? mpfr(1) / 16 : mpfr(1) / 512));
            CHECK(row.at("time_of_maximum") == "1");
            CHECK(row.at("rigour") == "two-method");
        } else if (row.at("method") == "pade") {
            CHECK(row.at("norm") == "0");
        } else if (row.at("method") == "euler" || row.at("method") == "gauge") {
            CHECK(row.at("norm").empty());  // too few coefficients for a radius, and no scale is given
        } else {
            // y - p = (t - 1)^2 t^(N+1) r(t) with the pole's residue: r = c/(2 - t), c (2 - 1)^2 2^(N+1) = 1 at t = 2.
            const bool low = row.at("order") == "3";
            const precision_scope scope(30);
            mpfr largest(0);
            for (int i = 0; i <= 4; ++i) {
                const mpfr t = mpfr(i) / 4;
                const mpfr error = pow(t, low ? 4 : 9) * (1 - t) * (1 - t) / ((2 - t) * (low ? 16 : 512));
                largest = error > largest ? error : largest;
            }
            CHECK(abs(number_of(row.at("norm")) - largest) <= last_place(row.at("norm")));
        }
    }
}

TEST_CASE("a parameter without a solution fails its cell alone", "[studies][equation]") {
    const equation_words asked{"y' = log(y); y(0) = c; c = 1", {"c=0,2"}};
    const auto answers =
        answers_of(order_asked("study", "error_norm", asked, {{"--times", "0:1:3"}, {"--orders", "4"}}, 1));
    CHECK(answers.failures.count == 2);  // the norms and the radii of c = 0
    CHECK(answers.failures.first.front().inputs.starts_with("c=0 "));
    CHECK(rows_of_table(answers.tables.front()).size() == 5);
}

TEST_CASE("approximants over b meet the wall shears of Falkner and Skan in print", "[studies][equation]") {
    const equation_words asked{"falkner_skan", {"b=0,1"}};
    const study_words words{{"--orders", "20"}, {"--digits", "10"}};
    const auto tables = tables_of(order_asked("study", "approximants", asked, words, 2));
    std::vector<std::string> shears;
    for (const auto& row : rows_of_table(tables.at(1))) {
        if (row.at("quantity") == "s") {
            shears.push_back(row.at("value"));
        }
    }
    // problems/falkner_skan.ode says where they are printed.
    REQUIRE(shears.size() == 2);
    CHECK(std::stod(shears[0]) == Approx(0.469599988361).epsilon(1e-11));
    CHECK(std::stod(shears[1]) == Approx(1.2325876568202810).epsilon(1e-11));
    // At N = 20 the asymptotic approximant knows the layer, and the series is of no use there.
    for (const auto& row : rows_of_table(tables.at(0))) {
        if (row.at("method") == "asymptotic") {
            CHECK(std::stod(row.at("log10_norm")) < -3);
        } else if (row.at("method") == "series") {
            CHECK(std::stod(row.at("log10_norm")) > 0);
        }
    }
    CHECK_THROWS_WITH(rows_about("approximants", {"lorenz", {"x(0)=1,2"}}, words),
                      Catch::Contains("no known asymptotic behaviour"));
}

namespace {

// The norms of asymptotic approximants, as printed, and the lines about them.
struct norms_with_remarks {
    std::vector<double> norms;
    std::vector<std::string> rigour, remarks;
};

norms_with_remarks asymptotic_norms(const equation_words& asked, const study_words& words) {
    const auto order = order_asked("study", "error_norm", asked, words, 2);
    const auto tables = tables_of(order);
    norms_with_remarks found{{}, {}, order.what->remarks(tables)};
    for (const auto& row : rows_of_table(tables.front())) {
        if (row.at("method") == "asymptotic") {
            found.norms.push_back(row.at("norm").empty() ? 0 : std::stod(row.at("norm")));
            found.rigour.push_back(row.at("rigour"));
        }
    }
    return found;
}

const study_words five_times{{"--times", "1/2,1,3/2,2,4"}, {"--orders", "4,8,16"}};

}  // namespace

// tanh t = z/(2 - z) in z = 1 - exp(-2 t): the approximant of order N is wrong by 2^-N z^(N+1) (1 - z)/(2 - z).
TEST_CASE("norms at infinity are those of closed forms, and the best order is named", "[studies][equation]") {
    const auto kink = asymptotic_norms({"u'' = 2*u*(u^2-1); u(0) = 0; u(inf) = 1", {}}, five_times);
    REQUIRE(kink.norms.size() == 3);
    for (std::size_t i = 0; i < kink.norms.size(); ++i) {
        const int n = 4 << i;
        double largest = 0;
        for (const double t : {0.5, 1., 1.5, 2., 4.}) {
            const double z = -std::expm1(-2 * t);
            largest = std::max(largest, std::pow(2., -n) * std::pow(z, n + 1) * (1 - z) / (2 - z));
        }
        CHECK(kink.norms[i] == Approx(largest).epsilon(1e-10));  // 12 digits printed, a few roundings of double
        CHECK(kink.rigour[i] == "two-method");
    }
    REQUIRE(kink.remarks.size() == 1);
    CHECK_THAT(kink.remarks.front(), Catch::Contains("N = 16 is the best") && !Catch::Contains("warning"));
}

// y = 1/sinh(t + a), 1/sinh a = 3: with q = exp(-a), z = 1 - exp(-t), y = 1/(1 - q + q z) - 1/(1 + q - q z), whose
// radius (1 - q)/q = 0.39 is less than 1.
TEST_CASE("approximants whose norms grow with the order are warned of", "[studies][equation]") {
    const auto far = asymptotic_norms({"y'' = y + 2*y^3; y(0) = 3; y(inf) = 0", {"y'(0)=-9"}}, five_times);
    const double q = std::sqrt(10.) / 3 - 1. / 3;
    REQUIRE(far.norms.size() == 3);
    for (std::size_t i = 0; i < far.norms.size(); ++i) {
        double largest = 0;
        for (const double t : {0.5, 1., 1.5, 2., 4.}) {
            const double z = -std::expm1(-t);
            double sum = 0, left = 0;
            for (int k = 0; k <= 4 << i; ++k) {
                const double c = std::pow(-q / (1 - q), k) / (1 - q) - std::pow(q / (1 + q), k) / (1 + q);
                sum += c * std::pow(z, k);
                left -= c;
            }
            sum += left * std::pow(z, (4 << i) + 1);
            const double truth = 1 / (1 - q + q * z) - 1 / (1 + q - q * z);
            largest = std::max(largest, std::fabs(sum - truth));
        }
        CHECK(far.norms[i] == Approx(largest).epsilon(1e-9));  // the sums lose 6 digits of 16 at N = 16
    }
    REQUIRE(far.remarks.size() == 1);
    CHECK_THAT(far.remarks.front(), Catch::Contains("N = 4 is the best") && Catch::Contains("warning"));
}

// f = 1 - exp(-t) has no error.
TEST_CASE("an exact approximant at infinity is not told from the solution", "[studies][equation]") {
    const auto sheet = asymptotic_norms({"f''' + f*f'' - f'^2 = 0; f(0) = 0; f'(0) = 1; f'(inf) = 0", {}}, five_times);
    CHECK(sheet.rigour == std::vector<std::string>(3, "not decided"));
}

TEST_CASE("conditions at infinity are refused where a study has no answer", "[studies][equation]") {
    const std::string problem = "y'' = y - y^3; y'(0) = 0; y(inf) = 0";
    CHECK_THROWS_WITH(order_asked("study", "terms", equation_words{problem, {}}, {{"--times", "0:1:3"}}, 1),
                      Catch::Contains("conditions at infinity") && Catch::Contains("error_norm"));
    CHECK_THROWS_WITH(
        tables_of(order_asked("study", "error_norm", equation_words{problem, {}}, {{"--scalar", "double"}}, 1)),
        Catch::Contains("--scalar") && Catch::Contains("mpfr"));
    CHECK_THROWS_WITH(
        tables_of(order_asked("study", "error_norm",
                              equation_words{"u'' + c*u' + u*(1-u)*(u-1/4) = 0; u(-inf) = 1; u(inf) = 0", {}},
                              {{"--orders", "4"}}, 1)),
        Catch::Contains("-inf"));
}

// y = 1/(1 + e^-t) = 1/2 + t/4 - t^3/48 + ...: partial sums, [2/2] = (1/2 + t/4 + t^2/24)/(1 + t^2/12), and the cubic
// that has values and slopes y (1 - y) at 0 and 1.
TEST_CASE("proved norms of the logistic equation are those of closed forms", "[studies][equation][proved]") {
    const precision_scope scope(60);
    const auto rows = rows_about("error_norm", {"logistic", {}},
                                 {{"--times", "1/2,1"}, {"--orders", "1,4"}, {"--scalar", "ball:30"}});
    const auto y = [](const mpfr& t) { return mpfr(1 / (1 + exp(mpfr(-t)))); };
    const auto largest = [&](const auto& f) {
        const mpfr half = mpfr(1) / 2;
        return std::max(mpfr(abs(mpfr(f(half) - y(half)))), mpfr(abs(mpfr(f(mpfr(1)) - y(mpfr(1))))));
    };
    const std::map<std::string, mpfr> expected{
        {"1series", largest([](const mpfr& t) { return mpfr(mpfr(1) / 2 + t / 4); })},
        {"4series", largest([](const mpfr& t) { return mpfr(mpfr(1) / 2 + t / 4 - t * t * t / 48); })},
        {"4pade", largest([](const mpfr& t) { return mpfr((mpfr(1) / 2 + t / 4 + t * t / 24) / (1 + t * t / 12)); })},
        {"1endpoint", largest([&](const mpfr& t) {
             const mpfr end = y(mpfr(1));
             const mpfr rest = end - mpfr(1) / 2 - mpfr(1) / 4;
             const mpfr slope = end * (1 - end) - mpfr(1) / 4;
             return mpfr(mpfr(1) / 2 + t / 4 + t * t * (3 * rest - slope) + t * t * t * (slope - 2 * rest));
         })}};
    std::size_t compared = 0;
    for (const table_row& row : rows) {
        const auto found = expected.find(row.at("order") + row.at("method"));
        if (found != expected.end()) {
            INFO(found->first);
            CHECK(row.at("rigour") == "proved");
            CHECK(abs(mpfr(mpfr(row.at("norm")) - found->second)) <= found->second * pow(mpfr(10), -29));
            ++compared;
        }
    }
    CHECK(compared == expected.size());
}

// The series of a polynomial is the solution: no precision tells its error from 0, and nothing is said to be proved.
TEST_CASE("a norm that is 0 is not called proved", "[studies][equation][proved]") {
    const auto rows = rows_about("error_norm", {"y' = 2*t; y(0) = 1/3", {}},
                                 {{"--times", "1/2,1"}, {"--orders", "2"}, {"--scalar", "ball:20"}});
    REQUIRE(rows.front().at("method") == "series");
    CHECK(rows.front().at("norm").empty());
    CHECK(rows.front().at("rigour") == "not decided");
}

}  // namespace studies_equation_studies_test
