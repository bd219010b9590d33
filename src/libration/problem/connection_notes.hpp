// What a connection proves, as notes of an answer.
#pragma once

#include <vector>

#include "libration/problem/answer.hpp"
#include "libration/query/connection/connection.hpp"

namespace libration {

/// "proved"; if anything is left open, "not claimed"; and "phase" of an orbit with two ends.
inline std::vector<answer_note> notes_of(const ode::connection& found) {
    std::vector<answer_note> notes{{"proved", found.proved}};
    if (!found.not_claimed.empty()) {
        notes.push_back({"not claimed", found.not_claimed});
    }
    if (!found.phase.empty()) {
        notes.push_back({"phase", found.phase});
    }
    return notes;
}

}  // namespace libration
