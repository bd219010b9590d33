#include "libration/integration/kept_integrations.hpp"

#include <algorithm>

#include "libration/integration/rule_for.hpp"

namespace libration::ode {

namespace {

bool makes_same_steps(const proof_route& a, const proof_route& b) {
    return a.more_terms == b.more_terms && a.step_eighths == b.step_eighths && a.product == b.product &&
           a.integrator == b.integrator;
}

}  // namespace

std::shared_ptr<integration> kept_integrations::along(std::size_t part, const explicit_system& system, long bits,
                                                      int direction, const proof_route& route) {
    const auto found = std::ranges::find_if(entries_, [&](const entry& each) {
        return each.part == part && each.direction == direction && makes_same_steps(each.route, route);
    });
    if (found != entries_.end() && found->along->bits() >= bits && found->along->first() == 0) {
        return found->along;
    }
    auto made = std::make_shared<integration>(start_of(system, bits), rule_for(system, {bits}, route),
                                              infinite_distance(direction), bits);
    if (found == entries_.end()) {
        entries_.push_back({part, direction, route, made});
    } else {
        made_before_ += found->along->made();
        found->along = made;
    }
    return made;
}

// The arrays of a step: the coefficients of the unknowns, and those of the derivative by the initial state with fewer bits.
bool kept_integrations::keeps(const integration& along) const {
    const step* const last = along.last_step();
    if (last == nullptr) {
        return true;
    }
    constexpr std::size_t bytes_beside = 64;
    const std::size_t size = along.start().set.centre.size();
    const auto terms = static_cast<std::size_t>(last->made().order + 1);
    const auto bytes = static_cast<std::size_t>(last->made().bits) / 8 + bytes_beside;
    const std::size_t of_step = terms * (size * bytes + size * size * 2 * bytes_beside);
    return (along.made() - along.first()) * of_step <= most_bytes_;
}

std::size_t kept_integrations::made() const {
    std::size_t sum = made_before_;
    for (const entry& each : entries_) {
        sum += each.along->made();
    }
    return sum;
}

}  // namespace libration::ode
