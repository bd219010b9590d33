// The single exception type of this library for invalid input: the quantity, its value, and the reason.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace libration {

/// The remedies available to a caller. Two results are kept apart, as GR_DOMAIN and GR_UNABLE in FLINT: `undefined`, the
/// question as stated has no result, and `unable`, the result was not decided or not computed within the limits.
enum class error_kind {
    argument,  ///< undefined: the value is malformed or outside the domain: use another one
    range,     ///< undefined in this scalar, whose range the value exceeds: use another scalar
    undecided  ///< unable: no precision, proof or method within the limits decides; the value itself is valid
};

/// Whether the question as stated has no result: the exit code of a command is 2, otherwise 1.
constexpr bool is_undefined(error_kind kind) {
    switch (kind) {
        case error_kind::argument:
        case error_kind::range: return true;
        case error_kind::undecided: break;
    }
    return false;
}

/// "energy '-1' is negative": a quantity by the name familiar to the caller, its value as text, and the reason. Errors
/// of the library itself are std::logic_error, never this.
class error : public std::runtime_error {
public:
    error(error_kind kind, std::string subject, std::string value, std::string reason)
        : std::runtime_error(subject + (value.empty() ? "" : " '" + value + "'") + " " + reason),
          kind_(kind),
          subject_(std::move(subject)),
          value_(std::move(value)),
          reason_(std::move(reason)) {}

    error_kind kind() const { return kind_; }
    /// The quantity: "energy", "order", "time", "number".
    const std::string& subject() const { return subject_; }
    /// As it was given; empty if the error is not in a single value.
    const std::string& value() const { return value_; }
    /// A predicate of the quantity: "is negative".
    const std::string& reason() const { return reason_; }

private:
    error_kind kind_;
    std::string subject_, value_, reason_;
};

/// Throws error of kind argument for a number without a name at this point.
[[noreturn]] inline void refuse_number(const std::string& reason) {
    throw error(error_kind::argument, "number", "", reason);
}

}  // namespace libration
