// What the functions of the C interface that search for unknowns have in common.
#pragma once

#include <string>
#include <vector>

#include "guarded.hpp"
#include "libration/number/given_number.hpp"
#include "libration/problem/answer.hpp"

namespace libration::c {

/// Proved digits by integrations whose number is not known: the part that is done is always 0.
inline request watched_digits(long digits, const watcher& watch) {
    request how = proved_digits(given_digits(digits));
    how.reached = [watch](double /*time*/, long /*bits*/) { watch(0.0); };
    return how;
}

/// "f'(5) = 1; y(1) = 2".
inline std::vector<std::string> conditions_of(const std::string& text) {
    std::vector<std::string> conditions;
    for (const auto& [left, right] : settings_of(text, "conditions")) {
        conditions.push_back(left);
        conditions.back().append(" = ").append(right);
    }
    return conditions;
}

}  // namespace libration::c
