#include "libration/hybrid/sliding.hpp"

#include <algorithm>

namespace libration::ode {

mode_failure failure_at_surface(const std::vector<side_of_surface>& branches, int order, bool alone) {
    const auto all = [&](int factor) {
        return std::ranges::all_of(
            branches, [&](const side_of_surface& each) { return each.side == 0 || each.sign == factor * each.side; });
    };
    return order == 1 && all(-1) ? mode_failure::sliding
           : alone && all(1)     ? mode_failure::several
                                 : mode_failure::undecided;
}

std::string reason_of(mode_failure failure, const std::string& text) {
    const std::string of = text.empty() ? "" : " of `" + text + "`";
    switch (failure) {
        case mode_failure::sliding:
            return "the solution slides along the surface" + of + ": both branches lead back to it";
        case mode_failure::several: return "the solution can continue on more than one branch" + of;
        case mode_failure::not_continuous:
            return "it is not decided which branch" + of +
                   " follows: a right-hand side is not proved to be continuous about its surface, as that with a root "
                   "of "
                   "what is 0 there";
        case mode_failure::together:
            return "it is not decided which branch" + of +
                   " follows: other conditions change there, too, and solutions on several surfaces are supported only "
                   "where each condition decides separate terms";
        case mode_failure::undecided: break;
    }
    return "it is not decided which branch" + of + " follows: its two sides are equal, or not distinguished";
}

}  // namespace libration::ode
