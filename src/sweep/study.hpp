// What a study is: a question, the parameters that answer it, and a program that makes tables of them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libration/pendulum/energy/period.hpp"
#include "libration/scalar/dispatch.hpp"
#include "option/sweep_energy.hpp"
#include "run/progress.hpp"
#include "text/table.hpp"

namespace libration {

/// A way to T* as it was typed: agm, series:N or resummed:N.
struct sweep_period_rule {
    period_rule rule;
    std::string text;
};

/// Reads one; throws error of the kind argument saying what is wrong.
sweep_period_rule read_period_rule(std::string_view text);

/// What a study is asked for, parsed; what the user left out holds the study's defaults, and a parameter that the study
/// does not have is empty.
struct study_request {
    std::vector<sweep_energy> energies;           ///< --energies and --gaps, by size
    std::vector<int> orders;                      ///< --orders
    std::vector<exact> times;                     ///< --times; multiples of T are allowed
    std::vector<exact> points;                    ///< --points: fractions of T*, 0 the top, 1 the bottom
    std::vector<int> digits;                      ///< --digits
    std::vector<integer> periods;                 ///< --periods: whole numbers
    std::vector<sweep_period_rule> period_rules;  ///< --period-by
    exact step;                                   ///< --step
    std::optional<scalar_spec> scalar;            ///< --scalar; nothing: the scalars that the study takes by itself
    int jobs = 1;
    progress_context shown;  ///< what the progress line says around the study's own part
};

/// A parameter of a study: its option, what it is where the user says nothing, and what it means.
struct study_parameter {
    /// --energies, --gaps, --orders, --times, --points, --digits, --periods, --period-by, --step or --scalar.
    std::string option;
    std::string usual;    ///< in the words of the command line; --gaps may be empty beside --energies
    std::string meaning;  ///< with unit
};

/// One CSV of a study: its name is the study's, with _SUFFIX where there are several.
struct study_table {
    std::string suffix;
    scalar_spec scalar;
    table data;
    bool timed = false;  ///< holds times of this machine: its bytes differ from run to run
};

/// A study; studies/NAME.cpp defines one and studies/NAME.gp draws it from the CSV.
struct study {
    std::string name;
    std::string title;     ///< of its chapter in the report
    std::string label;     ///< the figure of the paper that it regenerates (fig:surf), or empty
    std::string question;  ///< ends in a question mark
    std::string reading;   ///< how to read the figure and what it shows: whole sentences for a reader of the report
    std::vector<study_parameter> parameters;
    std::vector<study_parameter> quick;  ///< (option, words) of a run of a second at most, for the tests
    double seconds;                      ///< with the usual parameters, on two cores
    std::function<std::vector<study_table>(const study_request&)> run;
    arithmetics offers = arithmetics::rounding;  ///< proved_too where it has proofs
};

/// All studies, by name (generated at build time from the files in studies/).
std::vector<const study*> all_studies();

}  // namespace libration
