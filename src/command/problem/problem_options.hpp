// The options of commands that accept any differential equation instead of a motion.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/problem/solution.hpp"
#include "libration/scalar/error.hpp"
#include "text/input_error.hpp"

namespace libration {

/// read(); an error about a problem is rethrown with the name of the option. Errors of the kind undecided and errors
/// about anything else are passed on.
template <class Read>
auto naming_option(const std::string& option, const Read& read) {
    try {
        return read();
    } catch (const error& problem) {
        if (problem.kind() != error_kind::argument || !problem.is_about(error_subject::problem)) {
            throw;
        }
        const std::string value = problem.value().empty() ? "" : " '" + problem.value() + "'";
        throw input_error(option + value + " " + problem.reason());
    }
}

/// The problem of --problem: the name in the catalogue, a file's without directory and extension, or "typed"; and the
/// text.
struct problem_source {
    std::string name;
    std::string text;
};

/// A text if it contains =, a file if it contains / or ends in .ode, else a name of the catalogue. Throws input_error.
problem_source problem_named(const std::string& words);

/// A line on stderr for each parameter that a problem defines but does not use: valid, but possibly not what was
/// intended. It is therefore a warning, and stdout is unchanged. Throws error if the problem cannot be read.
void warn_of_unused_parameters(const std::string& written);

class problem_options;

/// A problem of a family: the values of the lists of --set, by name, and its options.
struct family_member;

/// --problem NAME | FILE.ode | 'TEXT; WITH; SEMICOLONS' and --set k=1/3, --set "f'(0)=1", any number of them.
class problem_options {
public:
    /// Whether a command uses closed forms if they are known, and has --general, which disables them.
    enum class closed_forms { used, not_used };
    /// Whether --set accepts lists, which make a family.
    enum class set_values { single, lists };
    void add_to(CLI::App& command, closed_forms known = closed_forms::not_used, set_values sets = set_values::single);
    /// The solution; by Taylor series with --general or `general`. A line on stderr names the closed form that is used.
    /// Throws input_error.
    std::unique_ptr<libration::solution> solution(bool general = false) const;
    /// The solution by Taylor series. Throws input_error.
    std::unique_ptr<libration::solution> general_solution() const;
    /// Whether a problem is given.
    bool is_chosen() const { return problem_.has_value(); }
    /// For a problem with events or a piecewise right-hand side, a line on stderr: the results are those of the branch at
    /// the initial point.
    void state_first_branch() const;
    /// The problem solved for its highest derivatives. Throws input_error.
    ode::explicit_system choose() const;
    /// The same; of a problem with events or a piecewise right-hand side the branch at its initial point, of one with
    /// delays the equations up to the first breaking point.
    ode::explicit_system choose_first_branch() const;
    /// The same as it is written, with the changes; other options, by their names, may give values X = VALUE to what
    /// the text leaves open.
    ode::equation_system equations(const std::vector<std::pair<std::string, std::string>>& by_options = {}) const;
    /// The same without the requirement that all initial values are given.
    ode::equation_system equations_with_open_starts(
        const std::vector<std::pair<std::string, std::string>>& by_options) const;
    /// Removes the conditions at infinity, f'(inf) = 1, from the text of the problem, and adds the initial values that
    /// with_starts_between() gives.
    std::vector<std::string> take_limits(const std::vector<std::string>& unknowns);
    /// Whether the text of the problem has conditions at infinity that were not removed.
    bool has_limits() const;
    /// Removes these words from --show, unless the problem has such a name, and returns them.
    std::vector<std::string> take_shown(const std::vector<std::string>& words);
    /// The argument as it was given, without what take_limits() removed.
    const std::optional<std::string>& problem() const { return problem_; }
    const std::vector<std::string>& changes() const { return changes_; }
    /// The name of the problem for titles (problem_source::name). Throws input_error.
    std::string name() const { return problem_named(*problem_).name; }
    /// A heading for figures: the text as typed, the comment in the first line of a file, or else the name. Throws
    /// input_error.
    std::string heading() const;
    /// The combinations of the lists --set X=1,2 or X=a:b:n, the last list fastest; one problem without values if there
    /// are no lists. Throws input_error, also for more than `most`.
    std::vector<family_member> family(std::size_t most = 1000) const;

    /// read(); an error about the problem is rethrown with the names of the options that give it.
    template <class Read>
    auto naming(const Read& read) const {
        return naming_option(changes_.empty() ? "--problem" : "--problem with --set", read);
    }

private:
    ode::equation_system changed_equations(const std::vector<std::pair<std::string, std::string>>& by_options) const;
    void warn_of_unused(const std::string& written) const;

    const CLI::App* command_ = nullptr;
    std::optional<std::string> problem_;
    std::vector<std::string> changes_;
    std::vector<std::string> shown_;
    std::vector<std::string> limits_;         ///< taken by take_limits()
    std::optional<std::string> with_limits_;  ///< the argument before that
    bool general_ = false;
    bool announced_ = false;  ///< the first of a family has announced what holds for all
    std::shared_ptr<bool> warned_ = std::make_shared<bool>(false);  ///< once for all copies
};

struct family_member {
    std::vector<std::pair<std::string, std::string>> values;
    problem_options problem;
};

}  // namespace libration
