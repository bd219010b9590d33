// Stiff equations in rounded arithmetic: closed forms over all scalars in both directions of time, proved digits of the
// classical problems, and equations that are not stiff.
#include "libration/integration/collocation/stiff_march.hpp"

#include <fmt/core.h>

#include <catch2/catch.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/query/stiff_trajectory.hpp"
#include "scalars.hpp"

namespace integration_collocation_stiff_march_test {

using namespace libration;
using namespace libration::ode;
using namespace libration::tests;

namespace {

explicit_system system_of(const std::string& text) { return explicit_system(parse(text)); }
explicit_system problem_named(const std::string& name) { return system_of(std::string(problem_text(name))); }
number time_of(const std::string& text) { return parse_constant(text).constant(); }

const std::string van_der_pol = "x' = y; y' = ((1 - x^2)*y - x)/1e-6; x(0) = 2; y(0) = 0";

// Proved digits (libration reference).
struct proved_state {
    std::string text;
    std::string time;
    std::vector<std::string> values;
    long epsilons;            // of the error in double by collocation
    long epsilons_of_series;  // by Taylor series, or by both
};

// Robertson's equations and the relaxation oscillations forget perturbations: tens of steps with some epsilon each; the
// phase of the oscillations keeps the errors of their jumps. For HIRES, and Robertson's equations to 40, in double some
// thousand steps of Taylor series, at the limit of their stability, take no more time than collocation, and lose more.
// Each unknown of E5 is relative to itself.
const std::vector<proved_state>& proved_states() {
    static const std::vector<proved_state> all{
        {"robertson", "40", {"0.71582706871940509047", "9.1855347645577639039e-6", "0.28416374574583035176"}, 16, 64},
        {"robertson",
         "4e5",
         {"0.0049382745209798155602", "1.9849940879543754370e-8", "0.99506170562907930490"},
         16,
         16},
        {"robertson",
         "1e11",
         {"2.0833401497012942306e-8", "8.3333607703347834006e-14", "0.99999997916651516938"},
         16,
         16},
        {van_der_pol, "2", {"1.7061677321704650085", "-0.89280970102481654778"}, 32, 32},
        {"hires",
         "321.8122",
         {"0.00073713125733256678073", "0.00014424857263161846582", "0.000058887297409675750075",
          "0.0011756513432831491455", "0.0023863561988313304688", "0.0062389682527427957866",
          "0.0028499983951857686579", "0.0028500016048142313421"},
         64,
         2048},
        {"oregonator", "360", {"1.0008148703185227163", "1228.1785215498879837", "132.05549428465082877"}, 64, 64},
        {"stiff_e5",
         "1000",
         {"0.0016180769999072942553", "1.3822370304983735443e-10", "8.2515735006838336088e-12",
          "1.2997212954915352082e-10"},
         64,
         64}};
    return all;
}

explicit_system system_of(const proved_state& each) {
    return each.text.find('=') == std::string::npos ? problem_named(each.text) : system_of(each.text);
}

template <class T>
std::vector<T> values_of(const solution_state<T>& state) {
    std::vector<T> all;
    for (const auto& of_unknown : state) {
        all.insert(all.end(), of_unknown.begin(), of_unknown.end());
    }
    return all;
}

}  // namespace

// u = 1/(1 + t), and v tends to u^2 like exp(-1e8 t). Collocation in mpfr accepts coefficients of 10^7 epsilon, which the
// guard digits of two runs cover.
TEMPLATE_LIST_TEST_CASE("a stiff solution with a closed form is followed over ten orders of time", "[ode][stiff]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto system = system_of("u' = -u^2; v' = -1e8*(v - u^2) - 2*u^3; u(0) = 1; v(0) = 2");
    const long epsilons = std::is_same_v<T, double> ? 64 : fixed_scalar<T> ? 100'000 : 1'000'000'000;
    stiff_march<T> march(system);
    march.head_for(from_rational<T>(rational("10000000000")));
    for (const char* time : {"1/3", "1000", "10000000000"}) {
        CAPTURE(time);
        const T t = from_rational<T>(rational(time));
        const auto found = values_of(march.advance_to(t));
        const T u = T(1 / T(1 + t));
        CHECK_THAT(found[0], near<T>(u, epsilons));
        CHECK_THAT(found[1], near<T>(T(u * u), 2 * epsilons));
    }
    REQUIRE(march.collocation().size() == 1);
    CHECK(march.collocation().front().last == 1e10);
    CHECK_FALSE(march.collocation().front().proved);
}

// x = exp(-|t|) in the direction in which the mode exp(-1e6 |t|) decays.
TEST_CASE("collocation follows a stiff solution backwards, and forwards again", "[ode][stiff]") {
    using std::exp;
    const auto system = system_of("x' = 1e6*(x - exp(t)) + exp(t); x(0) = 1");
    stiff_march<double> march(system, integrator_choice::collocation);
    for (const double time : {-0.5, -30.0, -3.0}) {
        CHECK_THAT(march.advance_to(time)[0][0], near<double>(exp(time), 64));
    }
    CHECK_THAT(march.advance_to(1e-6)[0][0], near<double>(exp(1e-6), 64));
    CHECK(march.advance_to(0)[0][0] == 1);
    const auto used = march.collocation();
    REQUIRE(used.size() >= 2);
    CHECK(used.front().last == -30);
}

TEST_CASE("the classical problems have their proved digits in double, by any choice of the integrator",
          "[ode][stiff]") {
    for (const proved_state& each : proved_states()) {
        const auto system = system_of(each);
        for (const auto choice : {integrator_choice::automatic, integrator_choice::collocation}) {
            CAPTURE(each.text, each.time, static_cast<int>(choice));
            const auto found = part_of_stiff_march<double>(system, {time_of(each.time)}, choice);
            REQUIRE_FALSE(found.missing);
            const auto values = values_of(found.states.front());
            const long epsilons = choice == integrator_choice::collocation ? each.epsilons : each.epsilons_of_series;
            REQUIRE(values.size() == each.values.size());
            for (std::size_t i = 0; i < values.size(); ++i) {
                CHECK_THAT(values[i], near<double>(decimal(each.values[i]), epsilons));
            }
        }
    }
}

TEST_CASE("two runs in mpfr agree on proved digits", "[ode][stiff]") {
    const auto& all = proved_states();
    for (const proved_state& each : {all[2], all[3]}) {
        CAPTURE(each.text);
        const auto found = part_of_stiff_trajectory(system_of(each), {time_of(each.time)}, 18);
        REQUIRE_FALSE(found.missing);
        CHECK_FALSE(found.collocation.empty());
        const auto values = values_of(found.states.front());
        for (std::size_t i = 0; i < values.size(); ++i) {
            const auto truth = decimal(each.values[i]);
            const precision_scope scope(40);
            CHECK(abs(values[i] - truth.value) <= abs(truth.value) * mpfr("1e-17"));
        }
    }
}

// As the Test Set for IVP Solvers prints them; a run in long double differs from the first one by 1.7e-12 of itself.
TEST_CASE("the beam that is pulled until t = pi has the published angles at t = 5", "[.long][ode][stiff]") {
    std::string text(problem_text("beam"));
    const auto pulled = part_of_stiff_march<double>(system_of(text), {time_of("pi")});
    REQUIRE_FALSE(pulled.missing);
    text.replace(text.find("p = 1"), 5, "p = 0");
    text.erase(text.find("th1(0)"));
    const auto state = values_of(pulled.states.front());
    for (std::size_t k = 0; k < state.size(); ++k) {
        text += fmt::format("th{}{}(0) = {}\n", k / 2 + 1, k % 2 == 0 ? "" : "'", state[k]);
    }
    const auto free = part_of_stiff_march<double>(system_of(text), {time_of("5 - pi")});
    REQUIRE_FALSE(free.missing);
    const auto angles = values_of(free.states.front());
    const std::vector<double> published{-0.5792366591285007e-2, -0.1695298550721735e-1, -0.2769103312973094e-1,
                                        -0.3800815655879158e-1};
    for (std::size_t k = 0; k < published.size(); ++k) {
        CHECK(angles[2 * k] == Approx(published[k]).epsilon(1e-11));
    }
}

// 80 steps, 50 of them after t = 1; tables of many times do not change them.
TEST_CASE("steps grow with the time scale, and do not depend on the times between", "[ode][stiff]") {
    const auto system = problem_named("robertson");
    const auto once = part_of_stiff_march<double>(system, {time_of("1e11")}, integrator_choice::collocation);
    REQUIRE(once.collocation.size() == 1);
    CHECK(once.collocation.front().steps < 100);
    std::vector<number> times;
    for (int k = 1; k <= 200; ++k) {
        times.push_back(number(rational(k) * 500'000'000));
    }
    const auto often = part_of_stiff_march<double>(system, times, integrator_choice::collocation);
    CHECK(often.states.back() == once.states.back());
    CHECK(often.collocation.front().steps == once.collocation.front().steps);
    for (const auto& state : often.states) {  // dense output conserves the sum as the nodes do
        CHECK_THAT(state[0][0] + state[1][0] + state[2][0], near<double>(1.0, 8));
    }
}

TEST_CASE("equations that are not stiff have the steps of Taylor series", "[ode][stiff]") {
    const std::vector<number> times{number(rational(1)), number(rational(300))};
    for (const char* name : {"lorenz", "pendulum", "duffing"}) {
        CAPTURE(name);
        const auto system = system_of(std::string(name) == "pendulum" ? "x'' = -sin(x); x(0) = 2; x'(0) = 0"
                                                                      : std::string(problem_text(name)));
        const auto by_taylor = part_of_march<double>(system, times);
        const auto chosen = part_of_stiff_march<double>(system, times);
        CHECK(chosen.states == by_taylor.states);
        CHECK(chosen.collocation.empty());
    }
}

TEST_CASE("collocation that is chosen states its limit of unknowns", "[ode][stiff]") {
    std::string text = "y0' = -y199; y0(0) = 1";
    for (int i = 1; i < 200; ++i) {
        const std::string name = "y" + std::to_string(i);
        text += "; " + name + "' = y" + std::to_string(i - 1) + "; " + name + "(0) = 0";
    }
    CHECK_THROWS_WITH(stiff_march<double>(system_of(text), integrator_choice::collocation),
                      Catch::Contains("is limited to 184 unknowns"));
}

}  // namespace integration_collocation_stiff_march_test
