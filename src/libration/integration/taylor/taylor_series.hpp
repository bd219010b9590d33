// The series of theorem V about a state, which a step keeps.
#pragma once

#include <cstddef>
#include <mutex>
#include <vector>

#include "libration/expansion/ball_expansion.hpp"
#include "libration/expansion/tail_bound.hpp"
#include "libration/integration/lohner_set.hpp"
#include "libration/integration/taylor/step_length.hpp"

namespace libration::ode {

/// The series of the centre c of a set with their tails and, in low precision, those of the whole set with the variations
/// of the flow. Distances are within the radii of both tails.
struct taylor_series {
    /// Of the given unknowns.
    std::vector<series::power_series<ball>> centre;
    tail_bound tail;
    /// Of the derivatives of the given unknowns by each other.
    std::vector<std::vector<series::power_series<ball>>> variations;
    tail_bound set_tail;
    variation_places places;
    long bits = 0, set_bits = 0;  ///< of the centre and of the variations
    lohner_set errors;            ///< of the set
    magnitude length;             ///< up to which it is used

    /// The unknowns of the solution through c.
    std::vector<ball> flow_of_centre(const ball& distance) const;
    /// The derivative of the flow with respect to the state at the beginning, for every point of the set.
    ball_matrix derivative_of_flow(const ball& distance) const;
    /// The unknowns of every solution through the set, at every distance of a ball.
    std::vector<ball> values(const ball& distance) const;

private:
    const std::vector<magnitude>& reaches() const;

    mutable std::vector<magnitude> reaches_;  // of the errors at every distance up to the length
    mutable std::once_flag has_reaches_;
};

}  // namespace libration::ode
