// What a connection proves, as notes of an answer.
#pragma once

#include <vector>

#include "libration/problem/answer.hpp"
#include "libration/query/connection/connection.hpp"

namespace libration {

/// "proved" and, if anything is left open, "not claimed".
inline std::vector<answer_note> notes_of(const ode::connection& found) {
    std::vector<answer_note> notes{{"proved", found.proved}};
    if (!found.not_claimed.empty()) {
        notes.push_back({"not claimed", found.not_claimed});
    }
    return notes;
}

}  // namespace libration
