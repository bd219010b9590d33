#include "collocation_phase.hpp"

#include <algorithm>

#include "../rigorous/lifted_set.hpp"
#include "../rigorous/matrix/dense_matrix.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

// The cost of a step grows with the cube of the number of unknowns, that of the preparation with the cube of the bits.
constexpr std::size_t most_collocation_unknowns = 40;
constexpr long most_collocation_bits = 1024;
// The number of steps in which their length may grow until they are worth their cost.
constexpr long steps_to_grow = 6;
constexpr int steps_without_fast_modes = 3;

// The least number of steps of Taylor series that take longer than the preparation of collocation.
unsigned long steps_worth_preparation(long bits) {
    constexpr unsigned long at_200_bits = 1000;
    const auto times = static_cast<unsigned long>(std::max(200L, bits));
    return at_200_bits * times * times * times / (200 * 200 * 200);
}

}  // namespace

collocation_phase::collocation_phase(const lifted_system& of, long bits, const proof_route& route)
    : system_(of), bits_(bits), route_(route), between_checks_(first_interval()) {
    if (route.integrator == integrator_choice::automatic) {
        next_check_ = between_checks_;
    }
}

long collocation_phase::cost_of_step() const {
    constexpr long at_200_bits = 32;
    const long bits = std::max(200L, bits_);
    return at_200_bits * bits * bits / (200 * 200);
}

long collocation_phase::first_interval() const { return steps_without_fast_modes * cost_of_step(); }

std::string collocation_phase::obstacle() const {
    const std::size_t count = system_.leaves.size();
    if (count > most_collocation_unknowns) {
        return "is limited to " + std::to_string(most_collocation_unknowns) +
               " unknowns, and the polynomial form of these equations has " + std::to_string(count);
    }
    if (bits_ > most_collocation_bits) {
        return "is limited to a precision of " + std::to_string(most_collocation_bits) +
               " bits, and these digits need " + std::to_string(bits_);
    }
    return "";
}

bool collocation_phase::may_begin(long steps, const magnitude& length, const ball& rest) const {
    if (steps < next_check_ || !obstacle().empty()) {
        return false;
    }
    switch (route_.integrator) {
        case integrator_choice::taylor: return false;
        case integrator_choice::collocation: return true;
        case integrator_choice::automatic: break;
    }
    return length * magnitude(steps_worth_preparation(bits_)) <= magnitude(rest);
}

bool collocation_phase::begin(long steps, const ball& time, const state_set& set, const magnitude& length,
                              const ball& rest) {
    next_check_ = steps + between_checks_;
    between_checks_ *= 2;
    if (!integrator_) {
        integrator_.emplace(system_, bits_, route_.more_terms);
    }
    const auto all = lifted_set(system_, time, set);
    if (!all) {
        return false;
    }
    const ball first = arb_is_negative(rest.handle()) != 0 ? -length.exact() : length.exact();
    if (route_.integrator == integrator_choice::automatic && !integrator_->is_smooth_over(time, all->centre, first)) {
        return false;
    }
    integrator_->begin(time, *all, first);
    active_ = integrator_->prepare();
    steps_of_phase_ = 0;
    length_to_pay_ = length * magnitude(static_cast<unsigned long>(cost_of_step()));
    return active_;
}

void collocation_phase::use() {
    if (use_.steps++ == 0) {
        use_.first = as_double(integrator_->reached());
    }
    use_.periods += steps_of_phase_ == 0 ? 1 : 0;
}

bool collocation_phase::step(long steps) {
    const bool pays = length_to_pay_ <= magnitude(integrator_->length());
    integrator_->step();
    ++steps_of_phase_;
    reach(as_double(integrator_->reached()));
    if (pays) {
        between_checks_ = first_interval();
    }
    next_check_ = steps + between_checks_;
    if (route_.integrator == integrator_choice::collocation) {
        return true;
    }
    return integrator_->steps_without_fast_modes() < steps_without_fast_modes &&
           (steps_of_phase_ <= steps_to_grow || pays);
}

}  // namespace libration::ode
