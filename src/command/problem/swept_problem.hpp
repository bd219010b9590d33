// A problem with varied parameters and initial values: each --set of a study is an axis.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/problem/limit_solution.hpp"
#include "libration/problem/problem_family.hpp"

namespace libration {

/// A parameter or an initial value, and the text of its values: k=1,2 or f''(0)=0.1:0.5:9.
struct set_axis {
    std::string name;
    std::string words;

    /// The option of a study for it: "--set k".
    std::string option() const { return "--set " + name; }
    /// The name of its axis: "set k".
    std::string axis() const { return "set " + name; }
};

/// The equation of a study.
struct swept_problem {
    std::string said;  ///< the argument of --problem
    std::string name;  ///< as in the names of files
    std::string text;
    ode::equation_system system;
    std::vector<set_axis> sets;           ///< parameters in the order of the text, then initial values
    std::vector<std::string> limits;      ///< conditions at infinity, which `system` does not contain
    std::vector<std::string> determined;  ///< the numbers that the text leaves open, if there are such conditions
    problem_family axes;                  ///< of the sets, of times and of unknowns

    /// The system with these values, one for each of the sets, solved for its highest derivatives. Throws error if
    /// there is no solution.
    ode::explicit_system at(const std::vector<exact>& values) const;
    /// The problem with these values and conditions at infinity; those of `determined` numbers are first guesses.
    limit_problem at_infinity(const std::vector<exact>& values) const;
    /// "--problem sir --set r=0.01:0.05:9": how a command line specifies it.
    std::string command() const;
};
using shared_problem = std::shared_ptr<const swept_problem>;

/// The problem of --problem and --set. Throws input_error for an invalid problem, and for names that it does not have.
shared_problem sweep_problem(const std::string& said, const std::vector<std::string>& sets);

/// A word of a command, in double quotes if a shell needs them.
std::string quoted_word(const std::string& word);
/// Without such quotes.
std::string unquoted_word(const std::string& word);
/// The text without blanks, tabs and ends of lines.
std::string without_blanks(std::string text);

}  // namespace libration
