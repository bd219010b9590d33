// The derivative of the flow about a point, as a series from those of the Jacobian matrix, with its tail.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "libration/equation/polynomial_form.hpp"
#include "libration/expansion/ball_expansion.hpp"
#include "libration/expansion/tail_bound.hpp"
#include "libration/expansion/tape.hpp"

namespace libration::ode {

/// The Jacobian matrix J = df_i/dy_j of the given unknowns of a polynomial form, as polynomials in all of its unknowns, by its
/// nonzero entries. Not for a form that contains relative functions.
class jacobian_form {
public:
    explicit jacobian_form(const polynomial_form& of);

    struct entry {
        std::size_t row = 0, column = 0;
        bool constant = false;
    };

    /// The steps of the form, which observe the entries.
    const tape& steps() const { return tape_; }
    /// The number of those that are needed without the entries.
    std::size_t steps_of_unknowns() const;
    std::size_t given() const { return given_; }
    const std::vector<entry>& entries() const { return entries_; }

private:
    // The entries as expressions.
    struct differentiated {
        explicit differentiated(const polynomial_form& of);

        std::vector<entry> entries;
        std::vector<expression> values;
    };

    jacobian_form(const polynomial_form& of, differentiated jacobian);

    std::size_t given_;
    std::vector<entry> entries_;
    tape tape_;
};

/// V' = J(y) V, V(0) = 1: coefficient n + 1 of V is sum_(m <= n) J_m V_(n - m)/(n + 1), for all solutions y from a set of
/// balls. O(N^2) products for each entry of J and each column of V.
///
/// The tail is that of theorem T for y together with V. With s of the unknowns of the form found first, and with q the
/// polynomials of degree N of V, the condition of the theorem for V is
///     rho/(N+1) ||(J(p) q)_ij, degrees >= N|| + rho/(N+2) sum_k ((||J_ik|| + c_ik) s_kj + c_ik ||q_kj||) <= s_ij,
/// c a bound of ||J(p + e) - J(p)||: its matrix is the same for all columns j.
class flow_variations {
public:
    /// `of` must outlive it. Series of the unknowns and of V up to the power `order`.
    flow_variations(const jacobian_form& of, int order, const series::block_product<ball>* fast = nullptr);

    /// From all unknowns of the form (lifted_values), which are finite.
    void about(const ball& time, const std::vector<ball>& lifted);
    int order() const { return unknowns_.order(); }
    /// Coefficients 0 .. order of V_ij.
    const ball* coefficients(std::size_t i, std::size_t j) const { return columns_.data() + place(i, j); }
    /// log2 of the least radius of convergence of the unknowns and of V by their coefficients; infinite if none limits it.
    double estimated_radius() const;
    /// error[i] of the given unknowns, then those of V by columns: error[given (j + 1) + i]. std::nullopt as bounded_tail.
    std::optional<tail_bound> tail(const ball& time, double log_of_radius) const;

private:
    std::size_t place(std::size_t i, std::size_t j) const { return (j * of_->given() + i) * length_; }
    std::optional<tail_bound> bounded(const series_sizes& sizes, const magnitude& radius) const;

    const jacobian_form* of_;
    taylor_expansion<ball> unknowns_;
    std::size_t length_;
    std::vector<ball> columns_;
};

}  // namespace libration::ode
