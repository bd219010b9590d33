// Numbers of which some may be 0 or nearly so, by runs of increasing precision that agree.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "libration/digits/agreed_values.hpp"

namespace libration::studies {

/// A number of some digits, and whether two runs agree to them. If not, it is 0 as far as can be determined.
struct agreed_number {
    mpfr value;
    bool agreed = false;
};

/// The numbers of compute(guard), which works with `digits` and `guard` digits: repeated until two runs agree on all,
/// at most six times. What is smaller than 10^-(digits + guard/2) in both of the last two runs is 0, without being
/// marked as agreed; inf agrees with inf, and an exact 0 with another.
template <class Compute>
std::vector<agreed_number> agreed_numbers(long digits, const Compute& compute) {
    constexpr std::array<long, 6> guards{20, 45, 90, 180, 360, 720};
    std::vector<mpfr> before;
    std::vector<agreed_number> found;
    for (const long guard : guards) {
        const std::vector<mpfr> now = compute(guard);
        const precision_scope scope(digits + guard);
        const mpfr negligible = pow(mpfr(10), static_cast<int>(-digits - guard / 2));
        bool all = !before.empty();
        found.resize(now.size());
        for (std::size_t i = 0; i < now.size(); ++i) {
            const bool infinite = mpfr_number_p(handle(now[i])) == 0;
            const bool same = !before.empty() &&
                              (infinite ? mpfr_number_p(handle(before[i])) == 0 : agree(before[i], now[i], digits));
            if (!found[i].agreed) {
                found[i] = {now[i], same};
            }
            all = all && found[i].agreed;
        }
        if (all) {
            break;
        }
        if (guard == guards.back()) {
            for (std::size_t i = 0; i < now.size(); ++i) {
                const bool vanishes =
                    !found[i].agreed && abs(now[i]) < negligible && abs(before[i]) < negligible * 1000;
                found[i].value = vanishes ? mpfr(0) : found[i].value;
            }
        }
        before = now;
    }
    return found;
}

}  // namespace libration::studies
