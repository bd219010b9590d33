// The exact structure of the solutions of a linear equation about a singular point: exponents and logarithms.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "libration/equation/linear_equation.hpp"

namespace libration::ode {

/// The solution x^e sum over n, k of v[n][k] x^n log(x)^k/k!, n <= last, whose further coefficients follow from its recurrence; the v are
/// elements of Q(alpha).
struct exact_local_solution {
    std::vector<std::vector<rational_polynomial>> v;
};

/// The exponents e + n_i, n_0 = 0 < n_1 < .., with multiplicities m_i, that differ by integers, and as many solutions as the sum of m_i.
struct exponent_class {
    rational exponent;
    std::vector<std::pair<long, int>> offsets;
    std::vector<exact_local_solution> solutions;
    long last() const { return offsets.back().first; }
};

/// About a root t* of an irreducible factor of p_r, with x = 1 - (t - t0)/(t* - t0), or x = t - t0 for t* = t0, log(x) and x^e real on the segment from t0,
///     L x^e = sum over l >= 0 of Q_l(e) x^(e+l-m),   Q_l(e) = sum over i of c_il e (e - 1) .. (e - i + 1),
/// with c_il in Q(alpha), alpha = t* - t0; Q_0 is the indicial polynomial, of degree r at regular singular points [Fuchs, Frobenius]. With S the shift
/// v_k -> v_(k+1) of coefficients of log^k/k!, which is x d/dx - e on them, the coefficients satisfy
///     Q_0(e + n + S) v_n = - sum over l >= 1 of Q_l(e + n - l + S) v_(n-l),
/// where Q_0(e + n + S) = S^m U(S), U(0) != 0, at an exponent of multiplicity m: v_0 .. v_(m-1) are free there, and the others follow. All
/// decisions about zeros are exact. Rational exponents are found for all roots of the factor at once.
class fuchsian_point {
public:
    fuchsian_point(const linear_equation& of, const rational_polynomial& factor);

    const number_field& field() const { return field_; }
    /// Whether t* = t0.
    bool is_start() const { return field_.modulus() == rational_polynomial({rational(0), rational(1)}); }
    /// Whether the point is a regular singular one; otherwise there is nothing else.
    bool is_regular() const { return regular_; }
    /// c_il.
    const std::vector<std::vector<rational_polynomial>>& coefficients() const { return c_; }
    const std::vector<exponent_class>& classes() const { return classes_; }
    /// The factor of the indicial polynomial, in powers of e, without rational roots.
    const std::vector<rational_polynomial>& other_exponents() const { return others_; }
    /// Whether all solutions are analytic there.
    bool is_apparent() const;
    /// Whether no solution has more than one value about it: integer exponents without logarithms.
    bool has_single_values() const;

private:
    void find_exponents();
    void solve(exponent_class& of) const;
    std::vector<rational_polynomial> shifted(std::size_t l, const rational& at, std::size_t count) const;

    number_field field_;
    bool regular_ = false;
    std::vector<std::vector<rational_polynomial>> c_;
    std::vector<exponent_class> classes_;
    std::vector<rational_polynomial> others_;
};

/// sum over i of c_i e (e - 1) .. (e - i + 1) at e = a + S, up to S^(count-1), for c_i and a of any field.
template <class R>
std::vector<R> falling_sum(const std::vector<R>& c, const R& a, std::size_t count) {
    std::vector<R> sum(count, R(0));
    std::vector<R> product(count, R(0));
    product[0] = R(1);
    for (std::size_t i = 0; i < c.size(); ++i) {
        for (std::size_t k = 0; k < count; ++k) {
            sum[k] = sum[k] + c[i] * product[k];
        }
        const R at = a - R(static_cast<int>(i));
        for (std::size_t k = count; k-- > 0;) {
            product[k] = k > 0 ? R(product[k] * at + product[k - 1]) : R(product[k] * at);
        }
    }
    return sum;
}

}  // namespace libration::ode
