// The stable manifold of an equilibrium as a power series with a proved tail: theorem W.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "graded_monomials.hpp"
#include "linear_frame.hpp"
#include "linear_steps.hpp"

namespace libration::ode {

/// y = P(theta) on the unit polydisc and theta' = h(theta), of a polynomial field at an equilibrium, by theorem W
/// [THEOREMS: parameterization method, CabreFontichLlave2003]: P = y* + Q p + O(|theta|^(N+1)), where p(theta) = (theta, 0) + ..
/// are polynomials of degree N for which the terms of degree <= N of B p + g(p) - Dp h vanish, B = Q^-1 A Q = diag(d) +
/// R, R_us = 0, g the terms of degree >= 2. With delta the other terms, alpha = min |Re d_s|, a_i = (N+1) alpha + Re d_i > 0, h~ = h
/// - d theta, which begins with R_ss theta, eta = max ||h~_j||, c_i = max(1/alpha, (N+1)/a_i), norms ||.|| the sums of the sizes of all coefficients: if
///     (||delta_i|| + sum_j |R_ij| s_j + G_i(s))/a_i + c_i eta s_i < s_i  for all i,  ||g_i(p+e) - g_i(p)|| <= G_i(s) for ||e|| <= s,
/// P exists, is unique, and |P - y* - Q p|_i <= (|Q| s)_i |theta|^(N+1), |theta| = max |theta_j| <= 1. It holds for each
/// point of the balls. A resonant or nearly resonant term of the first rows is in h~, which else is R_ss theta, and 0 without nearly
/// equal eigenvalues; if eta < alpha,
/// y(t) = P(theta(t)) tends to y* for |theta(0)| < 1.
class invariant_manifold {
public:
    /// The polynomials p up to degree N; the columns of the frame are those of the plan. Throws like linear_steps.
    invariant_manifold(const field_at_rest& field, const linear_frame& frame, const frame_plan& plan, int degree);

    /// |Q| s: bounds of the tails of y - y*; std::nullopt if theorem W was not shown with any s.
    std::optional<std::vector<magnitude>> tails() const;
    /// For each degree up to N the sum of the sizes of its terms in y - y*, the largest over the unknowns.
    std::vector<double> sizes() const;

    std::size_t variables() const { return monomials_->variables(); }
    int degree() const { return degree_; }
    /// The diagonal d_s.
    const std::vector<complex_jet>& rates() const { return rates_; }
    /// Whether h = diag(d) theta: no nearly equal eigenvalues, and no resonant terms.
    bool moves_linearly() const;

    struct point {
        std::vector<complex_jet> value;  ///< of the moving unknowns, without the tail
        jet_matrix by_theta;             ///< by_theta[i][j], without slopes
    };
    point at(const std::vector<complex_ball>& theta) const;

private:
    using block = std::vector<complex_jet>;  // the terms of one degree, by place
    using series = std::vector<block>;       // by degree

    void compute(const field_at_rest& field, const jet_matrix& inner);
    void add_degree(const field_at_rest& field, int m);
    void bound_defect();
    void solve_degree(const field_at_rest& field, int m);
    void solve_terms(const std::vector<block>& right, const std::vector<jet_matrix>& by, int m);
    std::vector<block> coupled(const std::vector<block>& rest, const std::vector<block>& p, int m) const;
    block nonlinear_part(std::size_t step, int m);
    void add_convolution(block& sum, const series& a, const series& b, int m) const;
    std::vector<block> residual(const field_at_rest& field, int m);
    complex_jet rate_of(const std::vector<int>& exponents) const;
    bool is_resonant(const std::vector<int>& exponents, std::size_t i) const;
    void subtract_normal_form(std::vector<block>& rest, int m) const;
    magnitude norm_of_degree(const series& of, int m) const;
    std::vector<magnitude> image(const std::vector<magnitude>& s) const;

    int degree_;
    int top_ = 1;
    std::vector<complex_jet> centre_;
    jet_matrix q_, inverse_, b_;
    std::vector<complex_jet> rates_;
    bool is_coupled_ = false;  // R_ss != 0
    frame_plan plan_;
    std::vector<linear_step> linear_;
    std::vector<std::size_t> outputs_;  // the steps of the slopes of the moving unknowns
    std::shared_ptr<graded_monomials> monomials_;
    std::vector<series> rest_;                   // of each step: the terms of order >= 2 in w
    std::vector<series> deviation_;              // all of it without the centre
    std::vector<series> p_;                      // in w
    std::vector<series> normal_;                 // h~
    std::vector<std::vector<magnitude>> norms_;  // of the deviation of each step, by degree up to top_
    std::vector<magnitude> whole_norms_;
    std::vector<magnitude> defect_;
};

}  // namespace libration::ode
