#include "polynomial_range.hpp"

#include <algorithm>

#include "../../manifold/linear_series.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

ball_polynomial times(const ball_polynomial& a, const ball_polynomial& b) {
    ball_polynomial result(a.empty() || b.empty() ? 0 : a.size() + b.size() - 1, ball(0));
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t k = 0; k < b.size(); ++k) {
            result[i + k] += a[i] * b[k];
        }
    }
    return result;
}

// a + factor b.
ball_polynomial added(ball_polynomial a, long factor, const ball_polynomial& b) {
    a.resize(std::max(a.size(), b.size()), ball(0));
    for (std::size_t i = 0; i < b.size(); ++i) {
        a[i] += b[i] * factor;
    }
    return a;
}

ball_polynomial slope_of(const ball_polynomial& p) {
    ball_polynomial result;
    for (std::size_t i = 1; i < p.size(); ++i) {
        result.push_back(p[i] * static_cast<long>(i));
    }
    return result;
}

ball value_at(const ball_polynomial& p, const ball& s) {
    ball sum(0);
    for (std::size_t i = p.size(); i-- > 0;) {
        sum = sum * s + p[i];
    }
    return sum;
}

// Whether p(s) >= 0 for all s >= from.
bool is_nonnegative_from(const ball_polynomial& p, const ball& from) {
    return std::ranges::all_of(shifted(p, from),
                               [](const ball& each) { return arb_is_nonnegative(each.handle()) != 0; });
}

// Whether p(s) > 0 there.
bool is_positive_from(const ball_polynomial& p, const ball& from) {
    return is_nonnegative_from(p, from) && arb_is_positive(value_at(p, from).handle()) != 0;
}

// p(s)/s^(n) for all s >= from.
ball range_from(const ball_polynomial& p, std::size_t n, const ball& from) {
    const ball inverse = hull(ball(0), ball(1) / from);
    ball sum(0);
    for (std::size_t i = 0; i < std::max(p.size(), n + 1); ++i) {
        sum = sum * inverse + (i < p.size() ? p[i] : ball(0));
    }
    return sum;
}

}  // namespace libration::ode
