#include "libration/ode/proved/blasius_infinity.hpp"

#include "libration/ode/parse.hpp"
#include "libration/ode/proved/proved_march.hpp"
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
