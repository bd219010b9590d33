// The largest errors of approximants of an equation at times of an interval, every digit proved.
//
// The solution at the times is enclosed by theorem V (ode/proved/proved_march.hpp), the coefficients are computed on
// balls, and so is what approximants make of them: the largest of the differences is enclosed. A Pade approximant
// exists where elimination on balls finds every pivot away from 0.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "libration/approximant/endpoint_approximant.hpp"
#include "libration/ode/ball/taylor_expansion.hpp"
#include "libration/ode/first_order_form.hpp"
#include "libration/ode/proved/proved_march.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/integer_power.hpp"
#include "norms_on_interval.hpp"

namespace libration::studies::of_equation {

/// The solution of A x = b by elimination on balls; nothing where a pivot that is not 0 is not seen.
inline std::optional<std::vector<ball>> solved_on_balls(std::vector<std::vector<ball>> a, std::vector<ball> b) {
    const std::size_t n = b.size();
    const auto smaller = [](const ball& x, const ball& y) {
        return midpoint_of(lower_bound(abs(x))) < midpoint_of(lower_bound(abs(y)));
    };
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < n; ++i) {
            pivot = smaller(a[pivot][k], a[i][k]) ? i : pivot;
        }
        if (contains_zero(a[pivot][k])) {
            return std::nullopt;
        }
        std::swap(a[k], a[pivot]);
        std::swap(b[k], b[pivot]);
        for (std::size_t i = k + 1; i < n; ++i) {
            const ball factor = a[i][k] / a[k][k];
            for (std::size_t j = k + 1; j < n; ++j) {
                a[i][j] -= factor * a[k][j];
            }
            b[i] -= factor * b[k];
        }
    }
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t j = k + 1; j < n; ++j) {
            b[k] -= a[k][j] * b[j];
        }
        b[k] /= a[k][k];
    }
    return b;
}

/// The solution at times of an interval and its series about the start, on balls of the working precision.
class enclosed_interval {
public:
    /// Throws precision_exhausted where the proof of the solution needs more bits, error of the kind undecided where its
    /// steps become too small.
    enclosed_interval(const ode::explicit_system& system, const std::vector<ode::number>& times, int order)
        : tape_(ode::tape::about_start(system)) {
        for (const ode::number& each : times) {
            distances_.push_back(ode::constant_value<ball>::of(each - system.point()));
        }
        for (std::size_t k = 1; k < times.size(); ++k) {
            far_ = size_of(k) > size_of(far_) ? k : far_;
        }
        one_sided_ = size_of(far_) > 0 && std::ranges::all_of(distances_, [&](const ball& each) {
                         return each_sign(each) * each_sign(distances_[far_]) >= 0;
                     });
        march_through(system, times);
        ode::taylor_expansion<ball> expansion(tape_, order);
        expansion.about_start();
        for (int i = 0; i < static_cast<int>(values_.size()); ++i) {
            scaled_.push_back(expansion.series_of(i));
            ball power(1);
            for (int n = 0; n <= order; ++n, power *= distances_[far_]) {
                scaled_.back()[n] *= power;
            }
        }
    }

    /// An enclosed norm, and the place of its time where that is told from all others.
    struct largest_error {
        ball norm;
        std::optional<std::size_t> place;
    };

    /// Whether there is such an approximant, as far as is known without a computation.
    bool offers(approximation method) const { return method != approximation::endpoint || one_sided_; }

    /// Nothing where the approximant is not seen to exist with this precision.
    std::optional<largest_error> error_of(approximation method, int unknown, int order) const {
        const auto i = static_cast<std::size_t>(unknown);
        const auto approximant = approximant_of(method, unknown, order);
        if (!approximant) {
            return std::nullopt;
        }
        std::vector<ball> errors;
        for (std::size_t k = 0; k < distances_.size(); ++k) {
            errors.push_back(abs((*approximant)(ball(distances_[k] / distances_[far_])) - values_[i][k]));
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
    using function = std::function<ball(const ball&)>;

    static int each_sign(const ball& x) { return midpoint_of(x) < 0 ? -1 : midpoint_of(x) > 0 ? 1 : 0; }
    mpfr size_of(std::size_t k) const { return abs(midpoint_of(distances_[k])); }

    void march_through(const ode::explicit_system& system, const std::vector<ode::number>& times) {
        std::vector<std::size_t> order(times.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        const auto backwards = [&](std::size_t k) { return each_sign(distances_[k]) < 0; };
        std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
            return backwards(a) != backwards(b) ? backwards(b) : size_of(a) < size_of(b);
        });
        values_.assign(system.unknowns().size(), std::vector<ball>(times.size(), ball(0)));
        const ode::first_order_form form(system);
        std::optional<ode::proved_march> march;
        bool before = false;
        for (const std::size_t k : order) {
            if (!march || backwards(k) != before) {
                before = backwards(k);
                march.emplace(system, ball::working_bits());
            }
            const auto state = state_at(system, *march, times[k], k);
            if (!state) {
                require_precision(march->end());
            }
            std::size_t at = 0;
            for (std::size_t i = 0; i < values_.size(); ++i) {
                values_[i][k] = (*state)[at];
                if (k == far_) {
                    slopes_.push_back(form.slopes_at(*state, ode::constant_value<ball>::of(times[k]))[at]);
                }
                at += static_cast<std::size_t>(system.unknowns()[i].order);
            }
        }
    }

    // At a singular start itself that, and nothing before it.
    std::optional<std::vector<ball>> state_at(const ode::explicit_system& system, ode::proved_march& march,
                                              const ode::number& time, std::size_t k) const {
        const int side = each_sign(distances_[k]);
        if (!system.singular() || side > 0) {
            return march.at(time);
        }
        if (side < 0) {
            throw error(error_kind::argument, "list of times", "",
                        "has one before the start, where the equation is singular: choose times behind it");
        }
        std::vector<ball> start;
        for (const auto& of_unknown : system.starts()) {
            for (const ode::number& each : of_unknown) {
                start.push_back(ode::constant_value<ball>::of(each));
            }
        }
        return start;
    }

    [[noreturn]] static void require_precision(ode::march_end why) {
        if (why == ode::march_end::precision) {
            throw precision_exhausted("the solution at the times");
        }
        throw error(error_kind::undecided, "list of times", "",
                    "has one that is not reached: the steps of the proof become too small before it, as they do near a "
                    "singularity");
    }

    std::optional<function> approximant_of(approximation method, int unknown, int order) const {
        const auto& all = scaled_[static_cast<std::size_t>(unknown)].coefficients();
        const series::power_series<ball> cut({all.begin(), all.begin() + std::ptrdiff_t{order} + 1});
        if (method == approximation::series) {
            return [cut](const ball& x) { return evaluate_value(cut, x); };
        }
        if (method == approximation::endpoint) {
            const auto i = static_cast<std::size_t>(unknown);
            const std::vector<ball> end{values_[i][far_], ball(slopes_[i] * distances_[far_])};
            return [of = endpoint_approximant<ball>(cut, end)](const ball& x) { return of.value(x); };
        }
        return pade_of(unknown, order);
    }

    // [m/m] in x^stride, as approximants_of_unknown has it, of the full degrees alone.
    std::optional<function> pade_of(int unknown, int order) const {
        const int stride = tape_.stride();
        const int first = std::max(0, tape_.residue_of(unknown));
        const auto& all = scaled_[static_cast<std::size_t>(unknown)];
        std::vector<ball> c;
        for (int n = first; n <= order; n += stride) {
            c.push_back(all[n]);
        }
        if (c.empty()) {
            return std::nullopt;
        }
        const std::size_t m = (c.size() - 1) / 2;
        std::vector<std::vector<ball>> a(m);
        std::vector<ball> b;
        for (std::size_t i = 1; i <= m; ++i) {
            for (std::size_t j = 1; j <= m; ++j) {
                a[i - 1].push_back(c[m + i - j]);
            }
            b.push_back(-c[m + i]);
        }
        auto q = solved_on_balls(std::move(a), std::move(b));
        if (!q) {
            return std::nullopt;
        }
        q->insert(q->begin(), ball(1));
        std::vector<ball> p;
        for (std::size_t n = 0; n <= m; ++n) {
            p.emplace_back(0);
            for (std::size_t j = 0; j <= n; ++j) {
                p.back() += (*q)[j] * c[n - j];
            }
        }
        return [p = series::power_series<ball>(std::move(p)), q = series::power_series<ball>(*std::move(q)), stride,
                first](const ball& x) {
            const ball z = integer_power(x, stride);
            return ball(integer_power(x, first) * evaluate_value(p, z) / evaluate_value(q, z));
        };
    }

    ode::tape tape_;
    std::vector<ball> distances_;  ///< of the times from the start
    std::size_t far_ = 0;
    bool one_sided_ = true;
    std::vector<std::vector<ball>> values_;  ///< [unknown][time]
    std::vector<ball> slopes_;               ///< of the unknowns at the far end
    std::vector<series::power_series<ball>> scaled_;
};

/// A norm with its proved digits; without them where no precision that was tried decides it, which is so where the
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

}  // namespace libration::studies::of_equation
