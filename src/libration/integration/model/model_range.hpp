// The range of a Taylor model on its box, by dividing the box.
#pragma once

#include <optional>

#include "libration/expansion/step_pieces.hpp"
#include "taylor_model.hpp"

namespace libration::ode {

/// At times, of which there are few.
inline constexpr long log2_of_excess_at_times = -12;

/// Bounds of a range that are narrow enough, exact.
struct enough_bounds {
    ball lower, upper;

    /// The bounds of numbers that are to be widened by so much afterwards.
    enough_bounds before_widening(const magnitude& by) const {
        return {upper_bound(lower + by.exact()), lower_bound(upper - by.exact())};
    }
};

/// A ball that contains x(a) for all a. The part of the box that determines a bound is halved along the variable of the largest
/// terms that are not linear, until these are below 2^log2_of_excess of the width, at most 2^-log2_of_excess and 1024
/// times for each bound: as c_0 + sum |linear c_i| is attained up to the terms that are not linear, the bounds then exceed
/// the range by no more than twice that and the rest. A bound that is narrow enough is not improved.
/// log2_of_excess < 0.
ball narrow_range(const taylor_model& of, long log2_of_excess, const std::optional<enough_bounds>& enough);

}  // namespace libration::ode
