// The motions of tests/reference/motions.csv as options of the command.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "reference_table.hpp"

namespace libration::tests {

/// A motion as options, and its rows: one per time, all with the same period.
struct reference_motion {
    std::vector<std::string> options;
    std::vector<table_row> rows;

    /// --times with the times of all rows.
    std::string times() const {
        std::string list = "--times=";
        for (const table_row& row : rows) {
            list += (list.back() == '=' ? "" : ",") + row.at("time");
        }
        return list;
    }
};

/// All motions of the table, in its order.
inline std::vector<reference_motion> reference_motions() {
    std::vector<reference_motion> motions;
    for (const table_row& row : reference_table("motions.csv")) {
        std::vector<std::string> options;
        for (const std::string name : {"energy", "gap", "theta0", "omega0", "direction"}) {
            if (!row.at(name).empty()) {
                options.insert(options.end(), {"--" + name, row.at(name)});
            }
        }
        if (motions.empty() || motions.back().options != options) {
            motions.push_back({options, {}});
        }
        motions.back().rows.push_back(row);
    }
    return motions;
}

/// The motion given by this energy alone; throws std::runtime_error if the table has none.
inline reference_motion reference_motion_of(const std::string& energy) {
    for (const reference_motion& motion : reference_motions()) {
        if (motion.options == std::vector<std::string>{"--energy", energy}) {
            return motion;
        }
    }
    throw std::runtime_error("motions.csv has no energy " + energy);
}

}  // namespace libration::tests
