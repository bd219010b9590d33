#include "libration/problem/known/blasius.hpp"

#include "far_start.hpp"
#include "known_problems.hpp"
#include "libration/digits/proved_decimals.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/proved.hpp"

namespace libration::ode {

namespace {

constexpr int latest_time = 1000;

}  // namespace

ball blasius_velocity() {
    const long bits = static_cast<long>(ball::working_bits());
    proved_march march(explicit_system(parse("f''' + f*f''/2 = 0; f(0) = 0; f'(0) = 0; f''(0) = 1")), bits + 32);
    for (int time = 8; time <= latest_time; time += 2) {
        const auto state = march.at(number(rational(time)));
        if (!state) {
            break;
        }
        const ball left = (*state)[2] * 2 / (*state)[0];  // decreases in t
        const magnitude bound(left);
        if (bound <= magnitude::of(1, -bits)) {
            return widened((*state)[1], bound);
        }
    }
    throw precision_exhausted("the velocity at infinity");
}

ball blasius_shear(const ball& value) {
    const ball ratio = value / blasius_velocity();
    return ratio * sqrt(ratio);
}

}  // namespace libration::ode

namespace libration {

namespace {

using ode::equation_system;
using ode::explicit_system;

// f ~ f'(inf) t + B, f'' vanishing faster than exponentially. If f'(inf) = l, F(t) = c f(c t), c = l^(-1/2), has 1.
far_behaviour far_from_blasius(const equation_system& given, long digits) {
    mpfr time(8);
    auto state = far::state_at(given, time);
    while (abs(state[2]) > far::ten_to(-digits - 4)) {
        time = time * 5 / 4;
        state = far::state_at(given, time);
    }
    const mpfr offset = state[0] - state[1] * time;
    const mpfr c = 1 / sqrt(state[1]);
    const explicit_system system(given);
    const mpfr scaled_shear = far::start_of(system, 0, 2) * c * c * c;
    return {"blasius",
            "f",
            far_form::power,
            system,
            far::polynomial({offset, state[1]}),
            mpfr(0),
            time,
            {{"f''(0) for f'(inf) = 1", scaled_shear}, {"B for f'(inf) = 1", mpfr(offset * c)}}};
}

}  // namespace

known_facts facts_of_blasius() {
    return {.problem = "blasius",
            .condition = condition_at_infinity{
                .unknowns = {"k"},
                .of = "f'(inf)",
                .limits = "above 0",
                .holds = [](const std::string& limit) { return ode::parse_constant(limit).constant().sign() > 0; },
                .values =
                    [](const equation_system&, const std::string& limit, long digits) {
                        return proved_decimals(digits, [&] {
                            const auto velocity = ode::parse_constant(limit).constant();
                            return std::vector{ode::blasius_shear(ode::constant_value<ball>::of(velocity))};
                        });
                    }},
            .far = [](const equation_system& given, long digits, const std::string&) {
                return far_from_blasius(given, digits);
            }};
}

}  // namespace libration
