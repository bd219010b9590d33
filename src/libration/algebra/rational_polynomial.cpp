#include "libration/algebra/rational_polynomial.hpp"

#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/convert.hpp"
#include "libration/scalar/error.hpp"

#if __has_include(<flint/arb_fmpz_poly.h>)
#include <flint/arb_fmpz_poly.h>
#else
#include <arb_fmpz_poly.h>
#endif
#include <flint/fmpz_poly_factor.h>

namespace libration {

namespace {

// The integer polynomial that is a multiple of a rational one.
class integer_polynomial {
public:
    explicit integer_polynomial(const rational_polynomial& of) {
        fmpz_poly_init(value_);
        integer common(1);
        for (const rational& each : of.coefficients()) {
            common = lcm(common, denominator(each));
        }
        fmpz_t c;
        fmpz_init(c);
        for (int k = 0; k <= of.degree(); ++k) {
            const integer scaled = numerator(of[k]) * (common / denominator(of[k]));
            fmpz_set_mpz(c, scaled.backend().data());
            fmpz_poly_set_coeff_fmpz(value_, k, c);
        }
        fmpz_clear(c);
    }
    integer_polynomial(const integer_polynomial&) = delete;
    integer_polynomial& operator=(const integer_polynomial&) = delete;
    ~integer_polynomial() { fmpz_poly_clear(value_); }

    const fmpz_poly_t& handle() const { return value_; }

private:
    fmpz_poly_t value_{};
};

rational_polynomial monic(const rational_polynomial& p) { return p * (rational(1) / p.coefficients().back()); }

rational_polynomial monic(const fmpz_poly_struct& p) {
    std::vector<rational> coefficients;
    for (slong k = 0; k < p.length; ++k) {
        integer c;
        fmpz_get_mpz(c.backend().data(), p.coeffs + k);
        coefficients.emplace_back(c);
    }
    return monic(rational_polynomial(std::move(coefficients)));
}

}  // namespace

rational_polynomial::rational_polynomial(std::vector<rational> coefficients) : coefficients_(std::move(coefficients)) {
    while (!coefficients_.empty() && coefficients_.back() == 0) {
        coefficients_.pop_back();
    }
}

rational_polynomial operator+(const rational_polynomial& a, const rational_polynomial& b) {
    std::vector<rational> sum;
    for (int k = 0; k <= a.degree() || k <= b.degree(); ++k) {
        sum.push_back(a[k] + b[k]);
    }
    return sum;
}

rational_polynomial operator-(const rational_polynomial& a, const rational_polynomial& b) {
    return a + b * rational(-1);
}

rational_polynomial operator*(const rational_polynomial& a, const rational_polynomial& b) {
    if (a.is_zero() || b.is_zero()) {
        return {};
    }
    std::vector<rational> sums(static_cast<std::size_t>(a.degree() + b.degree() + 1));
    for (std::size_t i = 0; i < a.coefficients_.size(); ++i) {
        for (std::size_t j = 0; j < b.coefficients_.size(); ++j) {
            sums[i + j] += a.coefficients_[i] * b.coefficients_[j];
        }
    }
    return sums;
}

rational_polynomial operator*(const rational_polynomial& a, const rational& c) {
    std::vector<rational> all = a.coefficients_;
    for (rational& each : all) {
        each *= c;
    }
    return all;
}

rational_polynomial rational_polynomial::derivative() const {
    std::vector<rational> all;
    for (int k = 1; k <= degree(); ++k) {
        all.push_back((*this)[k] * k);
    }
    return all;
}

rational_polynomial rational_polynomial::taylor_coefficient(int k) const {
    rational_polynomial result = *this;
    for (int i = 1; i <= k; ++i) {
        result = result.derivative() * rational(1, i);
    }
    return result;
}

polynomial_division divided(const rational_polynomial& a, const rational_polynomial& b) {
    if (b.is_zero()) {
        throw error(error_kind::argument, "divisor", "0", "is the polynomial 0");
    }
    std::vector<rational> rest = a.coefficients();
    std::vector<rational> quotient;
    const auto degree = static_cast<std::size_t>(b.degree());
    while (rest.size() > degree) {
        const rational factor = rest.back() / b.coefficients().back();
        quotient.insert(quotient.begin(), factor);
        for (std::size_t k = 0; k <= degree; ++k) {
            rest[rest.size() - 1 - degree + k] -= factor * b.coefficients()[k];
        }
        rest.pop_back();
    }
    return {quotient, rest};
}

rational_polynomial common_divisor(rational_polynomial a, rational_polynomial b) {
    while (!b.is_zero()) {
        a = std::exchange(b, divided(a, b).rest);
    }
    return a.is_zero() ? a : monic(a);
}

std::vector<std::pair<rational_polynomial, int>> irreducible_factors(const rational_polynomial& of) {
    const integer_polynomial p(of);
    fmpz_poly_factor_t factors;
    fmpz_poly_factor_init(factors);
    fmpz_poly_factor(factors, p.handle());
    std::vector<std::pair<rational_polynomial, int>> result;
    for (slong k = 0; k < factors->num; ++k) {
        result.emplace_back(monic(factors->p[k]), static_cast<int>(factors->exp[k]));
    }
    fmpz_poly_factor_clear(factors);
    return result;
}

std::vector<complex_number<ball>> enclosed_roots(const rational_polynomial& of) {
    const integer_polynomial p(of);
    const slong count = std::max(of.degree(), 0);
    acb_ptr roots = _acb_vec_init(count);
    arb_fmpz_poly_complex_roots(roots, p.handle(), 0, ball::working_bits());
    std::vector<complex_number<ball>> result;
    for (slong k = 0; k < count; ++k) {
        complex_number<ball> root;
        arb_set(root.re.handle(), acb_realref(roots + k));
        arb_set(root.im.handle(), acb_imagref(roots + k));
        result.push_back(std::move(root));
    }
    _acb_vec_clear(roots, count);
    return result;
}

rational_polynomial number_field::inverse(const rational_polynomial& a) const {
    // old = s a modulo the modulus, in each step
    rational_polynomial old = a;
    rational_polynomial now = modulus_;
    rational_polynomial old_factor(rational(1));
    rational_polynomial factor;
    while (!now.is_zero()) {
        const polynomial_division by = divided(old, now);
        old = std::exchange(now, by.rest);
        old_factor = std::exchange(factor, old_factor - by.quotient * factor);
    }
    if (old.degree() != 0) {
        throw error(error_kind::argument, "divisor", "0", "has no inverse");
    }
    return reduced(old_factor * (rational(1) / old[0]));
}

complex_number<ball> value_at(const rational_polynomial& p, const complex_number<ball>& t) {
    complex_number<ball> sum(0);
    for (int k = p.degree(); k >= 0; --k) {
        sum = sum * t;
        sum.re += from_rational<ball>(p[k]);
    }
    return sum;
}

}  // namespace libration
