#include "gamma_powers.hpp"

#include <algorithm>
#include <cmath>

#include "libration/scalar/ball/complex_values.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

ball gamma_at(const ball& x) { return apply(arb_gamma, x); }

ball quotient_of_gammas(long n, const ball& b) {
    return exp(ball(apply(arb_lgamma, ball(ball(n) - b)) - apply(arb_lgamma, ball(n + 1))));
}

ball with_image(const complex_ball& z, bool real) { return real ? z.re : ball(z.re * 2); }

long floor_in_double(const ball& x) {
    return static_cast<long>(std::floor(arf_get_d(arb_midref(upper_bound(x).handle()), ARF_RND_UP)));
}

bool is_zero_exactly(const complex_ball& z) {
    return is_exact(z.re) && contains_zero(z.re) && is_exact(z.im) && contains_zero(z.im);
}

namespace {

complex_ball polygamma_at(long order, const complex_ball& z) {
    flint_complex result;
    acb_polygamma(result.handle(), flint_complex(complex_ball(ball(order))).handle(), flint_complex(z).handle(),
                  ball::working_bits());
    return result.number();
}

complex_ball log_gamma_at(const complex_ball& z) {
    flint_complex result;
    acb_lgamma(result.handle(), flint_complex(z).handle(), ball::working_bits());
    return result.number();
}

}  // namespace

std::vector<complex_ball> gamma_series(const complex_ball& a, long n, std::size_t count) {
    // 1/Gamma(z) = z (z + 1) .. (z + k - 1)/Gamma(z + k)
    const long shift = std::max(0L, floor_in_double(ball(a.re + 2)));
    const complex_ball upper{ball(n) - a.re, -a.im};
    const complex_ball lower{ball(shift) - a.re, -a.im};
    std::vector<complex_ball> logarithm{log_gamma_at(upper) - log_gamma_at(lower) -
                                        complex_ball(apply(arb_lgamma, ball(n + 1)))};
    ball factorial(1);
    for (std::size_t j = 1; j < count; ++j) {
        const auto order = static_cast<long>(j);
        factorial *= order;
        const complex_ball by = (polygamma_at(order - 1, upper) - polygamma_at(order - 1, lower)) / factorial;
        logarithm.push_back(j % 2 == 0 ? by : -by);
    }
    flint_complex first;
    acb_exp(first.handle(), flint_complex(logarithm[0]).handle(), ball::working_bits());
    std::vector<complex_ball> result{first.number()};
    for (std::size_t j = 1; j < count; ++j) {
        complex_ball sum(0);
        for (std::size_t i = 1; i <= j; ++i) {
            sum = sum + logarithm[i] * result[j - i] * ball(static_cast<long>(i));
        }
        result.push_back(sum / ball(static_cast<long>(j)));
    }
    for (long i = 0; i < shift; ++i) {
        const complex_ball factor{ball(i) - a.re, -a.im};
        for (std::size_t k = count; k-- > 0;) {
            result[k] = k > 0 ? result[k] * factor - result[k - 1] : result[k] * factor;
        }
    }
    return result;
}

void take_next_exponent(std::vector<complex_ball>& series, const complex_ball& a, long n) {
    const complex_ball zero{-a.re - 1, -a.im};
    const complex_ball divisor{zero.re + n, zero.im};
    for (std::size_t k = series.size(); k-- > 0;) {
        series[k] = k > 0 ? series[k] * zero - series[k - 1] : series[k] * zero;
    }
    for (std::size_t k = 0; k < series.size(); ++k) {
        series[k] = (k > 0 ? series[k] + series[k - 1] : series[k]) / divisor;
    }
}

complex_ball inverse_power(const complex_ball& place, long n) {
    flint_complex power;
    acb_pow_si(power.handle(), flint_complex(place).handle(), -n, ball::working_bits());
    return power.number();
}

}  // namespace libration::ode
