#include <algorithm>
#include <cmath>
#include <limits>

#include "local_field.hpp"

namespace libration::ode {

namespace {

constexpr std::size_t most_exact_monomials = 400;
constexpr std::size_t most_samples = 600;

}  // namespace

// The product of |w/c|^mu i^j over the equations of which its exponents are the combination mu, and of powers of the free S: the factor of c x^l in
// units in which x is t - t*.
std::optional<quadratic_number> local_field::exact_factor(const balance_term& of, const exact_sample& sample) const {
    const auto exponents = balance_.exponents_of(of);
    std::vector<rational> mu(balance_.equations.size());
    for (std::size_t k = 0; k < mu.size(); ++k) {
        for (std::size_t i = 0; i < balance_.pivots.size(); ++i) {
            mu[k] += balance_.inverse[i][k] * exponents[balance_.pivots[i]];
        }
    }
    rational free = 1;
    for (std::size_t l = 0; l < balance_.free.size(); ++l) {
        rational power = exponents[balance_.free[l]];
        for (std::size_t k = 0; k < mu.size(); ++k) {
            power -= mu[k] * balance_.exponents_of(balance_.terms[balance_.equations[k]])[balance_.free[l]];
        }
        if (denominator(power) != 1) {
            return std::nullopt;
        }
        for (int i = 0; i < abs(power); ++i) {
            free = power > 0 ? rational(free * sample.free[l]) : rational(free / sample.free[l]);
        }
    }
    // the square of the product, and the power of i
    rational square = 1;
    rational quarter_turns = 0;
    for (std::size_t k = 0; k < mu.size(); ++k) {
        const balance_term& equation = balance_.terms[balance_.equations[k]];
        const auto factor = equation.of.by_time.size() == 1 ? equation.of.by_time[0].fraction() : std::nullopt;
        const rational twice = mu[k] * 2;
        if (twice == 0) {
            continue;
        }
        if (!factor || denominator(twice) != 1 || abs(twice) > 64) {
            return std::nullopt;
        }
        const rational base = abs(rational(*equation.share / *factor));
        for (int i = 0; i < abs(twice); ++i) {
            square = twice > 0 ? rational(square * base) : rational(square / base);
        }
        // log w - log c + 2 pi i turn, in units of pi i
        const long half_turns = (*equation.share < 0 ? 1 : 0) - (*factor < 0 ? 1 : 0) + 2 * balance_.turns[k];
        quarter_turns += twice * static_cast<int>(half_turns);
    }
    const auto quarter = static_cast<long>(numerator(quarter_turns) % 4);
    const long turn = (quarter + 4) % 4;
    const rational signed_square = turn % 2 == 0 ? square : rational(-square);
    const rational sign = turn >= 2 ? -1 : 1;
    if (const auto root = turn % 2 == 0 ? rational_root(signed_square) : std::nullopt) {
        return quadratic_number(rational(sign * free * *root));
    }
    return quadratic_number(0, rational(sign * free), signed_square);  // the principal root
}

std::optional<balance_field<quadratic_number>> local_field::exact_field(const exact_sample& sample) {
    std::vector<quadratic_number> at_zero;
    for (const balance_role each : balance_.roles) {
        at_zero.emplace_back(rational(each == balance_role::nonzero ? 1 : 0));
    }
    for (std::size_t k = 0; k < balance_.finite.size(); ++k) {
        at_zero[balance_.finite[k]] = quadratic_number(sample.finite[k]);
    }
    balance_field<quadratic_number> result;
    result.rows.resize(size_);
    std::optional<rational> field;
    for (const quadratic_number& each : balance_.eigenvalues) {
        field = each.is_rational() ? field : each.radicand;
    }
    for (const balance_term& each : balance_.terms) {
        const auto count = static_cast<int>(each.of.by_time.size());
        for (int l = 0; l < count; ++l) {
            const bool leading = l == 0 && each.excess == 0;
            auto factor =
                leading && each.share ? std::optional(quadratic_number(*each.share)) : exact_factor(each, sample);
            if (!factor) {
                return std::nullopt;
            }
            if (!leading || !each.share) {
                rational c = 0;
                for (int n = count - 1; n >= l; --n) {
                    const auto by = each.of.by_time[static_cast<std::size_t>(n)].fraction();
                    if (!by) {
                        return std::nullopt;
                    }
                    rational power = *by * static_cast<int>(binomial_of(n, l));
                    for (int i = l; i < n; ++i) {
                        power *= sample.time;
                    }
                    c += power;
                }
                factor = *factor * quadratic_number(c);
            }
            if (!factor->is_rational()) {
                field = field ? field : factor->radicand;
                const auto part = rational_root(factor->radicand / *field);
                if (!part) {
                    return std::nullopt;
                }
                factor = quadratic_number(factor->p, rational(factor->q * *part), *field);
            }
            if (!factor->is_zero()) {
                expand<quadratic_number>(each, *factor, whole_power(rational(each.excess + l)), at_zero,
                                         leading ? 2 : 0, result.rows[each.row]);
            }
        }
    }
    result.products = products_;
    return result;
}

// The resonant terms are Laurent polynomials in t*, the finite limits and the free S. They are 0 if they are so at one more points of a grid than the
// number of powers. Their weight is the sum of those of variables and of terms beyond the leading ones, each at least the least weight of a
// variable: at most w of them. A leading term without a share has two factors or more, so that there are fewer than w of these.
std::optional<std::vector<local_field::exact_sample>> local_field::exact_grid(double largest, double least) const {
    const int factors = 2 * static_cast<int>(largest / least + 1e-9);
    int of_time = 0;
    std::vector<int> of_finite(balance_.finite.size()), of_free(balance_.free.size());
    for (const balance_term& each : balance_.terms) {
        of_time = std::max(of_time, static_cast<int>(each.of.by_time.size()) - 1);
        for (std::size_t k = 0; k < of_finite.size(); ++k) {
            of_finite[k] = std::max(of_finite[k], each.of.powers[balance_.finite[k]]);
        }
        const auto exponents = balance_.exponents_of(each);
        for (std::size_t l = 0; l < of_free.size(); ++l) {
            rational power = exponents[balance_.free[l]];
            for (std::size_t k = 0; k < balance_.equations.size(); ++k) {
                rational mu = 0;
                for (std::size_t i = 0; i < balance_.pivots.size(); ++i) {
                    mu += balance_.inverse[i][k] * exponents[balance_.pivots[i]];
                }
                power -= mu * balance_.exponents_of(balance_.terms[balance_.equations[k]])[balance_.free[l]];
            }
            of_free[l] = std::max(of_free[l], 2 * static_cast<int>(std::ceil(std::abs(static_cast<double>(power)))));
        }
    }
    std::vector<exact_sample> grid{{rational(2, 3), std::vector<rational>(of_finite.size(), rational(1)),
                                    std::vector<rational>(of_free.size(), rational(1))}};
    const auto extend = [&](int degree, const auto& part) {
        const std::size_t count = grid.size();
        for (int k = 1; k <= degree * factors; ++k) {
            for (std::size_t i = 0; i < count && grid.size() <= most_samples; ++i) {
                grid.push_back(grid[i]);
                part(grid.back()) += k;
            }
        }
    };
    extend(of_time, [](exact_sample& of) -> rational& { return of.time; });
    for (std::size_t k = 0; k < of_finite.size(); ++k) {
        extend(of_finite[k], [&](exact_sample& of) -> rational& { return of.finite[k]; });
    }
    for (std::size_t k = 0; k < of_free.size(); ++k) {
        extend(of_free[k], [&](exact_sample& of) -> rational& { return of.free[k]; });
    }
    return grid.size() <= most_samples ? std::optional(grid) : std::nullopt;
}

void local_field::find_exact_resonances(const weighted_monomials& monomials) {
    std::vector<quadratic_number> weights;
    double largest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t v = 0; v < monomials.variables(); ++v) {
        weights.push_back(monomials.weight_of(v));
        largest = std::max(largest, weights.back().real_part());
        least = std::min(least, weights.back().real_part());
    }
    const weighted_monomials up_to_last(weights, largest, most_exact_monomials);
    const auto grid = exact_grid(largest, least);
    if (!grid || up_to_last.least_beyond() < largest * (1 - 1e-6)) {
        return;
    }
    std::vector<std::pair<std::size_t, std::vector<int>>> found;
    for (const exact_sample& each : *grid) {
        const auto field = exact_field(each);
        if (!field) {
            return;
        }
        for (const auto& term : series_of(balance_, *field, up_to_last).resonant) {
            found.emplace_back(term.variable, up_to_last[term.monomial]);
        }
    }
    exact_resonances_ = std::move(found);
}

void local_field::drop_exact_zeros(balance_series<complex_ball>& series, const weighted_monomials& monomials) {
    if (!tried_ && !series.resonant.empty()) {
        tried_ = true;
        find_exact_resonances(monomials);
    }
    if (exact_resonances_) {
        std::erase_if(series.resonant, [&](const resonant_term<complex_ball>& each) {
            return std::ranges::none_of(*exact_resonances_, [&](const auto& known) {
                return known.first == each.variable && known.second == monomials[each.monomial];
            });
        });
    }
}

}  // namespace libration::ode
