// The range of a Taylor model on its box, by dividing the box.
#pragma once

#include "taylor_model.hpp"

namespace libration::ode {

/// A ball that contains x(a) for all a. The part of the box that determines a bound is halved along the variable of the largest
/// terms that are not linear, until these are below 2^-12 of the width, at most 1024 times for each bound: as
/// c_0 + sum |linear c_i| is attained up to the terms that are not linear, the bounds then exceed the range by no more
/// than twice that and the rest.
ball narrow_range(const taylor_model& of);

}  // namespace libration::ode
