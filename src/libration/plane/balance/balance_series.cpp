#include "balance_series.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace libration::ode {

namespace {

constexpr double tolerance_of_weight = 1e-6;
constexpr int most_tail_rounds = 120;
constexpr std::size_t most_variables = 8;
constexpr std::size_t bits_of_key = 64;
constexpr std::size_t most_bits_of_exponent = 16;

magnitude modulus_above(const complex_ball& z) { return hypotenuse(magnitude(z.re), magnitude(z.im)); }

}  // namespace

weighted_monomials::weighted_monomials(std::vector<quadratic_number> weights, double highest, std::size_t most)
    : weights_(std::move(weights)), highest_(highest) {
    if (weights_.size() > most_variables) {
        throw error(error_kind::undecided, error_subject::problem, "",
                    "has a singularity with more than " + std::to_string(most_variables) + " resonances");
    }
    // Exponents below 2^bits_of_exponent have keys: the weight of the first one that has none is beyond.
    bits_of_exponent_ =
        std::min<std::size_t>(most_bits_of_exponent, bits_of_key / std::max<std::size_t>(1, weights_.size()));
    for (const quadratic_number& each : weights_) {
        highest_ = std::min(highest_, static_cast<double>((1UL << bits_of_exponent_) - 1) * each.real_part());
    }
    for (;; highest_ *= 0.9) {
        make(highest_, most);
        if (all_.size() <= most) {
            break;
        }
    }
    for (std::size_t m = 0; m < all_.size(); ++m) {
        places_.emplace(key_of(all_[m]), m);
    }
    factors_.resize(all_.size());
    for (std::size_t m = 0; m < all_.size(); ++m) {
        std::vector<int> part(weights_.size());
        for (;;) {
            std::size_t j = 0;
            while (j < part.size() && part[j] == all_[m][j]) {
                part[j++] = 0;
            }
            if (j == part.size()) {
                break;
            }
            ++part[j];
            if (part != all_[m]) {
                std::vector<int> rest = all_[m];
                for (std::size_t i = 0; i < rest.size(); ++i) {
                    rest[i] -= part[i];
                }
                factors_[m].emplace_back(places_.at(key_of(part)), places_.at(key_of(rest)));
            }
        }
    }
}

void weighted_monomials::make(double highest, std::size_t most) {
    all_.clear();
    std::vector<int> exponents(weights_.size());
    extend(exponents, 0, highest + 2 * tolerance_of_weight, 2 * most);
    // By the exact sums: all monomials of one weight or none of them.
    std::erase_if(all_, [&](const std::vector<int>& each) {
        return weight_sum(each).real_part() > highest + tolerance_of_weight;
    });
    std::ranges::sort(all_, [](const auto& a, const auto& b) {
        const int p = std::accumulate(a.begin(), a.end(), 0);
        const int q = std::accumulate(b.begin(), b.end(), 0);
        return p != q ? p < q : a < b;
    });
    sums_.clear();
    sizes_.clear();
    for (const auto& each : all_) {
        sums_.push_back(weight_sum(each));
        sizes_.push_back(sums_.back().real_part());
    }
}

quadratic_number weighted_monomials::weight_sum(const std::vector<int>& exponents) const {
    quadratic_number sum;
    for (std::size_t j = 0; j < exponents.size(); ++j) {
        sum = sum + quadratic_number(rational(exponents[j])) * weights_[j];
    }
    return sum;
}

void weighted_monomials::extend(std::vector<int>& exponents, std::size_t j, double left, std::size_t most) {
    if (all_.size() > most) {
        return;
    }
    if (j == weights_.size()) {
        all_.push_back(exponents);
        return;
    }
    const double weight = weights_[j].real_part();
    for (int m = 0; m * weight <= left && m < (1 << bits_of_exponent_); ++m) {
        exponents[j] = m;
        extend(exponents, j + 1, left - m * weight, most);
    }
    exponents[j] = 0;
}

unsigned long weighted_monomials::key_of(const std::vector<int>& exponents) const {
    unsigned long key = 0;
    for (const int each : exponents) {
        key = (key << bits_of_exponent_) + static_cast<unsigned long>(each);
    }
    return key;
}

std::optional<std::size_t> weighted_monomials::place_of(const std::vector<int>& exponents) const {
    const auto at = places_.find(key_of(exponents));
    return at == places_.end() ? std::nullopt : std::optional(at->second);
}

namespace {

class tail_search {
public:
    tail_search(const dominant_balance& balance, const balance_field<complex_ball>& field,
                const weighted_monomials& monomials, const balance_series<complex_ball>& series,
                const std::vector<magnitude>& radii)
        : balance_(balance), field_(field), monomials_(monomials), series_(series), radii_(radii) {
        for (std::size_t m = 0; m < monomials.count(); ++m) {
            magnitude product(1U);
            for (std::size_t v = 0; v < radii.size(); ++v) {
                product *= pow(radii[v], static_cast<unsigned long>(monomials[m][v]));
            }
            powers_.push_back(std::move(product));
            order_.push_back(m);
        }
        std::ranges::sort(order_,
                          [&](std::size_t a, std::size_t b) { return monomials_.size(a) < monomials_.size(b); });
        for (const std::size_t m : order_) {
            sorted_.push_back(monomials_.size(m));
        }
        for (const auto& row : balance.columns) {
            add_sizes(q_, row);
        }
        for (const auto& row : balance.inverse_columns) {
            add_sizes(inverse_, row);
        }
        measure();
    }

    std::optional<series_tail> found() const {
        const std::size_t n = q_.size();
        const double least = monomials_.least_beyond();
        const auto eta = largest_resonance();
        std::vector<magnitude> s, c, gaps;
        const std::vector<magnitude> start = in_components(defects_);
        for (std::size_t i = 0; i < n; ++i) {
            const double gap = (least - balance_.eigenvalues[i].real_part()) * (1 - 1e-9);
            if (gap <= 0) {
                return std::nullopt;
            }
            gaps.push_back(magnitude::at_least(1 / gap * (1 + 1e-9), 0));
            c.push_back(eta * magnitude::at_least(std::max(1.0, least / gap) * (1 + 1e-9), 0));
            s.push_back(start[i] * gaps[i] * magnitude::of(9, -3) + magnitude::of(1, -20'000));
        }
        for (int round = 0; round < most_tail_rounds; ++round) {
            const std::vector<magnitude> by = in_components(increments(s));
            bool inside = true;
            std::vector<magnitude> next;
            for (std::size_t i = 0; i < n; ++i) {
                const magnitude now = (start[i] + by[i]) * gaps[i] + c[i] * s[i];
                inside = inside && now <= s[i];
                next.push_back(now * magnitude::of(33, -5));
                if (!next.back().is_finite() || magnitude(1'000'000U) < next.back()) {
                    return std::nullopt;
                }
            }
            if (inside) {
                series_tail result;
                for (std::size_t i = 0; i < n; ++i) {
                    magnitude sum;
                    for (std::size_t j = 0; j < n; ++j) {
                        sum.add_product(q_[i][j], s[j]);
                    }
                    result.beyond.push_back(std::move(sum));
                    result.norms.push_back(norms_[i]);
                }
                return result;
            }
            for (std::size_t i = 0; i < n; ++i) {
                s[i] = s[i] < next[i] ? next[i] : s[i];
            }
        }
        return std::nullopt;
    }

private:
    static void add_sizes(std::vector<std::vector<magnitude>>& to, const std::vector<quadratic_number>& row) {
        auto& sizes = to.emplace_back();
        for (const quadratic_number& each : row) {
            sizes.push_back(modulus_above(each.value()));
        }
    }

    // The sum of the sizes of the terms of a node with a weight above a bound, within the tolerance of the monomials.
    magnitude beyond(std::size_t node, double bound) const {
        const auto at = std::ranges::lower_bound(sorted_, bound + tolerance_of_weight / 2) - sorted_.begin();
        return tails_[node][static_cast<std::size_t>(at)];
    }

    // The polynomials of the nodes up to the highest weight, then the terms of their products beyond it.
    void measure() {
        const double highest = monomials_.least_beyond();
        const std::size_t n = q_.size();
        for (std::size_t k = 0; k < series_.nodes.size(); ++k) {
            std::vector<magnitude>& tail = tails_.emplace_back(order_.size() + 1);
            for (std::size_t at = order_.size(); at-- > 0;) {
                const std::size_t m = order_[at];
                tail[at] = tail[at + 1] + modulus_above(series_.nodes[k][m]) * powers_[m];
            }
            magnitude above;
            if (k >= n) {
                const auto& [left, right] = field_.products[k - n];
                for (std::size_t m = 1; m < monomials_.count(); ++m) {
                    if (!is_zero_term(series_.nodes[left - 1][m])) {
                        above += modulus_above(series_.nodes[left - 1][m]) * powers_[m] *
                                 beyond(right - 1, highest - monomials_.size(m));
                    }
                }
                above += norms_[left - 1] * above_[right - 1];
            }
            norms_.push_back(tail[0] + above);
            above_.push_back(std::move(above));
        }
        for (const auto& row : field_.rows) {
            magnitude sum;
            for (const auto& each : row) {
                if (each.node != 0) {
                    const magnitude power =
                        each.power > 0 ? pow(radii_[0], static_cast<unsigned long>(each.power)) : magnitude(1U);
                    const double by = each.power > 0 ? each.power * monomials_.weight_of(0).real_part() : 0;
                    sum += modulus_above(each.factor) * power *
                           (beyond(each.node - 1, highest - by) + above_[each.node - 1]);
                } else if (each.power * monomials_.weight_of(0).real_part() > highest + tolerance_of_weight / 2) {
                    sum += modulus_above(each.factor) * pow(radii_[0], static_cast<unsigned long>(each.power));
                }
            }
            defects_.push_back(std::move(sum));
        }
    }

    magnitude largest_resonance() const {
        std::vector<magnitude> eta(radii_.size());
        for (const auto& each : series_.resonant) {
            eta[each.variable] += modulus_above(each.factor) * powers_[each.monomial] / radii_[each.variable];
        }
        magnitude largest;
        for (std::size_t v = 0; v < eta.size(); ++v) {
            const double part = 1 / monomials_.weight_of(v).real_part() * (1 + 1e-9);
            largest = std::max(largest, magnitude(eta[v] * magnitude::at_least(part, 0)));
        }
        return largest;
    }

    std::vector<magnitude> in_components(const std::vector<magnitude>& of_unknowns) const {
        std::vector<magnitude> result;
        for (const auto& row : inverse_) {
            magnitude sum;
            for (std::size_t j = 0; j < row.size(); ++j) {
                sum.add_product(row[j], of_unknowns[j]);
            }
            result.push_back(std::move(sum));
        }
        return result;
    }

    std::vector<magnitude> increments(const std::vector<magnitude>& s) const {
        const std::size_t n = q_.size();
        std::vector<magnitude> change;
        for (std::size_t i = 0; i < n; ++i) {
            magnitude sum;
            for (std::size_t j = 0; j < n; ++j) {
                sum.add_product(q_[i][j], s[j]);
            }
            change.push_back(std::move(sum));
        }
        for (const auto& [left, right] : field_.products) {
            const magnitude& a = change[left - 1];
            const magnitude& b = change[right - 1];
            change.push_back(norms_[left - 1] * b + a * norms_[right - 1] + a * b);
        }
        std::vector<magnitude> result;
        for (const auto& row : field_.rows) {
            magnitude sum;
            for (const auto& each : row) {
                if (each.node != 0) {
                    const magnitude power =
                        each.power > 0 ? pow(radii_[0], static_cast<unsigned long>(each.power)) : magnitude(1U);
                    sum += modulus_above(each.factor) * power * change[each.node - 1];
                }
            }
            result.push_back(std::move(sum));
        }
        return result;
    }

    const dominant_balance& balance_;
    const balance_field<complex_ball>& field_;
    const weighted_monomials& monomials_;
    const balance_series<complex_ball>& series_;
    const std::vector<magnitude>& radii_;
    std::vector<magnitude> powers_;  // of the radii, by monomial
    std::vector<std::size_t> order_;
    std::vector<double> sorted_;
    std::vector<std::vector<magnitude>> q_, inverse_, tails_;
    std::vector<magnitude> norms_, above_;  // of the nodes: all terms, and those beyond the highest weight
    std::vector<magnitude> defects_;
};

}  // namespace

std::optional<series_tail> tail_of(const dominant_balance& balance, const balance_field<complex_ball>& field,
                                   const weighted_monomials& monomials, const balance_series<complex_ball>& series,
                                   const std::vector<magnitude>& radii) {
    return tail_search(balance, field, monomials, series, radii).found();
}

}  // namespace libration::ode
