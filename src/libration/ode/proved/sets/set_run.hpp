// The values of all solutions from a box of initial values and parameters in spans of time, by theorem V.
#pragma once

#include <vector>

#include "libration/ode/proved/sets/solution_sets.hpp"
#include "set_question.hpp"

namespace libration::ode {

/// From the initial point in both directions, as far as the spans require.
class span_question : public set_question {
public:
    span_question(const set_problem& of, std::vector<time_span> spans, long bits, const march_watch& watch,
                  const proof_route& route)
        : set_question(of, bits, watch, route), spans_(std::move(spans)) {}

    set_run_result enclosed_from(const number_box& box, bool with_derivatives) const override;
    /// Times, not spans from one to another.
    bool is_narrowed(std::size_t image) const override { return (spans_[image].to - spans_[image].from).sign() == 0; }

private:
    std::vector<time_span> spans_;
};

}  // namespace libration::ode
