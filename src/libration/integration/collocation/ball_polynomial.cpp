#include "ball_polynomial.hpp"

#include <algorithm>
#include <utility>

#include "libration/expansion/step_pieces.hpp"
#include "libration/scalar/ball/polynomial.hpp"
#include "libration/scalar/ball/predicates.hpp"

#if __has_include(<flint/arb_poly.h>)
#include <flint/arb_poly.h>
#else
#include <arb_poly.h>
#endif

namespace libration::ode {

ball_polynomial sum_of(const ball_polynomial& a, const ball_polynomial& b) {
    ball_polynomial result = a.size() >= b.size() ? a : b;
    const ball_polynomial& shorter = a.size() >= b.size() ? b : a;
    for (std::size_t k = 0; k < shorter.size(); ++k) {
        result[k] += shorter[k];
    }
    return result;
}

ball_polynomial difference_of(const ball_polynomial& a, const ball_polynomial& b) {
    ball_polynomial result = a;
    result.resize(std::max(a.size(), b.size()));
    for (std::size_t k = 0; k < b.size(); ++k) {
        result[k] -= b[k];
    }
    return result;
}

ball_polynomial product_of(const ball_polynomial& a, const ball_polynomial& b) {
    if (a.empty() || b.empty()) {
        return {};
    }
    if (a.size() == 1 || b.size() == 1) {
        return a.size() == 1 ? multiple_of(a.front(), b) : multiple_of(b.front(), a);
    }
    return leading_product(a.data(), static_cast<int>(a.size()), b.data(), static_cast<int>(b.size()),
                           static_cast<int>(a.size() + b.size() - 1), ball::working_bits());
}

ball_polynomial multiple_of(const ball& factor, const ball_polynomial& a) {
    ball_polynomial result;
    result.reserve(a.size());
    for (const ball& each : a) {
        result.push_back(factor * each);
    }
    return result;
}

ball_polynomial shifted(ball_polynomial a, long e) {
    for (ball& each : a) {
        arb_mul_2exp_si(each.handle(), each.handle(), e);
    }
    return a;
}

ball_polynomial derivative_of(const ball_polynomial& a) {
    ball_polynomial result;
    for (std::size_t k = 1; k < a.size(); ++k) {
        result.push_back(a[k] * static_cast<long>(k));
    }
    return result;
}

std::vector<ball_polynomial> derivatives_of(const std::vector<ball_polynomial>& all) {
    std::vector<ball_polynomial> result;
    result.reserve(all.size());
    for (const ball_polynomial& each : all) {
        result.push_back(derivative_of(each));
    }
    return result;
}

ball value_of(const ball_polynomial& a, const ball& x) {
    ball sum(0);
    for (std::size_t k = a.size(); k-- > 0;) {
        sum = sum * x + a[k];
    }
    return sum;
}

ball value_over(const ball_polynomial& a, const ball& x) {
    const magnitude radius = magnitude::radius_of(x);
    const ball middle = midpoint_alone(x);
    if (radius.is_zero() || a.size() < 2) {
        return value_of(a, middle);
    }
    const auto length = static_cast<slong>(a.size());
    arb_poly_t about;
    arb_poly_init2(about, length);
    for (slong k = 0; k < length; ++k) {
        arb_set(about->coeffs + k, a[static_cast<std::size_t>(k)].handle());
    }
    _arb_poly_taylor_shift(about->coeffs, middle.handle(), length, ball::working_bits());
    ball value;
    arb_set(value.handle(), about->coeffs);
    magnitude reach;
    magnitude power = radius;
    for (slong k = 1; k < length; ++k) {
        ball each;
        arb_swap(each.handle(), about->coeffs + k);
        reach.add_product(magnitude(each), power);
        power = power * radius;
    }
    arb_poly_clear(about);
    return widened(value, reach);
}

void chebyshev_form::extend(std::size_t length) {
    if (weights_.size() >= length) {
        return;
    }
    const std::size_t whole = std::max(length, 2 * weights_.size());
    const precision_scope scope(decimal_digits(bits_));
    weights_.assign(whole, {});
    for (std::size_t l = 0; l < whole; ++l) {
        // 2^(1-k) binom(k, (k-l)/2), half of it for l = 0.
        ball weight = shifted(ball(1), l == 0 ? 0 : 1 - static_cast<long>(l));
        for (std::size_t k = l; k < whole; k += 2) {
            if (k > l) {
                const auto j = static_cast<long>((k - l) / 2);
                const auto n = static_cast<long>(k);
                weight = weight * (n * (n - 1)) / (4 * j * (n - j));
            }
            weights_[l].push_back(weight);
        }
    }
}

std::vector<ball> chebyshev_form::coefficients(const ball_polynomial& a) {
    extend(a.size());
    std::vector<ball> result;
    for (std::size_t l = 0; l < a.size(); ++l) {
        result.push_back(inner_product(&a[l], 2, weights_[l].data(), 1, static_cast<int>((a.size() - l + 1) / 2)));
    }
    return result;
}

// Clenshaw's recurrence b_l = c_l + 2 x b_(l+1) - b_(l+2), of which the sum is b_0 - x b_1.
ball_polynomial chebyshev_form::in_powers(const std::vector<ball>& coefficients) {
    ball_polynomial next;
    ball_polynomial after;
    for (std::size_t l = coefficients.size(); l-- > 0;) {
        ball_polynomial now{coefficients[l]};
        for (const ball& each : next) {
            now.push_back(l == 0 ? each : each * 2L);
        }
        now = difference_of(now, after);
        after = std::exchange(next, std::move(now));
    }
    return next;
}

magnitude chebyshev_form::supremum(const ball_polynomial& a) {
    magnitude sum;
    for (const ball& each : coefficients(a)) {
        sum += magnitude(each);
    }
    return sum;
}

std::vector<ball> chebyshev_form::upper_bounds(const ball_polynomial& a, int parts) {
    const magnitude reach = supremum(derivative_of(a));
    std::vector<ball> bounds;
    for (int k = 0; k < parts; ++k) {
        const ball middle = ball(2L * k + 1 - parts) / parts;
        bounds.push_back(upper_bound(widened(value_of(a, middle), reach / static_cast<unsigned long>(parts))));
    }
    return bounds;
}

}  // namespace libration::ode
