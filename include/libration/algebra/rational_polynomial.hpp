// Polynomials with rational coefficients: exact arithmetic, irreducible factors, enclosures of roots.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "libration/scalar/ball/ball.hpp"
#include "libration/scalar/complex_number.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration {

/// c_0 + c_1 t + .. + c_d t^d, c_d != 0; without coefficients the polynomial 0, of degree -1.
class rational_polynomial {
public:
    rational_polynomial() = default;
    rational_polynomial(std::vector<rational> coefficients);
    explicit rational_polynomial(const rational& constant) : rational_polynomial(std::vector<rational>{constant}) {}

    int degree() const { return static_cast<int>(coefficients_.size()) - 1; }
    bool is_zero() const { return coefficients_.empty(); }
    /// c_k; 0 above the degree.
    rational operator[](int k) const { return k > degree() ? rational(0) : coefficients_[static_cast<std::size_t>(k)]; }
    const std::vector<rational>& coefficients() const { return coefficients_; }

    friend rational_polynomial operator+(const rational_polynomial& a, const rational_polynomial& b);
    friend rational_polynomial operator-(const rational_polynomial& a, const rational_polynomial& b);
    friend rational_polynomial operator*(const rational_polynomial& a, const rational_polynomial& b);
    friend rational_polynomial operator*(const rational_polynomial& a, const rational& c);
    friend bool operator==(const rational_polynomial& a, const rational_polynomial& b) = default;

    rational_polynomial derivative() const;
    /// p^(k)/k!.
    rational_polynomial taylor_coefficient(int k) const;

private:
    std::vector<rational> coefficients_;
};

struct polynomial_division {
    rational_polynomial quotient, rest;
};
/// a = quotient b + rest with the degree of the rest below that of b. Throws error if b is 0.
polynomial_division divided(const rational_polynomial& a, const rational_polynomial& b);

/// The greatest common divisor with leading coefficient 1, or 0 of two zeros.
rational_polynomial common_divisor(rational_polynomial a, rational_polynomial b);

/// The monic irreducible factors over the rational numbers of a nonzero polynomial, with their multiplicities
/// [FLINT, fmpz_poly_factor].
std::vector<std::pair<rational_polynomial, int>> irreducible_factors(const rational_polynomial& of);

/// Disjoint balls in the working precision, one for each root of a polynomial without multiple roots; real roots have the imaginary
/// part 0 exactly [Arb, arb_fmpz_poly_complex_roots].
std::vector<complex_number<ball>> enclosed_roots(const rational_polynomial& of);

/// The numbers a with p(x) = 0 for x = the class of t in Q[t]/(modulus), an irreducible polynomial: a field, whose elements are
/// polynomials of a degree below that of the modulus.
class number_field {
public:
    explicit number_field(rational_polynomial modulus) : modulus_(std::move(modulus)) {}

    const rational_polynomial& modulus() const { return modulus_; }
    rational_polynomial reduced(const rational_polynomial& a) const { return divided(a, modulus_).rest; }
    rational_polynomial product(const rational_polynomial& a, const rational_polynomial& b) const {
        return reduced(a * b);
    }
    /// 1/a, by Euclid's algorithm. Throws error if a is 0.
    rational_polynomial inverse(const rational_polynomial& a) const;

private:
    rational_polynomial modulus_;
};

/// Its value for t in a ball, by Horner's scheme.
complex_number<ball> value_at(const rational_polynomial& p, const complex_number<ball>& t);

}  // namespace libration
