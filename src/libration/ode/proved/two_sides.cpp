#include "two_sides.hpp"

#include <string>

#include "libration/ode/explicit_system.hpp"
#include "libration/ode/proved/proved_march.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/proved.hpp"

namespace libration::ode {

namespace {

constexpr int pieces_of_a_step = 8;
// Bits by which the two sides are farther apart than the working precision.
constexpr long bits_of_sides = 6;
constexpr int latest_time_of_sides = 100'000;

std::optional<side> side_of(const equation_system& system, long bits, const state_test& decided, const ball& least) {
    proved_march march(explicit_system(system), bits);
    while (march.prepare() && certainly_less(march.reached(), ball(latest_time_of_sides))) {
        if (const auto found = decided(march.values_at(ball(0)))) {
            return found;
        }
        const ball piece = march.length().exact() / pieces_of_a_step;
        for (int k = 0; k < pieces_of_a_step; ++k) {
            const auto values = march.values_at(hull(piece * k, piece * (k + 1)));
            if (!certainly_less(least, values[1])) {
                return std::nullopt;
            }
        }
        march.step(1);
    }
    return std::nullopt;
}

}  // namespace

equation_system with_value(equation_system system, const std::string& name, const mpfr& value) {
    rational q;
    mpfr_get_q(q.backend().data(), handle(value));
    return system.set(name, expression(q));
}

ball between(const equation_system& given, const std::string& name, const mpfr& middle, const state_test& decided,
             const ball& least) {
    const long bits = static_cast<long>(ball::working_bits());
    const mpfr away = ldexp(abs(middle), static_cast<int>(bits_of_sides - bits));
    const auto low = side_of(with_value(given, name, mpfr(middle - away)), bits + side_guard_bits, decided, least);
    const auto high = side_of(with_value(given, name, mpfr(middle + away)), bits + side_guard_bits, decided, least);
    if (!low || !high || *low == *high) {
        throw precision_exhausted("the sides of a value for infinity");
    }
    return hull(ball(mpfr(middle - away)), ball(mpfr(middle + away)));
}

}  // namespace libration::ode
