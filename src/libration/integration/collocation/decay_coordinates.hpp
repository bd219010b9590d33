// Unknowns that decay to nothing together: the logarithm of one of them, and the quotients of the others by it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "libration/equation/polynomial_form.hpp"
#include "libration/integration/lohner_set.hpp"

namespace libration::ode {

/// As many functions of the unknowns and of the variable as there are unknowns.
class coordinate_map {
public:
    coordinate_map(std::vector<expression> leaves, std::vector<expression> values);

    /// Their values at a state.
    std::vector<ball> at(const ball& time, const std::vector<ball>& state) const;
    /// Their derivatives with respect to the unknowns, over a box of states.
    ball_matrix derivative(const ball& time, const std::vector<ball>& state) const;
    /// Their values g(t, y) for every state of a set, at every time of a ball, by the mean value theorem as in
    /// lifted_set.hpp: for y = c + C e + a in the set, g(t, y) is in g(t, c) + (G C) e + G a, G = g_y over the whole set.
    /// std::nullopt if a value or a derivative is not finite on the set.
    std::optional<state_set> image(const ball& time, const state_set& of) const;

private:
    std::vector<expression> leaves_, values_;
    std::vector<std::vector<expression>> derivatives_;
};

/// Let the right-hand sides of some unknowns y_k, k in S, be linear in them without a term that is free of them,
///     y_k' = sum_(l in S) m_kl y_l,    m_kl functions of t and of the other unknowns.
/// With y_i of them not 0, u = log |y_i| and q_k = y_k/y_i solve
///     u' = sum_l m_il q_l,    q_k' = sum_l m_kl q_l - q_k u',    q_i = 1,
/// where the other equations contain y_i = s exp u and y_k = s exp(u) q_k, s the sign of y_i. In these coordinates, in
/// which the unknowns at the places of S are u and q_k, the relative error of an unknown that decays is bounded by the
/// absolute one of its logarithm, so that no step needs to resolve its decay.
///
/// Proof. Let (u, q, y_j) solve these equations on an interval. Then (s exp u, s exp(u) q_k, y_j) solves the given ones
/// there, and it is the only solution with these values at one time. []
class decay_coordinates {
public:
    /// For these unknowns of a polynomial form, and a set of its given unknowns at a time; std::nullopt if the
    /// right-hand sides are not of this form, or none of the unknowns is distinguished from 0.
    static std::optional<decay_coordinates> of(const polynomial_form& form, const std::vector<std::size_t>& decaying,
                                               const state_set& at);

    /// The polynomial form of the equations in these coordinates; its given unknowns are as many as before.
    const polynomial_form& system() const { return system_; }
    const coordinate_map& to_coordinates() const { return to_; }
    const coordinate_map& from_coordinates() const { return from_; }

private:
    decay_coordinates(polynomial_form system, coordinate_map to, coordinate_map from)
        : system_(std::move(system)), to_(std::move(to)), from_(std::move(from)) {}

    polynomial_form system_;
    coordinate_map to_, from_;
};

}  // namespace libration::ode
