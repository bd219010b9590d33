// What a study is: a question, the parameters that answer it, and a program that makes tables of them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "libration/pendulum/motion.hpp"
#include "libration/scalar/dispatch.hpp"
#include "sweep/table.hpp"

namespace libration {

/// An energy of a sweep as it was typed: E itself, or the gap 2 - E.
struct sweep_energy {
    std::string energy;  ///< as typed, or 2 - gap: exact as a decimal or a short fraction, else to 50 digits
    std::string gap;     ///< likewise
    rational value;      ///< E
};

/// The energy E, or the one that a gap means. Throws std::invalid_argument for what is not an energy (negative, with pi).
sweep_energy energy_from(const exact& energy);
sweep_energy energy_from_gap(const exact& gap);

/// What a study is asked for, parsed; what the user left out holds the study's defaults.
struct study_request {
    std::vector<sweep_energy> energies;
    std::vector<int> orders;
    std::optional<scalar_spec> scalar;  ///< nothing: the scalars that the study takes by itself
    int jobs = 1;
};

/// The defaults of a study, in the words of the command line; empty where the study has no such parameter.
struct study_defaults {
    std::string energies;
    std::string gaps;
    std::string orders;
    std::string scalars;
};

/// One CSV of a study: its name is the study's, with _SUFFIX where there are several.
struct study_table {
    std::string suffix;
    scalar_spec scalar;
    table data;
};

/// A study; studies/NAME.cpp defines one and studies/NAME.gp draws it from the CSV.
struct study {
    std::string name;
    std::string question;
    study_defaults defaults;
    std::string cost;
    std::function<std::vector<study_table>(const study_request&)> run;
};

/// All studies, by name (generated at build time from the files in studies/).
std::vector<const study*> all_studies();

}  // namespace libration
