// Polynomials of balls in powers of x on [-1, 1], and bounds of them there.
#pragma once

#include <vector>

#include "libration/integration/collocation/tube.hpp"
#include "libration/scalar/ball/magnitude.hpp"
#include "polynomial_map.hpp"

namespace libration::ode {

ball_polynomial sum_of(const ball_polynomial& a, const ball_polynomial& b);
ball_polynomial difference_of(const ball_polynomial& a, const ball_polynomial& b);
/// By guarded products of whole sequences (scalar/ball/polynomial.hpp).
ball_polynomial product_of(const ball_polynomial& a, const ball_polynomial& b);
ball_polynomial multiple_of(const ball& factor, const ball_polynomial& a);
/// a 2^e, exactly.
ball_polynomial shifted(ball_polynomial a, long e);
inline ball shifted(ball a, long e) {
    arb_mul_2exp_si(a.handle(), a.handle(), e);
    return a;
}
ball_polynomial derivative_of(const ball_polynomial& a);
std::vector<ball_polynomial> derivatives_of(const std::vector<ball_polynomial>& all);
ball value_of(const ball_polynomial& a, const ball& x);
/// value_of() for a wide x = m +- r: a(m) +- sum_(k > 0) |a^(k)(m)/k!| r^k, where value_of would add up the cancelling
/// powers of a number that is known to few digits.
ball value_over(const ball_polynomial& a, const ball& x);

/// The ring of such polynomials, for polynomial_map.
struct polynomial_ring {
    const std::vector<ball>& constants;
    ball_polynomial time;

    ball_polynomial constant(int k) const { return {constants[static_cast<std::size_t>(k)]}; }
    const ball_polynomial& variable() const { return time; }
    static ball_polynomial sum(const ball_polynomial& a, const ball_polynomial& b) { return sum_of(a, b); }
    static ball_polynomial difference(const ball_polynomial& a, const ball_polynomial& b) {
        return difference_of(a, b);
    }
    static ball_polynomial product(const ball_polynomial& a, const ball_polynomial& b) { return product_of(a, b); }
    ball_polynomial multiple(int k, const ball_polynomial& a) const {
        return multiple_of(constants[static_cast<std::size_t>(k)], a);
    }
    static ball_polynomial ratio(int p, int q, const ball_polynomial& a) { return multiple_of(ball(p) / ball(q), a); }
};

/// Chebyshev coefficients of polynomials, by x^k = sum_l w_kl T_l(x), w >= 0, sum_l w_kl = 1, so that radii are not
/// amplified.
class chebyshev_form {
public:
    explicit chebyshev_form(long bits) : bits_(bits) {}

    /// c_l.
    std::vector<ball> coefficients(const ball_polynomial& a);
    /// sum_l c_l T_l in powers of x, in the working precision.
    static ball_polynomial in_powers(const std::vector<ball>& coefficients);

    /// sum_l |c_l| >= |a(x)| on [-1, 1].
    magnitude supremum(const ball_polynomial& a);
    /// An upper bound of a(x), with its sign, on each of `parts` equal parts of [-1, 1], `parts` a power of two: the
    /// value at the midpoint plus half of the length times a bound of |a'|.
    std::vector<ball> upper_bounds(const ball_polynomial& a, int parts);

private:
    void extend(std::size_t length);

    long bits_;
    std::vector<std::vector<ball>> weights_;  ///< of T_l in x^l, x^(l+2), ..
};

}  // namespace libration::ode
