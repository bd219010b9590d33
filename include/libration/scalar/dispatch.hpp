// From the name of a scalar at run time to its type: the only place where this happens.
#pragma once

#include <charconv>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "libration/scalar/error.hpp"
#include "libration/scalar/precision.hpp"

namespace libration {

enum class scalar_kind { binary64, extended, binary128, arbitrary, proved };

/// The scalars accepted when a name is read: a computation without proofs does not accept balls.
enum class arithmetics { rounding, proved_too };

/// A scalar named at run time: double, long-double, quad, mpfr:DIGITS or ball:DIGITS.
struct scalar_spec {
    scalar_kind kind = scalar_kind::arbitrary;
    long digits = 50;  ///< correct digits requested in a result; for the fixed scalars those that print a value in full

    /// The name in the notation of the command line.
    std::string name() const {
        switch (kind) {
            case scalar_kind::binary64: return "double";
            case scalar_kind::extended: return "long-double";
            case scalar_kind::binary128: return "quad";
            case scalar_kind::proved: return "ball:" + std::to_string(digits);
            case scalar_kind::arbitrary: break;
        }
        return "mpfr:" + std::to_string(digits);
    }
};

/// The maximum number of digits of a run-time precision.
inline constexpr long most_digits = 100'000;

/// A number of digits as text, 1 .. most_digits. Throws error with the reason.
inline long read_digits(std::string_view text) {
    long value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem == std::errc::result_out_of_range || (problem == std::errc() && value > most_digits)) {
        throw error(error_kind::argument, "number of digits", std::string(text),
                    "is more than " + std::to_string(most_digits));
    }
    if (problem != std::errc() || end != text.data() + text.size()) {
        throw error(error_kind::argument, "number of digits", std::string(text), "is not a whole number of digits");
    }
    if (value < 1) {
        throw error(error_kind::argument, "number of digits", std::string(text), "is less than one");
    }
    return value;
}

/// Reads a scalar's name. Throws error with the reason.
inline scalar_spec read_scalar(std::string_view name, arithmetics offered = arithmetics::rounding) {
    if (name == "double") {
        return {scalar_kind::binary64, std::numeric_limits<double>::max_digits10};
    }
    if (name == "long-double") {
        return {scalar_kind::extended, std::numeric_limits<long double>::max_digits10};
    }
    if (name == "quad") {
        return {scalar_kind::binary128, std::numeric_limits<quad>::max_digits10};
    }
    if (name.starts_with("mpfr:")) {
        return {scalar_kind::arbitrary, read_digits(name.substr(5))};
    }
    if (name.starts_with("ball:")) {
        if (offered == arithmetics::rounding) {
            throw error(error_kind::argument, "scalar", std::string(name),
                        "is a proved arithmetic, which is not supported here");
        }
        return {scalar_kind::proved, read_digits(name.substr(5))};
    }
    throw error(error_kind::argument, "scalar", std::string(name), "is not a scalar");
}

/// Calls f<T>() with the rounding type named by the spec; mpfr at spec.digits + guard digits of working precision.
/// Balls are excluded: their digits come from repetition until they are proved, and this header does not need FLINT.
/// Throws std::logic_error for them.
template <class F>
decltype(auto) with_scalar(const scalar_spec& spec, long guard, F&& f) {
    switch (spec.kind) {
        case scalar_kind::binary64: return std::forward<F>(f).template operator()<double>();
        case scalar_kind::extended: return std::forward<F>(f).template operator()<long double>();
        case scalar_kind::binary128: return std::forward<F>(f).template operator()<quad>();
        case scalar_kind::proved: throw std::logic_error(spec.name() + " among the rounding scalars");
        case scalar_kind::arbitrary: break;
    }
    const precision_scope scope(spec.digits + guard);
    return std::forward<F>(f).template operator()<mpfr>();
}

}  // namespace libration
