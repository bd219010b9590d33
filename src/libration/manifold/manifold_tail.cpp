#include <algorithm>

#include "invariant_manifold.hpp"
#include "libration/algebra/ball_matrix.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

constexpr int most_tails = 80;

magnitude size_of_value(const complex_jet& x) { return size_of_complex(x.value); }

}  // namespace

magnitude invariant_manifold::norm_of_degree(const series& of, int m) const {
    magnitude sum;
    for (const auto& each : monomials_->of_degree(m)) {
        sum += size_of_value(of[static_cast<std::size_t>(m)][each.place]);
    }
    return sum;
}

// The norms of all steps by degree: of the polynomials up to degree N, and beyond by those of the factors. There, Q^-1
// (rest) - Dp h~ is the defect.
void invariant_manifold::bound_defect() {
    const auto top = static_cast<std::size_t>(top_);
    const auto last = static_cast<std::size_t>(degree_);
    for (std::size_t step = 0; step < linear_.size(); ++step) {
        auto& norms = norms_.emplace_back(top + 1);
        for (std::size_t m = 1; m <= last; ++m) {
            norms[m] = norm_of_degree(deviation_[step], static_cast<int>(m));
        }
        const linear_step& what = linear_[step];
        const std::size_t left = what.left;
        const std::size_t right = what.right;
        for (std::size_t m = last + 1; m <= top; ++m) {
            switch (what.kind) {
                case polynomial_operation::leaf: break;
                case polynomial_operation::sum:
                    norms[m] = norms_[left][m] + size_of_value(what.factor) * norms_[right][m];
                    break;
                case polynomial_operation::multiple: norms[m] = size_of_value(what.factor) * norms_[left][m]; break;
                case polynomial_operation::product:
                    norms[m] = size_of_value(linear_[left].centre) * norms_[right][m];
                    norms[m] += size_of_value(linear_[right].centre) * norms_[left][m];
                    for (std::size_t i = 1; i < m; ++i) {
                        norms[m].add_product(norms_[left][i], norms_[right][m - i]);
                    }
                    break;
            }
        }
        magnitude& whole = whole_norms_.emplace_back();
        for (const magnitude& each : norms) {
            whole += each;
        }
    }
    for (std::size_t m = last + 1; m <= top; ++m) {
        for (std::size_t i = 0; i < defect_.size(); ++i) {
            for (std::size_t j = 0; j < outputs_.size(); ++j) {
                defect_[i].add_product(size_of_value(inverse_[i][j]), norms_[outputs_[j]][m]);
            }
        }
    }
    for (std::size_t a = 2; a <= last; ++a) {
        magnitude most;
        for (const series& each : normal_) {
            most = std::max(most, norm_of_degree(each, static_cast<int>(a)));
        }
        for (std::size_t of_p = std::max<std::size_t>(2, last + 2 - a); of_p <= last && !most.is_zero(); ++of_p) {
            for (std::size_t i = 0; i < defect_.size(); ++i) {
                defect_[i] += norm_of_degree(p_[i], static_cast<int>(of_p)) * most * magnitude(of_p);
            }
        }
    }
}

// Bounds of ||Q^-1 (nonlinear terms of f(p + e) - f(p))|| for ||e|| <= s, in w.
std::vector<magnitude> invariant_manifold::image(const std::vector<magnitude>& s) const {
    std::vector<magnitude> whole;   // of the change of each step
    std::vector<magnitude> beyond;  // of its terms of order >= 2
    for (std::size_t step = 0; step < linear_.size(); ++step) {
        const linear_step& what = linear_[step];
        const std::size_t left = what.left;
        const std::size_t right = what.right;
        magnitude sum;
        switch (what.kind) {
            case polynomial_operation::leaf: break;
            case polynomial_operation::sum: sum = beyond[left] + size_of_value(what.factor) * beyond[right]; break;
            case polynomial_operation::multiple: sum = size_of_value(what.factor) * beyond[left]; break;
            case polynomial_operation::product:
                sum = size_of_value(linear_[left].centre) * beyond[right] +
                      size_of_value(linear_[right].centre) * beyond[left];
                sum += whole_norms_[left] * whole[right] + whole_norms_[right] * whole[left];
                sum.add_product(whole[left], whole[right]);
                break;
        }
        beyond.push_back(sum);
        for (std::size_t j = 0; j < linear_[step].linear.size(); ++j) {
            sum.add_product(size_of_value(linear_[step].linear[j]), s[j]);
        }
        whole.push_back(std::move(sum));
    }
    std::vector<magnitude> result(s.size());
    for (std::size_t i = 0; i < s.size(); ++i) {
        for (std::size_t j = 0; j < s.size(); ++j) {
            result[i].add_product(size_of_value(inverse_[i][j]), beyond[outputs_[j]]);
        }
    }
    return result;
}

std::optional<std::vector<magnitude>> invariant_manifold::tails() const {
    const std::size_t n = centre_.size();
    const std::size_t k = rates_.size();
    // Lower bounds of alpha and a_i.
    std::optional<ball> alpha;
    for (const complex_jet& each : rates_) {
        const ball decay = lower_bound(-each.value.re);
        if (arb_is_positive(decay.handle()) == 0) {
            return std::nullopt;
        }
        alpha = !alpha || arb_lt(decay.handle(), alpha->handle()) != 0 ? decay : *alpha;
    }
    magnitude eta;
    for (const series& each : normal_) {
        magnitude sum;
        for (int m = 1; m <= degree_; ++m) {
            sum += norm_of_degree(each, m);
        }
        eta = std::max(eta, sum);
    }
    if (!alpha || !(eta < magnitude::below(*alpha))) {
        return std::nullopt;
    }
    std::vector<complex_ball> d;
    std::vector<magnitude> a;
    std::vector<magnitude> c;
    for (std::size_t i = 0; i < n; ++i) {
        const complex_ball& entry = b_[i][i].value;
        d.push_back(i < k ? entry : complex_ball(exact_midpoint(entry.re), exact_midpoint(entry.im)));
        const ball gap = lower_bound(*alpha * (degree_ + 1) + d.back().re);
        if (arb_is_positive(gap.handle()) == 0) {
            return std::nullopt;
        }
        a.push_back(magnitude::below(gap));
        c.push_back(std::max(magnitude(1U) / magnitude::below(*alpha),
                             magnitude(static_cast<unsigned>(degree_) + 1) / a.back()));
    }
    std::vector<magnitude> s;
    for (std::size_t i = 0; i < n; ++i) {
        s.push_back((defect_[i] / a[i]).shifted(1) + magnitude::of(1, -4 * ball::working_bits()));
    }
    for (int round = 0; round < most_tails; ++round) {
        const auto more = image(s);
        bool inside = true;
        std::vector<magnitude> next;
        for (std::size_t i = 0; i < n; ++i) {
            magnitude sum = defect_[i] + more[i];
            for (std::size_t j = 0; j < n; ++j) {
                if (i != j || i >= k) {
                    sum.add_product(size_of_complex(i == j ? b_[i][j].value - d[i] : b_[i][j].value), s[j]);
                }
            }
            const magnitude now = sum / a[i] + c[i] * eta * s[i];
            inside = inside && now < s[i];
            next.push_back(now + now / 50U);
        }
        if (inside) {
            std::vector<magnitude> bounds(n);
            for (std::size_t i = 0; i < n; ++i) {
                for (std::size_t j = 0; j < n; ++j) {
                    bounds[i].add_product(size_of_value(q_[i][j]), s[j]);
                }
            }
            return bounds;
        }
        for (std::size_t i = 0; i < n; ++i) {
            s[i] = std::max(s[i], next[i]);
        }
    }
    return std::nullopt;
}

}  // namespace libration::ode
