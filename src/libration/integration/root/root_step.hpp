// Steps across a time with roots, in a root of the distance from it.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "../taylor/series_step.hpp"
#include "libration/digits/precision_loop.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/integration/rule.hpp"
#include "root_time.hpp"

namespace libration::ode {

/// The way past a time tau with roots, or from it on, in w, t = tau + side w^degree.
struct root_passage {
    root_time about;
    int direction = 1;                       ///< of w
    ball begins, ends;                       ///< exact values of w
    bool leads_beyond = false;               ///< the solution continues in t after the passage
    std::vector<expression> leaves, slopes;  ///< the slopes dy/dt in w
    std::shared_ptr<step_rule> rule;         ///< in w

    /// side w^degree, exactly for an exact w.
    ball raised(const ball& w) const;
    /// w at a distance from tau: of those on the side without roots, as at tau.
    ball root_of(const ball& distance) const;
    /// The time of w.
    ball time_of(const ball& w) const;
};

/// The state in w, with w as its time.
struct root_state : carried {
    root_state(std::shared_ptr<const root_passage> by, flow_state in_root, bool moved)
        : passage(std::move(by)), inner(std::move(in_root)), has_moved(moved) {}

    std::shared_ptr<const root_passage> passage;
    flow_state inner;
    bool has_moved;  ///< since the beginning of the passage
};

/// A state of a passage, from that in w.
flow_state state_in_root(std::shared_ptr<const root_passage> passage, flow_state inner, bool has_moved);

/// The part of a step in t that leads to where a passage is to begin, because it is short as roots are ahead.
class root_entry : public series_step {
public:
    /// At a distance that is exact unless tau is not a dyadic number; the length is not shorter.
    root_entry(const series_step& whole, const ball& distance, std::shared_ptr<const root_passage> passage);

    flow_state end() const override;

private:
    std::shared_ptr<const root_passage> passage_;
};

/// A step from w to w + h is a step in t of the length |(w + h)^degree - w^degree|, which is exact, as w and h are. If the
/// roots are not real beyond tau it ends there at the latest.
class root_step : public step {
public:
    root_step(const flow_state& from, const root_state& at, std::shared_ptr<const step> inner);

    /// Whether it ends at tau, beyond which the roots are not real.
    bool is_last() const { return is_last_; }
    std::vector<ball> values(const ball& distance) const override;
    std::vector<ball> slopes(const ball& distance) const override;
    ball_matrix derivative(const ball& distance) const override;
    flow_state end() const override;
    ball end_time() const override { return end_time_; }

private:
    root_step(const flow_state& from, const root_state& at, std::shared_ptr<const step> inner, const ball& last);
    ball root_at(const ball& distance) const;
    std::vector<ball> values_in_root(const ball& w) const { return inner_->values(w - inner_->from().time); }
    std::vector<ball> slopes_in_root(const ball& w, const std::vector<ball>& state) const;

    std::shared_ptr<const root_passage> passage_;
    std::shared_ptr<const step> inner_;
    bool is_last_;
    ball end_time_;
};

}  // namespace libration::ode
