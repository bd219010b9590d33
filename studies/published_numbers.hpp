// Numbers that the literature prints about problems with asymptotic approximants, exactly as printed:
// published_numbers.csv.
#pragma once

#include <string>
#include <vector>

#include "shared/data_table.hpp"

namespace libration::studies {

/// A printed number: its problem, the changes of the problem's text, and the name of the quantity in far_behaviour.
struct published_number {
    std::string problem;
    std::vector<std::string> changes;
    std::string free;  ///< the unknown parameter, if it is not the initial value
    std::string quantity;
    int known = 0;  ///< coefficients that the approximant uses to predict it; 0: of the solution itself
    std::string printed;
    std::string source;
};

inline std::vector<published_number> published_numbers(const std::string& problem) {
    std::vector<published_number> of_problem;
    for (const data_row& row : data_table("published_numbers")) {
        if (row.at("problem") == problem) {
            of_problem.push_back({problem, parts_of_cell(row.at("changes")), row.at("free"), row.at("quantity"),
                                  std::stoi(row.at("known")), row.at("printed"), row.at("source")});
        }
    }
    return of_problem;
}

}  // namespace libration::studies
