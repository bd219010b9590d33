#include "libration/integration/rule_for.hpp"

#include <optional>
#include <stdexcept>
#include <utility>

#include "../expansion/set_values.hpp"
#include "first_step.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/integration/singular_step.hpp"
#include "method_choice.hpp"
#include "root/root_rule.hpp"

namespace libration::ode {

namespace {

// Then the first steps are those of a root_rule.
bool begins_at_root(const explicit_system& system) { return system.singular() && system.singular()->root > 1; }

// A singular initial point, times with roots, and the choice of a method elsewhere, in this order.
class nested_rule : public step_rule {
public:
    nested_rule(const explicit_system& of, const run_bits& bits, const proof_route& route, error_weights weights);

    void begin(const flow_state& start) override;
    next_step next(const flow_state& from, const ball& rest) override;

private:
    next_step next_at_start(const flow_state& from, int direction);
    next_step counted(next_step made);
    void require_given_start(const flow_state& start) const;

    explicit_system of_;
    run_bits bits_;
    proof_route route_;
    std::optional<singular_step> singular_;  // the first step from a singular initial point without roots
    std::unique_ptr<method_choice> regular_;
    std::unique_ptr<root_rule> roots_;                   // if there are times with roots
    std::shared_ptr<const root_passage> first_passage_;  // if one of them is the initial point
    bool at_start_ = true;
};

nested_rule::nested_rule(const explicit_system& of, const run_bits& bits, const proof_route& route,
                         error_weights weights)
    : of_(of), bits_(bits), route_(route) {
    if (of.singular() && !begins_at_root(of)) {
        singular_ = proved_singular_step(of, bits.bits, route);
    }
    const explicit_system regular = begins_at_root(of) ? first_order_form(of).about_points(of.point())
                                    : singular_        ? singular_->beyond
                                                       : of;
    regular_ = std::make_unique<method_choice>(
        lifted(regular, relative_functions::kept), bits, route, weights,
        [this](const series_step& whole, int direction) { return roots_ ? roots_->entry(whole, direction) : nullptr; });
    if (auto times = root_times(regular); !times.empty() || begins_at_root(of)) {
        roots_ = std::make_unique<root_rule>(begins_at_root(of) ? of : regular, std::move(times), bits, route, weights);
    }
    if (!roots_) {
        regular_->allow_boxes(regular);
    }
    first_passage_ = begins_at_root(of) ? roots_->passage_from_start(of) : nullptr;
    regular_->require_integrator(false);
}

// Theorem S begins from the initial values of the system alone. lifted() throws the error of a singular point.
void nested_rule::require_given_start(const flow_state& start) const {
    const auto given = start_of(of_, bits_.bits).set.hull();
    const auto found = start.set.hull();
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (arb_equal(given[i].handle(), found[i].handle()) == 0) {
            lifted(of_, relative_functions::kept);
            throw std::logic_error("a set about a singular initial point");
        }
    }
}

void nested_rule::begin(const flow_state& start) {
    if (of_.singular()) {
        require_given_start(start);
    }
    regular_->begin(start);
    at_start_ = of_.singular().has_value();
}

next_step nested_rule::next(const flow_state& from, const ball& rest) {
    const int direction = arb_is_negative(rest.handle()) != 0 ? -1 : 1;
    if (std::exchange(at_start_, false)) {
        return counted(next_at_start(from, direction));
    }
    if (dynamic_cast<const root_state*>(from.more.get()) == nullptr) {
        return regular_->next(from, rest);
    }
    return root_rule::leads_towards(from, direction) ? counted(root_rule::next(from))
                                                     : regular_->next(root_rule::end_of(from), rest);
}

next_step nested_rule::counted(next_step made) {
    regular_->count(made.made ? made.made->cost() : 0);
    return made;
}

next_step nested_rule::next_at_start(const flow_state& from, int direction) {
    if (direction < 0) {
        return {{}, stop::step_too_small};
    }
    if (first_passage_) {
        return root_rule::next(root_rule::begin_at_start(first_passage_, from));
    }
    return {std::make_shared<singular_first_step>(from, of_, *singular_, bits_.bits, bits_.error_bits, route_),
            stop::none};
}

}  // namespace

std::unique_ptr<step_rule> rule_for(const explicit_system& system, const run_bits& bits, const proof_route& route,
                                    error_weights weights) {
    return std::make_unique<nested_rule>(system, bits, route, weights);
}

flow_state start_of(const explicit_system& system, long bits) {
    const precision_scope scope(decimal_digits(bits));
    return {constant_value<ball>::of(system.point()), box_around(enclosed_start(system, bits), bits), {}, {}};
}

}  // namespace libration::ode
