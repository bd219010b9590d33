#include "libration/algebra/ball_matrix.hpp"

#include "libration/scalar/ball/functions.hpp"

#if __has_include(<flint/arb_mat.h>)
#include <flint/arb_mat.h>
#else
#include <arb_mat.h>
#endif

namespace libration::ode {

ball exact_midpoint(const ball& x) {
    ball result;
    arf_set_round(arb_midref(result.handle()), arb_midref(x.handle()), ball::working_bits(), ARF_RND_NEAR);
    return result;
}

ball_matrix product(const ball_matrix& a, const ball_matrix& b) {
    ball_matrix result(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.front().size(); ++j) {
            ball sum(0);
            for (std::size_t k = 0; k < b.size(); ++k) {
                sum += a[i][k] * b[k][j];
            }
            result[i].push_back(sum);
        }
    }
    return result;
}

std::optional<ball_matrix> inverse_near(const ball_matrix& a) {
    const auto size = static_cast<slong>(a.size());
    arb_mat_t from;
    arb_mat_t to;
    arb_mat_init(from, size, size);
    arb_mat_init(to, size, size);
    for (slong i = 0; i < size; ++i) {
        for (slong j = 0; j < size; ++j) {
            const ball& entry = a[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
            arf_set(arb_midref(arb_mat_entry(from, i, j)), arb_midref(entry.handle()));
        }
    }
    const bool regular = arb_mat_inv(to, from, ball::working_bits()) != 0;
    ball_matrix result(a.size());
    for (slong i = 0; i < size && regular; ++i) {
        for (slong j = 0; j < size; ++j) {
            ball entry;
            arf_set(arb_midref(entry.handle()), arb_midref(arb_mat_entry(to, i, j)));
            result[static_cast<std::size_t>(i)].push_back(entry);
        }
    }
    arb_mat_clear(from);
    arb_mat_clear(to);
    return regular ? std::optional(result) : std::nullopt;
}

}  // namespace libration::ode
