// The system in the coordinates of a balance, for given parameters, in balls; exactly where its coefficients are in a quadratic field.
#pragma once

#include <algorithm>
#include <map>
#include <numeric>
#include <vector>

#include "balance_series.hpp"

namespace libration::ode {

long binomial_of(int n, int k);

class local_field {
public:
    explicit local_field(const dominant_balance& balance);

    // x dz/dx for t* - t0, the finite limits and the free log S; `scales` receives the S. Terms without a positive power of x are those of
    // the shares, exactly.
    balance_field<complex_ball> at(const complex_ball& origin, const complex_ball& place,
                                   const std::vector<complex_ball>& finite, const std::vector<complex_ball>& free,
                                   std::vector<complex_ball>& scales);
    // V at x = 0.
    std::vector<complex_ball> limits(const std::vector<complex_ball>& finite) const;
    // Whether the coefficients are not the same for all parameters.
    bool depends_on_parameters() const { return depends_; }
    // The leading terms of all equations are in the ratio of their shares: those not used for S are so up to a root of unity of an order of at most
    // 64, which enclosures exclude. Throws precision_exhausted if they do not.
    void check_shares(const std::vector<complex_ball>& scales, const complex_ball& origin,
                      const complex_ball& place) const;
    // Removes the resonant terms whose factor is 0 by exact arithmetic.
    void drop_exact_zeros(balance_series<complex_ball>& series, const weighted_monomials& monomials);

private:
    complex_ball factor_of(const balance_term& of, const complex_ball& time, int power) const;
    std::size_t node_of(const std::vector<int>& exponents);
    int whole_power(const rational& exponent) const;
    template <class R>
    void expand(const balance_term& of, const R& factor, int power, const std::vector<R>& limits, std::size_t least,
                std::vector<typename balance_field<R>::term>& row);
    struct exact_sample {
        rational time;
        std::vector<rational> finite, free;
    };
    std::optional<balance_field<quadratic_number>> exact_field(const exact_sample& sample);
    std::optional<quadratic_number> exact_factor(const balance_term& of, const exact_sample& sample) const;
    std::optional<std::vector<exact_sample>> exact_grid(double largest, double least) const;
    void find_exact_resonances(const weighted_monomials& monomials);

    const dominant_balance& balance_;
    std::size_t size_;
    bool depends_ = false;
    std::map<std::vector<int>, std::size_t> nodes_;
    std::vector<std::pair<std::size_t, std::size_t>> products_;
    bool tried_ = false;
    std::optional<std::vector<std::pair<std::size_t, std::vector<int>>>> exact_resonances_;  // variable and exponents
};

// factor theta_0^power times the product of (limit_j + z_j)^e_j, without the terms of a degree below `least`.
template <class R>
void local_field::expand(const balance_term& of, const R& factor, int power, const std::vector<R>& limits,
                         std::size_t least, std::vector<typename balance_field<R>::term>& row) {
    std::vector<int> part(size_);
    const auto extend = [&](const auto& self, std::size_t j, const R& c) -> void {
        if (j == size_) {
            if (std::accumulate(part.begin(), part.end(), 0) >= static_cast<int>(least)) {
                row.push_back({c, power, node_of(part)});
            }
            return;
        }
        const int e = of.of.powers[j];
        for (int k = e; k >= 0; --k) {
            part[j] = k;
            R next = c * value_in<R>(quadratic_number(rational(static_cast<int>(binomial_of(e, k)))));
            for (int i = k; i < e; ++i) {
                next = next * limits[j];
            }
            if (!is_zero_term(next)) {
                self(self, j + 1, next);
            }
        }
        part[j] = 0;
    };
    extend(extend, 0, factor);
}

}  // namespace libration::ode
