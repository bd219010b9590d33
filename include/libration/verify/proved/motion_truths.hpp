// What theta and omega of one motion are compared with.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "libration/pendulum/proved/condition.hpp"
#include "libration/verify/proved/row_question.hpp"

namespace libration::pendulum {

/// The truths of a motion at any times: proved, exact fractions where the start or its image half a period later makes
/// them so. Where one is 0 its scale is the largest |theta| (pi beyond libration) or |omega| of the motion. Not for
/// several threads at once.
class motion_truths {
public:
    /// The numbers of a motion, and the motion that they give.
    motion_truths(typed_motion typed, motion exactly);

    /// theta, and omega for count = 2, at a time. The question holds as long as this. Throws error for a multiple of T
    /// where there is none.
    row_question at(const exact& time, std::size_t count);

private:
    const conditioned_motion& in_precision(long digits);

    typed_motion typed_;
    motion exactly_;
    mpfr theta_scale_;
    mpfr omega_scale_;
    std::vector<std::pair<long, std::unique_ptr<conditioned_motion>>> by_digits_ = {};
};

}  // namespace libration::pendulum
