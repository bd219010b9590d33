#include "libration/problem/known/thomas_fermi.hpp"

#include <optional>

#include "known_problems.hpp"
#include "libration/digits/proved_decimals.hpp"
#include "libration/equation/explicit_system.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/integration/taylor/taylor_march.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "shooting.hpp"

namespace libration::ode {

namespace {

// s as an additional unknown, since theorem V passes on values alone.
equation_system equations() {
    return parse("y' = 2*t*v; v' = 2*y^(3/2); s' = 1; y(0) = 1; v(0) = slope; s(0) = 0; slope = -3/2");
}

// The lemma on numbers or balls, where `less` is certain.
template <class T, class Less>
std::optional<side> side_at(const T& y, const T& v, const T& s, const Less& less) {
    if (less(T(0), v)) {
        return side::above;
    }
    return less(v, T(0)) && less(T(y * y * sqrt(y) * 4), T(s * v * v)) ? std::optional(side::below) : std::nullopt;
}

// In floating-point arithmetic; a solution that cannot be continued has met y = 0.
side likely_side(const equation_system& given, const mpfr& slope) {
    taylor_march<mpfr> march(explicit_system(with_value(given, "slope", slope)));
    try {
        for (mpfr s(1);; s += s / 16) {
            const auto& state = march.advance_to(s);
            const mpfr& y = state[0][0];
            if (!(y > 0)) {
                return side::below;
            }
            const auto less = [](const mpfr& a, const mpfr& b) { return a < b; };
            if (const auto found = side_at(y, state[1][0], s, less)) {
                return *found;
            }
        }
    } catch (const error&) {
        return side::below;
    }
}

}  // namespace

ball thomas_fermi_slope() {
    const auto bits = static_cast<int>(ball::working_bits());
    const equation_system given = equations();
    mpfr middle;
    {
        const precision_scope more(decimal_digits(bits + side_guard_bits));
        mpfr low(-2);
        mpfr high(-1);
        for (int k = 0; k < bits; ++k) {
            middle = (low + high) / 2;
            (likely_side(given, middle) == side::above ? high : low) = middle;
        }
    }
    const auto decided = [](const std::vector<ball>& state) {
        return side_at(state[0], state[1], state[2], [](const ball& a, const ball& b) { return certainly_less(a, b); });
    };
    return between(given, "slope", middle, decided, ball(-3));
}

}  // namespace libration::ode

namespace libration {

known_facts facts_of_thomas_fermi() {
    return {.problem = "thomas_fermi",
            .condition = condition_at_infinity{
                .unknowns = {"slope"},
                .of = "y(inf)",
                .limits = "0",
                .holds = [](const std::string& limit) { return ode::parse_constant(limit).constant().sign() == 0; },
                .values =
                    [](const ode::equation_system&, const std::string&, long digits) {
                        return proved_decimals(digits, [] { return std::vector{ode::thomas_fermi_slope()}; });
                    }}};
}

}  // namespace libration
