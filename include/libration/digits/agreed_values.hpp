// Correct digits by two precisions: a computation without a bound of its error is repeated with more digits until two
// runs agree. That catches every loss that rounding causes (cancellation, a value next to 0); it does not judge the
// formula.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/digits/growing_precision.hpp"
#include "libration/scalar/complex_number.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration {

/// Whether a and b are the same number to `digits` significant digits and two more; 0 agrees with 0 alone.
bool agree(const mpfr& a, const mpfr& b, long digits);

/// The last of compute(run), in the precision of the run, that same(the one before, it) confirms; a run that answers
/// std::nullopt confirms nothing and is not compared with. Throws as with_growing_precision.
template <class Compute, class Same>
auto until_two_agree(const growing_digits& digits, const std::string& subject, const Compute& compute,
                     const Same& same) {
    decltype(compute(precision_run{})) before;
    return with_growing_precision(digits, subject, [&](const precision_run& run) {
        auto now = compute(run);
        const bool agreed = before && now && same(*before, *now);
        before = agreed ? std::nullopt : now;
        return agreed ? std::move(now) : std::nullopt;
    });
}

/// Guard digits beyond which no loss is believed: what still changes is 0, or has no digits.
inline constexpr long most_agreement_digits = 100'000;

/// Numbers with `digits` digits each right to one unit in the last: compute(guard) returns them by arithmetic of
/// `guard` digits more, in whatever scope it opens. vanishing() is asked, once, which of them are exactly 0, when one
/// has kept no digit in two runs: no precision would tell. Cost: two runs, with 20 and 45 guard digits, where less than
/// 18 are lost; then 90, 180, ... A 0 that two runs find is believed where vanishing() stands by, else from 1440 guard
/// digits on: a loss of all digits looks the same.
/// Throws error of the kind undecided where most_agreement_digits do not do.
std::vector<mpfr> agreed_values(long digits, const std::function<std::vector<mpfr>(long guard)>& compute,
                                const std::function<std::vector<bool>()>& vanishing = {});

/// Guard digits beyond which complex numbers are not tried.
inline constexpr long most_complex_agreement_digits = 3000;
/// A part of a complex number that is less than 10^-(digits + this) of its modulus is given as 0.
inline constexpr long digits_of_small_part = 15;

/// Complex numbers: each part has `digits` digits right to one unit in the last, but one that two runs of different
/// precision find below 10^-(digits + digits_of_small_part) of the modulus is 0. So a real number is one, however it
/// was computed. vanishing() and cost as above. Throws error of the kind undecided where most_complex_agreement_digits
/// do not do, as for a number that is exactly 0 and is not said to be.
std::vector<complex_number<mpfr>> agreed_complex_values(
    long digits, const std::function<std::vector<complex_number<mpfr>>(long guard)>& compute,
    const std::function<std::vector<bool>()>& vanishing = {});

}  // namespace libration
