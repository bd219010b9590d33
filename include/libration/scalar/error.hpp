// The single exception type of this library for invalid input: the quantity, its value, and the reason.
#pragma once

#include <array>
#include <cstddef>
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

/// The subjects that distinguish errors. Each has a name (name_of); any other subject is a text.
enum class error_subject {
    other,
    along,     ///< the parameter of a branch and its values
    argument,  ///< of a function
    before,    ///< the end of a search
    certificate,
    characteristic,  ///< of an elliptic integral
    check,           ///< the second proof
    condition,
    conditions,
    derivatives,
    direction,
    energy,
    first_guess,  ///< a solution that another first guess may lead to
    gap,
    gravity,
    integrator,
    length,
    nome,
    number,
    omega0,
    option,     ///< of a command
    parameter,  ///< of an elliptic function
    point,
    problem,
    proof,
    solution,
    start,
    theta0,
    time,
    unknowns
};

constexpr const char* name_of(error_subject subject) {
    constexpr std::array names{"",         "along",     "argument",   "before",      "certificate", "n",
                               "check",    "condition", "conditions", "derivatives", "direction",   "energy",
                               "solution", "gap",       "gravity",    "integrator",  "length",      "q",
                               "number",   "omega0",    "option",     "m",           "point",       "problem",
                               "proof",    "solution",  "start",      "theta0",      "time",        "unknowns"};
    static_assert(names.size() == static_cast<std::size_t>(error_subject::unknowns) + 1);
    return names.at(static_cast<std::size_t>(subject));
}

/// The subject of an error, and its name in messages.
struct subject_name {
    subject_name(error_subject subject) : of(subject), text(name_of(subject)) {}
    subject_name(std::string name) : of(error_subject::other), text(std::move(name)) {}
    subject_name(const char* name) : of(error_subject::other), text(name) {}
    subject_name(error_subject subject, std::string name) : of(subject), text(std::move(name)) {}

    error_subject of;
    std::string text;
};

/// "energy '-1' is negative": a quantity by the name familiar to the caller, its value as text, and the reason. Errors
/// of the library itself are std::logic_error, never this.
class error : public std::runtime_error {
public:
    error(error_kind kind, subject_name subject, std::string value, std::string reason)
        : std::runtime_error(subject.text + (value.empty() ? "" : " '" + value + "'") + " " + reason),
          kind_(kind),
          subject_(std::move(subject)),
          value_(std::move(value)),
          reason_(std::move(reason)) {}

    error_kind kind() const { return kind_; }
    /// The quantity: "energy", "order", "time", "number".
    const std::string& subject() const { return subject_.text; }
    /// The same to be compared with.
    error_subject about() const { return subject_.of; }
    bool is_about(error_subject subject) const { return subject_.of == subject; }
    /// Whether it is about the solution of conditions.
    bool is_about_solution() const { return is_about(error_subject::solution) || is_about(error_subject::first_guess); }
    /// As it was given; empty if the error is not in a single value.
    const std::string& value() const { return value_; }
    /// A predicate of the quantity: "is negative".
    const std::string& reason() const { return reason_; }

private:
    error_kind kind_;
    subject_name subject_;
    std::string value_, reason_;
};

/// Throws error of kind argument for a number without a name at this point.
[[noreturn]] inline void refuse_number(const std::string& reason) {
    throw error(error_kind::argument, error_subject::number, "", reason);
}

}  // namespace libration
