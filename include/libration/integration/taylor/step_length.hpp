// Lengths of the steps of theorem V, with each unknown measured by its own size. No proof depends on the choices made
// here.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "libration/expansion/ball_expansion.hpp"
#include "libration/expansion/tail_bound.hpp"
#include "libration/integration/lohner_set.hpp"

namespace libration::ode {

/// log2 of the number 0.
inline constexpr double nothing = -std::numeric_limits<double>::infinity();

/// log2 of the width relative to the size of an unknown beyond which more bits are requested.
inline constexpr double widest_set = -24;

/// The scale of an unknown on a step, in log2.
struct unknown_scale {
    double size = nothing;   ///< a lower bound of its maximum; `nothing` when not distinguished from 0
    double reach = nothing;  ///< its error set
    double scale = 0;        ///< the larger of both; for an unknown that is 0 the largest of all
    /// Whether it has been distinguished from 0: then it is lost if its error set is as wide as the unknown itself.
    bool resolved = false;
};

class unknown_scales {
public:
    explicit unknown_scales(const std::vector<ball>& start) {
        for (const ball& each : start) {
            all_.push_back({log_of(magnitude::below(each)), nothing, 0, arb_contains_zero(each.handle()) == 0});
        }
    }

    const unknown_scale& operator[](std::size_t i) const { return all_[i]; }

    void measure_errors(const lohner_set& errors) {
        for (std::size_t i = 0; i < all_.size(); ++i) {
            all_[i].reach = log_of(errors.reach(i));
        }
    }

    /// The sizes from the largest terms of a series at an eighth of its radius, about R/e^2, the usual length of a
    /// step: so that an unknown that passes through 0 keeps the size that it has nearby.
    void measure_sizes(const taylor_expansion<ball>& series, const magnitude& radius) {
        const double distance = log_of(radius) - 3;
        for (std::size_t i = 0; i < all_.size(); ++i) {
            const ball* const a = series.coefficients(static_cast<int>(i));
            all_[i].size = nothing;
            for (int n = 0; n <= series.order(); ++n) {
                if (const magnitude least = magnitude::below(a[n]); !least.is_zero()) {
                    all_[i].size = std::max(all_[i].size, static_cast<double>(least.exponent()) + n * distance);
                }
            }
        }
        double largest = nothing;
        for (unknown_scale& each : all_) {
            each.scale = std::max(each.size, each.reach);
            largest = std::max(largest, each.scale);
        }
        for (unknown_scale& each : all_) {
            each.scale = each.scale != nothing ? each.scale : largest != nothing ? largest : 0;
        }
    }

    /// Whether the error set of an unknown that was distinguished from 0 is wider than 2^limit of its size.
    bool lost(double limit) const {
        return std::ranges::any_of(all_, [&](const unknown_scale& each) {
            return each.resolved && each.reach != nothing && each.reach - each.size > limit;
        });
    }
    /// The same for a state alone, by its size there instead of its size on the step: also true for an unknown near 0.
    bool may_be_lost(const std::vector<ball>& centre, const std::vector<magnitude>& reach, double limit) const {
        for (std::size_t i = 0; i < all_.size(); ++i) {
            if (all_[i].resolved && log_of(reach[i]) - log_of(magnitude(centre[i])) > limit) {
                return true;
            }
        }
        return false;
    }
    /// From here on no unknown counts as distinguished from 0, and none is lost.
    void accept_any_width() {
        any_width_ = true;
        for (unknown_scale& each : all_) {
            each.resolved = false;
        }
    }
    bool accepts_any_width() const { return any_width_; }
    /// Marks as distinguished from 0 the unknowns whose error set is narrower than 2^limit of their size.
    void resolve(double limit) {
        for (unknown_scale& each : all_) {
            each.resolved = (each.resolved || (each.size != nothing && each.reach - each.size < limit)) && !any_width_;
        }
    }
    /// Whether any error set is wider than 2^limit of the size of its unknown.
    bool wide(double limit) const {
        return std::ranges::any_of(
            all_, [&](const unknown_scale& each) { return each.reach != nothing && each.reach - each.size > limit; });
    }

    /// The relative accuracy in bits of the most accurate unknown with an error set; `most` if there is none.
    long accuracy(long most) const {
        double best = nothing;
        for (const unknown_scale& each : all_) {
            if (each.resolved && each.reach != nothing) {
                best = std::max(best, each.size - each.reach);
            }
        }
        return best == nothing ? most : static_cast<long>(std::min(best, static_cast<double>(most)));
    }

    /// Exponents of the scales in which errors are comparable, for lohner_set::settled.
    std::vector<long> exponents() const {
        std::vector<long> result;
        for (const unknown_scale& each : all_) {
            result.push_back(static_cast<long>(by_errors_ && each.reach != nothing ? each.reach : each.scale));
        }
        return result;
    }

    /// From here on errors are weighted by the scales only, as required for the derivative of the flow.
    void weigh_by_scales() { by_scales_ = true; }
    /// From here on errors are weighted by the error sets only: an unknown that is much smaller than another, and has
    /// fewer relative digits, does not propagate its relative error.
    void weigh_by_errors() { by_errors_ = true; }
    /// log2 of the weight of an error of unknown j in unknown i: relative to the scales of both or, if that is less, to
    /// their error sets.
    double weight(std::size_t i, std::size_t j) const {
        const double of_scales = all_[j].scale - all_[i].scale;
        if (by_scales_) {
            return of_scales;
        }
        if (all_[j].reach == nothing) {
            return nothing;
        }
        if (all_[i].reach == nothing) {
            return of_scales;
        }
        const double of_errors = all_[j].reach - all_[i].reach;
        return by_errors_ ? of_errors : std::min(of_scales, of_errors);
    }

    /// log2 of the longest step whose tail is below the last of so many bits of each unknown, or far enough below its
    /// error set; for unknowns that are not distinguished from 0 only the latter applies.
    double longest(const tail_bound& tail, long bits, long bits_below_the_set) const {
        const double radius = log_of(tail.radius);
        double least = radius - 1;
        for (std::size_t i = 0; i < all_.size(); ++i) {
            const double allowed = std::max(all_[i].size - static_cast<double>(bits),
                                            all_[i].reach - static_cast<double>(bits_below_the_set));
            const double error = log_of(tail.error[i]);
            if (allowed != nothing && error != nothing) {
                least = std::min(least, radius + (allowed - error) / (tail.degree + 1));
            }
        }
        return least;
    }

private:
    std::vector<unknown_scale> all_;
    bool by_scales_ = false;
    bool by_errors_ = false;
    bool any_width_ = false;
};

/// The indices of the derivatives of the unknowns with respect to each other in the system with its variations.
struct variation_places {
    std::size_t given;  ///< unknowns whose derivatives are requested
    std::size_t count;  ///< unknowns of the polynomial form

    std::size_t of(std::size_t i, std::size_t j) const { return count * (j + 1) + i; }
};

/// log2 of the longest step whose tail changes the error map by 2^wanted, in the weights of its unknowns.
inline double longest_for_map(const tail_bound& tail, const unknown_scales& scales, const variation_places& places,
                              double wanted) {
    const double radius = log_of(tail.radius);
    double least = radius - 1;
    for (std::size_t i = 0; i < places.given; ++i) {
        for (std::size_t j = 0; j < places.given; ++j) {
            const double error = log_of(tail.error[places.of(i, j)]) + scales.weight(i, j);
            if (error > nothing) {
                least = std::min(least, radius + (wanted - error) / (tail.degree + 1));
            }
        }
    }
    return least;
}

/// log2 of the largest term of the error map at a distance, in the same weights, at least 0: a contracting map is the
/// sum of terms larger than 1 by about as much as it is smaller than 1 itself.
template <class SetExpansion>
double growth_of_terms(const SetExpansion& series, const unknown_scales& scales, std::size_t unknowns,
                       double distance) {
    double largest = 0;
    for (std::size_t i = 0; i < unknowns; ++i) {
        for (std::size_t j = 0; j < unknowns; ++j) {
            const double weight = scales.weight(i, j);
            if (weight == nothing) {
                continue;
            }
            const ball* const a = series.coefficients(i, j);
            for (int n = 0; n <= series.order(); ++n) {
                if (const magnitude size(a[n]); !size.is_zero()) {
                    largest = std::max(largest, static_cast<double>(size.exponent()) + n * distance + weight);
                }
            }
        }
    }
    return largest;
}

}  // namespace libration::ode
