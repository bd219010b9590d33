// The true values with which theta and omega of one motion are compared.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "libration/pendulum/condition.hpp"
#include "libration/verification/row_question.hpp"

namespace libration::pendulum {

/// The true values of a motion at any times: proved, and exact fractions if those of the start or of its image half a
/// period later are. If one is 0 its scale is the largest |theta| (pi beyond libration) or |omega| of the motion. Not
/// for several threads at once.
class motion_truths {
public:
    /// The numbers of a motion, and the motion defined by them.
    motion_truths(typed_motion typed, motion exactly);

    /// theta, and omega for count = 2, at a time. The question is valid for the lifetime of this object. Throws error
    /// for a multiple of T if T is infinite.
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
