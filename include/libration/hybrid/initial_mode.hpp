// The values of the step functions at the beginning of a branch: theorem H, "Step functions".
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "libration/equation/hybrid_system.hpp"
#include "libration/hybrid/sliding.hpp"

namespace libration::ode {

class branch_beginning;

/// The values of all step functions directly after the beginning of a branch, or the first that is not decided.
struct initial_mode {
    std::optional<step_values> values = {};
    /// The signs that are 0 along the branch and on which its right-hand side depends there: the relation as written, or
    /// sign(0) = 0, decides.
    std::vector<std::size_t> by_relation = {};
    mode_failure failure = mode_failure::undecided;
    std::size_t step = 0;

    /// Of the failure, for messages.
    std::string reason(const hybrid_system& system) const { return reason_of(failure, system.steps()[step].text); }
};

/// The function that decides all of them, at the initial point and after each event. A step function whose argument
/// does not contain steps that are not yet found has the value
/// (1) of its argument, if that is a number, or consists of values that nothing changes on a branch
///     (hybrid_system::is_kept) and that are known exactly;
/// (2) of its argument at (t*, a), if that is proved not to be 0 (an integer, for a floor);
/// (3) of the strict sign that the derivative of order k of its argument has at (t*, a) along the branches of all lists
///     of values that are possible there, if the derivatives of lower orders are 0 there and, where its argument u is 0,
///     the same on all of these branches;
/// (4) 0, if in (3) a derivative is 0 wherever u is, on all of these branches, and no other argument contains this step:
///     u is 0 along the solution.
/// If only signs are left, no step is 0 by (4), no other argument contains one of them, the slopes are sums of what each of
/// them decides, and the part of each where its argument u is 0 is that of a side or the mean of both, they are found one
/// after the other, where the derivative of u does not depend on those still left:
/// (5) sliding_value(), if the derivative of u above the surface is negative or 0 wherever u is, and below it positive or 0
///     wherever u is, not both 0; of a function of the time alone by its sign directly after t*;
/// (6) 1, if the derivative of u is positive below the surface and 0 above it at (t*, a), and its derivative on the
///     branch above is positive; -1 likewise. Also the sign that the derivative has on both sides.
/// Theorem H proves that the branch with these values contains the only solution. `before` are the values on the
/// branch before an event, for arguments of which it is known that they are not 0 at the event: those that neither the
/// event nor a resulting change of step functions changes. Each value is then verified on the branch that is entered.
initial_mode mode_after(const branch_beginning& beginning, const std::optional<step_values>& before = std::nullopt,
                        const std::vector<std::size_t>& crossed = {});

/// Those at the initial point. Throws error of the kind undecided if they are not known.
initial_mode mode_at_start(const hybrid_system& system);
inline step_values values_at_start(const hybrid_system& system) { return *mode_at_start(system).values; }

}  // namespace libration::ode
