#include "libration/plane/regular_coordinates.hpp"

#include <cstddef>
#include <utility>

#include "coefficients_in.hpp"

namespace libration::ode {

namespace {

expression slope_in_time(const expression& e) { return partial(e, variable()); }

}  // namespace

std::optional<regular_coordinates> regular_coordinates::of(const explicit_system& system) {
    if (system.unknowns().size() != 1 || system.singular() || system.unknowns().front().order > 2) {
        return std::nullopt;
    }
    const auto& [name, order] = system.unknowns().front();
    const expression& f = system.right().front();
    const expression y = unknown(name);
    const expression v = unknown("v");
    if (order == 1) {
        const auto a = coefficients_in(f, y, 2);
        if (!a || (*a)[2].is(0)) {
            return std::nullopt;
        }
        const expression right = -(*a)[2] - (*a)[1] * v - (*a)[0] * v * v;
        return regular_coordinates(1, {v}, explicit_system::first_order({v}, {right}, system.point()));
    }
    if (!partial(f, unknown(name, 1)).is(0)) {
        return std::nullopt;
    }
    const auto coefficients = coefficients_in(f, y, 3);
    if (!coefficients) {
        return std::nullopt;
    }
    const expression& c = (*coefficients)[0];
    const expression& b = (*coefficients)[1];
    const expression& a2 = (*coefficients)[2];
    const expression& a3 = (*coefficients)[3];
    const bool cubic = !a3.is(0);
    const expression moving = slope_in_time(cubic ? b : c);
    const expression resting = slope_in_time(cubic ? c : b);
    const bool regular = a3.is_constant() && a2.is_constant() && (cubic || !a2.is(0)) && resting.is(0) &&
                         moving.is_constant() && (!cubic || moving.is(0) || a2.is(0));
    if (!regular) {
        return std::nullopt;
    }
    const expression k = cubic ? 2 * moving / a3 : 6 * moving / a2;
    const expression p = unknown("p");
    const expression g = unknown("g");
    const expression of_p = -a2 / 3 - b * v - 3 * c * v * v - 2 * (g * v * v * v - k * p * v * v);
    const expression of_g = -k * (c * v + g * v * v - k * p * v);
    regular_coordinates made(cubic ? 1 : 2, {v, p, g},
                             explicit_system::first_order({v, p, g}, {-p, of_p, of_g}, system.point()));
    made.a3_ = a3;
    made.a2_ = a2;
    made.b_ = b;
    made.c_ = c;
    made.k_ = k;
    return made;
}

}  // namespace libration::ode
