#include "libration/problem/problem_family.hpp"

namespace libration {

std::string reason_against(const std::vector<without_answer>& excluded, const std::string& coordinate,
                           const exact& value) {
    for (const without_answer& each : excluded) {
        if (each.coordinate == coordinate && each.at(value)) {
            return each.reason;
        }
    }
    return "";
}

}  // namespace libration
