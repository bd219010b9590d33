// The study of solvers: what peers are told of an equation against closed forms, and what is said of their answers.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "../studies/proved/solver_peers.hpp"
#include "libration/equation/text/parse.hpp"
#include "studies/study_rows.hpp"

namespace studies_solvers_test {

using namespace libration;
using namespace libration::tests;
using studies::proved::solver_peer;

// Every operation of a right side: quadratures with closed forms, an oscillator, and (1 + t) y' = y.
struct closed_form {
    std::string slope;
    double (*value)(double t);
};

const std::vector<closed_form>& quadratures() {
    static const std::vector<closed_form> all{
        {"sin(t)", [](double t) { return 1 - std::cos(t); }},
        {"cos(t) - 2*t", [](double t) { return std::sin(t) - t * t; }},
        {"tan(t)", [](double t) { return -std::log(std::cos(t)); }},
        {"atan(t)", [](double t) { return t * std::atan(t) - std::log(1 + t * t) / 2; }},
        {"asin(t/2)", [](double t) { return t * std::asin(t / 2) + std::sqrt(4 - t * t) - 2; }},
        {"sinh(t) + 1", [](double t) { return std::cosh(t) - 1 + t; }},
        {"cosh(t)", [](double t) { return std::sinh(t); }},
        {"tanh(t)", [](double t) { return std::log(std::cosh(t)); }},
        {"exp(t)*t", [](double t) { return (t - 1) * std::exp(t) + 1; }},
        {"log(1 + t)", [](double t) { return (1 + t) * std::log(1 + t) - t; }},
        {"sqrt(1 + t)", [](double t) { return 2 * (std::pow(1 + t, 1.5) - 1) / 3; }},
        {"(1 + t)^(1/3)", [](double t) { return 3 * (std::pow(1 + t, 4.0 / 3) - 1) / 4; }},
        {"1/(1 + t)^2", [](double t) { return t / (1 + t); }}};
    return all;
}

// The unknowns a, b, ... of the quadratures, the oscillator x'' = -x from 1, and y' = y/(1 + t) from 1.
std::string text_of_quadratures() {
    std::string text = "x'' = -x; x(0) = 1; x'(0) = 0; y' = y/(1 + t); y(0) = 1";
    for (std::size_t i = 0; i < quadratures().size(); ++i) {
        const std::string name = "q" + std::to_string(i);
        text += "; " + name + "' = " + quadratures()[i].slope + "; " + name + "(0) = 0";
    }
    return text;
}

std::vector<double> exact_values(double t) {
    std::vector<double> values{std::cos(t), -std::sin(t), 1 + t};
    for (const closed_form& each : quadratures()) {
        values.push_back(each.value(t));
    }
    return values;
}

// Local errors of 1e-11 over fewer than a thousand steps leave 1e-8.
TEST_CASE("peers solve the equations that they are told, with every function", "[studies][proved][solvers]") {
    const std::vector<double> times{0.5, 1};
    const studies::proved::solver_input problem(ode::explicit_system(ode::parse(text_of_quadratures())),
                                                {ode::number(rational(1, 2)), ode::number(rational(1))});
    for (const solver_peer& peer : studies::proved::solver_peers()) {
        if (!studies::proved::version_of(peer)) {
            CHECK(peer.name != "odeint");  // Boost is always there
            continue;
        }
        INFO(peer.name);
        for (const std::string& method : peer.methods) {
            INFO(method);
            const auto answers = studies::proved::answers_of(peer, problem, times.size(), {{method, "1e-11"}});
            REQUIRE(answers.size() == 1);
            REQUIRE(answers[0].outcome == "ended");
            CHECK(answers[0].evaluations > 0);
            const auto& found = answers[0].values;
            REQUIRE(found.size() == 2 * problem.states());
            for (std::size_t i = 0; i < times.size(); ++i) {
                const auto exact = exact_values(times[i]);
                REQUIRE(exact.size() == problem.states());
                for (std::size_t k = 0; k < exact.size(); ++k) {
                    INFO(k);
                    CHECK(std::abs(found[i * exact.size() + k] - exact[k]) < 1e-8);
                }
            }
        }
    }
}

TEST_CASE("a peer stops at its limit of evaluations", "[studies][proved][solvers]") {
    const studies::proved::solver_input problem(ode::explicit_system(ode::parse("x'' = -x; x(0) = 1; x'(0) = 0")),
                                                {ode::number(rational(1000))});
    for (solver_peer peer : studies::proved::solver_peers()) {
        if (studies::proved::version_of(peer)) {
            INFO(peer.name);
            peer.most_evaluations = 50;
            const auto answers = studies::proved::answers_of(peer, problem, 1, {{peer.methods.front(), "1e-9"}});
            CHECK(answers[0].outcome == "stopped");
            CHECK(answers[0].values.empty());
        }
    }
}

// y = x/10^9: an absolute tolerance of 10^-6 leaves y almost free. BDF of order 5 at most loses two digits here.
TEST_CASE("the absolute tolerance of an unknown is relative to its scale", "[studies][proved][solvers]") {
    const ode::explicit_system system(ode::parse("x' = -x; y' = -y; x(0) = 1; y(0) = 1e-9"));
    const std::vector<ode::number> times{ode::number(rational(3))};
    const studies::proved::solver_input scaled(system, times, {1, 1e-9});
    const studies::proved::solver_input unscaled(system, times);
    for (const solver_peer& peer : studies::proved::solver_peers()) {
        if (!studies::proved::version_of(peer)) {
            continue;
        }
        for (const std::string& method : peer.implicit_methods) {
            INFO(peer.name << " " << method);
            const auto error_of = [&](const studies::proved::solver_input& problem) {
                const auto answers = studies::proved::answers_of(peer, problem, 1, {{method, "1e-6"}});
                REQUIRE(answers[0].outcome == "ended");
                return std::abs(answers[0].values[1] * 1e9 - std::exp(-3.0));
            };
            CHECK(error_of(scaled) < 1e-4);
            // Where x determines the steps, both errors are the same, up to the rounding of fewer than 1000 steps.
            CHECK(error_of(scaled) <= error_of(unscaled) + 1000 * std::numeric_limits<double>::epsilon());
        }
    }
}

// Linear, with eigenvalues of different sizes. GSL answers where it is installed.
TEST_CASE("stiff problems are solved by implicit methods alone", "[studies][proved][solvers]") {
    const auto rows = rows_by_suffix("stiff_solvers",
                                     {{"--problems", "stiff_b4"}, {"--solvers", "gsl"}, {"--tolerances", "1e-4,1e-9"}});
    const auto& all = rows.at("");
    REQUIRE(!all.empty());
    if (all[0].at("outcome") == "not installed") {
        return;
    }
    REQUIRE(all.size() == 2);
    for (const auto& row : all) {
        CHECK(row.at("method") == "msbdf");
        CHECK(row.at("outcome") == "ended");
        CHECK(row.at("rounding").empty());
    }
    CHECK(std::stod(all[0].at("error")) < 1e-6);
    CHECK(std::stod(all[0].at("error")) < std::stod(all[1].at("error")) / 100);
}

// y = 1/(1 + e^-t): errors are measured from the truth, whose largest value is y(20), next to 1.
TEST_CASE("solvers get better with their tolerance, and cost more", "[studies][proved][solvers]") {
    const auto rows = rows_by_suffix(
        "solvers", {{"--problems", "logistic"}, {"--solvers", "odeint"}, {"--tolerances", "1e-4,1e-8,1e-12"}});
    const auto& all = rows.at("");
    REQUIRE(all.size() == 9);
    for (std::size_t i = 0; i < all.size(); ++i) {
        INFO(i);
        CHECK(all[i].at("outcome") == "ended");
        CHECK(all[i].at("rounding") == "0");  // 1/2 is a double
        if (i % 3 > 0) {                      // the smallest tolerance first
            CHECK(std::stod(all[i - 1].at("error")) < std::stod(all[i].at("error")) / 100);
            CHECK(std::stol(all[i - 1].at("evaluations")) > std::stol(all[i].at("evaluations")));
        }
    }
    CHECK(std::stod(all[0].at("error")) < 1e-9);
}

}  // namespace studies_solvers_test
