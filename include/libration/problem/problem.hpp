// A problem as studies see it: a name, and the axes along which it can be varied.
#pragma once

#include <string>
#include <vector>

#include "libration/problem/axis.hpp"

namespace libration {

/// A problem. Its axes stand in the order in which commands are written.
struct problem {
    std::string name;
    std::vector<axis> axes;
};

/// Where a study has no answer: values of a coordinate, and why, as in "has the energy 2, where the period is
/// infinite".
struct without_answer {
    std::string coordinate;
    std::function<bool(const exact&)> at;
    std::string reason;
};

/// The reason why there is no answer at this value of a coordinate; empty where there is one.
std::string reason_against(const std::vector<without_answer>& excluded, const std::string& coordinate,
                           const exact& value);

}  // namespace libration
