// What a solution is asked for, and what it answers: decimals with what is known of their error.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "libration/scalar/dispatch.hpp"
#include "libration/scalar/error.hpp"

namespace libration {

/// How a solution is asked.
struct request {
    /// ball:DIGITS: every digit proved; mpfr:DIGITS: every digit right to one unit in the last; a fixed scalar: what
    /// the arithmetic of that type makes of it.
    scalar_spec scalar{scalar_kind::proved, 50};
    /// Digits of the decimals; those of the scalar where it is 0.
    long digits = 0;
    /// Each proof is compared with a second one by another route.
    bool check = false;
    /// Progress callback: which part of the work is done, from 0 to 1.
    std::function<void(double part)> progress = {};

    long printed_digits() const { return digits > 0 ? digits : scalar.digits; }
};

/// Every digit proved.
inline request proved_digits(long digits) { return {.scalar = {scalar_kind::proved, digits}}; }
/// Every digit right to one unit in the last, by runs that agree or by bounds.
inline request rounded_digits(long digits) { return {.scalar = {scalar_kind::arbitrary, digits}}; }

/// A number of an answer.
struct answer_value {
    /// The decimal; empty where no digit of it is decided, or the equations of its unknown do not reach the time.
    std::string text;
    /// Where it is proved: an upper bound of |exact - decimal|, of |exact| where no digit is decided. Empty otherwise.
    std::string bound;
};

/// Numbers with the names of their columns.
struct answer {
    std::vector<std::string> names;
    /// As many values as names; none in a row that has no answer, as a time that is not reached.
    std::vector<std::vector<answer_value>> rows;
    /// proved, two-method or heuristic.
    std::string rigour;
    /// Of states where the problem has invariants and nothing is proved: in each row the largest change of one since the
    /// start, empty where the state is not complete.
    std::vector<std::string> drifts = {};
    /// Why something is missing, where something is.
    std::optional<error> missing = {};

    /// The decimal of a row and a column. Throws what is missing, and error for a name that there is none of.
    const std::string& at(std::size_t row, const std::string& name) const;
};

}  // namespace libration
