// The local solutions at a balance as power series in x^step and the powers of x that the resonances add: theorem W by weights.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "dominant_balance.hpp"
#include "libration/scalar/ball/magnitude.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

using complex_ball = complex_number<ball>;

inline bool is_zero_term(const quadratic_number& z) { return z.is_zero(); }
inline bool is_zero_term(const complex_ball& z) {
    return arb_is_zero(z.re.handle()) != 0 && arb_is_zero(z.im.handle()) != 0;
}
// sum += a b, without temporaries.
inline void add_product(quadratic_number& sum, const quadratic_number& a, const quadratic_number& b) {
    sum = sum + a * b;
}
inline void add_product(complex_ball& sum, const complex_ball& a, const complex_ball& b) {
    const slong bits = ball::working_bits();
    arb_addmul(sum.re.handle(), a.re.handle(), b.re.handle(), bits);
    arb_submul(sum.re.handle(), a.im.handle(), b.im.handle(), bits);
    arb_addmul(sum.im.handle(), a.re.handle(), b.im.handle(), bits);
    arb_addmul(sum.im.handle(), a.im.handle(), b.re.handle(), bits);
}
inline bool may_be_zero(const complex_ball& z) { return contains_zero(z.re) && contains_zero(z.im); }

// The variables theta: first theta_0 = x^step if there is a step, then one for each growing component. Monomials theta^m up to a
// real part of the weight, by degree and then by the power of theta_0.
class weighted_monomials {
public:
    // The weights may exceed `highest` by none of the monomials, of which there are at most `most`.
    weighted_monomials(std::vector<quadratic_number> weights, double highest, std::size_t most);

    std::size_t variables() const { return weights_.size(); }
    std::size_t count() const { return all_.size(); }
    const std::vector<int>& operator[](std::size_t m) const { return all_[m]; }
    const quadratic_number& weight_of(std::size_t variable) const { return weights_[variable]; }
    const quadratic_number& weight(std::size_t m) const { return sums_[m]; }
    double size(std::size_t m) const { return sizes_[m]; }
    // All other monomials have a weight of at least this real part.
    double least_beyond() const { return highest_ * (1 - 1e-9); }
    std::optional<std::size_t> place_of(const std::vector<int>& exponents) const;
    // The pairs of indices of nonconstant monomials with the product m.
    const std::vector<std::pair<std::size_t, std::size_t>>& factors_of(std::size_t m) const { return factors_[m]; }

private:
    unsigned long key_of(const std::vector<int>& exponents) const;
    quadratic_number weight_sum(const std::vector<int>& exponents) const;
    void extend(std::vector<int>& exponents, std::size_t j, double left, std::size_t most);
    void make(double highest, std::size_t most);

    std::vector<quadratic_number> weights_;
    double highest_;
    std::size_t bits_of_exponent_ = 0;
    std::vector<std::vector<int>> all_;
    std::vector<quadratic_number> sums_;
    std::vector<double> sizes_;
    std::unordered_map<unsigned long, std::size_t> places_;
    std::vector<std::vector<std::pair<std::size_t, std::size_t>>> factors_;
};

// x dz_i/dx = sum of K_ij z_j + sum of factor theta_0^power times a node, z = V - limit; nodes: the constant 1, z_1 .. z_n, products of an
// unknown and a node.
template <class R>
struct balance_field {
    struct term {
        R factor;
        int power = 0;
        std::size_t node = 0;
    };
    std::vector<std::vector<term>> rows;
    std::vector<std::pair<std::size_t, std::size_t>> products;
};

// K theta^m in x dtheta_variable/dx besides r theta_variable.
template <class R>
struct resonant_term {
    std::size_t variable = 0;
    std::size_t monomial = 0;
    R factor;
};

template <class R>
struct balance_series {
    std::vector<std::vector<R>> nodes;  // coefficients of the nodes but the constant, by node - 1 and monomial
    std::vector<resonant_term<R>> resonant;
    std::vector<std::vector<R>> components;  // of w, by component and monomial
};

template <class R>
R value_in(const quadratic_number& z) {
    if constexpr (std::is_same_v<R, quadratic_number>) {
        return z;
    } else {
        return z.value();
    }
}

// z = Q w(theta), x dtheta/dx = weights theta + resonant terms: the coefficients of all monomials. With f the terms beyond K z and g =
// Q^-1 f, (W(m) - lambda_i) w_im = g_im - resonant terms applied to w_i, where the factor is nonzero; where it is 0, the left side belongs to
// theta' of a growing component, w_im = 0.
template <class R>
balance_series<R> series_of(const dominant_balance& balance, const balance_field<R>& field,
                            const weighted_monomials& monomials) {
    const std::size_t n = balance.orders.size();
    const std::size_t first = monomials.variables() - balance.growing.size();
    const std::size_t count = monomials.count();
    std::vector<std::vector<R>> q(n), inverse(n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            q[i].push_back(value_in<R>(balance.columns[i][j]));
            inverse[i].push_back(value_in<R>(balance.inverse_columns[i][j]));
        }
    }
    const R zero = value_in<R>(quadratic_number());
    balance_series<R> result;
    result.nodes.assign(n + field.products.size(), std::vector<R>(count, zero));
    result.components.assign(n, std::vector<R>(count, zero));
    for (std::size_t m = 1; m < count; ++m) {
        const std::vector<int>& exponents = monomials[m];
        for (std::size_t k = 0; k < field.products.size(); ++k) {
            const auto& a = result.nodes[field.products[k].first - 1];
            const auto& b = result.nodes[field.products[k].second - 1];
            R sum = zero;
            for (const auto& [left, right] : monomials.factors_of(m)) {
                if (!is_zero_term(a[left]) && !is_zero_term(b[right])) {
                    add_product(sum, a[left], b[right]);
                }
            }
            result.nodes[n + k][m] = sum;
        }
        std::vector<R> f(n, zero);
        for (std::size_t i = 0; i < n; ++i) {
            for (const auto& each : field.rows[i]) {
                if (each.power > 0 && exponents[0] < each.power) {
                    continue;
                }
                std::vector<int> rest = exponents;
                if (each.power > 0) {
                    rest[0] -= each.power;
                }
                const std::size_t at = each.power > 0 ? *monomials.place_of(rest) : m;
                if (each.node == 0) {
                    f[i] = at == 0 ? f[i] + each.factor : f[i];
                } else if (at > 0) {
                    const R& c = result.nodes[each.node - 1][at];
                    if (!is_zero_term(c)) {
                        add_product(f[i], each.factor, c);
                    }
                }
            }
        }
        for (std::size_t i = 0; i < n; ++i) {
            R g = zero;
            for (std::size_t j = 0; j < n; ++j) {
                if (!is_zero_term(inverse[i][j]) && !is_zero_term(f[j])) {
                    add_product(g, inverse[i][j], f[j]);
                }
            }
            for (const auto& each : result.resonant) {
                // theta^m' (m'_v)/theta_v theta^M has the exponents of m
                std::vector<int> source = exponents;
                ++source[each.variable];
                bool divides = true;
                for (std::size_t v = 0; v < source.size(); ++v) {
                    source[v] -= monomials[each.monomial][v];
                    divides = divides && source[v] >= 0;
                }
                const auto at = divides ? monomials.place_of(source) : std::nullopt;
                if (at && *at != 0 && !is_zero_term(result.components[i][*at])) {
                    g = g - each.factor * result.components[i][*at] *
                                value_in<R>(quadratic_number(rational(source[each.variable])));
                }
            }
            const quadratic_number divisor = monomials.weight(m) - balance.eigenvalues[i];
            std::optional<std::size_t> own;
            for (std::size_t j = 0; j < balance.growing.size(); ++j) {
                own = balance.growing[j] == i ? std::optional(first + j) : own;
            }
            const bool is_variable =
                own && monomials.weight(m).is_zero() == false && exponents[*own] == 1 &&
                std::count(exponents.begin(), exponents.end(), 0) + 1 == static_cast<std::ptrdiff_t>(exponents.size());
            if (is_variable) {
                result.components[i][m] = value_in<R>(quadratic_number(rational(1)));
            } else if (!divisor.is_zero()) {
                result.components[i][m] = is_zero_term(g) ? zero : g / value_in<R>(divisor);
            } else if (!is_zero_term(g)) {
                result.resonant.push_back({*own, m, g});
            }
        }
        for (std::size_t i = 0; i < n; ++i) {
            R sum = zero;
            for (std::size_t j = 0; j < n; ++j) {
                if (!is_zero_term(q[i][j]) && !is_zero_term(result.components[j][m])) {
                    add_product(sum, q[i][j], result.components[j][m]);
                }
            }
            result.nodes[i][m] = sum;
        }
    }
    return result;
}

// ||.|| = sum of the sizes of all coefficients times products of the radii. Bounds of ||z_i - polynomial||, the terms of weights beyond the
// monomials, by theorem W: with delta the terms of Q^-1 f(polynomial) there, N their least weight, eta_v the norm of the resonant terms of
// theta_v divided by its radius, and c_i = max(1, N/(N - Re lambda_i)) max of eta_v/Re r_v,
//     s_i >= (||delta_i|| + ||Q^-1 (f(z + Q e) - f(z))||_i)/(N - Re lambda_i) + c_i s_i  for all ||e|| <= s;
// by induction over the weights the formal series has such sums. std::nullopt if no s is found.
struct series_tail {
    std::vector<magnitude> beyond;  // by unknown
    std::vector<magnitude> norms;   // of the polynomials
};
std::optional<series_tail> tail_of(const dominant_balance& balance, const balance_field<complex_ball>& field,
                                   const weighted_monomials& monomials, const balance_series<complex_ball>& series,
                                   const std::vector<magnitude>& radii);

}  // namespace libration::ode
