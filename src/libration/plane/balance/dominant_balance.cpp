#include "dominant_balance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include "../place_words.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

void refuse_balance(const std::complex<double>& place, const std::string& why) {
    throw error(error_kind::undecided, error_subject::problem, "",
                "has a singularity near " + words_of_place(place) + " " + why);
}

namespace {

constexpr int largest_denominator_of_order = 6;
constexpr double tolerance_of_order = 0.02;
constexpr int largest_denominator_of_share = 12;
constexpr double tolerance_of_share = 2e-3;
constexpr double tolerance_of_logarithm = 0.05;

// The fraction with the least denominator that is close enough.
std::optional<rational> guessed_fraction(double x, int largest, double tolerance) {
    for (int q = 1; q <= largest; ++q) {
        if (std::isfinite(x) && std::abs(x - std::round(x * q) / q) < tolerance) {
            return rational(static_cast<int>(std::round(x * q)), q);
        }
    }
    return std::nullopt;
}

class balance_builder {
public:
    // With `powers` unknowns that vanish have a negative order instead of the limit 0.
    balance_builder(const std::vector<std::vector<field_term>>& rows, const balance_sample& sample, bool powers)
        : rows_(rows), sample_(sample), n_(rows.size()), powers_(powers) {}

    dominant_balance built() {
        result_.place = sample_.place;
        set_orders();
        set_terms();
        set_roles();
        set_shares();
        set_equations();
        set_resonances(result_);
        set_step();
        return std::move(result_);
    }

private:
    [[noreturn]] void refuse(const std::string& why) const { refuse_balance(sample_.place, why); }

    void set_orders() {
        for (std::size_t i = 0; i < n_; ++i) {
            const double m = std::log2(std::abs(sample_.values[i] / sample_.before[i]));
            const bool vanishes = !(m > -tolerance_of_order) && !(powers_ && std::isfinite(m));
            vanishes_.push_back(vanishes);
            const auto order =
                vanishes ? rational(0) : guessed_fraction(m, largest_denominator_of_order, tolerance_of_order);
            if (!order) {
                refuse("at which an unknown does not behave like a power with a small denominator");
            }
            result_.orders.push_back(*order);
        }
    }

    void set_terms() {
        for (std::size_t i = 0; i < n_; ++i) {
            for (const field_term& each : rows_[i]) {
                balance_term term{i, each, result_.orders[i] + 1};
                for (std::size_t j = 0; j < n_; ++j) {
                    term.excess -= result_.orders[j] * each.powers[j];
                }
                if (term.excess < 0) {
                    refuse("at which terms cancel that are larger than the derivatives");
                }
                result_.terms.push_back(std::move(term));
            }
        }
    }

    void set_roles() {
        std::vector<bool> moves(n_), acts(n_);
        for (const balance_term& each : result_.terms) {
            if (each.excess == 0) {
                moves[each.row] = true;
                for (std::size_t j = 0; j < n_; ++j) {
                    acts[j] = acts[j] || each.of.powers[j] > 0;
                }
            }
        }
        for (std::size_t i = 0; i < n_; ++i) {
            const bool free = !moves[i] && !acts[i] && result_.orders[i] == 0;
            if (!moves[i] && !free && (vanishes_[i] || result_.orders[i] != 0)) {
                refuse("at which the leading terms do not determine an unknown");
            }
            result_.roles.push_back(free           ? balance_role::finite
                                    : vanishes_[i] ? balance_role::zero
                                                   : balance_role::nonzero);
            if (free) {
                result_.finite.push_back(i);
            }
        }
    }

    // How many factors of a term are unknowns with the limit 0.
    int vanishing_factors(const balance_term& of) const {
        int count = 0;
        for (std::size_t j = 0; j < n_; ++j) {
            count += result_.roles[j] == balance_role::zero ? of.of.powers[j] : 0;
        }
        return count;
    }

    std::complex<double> observed_logarithm(const balance_term& of) const {
        std::complex<double> sum = 0;
        const auto exponents = result_.exponents_of(of);
        for (std::size_t j = 0; j < n_; ++j) {
            if (exponents[j] != 0) {
                sum += static_cast<double>(exponents[j]) * observed_scale(j);
            }
        }
        return sum;
    }

    // log S
    std::complex<double> observed_scale(std::size_t j) const {
        return std::log(sample_.values[j]) - static_cast<double>(result_.orders[j]) * sample_.level * std::numbers::ln2;
    }

    std::complex<double> factor_of(const balance_term& of) const {
        std::complex<double> sum = 0;
        std::complex<double> power = 1;
        for (const number& each : of.of.by_time) {
            sum += power * arf_get_d(arb_midref(constant_value<ball>::of(each).handle()), ARF_RND_NEAR);
            power *= sample_.place + sample_.origin;
        }
        return sum;
    }

    void set_shares() {
        std::vector<rational> sums(n_);
        for (balance_term& each : result_.terms) {
            const bool of_zero = result_.roles[each.row] == balance_role::zero;
            const int factors = each.excess == 0 ? vanishing_factors(each) : 0;
            if (each.excess != 0 || factors > (of_zero ? 1 : 0)) {
                continue;
            }
            if (of_zero && each.of.powers[each.row] != 1) {
                refuse("at which several unknowns that vanish act on each other");
            }
            const std::complex<double> w = (0.0 - sample_.place) * factor_of(each) * std::exp(observed_logarithm(each));
            each.share = std::abs(w.imag()) < tolerance_of_share
                             ? guessed_fraction(w.real(), largest_denominator_of_share, tolerance_of_share)
                             : std::nullopt;
            if (!each.share || *each.share == 0) {
                refuse("whose leading terms are not in the ratio of small integers");
            }
            sums[each.row] += *each.share;
        }
        for (std::size_t i = 0; i < n_; ++i) {
            if (result_.roles[i] == balance_role::nonzero && sums[i] != -result_.orders[i]) {
                refuse("with a logarithm in the leading term, or whose leading terms are not decided");
            }
        }
        for (const balance_term& each : result_.terms) {
            if (each.excess == 0 && !each.share && result_.roles[each.row] == balance_role::nonzero &&
                vanishing_factors(each) == 1) {
                refuse("at which an unknown that vanishes acts on one that does not");
            }
        }
    }

    // The equations S^e/S_i = -w/(c (t* - t0)), their consistency, and which of them determine the S.
    void set_equations() {
        std::vector<std::size_t> unknowns;
        for (std::size_t i = 0; i < n_; ++i) {
            if (result_.roles[i] == balance_role::nonzero) {
                unknowns.push_back(i);
            }
        }
        std::vector<std::size_t> all;
        surd_matrix e, transposed(unknowns.size());
        for (std::size_t k = 0; k < result_.terms.size(); ++k) {
            if (result_.terms[k].share) {
                all.push_back(k);
                auto& row = e.emplace_back();
                const auto exponents = result_.exponents_of(result_.terms[k]);
                for (std::size_t j = 0; j < unknowns.size(); ++j) {
                    row.emplace_back(rational(exponents[unknowns[j]]));
                    transposed[j].push_back(row.back());
                }
            }
        }
        for (const auto& relation : null_space(transposed, all.size())) {
            check_relation(relation, all);
        }
        // Independent equations are the pivots of the transposed matrix, determined unknowns those of the matrix.
        surd_matrix reduced = e;
        for (const std::size_t each : reduce_rows(reduced, unknowns.size())) {
            result_.pivots.push_back(unknowns[each]);
        }
        for (const std::size_t each : unknowns) {
            if (std::ranges::find(result_.pivots, each) == result_.pivots.end()) {
                result_.free.push_back(each);
            }
        }
        surd_matrix square;
        for (const std::size_t each : reduce_rows(transposed, all.size())) {
            result_.equations.push_back(all[each]);
            const auto exponents = result_.exponents_of(result_.terms[all[each]]);
            auto& row = square.emplace_back();
            for (const std::size_t j : result_.pivots) {
                row.emplace_back(rational(exponents[j]));
            }
        }
        for (const auto& row : inverse_of(square)) {
            auto& plain = result_.inverse.emplace_back();
            for (const quadratic_number& each : row) {
                plain.push_back(each.p);
            }
        }
        for (const std::size_t each : result_.equations) {
            set_turns(result_.terms[each]);
        }
    }

    void set_turns(const balance_term& of) {
        const std::complex<double> c = factor_of(of);
        const auto logarithm_at = [](const std::complex<double>& z) {
            complex_number<ball> exact;
            arb_set_d(exact.re.handle(), z.real());
            arb_set_d(exact.im.handle(), z.imag());
            const complex_number<ball> value = logarithm_near(exact, z);
            return std::complex<double>(arf_get_d(arb_midref(value.re.handle()), ARF_RND_NEAR),
                                        arf_get_d(arb_midref(value.im.handle()), ARF_RND_NEAR));
        };
        const std::complex<double> known =
            logarithm_at(static_cast<double>(*of.share)) - logarithm_at(c) - logarithm_at(0.0 - sample_.place);
        result_.factors.push_back(c);
        const std::complex<double> rest = (observed_logarithm(of) - known) / (2 * std::numbers::pi);
        if (std::abs(rest - std::complex<double>(0, std::round(rest.imag()))) > tolerance_of_logarithm) {
            refuse("whose leading coefficients are not decided");
        }
        result_.turns.push_back(std::lround(rest.imag()));
    }

    void check_relation(const std::vector<quadratic_number>& relation, const std::vector<std::size_t>& all) const {
        integer common = 1;
        for (const quadratic_number& each : relation) {
            common = lcm(common, denominator(each.p));
        }
        rational product = 1;
        for (std::size_t k = 0; k < all.size(); ++k) {
            const rational power = relation[k].p * common;
            if (power == 0) {
                continue;
            }
            const balance_term& term = result_.terms[all[k]];
            const auto c = term.of.by_time.size() == 1 ? term.of.by_time[0].fraction() : std::nullopt;
            if (!c || abs(power) > 64) {
                refuse("with coefficients for which the leading terms are not decided exactly");
            }
            const rational base = *term.share / *c;
            for (int i = 0; i < abs(power); ++i) {
                product = power > 0 ? rational(product * base) : rational(product / base);
            }
        }
        if (product != 1) {
            refuse("whose leading terms are not in the ratio of small integers");
        }
    }

    void set_step() {
        const auto include = [&](const rational& x) {
            if (x == 0) {
                return;
            }
            const integer common = lcm(denominator(result_.step), denominator(x));
            const integer a = numerator(rational(result_.step * common));
            const integer b = numerator(rational(x * common));
            result_.step = rational(gcd(a, b), common);
        };
        for (const balance_term& each : result_.terms) {
            include(each.excess);
            if (each.of.by_time.size() > 1) {
                include(rational(1));
            }
        }
    }

    const std::vector<std::vector<field_term>>& rows_;
    const balance_sample& sample_;
    std::size_t n_;
    bool powers_;
    std::vector<bool> vanishes_;
    dominant_balance result_;
};

}  // namespace

std::vector<int> dominant_balance::exponents_of(const balance_term& term) const {
    std::vector<int> result = term.of.powers;
    --result[term.row];
    return result;
}

complex_number<ball> logarithm_near(const complex_number<ball>& z, std::complex<double> near) {
    complex_number<ball> reference;
    arb_set_d(reference.re.handle(), near.real());
    arb_set_d(reference.im.handle(), near.imag());
    flint_complex a, b;
    acb_log(a.handle(), flint_complex(reference).handle(), ball::working_bits());
    acb_log(b.handle(), flint_complex(z / reference).handle(), ball::working_bits());
    return a.number() + b.number();
}

dominant_balance dominant_balance_of(const std::vector<std::vector<field_term>>& rows, const balance_sample& sample) {
    try {
        return balance_builder(rows, sample, false).built();
    } catch (const error&) {
        try {
            return balance_builder(rows, sample, true).built();
        } catch (const error&) {
            // the first reason is the plainer one
        }
        throw;
    }
}

}  // namespace libration::ode
