// The terms of one degree of an invariant manifold.
#include <algorithm>
#include <cmath>

#include "invariant_manifold.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

// Where |<m, d> - d_i| is below this part of alpha, the term is in the normal form.
constexpr double nearly_resonant = 0.125;
constexpr int most_couplings = 300;

bool is_strictly_inside(const ball& inner, const ball& outer) {
    return arb_contains_interior(outer.handle(), inner.handle()) != 0;
}

bool is_strictly_inside(const complex_ball& inner, const complex_ball& outer) {
    return is_strictly_inside(inner.re, outer.re) && is_strictly_inside(inner.im, outer.im);
}

// Of the value and all slopes; absent ones are 0.
bool is_strictly_inside(const complex_jet& inner, const complex_jet& outer) {
    if (inner.slopes.size() > outer.slopes.size() || !is_strictly_inside(inner.value, outer.value)) {
        return false;
    }
    for (std::size_t l = 0; l < outer.slopes.size(); ++l) {
        if (!is_strictly_inside(l < inner.slopes.size() ? inner.slopes[l] : complex_ball(ball(0), ball(0)),
                                outer.slopes[l])) {
            return false;
        }
    }
    return true;
}

ball twice_as_wide(const ball& x) {
    return widened(x, magnitude::radius_of(x) + magnitude::of(1, -4 * ball::working_bits()));
}

complex_ball twice_as_wide(const complex_ball& x) { return {twice_as_wide(x.re), twice_as_wide(x.im)}; }

complex_jet twice_as_wide(complex_jet x) {
    x.value = twice_as_wide(x.value);
    for (complex_ball& each : x.slopes) {
        each = twice_as_wide(each);
    }
    return x;
}

}  // namespace

// The same for conjugate monomials: the summands of a pair are added first.
bool invariant_manifold::is_resonant(const std::vector<int>& exponents, std::size_t i) const {
    double re = 0;
    double im = 0;
    double alpha = INFINITY;
    for (std::size_t j = 0; j < exponents.size(); ++j) {
        alpha = std::min(alpha, -plan_.rates[j].real());
        if (plan_.begins_pair(j)) {
            re += plan_.rates[j].real() * (exponents[j] + exponents[j + 1]);
            im += plan_.rates[j].imag() * (exponents[j] - exponents[j + 1]);
        } else if (!plan_.ends_pair(j)) {
            re += plan_.rates[j].real() * exponents[j];
        }
    }
    return std::hypot(re - plan_.rates[i].real(), im - plan_.rates[i].imag()) < nearly_resonant * alpha;
}

// p of the degree solves p = S(rest + C p), S the solution without R_ss and C its terms, an affine map: if it maps a box into the
// interior of that box, its only fixed point is there.
void invariant_manifold::solve_degree(const field_at_rest& field, int m) {
    const std::size_t n = centre_.size();
    const std::size_t k = rates_.size();
    const auto rest = residual(field, m);
    for (series& each : p_) {
        each.emplace_back(monomials_->places(m));
    }
    for (series& each : normal_) {
        each.emplace_back(monomials_->places(m));
    }
    std::vector<jet_matrix> inverses;  // of <m, d> - B_uu
    for (const auto& each : monomials_->of_degree(m)) {
        jet_matrix others(n - k, std::vector<complex_jet>(n - k));
        for (std::size_t i = k; i < n; ++i) {
            for (std::size_t j = k; j < n; ++j) {
                others[i - k][j - k] = (i == j ? rate_of(each.exponents) : complex_jet()) - b_[i][j];
            }
        }
        auto by = inverse(others);
        if (!by) {
            throw precision_exhausted("a term of a manifold");
        }
        inverses.push_back(*std::move(by));
    }
    solve_terms(rest, inverses, m);
    if (!is_coupled_) {
        return;
    }
    const auto terms = [&] {
        std::vector<block> result;
        for (const series& each : p_) {
            result.push_back(each.back());
        }
        return result;
    };
    for (int round = 0; round < most_couplings; ++round) {
        auto outer = terms();
        for (block& each : outer) {
            std::ranges::transform(each, each.begin(), [](const complex_jet& x) { return twice_as_wide(x); });
        }
        solve_terms(coupled(rest, outer, m), inverses, m);
        const auto inner = terms();
        bool inside = true;
        for (std::size_t i = 0; i < n; ++i) {
            for (const auto& each : monomials_->of_degree(m)) {
                inside = inside && is_strictly_inside(inner[i][each.place], outer[i][each.place]);
            }
        }
        if (inside) {
            return;
        }
    }
    throw precision_exhausted("the terms of a manifold with nearly equal eigenvalues");
}

complex_jet invariant_manifold::rate_of(const std::vector<int>& exponents) const {
    complex_jet rate;
    for (std::size_t j = 0; j < exponents.size(); ++j) {
        rate.add_product(complex_ball(ball(exponents[j]), ball(0)), rates_[j]);
    }
    return rate;
}

// The terms of the unknowns of p, and of h for the others, for right-hand sides.
void invariant_manifold::solve_terms(const std::vector<block>& right, const std::vector<jet_matrix>& by, int m) {
    const std::size_t n = centre_.size();
    const std::size_t k = rates_.size();
    auto inverse_of_others = by.begin();
    for (const auto& each : monomials_->of_degree(m)) {
        std::vector<complex_jet> others;
        for (std::size_t i = k; i < n; ++i) {
            others.push_back(right[i][each.place]);
        }
        others = product(*inverse_of_others++, others);
        for (std::size_t i = k; i < n; ++i) {
            p_[i].back()[each.place] = others[i - k];
        }
        for (std::size_t i = 0; i < k; ++i) {
            complex_jet sum = right[i][each.place];
            for (std::size_t j = k; j < n; ++j) {
                sum.add_product(b_[i][j], p_[j].back()[each.place]);
            }
            if (is_resonant(each.exponents, i)) {
                normal_[i].back()[each.place] = sum;
            } else {
                p_[i].back()[each.place] = sum * reciprocal(rate_of(each.exponents) - rates_[i]);
            }
        }
    }
}

// rest + R_ss p_s - Dp R_ss theta for terms p of a degree.
std::vector<invariant_manifold::block> invariant_manifold::coupled(const std::vector<block>& rest,
                                                                   const std::vector<block>& p, int m) const {
    const std::size_t k = rates_.size();
    auto result = rest;
    for (std::size_t j = 0; j < k; ++j) {
        for (std::size_t l = 0; l < k; ++l) {
            const complex_jet& by = b_[j][l];
            if (j == l || by.is_zero()) {
                continue;
            }
            for (const auto& each : monomials_->of_degree(m)) {
                result[j][each.place].add_product(by, p[l][each.place]);
                if (each.exponents[j] == 0) {
                    continue;
                }
                const complex_jet slope = by * complex_jet(complex_ball(ball(-each.exponents[j]), ball(0)));
                const std::size_t place = each.place + monomials_->step_of(l) - monomials_->step_of(j);
                for (std::size_t i = 0; i < p.size(); ++i) {
                    result[i][place].add_product(slope, p[i][each.place]);
                }
            }
        }
    }
    return result;
}

}  // namespace libration::ode
