// Functions on a box as polynomials in its coordinates with a bound of the rest: Taylor models [MakinoBerz2003].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "libration/scalar/ball/magnitude.hpp"

namespace libration::ode {

/// The monomials in variables a_1 .. a_m up to a total degree, in the order of their degrees, with the index of each
/// product: those of a lower degree are the first ones of any set of monomials in as many variables.
class monomial_set {
public:
    monomial_set(std::size_t variables, int degree);
    /// Up to the largest degree, at least 2 and at most 16, for which a product costs no more than so many
    /// multiplications.
    static monomial_set of_cost(std::size_t variables, std::size_t most_products);

    std::size_t variables() const { return variables_; }
    int degree() const { return static_cast<int>(ends_.size()) - 1; }
    std::size_t size() const { return exponents_.size(); }
    /// The number of monomials of at most this degree; 0 for a negative one.
    std::size_t size_to(int degree) const { return degree < 0 ? 0 : ends_[static_cast<std::size_t>(degree)]; }
    int degree_of(std::size_t i) const { return degrees_[i]; }
    const std::vector<std::uint8_t>& exponents(std::size_t i) const { return exponents_[i]; }
    /// The exponents of a variable in all monomials.
    const std::vector<std::uint8_t>& exponents_of(std::size_t variable) const { return by_variable_[variable]; }
    /// Whether it is a square: between 0 and 1 on [-1, 1]^m.
    bool is_even(std::size_t i) const { return even_[i]; }
    /// The indices of the products of monomial i with the first size_to(degree() - degree_of(i)) ones.
    const std::uint32_t* products_of(std::size_t i) const { return products_.data() + first_products_[i]; }

private:
    std::size_t variables_;
    std::vector<std::size_t> ends_;
    std::vector<std::vector<std::uint8_t>> exponents_;
    std::vector<std::vector<std::uint8_t>> by_variable_;
    std::vector<int> degrees_;
    std::vector<bool> even_;
    std::vector<std::size_t> first_products_;
    std::vector<std::uint32_t> products_;
};

/// The functions x on [-1, 1]^m with |x(a) - sum_i c_i a^e_i| <= rest for all a, c_i in double, e_i the exponents of a
/// monomial_set. The operations contain all results: rests include the terms of a higher degree and the rounding
/// errors of the coefficients, which are computed by rounding to nearest.
class taylor_model {
public:
    /// The number 0. The set must outlive all models.
    explicit taylor_model(const monomial_set& in) : in_(&in) {}
    /// All numbers of a ball, as constants.
    taylor_model(const monomial_set& in, const ball& constant);
    /// x_0 + sum_j x_j a_j for all numbers of balls, one for each variable.
    taylor_model(const monomial_set& in, const ball& constant, std::span<const ball> linear);

    const monomial_set& in() const { return *in_; }
    /// c_i; 0 beyond the last nonzero degree.
    double coefficient(std::size_t i) const { return i < coefficients_.size() ? coefficients_[i] : 0; }
    const magnitude& rest() const { return rest_; }
    void add_to_rest(const magnitude& more) { rest_ += more; }
    void drop_rest() { rest_ = magnitude(); }

    /// A bound of the sum of the |c_i| of one degree.
    magnitude norm(int degree) const;
    /// Of the sum of all |c_i|.
    magnitude norm() const { return norm_from(0); }
    /// Of |x(a)|, for all a: the sum of all |c_i| and the rest.
    magnitude size() const { return norm() + rest_; }
    /// Of the sum of the |c_i| of degrees from 1 on, hence of the distance of the polynomial from c_0.
    magnitude width() const { return norm_from(1); }
    /// Of the sum of the |c_i| of degrees from 2 on.
    magnitude nonlinear_width() const { return norm_from(2); }
    /// Of the sum of the |c_i| of degrees from 2 on, each times the exponent of a variable.
    magnitude nonlinear_share(std::size_t variable) const;
    /// A ball that contains x(a) for all a.
    ball range() const;

    /// As a function of b, where a variable is a_j = (b_j - 1)/2 on the lower half of its range, or (b_j + 1)/2.
    taylor_model on_half(std::size_t variable, bool upper) const;
    /// With the monomials of another set of as many variables and a lower degree.
    taylor_model truncated(const monomial_set& to) const;

    friend taylor_model operator+(const taylor_model& a, const taylor_model& b) { return combined(a, b, 1); }
    friend taylor_model operator-(const taylor_model& a, const taylor_model& b) { return combined(a, b, -1); }
    taylor_model& operator+=(const taylor_model& b) { return *this = combined(*this, b, 1); }
    /// Every number of a ball times x.
    friend taylor_model operator*(const ball& factor, const taylor_model& x);
    /// x + every number of a ball.
    friend taylor_model operator+(const taylor_model& x, const ball& constant) {
        return x + taylor_model(*x.in_, constant);
    }

    /// sum_j f_j x_j for all numbers of the balls f_j.
    friend taylor_model linear_combination(const std::vector<ball>& factors, const std::vector<taylor_model>& x);

    /// Coefficient n of the product of two series, sum_(j = 0 .. n) a_j b_(n - j).
    friend taylor_model product_coefficient(const std::vector<taylor_model>& a, const std::vector<taylor_model>& b,
                                            std::size_t n);

private:
    magnitude norm_from(std::size_t degree) const;
    static taylor_model combined(const taylor_model& a, const taylor_model& b, int sign);
    void measure();
    void add_rounding(const magnitude& of, std::size_t roundings);

    const monomial_set* in_;
    std::vector<double> coefficients_;  // up to the last degree with a nonzero one
    std::vector<magnitude> norms_;      // of each of these degrees
    magnitude rest_;
};

taylor_model linear_combination(const std::vector<ball>& factors, const std::vector<taylor_model>& x);
taylor_model product_coefficient(const std::vector<taylor_model>& a, const std::vector<taylor_model>& b, std::size_t n);

}  // namespace libration::ode
