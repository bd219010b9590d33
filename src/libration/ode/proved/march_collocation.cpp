// The parts of proved_march that concern the change between Taylor series and collocation, and the reports of steps.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "../rigorous/lifted_set.hpp"
#include "../rigorous/matrix/dense_matrix.hpp"
#include "collocation_phase.hpp"
#include "libration/ode/proved/proved_march.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

// log2 of the largest of |radius/midpoint|.
double log2_of_relative_width(const std::vector<ball>& centre, const std::vector<magnitude>& reach) {
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < reach.size(); ++i) {
        if (!reach[i].is_zero()) {
            const magnitude least = magnitude::below(centre[i]);
            most = std::max(
                most, least.is_zero() ? std::numeric_limits<double>::infinity() : log_of(reach[i]) - log_of(least));
        }
    }
    return most;
}

}  // namespace

void proved_march::require_integrator() const {
    if (route_.integrator != integrator_choice::collocation) {
        return;
    }
    if (const std::string reason = collocation_->obstacle(); !reason.empty()) {
        throw error(error_kind::argument, "integrator", "collocation", reason + ": use automatic or taylor");
    }
}

bool proved_march::begins_collocation(const proved_step& step, const ball& rest) {
    if (derivative_ || !collocation_->may_begin(steps_, step.length(), rest) ||
        !collocation_->begin(steps_, time_, set_, step.length(), rest)) {
        return false;
    }
    used_ = false;
    return true;
}

std::vector<ball> proved_march::values_by_collocation(const ball& distance) {
    use_step(1);
    collocation_->reach(as_double(time_ + distance));
    const collocation_integrator& integrator = collocation_->integrator();
    std::vector<ball> values = integrator.values_at(distance);
    values.resize(lifted_.given);
    return values;
}

void proved_march::step_of_collocation() {
    use_step(1);
    count_steps(collocation_->cost_of_step());
    const bool continues = collocation_->step(steps_);
    time_ = collocation_->integrator().reached();
    used_ = false;
    if (!continues || loses_an_unknown(collocation_->integrator().set())) {
        end_collocation();
    }
}

// By the state alone, also for an unknown near 0; the next step of Taylor series decides.
bool proved_march::loses_an_unknown(const state_set& set) const {
    std::vector<magnitude> reach;
    for (std::size_t i = 0; i < lifted_.given; ++i) {
        reach.push_back(set.reach(i));
    }
    return scales_.may_be_lost(set.centre, reach, widest_set);
}

void proved_march::end_collocation() {
    auto set = set_of_first(lifted_.given, collocation_->integrator().set());
    if (!set) {
        throw precision_exhausted("an error set");
    }
    set_ = std::move(*set);
    now_->ready_ = false;
    used_ = false;
    collocation_->end();
}

const collocation_use& proved_march::collocation() const { return collocation_->all(); }

// Once for each step; the direction is that of Taylor series, of which it is not a part.
void proved_march::use_step(int direction) {
    if (used_) {
        return;
    }
    used_ = true;
    if (collocation_->is_active()) {
        collocation_->use();
    }
    if (observer_) {
        observer_(report_of_step(direction));
    }
}

step_report proved_march::report_of_step(int direction) const {
    if (collocation_->is_active()) {
        const collocation_integrator& by = collocation_->integrator();
        std::vector<magnitude> reach;
        for (std::size_t i = 0; i < lifted_.given; ++i) {
            reach.push_back(by.set().reach(i));
        }
        return {as_double(time_), as_double(by.length()),   by.bits(),
                by.degree(),      step_method::collocation, log2_of_relative_width(by.set().centre, reach)};
    }
    std::vector<magnitude> reach;
    for (std::size_t i = 0; i < set_.centre.size(); ++i) {
        reach.push_back(set_.reach(i));
    }
    const double length = as_double(now_->length().exact());
    return {as_double(time_),    direction < 0 ? -length : length,          now_->bits(), now_->order(),
            step_method::taylor, log2_of_relative_width(set_.centre, reach)};
}

}  // namespace libration::ode
