// The parts of proved_march that concern the change between Taylor series and collocation, and the reports of steps.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "../algebra/dense_matrix.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "lifted_set.hpp"
#include "method_choice.hpp"
#include "root/root_rule.hpp"

namespace libration::ode {

namespace {

// log2 of the largest of |radius/midpoint|.
double log2_of_relative_width(const std::vector<ball>& hull) {
    double most = -std::numeric_limits<double>::infinity();
    for (const ball& each : hull) {
        const magnitude reach = magnitude::radius_of(each);
        if (!reach.is_zero()) {
            const magnitude least = magnitude::below(midpoint_alone(each));
            most = std::max(most,
                            least.is_zero() ? std::numeric_limits<double>::infinity() : log_of(reach) - log_of(least));
        }
    }
    return most;
}

}  // namespace

void proved_march::require_integrator() const {
    if (route_.integrator != integrator_choice::collocation) {
        return;
    }
    if (const std::string reason = collocation_->obstacle(derivative_.has_value()); !reason.empty()) {
        throw error(error_kind::argument, "integrator", "collocation", reason + ": use automatic or taylor");
    }
}

bool proved_march::begins_collocation(const proved_step& step, const ball& rest) {
    if (!collocation_->may_begin(steps_, step.length(), rest, derivative_.has_value())) {
        return false;
    }
    const bool has_more_columns = set_.errors.columns().size() > set_.centre.size();
    const auto set = has_more_columns ? set_of_first(set_.centre.size(), set_) : std::optional(set_);
    if (!set || !collocation_->begin(steps_, time_, *set, step.length(), rest, derivative_.has_value())) {
        return false;
    }
    used_ = false;
    return true;
}

const enclosed_step* proved_march::prepare_towards(const ball& rest) {
    const int direction = arb_is_negative(rest.handle()) != 0 ? -1 : 1;
    if (roots_) {
        roots_->drop_entry();
    }
    if (roots_ && roots_->is_active()) {
        if (roots_->leads_towards(direction)) {
            return roots_->prepare() ? roots_.get() : static_cast<const enclosed_step*>(stopped(roots_->end()));
        }
        leave_roots();
    }
    if (collocation_->is_active()) {
        if (!contains_zero(rest) && collocation_->prepare()) {
            return collocation_.get();
        }
        end_collocation();
    }
    const proved_step* const step = prepare();
    if (step == nullptr || step->reaches(rest)) {
        return step;
    }
    if (const enclosed_step* const entry = roots_ ? roots_->entry(time_, *step, direction) : nullptr) {
        return entry;
    }
    return begins_collocation(*step, rest) ? static_cast<const enclosed_step*>(collocation_.get()) : step;
}

void proved_march::enter_roots(int direction) {
    use_step(direction);
    move(*now_, roots_->prepared_entry()->distance());
    roots_->begin(set_, derivative_.has_value());
    if (scales_.accepts_any_width()) {
        roots_->accept_any_width();
    }
    time_ = roots_->time();
    count_steps(1);
}

void proved_march::step_in_root(int direction) {
    use_step(direction);
    roots_->step();
    time_ = roots_->time();
    used_ = false;
    count_steps(1);
}

void proved_march::leave_roots() {
    set_ = roots_->set();
    if (derivative_) {
        derivative_ = product(roots_->derivative(), *derivative_);
    }
    if (now_) {
        now_->ready_ = false;
    }
    used_ = false;
    roots_->leave();
}

void proved_march::use_prepared(const ball& time, int direction) {
    use_step(direction);
    collocation_->reach(time);
}

void proved_march::take_prepared(int direction) {
    if (roots_ && roots_->is_active()) {
        step_in_root(direction);
    } else if (roots_ && roots_->prepared_entry()) {
        enter_roots(direction);
    } else if (collocation_->is_active()) {
        step_of_collocation();
    } else {
        take(*now_, direction);
    }
}

void proved_march::step_of_collocation() {
    use_step(1);
    count_steps(collocation_->cost_of_step());
    const bool continues = collocation_->step(steps_);
    time_ = collocation_->integrator().reached();
    used_ = false;
    if (!continues || loses_an_unknown(collocation_->hull())) {
        end_collocation();
    }
}

// By the state alone, also for an unknown near 0; the next step of Taylor series decides.
bool proved_march::loses_an_unknown(const std::vector<ball>& hull) const {
    std::vector<ball> centre;
    std::vector<magnitude> reach;
    for (const ball& each : hull) {
        centre.push_back(midpoint_alone(each));
        reach.push_back(magnitude::radius_of(each));
    }
    return scales_.may_be_lost(centre, reach, widest_set);
}

void proved_march::end_collocation() {
    auto set = collocation_->set();
    if (!set) {
        throw precision_exhausted("an error set");
    }
    set_ = std::move(*set);
    if (derivative_) {
        derivative_ = product(collocation_->derivative(), *derivative_);
    }
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
    if (roots_ && roots_->is_active()) {
        const double length = as_double(roots_->length_of_step());
        return {as_double(time_),          direction < 0 ? -length : length,
                roots_->prepared().bits(), roots_->prepared().order(),
                step_method::taylor,       log2_of_relative_width(roots_->set().hull())};
    }
    if (collocation_->is_active()) {
        const collocation_integrator& by = collocation_->integrator();
        return {as_double(time_), as_double(by.length()),   by.bits(),
                by.degree(),      step_method::collocation, log2_of_relative_width(collocation_->hull())};
    }
    const double length = as_double(now_->length().exact());
    return {as_double(time_),    direction < 0 ? -length : length,   now_->bits(), now_->order(),
            step_method::taylor, log2_of_relative_width(set_.hull())};
}

}  // namespace libration::ode
