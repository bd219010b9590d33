// A family of problems as studies see it: a name, and the axes along which it is varied.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "libration/problem/axis.hpp"

namespace libration {

/// The axes are in the order in which commands are written.
struct problem_family {
    std::string name;
    std::vector<axis> axes;
};

/// Values of a coordinate for which a study is not defined, and the reason, as in "has the energy 2, where the period
/// is infinite".
struct without_answer {
    std::string coordinate;
    std::function<bool(const exact&)> at;
    std::string reason;
};

/// The reason why a study is not defined at this value of a coordinate; empty if it is defined.
std::string reason_against(const std::vector<without_answer>& excluded, const std::string& coordinate,
                           const exact& value);

}  // namespace libration
