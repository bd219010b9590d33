// What a study is: a question, the parameters that answer it, and a program that makes tables of them.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "equation/swept_problem.hpp"
#include "libration/problem/problem.hpp"
#include "run/progress.hpp"
#include "sweep/study_plan.hpp"

namespace libration {

/// What a study is asked for, parsed; what the user left out holds the study's defaults, and an axis that the study
/// does not have is empty.
struct study_request {
    axis_values values;                 ///< of the problem's axes and of the study's own: order, digits, step
    std::optional<scalar_spec> scalar;  ///< --scalar; nothing: the scalars that the study takes by itself
    shared_problem equation = {};       ///< of --problem; null for the study's own problem
    int jobs = 1;
    progress_context shown;  ///< what the progress line says around the study's own part

    std::vector<int> orders() const { return values.counts("order"); }
    std::vector<int> digits() const { return values.counts("digits"); }
    /// Of a march; 0 where the study has none.
    exact step() const { return values.of("step").empty() ? exact{} : values.of("step").front(); }
};

/// A parameter of a study: its option, what it is where the user says nothing, and what it means.
struct study_parameter {
    std::string option;   ///< of an axis of the problem or of study_axes(), or --scalar
    std::string usual;    ///< in the words of the command line; one way to say a coordinate may be empty beside another
    std::string meaning;  ///< with unit
};

/// What a user says to a study: words by option. What is missing is the study's usual value.
using study_words = std::map<std::string, std::string>;

/// The words of --problem and of --set.
struct equation_words {
    std::string problem;
    std::vector<std::string> sets;
};

/// What a study is with --problem P, where that differs from what it is of its own problem.
struct equation_form {
    std::string title = {};                   ///< empty: that of the study
    std::string question = {};                ///< empty: that of the study
    std::string reading = {};                 ///< empty: that of the study
    std::vector<study_parameter> parameters;  ///< besides --problem, --set and --unknowns
    equation_words example;                   ///< what the set `problems` asks,
    study_words example_words = {};           ///< with these parameters
    study_words quick;                        ///< the same, of a second at most
    double seconds;                           ///< of the example, on two cores
};

/// A file by its name and what stands in it.
struct text_file {
    std::string name;
    std::string content;
};

/// A study; NAME.cpp in studies/ or a folder of it defines one and NAME.gp beside it draws it from the CSV. Its members
/// say what it is of its own problem, and any_equation what it is with --problem.
struct study {
    std::string name;
    std::string title;       ///< of its chapter in the report
    std::string label = {};  ///< the figure of the paper that it regenerates (fig:surf), or empty
    std::string question;    ///< ends in a question mark
    /// How to read the figure and what it shows: whole sentences for a reader of the report. Numbers that were measured
    /// stand in {{...}} and are taken from the tables (text/measured_text.hpp).
    std::string reading = {};
    const problem* of = nullptr;  ///< whose axes it has, besides those of every study
    std::vector<study_parameter> parameters = {};
    std::vector<study_parameter> quick = {};    ///< (option, words) of a run of a second at most, for the tests
    double seconds = 0;                         ///< with the usual parameters, on two cores
    std::vector<without_answer> excluded = {};  ///< where it has no answer
    /// The cells that answer the request. Throws input_error for what the study cannot be asked.
    std::function<study_plan(const study_request&)> plan;
    /// Raised when a cell's rows change that were right by its inputs before: journals of others are not used then.
    int version = 1;
    arithmetics offers = arithmetics::rounding;      ///< proved_too where it has proofs
    bool alone = false;                              ///< it measures times: nothing is to run beside it
    std::optional<equation_form> any_equation = {};  ///< nothing where it is of its own problem alone
    std::string script = {};                         ///< SCRIPT.gp draws its figures; empty: NAME.gp
    std::string command = {};  ///< what stands behind `libration study` before its parameters; empty: its name
    /// The equation that it is about, which is an input of every cell; nothing for the pendulum.
    shared_problem equation = {};
    /// Further files of its folder, made of its tables; their names are none of a table or a figure. Empty: none.
    std::function<std::vector<text_file>(const std::vector<study_table>&)> files = {};

    /// Whether it has no problem of its own.
    bool needs_equation() const { return parameters.empty() && any_equation; }
};

/// All studies, by name (generated at build time from the files in studies/).
std::vector<const study*> all_studies();
/// Those that run without --problem.
std::vector<const study*> studies_of_own_problems();

}  // namespace libration
