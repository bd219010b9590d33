// The values of all solutions from a box of initial values and parameters in spans of time, by theorem V and by Taylor
// models.
#pragma once

#include <vector>

#include "libration/query/sets/solution_sets.hpp"
#include "set_query.hpp"

namespace libration::ode {

/// From the initial point in both directions, as far as the spans require.
class span_question : public set_query {
public:
    span_question(const set_problem& of, std::vector<time_span> spans, long bits, const march_watch& watch,
                  const proof_route& route)
        : set_query(of, bits, watch, route), spans_(std::move(spans)) {}

    set_run_result enclosed_from(const number_box& box, bool with_derivatives) const override;
    set_run_result enclosed_at_times(const number_box& box, bool with_derivatives) const override;
    bool has_spans() const override;
    std::optional<set_run_result> enclosed_by_models(const number_box& box, bool with_derivatives) const override;
    /// Times, not spans from one to another.
    bool is_narrowed(std::size_t image) const override { return is_time(spans_[image]); }

private:
    static bool is_time(const time_span& span) { return (span.to - span.from).sign() == 0; }
    set_run_result linear_from(const number_box& box, bool with_derivatives, bool with_spans) const;
    template <class MakeRun>
    set_run_result enclosed_by(const number_box& box, bool with_derivatives, bool with_spans,
                               const MakeRun& make) const;

    std::vector<time_span> spans_;
};

}  // namespace libration::ode
