// Bounds of values that are monotone in some numbers of a box.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "set_query.hpp"

namespace libration::ode {

/// The extreme values of a function that is monotone in some numbers of a box: those on one face, where each of
/// these numbers is at an end.
class box_faces {
public:
    /// Both must outlive it.
    box_faces(const number_box& whole, const set_query& question) : whole_(whole), question_(question) {}

    /// Narrows the bounds of an image, by its derivatives.
    void narrow(set_image& known, std::size_t image);

    /// The faces that were enclosed, and the steps of these runs.
    std::size_t size() const { return runs_.size(); }
    long steps() const { return steps_; }

private:
    const closed_interval* value_on(const std::vector<ball>& derivatives, int side, std::size_t image,
                                    std::size_t value);
    const set_run_result& run_on(const std::vector<int>& ends);

    const number_box& whole_;
    const set_query& question_;
    std::map<std::vector<int>, set_run_result> runs_;  // by the end of each number, 0 for the whole side
    long steps_ = 0;
};

}  // namespace libration::ode
