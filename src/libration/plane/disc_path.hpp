// A path in the complex t-plane, disc by disc.
#pragma once

#include <memory>
#include <utility>

#include "libration/plane/complex_disc.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

// The length of a step of a path relative to the radius, times 2^15.
inline constexpr unsigned long path_part = 19'660;  // 0.6 of 2^15
// The maximum number of discs in addition to one per bit; discs of nine tenths of the radius need one per two bits.
inline constexpr long most_path_discs = 60;

inline bool certainly_not_zero(const complex_ball& z) { return !contains_zero(z.re) || !contains_zero(z.im); }

// Continuation by discs, each centred inside the previous one.
class disc_path {
public:
    explicit disc_path(const complex_flow& flow) : flow_(flow), now_(std::make_unique<complex_disc>(flow)) {}
    disc_path(const complex_flow& flow, complex_set from)
        : flow_(flow), now_(std::make_unique<complex_disc>(flow, std::move(from))) {}

    // In steps of 0.6 of a radius; each(disc, offset) is called for every step.
    template <class Each>
    void go_to(const complex_ball& target, const Each& each) {
        for (;;) {
            const complex_ball rest = exact_difference(target, now_->about().offset);
            const magnitude away = size_of(rest);
            const magnitude longest = flow_.route().shortened(now_->radius() * magnitude::of(path_part, -15));
            const bool last = away <= longest;
            if (away.is_zero()) {
                return;
            }
            complex_ball next = target;
            if (!last) {
                const ball part = longest.exact() / away.exact();
                next = exact_midpoint(now_->about().offset + rest * part);
            }
            if (++discs_ > most_path_discs + flow_.bits()) {
                throw error(error_kind::undecided, error_subject::problem, "",
                            "cannot be followed to a singularity: the proved discs become too small before it; if a "
                            "sum such as x^2 + y^2 cancels there, write the problem in x + i y and x - i y");
            }
            if (!certainly_within(exact_difference(next, now_->about().offset), now_->radius())) {
                throw precision_exhausted("a step below the rounding of its position");
            }
            each(*now_, next);
            const ball modulus = upper_bound(sqrt(ball(next.re * next.re + next.im * next.im)));
            farthest_ = certainly_less(modulus, farthest_) ? farthest_ : modulus;
            now_ = std::make_unique<complex_disc>(flow_, now_->moved_to(next));
            if (last) {
                return;
            }
        }
    }

    const complex_disc& now() const { return *now_; }
    const ball& farthest() const { return farthest_; }
    long discs() const { return discs_; }

private:
    const complex_flow& flow_;
    std::unique_ptr<complex_disc> now_;
    ball farthest_;
    long discs_ = 1;
};

}  // namespace libration::ode
