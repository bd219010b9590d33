// The one exception of this library for what a caller gave: which quantity, its value, and what is wrong with it.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace libration {

/// What a caller can do about it.
enum class error_kind {
    argument,  ///< the value is malformed or outside the domain: give another one
    range,     ///< the value is beyond the range of this scalar: another scalar holds it
    undecided  ///< no precision within the limits decides: nothing is wrong with the value
};

/// "energy '-1' is negative": a quantity that the caller knows by this name, its value as text, and the reason.
/// Mistakes of the library itself are std::logic_error, never this.
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
    /// As it was given; empty where no single value is wrong.
    const std::string& value() const { return value_; }
    /// A predicate of the quantity: "is negative".
    const std::string& reason() const { return reason_; }

private:
    error_kind kind_;
    std::string subject_, value_, reason_;
};

/// Throws error of kind argument for a number that is not named here.
[[noreturn]] inline void refuse_number(const std::string& reason) {
    throw error(error_kind::argument, "number", "", reason);
}

}  // namespace libration
