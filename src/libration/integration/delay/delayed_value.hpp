// The solution at earlier times, as a polynomial about an earlier time and a bound of the rest.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "delay_step.hpp"

namespace libration::ode {

// A bound of x - p and of x' - p'.
struct series_error {
    magnitude value, slope;
};

inline magnitude larger_of(const magnitude& a, const magnitude& b) { return a < b ? b : a; }

// The solution from a time within a piece on. The step whose polynomials are used contains that time, except that the
// time may be a little before its beginning.
template <field R>
class delayed_view {
public:
    // `at` is the distance of the time from the beginning of the piece.
    delayed_view(const delay_piece<R>& piece, const R& at) : piece_(&piece), index_(piece.steps.size() - 1) {
        while (index_ > 0 && certainly_negative(R(at - step().begins), at)) {
            --index_;
        }
        shift_ = R(at - step().begins);
    }

    // The distance of the time at which the next step begins; std::nullopt for the last step, which extends to the end
    // of the piece.
    std::optional<R> rest() const {
        return index_ + 1 < piece_->steps.size() ? std::optional(R(next().begins - step().begins - shift_))
                                                 : std::nullopt;
    }

    // Of a leaf, about the time.
    std::vector<R> series(std::size_t leaf) const {
        return is_exact_zero(shift_) ? step().series[leaf] : shifted(step().series[leaf], shift_);
    }

    // The polynomial at the time.
    R value(std::size_t leaf) const { return value_of(step().series[leaf], shift_); }

    // The bounds for the distances from 0 to `length`, which may exceed rest() by the uncertainty of both.
    series_error error(std::size_t leaf, const R& length) const {
        series_error result{step().error[leaf], step().slope_error[leaf]};
        if (index_ > 0) {
            add_seam(result, leaf, index_ - 1, excess_of(R(-shift_)));
        }
        if (index_ + 1 < piece_->steps.size()) {
            add_seam(result, leaf, index_, excess_of(R(length - *rest())));
        }
        return result;
    }

private:
    const delay_step<R>& step() const { return piece_->steps[index_]; }
    const delay_step<R>& next() const { return piece_->steps[index_ + 1]; }

    // Up to this distance from the end of step `left` the solution differs from the polynomials of both neighbours by at
    // most the larger of their bounds plus the difference of the polynomials there.
    void add_seam(series_error& to, std::size_t leaf, std::size_t left, const magnitude& distance) const {
        if (distance.is_zero()) {
            return;
        }
        const delay_step<R>& a = piece_->steps[left];
        const delay_step<R>& b = piece_->steps[left + 1];
        if (!(distance < size_below(a.length) && distance < size_below(b.length))) {
            throw precision_exhausted("the order of the steps of a solution with delays");
        }
        const auto from_a = shifted(a.series[leaf], R(b.begins - a.begins));
        series_error between;
        magnitude power(1U);
        for (std::size_t n = 0; n < from_a.size(); ++n) {
            const magnitude difference = size_above(R(from_a[n] - b.series[leaf][n]));
            between.value.add_product(difference, power);
            if (n + 1 < from_a.size()) {
                const auto next = static_cast<unsigned long>(n + 1);
                between.slope.add_product(size_above(R(from_a[n + 1] - b.series[leaf][n + 1])) * magnitude(next),
                                          power);
            }
            power *= distance;
        }
        to.value = larger_of(to.value, larger_of(a.error[leaf], b.error[leaf]) + between.value);
        to.slope = larger_of(to.slope, larger_of(a.slope_error[leaf], b.slope_error[leaf]) + between.slope);
    }

    const delay_piece<R>* piece_;
    std::size_t index_;
    R shift_{};
};

}  // namespace libration::ode
