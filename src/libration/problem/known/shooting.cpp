#include "shooting.hpp"

#include <string>

#include "libration/equation/explicit_system.hpp"
#include "libration/integration/integration.hpp"
#include "libration/integration/rule_for.hpp"
#include "libration/integration/taylor/taylor_march.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/proved.hpp"

namespace libration::ode {

namespace {

constexpr int pieces_of_a_step = 8;
// Bits by which the distance of the two sides exceeds the working precision.
constexpr long bits_of_sides = 6;
constexpr int latest_time_of_sides = 100'000;

std::optional<side> side_of(const equation_system& system, long bits, const state_test& decided, const ball& least) {
    const explicit_system of(system);
    proof_route by_series;
    by_series.integrator = integrator_choice::taylor;
    integration along(start_of(of, bits), rule_for(of, {bits}, by_series, error_weights::absolute),
                      infinite_distance(1), bits);
    for (std::size_t k = 0; const step* const here = along[k]; ++k) {
        if (!certainly_less(here->from().time, ball(latest_time_of_sides))) {
            break;
        }
        if (const auto found = decided(here->values(ball(0)))) {
            return found;
        }
        const ball piece = here->length() / pieces_of_a_step;
        for (int i = 0; i < pieces_of_a_step; ++i) {
            const auto values = here->values(hull(piece * i, piece * (i + 1)));
            if (!certainly_less(least, values[1])) {
                return std::nullopt;
            }
        }
        along.forget_before(k);
    }
    return std::nullopt;
}

constexpr int most_secants = 40;

// f'(time) - target by one integration.
mpfr missed(const equation_system& system, const std::string& name, const mpfr& value, int time, int target) {
    taylor_march<mpfr> march(explicit_system(with_value(system, name, value)));
    return mpfr(march.advance_to(mpfr(time))[0][1] - target);
}

// The value with f'(T) = target for a T so large that it agrees with that for infinity, to the working precision.
mpfr shot(const equation_system& given, const std::string& name, int target, const std::function<int(long)>& time) {
    const definition* const guess = given.parameter_of(name);
    if (guess == nullptr) {
        throw error(error_kind::argument, error_subject::problem, "", "has no parameter " + name);
    }
    const number start = number_with_values(guess->value, given);
    mpfr value = constant_value<mpfr>::of(start);
    const long bits = static_cast<long>(digits<mpfr>());
    mpfr offset = ldexp(mpfr(1), -14);
    for (int at = 4; at <= time(bits); at += at < 8 ? 2 : 4) {
        const mpfr before = value;
        mpfr other = value + offset;
        mpfr of_value = missed(given, name, value, at, target);
        for (int k = 0; k < most_secants; ++k) {
            const mpfr of_other = missed(given, name, other, at, target);
            const mpfr difference = of_other - of_value;
            if (difference == 0) {
                break;
            }
            const mpfr next = other - of_other * (other - value) / difference;
            value = other;
            of_value = of_other;
            other = next;
            if (abs(mpfr(other - value)) <= ldexp(abs(value), static_cast<int>(4 - bits))) {
                break;
            }
        }
        value = other;
        offset = abs(mpfr(value - before)) + ldexp(abs(value), static_cast<int>(8 - bits));  // the next one is smaller
        if (mpfr_number_p(handle(value)) == 0) {
            throw error(error_kind::undecided, error_subject::problem, "",
                        "has a condition at infinity that is not met from this guess");
        }
    }
    return value;
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
    // Where the sides separate, f'' is about as small as their distance, and the integrator needs digits of it too.
    const long bits_of_both = 2 * bits + side_guard_bits;
    const auto low = side_of(with_value(given, name, mpfr(middle - away)), bits_of_both, decided, least);
    const auto high = side_of(with_value(given, name, mpfr(middle + away)), bits_of_both, decided, least);
    if (!low || !high || *low == *high) {
        throw precision_exhausted("the bracket of a value for a condition at infinity");
    }
    return hull(ball(mpfr(middle - away)), ball(mpfr(middle + away)));
}

ball proved_shot(const equation_system& given, const std::string& name, int target, const state_test& decided,
                 const ball& least, const std::function<int(long)>& time) {
    mpfr middle;
    {
        const precision_scope more(decimal_digits(static_cast<long>(ball::working_bits()) + side_guard_bits));
        middle = shot(given, name, target, time);
    }
    return between(given, name, middle, decided, least);
}

}  // namespace libration::ode
