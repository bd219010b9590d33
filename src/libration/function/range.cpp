#include "libration/function/range.hpp"

#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "libration/function/ball_functions.hpp"
#include "libration/function/interval.hpp"
#include "libration/function/list.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/precision.hpp"

namespace libration::function {

namespace {

// Numbers with more than this many bits before the point, or zeros after it, are rejected, since they become fractions.
constexpr long largest_exponent_of_two = 1L << 27U;

// x / y rounded down or up, y != 0: the exact product of y and of the result lies on the corresponding side of x, or on
// the opposite one if y < 0. Beyond the range of exponents the result is infinite or 0, and is accepted.
int checked_quotient(mpfr_ptr result, mpfr_srcptr x, mpfr_srcptr y, mpfr_rnd_t rounding) {
    const int inexact = mpfr_div(result, x, y, rounding);
    if (mpfr_regular_p(result) != 0 && mpfr_regular_p(x) != 0) {
        mpfr_t product;
        mpfr_init2(product, mpfr_get_prec(result) + mpfr_get_prec(y));
        const bool in_range = mpfr_mul(product, result, y, MPFR_RNDN) == 0;
        const int side = mpfr_cmp(product, x) * mpfr_sgn(y);
        mpfr_clear(product);
        if (!in_range) {
            refuse_number("is beyond the range of numbers");
        }
        require_rounding(rounding == MPFR_RNDD ? side <= 0 : side >= 0);
    }
    return inexact;
}

const ball_functions* functions_in_use = nullptr;

}  // namespace

void require_rounding(bool as_asked) {
    if (!as_asked) {
        throw std::logic_error("a quotient of MPFR is on the wrong side of the exact one: no typed number is enclosed");
    }
}

void require_exponent(const number_bounds& x) {
    if (x.upper > largest_exponent_of_two || x.lower < -largest_exponent_of_two) {
        refuse_number("is beyond the range of numbers");
    }
}

number_bounds size_of(const number_bounds& x) {
    if (x.lower >= 0) {
        return x;
    }
    return x.upper <= 0 ? number_bounds{mpfr(-x.upper), mpfr(-x.lower)}
                        : number_bounds{mpfr(0), std::max(mpfr(-x.lower), x.upper)};
}

range quotient(const number_bounds& a, const number_bounds& b) {
    if (b.lower <= 0 && b.upper >= 0) {
        return std::nullopt;
    }
    return at_corners(a, b, checked_quotient);
}

number_bounds rising(rounded_function f, const number_bounds& x) {
    number_bounds result;
    f(handle(result.lower), handle(x.lower), MPFR_RNDD);
    f(handle(result.upper), handle(x.upper), MPFR_RNDU);
    return result;
}

number_bounds falling(rounded_function f, const number_bounds& x) {
    number_bounds result;
    f(handle(result.lower), handle(x.upper), MPFR_RNDD);
    f(handle(result.upper), handle(x.lower), MPFR_RNDU);
    return result;
}

number_bounds rising_with_size(rounded_function f, const number_bounds& x) {
    require_exponent(x);
    return rising(f, size_of(x));
}

number_bounds rising_steeply(rounded_function f, const number_bounds& x) {
    require_exponent(x);
    return rising(f, x);
}

// sin and cos have derivatives bounded by 1: the value at the midpoint, plus or minus the distance from there to the
// ends.
number_bounds of_circle(rounded_function f, const number_bounds& x) {
    mpfr middle = (x.lower + x.upper) / 2;
    middle = std::clamp(middle, x.lower, x.upper);
    mpfr left;
    mpfr right;
    mpfr_sub(handle(left), handle(middle), handle(x.lower), MPFR_RNDU);
    mpfr_sub(handle(right), handle(x.upper), handle(middle), MPFR_RNDU);
    const mpfr reach = std::max(left, right);
    number_bounds result;
    f(handle(result.lower), handle(middle), MPFR_RNDD);
    f(handle(result.upper), handle(middle), MPFR_RNDU);
    mpfr_sub(handle(result.lower), handle(result.lower), handle(reach), MPFR_RNDD);
    mpfr_add(handle(result.upper), handle(result.upper), handle(reach), MPFR_RNDU);
    return {std::max(result.lower, mpfr(-1)), std::min(result.upper, mpfr(1))};
}

range above(domain_end end, const number_bounds& x, const char* refusal) {
    if (x.upper < end.at || (!end.included && x.upper <= end.at)) {
        refuse_number(refusal);
    }
    return x.lower < end.at || (!end.included && x.lower <= end.at) ? std::nullopt : range(x);
}

range below(domain_end end, const number_bounds& x, const char* refusal) {
    if (x.lower > end.at || (!end.included && x.lower >= end.at)) {
        refuse_number(refusal);
    }
    return x.upper > end.at || (!end.included && x.upper >= end.at) ? std::nullopt : range(x);
}

void use_functions(const ball_functions& of_balls) { functions_in_use = &of_balls; }

const ball_functions& functions_of_balls(function_kind needed_for) {
    if (functions_in_use == nullptr) {
        refuse_number("takes " + std::string(name_of(needed_for)) +
                      ", which needs FLINT: include libration/proved.hpp and link libration::proved");
    }
    return *functions_in_use;
}

range by_balls(function_kind f, const number_bounds& x) { return functions_of_balls(f).bounds(f, nullptr, x); }

range by_balls(function_kind f, const rational& order, const number_bounds& x) {
    return functions_of_balls(f).bounds(f, &order, x);
}

mpfr rounded_value(function_kind f, const rational* order, const mpfr& x, long bits) {
    mpfr result;
    mpfr_set_prec(handle(result), bits);
    const rounded_function by_mpfr = with_function(f, [](auto of) -> rounded_function {
        if constexpr (requires { of.rounded; }) {
            return of.rounded;
        } else {
            return nullptr;
        }
    });
    if (by_mpfr != nullptr) {
        by_mpfr(handle(result), handle(x), MPFR_RNDN);
        return result;
    }
    const ball_functions& by_flint = functions_of_balls(f);
    constexpr int most_doublings = 12;
    long at = bits + 32;
    for (int i = 0; i < most_doublings && mpfr_number_p(handle(x)) != 0; ++i, at *= 2) {
        const precision_scope scope(decimal_digits(at));
        const range within = by_flint.bounds(f, order, {x, x});
        if (within && mpfr(within->upper - within->lower) <= ldexp(abs(within->lower), static_cast<int>(-bits - 8))) {
            mpfr_set(handle(result), handle(within->lower), MPFR_RNDN);
            return result;
        }
    }
    return result;  // a new MPFR number is NaN
}

}  // namespace libration::function
