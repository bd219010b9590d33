#include "layer_graph.hpp"

#include <algorithm>

#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

constexpr std::size_t highest_power_of_u = 2;

// The formal solution of 0 = -phi^2 - a phi + sigma (k - (L + u) phi) - u phi phi_u + 2 (L + u) sigma^2 phi_sigma.
layer_polynomial formal_graph(const layer_equation& of, std::size_t terms) {
    layer_polynomial phi(terms + 1, highest_power_of_u + 1);
    phi.at(0, 0) = -of.a;
    for (std::size_t i = 0; i <= terms; ++i) {
        for (std::size_t j = 0; j <= highest_power_of_u; ++j) {
            if (i == 0 && j == 0) {
                continue;
            }
            ball sum(0);
            for (std::size_t k = 0; k <= i; ++k) {
                for (std::size_t l = 0; l <= j; ++l) {
                    const bool newest = (k == i && l == j) || (k == 0 && l == 0);
                    if (!newest) {
                        sum -= phi.at(k, l) * phi.at(i - k, j - l) * static_cast<long>(1 + l);
                    }
                }
            }
            if (i == 1 && j < of.k.size()) {
                sum += of.k[j];
            }
            const long twice = i > 0 ? 2 * static_cast<long>(i - 1) : 0;
            if (i > 0) {
                sum += phi.at(i - 1, j) * of.limit * (twice - 1);
            }
            if (i > 0 && j > 0) {
                sum += phi.at(i - 1, j - 1) * (twice - 1);
            }
            phi.at(i, j) = -sum / (of.a * static_cast<long>(1 + j));
        }
    }
    return phi;
}

// The right-hand side of that equation for phi, without the terms that vanish.
layer_polynomial residual_of(const layer_equation& of, const layer_polynomial& phi) {
    const std::size_t columns = std::max(2 * phi.columns() + 1, of.k.size() + 1);
    layer_polynomial result(2 * phi.rows() + 2, columns);
    const layer_polynomial by_u = phi.by_u();
    const layer_polynomial by_sigma = phi.by_sigma();
    result.add_product(ball(-1), phi, phi);
    result.add(-of.a, 0, 0, phi);
    for (std::size_t j = 0; j < of.k.size(); ++j) {
        result.at(1, j) += of.k[j];
    }
    result.add(-of.limit, 1, 0, phi);
    result.add(ball(-1), 1, 1, phi);
    layer_polynomial u_by_u(by_u.rows(), by_u.columns() + 1);
    u_by_u.add(ball(1), 0, 1, by_u);
    result.add_product(ball(-1), u_by_u, phi);
    result.add(of.limit * 2, 2, 0, by_sigma);
    result.add(ball(2), 2, 1, by_sigma);
    for (std::size_t i = 0; i < phi.rows(); ++i) {
        for (std::size_t j = 0; j < phi.columns(); ++j) {
            result.at(i, j) = ball(0);  // for the exact coefficients
        }
    }
    return result;
}

// -2 phi - a - sigma (L + u) - u phi_u.
layer_polynomial rate_of(const layer_equation& of, const layer_polynomial& phi) {
    layer_polynomial rate(std::max<std::size_t>(phi.rows(), 2), std::max<std::size_t>(phi.columns(), 2));
    rate.add(ball(-2), 0, 0, phi);
    rate.at(0, 0) -= of.a;
    rate.at(1, 0) -= of.limit;
    rate.at(1, 1) -= ball(1);
    rate.add(ball(-1), 0, 1, phi.by_u());
    return rate;
}

}  // namespace

void layer_polynomial::add(const ball& factor, std::size_t i, std::size_t j, const layer_polynomial& of) {
    for (std::size_t k = 0; k < of.rows(); ++k) {
        for (std::size_t l = 0; l < of.columns(); ++l) {
            if (arb_is_zero(of.c_[k][l].handle()) == 0) {
                c_[i + k][j + l] += factor * of.c_[k][l];
            }
        }
    }
}

void layer_polynomial::add_product(const ball& factor, const layer_polynomial& a, const layer_polynomial& b) {
    for (std::size_t k = 0; k < a.rows(); ++k) {
        for (std::size_t l = 0; l < a.columns(); ++l) {
            if (arb_is_zero(a.c_[k][l].handle()) == 0) {
                add(factor * a.c_[k][l], k, l, b);
            }
        }
    }
}

layer_polynomial layer_polynomial::by_sigma() const {
    layer_polynomial result(std::max<std::size_t>(rows(), 2) - 1, columns());
    for (std::size_t i = 1; i < rows(); ++i) {
        for (std::size_t j = 0; j < columns(); ++j) {
            result.c_[i - 1][j] = c_[i][j] * static_cast<long>(i);
        }
    }
    return result;
}

layer_polynomial layer_polynomial::by_u() const {
    layer_polynomial result(rows(), std::max<std::size_t>(columns(), 2) - 1);
    for (std::size_t i = 0; i < rows(); ++i) {
        for (std::size_t j = 1; j < columns(); ++j) {
            result.c_[i][j - 1] = c_[i][j] * static_cast<long>(j);
        }
    }
    return result;
}

ball layer_polynomial::value(const ball& sigma, const ball& u) const {
    ball sum(0);
    for (std::size_t i = rows(); i-- > 0;) {
        ball row(0);
        for (std::size_t j = columns(); j-- > 0;) {
            row = row * u + c_[i][j];
        }
        sum = sum * sigma + row;
    }
    return sum;
}

magnitude layer_polynomial::norm(const magnitude& sigma, const magnitude& u) const {
    magnitude sum;
    for (std::size_t i = rows(); i-- > 0;) {
        magnitude row;
        for (std::size_t j = columns(); j-- > 0;) {
            row = row * u + magnitude(c_[i][j]);
        }
        sum = sum * sigma + row;
    }
    return sum;
}

std::optional<layer_graph> proved_layer_graph(const layer_equation& of, std::size_t terms, const magnitude& sigma,
                                              const magnitude& u) {
    layer_graph result{formal_graph(of, terms), {}, {}, {}, {}, sigma, u};
    result.by_sigma = result.phi.by_sigma();
    result.by_u = result.phi.by_u();
    const layer_polynomial residual = residual_of(of, result.phi);
    const layer_polynomial rate = rate_of(of, result.phi);
    layer_polynomial rest = rate;
    rest.at(0, 0) = ball(0);
    const magnitude r = residual.norm(sigma, u);
    const ball low = lower_bound(rate.at(0, 0) - rest.norm(sigma, u).exact());
    if (arb_is_positive(low.handle()) == 0 || !certainly_less(u.exact(), of.limit)) {
        return std::nullopt;
    }
    // X1: |Res| < eps (low - eps).
    result.eps = (r / magnitude::below(low)).shifted(1) + magnitude::of(1, -8 * ball::working_bits());
    const ball eps = result.eps.exact();
    if (!certainly_less(r.exact(), eps * (low - eps))) {
        return std::nullopt;
    }
    layer_polynomial beside = result.phi;
    beside.at(0, 0) = ball(0);
    const ball decay = lower_bound(of.a - beside.norm(sigma, u).exact() - eps);  // -(phi + rho) is at least this
    if (arb_is_positive(decay.handle()) == 0) {
        return std::nullopt;
    }
    // X2 in u/u_0 and sigma/sigma_0.
    const ball m_a = low - eps * 2;
    const magnitude n_ab = u * (residual.by_u().norm(sigma, u) + result.eps * rate.by_u().norm(sigma, u)) +
                           sigma * (residual.by_sigma().norm(sigma, u) + result.eps * rate.by_sigma().norm(sigma, u));
    const ball of_u = (u * result.by_u.norm(sigma, u) + sigma * result.by_sigma.norm(sigma, u)).exact() - decay;
    const ball of_sigma = (sigma * u).shifted(1).exact();
    const ball mu_b = certainly_less(of_u, of_sigma) ? of_sigma : upper_bound(hull(of_u, of_sigma));
    const ball gap = lower_bound(m_a - mu_b);
    if (arb_is_positive(gap.handle()) == 0) {
        return std::nullopt;
    }
    result.slope = n_ab / magnitude::below(gap) * magnitude::of(3, -1) + magnitude::of(1, -8 * ball::working_bits());
    const ball l = result.slope.exact();
    const ball left = m_a - n_ab.exact() / l;
    const bool cones = certainly_less(mu_b + l, left) && arb_is_positive(lower_bound(left).handle()) != 0;
    return cones ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace libration::ode
