#include "far_start.hpp"
#include "known_problems.hpp"
#include "libration/scalar/error.hpp"

namespace libration {

namespace {

using ode::equation_system;
using ode::explicit_system;

// w'/w of a decaying solution of w'' + w'/r - w = 0 at large r, that of K_0: v' = 1 - v/r - v^2, v = sum v_n r^-n,
// summed to its least term.
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

// The square of w is e^(-2 r) there, and an error of w0 grows by as much as e^r: half of the distance is accurate.
far_behaviour far_from_flierl_petviashvili(const equation_system& given, long digits) {
    const auto found = far::reach(
        given, "w0", [](const std::vector<mpfr>& w, const mpfr& r) { return mpfr(w[1] - w[0] * decay_of_bessel(r)); },
        [](const std::vector<mpfr>& /*w*/, const mpfr& r) { return exp(mpfr(r * -2)); }, mpfr(6), digits + 4);
    return {"flierl_petviashvili",      "w",     far_form::damped,         explicit_system(found.system),
            far::polynomial({mpfr(0)}), mpfr(1), mpfr(found.distance / 2), {{"w0", found.value}}};
}

}  // namespace

known_facts facts_of_flierl_petviashvili() {
    return {.problem = "flierl_petviashvili", .far = [](const equation_system& given, long digits, const std::string&) {
                return far_from_flierl_petviashvili(given, digits);
            }};
}

}  // namespace libration
