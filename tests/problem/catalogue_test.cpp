// Every problem of the catalogue: it is read, its series fulfils its equations by a route of its own, and what is known
// of it (first integrals, closed forms, published digits) comes out.
#include "libration/problem/catalogue.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstddef>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/equation/unused_parameters.hpp"
#include "libration/integration/taylor/taylor_march.hpp"
#include "libration/number/exact.hpp"
#include "libration/query/trajectory.hpp"
#include "libration/scalar/error.hpp"

namespace problem_catalogue_test {

using namespace libration;
using namespace libration::ode;

namespace {

using state = solution_state<mpfr>;

rational exactly_as_fraction(const mpfr& x) {
    rational result;
    mpfr_get_q(result.backend().data(), handle(x));
    return result;
}

mpfr size_of(const state& s) {
    mpfr size(1);
    for (const auto& of_unknown : s) {
        for (const mpfr& x : of_unknown) {
            size = std::max(size, mpfr(abs(x)));
        }
    }
    return size;
}

mpfr distance(const state& a, const state& b) {
    mpfr largest(0);
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < a[i].size(); ++j) {
            largest = std::max(largest, mpfr(abs(mpfr(a[i][j] - b[i][j]))));
        }
    }
    return largest;
}

// y', y'', ... and y^(q) by one evaluation of the right sides.
class right_sides {
public:
    explicit right_sides(const explicit_system& system, const std::vector<ode::expression>& watched = {})
        : tape_(tape::about_points(system, watched)), values_(tape_, highest(system)) {}

    state slopes(const mpfr& t, const state& at) {
        values_.about(t, at);
        state result = at;
        for (std::size_t i = 0; i < at.size(); ++i) {
            std::rotate(result[i].begin(), result[i].begin() + 1, result[i].end());
            result[i].back() = values_.right_side(static_cast<int>(i))[0];
        }
        return result;
    }
    mpfr watched(int which, const mpfr& t, const state& at) {
        values_.about(t, at);
        return values_.watched(which)[0];
    }

private:
    static int highest(const explicit_system& system) {
        return std::ranges::max_element(system.unknowns(), {}, &unknown_function::order)->order;
    }
    tape tape_;
    taylor_expansion<mpfr> values_;
};

state moved(const state& from, const state& slopes, const mpfr& h) {
    state result = from;
    for (std::size_t i = 0; i < from.size(); ++i) {
        for (std::size_t j = 0; j < from[i].size(); ++j) {
            result[i][j] += slopes[i][j] * h;
        }
    }
    return result;
}

// One step of the classical Runge-Kutta method, which knows nothing of series.
state runge_kutta(right_sides& f, const mpfr& t, const state& y, const mpfr& h) {
    const state k1 = f.slopes(t, y);
    const state k2 = f.slopes(t + h / 2, moved(y, k1, mpfr(h / 2)));
    const state k3 = f.slopes(t + h / 2, moved(y, k2, mpfr(h / 2)));
    const state k4 = f.slopes(t + h, moved(y, k3, h));
    state result = moved(moved(y, k1, mpfr(h / 6)), k2, mpfr(h / 3));
    return moved(moved(result, k3, mpfr(h / 3)), k4, mpfr(h / 6));
}

explicit_system solved(const std::string& name, const std::vector<std::string>& changes = {}) {
    equation_system system = parse(problem_text(name));
    for (const std::string& each : changes) {
        system = changed(system, each);
    }
    return explicit_system(system);
}

/// The value of an unknown or of a derivative at a time.
struct published {
    std::string problem;
    std::vector<std::string> changes;
    std::string time;
    std::string unknown;
    int derivative;
    std::string value;
    std::string within;
};

mpfr number_in(const std::string& text) { return mpfr_from_exact(read_exact(text)); }

}  // namespace

TEST_CASE("no problem of the catalogue has a parameter that it does not use", "[problem]") {
    for (const catalogue_entry& each : catalogue()) {
        INFO(each.name);
        CHECK(unused_parameters(each.text).empty());
    }
}

TEST_CASE("the catalogue has the problems it promises", "[problem][catalogue]") {
    std::vector<std::string> names{"pendulum",
                                   "blasius",
                                   "falkner_skan",
                                   "sir",
                                   "sir_japan",
                                   "seir",
                                   "rayleigh",
                                   "sakiadis",
                                   "flierl_petviashvili",
                                   "riccati",
                                   "logistic",
                                   "lotka_volterra",
                                   "harmonic",
                                   "weierstrass",
                                   "painleve_1",
                                   "painleve_2",
                                   "lane_emden",
                                   "thomas_fermi",
                                   "meniscus",
                                   "van_der_pol",
                                   "lorenz",
                                   "duffing",
                                   "kepler",
                                   "arenstorf",
                                   "henon_heiles",
                                   "double_pendulum",
                                   "pleiades",
                                   "three_body_figure_8",
                                   "brusselator",
                                   "fitzhugh_nagumo",
                                   "toda",
                                   "robertson",
                                   "hires",
                                   "oregonator",
                                   "pollu",
                                   "ring_modulator",
                                   "brusselator_1d",
                                   "beam",
                                   "plate",
                                   "cusp",
                                   "bouncing_ball",
                                   "relay",
                                   "detest_f1",
                                   "detest_f2",
                                   "detest_f3",
                                   "detest_f4",
                                   "detest_f5",
                                   "akzo_nobel",
                                   "transistor_amplifier",
                                   "cartesian_pendulum",
                                   "mackey_glass",
                                   "infectious_disease",
                                   "wille_baker",
                                   "food_limited",
                                   "neutral_predator_prey",
                                   "wheldon",
                                   "nagumo",
                                   "korteweg_de_vries",
                                   "poeschl_teller",
                                   "quartic_oscillator"};
    for (const char group : std::string("abcde")) {
        for (const char which : std::string("12345")) {
            names.push_back(std::string("detest_") + group + which);
        }
    }
    for (const std::string group : {"a4", "b5", "c5", "d6", "e5", "f5"}) {
        for (char which = '1'; which <= group[1]; ++which) {
            names.push_back(std::string("stiff_") + group[0] + which);
        }
    }
    CHECK(catalogue().size() == names.size());
    for (const std::string& name : names) {
        INFO(name);
        CHECK_NOTHROW(problem_text(name));
    }
    for (const catalogue_entry& entry : catalogue()) {
        INFO(entry.name);
        CHECK(title_of(entry).size() > 5);
        CHECK(entry.text.starts_with("# "));
    }
    CHECK_THROWS_WITH(
        problem_text("blasus"),
        "problem 'blasus' is not in the catalogue (did you mean blasius?): `libration problems` lists it; a file "
        "contains / or ends in .ode, a text contains =");
}

TEST_CASE("every problem's series fulfils its equations, its integrals and its closed forms", "[problem][catalogue]") {
    const precision_scope scope(40);
    for (const catalogue_entry& entry : catalogue()) {
        INFO(entry.name);
        const equation_system equations = parse(entry.text);
        if (!equations.is_ordinary()) {
            continue;
        }
        const explicit_system system(equations);
        right_sides f(system, system.invariants());
        taylor_march<mpfr> march(system);
        const mpfr origin = constant_value<mpfr>::of(system.point());
        const mpfr step = march.length() == 0 ? mpfr(1) : march.length();
        const mpfr t = origin + step * 5 / 4;
        const state here = march.advance_to(t);
        const mpfr size = size_of(here);
        // A step of R/(1000 e^2): the fifth derivative leaves about (h/R)^5.
        const mpfr h = march.length() == 0 ? mpfr(mpfr(1) / 1000) : mpfr(march.length() / 1000);
        const state by_series = march.advance_to(mpfr(t + h));
        const state slopes = f.slopes(t, here);
        CHECK(distance(by_series, runge_kutta(f, t, here, h)) < (size + size_of(slopes) * h) * pow(mpfr(10), -13));
        const state later = march.advance_to(mpfr(origin + step * 3));
        for (int i = 0; i < static_cast<int>(system.invariants().size()); ++i) {
            INFO("invariant " << i + 1);
            const mpfr before = f.watched(i, t, here);
            const mpfr after = f.watched(i, mpfr(origin + step * 3), later);
            CHECK(abs(mpfr(before - after)) < (size_of(later) * size_of(later) + abs(before)) * pow(mpfr(10), -35));
        }
        for (const definition& known : system.exact()) {
            INFO("exact " << known.name);
            const ode::expression value = replaced(known.value, [&](const ode::expression&) {
                return std::optional(ode::expression(exactly_as_fraction(t)));
            });
            const auto which = std::ranges::find(system.unknowns(), known.name, &unknown_function::name);
            const mpfr found = here[static_cast<std::size_t>(which - system.unknowns().begin())][0];
            CHECK(abs(mpfr(found - rounded_value(value.constant()))) < size * pow(mpfr(10), -36));
        }
    }
}

TEST_CASE("published values come out", "[problem][catalogue]") {
    const std::vector<std::string> amplitude{"x(0) = 2.008619860874843136509"};
    const std::vector<std::string> orbit{"x(0) = -13.76361068213420052501", "y(0) = -19.57875194245179553883",
                                         "z(0) = 27"};
    const std::vector<published> all{
        {"blasius", {"k = 0.33205733621519629893718006201058"}, "20", "f", 1, "1", "1e-28"},
        {"falkner_skan", {}, "8", "f", 1, "1", "1e-8"},
        {"sakiadis", {}, "60", "f", 0, "1.616125446804603", "1e-11"},
        {"sir", {}, "30", "S", 0, "76.0563587702", "1e-10"},
        {"flierl_petviashvili", {}, "12", "w", 0, "0", "1e-4"},
        {"painleve_2", {}, "3", "u", 0, "0.006591139357460719", "1e-6"},  // Ai(3)
        {"lane_emden", {}, "6.89684861937696037545", "y", 0, "0", "1e-20"},
        {"lane_emden", {"n = 2"}, "4.35287459594612467697", "y", 0, "0", "1e-20"},
        {"lane_emden", {"n = 4"}, "14.97154634883809509761", "y", 0, "0", "1e-20"},
        {"thomas_fermi", {}, "10", "y", 0, "0.0243143", "5e-8"},
        {"meniscus", {}, "5", "h", 0, "0.00552425431544597607529", "1e-20"},          // from its closed form
        {"nagumo", {"a = 1/3"}, "1", "u", 0, "0.3302384506733430743832", "1e-18"},    // 1/(1 + exp(1/sqrt 2))
        {"korteweg_de_vries", {}, "1", "u", 0, "0.8399486832280521387890", "1e-18"},  // 2 sech(1)^2
        {"poeschl_teller", {}, "1", "psi", 0, "0.4199743416140260694945", "1e-18"},   // sech(1)^2
        {"quartic_oscillator", {}, "4", "psi", 0, "1.6277952867487e-10", "1e-22"},    // mpmath, 80 digits
        {"van_der_pol", amplitude, "6.66328685932313018969", "x", 0, "2.008619860874843136509", "1e-19"},
        {"van_der_pol", amplitude, "6.66328685932313018969", "x", 1, "0", "1e-19"},
        {"lorenz", orbit, "1.55865221071617472756", "x", 0, "-13.76361068213420052501", "1e-17"},
        {"lorenz", orbit, "1.55865221071617472756", "z", 0, "27", "1e-17"},
        {"duffing", {}, "1.68575035481259604287/sqrt(2)", "x", 0, "0", "1e-20"},  // K/sqrt(2), k = 1/2
        {"kepler", {}, "1-3/5*sin(1)", "x", 0, "cos(1)-3/5", "1e-28"},
        {"detest_d1", {}, "1-1/10*sin(1)", "x", 0, "cos(1)-1/10", "1e-28"},
        {"detest_d5", {}, "20-9/10*sin(20)", "x", 0, "cos(20)-9/10", "1e-28"},
        {"arenstorf", {}, "17.0652165601579625588917206249", "x", 0, "0.994", "1e-20"},
        {"three_body_figure_8", {}, "6.32591398", "x1", 0, "0.97000436", "1e-6"},
        {"pleiades", {}, "3", "x1", 0, "0.3706139143970502", "1e-9"},
        {"brusselator", {}, "20", "u", 0, "0.49863707126834783", "1e-15"},
        {"brusselator", {}, "20", "v", 0, "4.5967803494520112", "1e-15"},
        {"detest_c5", {}, "20", "x1", 0, "-4.792730224323733", "1e-11"},
        {"detest_c5", {}, "20", "y1", 0, "-2.420550725448973", "1e-11"},
        {"detest_e3", {}, "20", "y2", 0, "0.2411400132095954", "1e-11"},
        {"detest_e4", {}, "20", "y1", 0, "33.95091444646555", "1e-11"},
        {"detest_e5", {}, "20", "y1", 0, "14.11797390542629", "1e-11"},
    };
    const precision_scope scope(40);
    for (const published& each : all) {
        INFO(each.problem << ", " << each.unknown << " at " << each.time);
        const explicit_system system = solved(each.problem, each.changes);
        const auto which = std::ranges::find(system.unknowns(), each.unknown, &unknown_function::name);
        const auto i = static_cast<std::size_t>(which - system.unknowns().begin());
        const auto j = static_cast<std::size_t>(each.derivative);
        // What double can decide, it does: some hundred steps lose a few digits of 16, the seven stars seven.
        const number time = parse_constant(each.time).constant();
        const bool is_coarse = number_in(each.within) >= number_in("1e-11");
        const mpfr found = is_coarse
                               ? mpfr(taylor_march<double>(system).advance_to(constant_value<double>::of(time))[i][j])
                               : trajectory(system, {time}, 30).front()[i][j];
        INFO(to_decimal(found, 30));
        CHECK(abs(mpfr(found - number_in(each.value))) < number_in(each.within));
    }
}

TEST_CASE("singularities stand where they were published", "[problem][catalogue]") {
    const precision_scope scope(40);
    const auto state_at = [](const std::string& name, const std::string& time) {
        return trajectory(solved(name), {parse_constant(time).constant()}, 30).front()[0];
    };
    // u ~ (z - z_0)^-2 about a pole of Painleve I, the next term by (z - z_0)^4: z_0 = z + u^(-1/2) to 1e-12.
    const auto u = state_at("painleve_1", "2.38");
    CHECK(abs(mpfr(number_in("2.38") + 1 / sqrt(u[0]) - number_in("2.38416876956881664"))) < number_in("1e-11"));
    // R^(5/2) ~ t_0 - t at the collapse, within R^3 of it.
    const auto r = state_at("rayleigh", "0.9146");
    const mpfr collapse = number_in("0.9146") - r[0] / r[1] * 2 / 5;
    const mpfr third = mpfr(1) / 3;
    mpfr gamma_ratio;
    mpfr gamma_below;
    mpfr_gamma(handle(gamma_ratio), handle(mpfr(mpfr(5) / 6)), MPFR_RNDN);
    mpfr_gamma(handle(gamma_below), handle(mpfr(third + 1)), MPFR_RNDN);
    CHECK(abs(mpfr(collapse - sqrt(mpfr(pi<mpfr>() / 6)) * gamma_ratio / gamma_below)) < number_in("1e-8"));
    // wp'^2 = 4 wp^3 - 2.
    const auto wp = state_at("weierstrass", "1/4");
    CHECK(abs(mpfr(wp[1] * wp[1] - wp[0] * wp[0] * wp[0] * 4 + 2)) < number_in("1e-15"));
    CHECK_THROWS_AS(state_at("riccati", "2"), error);
}

}  // namespace problem_catalogue_test
