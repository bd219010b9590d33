// The request to a solution, and the result: decimals with error information.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/approximant/differential.hpp"
#include "libration/integration/integrator.hpp"
#include "libration/number/exact.hpp"
#include "libration/scalar/dispatch.hpp"
#include "libration/scalar/error.hpp"

namespace libration {

/// How a solution is computed and printed.
struct request {
    /// ball:DIGITS: every digit proved; mpfr:DIGITS: every digit correct to one unit in the last; a fixed scalar: the
    /// result of the arithmetic of that type.
    scalar_spec scalar{scalar_kind::proved, 50};
    /// Digits of the decimals; those of the scalar if 0.
    long digits = 0;
    /// Of states: the parameters and initial values, r, x'(0), with respect to which every quantity is differentiated
    /// (derivative_name), as ode::proved_derivatives does. An error of the subject "derivatives" unless the
    /// scalar is a ball. The derivatives of a recognised pendulum are those of its equations.
    std::vector<std::string> derivatives = {};
    /// Each proof is compared with a second one by another route.
    bool check = false;
    /// Progress callback: the part of the work that is done, from 0 to 1. If it throws an error of the kind undecided,
    /// states() returns what is finished, with this error as the reason of what is missing.
    std::function<void(double part)> progress = {};
    /// Of an integration, before progress: the time reached, and the bits of the run.
    std::function<void(double time, long bits)> reached = {};
    /// Of a search and a proof in the complex plane, for singularities and proved radii: "120 expansion points, 43
    /// discs". If it throws an error of the kind undecided, singularities() returns what is finished, with this error as
    /// the reason of what is missing; a proof of a radius ends with the proved bound.
    std::function<void(const std::string& done)> stage = {};
    /// The integrator of states that are computed by integration. collocation is an error of the subject
    /// "integrator", if it does not support the system or the precision, and for closed forms. taylor is an error for
    /// closed forms.
    ode::integrator_choice integrator = ode::integrator_choice::automatic;
    /// Called for each step of a proof of states at times; not for the second proof of `check`.
    ode::step_observer observer = {};
    /// Of a verdict on coefficients: where the singularity is known to be, for the exponent there.
    std::optional<exact> known_place = {};
    /// Independent tasks of a verdict on coefficients; one after the other unless given.
    task_runner run = run_in_order;

    long printed_digits() const { return digits > 0 ? digits : scalar.digits; }
};

/// Every digit proved.
inline request proved_digits(long digits) { return {.scalar = {scalar_kind::proved, digits}}; }
/// Every digit correct to one unit in the last, by runs that agree or by bounds.
inline request rounded_digits(long digits) { return {.scalar = {scalar_kind::arbitrary, digits}}; }

/// A list is a JSON array.
enum class value_kind { number, whole_number, text, list };

/// One value of a result.
struct answer_value {
    /// The decimal; empty if no digit of it is decided, or if the solution of its unknown does not reach the time.
    std::string text;
    /// If it is proved: an upper bound of |exact - decimal|, or of |exact| if no digit is decided; of the position of a
    /// singularity also if it is not proved, then an estimate. Empty otherwise.
    std::string bound;
    value_kind kind = value_kind::number;
};

/// The index of a row, and words.
inline answer_value whole_value(long n) { return {std::to_string(n), "0", value_kind::whole_number}; }
inline answer_value text_value(std::string text) { return {std::move(text), "", value_kind::text}; }

/// A remark about a result: "upper", "a singularity of y within 1e-9 of 1.5707963, because ...".
struct answer_note {
    std::string name;
    std::string text;
    std::string kind = {};  ///< of a number in addition to the values: amplitude, rate, limit or angle
};

/// The column of the derivative of a quantity with respect to a number: "dx'(t)/dx(0)".
std::string derivative_name(const std::string& quantity, const std::string& variable, const std::string& number);

/// Numbers with the names of their columns.
struct answer {
    std::vector<std::string> names;
    /// As many values as names; empty for a row without a result, for instance a time that is not reached.
    std::vector<std::vector<answer_value>> rows;
    /// proved, two-method or heuristic.
    std::string rigour;
    /// For states, if the problem has invariants and nothing is proved: in each row the largest change of one since the
    /// start, empty if the state is not complete.
    std::vector<std::string> drifts = {};
    /// Why values are missing, if any are.
    std::optional<error> missing = {};
    /// For singularities: whether the whole disc was searched.
    bool complete = true;
    /// What explains the values, line by line: the reasons of a proof, the verdict of several tests.
    std::vector<answer_note> notes = {};
    /// For states: where collocation was used, one entry per independent subsystem and direction of time.
    std::vector<ode::collocation_use> collocation = {};

    /// The decimal or the words, which may be empty, of a row and a column. Throws `missing` for a value that is
    /// missing, rows beyond the last included, and error for an unknown name and, if nothing is missing, such a row.
    const std::string& at(std::size_t row, const std::string& name) const;
};

}  // namespace libration
