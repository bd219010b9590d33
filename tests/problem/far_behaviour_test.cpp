#include "libration/problem/known_facts.hpp"

#include <catch2/catch.hpp>

#include "libration/equation/text/parse.hpp"
#include "libration/expansion/taylor_expansion.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/problem/known/sakiadis.hpp"
#include "libration/query/trajectory.hpp"
#include "scalars.hpp"

namespace problem_far_behaviour_test {

using namespace libration;
using libration::tests::decimal;

namespace {

far_behaviour of(const std::string& name, const std::vector<std::string>& changes = {}, const std::string& free = "") {
    auto system = ode::parse(problem_text(name));
    for (const std::string& each : changes) {
        system = ode::changed(system, each);
    }
    return far_behaviour_of(name, system, 16, free);
}

// Within one unit of the last digit of the decimal.
void check(const far_behaviour& far, const std::string& name, const std::string& expected) {
    const auto known = decimal(expected);
    INFO(far.problem << " " << name << ": " << to_decimal(far.values.at(name), 25));
    CHECK(abs(mpfr(far.values.at(name) - known.value)) <= known.uncertainty);
}

}  // namespace

TEST_CASE("the numbers of far behaviours are those in print", "[problem][asymptotic]") {
    check(of("blasius"), "f''(0) for f'(inf) = 1", "0.332057336215196299");  // OEIS A256522
    check(of("sakiadis"), "f''(0)", "-0.443748313368861");                   // [Barlow2017]
    check(of("sakiadis"), "f(inf)", "1.616125446804603");
    check(of("falkner_skan"), "s", "0.927680039836653");  // [Belden2020], figure 2
    check(of("falkner_skan", {"b = 0", "s = 0.47"}), "s", "0.469599988361");
    check(of("falkner_skan", {"b = -0.12", "s = -0.143"}), "s", "-0.1429351943576");  // the reversed branch
    // The same branch nearer to b = 0, whose interval near rest is longer: T. Cebeci, H. B. Keller, J. Comput. Phys. 7
    // (1971) 289-300.
    check(of("falkner_skan", {"b = -0.05", "s = -0.1083"}), "s", "-0.108271");
    check(of("flierl_petviashvili"), "w0", "2.391956403224");
    check(of("sir"), "S(inf)", "76.0563587702");
    check(of("rayleigh"), "collapse", "0.9146813565");
}

TEST_CASE("a start of Falkner and Skan's layer is free, or its parameter is", "[problem][asymptotic]") {
    const auto far = of("falkner_skan", {"b = 0.92", "s = 1.2325876568202810"}, "b");
    CHECK(abs(mpfr(far.values.at("b") - 1)) < 1e-13);
}

TEST_CASE("approximants have the given series and come to the far behaviour", "[problem][asymptotic]") {
    const precision_scope scope(50);
    for (const std::string& name : problems_with_far_behaviour()) {
        INFO(name);
        const far_behaviour far = of(name);
        const ode::tape tape = ode::tape::about_start(far.system);
        ode::taylor_expansion<mpfr> expansion(tape, 12);
        expansion.about_start();
        const auto f = expansion.series_of(far.index());
        const auto approximant = *asymptotic_approximant(far, f);
        // Near 0 the difference is the first omitted power: t^13, or one with a factor of the rates to the 13th.
        const mpfr near = far.end / 1'000'000'000;
        CHECK(abs(mpfr(approximant(near) - series::evaluate_value(f, near))) < 1e-30);
        if (far.form != far_form::branch) {
            CHECK(abs(mpfr(approximant(far.end * 4) - series::evaluate_value(far.line, mpfr(far.end * 4)))) < 1e-6);
        }
    }
}

TEST_CASE("what the approximants of Sakiadis' layer predict is the published table", "[problem][asymptotic]") {
    const precision_scope scope(60);
    const auto system = ode::parse(problem_text("sakiadis"));
    const auto at = [&](int known, const char* shear, const char* limit, const char* amplitude) {
        const auto found = predicted_sakiadis(system, known);
        CHECK(abs(mpfr(found.wall_shear - decimal(shear).value)) <= decimal(shear).uncertainty);
        CHECK(abs(mpfr(found.limit - decimal(limit).value)) <= decimal(limit).uncertainty);
        CHECK(abs(mpfr(found.amplitude - decimal(amplitude).value)) <= decimal(amplitude).uncertainty);
    };
    at(5, "-0.464241808775", "1.57791591603", "-1.9379232426");  // [Barlow2017], the table of Sakiadis
    at(7, "-0.445957694266", "1.61001774844", "-2.0928590899");
    CHECK_THROWS_WITH(predicted_sakiadis(system, 3), Catch::Contains("at least 4"));
}

TEST_CASE("a problem without a known far behaviour is refused", "[problem][asymptotic]") {
    CHECK_THROWS_WITH(of("lorenz"), Catch::Contains("has no known asymptotic behaviour"));
    CHECK_THROWS_WITH(of("rayleigh", {"R'(0) = 1"}), Catch::Contains("only from rest"));
}

}  // namespace problem_far_behaviour_test
