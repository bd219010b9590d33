// Taylor coefficients of theta as sums over the nearest singularities, with the proved bound of the omitted ones
// (singularity_view.hpp): each costs the same, however large its index, and none needs the ones before it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/pendulum/expansion_point.hpp"
#include "libration/pendulum/pole_reach.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/integer_power.hpp"

namespace libration::pendulum {

/// The largest power of a coefficient here: 128 bits beyond those of T cover the errors of a power of 10^15.
inline constexpr long largest_power = 1'000'000'000'000'000;

/// Throws error for powers outside the range of these coefficients.
inline void require_powers(long first, long last) {
    if (first < 0 || last < first || last > largest_power) {
        throw error(error_kind::argument, "powers", std::to_string(first) + " to " + std::to_string(last),
                    "are not from 0 up to " + std::to_string(largest_power));
    }
}

/// a_n scale^n about a point of a motion, for n from 5 to largest_power. An error of a few epsilon of T in
/// (8/n)(scale/R)^n, proved on balls. To be constructed in the precision in which it is used. Not for equilibria.
///
/// Each pole contributes (scale/z)^n = g c with a power g at which a block of 32 begins and a power c from a table, and
/// the sum over the poles is one inner product; the poles needed for a coefficient are fewer for larger n, in the end
/// one or two. All is computed from the exact motion with 64 bits more than T has, and 128 beyond n = 2^24: an n-th
/// power multiplies an error by n, and on balls each of the O(log n) complex products that lead to g widens rectangles
/// by up to sqrt 2 more. 2 products per pole for each coefficient, O(log n) at the beginning of every 16th block.
template <scalar T>
class lattice_coefficients {
    using W = wide_t<T>;

public:
    /// For powers up to `last`; the poles extend as far as needed for this many bits of a_n, by default those of T.
    lattice_coefficients(const motion& m, const expansion_point& at, const T& scale, long last,
                         std::optional<long> bits = {})
        : reached_bits_(bits.value_or(digits<T>())),
          last_(last),
          wide_digits_(decimal_digits(digits<T>() + (last < (1L << 24) ? 64 : 128))) {
        const precision_scope wide(wide_digits_);
        scale_ = widen(scale);
        auto view = view_from<W>(m, phase_of<W>(at, m));
        if (!view) {
            throw error(error_kind::argument, "motion", "", "is at rest: it has no singularities");
        }
        view_.emplace(std::move(*view));
    }

    /// n = first .. last. Throws error if first < 5, last < first or last is above the one of
    /// the constructor.
    std::vector<T> between(long first, long last) const {
        require_powers(first, last);
        if (first < 5 || last > last_) {
            throw error(error_kind::argument, "powers", std::to_string(first) + " to " + std::to_string(last),
                        "are not from 5 up to " + std::to_string(last_));
        }
        born_.require();
        std::vector<T> result(static_cast<std::size_t>(last - first + 1), T(0));
        {
            const precision_scope wide(wide_digits_);
            fill(result, first, last);
        }
        // Back in the caller's precision.
        if constexpr (!fixed_scalar<T>) {
            for (T& a : result) {
                a = narrow<T>(a);
            }
        }
        return result;
    }

private:
    static constexpr long block = 32;
    static constexpr long blocks_between_powers = 16;

    struct tracked_pole {
        complex_number<W> inverse;  // scale/z
        W square;                   // |z|^2, dimensionless
        int weight;
        complex_number<W> power{};  // of the inverse, with which the block begins
        complex_number<W> step{};   // to the next block
    };

    std::vector<tracked_pole> track(const W& reach) const {
        const auto seen = view_->within(reach);
        std::vector<tracked_pole> poles;
        poles.reserve(seen.size());
        for (const seen_pole<W>& each : seen) {
            const W factor = scale_ / each.square;
            poles.push_back({{each.along * factor, -each.height * factor}, each.square, each.weight});
        }
        return poles;
    }

    // Rows of powers 0, stride, 2 stride, ..: for each pole the imaginary part and the real one, by doubling; and the
    // step of a whole block.
    std::vector<std::vector<T>> table_of(std::vector<tracked_pole>& poles, long rows) const {
        const auto count = static_cast<std::size_t>(rows);
        std::vector<std::vector<T>> table(count, std::vector<T>(poles.size() * 2, T(0)));
        std::vector<complex_number<W>> powers(count + 1, {W(1), W(0)});
        for (std::size_t p = 0; p < poles.size(); ++p) {
            powers[1] = integer_power(poles[p].inverse, view_->powers().stride);
            for (std::size_t k = 0; k < count; ++k) {
                if (k > 1) {
                    powers[k] = powers[k / 2] * powers[k - k / 2];
                }
                table[k][2 * p] = narrow<T>(powers[k].im);
                table[k][2 * p + 1] = narrow<T>(powers[k].re);
            }
            poles[p].step = powers[count / 2] * powers[count - count / 2];
        }
        return table;
    }

    void fill(std::vector<T>& result, long first, long last) const {
        const long stride = view_->powers().stride;
        const long start = view_->powers().next(first);
        if (start > last) {
            return;
        }
        const pole_reach<W> reach(*view_, reached_bits_);
        std::vector<tracked_pole> poles = track(reach(start));
        const auto table = table_of(poles, std::min(block, (last - start) / stride + 1));
        std::vector<T> begins;
        long blocks = 0;
        for (long n = start; n <= last; n += block * stride) {
            const W next = reach(n);
            leave_out(poles, W(next * next));
            const bool anew = blocks++ % blocks_between_powers == 0;
            begin_block(poles, n, anew, begins);
            rest_of_sum rest(*view_, next, scale_, n);
            for (long k = 0; k < block && n + k * stride <= last; ++k) {
                const long power = n + k * stride;
                const T sum = inner_product(begins.data(), 1, table[static_cast<std::size_t>(k)].data(), 1,
                                            static_cast<int>(begins.size()));
                result[static_cast<std::size_t>(power - first)] = rest.added_to(T(-(sum * 4) / T(power)));
            }
        }
    }

    // Theorem A1 for n, n + stride, ..: 2/n is not updated from that of the first of them.
    class rest_of_sum {
    public:
        rest_of_sum(const singularity_view<W>& view, const W& next, const W& scale, long n) {
            if constexpr (proved_scalar<T>) {
                const W inverse = scale / next;
                const W square = next * next;
                bound_ = view.fourth_powers() * square * square * pow(inverse, n) * 2 / n;
                shrink_ = pow(inverse, view.powers().stride);
            }
        }
        T added_to(const T& sum) {
            T result = enclose(sum, bound_);
            if constexpr (proved_scalar<T>) {
                bound_ *= shrink_;
            }
            return result;
        }

    private:
        T bound_ = T(0);
        T shrink_ = T(0);
    };

    // Removes the poles that are certainly beyond the limit, from the far end.
    static void leave_out(std::vector<tracked_pole>& poles, const W& limit) {
        while (!poles.empty() && certainly_less(limit, poles.back().square)) {
            poles.pop_back();
        }
    }

    // The powers n of the poles with their weights, as in table_of: from scratch, or from the block before.
    static void begin_block(std::vector<tracked_pole>& poles, long n, bool anew, std::vector<T>& begins) {
        begins.clear();
        begins.reserve(poles.size() * 2);
        for (tracked_pole& pole : poles) {
            pole.power = anew ? integer_power(pole.inverse, n) : pole.power * pole.step;
            begins.push_back(narrow<T>(W(pole.power.re * pole.weight)));
            begins.push_back(narrow<T>(W(pole.power.im * pole.weight)));
        }
    }

    born_precision<T> born_;
    long reached_bits_;
    long last_;
    long wide_digits_;
    W scale_;
    std::optional<singularity_view<W>> view_;
};

}  // namespace libration::pendulum
