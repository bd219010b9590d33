#include "chebyshev_zeros.hpp"

#include <flint/fmpq.h>

#include <algorithm>

#include "libration/expansion/step_pieces.hpp"

namespace libration::ode {

chebyshev_zeros::chebyshev_zeros(int degree, std::size_t length, long bits)
    : count_(16 * std::max(1, (3 * degree + 31) / 32)) {
    const precision_scope scope(decimal_digits(bits));
    fmpq_t part;
    fmpq_init(part);
    for (int j = 0; j < 4 * count_; ++j) {
        fmpq_set_si(part, j, 2 * static_cast<ulong>(count_));
        arb_cos_pi_fmpq(cosines_.emplace_back().handle(), part, ball::working_bits());
    }
    fmpq_clear(part);
    for (int k = 0; k < count_ / 2; ++k) {
        auto& row = powers_.emplace_back();
        for (std::size_t l = 0; l < length; ++l) {
            row.push_back(l == 0 ? ball(1) : row.back() * place(k));
        }
    }
}

magnitude chebyshev_zeros::factor(int degree) const {
    return magnitude(1U) / magnitude::below(cosines_[static_cast<std::size_t>(degree)]);
}

std::array<std::vector<ball>, 2> chebyshev_zeros::values(const std::vector<ball_polynomial>& all, int k,
                                                         long bits) const {
    std::array<std::vector<ball>, 2> result;
    const auto& x = powers_[static_cast<std::size_t>(k)];
    for (const ball_polynomial& a : all) {
        const int terms = static_cast<int>(a.size());
        const ball even = terms > 0 ? inner_product(a.data(), 2, x.data(), 2, (terms + 1) / 2) : ball(0);
        const ball odd = terms > 1 ? inner_product(a.data() + 1, 2, x.data() + 1, 2, terms / 2) : ball(0);
        arb_set_round(result[0].emplace_back().handle(), (even + odd).handle(), bits);
        arb_set_round(result[1].emplace_back().handle(), (even - odd).handle(), bits);
    }
    return result;
}

std::vector<ball> chebyshev_zeros::coefficients(const std::vector<ball>& at, int degree) const {
    std::vector<ball> result;
    for (long l = 0; l <= degree; ++l) {
        ball sum(0);
        for (long k = 0; k < count_; ++k) {
            arb_addmul(sum.handle(), at[static_cast<std::size_t>(k)].handle(), cosine(l * (2 * k + 1)).handle(),
                       ball::working_bits());
        }
        result.push_back(sum * (l == 0 ? 1L : 2L) / count_);
    }
    return result;
}

std::vector<ball> chebyshev_zeros::chebyshev_values(int degree) const {
    std::vector<ball> result;
    for (long l = 0; l <= degree; ++l) {
        for (long k = 0; k < count_; ++k) {
            result.push_back(cosine(l * (2 * k + 1)));
        }
    }
    return result;
}

}  // namespace libration::ode
