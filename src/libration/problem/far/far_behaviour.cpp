#include "libration/problem/far/far_behaviour.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "libration/approximant/asymptotic/asymptotic.hpp"
#include "libration/ode/parse.hpp"
#include "libration/ode/step.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/text/decimal.hpp"
#include "libration/series/exponential.hpp"

namespace libration {

namespace {

using ode::equation_system;
using ode::explicit_system;
using series::power_series;

mpfr ten_to(long exponent) { return pow(mpfr(10), static_cast<int>(exponent)); }

power_series<mpfr> polynomial(std::vector<mpfr> coefficients) { return power_series<mpfr>(std::move(coefficients)); }

mpfr parameter_of(const equation_system& given, const std::string& name) {
    return ode::constant_value<mpfr>::of(with_values(ode::parameter(name), given).constant());
}

mpfr start_of(const explicit_system& system, std::size_t unknown, std::size_t derivative) {
    return ode::constant_value<mpfr>::of(system.starts()[unknown][derivative]);
}

// The first unknown and its lower derivatives at a time.
std::vector<mpfr> state_at(const equation_system& given, const mpfr& time) {
    ode::taylor_march<mpfr> march{explicit_system(given)};
    return march.advance_to(time).front();
}

equation_system with_parameter(const equation_system& given, const std::string& name, const mpfr& value) {
    return ode::changed(given, name + " = " + to_decimal(value, static_cast<long>(working_digits())));
}

// A condition at a distance from the start: 0 for the state of the solution that meets the one at infinity.
using far_condition = std::function<mpfr(const std::vector<mpfr>& state, const mpfr& distance)>;

struct found_start {
    equation_system system;
    mpfr value;
    mpfr distance;
    std::vector<mpfr> state;
};

// The value of a parameter for which the condition holds at a distance, from one nearby, to a relative tolerance.
mpfr meet(const equation_system& given, const std::string& free, const far_condition& condition, const mpfr& distance,
          mpfr value, const mpfr& tolerance) {
    constexpr int most_steps = 40;
    const auto off = [&](const mpfr& x) {
        return condition(state_at(with_parameter(given, free, x), distance), distance);
    };
    mpfr before = value + (abs(value) + 1) * ten_to(-static_cast<long>(working_digits()) / 2);
    mpfr off_before = off(before);
    for (int step = 0; step < most_steps; ++step) {
        const mpfr off_now = off(value);
        if (off_now == off_before) {
            return value;
        }
        const mpfr next = value - off_now * (value - before) / (off_now - off_before);
        before = std::exchange(value, next);
        off_before = off_now;
        if (abs(mpfr(value - before)) <= tolerance * (abs(value) + tolerance)) {
            return value;
        }
    }
    throw error(error_kind::argument, "start", to_decimal(value, 10),
                "does not reach the far end: give a nearer guess of " + free);
}

// At distances that grow by half until little(state) at the last is below 10^-digits.
found_start reach(const equation_system& given, const std::string& free, const far_condition& condition,
                  const std::function<mpfr(const std::vector<mpfr>&, const mpfr&)>& little, const mpfr& first,
                  long digits) {
    constexpr int most_stages = 20;
    mpfr value = parameter_of(given, free);
    mpfr distance = first;
    for (int stage = 0; stage < most_stages; ++stage, distance = distance * 3 / 2) {
        value = meet(given, free, condition, distance, value, ten_to(-digits));
        auto state = state_at(with_parameter(given, free, value), distance);
        if (little(state, distance) < ten_to(-digits)) {
            value = meet(given, free, condition, distance, value, ten_to(-2 * digits));
            auto system = with_parameter(given, free, value);
            state = state_at(system, distance);
            return {std::move(system), value, distance, std::move(state)};
        }
    }
    throw error(error_kind::argument, "start", to_decimal(value, 10), "does not come to its far behaviour");
}

// f ~ f'(inf) t + B, f'' vanishing faster than exponentially. Where f'(inf) = l, F(t) = c f(c t), c = l^(-1/2), has 1.
far_behaviour of_blasius(const equation_system& given, long digits) {
    mpfr time(8);
    auto state = state_at(given, time);
    while (abs(state[2]) > ten_to(-digits - 4)) {
        time = time * 5 / 4;
        state = state_at(given, time);
    }
    const mpfr offset = state[0] - state[1] * time;
    const mpfr c = 1 / sqrt(state[1]);
    const explicit_system system(given);
    const mpfr scaled_shear = start_of(system, 0, 2) * c * c * c;
    return {"blasius",
            "f",
            far_form::power,
            system,
            polynomial({offset, state[1]}),
            mpfr(0),
            time,
            {{"f''(0) for f'(inf) = 1", scaled_shear}, {"B for f'(inf) = 1", mpfr(offset * c)}}};
}

far_behaviour of_falkner_skan(const equation_system& given, const std::string& free, long digits) {
    // Reversed profiles begin with a long way at rest: the guess itself says how far. A guess that overshoots does not.
    mpfr first(9);
    for (auto state = state_at(given, first); first < 60 && abs(state[2]) * 100 > 1 && state[1] * 2 < 3;) {
        first = first * 3 / 2;
        state = state_at(given, first);
    }
    const auto found = reach(
        given, free, [](const std::vector<mpfr>& f, const mpfr& /*t*/) { return mpfr(f[1] - 1); },
        [](const std::vector<mpfr>& f, const mpfr& /*t*/) { return mpfr(abs(f[2])); }, first, digits + 4);
    const mpfr offset = found.state[0] - found.distance;
    return {"falkner_skan",
            "f",
            far_form::power,
            explicit_system(found.system),
            polynomial({offset, mpfr(1)}),
            mpfr(0),
            found.distance,
            {{free, found.value}, {"B", offset}}};
}

far_behaviour of_sakiadis(const equation_system& given, long digits) {
    const auto found = reach(
        given, "G", [](const std::vector<mpfr>& f, const mpfr& /*t*/) { return f[1]; },
        [](const std::vector<mpfr>& f, const mpfr& /*t*/) { return mpfr(abs(f[2])); }, mpfr(10), digits + 4);
    const mpfr limit = found.state[0];
    return {"sakiadis",
            "f",
            far_form::exponential,
            explicit_system(found.system),
            polynomial({limit}),
            mpfr(limit / 2),
            found.distance,
            {{"f''(0)", found.value}, {"f(inf)", limit}}};
}

// w'/w of a decaying solution of w'' + w'/r - w = 0 far away, that of K_0: v' = 1 - v/r - v^2, v = sum v_n r^-n, summed
// to its least term.
mpfr decay_of_bessel(const mpfr& r) {
    std::vector<mpfr> v{mpfr(-1)};
    mpfr sum = v[0];
    mpfr power(1);
    mpfr before(2);
    for (int n = 1;; ++n) {
        mpfr next = v[static_cast<std::size_t>(n) - 1] * (n - 2);
        for (int i = 1; i < n; ++i) {
            next -= v[static_cast<std::size_t>(i)] * v[static_cast<std::size_t>(n - i)];
        }
        v.push_back(mpfr(-next / 2));
        power /= r;
        const mpfr term = v.back() * power;
        if (abs(term) >= before || abs(term) < epsilon<mpfr>()) {
            return sum;
        }
        sum += term;
        before = abs(term);
    }
}

// The square of w is e^(-2 r) there, and e^r as much does a wrong start grow: half of the way the start is good for.
far_behaviour of_flierl_petviashvili(const equation_system& given, long digits) {
    const auto found = reach(
        given, "w0", [](const std::vector<mpfr>& w, const mpfr& r) { return mpfr(w[1] - w[0] * decay_of_bessel(r)); },
        [](const std::vector<mpfr>& /*w*/, const mpfr& r) { return exp(mpfr(r * -2)); }, mpfr(6), digits + 4);
    return {"flierl_petviashvili", "w",     far_form::damped,         explicit_system(found.system),
            polynomial({mpfr(0)}), mpfr(1), mpfr(found.distance / 2), {{"w0", found.value}}};
}

// a/r ln(S/S0) + S0 + rest - S = 0 below a/r: concave and growing, and negative at S0 e^(-r (S0 + rest)/a), so that
// Newton's method rises to it.
mpfr left_of_epidemic(const mpfr& ratio, const mpfr& s0, const mpfr& rest) {
    mpfr s = s0 * exp(mpfr(-(s0 + rest) / ratio));
    for (;;) {
        mpfr next = s - (ratio * log(mpfr(s / s0)) + s0 + rest - s) / (ratio / s - 1);
        if (!(next > s) || next - s <= s * epsilon<mpfr>()) {
            return next;
        }
        s = next;
    }
}

far_behaviour of_sir(const std::string& name, const equation_system& given, long digits) {
    const explicit_system system(given);
    const mpfr a = parameter_of(given, "a");
    const mpfr r = parameter_of(given, "r");
    const mpfr s = left_of_epidemic(mpfr(a / r), start_of(system, 0, 0), start_of(system, 1, 0));
    const mpfr rate = a - r * s;
    return {name,
            "S",
            far_form::reciprocal_exponential,
            system,
            polynomial({s}),
            rate,
            mpfr(-log(ten_to(-digits)) * 5 / 4 / rate),
            {{"S(inf)", s}, {"rate", rate}}};
}

// x^2 + (a + g) x + a (g - b S(inf)) = 0 for the exponents of E and I at S = S(inf): the smaller decides.
far_behaviour of_seir(const equation_system& given, long digits) {
    const explicit_system system(given);
    const mpfr a = parameter_of(given, "a");
    const mpfr b = parameter_of(given, "b");
    const mpfr g = parameter_of(given, "g");
    const mpfr rest = start_of(system, 1, 0) + start_of(system, 2, 0);
    const mpfr s = left_of_epidemic(mpfr(g / b), start_of(system, 0, 0), rest);
    const mpfr rate = (a + g - sqrt(mpfr((a - g) * (a - g) + a * b * s * 4))) / 2;
    return {"seir",
            "S",
            far_form::damped_logarithm,
            system,
            polynomial({s}),
            rate,
            mpfr(-log(ten_to(-digits)) * 5 / 4 / rate),
            {{"S(inf)", s}, {"rate", rate}}};
}

mpfr gamma_of(const mpfr& x) {
    mpfr result(0);
    mpfr_gamma(handle(result), handle(x), MPFR_RNDN);
    return result;
}

// R0 sqrt(pi/6) Gamma(5/6)/Gamma(4/3) from rest.
far_behaviour of_rayleigh(const equation_system& given) {
    const explicit_system system(given);
    if (start_of(system, 0, 1) != 0) {
        throw error(error_kind::argument, "start", "", "of rayleigh moves, and its collapse is known from rest alone");
    }
    const mpfr end =
        start_of(system, 0, 0) * sqrt(mpfr(pi<mpfr>() / 6)) * gamma_of(mpfr(mpfr(5) / 6)) / gamma_of(mpfr(mpfr(4) / 3));
    return {"rayleigh", "R", far_form::branch, system, polynomial({mpfr(0)}), mpfr(0), end, {{"collapse", end}}};
}

}  // namespace

int far_behaviour::index() const {
    const auto& all = system.unknowns();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.name == unknown; });
    return static_cast<int>(found - all.begin());
}

const std::vector<std::string>& problems_with_far_behaviour() {
    static const std::vector<std::string> all{
        "blasius", "falkner_skan", "flierl_petviashvili", "rayleigh", "sakiadis", "seir", "sir", "sir_japan"};
    return all;
}

far_behaviour far_behaviour_of(const std::string& problem, const equation_system& given, long digits,
                               const std::string& free) {
    const precision_scope scope(2 * digits + 20);
    if (problem == "blasius") {
        return of_blasius(given, digits);
    }
    if (problem == "falkner_skan") {
        return of_falkner_skan(given, free.empty() ? "s" : free, digits);
    }
    if (problem == "sakiadis") {
        return of_sakiadis(given, digits);
    }
    if (problem == "flierl_petviashvili") {
        return of_flierl_petviashvili(given, digits);
    }
    if (problem == "seir") {
        return of_seir(given, digits);
    }
    if (problem == "rayleigh") {
        return of_rayleigh(given);
    }
    if (problem == "sir" || problem == "sir_japan") {
        return of_sir(problem, given, digits);
    }
    throw error(error_kind::argument, "problem", problem, "has no known far behaviour");
}

std::optional<std::function<mpfr(const mpfr&)>> asymptotic_approximant(const far_behaviour& far,
                                                                       const power_series<mpfr>& f) {
    const mpfr& limit = far.line[0];
    const int half = f.order() / 2;
    const auto from_pade = [](std::optional<damped_pade<mpfr>> found, bool logarithm) {
        std::optional<std::function<mpfr(const mpfr&)>> result;
        if (found) {
            result = [of = *std::move(found), logarithm](const mpfr& t) {
                return logarithm ? mpfr(exp(of.value(t))) : of.value(t);
            };
        }
        return result;
    };
    switch (far.form) {
        case far_form::power:
            return [of = power_approximant<mpfr>(f, far.line, mpfr(-1))](const mpfr& t) { return of.value(t); };
        case far_form::exponential:
            return [of = exponential_approximant<mpfr>(f, limit, far.rate)](const mpfr& t) { return of.value(t); };
        case far_form::reciprocal_exponential: {
            auto numerator = power_series<mpfr>::zero(f.order());
            numerator[0] = limit;
            return [of = exponential_approximant<mpfr>(numerator / f, mpfr(1), far.rate), limit](const mpfr& t) {
                return mpfr(limit / of.value(t));
            };
        }
        case far_form::damped:
            return from_pade(damped_pade<mpfr>::of(f, half, {limit, far.rate, mpfr(mpfr(1) / 2)}), false);
        case far_form::damped_logarithm:
            return from_pade(damped_pade<mpfr>::of(series::logarithm(f), half, {log(limit), far.rate, mpfr(0)}), true);
        case far_form::branch: break;
    }
    return [of = branch_approximant<mpfr>(f, far.end, mpfr(mpfr(2) / 5), 2)](const mpfr& t) { return of.value(t); };
}

}  // namespace libration
