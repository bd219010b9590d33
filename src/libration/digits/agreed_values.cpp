#include "libration/digits/agreed_values.hpp"

#include <utility>

namespace libration {

namespace {

// A second run has more than twice the guard digits: the remainders of two equal losses would not agree.
constexpr long first_guard = 20;
constexpr long second_guard = 45;

// Two runs that lost all digits are both 0: unless vanishing() confirms it, 0 is accepted only from this number of
// guard digits on.
constexpr long guard_of_zero = 1440;

// In few digits: for a nonzero number of both parts, one of which may be small compared with the other.
mpfr size_of(const complex_number<mpfr>& z) {
    const precision_scope scope(20);
    return sqrt(mpfr(z.re * z.re + z.im * z.im));
}

// Whether the runs agree on a complex number; a small part becomes 0.
bool agreed_complex(const complex_number<mpfr>& before, complex_number<mpfr>& now, long digits) {
    const mpfr small = size_of(now) * pow(mpfr(10), static_cast<int>(-digits - digits_of_small_part));
    bool all = small > 0;
    const auto judge = [&](const mpfr& part_before, mpfr& part) {
        if (abs(part_before) < small && abs(part) < small) {
            part = 0;
        } else {
            all = all && agree(part_before, part, digits);
        }
    };
    judge(before.re, now.re);
    judge(before.im, now.im);
    return all;
}

// The second of two runs that are the same; the first one has first_guard.
template <class T, class Compute, class Same>
std::vector<T> values_of_two_runs(long digits, long most, const Compute& compute, const Same& same) {
    std::vector<T> now = compute(first_guard);
    return with_growing_precision({digits, second_guard, most}, std::to_string(digits) + " digits",
                                  [&](const precision_run& run) {
                                      const std::vector<T> before = std::exchange(now, compute(run.more));
                                      return same(before, now, run.more) ? std::optional(now) : std::nullopt;
                                  });
}

}  // namespace

bool agree(const mpfr& a, const mpfr& b, long digits) {
    const precision_scope scope(20);
    return abs(a - b) <= abs(b) * pow(mpfr(10), static_cast<int>(-digits - 2));
}

std::vector<mpfr> agreed_values(long digits, const std::function<std::vector<mpfr>(long guard)>& compute,
                                const std::function<std::vector<bool>()>& vanishing) {
    std::optional<std::vector<bool>> zero;
    // Whether the runs agree; values known to be 0 are set to 0.
    const auto same = [&](const std::vector<mpfr>& before, std::vector<mpfr>& now, long guard) {
        bool all = true;
        for (std::size_t i = 0; i < now.size(); ++i) {
            const bool believed = now[i] != 0 || vanishing || guard >= guard_of_zero;
            const bool agreed = believed && agree(before[i], now[i], digits);
            if (!agreed && !zero && vanishing && !agree(before[i], now[i], -1)) {
                zero = vanishing();
            }
            const bool vanishes = !agreed && zero && i < zero->size() && (*zero)[i];
            if (vanishes) {
                now[i] = 0;
            }
            all = all && (agreed || vanishes);
        }
        return all;
    };
    return values_of_two_runs<mpfr>(digits, most_agreement_digits, compute, same);
}

std::vector<complex_number<mpfr>> agreed_complex_values(
    long digits, const std::function<std::vector<complex_number<mpfr>>(long guard)>& compute,
    const std::function<std::vector<bool>()>& vanishing) {
    const auto zero = vanishing ? vanishing() : std::vector<bool>();
    const auto same = [&](const std::vector<complex_number<mpfr>>& before, std::vector<complex_number<mpfr>>& now,
                          long guard) {
        bool all = true;
        for (std::size_t i = 0; i < now.size(); ++i) {
            const bool vanishes = i < zero.size() && zero[i];
            const bool both_zero = before[i] == now[i] && size_of(now[i]) == 0;
            if (vanishes) {
                now[i] = complex_number<mpfr>(mpfr(0));
            }
            all =
                all && (vanishes || (both_zero && guard >= guard_of_zero) || agreed_complex(before[i], now[i], digits));
        }
        return all;
    };
    return values_of_two_runs<complex_number<mpfr>>(digits, most_complex_agreement_digits, compute, same);
}

}  // namespace libration
