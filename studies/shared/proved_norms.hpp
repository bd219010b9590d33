// The largest errors of approximants of an equation at times of an interval, every digit proved.
//
// The solution at the times is enclosed by theorem V (integration/proved_march.hpp), the coefficients and the values of
// the approximants are computed on balls, and so the largest of the differences is enclosed.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "libration/approximant/pade_enclosure.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/expansion/ball_expansion.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "norms_on_interval.hpp"

namespace libration::studies {

/// The solution at times of an interval and its series about the initial point, on balls of the working precision.
class enclosed_interval {
public:
    /// Throws precision_exhausted if the proof of the solution needs more bits, and as enclosed_trajectory.
    enclosed_interval(const ode::explicit_system& system, const std::vector<ode::number>& times, int order) {
        const auto states = ode::enclosed_trajectory(system, times, ball::working_bits());
        if (!states) {
            throw precision_exhausted("the solution at the times");
        }
        std::vector<ball> distances;
        std::size_t far = 0;
        for (std::size_t k = 0; k < times.size(); ++k) {
            distances.push_back(ode::constant_value<ball>::of(times[k] - system.point()));
            far = size_of(distances[k]) > size_of(distances[far]) ? k : far;
        }
        const ball& reach = distances[far];
        for (const ball& each : distances) {
            x_.push_back(each / reach);
            one_sided_ = one_sided_ && midpoint_of(x_.back()) >= 0;
        }
        const ode::tape of = ode::tape::about_start(system);
        ode::taylor_expansion<ball> expansion(of, order);
        expansion.about_start();
        const auto slopes =
            ode::first_order_form(system).slopes_at((*states)[far], ode::constant_value<ball>::of(times[far]));
        std::size_t place = 0;
        for (int i = 0; i < static_cast<int>(system.unknowns().size()); ++i) {
            auto& values = values_.emplace_back();
            for (const auto& state : *states) {
                values.push_back(state[place]);
            }
            approximants_.emplace_back(
                rescale(expansion.series_of(i), reach), first_of_unknown(of, i), of.stride(),
                one_sided_ ? std::vector<ball>{values[far], ball(slopes[place] * reach)} : std::vector<ball>{});
            place += static_cast<std::size_t>(system.unknowns()[static_cast<std::size_t>(i)].order);
        }
    }

    /// An enclosed norm, and the index of its time if that is distinguished from all others.
    struct largest_error {
        ball norm;
        std::optional<std::size_t> place;
    };

    /// Whether there is such an approximant, as far as can be determined without a computation.
    bool offers(approximation method) const { return method != approximation::endpoint || one_sided_; }

    /// Returns std::nullopt if the approximant cannot be shown to exist in this precision.
    std::optional<largest_error> error_of(approximation method, int unknown, int order) const {
        const auto i = static_cast<std::size_t>(unknown);
        const auto approximant = approximants_[i].of(method, order);
        if (!approximant) {
            return std::nullopt;
        }
        std::vector<ball> errors;
        for (std::size_t k = 0; k < x_.size(); ++k) {
            errors.push_back(abs((*approximant)(x_[k]) - values_[i][k]));
        }
        std::size_t place = 0;
        ball least = lower_bound(errors[0]);
        ball most = upper_bound(errors[0]);
        for (std::size_t k = 1; k < errors.size(); ++k) {
            place = midpoint_of(errors[k]) > midpoint_of(errors[place]) ? k : place;
            least = certainly_less(least, lower_bound(errors[k])) ? lower_bound(errors[k]) : least;
            most = certainly_less(most, upper_bound(errors[k])) ? upper_bound(errors[k]) : most;
        }
        bool alone = true;
        for (std::size_t k = 0; k < errors.size(); ++k) {
            alone = alone && (k == place || certainly_less(errors[k], errors[place]));
        }
        return largest_error{hull(least, most), alone ? std::optional(place) : std::nullopt};
    }

private:
    static mpfr size_of(const ball& x) { return abs(midpoint_of(x)); }

    std::vector<ball> x_;  ///< of the times, 1 at the far end
    bool one_sided_ = true;
    std::vector<std::vector<ball>> values_;  ///< [unknown][time]
    std::vector<approximants_of_list<ball>> approximants_;
};

/// A norm with its proved digits; without them if it is decided at none of the precisions tried, as is the case if the
/// approximant is the solution.
struct proved_norm {
    int order;
    approximation method;
    int unknown;
    std::optional<proved_decimal> norm = {};
    std::optional<std::size_t> place = {};
    bool there = true;
};

/// The norms of all these orders. Throws as enclosed_interval.
inline std::vector<proved_norm> proved_norms(const asked_norms& asked, const std::vector<int>& orders, long digits) {
    constexpr std::array<long, 6> guards{20, 50, 120, 300, 700, 1500};
    std::vector<proved_norm> norms;
    for (const int order : orders) {
        for (const int unknown : asked.unknowns) {
            for (const approximation method : asked.methods) {
                norms.push_back({order, method, unknown});
            }
        }
    }
    std::optional<enclosed_interval> here;
    for (const long guard : guards) {
        const precision_scope scope(digits + guard);
        try {
            here.emplace(asked.system, asked.times, *std::ranges::max_element(orders));
        } catch (const precision_exhausted&) {
            continue;
        }
        bool all = true;
        for (proved_norm& each : norms) {
            each.there = here->offers(each.method);
            if (!each.there || each.norm) {
                continue;
            }
            if (const auto found = here->error_of(each.method, each.unknown, each.order)) {
                each.norm = to_proved_decimal(found->norm, digits);
                each.place = found->place;
            }
            all = all && each.norm;
        }
        if (all) {
            break;
        }
    }
    return norms;
}

}  // namespace libration::studies
