// The options of commands that follow solutions with conditions at infinity.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "libration/problem/limit_solution.hpp"
#include "problem/problem_options.hpp"

namespace libration {

/// What take() takes out of a problem.
struct taken_limits {
    limit_problem problem;
    std::vector<std::string> shown;  ///< of numbers_at_infinity(), by --show
};

/// A line on stderr for each kind of number that `shown` names and no note has.
void say_missing(const std::vector<std::string>& shown, const std::vector<answer_note>& notes);

/// The parameters and initial values that the text of a problem leaves open, after its conditions at infinity were taken
/// out.
std::vector<std::string> numbers_left_open(const problem_options& problem_of);

/// --unknown and --guess, for problems whose text has conditions at infinity.
class limit_options {
public:
    void add_to(CLI::App& command);
    /// Takes the conditions out of the text of a problem. The unknowns are those of --unknown, or else the parameters and initial values that the
    /// text leaves open. std::nullopt without conditions. Throws input_error.
    std::optional<taken_limits> take(problem_options& problem) const;

private:
    std::vector<std::string> unknowns_, guesses_;
};

}  // namespace libration
