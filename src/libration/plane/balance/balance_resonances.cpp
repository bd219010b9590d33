#include <string>

#include "dominant_balance.hpp"

namespace libration::ode {

namespace {

class resonance_finder {
public:
    explicit resonance_finder(dominant_balance& of) : of_(of), n_(of.orders.size()) {}

    void set_eigenvalues() {
        std::vector<std::vector<rational>> k(n_, std::vector<rational>(n_));
        for (std::size_t i = 0; i < n_; ++i) {
            k[i][i] = of_.orders[i];
        }
        for (const balance_term& each : of_.terms) {
            for (std::size_t j = 0; each.share && j < n_; ++j) {
                // of a vanishing unknown only its own factor is differentiated
                if (of_.roles[each.row] == balance_role::nonzero || j == each.row) {
                    k[each.row][j] += *each.share * each.of.powers[j];
                }
            }
        }
        rational field = 1;
        std::vector<std::vector<quadratic_number>> vectors;
        for (const auto& [factor, multiplicity] : irreducible_factors(characteristic_of(k))) {
            std::vector<quadratic_number> roots;
            if (factor.degree() == 1) {
                roots.emplace_back(-factor[0]);
            } else if (factor.degree() == 2) {
                const rational d = factor[1] * factor[1] - factor[0] * 4;
                field = field == 1 ? d : field;
                const auto part = rational_root(d / field);
                if (!part) {
                    refuse("whose resonances are in different quadratic fields");
                }
                roots.emplace_back(-factor[1] / 2, *part / 2, field);
                roots.emplace_back(-factor[1] / 2, -*part / 2, field);
            } else {
                refuse("whose resonances are roots of an irreducible polynomial of degree " +
                       std::to_string(factor.degree()));
            }
            for (const quadratic_number& each : roots) {
                surd_matrix shifted(n_);
                for (std::size_t i = 0; i < n_; ++i) {
                    for (std::size_t j = 0; j < n_; ++j) {
                        shifted[i].emplace_back(k[i][j]);
                    }
                    shifted[i][i] = shifted[i][i] - each;
                }
                const auto basis = null_space(shifted, n_);
                if (basis.size() != static_cast<std::size_t>(multiplicity)) {
                    refuse("with a multiple resonance without as many directions");
                }
                add_resonance(each, basis, vectors);
            }
        }
        check_resonances();
        of_.columns.assign(n_, {});
        for (std::size_t i = 0; i < n_; ++i) {
            for (const auto& each : vectors) {
                of_.columns[i].push_back(each[i]);
            }
        }
        of_.inverse_columns = inverse_of(of_.columns);
    }

private:
    [[noreturn]] void refuse(const std::string& why) const { refuse_balance(of_.place, why); }

    void add_resonance(const quadratic_number& value, const std::vector<std::vector<quadratic_number>>& basis,
                       std::vector<std::vector<quadratic_number>>& vectors) {
        for (const auto& each : basis) {
            of_.eigenvalues.push_back(value);
            vectors.push_back(each);
        }
    }

    void check_resonances() {
        std::size_t translations = 0;
        std::size_t neutral = 0;
        for (std::size_t i = 0; i < n_; ++i) {
            const quadratic_number& r = of_.eigenvalues[i];
            if (r == quadratic_number(rational(-1))) {
                of_.translation = i;
                ++translations;
            } else if (r.is_zero()) {
                ++neutral;
            } else if (r.real_part() > 1e-9) {
                of_.growing.push_back(i);
            } else {
                refuse("at a lower balance, with a resonance of negative real part besides -1");
            }
        }
        if (translations != 1 || neutral != of_.finite.size() + of_.free.size()) {
            refuse("whose resonances -1 and 0 do not correspond to its place and its free coefficients");
        }
    }

    dominant_balance& of_;
    std::size_t n_;
};

}  // namespace

void set_resonances(dominant_balance& of) { resonance_finder(of).set_eigenvalues(); }

}  // namespace libration::ode
