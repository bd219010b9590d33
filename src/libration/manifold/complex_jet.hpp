// Complex balls with their derivatives by parameters, and linear systems of them.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "libration/scalar/ball/magnitude.hpp"
#include "libration/scalar/complex_number.hpp"

namespace libration::ode {

using complex_ball = complex_number<ball>;

/// A bound of |z|.
inline magnitude size_of_complex(const complex_ball& z) { return hypotenuse(magnitude(z.re), magnitude(z.im)); }
inline bool is_exact_zero(const complex_ball& z) {
    return arb_is_zero(z.re.handle()) != 0 && arb_is_zero(z.im.handle()) != 0;
}
inline complex_ball conjugate(const complex_ball& z) { return {z.re, -z.im}; }

/// An analytic function of parameters on a box: its values, and its derivatives, in enclosures; no derivatives are 0.
struct complex_jet {
    complex_ball value;
    std::vector<complex_ball> slopes;

    complex_jet() : value(ball(0), ball(0)) {}
    complex_jet(complex_ball constant) : value(std::move(constant)) {}
    complex_jet(complex_ball at, std::vector<complex_ball> by) : value(std::move(at)), slopes(std::move(by)) {}

    bool is_zero() const { return slopes.empty() && is_exact_zero(value); }
    complex_jet operator-() const;
    complex_jet& operator+=(const complex_jet& b);
    complex_jet& operator-=(const complex_jet& b);
    /// += a b.
    void add_product(const complex_jet& a, const complex_jet& b);
    friend complex_jet operator+(complex_jet a, const complex_jet& b) { return a += b; }
    friend complex_jet operator-(complex_jet a, const complex_jet& b) { return a -= b; }
    friend complex_jet operator*(const complex_jet& a, const complex_jet& b) {
        complex_jet result;
        result.add_product(a, b);
        return result;
    }
};

/// 1/a. Unbounded if a contains 0.
complex_jet reciprocal(const complex_jet& a);
complex_jet conjugate(const complex_jet& a);

/// By rows.
using jet_matrix = std::vector<std::vector<complex_jet>>;

jet_matrix unit_jets(std::size_t size);
jet_matrix product(const jet_matrix& a, const jet_matrix& b);
std::vector<complex_jet> product(const jet_matrix& a, const std::vector<complex_jet>& x);
/// The inverse by Gaussian elimination with the largest pivots; std::nullopt if a pivot may be 0.
std::optional<jet_matrix> inverse(const jet_matrix& a);

}  // namespace libration::ode
