// The exponentially decaying solutions of boundary-layer equations, as a graph with a proved error: theorems X and Y.
#pragma once

#include <optional>
#include <vector>

#include "libration/scalar/ball/magnitude.hpp"

namespace libration::ode {

/// f''' = -a f f'' + u k(u), u = f' - L, with a, L > 0 and a polynomial k: f' -> L.
struct layer_equation {
    ball a;
    ball limit;           ///< L
    std::vector<ball> k;  ///< by powers of u; empty: 0
};

/// A polynomial sum c_ij sigma^i u^j, by i and j.
class layer_polynomial {
public:
    layer_polynomial() = default;
    layer_polynomial(std::size_t rows, std::size_t columns) : c_(rows, std::vector<ball>(columns, ball(0))) {}

    std::size_t rows() const { return c_.size(); }
    std::size_t columns() const { return c_.empty() ? 0 : c_.front().size(); }
    ball& at(std::size_t i, std::size_t j) { return c_[i][j]; }
    const ball& at(std::size_t i, std::size_t j) const { return c_[i][j]; }
    /// += factor sigma^i u^j of.
    void add(const ball& factor, std::size_t i, std::size_t j, const layer_polynomial& of);
    /// += factor of b.
    void add_product(const ball& factor, const layer_polynomial& a, const layer_polynomial& b);
    layer_polynomial by_sigma() const;
    layer_polynomial by_u() const;
    ball value(const ball& sigma, const ball& u) const;
    /// sum |c_ij| sigma^i u^j.
    magnitude norm(const magnitude& sigma, const magnitude& u) const;

private:
    std::vector<std::vector<ball>> c_;
};

/// With r = f''/(f u), sigma = 1/f^2 and dtau = f dt,
///     r' = -r^2 - a r + sigma (k(u) - r (L + u)),   u' = r u,   sigma' = -2 (L + u) sigma^2,
/// and the formal graph r = phi(sigma, u) = -a + ..: by theorems X1 and X2 [THEOREMS, Y2], for each (sigma, u) of the
/// block 0 <= sigma <= sigma_0, |u| <= u_0 there is exactly one r with |r - phi| <= eps whose solution stays with it in the
/// block |r - phi| <= eps: r = Phi(sigma, u), |Phi - phi| <= eps, where Phi - phi has the Lipschitz constant `slope` in
/// (sigma/sigma_0, u/u_0) in the maximum norm. On it u decays like exp(-a int f): these solutions are the ones for which f' tends to L
/// exponentially.
struct layer_graph {
    layer_polynomial phi;
    layer_polynomial by_sigma, by_u;
    magnitude eps, slope;
    magnitude sigma, u;  ///< sigma_0 and u_0
};

/// phi up to sigma^terms, and its errors on the block; std::nullopt if the hypotheses of X1 and X2 are not shown.
std::optional<layer_graph> proved_layer_graph(const layer_equation& of, std::size_t terms, const magnitude& sigma,
                                              const magnitude& u);

}  // namespace libration::ode
