// Values of stiff test problems in print, exactly as printed: printed_stiff_states.csv. The values of Enright and Pryce's 30
// problems are those of the routine EVALU, without its zeros.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "../shared/data_table.hpp"

namespace libration::studies::proved {

/// Some unknowns of a problem of the catalogue at a time.
struct printed_state {
    std::string name;
    std::string problem;               ///< its name in the catalogue
    std::vector<std::string> changes;  ///< of parameters
    std::string time;
    std::vector<std::pair<std::string, std::string>> values;  ///< unknowns, and their digits
    std::string source;
};

inline std::vector<printed_state> printed_stiff_states() {
    std::vector<printed_state> all;
    for (const data_row& row : data_table("printed_stiff_states")) {
        if (all.empty() || all.back().name != row.at("name")) {
            all.push_back({row.at("name"),
                           row.at("problem"),
                           parts_of_cell(row.at("changes")),
                           row.at("time"),
                           {},
                           row.at("source")});
        }
        all.back().values.emplace_back(row.at("unknown"), row.at("printed"));
    }
    return all;
}

}  // namespace libration::studies::proved
