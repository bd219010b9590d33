// Enclosures of all solutions from a box of initial values and parameters that are not close to linear on it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "libration/integration/proved_march.hpp"
#include "model_expansion.hpp"
#include "model_range.hpp"

namespace libration::ode {

/// Rows.
using model_matrix = std::vector<std::vector<taylor_model>>;

/// p(a) + e, a in [-1, 1]^m, e in a set: encloses the states of the solutions from each point a of a box.
struct model_set {
    std::vector<taylor_model> models;  ///< of all unknowns, with rests 0
    lohner_set errors;

    /// A bound of the error of an unknown.
    magnitude reach(std::size_t i) const { return errors.reach(i); }
    /// A bound of |y_i - p_i(0)| over the set.
    magnitude width(std::size_t i) const { return models[i].width() + reach(i); }
    /// A ball that contains an unknown over the set.
    ball range(std::size_t i) const { return widened(models[i].range(), reach(i)); }
};

/// A step from a model_set.
class model_step : public enclosed_step {
public:
    ball length_of_step() const override { return length_.exact(); }
    std::vector<ball> values_at(const ball& distance) const override;
    std::vector<ball> narrow_values_at(const ball& distance) const override;
    /// One of them, the range of its polynomial by narrow_range(), no narrower than `enough` requires.
    ball narrow_value_at(std::size_t i, const ball& distance, long log2_of_excess,
                         std::optional<enough_bounds> enough) const;

private:
    friend class model_march;
    model_step(const tape& of_box, const tape& varied, std::size_t given, const monomial_set& in,
               const monomial_set& few);

    taylor_model of_box_at(std::size_t i, const ball& distance) const;
    const std::vector<magnitude>& reaches() const;
    model_matrix derivative_of_flow(const ball& distance) const;

    model_expansion of_box_, of_set_;
    std::optional<tail_bound> tail_, set_tail_;
    lohner_set errors_;
    std::size_t given_;
    magnitude length_;
    mutable std::vector<magnitude> reaches_;  // of the errors at every distance of the step
};

/// Theorem V with polynomials. A solution through p(a) + e, e in E, is at the end of a step in p'(a) + E', because
///     Phi(p(a) + e) = Phi(p(a)) + (int_0^1 DPhi(p(a) + x e) dx) e,
/// E being convex: the coefficients of the series of the solutions from p(a) are computed as Taylor models of a, so that
/// Phi(p(a)) - p'(a) is bounded by their rests and the tail of theorem T for all a; and the derivative of the flow, from
/// theorem T for the system with its variations, over all p(a) + e. E' is their image (lohner_set).
///
/// The unknowns are all those of the polynomial form (polynomial_form).
class model_march : public enclosed_steps {
public:
    static constexpr std::size_t most_variables = 32;
    static constexpr long working_bits = 64;  ///< of the errors; the coefficients are in double

    /// From the initial point, from the states of a box: centre + sum_j C_j q_j a_j + e, the first m columns of the set
    /// times their radii; the others have the radius 0.
    model_march(const explicit_system& system, const state_set& start, std::size_t variables, march_watch watch);

    const enclosed_step* prepare_towards(const ball& rest) override;
    void take_prepared(int direction) override;

    march_end end() const override { return end_; }
    const ball& reached() const override { return time_; }
    long steps() const override { return steps_; }
    long bits() const override { return working_bits; }
    /// The states at reached(); null if the polynomial form may be singular on the set of the initial states, from which
    /// there is no step.
    const model_set* set() const { return set_ ? &*set_ : nullptr; }
    /// The derivative of the flow with respect to the given unknowns of the initial state, over the whole set, at a
    /// distance within the step that prepare_towards() has returned: a row for each given unknown. More narrowly if
    /// that needs more work.
    ball_matrix derivative_at(const ball& distance, bool narrowly) const;

private:
    void begin_from(const state_set& start);
    const enclosed_step* stopped(march_end why);
    bool expand();
    magnitude wanted_length() const;
    bool is_lost() const;

    polynomial_form lifted_;
    monomial_set monomials_, few_monomials_;
    tape tape_, varied_tape_;
    march_watch watch_;
    ball time_, origin_;
    std::optional<model_set> set_;
    model_matrix derivative_;        ///< of all unknowns at reached()
    std::vector<magnitude> widest_;  ///< of the polynomial parts up to now
    std::optional<model_step> now_;
    bool ready_ = false;
    long steps_ = 0;
    march_end end_ = march_end::none;
};

}  // namespace libration::ode
