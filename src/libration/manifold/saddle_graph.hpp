// Solutions that tend to a saddle whose equation depends on 1/t, as a graph with a proved error: theorem X.
#pragma once

#include <optional>
#include <vector>

#include "layer_graph.hpp"

namespace libration::ode {

/// u'' = R(u, u', w), w = 1/t, R a polynomial, with R(L, 0, 0) = 0 and a saddle there: x^2 = R_v x + R_u has roots of both signs.
struct saddle_equation {
    struct term {
        ball factor;
        unsigned w = 0, u = 0, v = 0;  ///< exponents
    };
    std::vector<term> terms;
    ball limit;  ///< L
};

/// Polynomials in w (sigma of layer_polynomial) and s (its u). With the approximate rates r+ > 0 > r-,
///     u = L + U(w) + a + s,   v = V(w) + r+ a + r- s,   a = phi(w, s) + rho,
/// U the formal solution in powers of w, V = -w^2 U_w, and phi the formal invariant graph, in which all numbers are exact. By theorems X1 and X2
/// [THEOREMS, X], for each (w, s) of the block 0 <= w <= w_0, |s| <= s_0 there is exactly one rho, |rho| <= eps, for which the solution stays in
/// the block |rho| <= eps: rho = Phi(w, s), with the Lipschitz constant `slope` in (w/w_0, s/s_0) in the maximum norm; and u tends to L.
struct saddle_graph {
    ball stable, unstable;            ///< r- and r+, exact
    layer_polynomial far, far_slope;  ///< L + U and V
    layer_polynomial phi;
    magnitude eps, slope;
    magnitude w, s;  ///< w_0 and s_0

    /// rho and s of a state, for w in the block.
    struct place {
        ball rho, s;
    };
    place place_of(const ball& u, const ball& v, const ball& w) const;
    /// The derivative of rho - Phi and of s along a vector (u, v, w) at a state.
    ball slope_along(const ball& u, const ball& v, const ball& w, const std::vector<ball>& along) const;
};

/// The formal graph up to w^terms, without errors; std::nullopt if the limit is not seen to be a saddle.
std::optional<saddle_graph> formal_saddle_graph(const saddle_equation& of, std::size_t terms);

/// Its errors on a block; std::nullopt if the hypotheses are not shown.
std::optional<saddle_graph> proved_saddle_graph(const saddle_equation& of, const saddle_graph& formal,
                                                const magnitude& w, const magnitude& s);

}  // namespace libration::ode
