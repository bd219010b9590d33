// First guesses of --guess, the solutions that they lead to, and why others lead to none.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/problem/answer.hpp"
#include "text/table.hpp"

namespace libration {

/// The changes of a problem that are one first guess: "y'(0) = 0.5", "k = 2".
using first_guess = std::vector<std::string>;

/// NAME=VALUES such as y'(0)=0.5,10 or k=0:1:11 in all combinations, one empty guess if nothing is given. Throws
/// input_error for other forms, and for names that are not among the unknowns or are given twice.
std::vector<first_guess> first_guesses(const std::vector<std::string>& given, const std::vector<std::string>& unknowns);

/// What several first guesses lead to, and a line for each of those that lead to nothing new.
class guessed_answers {
public:
    virtual ~guessed_answers() = default;

    /// find() of one first guess. An error of the kind undecided is kept; one that is not about this solution, such as
    /// the end of --timeout, is passed on.
    template <class Find>
    void add(const first_guess& guess, const Find& find) {
        try {
            keep(guess, find());
        } catch (const error& problem) {
            add_failure(guess, problem);
        }
    }
    const std::vector<std::string>& remarks() const { return remarks_; }
    bool has_failures() const { return has_failures_; }

protected:
    virtual void keep(const first_guess& guess, answer found) = 0;
    /// "the first guess y'(0) = 1 leads to no solution".
    virtual std::string failure(const first_guess& guess) const = 0;

    std::vector<std::string> remarks_;
    bool has_failures_ = false;

private:
    void add_failure(const first_guess& guess, const error& problem);
};

/// A solution whose enclosures meet those of an earlier one is not added.
class found_solutions : public guessed_answers {
public:
    const std::vector<answer>& solutions() const { return solutions_; }
    /// name, value, digits and rigour; of several first guesses in a first column the number of the solution.
    /// The notes that are a number of `shown` (numbers_at_infinity) have rows too.
    table as_table(long digits, bool numbered, const std::vector<std::string>& shown = {}) const;
    /// The same as lines, with a blank line between solutions.
    std::string as_text(const std::vector<std::string>& shown = {}) const;

private:
    void keep(const first_guess& guess, answer found) override;
    std::string failure(const first_guess& guess) const override;

    std::vector<answer> solutions_;
};

}  // namespace libration
