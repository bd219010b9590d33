// The true values with which the unknowns of a problem with events or piecewise right-hand sides are compared.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <vector>

#include "libration/equation/hybrid_system.hpp"
#include "libration/hybrid/hybrid_path.hpp"
#include "libration/number/exact.hpp"
#include "libration/verification/row_question.hpp"

namespace libration::ode {

/// The true values of such a problem at times from its initial point on, proved (hybrid_path): at the time of an event
/// those after it, and at a time that is not distinguished from that of an event both, of which a jump leaves no digits.
/// There are no condition numbers and no slopes. Increasing times share the integrations. Not for several threads at
/// once.
class hybrid_truths {
public:
    /// The values with these indices of names_of_state(system), which must outlive this object.
    hybrid_truths(const hybrid_system& system, std::vector<std::size_t> places);
    ~hybrid_truths();

    /// The values at a time. The question uses this object and is valid for its lifetime; its truths throw error for a
    /// time that the solution is not proved to reach, or before the initial point.
    row_question at(const exact& time);

private:
    struct followed_path;

    std::vector<ball> state(const exact& time, long digits);
    std::vector<true_value> truths_at(const exact& time, long digits);

    const hybrid_system& system_;
    std::vector<std::size_t> places_;
    std::map<long, std::unique_ptr<followed_path>> by_digits_;
};

}  // namespace libration::ode
