// Correct digits from two precisions: a computation without an error bound is repeated with more digits until two runs
// agree. This detects any loss due to rounding (cancellation, a value close to 0); it does not check the formula.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/digits/precision_loop.hpp"
#include "libration/scalar/complex_number.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration {

/// Whether a and b are equal to `digits` significant digits and two more; 0 agrees only with 0.
bool agree(const mpfr& a, const mpfr& b, long digits);

/// The last result of compute(run), in the precision of the run, for which same(previous, it) holds; a run that returns
/// std::nullopt confirms nothing and is not compared with. Throws as with_growing_precision.
template <class Compute, class Same>
auto until_two_agree(const growing_digits& digits, const subject_name& subject, const Compute& compute,
                     const Same& same) {
    decltype(compute(precision_run{})) before;
    return with_growing_precision(digits, subject, [&](const precision_run& run) {
        auto now = compute(run);
        const bool agreed = before && now && same(*before, *now);
        before = agreed ? std::nullopt : now;
        return agreed ? std::move(now) : std::nullopt;
    });
}

/// Number of guard digits at which the search ends: a value that still changes is 0, or has no correct digits.
inline constexpr long most_agreement_digits = 100'000;

/// Numbers with `digits` digits, each correct to one unit in the last: compute(guard) returns them by arithmetic with
/// `guard` more digits, in whatever scope it opens. vanishing(), called once if a number has kept no digit in two runs,
/// returns which of them are exactly 0, which no precision can decide. Cost: two runs, with 20 and 45 guard digits, if
/// fewer than 18 are lost; then 90, 180, ... A 0 found by two runs is accepted if vanishing() confirms it, otherwise
/// from 1440 guard digits on: a loss of all digits looks the same.
/// Throws error of the kind undecided if most_agreement_digits do not suffice.
std::vector<mpfr> agreed_values(long digits, const std::function<std::vector<mpfr>(long guard)>& compute,
                                const std::function<std::vector<bool>()>& vanishing = {});

/// Largest number of guard digits for complex numbers.
inline constexpr long most_complex_agreement_digits = 3000;
/// A part of a complex number that is less than 10^-(digits + this) of its modulus is returned as 0.
inline constexpr long digits_of_small_part = 15;

/// Complex numbers: each part has `digits` digits correct to one unit in the last, except that a part which two runs of
/// different precision find below 10^-(digits + digits_of_small_part) of the modulus is 0. A real number is thus
/// returned as real, however it was computed. vanishing() and cost as above. Throws error of the kind undecided if
/// most_complex_agreement_digits do not suffice, as for a number that is exactly 0 and is not reported as such.
std::vector<complex_number<mpfr>> agreed_complex_values(
    long digits, const std::function<std::vector<complex_number<mpfr>>(long guard)>& compute,
    const std::function<std::vector<bool>()>& vanishing = {});

}  // namespace libration
