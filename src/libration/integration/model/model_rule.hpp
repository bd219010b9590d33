// Enclosures of all solutions from a box of initial values and parameters that are not close to linear on it.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "libration/equation/polynomial_form.hpp"
#include "libration/integration/rule.hpp"
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

/// The set of all unknowns of the polynomial form, and their derivatives by the given initial values.
struct model_state : carried {
    model_state(model_set of, model_matrix by_start, std::vector<magnitude> widths)
        : set(std::move(of)), derivative(std::move(by_start)), widest(std::move(widths)) {}

    model_set set;
    model_matrix derivative;
    std::vector<magnitude> widest;  ///< of the polynomial parts up to there

    /// Of a state of an integration by model_rule; null if the polynomial form may be singular on the set of the initial
    /// states, from which there is no step.
    static const model_state* of(const flow_state& at) { return dynamic_cast<const model_state*>(at.more.get()); }
};

/// The series of theorem V with polynomials, of the tapes of a rule, which must outlive it.
struct model_series {
    model_expansion of_box, of_set;
    std::optional<tail_bound> tail, set_tail;
    lohner_set errors;

    /// The solution from p(a), with all errors in the rest.
    taylor_model of_box_at(std::size_t i, const ball& distance) const;
    model_matrix derivative_of_flow(const ball& distance) const;
};

/// A step from a model_set.
class model_step : public step {
public:
    model_step(flow_state from, const ball& length, std::size_t given, std::shared_ptr<const model_series> series);

    std::vector<ball> values(const ball& distance) const override;
    std::vector<ball> narrow_values(const ball& distance) const override;
    /// One of them, the range of its polynomial by narrow_range(), no narrower than `enough` requires.
    ball narrow_value(std::size_t i, const ball& distance, long log2_of_excess,
                      std::optional<enough_bounds> enough) const;
    /// With respect to the given unknowns of the initial state, over the whole set: a row for each given unknown.
    ball_matrix derivative(const ball& distance) const override;
    /// The same, more narrowly with more work.
    ball_matrix narrow_derivative(const ball& distance) const;
    flow_state end() const override;

private:
    const std::vector<magnitude>& reaches() const;
    model_matrix models_of_derivative(const ball& distance) const;

    std::size_t given_;
    std::shared_ptr<const model_series> series_;
    mutable std::vector<magnitude> reaches_;  // of the errors at every distance of the step
    mutable std::once_flag has_reaches_;
};

/// Theorem V with polynomials. A solution through p(a) + e, e in E, is at the end of a step in p'(a) + E', because
///     Phi(p(a) + e) = Phi(p(a)) + (int_0^1 DPhi(p(a) + x e) dx) e,
/// E being convex: the coefficients of the series of the solutions from p(a) are computed as Taylor models of a, so that
/// Phi(p(a)) - p'(a) is bounded by their rests and the tail of theorem T for all a; and the derivative of the flow, from
/// theorem T for the system with its variations, over all p(a) + e. E' is their image (lohner_set).
///
/// The unknowns are all those of the polynomial form (polynomial_form); the set of a state is that of the box alone at the
/// initial point, and empty later.
class model_rule : public step_rule {
public:
    static constexpr std::size_t most_variables = 32;
    static constexpr long working_bits = 64;  ///< of the errors; the coefficients are in double

    model_rule(const explicit_system& system, std::size_t variables);

    /// The initial point, from the states of a box: centre + sum_j C_j q_j a_j + e, the first m columns of the set times
    /// their radii; the others have the radius 0.
    flow_state start_from(const state_set& start) const;

    void begin(const flow_state& start) override;
    next_step next(const flow_state& from, const ball& rest) override;

private:
    std::shared_ptr<model_series> expanded(const ball& time, const model_set& set) const;
    magnitude wanted_length(const model_series& series, const model_set& set) const;

    number point_;
    polynomial_form lifted_;
    monomial_set monomials_, few_monomials_;
    tape tape_, varied_tape_;
    ball origin_;
    long steps_ = 0;
};

}  // namespace libration::ode
