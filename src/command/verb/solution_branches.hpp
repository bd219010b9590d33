// The branches of solutions that first guesses lead to, as one table.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "found_solutions.hpp"
#include "libration/problem/answer.hpp"
#include "text/table.hpp"

namespace libration {

/// The remarks state for each branch where and why it ends, and what is not proved.
class solution_branches : public guessed_answers {
public:
    bool has_points() const { return !branches_.empty(); }

    /// point, the parameter, the unknowns, digits, rigour; of several first guesses in a first column the number of the
    /// branch; in a last one the bounds of values that are not distinguished from 0, if there are any.
    table as_table(long digits, bool numbered) const;

private:
    void keep(const first_guess& guess, answer found) override;
    std::string failure(const first_guess& guess) const override;

    std::vector<answer> branches_;
};

}  // namespace libration
