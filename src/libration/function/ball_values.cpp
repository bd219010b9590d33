#include "libration/function/ball_values.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "libration/digits/precision_loop.hpp"
#include "libration/function/ball_functions.hpp"
#include "libration/function/list.hpp"
#include "libration/scalar/ball/ball.hpp"
#include "libration/scalar/ball/complex_values.hpp"
#include "libration/scalar/error.hpp"

namespace libration::function {

namespace {

template <class F>
concept has_balls = requires {
    F::template real_ball<arb_struct>;
};

// f(x) for a real or complex ball.
template <class R>
R ball_value(function_kind f, const rational* order, const R& x) {
    return with_function(f, [&](auto of) -> R {
        using each = decltype(of);
        if constexpr (ordered<each>) {
            return function_at(of, R(from_rational<ball>(*order)), x);
        } else if constexpr (has_balls<each>) {
            return function_at(of, x);
        } else {
            throw std::logic_error("a function that is not computed by FLINT");
        }
    });
}

range flint_bounds(function_kind f, const rational* order, const number_bounds& x) {
    ball at;
    arb_set_interval_mpfr(at.handle(), handle(x.lower), handle(x.upper), ball::working_bits());
    const ball value = ball_value(f, order, at);
    if (arb_is_finite(value.handle()) == 0) {
        return std::nullopt;
    }
    number_bounds result;
    arb_get_interval_mpfr(handle(result.lower), handle(result.upper), value.handle());
    return result;
}

std::array<mpfr, 2> flint_value(function_kind f, const rational* order, const std::array<mpfr, 2>& z, long bits) {
    constexpr long most_bits = 1L << 17U;
    using parts = std::array<mpfr, 2>;
    auto found = with_doubled_bits(bits + 32, std::max(most_bits, 8 * bits), [&](long at) {
        const precision_scope scope(decimal_digits(at));
        const complex_number<ball> value = ball_value(f, order, complex_number<ball>(ball(z[0]), ball(z[1])));
        const bool is_narrow = relative_bits(value) >= bits + 2;
        return is_narrow ? std::optional(parts{midpoint_of(value.re), midpoint_of(value.im)}) : std::nullopt;
    });
    if (!found) {
        refuse_number("takes " + std::string(name_of(f)) + " at a point where FLINT computes no value");
    }
    return *std::move(found);
}

std::vector<std::array<mpfr, 2>> flint_series(relative_kind family, int order, const std::array<mpfr, 2>& z, int count,
                                              long bits) {
    const precision_scope scope(decimal_digits(bits + 32));
    std::vector<std::array<mpfr, 2>> result;
    for (const auto& each : relative_series(family, order, complex_number<ball>(ball(z[0]), ball(z[1])), count)) {
        result.push_back({midpoint_of(each.re), midpoint_of(each.im)});
    }
    return result;
}

}  // namespace

bool use_flint() {
    static constexpr ball_functions by_flint{flint_bounds, flint_value, flint_series};
    use_functions(by_flint);
    return true;
}

}  // namespace libration::function
