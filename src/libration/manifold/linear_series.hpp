// Power series of the solutions of linear equations of the second order with polynomial coefficients, with proved tails.
#pragma once

#include <optional>
#include <vector>

#include "libration/scalar/ball/magnitude.hpp"

namespace libration::ode {

/// a y'' + b y' = c y with polynomials in s, each by its coefficients of increasing powers.
struct second_order_equation {
    std::vector<ball> a, b, c;
};

/// p(s0 + t) as a polynomial in t.
std::vector<ball> shifted(std::vector<ball> p, const ball& s0);

/// One solution about s0 for |s - s0| <= |h|, as a series in tau = (s - s0)/h.
class linear_series {
public:
    /// Of all numbers of a ball of tau with |tau| <= 1.
    ball value(const ball& tau) const;
    /// dy/ds there.
    ball slope(const ball& tau) const;

private:
    friend class second_order_step;
    std::vector<ball> c_;
    magnitude tail_, slope_tail_;  // of the value, and of d/dtau, for |tau| <= 1
    ball length_;
};

/// The equation about an exact point s0 on a step to s0 + h.
///
/// With e_k = |y_k h^k| for the coefficients y_k of a solution, and the sums over i >= 0 (i >= 1 for a)
///     A = sum |a_i h^i/a_0|,   B = sum |b_i h^(i+1)/a_0|,   C = sum |c_i h^(i+2)/a_0|
/// of the coefficients about s0, the recurrence gives for k > N
///     e_k <= rho max(e_(k-w), .., e_(k-1)),   rho = A + B/(N+1) + C/(N (N+1)),
/// w the largest of deg a, deg b + 1 and deg c + 2. If rho < 1, e_k <= rho^m W for N + (m-1) w < k <= N + m w, where W is
/// the largest of the last w of e_0 .. e_N: the series converges for |s - s0| <= |h|, with the tails
///     sum e_k <= w rho W/(1 - rho),   sum k e_k <= w W (N rho/(1 - rho) + w rho/(1 - rho)^2).
class second_order_step {
public:
    /// A step from s0 to `to` or, where that is too far, a part of it: B and C are at most `size`, `size`^2, and A <= 1/2.
    /// std::nullopt if a(s0) is not seen to differ from 0.
    static std::optional<second_order_step> towards(const second_order_equation& of, const ball& s0, const ball& to,
                                                    double size);

    const ball& length() const { return length_; }
    /// The solution with y(s0) = value, y'(s0) = slope, to the working precision, or with N = terms if terms > 0;
    /// std::nullopt if rho < 1 is not seen.
    std::optional<linear_series> solution(const ball& value, const ball& slope, std::size_t terms = 0) const;

private:
    std::vector<ball> a_, b_, c_;  // a_i h^i, b_i h^(i+1), c_i h^(i+2)
    magnitude a_size_, b_size_, c_size_;
    ball inverse_;  // 1/a_0
    ball length_;
};

}  // namespace libration::ode
