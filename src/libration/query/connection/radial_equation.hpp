// Equations with 1/t in them, from the start at t = 0 or later up to a saddle.
#pragma once

#include <optional>
#include <string>

#include "../../manifold/saddle_graph.hpp"
#include "connection_map.hpp"
#include "power_equation.hpp"

namespace libration::ode {

/// u'' = sum c t^-p u^q u'^r with u -> L.
struct radial_equation {
    power_terms text;
    std::string name;
    expression limit;
    bool starts_at_zero = false;
    long power = 0;  ///< n at t = 0

    saddle_equation at_infinity() const;
};

/// Of a question with the limit u(inf) = L, and u'(inf) = 0 or not, and one initial value as its unknown; std::nullopt for other questions.
/// Throws error of the subject "problem" for a start at t = 0 that is not supported.
std::optional<radial_equation> radial_equation_in(const connection_question& question);

/// The question about (u, u', w = 1/t) as an autonomous system with the equilibrium (L, 0, 0).
connection_question far_question(const radial_equation& of, const connection_question& typed);

/// (g, t g', t) in log t, with the limits x, 0, 0 as log t -> -inf.
connection_question regular_question(const radial_equation& of, const connection_question& typed);

/// The state (u, u', 1/t) shortly after t = 0 for an initial value x, to about t^3 and without derivatives by x: for first guesses.
differentiable_start rough_start(const radial_equation& of, const ball& x);

/// The name of the free number in both.
inline constexpr const char* radial_unknown = "x";

}  // namespace libration::ode
