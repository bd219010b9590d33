// The parts of proved arithmetic that other headers use without FLINT: the ball as a declared type, and the exception
// for a decision that is not proved.
#pragma once

#include <string>

#include "libration/scalar/error.hpp"
#include "libration/scalar/traits.hpp"

namespace libration {

class ball;

/// A decision (a sign, a branch, a digit) that the available enclosures do not prove: repeat with more digits.
class precision_exhausted : public error {
public:
    explicit precision_exhausted(const std::string& what)
        : error(error_kind::undecided, what, "", "is not decided by this many digits") {}
};

}  // namespace libration
