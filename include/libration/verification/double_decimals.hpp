// Recognises decimals that were printed from doubles, with more digits than these have.
#pragma once

#include <string>

namespace libration {

/// Whether written numbers, for instance those of a column, are the decimals of doubles to 17 digits or more, as "%.18e"
/// of numpy.savetxt and "%.17g" print them: each is the double nearest to it, rounded to the digits that are written.
///
/// A decimal chosen at random is so with the probability (unit of its last digit)/(unit in the last place of the
/// double), at most 1; with 19 digits that is less than 1/100, with 15 it is 1.
class double_decimals {
public:
    /// Another one of the numbers, which may be nan or inf. Throws error if it is not a number.
    void add(const std::string& text);
    /// Whether all of them are, and by chance with a probability of less than 1/100.
    bool recognised() const;
    /// Whether all of them are exactly doubles, as 0.5 is, so that reading them as decimals or as doubles is the same.
    bool exact() const { return exact_; }

private:
    bool all_ = true;
    bool exact_ = true;
    double chance_ = 1;
};

}  // namespace libration
