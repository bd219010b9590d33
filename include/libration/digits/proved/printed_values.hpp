// Numbers as they are printed in an arithmetic that is chosen at run time: the one place that tells fixed scalars, mpfr
// and balls apart.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "libration/digits/agreed_values.hpp"
#include "libration/digits/proved/proved_decimals.hpp"
#include "libration/scalar/dispatch.hpp"
#include "libration/scalar/text/decimal.hpp"

namespace libration {

/// A number as it is printed; the uncertainty is empty where nothing is proved.
using printed_number = proved_decimal;

/// f<T>(), numbers in the wide arithmetic of T, for a scalar that rounds, by one run with 20 guard digits in mpfr.
template <class F>
std::vector<mpfr> one_run(const scalar_spec& scalar, const F& f, long guard = 20) {
    const precision_scope wide(scalar.digits + guard);
    return with_scalar(scalar, guard, f);
}

/// The same as a fixed scalar computes them; in mpfr right to the digits of the scalar, by two runs that agree.
template <class F>
std::vector<mpfr> rounded_values(const scalar_spec& scalar, const F& f,
                                 const std::function<std::vector<bool>()>& vanishing = {}) {
    return scalar.kind == scalar_kind::arbitrary
               ? agreed_values(
                     scalar.digits, [&](long guard) { return one_run(scalar, f, guard); }, vanishing)
               : one_run(scalar, f);
}

/// The same of complex numbers.
template <class F>
std::vector<complex_number<mpfr>> rounded_complex_values(const scalar_spec& scalar, const F& f,
                                                         const std::function<std::vector<bool>()>& vanishing = {}) {
    const auto run = [&](long guard) {
        const precision_scope wide(scalar.digits + guard);
        return with_scalar(scalar, guard, f);
    };
    return scalar.kind == scalar_kind::arbitrary ? agreed_complex_values(scalar.digits, run, vanishing) : run(20);
}

/// The decimals of values that round, with so many digits.
inline std::vector<printed_number> printed(const std::vector<mpfr>& values, long digits) {
    std::vector<printed_number> numbers;
    numbers.reserve(values.size());
    for (const mpfr& value : values) {
        numbers.push_back({to_decimal(value, digits), ""});
    }
    return numbers;
}

/// f<T>() with `digits` printed digits, T the type of the scalar: as it stands for a fixed scalar, right to one unit in
/// the last for mpfr, proved for balls. vanishing() says which of the numbers are exactly 0, where that is known.
/// Throws error of the kind undecided where no precision within the limits does.
template <class F>
std::vector<printed_number> printed(const scalar_spec& scalar, long digits, const F& f,
                                    const std::function<std::vector<bool>()>& vanishing = {}) {
    if (scalar.kind == scalar_kind::proved) {
        return proved_decimals(
            digits, [&] { return f.template operator()<ball>(); }, vanishing);
    }
    return printed(rounded_values(scalar, f, vanishing), digits);
}

/// The same with digits that are right whatever the scalar of the command is: T is mpfr, or ball where that is proved.
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
