// Norms of the steps of a tape about a point, of the part below degree N and of the rest, and of their changes.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "libration/expansion/tail_bound.hpp"

namespace libration::ode {

/// For ||a|| = sum |a_n| rho^n, rho = radius, p the polynomials of degree N of the unknowns: ||f, degrees >= N|| of each
/// step f(p), and bounds of ||f(p + e) - f(p)||. Products: sum_j |a_j| rho^j (the part of b from N - j on) + ||a|| r_b + r_a
/// ||b|| + r_a r_b. A quotient q = a/b: |b_0| |q_n| <= |a_n| + sum_k |b_k| |q_(n-k)|, so that Q = ||q, degrees >= N|| satisfies
/// Q (|b_0| - ||b - b_0||) <= r_a + (the products of terms below N), and its change is at most (s_a + ||q|| s_b)/(|b_0| - ||b
/// - b_0|| - s_b). A function F(u), by its kernel phi (function_kernel.hpp): u = u_0 + h + r, h of the degrees 1 .. N - 1 and r
/// of the others: ||F(u), degrees >= N|| <= ||phi(h), degrees >= N|| + r phi'(||h|| + r), its change for ||e|| <= s at most s
/// phi'(||h|| + r + s). For exprel and cosrel, whose companion is F'(u), more sharply with ||F'(u)|| instead of phi', and s^2
/// phi''/2 in addition.
class norms_of_steps {
public:
    /// For the polynomials p: of the degrees below N, and of the others.
    struct step_norm {
        std::vector<magnitude> terms;  ///< |a_j| rho^j, j < N
        magnitude low;                 ///< their sum
        magnitude rest;
        magnitude whole;  ///< low + rest
        magnitude slope;  ///< of exprel and cosrel, ||F'(u)||
    };

    /// All arguments must outlive it. Throws std::logic_error for operations that are not bounded.
    norms_of_steps(const tape& of, const series_sizes& sizes, const magnitude& radius);

    /// ||step, degrees >= N|| for p itself.
    const magnitude& rest(int step) const { return all_[static_cast<std::size_t>(step)].rest; }

    const step_norm& parts(int step) const { return all_[static_cast<std::size_t>(step)]; }
    /// Those of a polynomial of degree N, by its coefficients.
    step_norm parts_of(const ball* coefficients) const;
    /// ||a b, degrees >= N||.
    static magnitude rest_of_product(const step_norm& a, const step_norm& b);

    /// Whether the norms of all steps are finite: all of them are then analytic in the disc.
    bool are_finite() const;

    /// ||step(p + e) - step(p)|| where of_state(s) bounds ||e_i^(l)|| of the state s; of the first steps alone.
    std::vector<magnitude> changes(const std::function<magnitude(const tape_step& state)>& of_state,
                                   std::size_t steps) const;
    std::vector<magnitude> changes(const std::function<magnitude(const tape_step& state)>& of_state) const {
        return changes(of_state, all_.size());
    }

    /// Whether it bounds a step of a tape.
    static bool bounds(const tape_step& step);

private:
    magnitude factor_of(const tape_step& s) const;
    magnitude shift_of(const tape_step& s) const { return pow(radius_, static_cast<unsigned long>(s.shift)); }
    const step_norm& of(int step) const { return all_[static_cast<std::size_t>(step)]; }
    const magnitude& norm(int step) const { return of(step).whole; }
    magnitude reach_of(int step) const;
    const function_kernel& kernel(int step) const { return sizes_.kernels[static_cast<std::size_t>(step)]; }
    step_norm norm_of(const tape_step& s, int index) const;
    magnitude rest_of(const tape_step& s, const std::vector<magnitude>& a) const;
    magnitude rest_of_delayed(const step_norm& a, const tape_step& s) const;
    magnitude rest_of_quotient(const tape_step& s, const step_norm& q, int index) const;
    void set_function(step_norm& result, const tape_step& s, int index) const;
    magnitude change_of_function(const tape_step& s, int index, const magnitude& by) const;
    magnitude change_of_quotient(const tape_step& s, int index, const magnitude& above, const magnitude& below) const;

    const tape& tape_;
    const series_sizes& sizes_;
    std::size_t terms_;
    magnitude radius_;
    std::vector<magnitude> powers_;
    std::vector<step_norm> all_;
};

/// s of theorem T (bounded_tail) by norms that have been computed, from the first steps, among which are all right-hand
/// sides.
std::optional<std::vector<magnitude>> kept_remainders(const tape& of, const norms_of_steps& norms, int degree,
                                                      const magnitude& radius, std::size_t steps);

}  // namespace libration::ode
