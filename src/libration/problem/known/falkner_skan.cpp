#include "libration/problem/known/falkner_skan.hpp"

#include "far_start.hpp"
#include "known_problems.hpp"
#include "libration/digits/proved_decimals.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "shooting.hpp"

#include <cmath>

namespace libration::ode {

ball falkner_skan_shear(const equation_system& given) {
    const state_test decided = [](const std::vector<ball>& y) -> std::optional<side> {
        if (certainly_less(ball(1), y[1])) {
            return side::above;
        }
        return certainly_less(y[2], ball(0)) ? std::optional(side::below) : std::nullopt;
    };
    // f'' falls like exp(-t^2/2).
    const auto time = [](long bits) { return 4 + static_cast<int>(std::sqrt(1.4 * static_cast<double>(bits))); };
    return proved_shot(given, "s", 1, decided, ball(-1), time);
}

}  // namespace libration::ode

namespace libration {

namespace {

using ode::equation_system;
using ode::explicit_system;

far_behaviour far_from_falkner_skan(const equation_system& given, const std::string& free, long digits) {
    // Reversed profiles start with a long interval near rest, whose length follows from the guess unless it overshoots.
    mpfr first(9);
    for (auto state = far::state_at(given, first); first < 60 && abs(state[2]) * 100 > 1 && state[1] * 2 < 3;) {
        first = first * 3 / 2;
        state = far::state_at(given, first);
    }
    const auto found = far::reach(
        given, free, [](const std::vector<mpfr>& f, const mpfr& /*t*/) { return mpfr(f[1] - 1); },
        [](const std::vector<mpfr>& f, const mpfr& /*t*/) { return mpfr(abs(f[2])); }, first, digits + 4);
    const mpfr offset = found.state[0] - found.distance;
    return {"falkner_skan",
            "f",
            far_form::power,
            explicit_system(found.system),
            far::polynomial({offset, mpfr(1)}),
            mpfr(0),
            found.distance,
            {{free, found.value}, {"B", offset}}};
}

// The lemma is for accelerated flow.
void require_accelerated(const equation_system& system) {
    const auto* const b = system.parameter_of("b");
    if (b != nullptr && ode::number_with_values(b->value, system).sign() <= 0) {
        throw error(error_kind::undecided, error_subject::problem, "falkner_skan",
                    "has a lemma for its condition at infinity only for b > 0");
    }
}

}  // namespace

known_facts facts_of_falkner_skan() {
    return {.problem = "falkner_skan",
            .condition = condition_at_infinity{
                .unknowns = {"s"},
                .of = "f'(inf)",
                .limits = "1",
                .holds =
                    [](const std::string& limit) {
                        return (ode::parse_constant(limit).constant() - ode::number(1)).sign() == 0;
                    },
                .values =
                    [](const equation_system& system, const std::string&, long digits) {
                        require_accelerated(system);
                        return proved_decimals(digits, [&] { return std::vector{ode::falkner_skan_shear(system)}; });
                    }},
            .far = [](const equation_system& given, long digits, const std::string& free) {
                return far_from_falkner_skan(given, free.empty() ? "s" : free, digits);
            }};
}

}  // namespace libration
