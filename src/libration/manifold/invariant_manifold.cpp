#include "invariant_manifold.hpp"

#include <algorithm>
#include <cmath>

#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

magnitude size_of(const complex_jet& x) { return size_of_complex(x.value); }

}  // namespace

invariant_manifold::invariant_manifold(const field_at_rest& field, const linear_frame& frame, const frame_plan& plan,
                                       int degree)
    : degree_(degree), q_(frame.columns), plan_(plan) {
    for (std::size_t j = 0; j < frame.inner.size(); ++j) {
        rates_.push_back(frame.inner[j][j]);
    }
    const auto inverse_of_frame = inverse(q_);
    if (!inverse_of_frame) {
        throw precision_exhausted("an inverse of eigenvectors");
    }
    inverse_ = *inverse_of_frame;
    linear_ = linear_steps(field, q_);
    for (const std::size_t i : field.moving) {
        outputs_.push_back(static_cast<std::size_t>(field.of->outputs()[i]));
        centre_.push_back(field.centre[i]);
    }
    compute(field, frame.inner);
}

void invariant_manifold::compute(const field_at_rest& field, const jet_matrix& inner) {
    const std::size_t n = centre_.size();
    const std::size_t k = rates_.size();
    jet_matrix slopes;
    for (const std::size_t step : outputs_) {
        top_ = std::max(top_, linear_[step].degree * degree_);
        auto row = linear_[step].linear;
        row.resize(n);
        if (field.direction < 0) {
            std::ranges::transform(row, row.begin(), [](const complex_jet& x) { return -x; });
        }
        slopes.push_back(std::move(row));
    }
    top_ = std::max(top_, degree_ + 1);
    monomials_ = std::make_shared<graded_monomials>(k, degree_);
    b_ = product(inverse_, slopes);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < k; ++j) {
            b_[i][j] = i < k ? inner[i][j] : complex_jet();  // the columns span an invariant subspace
            is_coupled_ = is_coupled_ || (i != j && !b_[i][j].is_zero());
        }
    }
    p_.resize(n);
    normal_.resize(k);
    rest_.resize(linear_.size());
    deviation_.resize(linear_.size());
    defect_.resize(n);
    for (int m = 0; m <= 1; ++m) {
        for (std::size_t i = 0; i < n; ++i) {
            p_[i].emplace_back(monomials_->places(m));
            if (m == 1 && i < k) {
                p_[i].back()[monomials_->step_of(i)] = complex_ball(ball(1), ball(0));
            }
        }
        for (std::size_t i = 0; i < k; ++i) {
            normal_[i].emplace_back(monomials_->places(m));
            for (std::size_t j = 0; m == 1 && j < k; ++j) {
                normal_[i].back()[monomials_->step_of(j)] = i == j ? complex_jet() : b_[i][j];
            }
        }
        add_degree(field, m);
    }
    for (int m = 2; m <= degree_; ++m) {
        add_degree(field, m);
    }
    bound_defect();
}

// The terms of degree m of every step.
void invariant_manifold::add_degree(const field_at_rest& field, int m) {
    for (std::size_t step = 0; step < linear_.size(); ++step) {
        rest_[step].push_back(nonlinear_part(step, m));
        deviation_[step].push_back(rest_[step].back());
    }
    if (m > 1) {
        solve_degree(field, m);
    }
    if (m == 0) {
        return;
    }
    for (std::size_t step = 0; step < linear_.size(); ++step) {
        for (std::size_t j = 0; j < linear_[step].linear.size(); ++j) {
            for (const auto& each : monomials_->of_degree(m)) {
                deviation_[step].back()[each.place].add_product(linear_[step].linear[j],
                                                                p_[j][static_cast<std::size_t>(m)][each.place]);
            }
        }
    }
}

invariant_manifold::block invariant_manifold::nonlinear_part(std::size_t step, int m) {
    block result(monomials_->places(m));
    const linear_step& what = linear_[step];
    if (m < 2 || what.degree < 2) {
        return result;
    }
    const auto add = [&](std::size_t of, const complex_jet& by) {
        const block& from = rest_[of][static_cast<std::size_t>(m)];
        for (const auto& each : monomials_->of_degree(m)) {
            result[each.place].add_product(by, from[each.place]);
        }
    };
    switch (what.kind) {
        case polynomial_operation::leaf: break;
        case polynomial_operation::sum:
            add(what.left, complex_ball(ball(1), ball(0)));
            add(what.right, what.factor);
            break;
        case polynomial_operation::multiple: add(what.left, what.factor); break;
        case polynomial_operation::product:
            add(what.left, linear_[what.right].centre);
            add(what.right, linear_[what.left].centre);
            add_convolution(result, deviation_[what.left], deviation_[what.right], m);
            break;
    }
    return result;
}

void invariant_manifold::add_convolution(block& sum, const series& a, const series& b, int m) const {
    for (int i = 1; i < m; ++i) {
        const block& left = a[static_cast<std::size_t>(i)];
        const block& right = b[static_cast<std::size_t>(m - i)];
        for (const auto& x : monomials_->of_degree(i)) {
            if (left[x.place].is_zero()) {
                continue;
            }
            for (const auto& y : monomials_->of_degree(m - i)) {
                sum[x.place + y.place].add_product(left[x.place], right[y.place]);
            }
        }
    }
}

// Q^-1 of the terms of order >= 2 of the field, minus those of Dp h~ of other degrees.
std::vector<invariant_manifold::block> invariant_manifold::residual(const field_at_rest& field, int m) {
    std::vector<block> result(centre_.size(), block(monomials_->places(m)));
    for (std::size_t j = 0; j < outputs_.size(); ++j) {
        const block& slope = rest_[outputs_[j]].back();
        for (const auto& each : monomials_->of_degree(m)) {
            const complex_jet term = field.direction < 0 ? -slope[each.place] : slope[each.place];
            for (std::size_t i = 0; i < result.size() && !term.is_zero(); ++i) {
                result[i][each.place].add_product(inverse_[i][j], term);
            }
        }
    }
    subtract_normal_form(result, m);
    return result;
}

void invariant_manifold::subtract_normal_form(std::vector<block>& rest, int m) const {
    for (std::size_t j = 0; j < normal_.size(); ++j) {
        for (std::size_t a = 2; a < normal_[j].size(); ++a) {
            const int of_p = m - static_cast<int>(a) + 1;
            if (of_p < 2 || of_p > degree_) {
                continue;
            }
            for (const auto& x : monomials_->of_degree(static_cast<int>(a))) {
                const complex_jet& h = normal_[j][a][x.place];
                if (h.is_zero()) {
                    continue;
                }
                for (const auto& y : monomials_->of_degree(of_p)) {
                    const int power = y.exponents[j];
                    if (power == 0) {
                        continue;
                    }
                    const complex_jet by = h * complex_jet(complex_ball(ball(-power), ball(0)));
                    const std::size_t place = x.place + y.place - monomials_->step_of(j);
                    for (std::size_t i = 0; i < rest.size(); ++i) {
                        rest[i][place].add_product(by, p_[i][static_cast<std::size_t>(of_p)][y.place]);
                    }
                }
            }
        }
    }
}

bool invariant_manifold::moves_linearly() const {
    const auto vanishes = [](const block& terms) { return std::ranges::all_of(terms, &complex_jet::is_zero); };
    return !is_coupled_ && std::ranges::all_of(normal_, [&](const series& each) {
        return std::all_of(each.begin() + std::min<std::ptrdiff_t>(2, std::ssize(each)), each.end(), vanishes);
    });
}

std::vector<double> invariant_manifold::sizes() const {
    std::vector<double> result(static_cast<std::size_t>(degree_) + 1);
    for (std::size_t m = 1; m < result.size(); ++m) {
        for (std::size_t i = 0; i < p_.size(); ++i) {
            double sum = 0;
            for (const auto& each : monomials_->of_degree(static_cast<int>(m))) {
                sum += size_of(p_[i][m][each.place]).above();
            }
            result[m] = std::max(result[m], sum);
        }
    }
    return result;
}

invariant_manifold::point invariant_manifold::at(const std::vector<complex_ball>& theta) const {
    const std::size_t n = centre_.size();
    const std::size_t k = theta.size();
    std::vector<std::vector<complex_ball>> powers(k, {complex_ball(ball(1), ball(0))});
    for (std::size_t j = 0; j < k; ++j) {
        for (int m = 1; m <= degree_; ++m) {
            powers[j].push_back(powers[j].back() * theta[j]);
        }
    }
    point result{std::vector<complex_jet>(n), jet_matrix(n, std::vector<complex_jet>(k))};
    std::vector<complex_jet> in_w(n);
    jet_matrix by(n, std::vector<complex_jet>(k));
    for (int m = 1; m <= degree_; ++m) {
        for (const auto& each : monomials_->of_degree(m)) {
            complex_ball power(ball(1), ball(0));
            std::vector<complex_ball> slopes(k, complex_ball(ball(1), ball(0)));
            for (std::size_t j = 0; j < k; ++j) {
                const auto exponent = static_cast<std::size_t>(each.exponents[j]);
                power *= powers[j][exponent];
                for (std::size_t l = 0; l < k; ++l) {
                    if (l != j) {
                        slopes[l] *= powers[j][exponent];
                    } else {
                        slopes[l] *= exponent == 0
                                         ? complex_ball(ball(0), ball(0))
                                         : powers[j][exponent - 1] * complex_ball(ball(each.exponents[j]), ball(0));
                    }
                }
            }
            for (std::size_t i = 0; i < n; ++i) {
                const complex_jet& term = p_[i][static_cast<std::size_t>(m)][each.place];
                in_w[i].add_product(term, power);
                for (std::size_t j = 0; j < k; ++j) {
                    by[i][j].add_product(term.value, slopes[j]);
                }
            }
        }
    }
    result.value = product(q_, in_w);
    for (std::size_t i = 0; i < n; ++i) {
        result.value[i] += centre_[i];
        for (std::size_t j = 0; j < k; ++j) {
            for (std::size_t l = 0; l < n; ++l) {
                result.by_theta[i][j].add_product(q_[i][l].value, by[l][j].value);
            }
        }
    }
    return result;
}

}  // namespace libration::ode
