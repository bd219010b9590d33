#include "local_solution.hpp"

#include <algorithm>

#include "libration/algebra/ball_matrix.hpp"
#include "libration/plane/series_disc.hpp"

namespace libration::ode {

namespace {

magnitude size_of_entry(const complex_ball& z) { return hypotenuse(magnitude(z.re), magnitude(z.im)); }

}  // namespace

complex_ball middle_of(const complex_ball& z) { return {exact_midpoint(z.re), exact_midpoint(z.im)}; }

complex_matrix inverse_near(complex_matrix a) {
    const std::size_t n = a.size();
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            a[i][j] = middle_of(a[i][j]);
            a[i].push_back(complex_ball(i == j ? 1 : 0));
        }
    }
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < n; ++i) {
            pivot = size_of_entry(a[pivot][k]) < size_of_entry(a[i][k]) ? i : pivot;
        }
        std::swap(a[k], a[pivot]);
        const complex_ball p = a[k][k];
        if (may_be_zero(p)) {
            throw precision_exhausted("the coefficients at a singularity");
        }
        for (complex_ball& each : a[k]) {
            each = middle_of(each / p);
        }
        for (std::size_t i = 0; i < n; ++i) {
            const complex_ball factor = a[i][k];
            for (std::size_t j = 0; i != k && j < 2 * n; ++j) {
                a[i][j] = middle_of(a[i][j] - factor * a[k][j]);
            }
        }
    }
    complex_matrix result;
    for (const complex_row& row : a) {
        result.emplace_back(row.begin() + static_cast<std::ptrdiff_t>(n), row.end());
    }
    return result;
}

complex_row product(const complex_matrix& a, const complex_row& b) {
    complex_row result;
    for (const complex_row& row : a) {
        complex_ball sum(0);
        for (std::size_t j = 0; j < b.size(); ++j) {
            sum = sum + row[j] * b[j];
        }
        result.push_back(sum);
    }
    return result;
}

complex_row product_of_polynomials(const complex_row& a, const complex_row& b) {
    complex_row result(a.size() + b.size() - 1, complex_ball(0));
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) {
            result[i + j] = result[i + j] + a[i] * b[j];
        }
    }
    return result;
}

std::vector<quadratic_number> local_solution::weights() const {
    std::vector<quadratic_number> result;
    if (has_step()) {
        result.emplace_back(balance_.step);
    }
    for (const std::size_t each : balance_.growing) {
        result.push_back(balance_.eigenvalues[each]);
    }
    return result;
}
local_model local_solution::model_at(const complex_row& x, const weighted_monomials& monomials) {
    local_model result{x, {}, {}, {}};
    const complex_row finite(x.begin() + 1, x.begin() + 1 + static_cast<std::ptrdiff_t>(balance_.finite.size()));
    const complex_row free(x.begin() + 1 + static_cast<std::ptrdiff_t>(balance_.finite.size()),
                           x.begin() + static_cast<std::ptrdiff_t>(first_growing()));
    result.field = field_.at(origin_, x[0], finite, free, result.scales);
    if (known_series_ && !field_.depends_on_parameters() && known_count_ == monomials.count() &&
        known_bits_ == ball::working_bits()) {
        result.series = *known_series_;
    } else {
        result.series = series_of(balance_, result.field, monomials);
        field_.drop_exact_zeros(result.series, monomials);
        known_series_ = result.series;
        known_count_ = monomials.count();
        known_bits_ = ball::working_bits();
    }
    return result;
}

std::vector<complex_row> local_solution::variables_of(const local_model& model, const complex_row& x,
                                                      const weighted_monomials& monomials) const {
    std::vector<complex_row> result;
    const std::size_t first = has_step() ? 1 : 0;
    if (has_step()) {
        result.push_back({complex_ball(1)});
    }
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < balance_.growing.size(); ++k) {
        result.push_back({x[first_growing() + k]});
        order.push_back(first + k);
    }
    std::ranges::stable_sort(order, {}, [&](std::size_t v) { return monomials.weight_of(v).real_part(); });
    for (const std::size_t v : order) {
        complex_row slope;
        for (const auto& each : model.series.resonant) {
            if (each.variable != v) {
                continue;
            }
            complex_row part{each.factor};
            for (std::size_t u = 0; u < monomials.variables(); ++u) {
                for (int k = 0; k < monomials[each.monomial][u]; ++k) {
                    part = product_of_polynomials(part, result[u]);
                }
            }
            slope.resize(std::max(slope.size(), part.size()), complex_ball(0));
            for (std::size_t k = 0; k < part.size(); ++k) {
                slope[k] = slope[k] + part[k];
            }
        }
        for (std::size_t k = 0; k < slope.size(); ++k) {
            result[v].push_back(slope[k] / ball(static_cast<long>(k) + 1));
        }
    }
    return result;
}

local_solution::base_values local_solution::values_at_base(const local_model& model, const complex_row& x,
                                                           const weighted_monomials& monomials) const {
    base_values result;
    const complex_ball at = complex_ball(1) - exact_point(base_) / x[0];
    flint_complex log_of;
    acb_log(log_of.handle(), flint_complex(at).handle(), ball::working_bits());
    const complex_ball logarithm = log_of.number();
    const auto power = [&](const complex_ball& r) {
        flint_complex value;
        acb_exp(value.handle(), flint_complex(logarithm * r).handle(), ball::working_bits());
        return value.number();
    };
    const std::vector<complex_row> variables = variables_of(model, x, monomials);
    std::vector<complex_row> powers;
    for (std::size_t v = 0; v < monomials.variables(); ++v) {
        complex_ball sum(0);
        for (std::size_t k = variables[v].size(); k-- > 0;) {
            sum = sum * logarithm + variables[v][k];
        }
        result.theta.push_back(sum * power(monomials.weight_of(v).value()));
        powers.push_back({complex_ball(1)});
    }
    complex_row values = field_.limits(finite_of(x));
    for (std::size_t m = 1; m < monomials.count(); ++m) {
        complex_ball product(1);
        for (std::size_t v = 0; v < monomials.variables(); ++v) {
            const auto e = static_cast<std::size_t>(monomials[m][v]);
            while (powers[v].size() <= e) {
                powers[v].push_back(powers[v].back() * result.theta[v]);
            }
            product = e == 0 ? product : product * powers[v][e];
        }
        for (std::size_t i = 0; i < size(); ++i) {
            const complex_ball& c = model.series.nodes[i][m];
            if (!is_zero_term(c)) {
                add_product(values[i], c, product);
            }
        }
    }
    for (std::size_t i = 0; i < size(); ++i) {
        result.front.push_back(power(complex_ball(from_rational<ball>(-balance_.orders[i]))) * model.scales[i]);
        result.unknowns.push_back(result.front[i] * values[i]);
    }
    return result;
}

complex_matrix local_solution::slopes_at(const local_model& model, const complex_row& x,
                                         const std::vector<magnitude>& steps, const weighted_monomials& monomials) {
    const base_values here = values_at_base(model, x, monomials);
    complex_matrix result(size(), complex_row(size()));
    for (std::size_t l = 0; l < size(); ++l) {
        complex_row next = x;
        const ball step = steps[l].exact();
        next[l].re = next[l].re + step;
        const base_values there = l < first_growing() ? values_at_base(model_at(next, monomials), next, monomials)
                                                      : values_at_base(model, next, monomials);
        for (std::size_t i = 0; i < size(); ++i) {
            result[i][l] = (there.unknowns[i] - here.unknowns[i]) / step;
        }
    }
    return result;
}

}  // namespace libration::ode
