// A study: a question, its parameters, and the code that computes its tables.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "libration/problem/problem_family.hpp"
#include "problem/swept_problem.hpp"
#include "run/progress.hpp"
#include "sweep/study_plan.hpp"

namespace libration {

/// The parsed parameters of a study, with the study's defaults for those that were not given; an axis that the study
/// does not have is empty.
struct study_request {
    axis_values values;                 ///< of the problem's axes and of the study's own: order, digits, step
    std::optional<scalar_spec> scalar;  ///< --scalar; std::nullopt: the scalars that the study uses by default
    /// The others of a list of --scalar, for a study with `several_scalars`: the first one is the most precise.
    std::vector<scalar_spec> further_scalars = {};
    shared_problem equation = {};  ///< of --problem; null for the study's own problem
    int jobs = 1;
    progress_context shown;  ///< what the progress line prints around the study's own part

    std::vector<int> orders() const { return values.counts("order"); }
    std::vector<int> digits() const { return values.counts("digits"); }
    /// Of an integrator; 0 if the study has none.
    exact step() const { return values.of("step").empty() ? exact{} : values.of("step").front(); }
};

/// A parameter of a study: its option, its default, and its meaning.
struct study_parameter {
    std::string option;     ///< of an axis of the problem or of study_axes(), or --scalar
    std::string usual;      ///< as on the command line; may be empty if another option sets the same coordinate
    std::string meaning;    ///< with unit
    bool required = false;  ///< the study rejects a request without it

    /// The default for readers: "required" or "none" if it has none.
    std::string usual_text() const { return !usual.empty() ? usual : required ? "required" : "none"; }
};

/// The arguments of a study by option. Missing ones have the study's default values.
using study_words = std::map<std::string, std::string>;

/// The arguments of --problem and of --set.
struct equation_words {
    std::string problem;
    std::vector<std::string> sets;
};

/// A study with --problem P, where it differs from the study of its own problem.
struct equation_form {
    std::function<study_plan(const study_request&)> plan;  ///< as study::plan; the request has an equation
    std::string title = {};                                ///< empty: that of the study
    std::string question = {};                             ///< empty: that of the study
    std::string reading = {};                              ///< empty: that of the study
    std::vector<study_parameter> parameters;               ///< in addition to --problem, --set and --unknowns
    equation_words example;                                ///< as in the set `problems`,
    study_words example_words = {};                        ///< with these parameters
    study_words quick;                                     ///< the same, for a run of at most one second
    double seconds;                                        ///< of the example, on two cores
    bool at_infinity = false;                              ///< whether the text may have conditions at infinity
    /// Lines about the tables, for stderr. Empty: none.
    std::function<std::vector<std::string>(const std::vector<study_table>&)> remarks = {};
};

/// A file: its name and its content.
struct text_file {
    std::string name;
    std::string content;
};

/// A study; NAME.cpp in studies/ or a subdirectory defines one and NAME.gp next to it draws it from the CSV. Its
/// members describe the study of its own problem, and any_equation that with --problem.
struct study {
    std::string name;
    std::string title;       ///< of its chapter in the report
    std::string label = {};  ///< the figure of the paper that it regenerates (fig:surf), or empty
    std::string question;    ///< ends in a question mark
    /// How to read the figure and what it shows: whole sentences for a reader of the report. Measured numbers are
    /// written as {{...}} and are taken from the tables (text/measured_text.hpp).
    std::string reading = {};
    const problem_family* of = nullptr;  ///< whose axes it has, in addition to those of every study
    std::vector<study_parameter> parameters = {};
    std::vector<study_parameter> quick = {};    ///< (option, argument) of a run of at most one second, for the tests
    double seconds = 0;                         ///< with the default parameters, on two cores
    std::vector<without_answer> excluded = {};  ///< where it has no result
    /// The cells for the request. Throws input_error for requests that the study does not support. Empty: it requires
    /// --problem.
    std::function<study_plan(const study_request&)> plan = {};
    /// Incremented when a cell's rows change for the same inputs: journals of other versions are then not used.
    int version = 1;
    arithmetics offers = arithmetics::rounding;      ///< proved_too if it supports proofs
    bool several_scalars = false;                    ///< --scalar may be a list
    bool alone = false;                              ///< it measures times: nothing may run at the same time
    std::optional<equation_form> any_equation = {};  ///< std::nullopt if it supports only its own problem
    std::string script = {};                         ///< SCRIPT.gp draws its figures; empty: NAME.gp
    std::string command = {};  ///< what follows `libration study` before its parameters; empty: its name
    /// Its equation, which is an input of every cell; null for the pendulum.
    shared_problem equation = {};
    /// Further files of its directory, made from its tables; their names differ from those of tables and figures.
    /// Empty: none.
    std::function<std::vector<text_file>(const std::vector<study_table>&)> files = {};
    /// equation_form::remarks.
    std::function<std::vector<std::string>(const std::vector<study_table>&)> remarks = {};

    /// Whether it lacks its own problem and requires --problem.
    bool needs_equation() const { return !plan && any_equation; }
};

/// All studies, by name (generated at build time from the files in studies/).
std::vector<const study*> all_studies();
/// Those that run without --problem.
std::vector<const study*> studies_of_own_problems();

}  // namespace libration
