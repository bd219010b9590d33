// The branches of solutions that first guesses lead to, as one table.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "find/found_solutions.hpp"
#include "libration/problem/answer.hpp"
#include "text/table.hpp"

namespace libration {

class solution_branches {
public:
    /// find() of one first guess. If several are added, an error of the kind undecided about the solution is kept; any
    /// other is passed on.
    template <class Find>
    void add(const first_guess& guess, const Find& find) {
        try {
            add_branch(guess, find());
        } catch (const error& problem) {
            add_failure(guess, problem);
        }
    }

    bool has_points() const { return !branches_.empty(); }
    bool has_failures() const { return has_failures_; }
    /// For each branch where and why it ends, what is not proved, and first guesses that lead to no branch.
    const std::vector<std::string>& remarks() const { return remarks_; }

    /// point, the parameter, the unknowns, digits, rigour; of several first guesses in a first column the number of the
    /// branch; in a last one the bounds of values that are not distinguished from 0, if there are any.
    table as_table(long digits, bool numbered) const;

private:
    void add_branch(const first_guess& guess, answer found);
    void add_failure(const first_guess& guess, const error& problem);

    std::vector<answer> branches_;
    std::vector<std::string> remarks_;
    bool has_failures_ = false;
};

}  // namespace libration
