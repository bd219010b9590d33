// Numbers as printed in an arithmetic chosen at run time: the only place that distinguishes fixed scalars, mpfr and
// balls.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "libration/digits/agreed_values.hpp"
#include "libration/digits/proved_decimals.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/dispatch.hpp"

namespace libration {

/// A number as it is printed; the uncertainty is empty if nothing is proved.
using printed_number = proved_decimal;

/// f<T>(), numbers in the wide arithmetic of T, for a rounding scalar, by one run with 20 guard digits in mpfr.
template <class F>
std::vector<mpfr> one_run(const scalar_spec& scalar, const F& f, long guard = 20) {
    const precision_scope wide(scalar.digits + guard);
    return with_scalar(scalar, guard, f);
}

/// The same as computed by a fixed scalar; in mpfr correct to the digits of the scalar, by two runs that agree.
template <class F>
std::vector<mpfr> rounded_values(const scalar_spec& scalar, const F& f,
                                 const std::function<std::vector<bool>()>& vanishing = {}) {
    return scalar.kind == scalar_kind::arbitrary
               ? agreed_values(
                     scalar.digits, [&](long guard) { return one_run(scalar, f, guard); }, vanishing)
               : one_run(scalar, f);
}

/// rounded_values() for complex numbers.
template <class F>
std::vector<complex_number<mpfr>> rounded_complex_values(const scalar_spec& scalar, const F& f,
                                                         const std::function<std::vector<bool>()>& vanishing = {}) {
    const auto run = [&](long guard) {
        const precision_scope wide(scalar.digits + guard);
        return with_scalar(scalar, guard, f);
    };
    return scalar.kind == scalar_kind::arbitrary ? agreed_complex_values(scalar.digits, run, vanishing) : run(20);
}

/// The decimals of rounded values, with this number of digits.
inline std::vector<printed_number> printed(const std::vector<mpfr>& values, long digits) {
    std::vector<printed_number> numbers;
    numbers.reserve(values.size());
    for (const mpfr& value : values) {
        numbers.push_back({to_decimal(value, digits), ""});
    }
    return numbers;
}

/// f<T>() with `digits` printed digits, T the type of the scalar: unchanged for a fixed scalar, correct to one unit in
/// the last for mpfr, proved for balls. vanishing() returns which of the numbers are exactly 0, where that is known.
/// Throws error of the kind undecided if no precision within the limits suffices.
template <class F>
std::vector<printed_number> printed(const scalar_spec& scalar, long digits, const F& f,
                                    const std::function<std::vector<bool>()>& vanishing = {}) {
    if (scalar.kind == scalar_kind::proved) {
        return proved_decimals(
            digits, [&] { return f.template operator()<ball>(); }, vanishing);
    }
    return printed(rounded_values(scalar, f, vanishing), digits);
}

/// printed() with correct digits whatever the scalar of the command is: T is mpfr, or ball for a proved scalar.
template <class F>
std::vector<printed_number> printed_right(const scalar_spec& scalar, long digits, const F& f) {
    if (scalar.kind == scalar_kind::proved) {
        return proved_decimals(digits, [&] { return f.template operator()<ball>(); });
    }
    const auto compute = [&](long guard) {
        const precision_scope scope(digits + guard);
        return f.template operator()<mpfr>();
    };
    return printed(agreed_values(digits, compute), digits);
}

}  // namespace libration
