// Quotients of polynomials with rational coefficients.
#pragma once

#include <vector>

#include "libration/algebra/rational_polynomial.hpp"
#include "libration/scalar/ball/ball.hpp"

namespace libration::ode {

/// above/below without common factors; the last coefficient of `below` is 1.
class rational_function {
public:
    rational_function(const rational& constant = 0)
        : rational_function(rational_polynomial(constant), rational_polynomial(rational(1))) {}
    /// Throws error of the subject "problem" for a denominator 0.
    rational_function(rational_polynomial above, rational_polynomial below);
    /// s.
    static rational_function variable() {
        return {rational_polynomial(std::vector<rational>{0, 1}), rational_polynomial(rational(1))};
    }

    const rational_polynomial& above() const { return above_; }
    const rational_polynomial& below() const { return below_; }
    bool is_polynomial() const { return below_.degree() == 0; }

    friend rational_function operator+(const rational_function& a, const rational_function& b);
    friend rational_function operator*(const rational_function& a, const rational_function& b);
    friend rational_function operator/(const rational_function& a, const rational_function& b);
    friend bool operator==(const rational_function& a, const rational_function& b) = default;
    /// f(s) ~ c s^degree() for s -> inf with c of this sign; -1 or less, and 0, for f = 0.
    int degree() const { return above_.degree() - below_.degree(); }
    int sign_at_infinity() const { return above_.is_zero() ? 0 : above_.coefficients().back() > 0 ? 1 : -1; }
    /// Of -s, of 1/s, and of s + c.
    rational_function of_negative() const;
    rational_function of_inverse() const;
    rational_function of_sum(const rational& c) const;
    /// The derivative by s.
    rational_function derivative() const;

private:
    rational_polynomial above_, below_;
};

rational_function power(const rational_function& of, long n);

/// The coefficients at the working precision.
std::vector<ball> balls_of(const rational_polynomial& p);

}  // namespace libration::ode
