// theta and omega of the canonical motion, proved, by the cheaper of two routes: fixed point where it is applicable,
// else balls.
#pragma once

#include <optional>
#include <utility>

#include "libration/pendulum/landen_motion.hpp"
#include "libration/pendulum/proved_libration.hpp"

namespace libration::pendulum {

/// One energy, any number of times: the results of landen_motion, by proved_libration where that is applicable to the
/// energy and the working precision. For a time that it excludes (|cos z| < 1/16) a landen_motion is constructed for
/// that time alone. Use it in a precision_scope of the size in which it was constructed.
class proved_canonical {
public:
    /// E and 2-E, exactly. Throws as landen_motion.
    proved_canonical(rational energy, rational gap) : energy_(std::move(energy)), gap_(std::move(gap)) {
        landen_motion::require_energies(energy_, gap_);
        if (proved_libration::serves(energy_, gap_, ball::working_bits())) {
            try {
                fixed_.emplace(energy_, gap_, ball::working_bits());
                mean_ = fixed_->mean();
                return;
            } catch (const precision_exhausted&) {
                fixed_.reset();
            }
        }
        floating_.emplace(energy_, gap_);
        mean_ = floating_->mean();
    }

    /// M: T = 2 pi/M below 2, pi/M above (one turn).
    const ball& mean() const { return mean_; }
    /// z = M t of an exact time.
    ball phase_at(const rational& time) const {
        return times(mean_, time, fixed_ ? fixed_->bits() : ball::working_bits());
    }

    /// theta alone, cheaper than both below 2.
    ball theta_at(const ball& z) const {
        if (fixed_) {
            if (auto theta = served([&] { return fixed_->theta_at(z); })) {
                return *std::move(theta);
            }
        }
        return floating_ ? floating_->theta_at(z) : landen_motion(energy_, gap_).theta_at(z);
    }

    /// theta and omega.
    enclosed_state state_at(const ball& z) const {
        if (fixed_) {
            if (auto state = served([&] { return fixed_->state_at(z); })) {
                return *std::move(state);
            }
        }
        return floating_ ? floating_->state_at(z) : landen_motion(energy_, gap_).state_at(z);
    }

private:
    // Fixed point fails if its radii grow too large, for instance at huge times; balls are used then.
    template <class Route>
    static auto served(const Route& route) -> decltype(route()) {
        try {
            return route();
        } catch (const precision_exhausted&) {
            return std::nullopt;
        }
    }

    rational energy_;
    rational gap_;
    ball mean_;
    std::optional<proved_libration> fixed_;
    std::optional<landen_motion> floating_;
};

}  // namespace libration::pendulum
