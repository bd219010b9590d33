// Taylor coefficients of theta as sums over the nearest singularities, with the proved bound of those that are left out
// (singularity_view.hpp): each costs the same, however large its index, and none needs the ones before it.
#pragma once

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "libration/pendulum/expansion_point.hpp"
#include "libration/pendulum/singularity_view.hpp"
#include "libration/scalar/complex_number.hpp"

namespace libration {

/// The last power that has a coefficient here: 64 bits beyond those of T hold an angle times 10^15.
inline constexpr long largest_power = 1'000'000'000'000'000;

/// Refuses powers that no coefficient has here.
inline void require_powers(long first, long last) {
    if (first < 0 || last < first || last > largest_power) {
        throw std::invalid_argument("powers from " + std::to_string(first) + " to " + std::to_string(last) +
                                    ", not from 0 up to " + std::to_string(largest_power));
    }
}

/// How far the poles reach that a_n needs: left-out ones add less than an eighth of an epsilon of T in 8/(n R^n).
/// 2^(bits/(n-4)) R, bits from (2/n) d^(4-n) S4 <= (8/n) R^-n epsilon/8. n > 4; where it decides costs alone, few digits
/// are enough.
template <scalar T>
class pole_reach {
public:
    pole_reach(const singularity_view<T>& view, long precision) : radius_(midpoint(view.radius())) {
        const T square = view.radius() * view.radius();
        bits_ = precision + 3 + std::max(0L, binary_exponent(T(view.fourth_powers() * square * square)));
    }

    long bits() const { return bits_; }
    /// In units of the radius.
    T factor(long n) const {
        using std::exp;
        using std::log;
        return midpoint(T(exp(T(log(T(2)) * T(bits_) / T(n - 4)))));
    }
    T operator()(long n) const { return midpoint(T(radius_ * factor(n))); }

private:
    T radius_;
    long bits_;
};

/// The power from which sums over the singularities cost less than the recurrence, or last + 1 where that is sooner: about
/// 2 powers a digit at 50 digits, 0.7 at 1000, and never below 512 for the built-in floating types. A step of the recurrence
/// costs 3n/8 products a power (with symmetry, for half of the poles; without it twice as many of both), a coefficient 2
/// products a pole, and the table of a pole 256; the poles within reach are about those of half an ellipse in the lattice. An
/// estimate of costs, which no result depends on beyond rounding.
template <scalar T>
long lattice_begins(const singularity_view<T>& view, long last) {
    constexpr bool built_in = fixed_scalar<T> && !std::same_as<T, quad>;
    const long least = built_in ? 512 : 16;
    const long precision = digits<T>();
    const precision_scope rough(20);
    const pole_reach<T> reach(view, precision);
    const T step = narrow<T>(widen(view.lattice().effective_period));
    const T wide = view.lattice().single_column ? T(0) : T(narrow<T>(widen(view.radius())) / step);
    const T tall = narrow<T>(widen(T(view.radius() / view.lattice().height)));
    const auto cheap = [&](long n) {
        const T factor = reach.factor(n);
        const T poles = midpoint(T((factor * wide + 1) * (factor * tall + 1)));  // times 4/pi twice over: upwards
        return certainly_less(poles, T(n)) && certainly_less(T(poles * 300), T(T(n) * T(n)));
    };
    long below = std::max(least, reach.bits() / 8) - 1;  // reach.factor() stays below 2^8 or so
    long enough = below + 1;
    while (enough <= last && !cheap(enough)) {
        below = enough;
        enough *= 2;
    }
    while (enough - below > 1 && below < last) {
        const long middle = below + (enough - below) / 2;
        (cheap(middle) ? enough : below) = middle;
    }
    return std::min(enough, last + 1);
}

/// a_n scale^n about a point of a motion, for n from 5 to largest_power. An error of a few epsilon of T in
/// (8/n)(scale/R)^n, proved on balls. Made in the precision it is used in. Not for equilibria.
///
/// Each pole gives (scale/z)^n = g c of a power g that begins a block of 64 and a power c of a table. So no coefficient is
/// more than one complex product away from logarithm and angle (on balls steps of one power would widen by up to sqrt 2
/// each). The poles that a coefficient needs are fewer for larger n, in the end one or two. All is computed from the exact
/// motion with 64 bits more than T has, because an n-th power multiplies an error by n. O(1) sines a block and pole, one
/// sum of 2 products a pole for each coefficient.
template <scalar T>
class lattice_coefficients {
    using W = wide_t<T>;

public:
    lattice_coefficients(const motion& m, const expansion_point& at, const T& scale) {
        const precision_scope wide(wide_digits());
        scale_ = widen(scale);
        auto view = view_from<W>(m, phase_of<W>(at, m));
        if (!view) {
            throw std::domain_error("an equilibrium has no singularities");
        }
        view_.emplace(std::move(*view));
    }

    /// n = first .. last. Throws std::invalid_argument where first < 5, last < first or last > largest_power.
    std::vector<T> between(long first, long last) const {
        require_powers(first, last);
        if (first < 5) {
            throw std::invalid_argument("a power below 5 by a sum over singularities");
        }
        born_.require();
        std::vector<T> result(static_cast<std::size_t>(last - first + 1), T(0));
        {
            const precision_scope wide(wide_digits());
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
    static constexpr long guard_bits = 64;
    static constexpr long block = 64;

    // A pole in units of the scale, by what its powers need.
    struct tracked_pole {
        W logarithm;  // log |scale/z|
        W angle;      // of scale/z
        W square;     // |z|^2, dimensionless
        int weight;
        complex_number<W> step{};   // the power of a whole block
        complex_number<W> power{};  // that the block begins with
        bool first_step = true;

        complex_number<W> to_the(long n) const {
            using std::cos;
            using std::exp;
            using std::sin;
            const W size = exp(W(logarithm * W(n)));
            const W turned = angle * W(n);
            return {size * cos(turned), size * sin(turned)};
        }
    };

    static long wide_digits() { return decimal_digits(digits<T>() + guard_bits); }

    std::vector<tracked_pole> track(const W& reach) const {
        using std::atan2;
        using std::log;
        const W unit = log(scale_);
        const auto seen = view_->within(reach);
        std::vector<tracked_pole> poles;
        poles.reserve(seen.size());
        for (const seen_pole<W>& each : seen) {
            poles.push_back({unit - log(each.square) / 2, -atan2(each.height, each.along), each.square, each.weight});
        }
        return poles;
    }

    // Rows of powers 0, stride, 2 stride, ..: for each pole the imaginary part and the real one, by doubling.
    std::vector<std::vector<T>> table_of(const std::vector<tracked_pole>& poles, long rows) const {
        const auto count = static_cast<std::size_t>(rows);
        std::vector<std::vector<T>> table(count, std::vector<T>(poles.size() * 2, T(0)));
        std::vector<complex_number<W>> powers(count, {W(1), W(0)});
        for (std::size_t p = 0; p < poles.size(); ++p) {
            for (std::size_t k = 0; k < count; ++k) {
                if (k > 0) {
                    powers[k] = k == 1 ? poles[p].to_the(view_->powers().stride) : powers[k / 2] * powers[k - k / 2];
                }
                table[k][2 * p] = narrow<T>(powers[k].im);
                table[k][2 * p + 1] = narrow<T>(powers[k].re);
            }
        }
        return table;
    }

    void fill(std::vector<T>& result, long first, long last) const {
        const long stride = view_->powers().stride;
        const long start = view_->powers().next(first);
        if (start > last) {
            return;
        }
        const pole_reach<W> reach(*view_, precision_);
        std::vector<tracked_pole> poles = track(reach(start));
        const auto table = table_of(poles, std::min(block, (last - start) / stride + 1));
        std::vector<T> begins;
        for (long n = start; n <= last; n += block * stride) {
            const W next = reach(n);
            leave_out(poles, W(next * next));
            begin_block(poles, n, n == start, begins);
            rest_of_sum rest(*view_, next, scale_, n);
            for (long k = 0; k < block && n + k * stride <= last; ++k) {
                const long power = n + k * stride;
                const T sum = inner_product(begins.data(), 1, table[static_cast<std::size_t>(k)].data(), 1,
                                            static_cast<int>(begins.size()));
                result[static_cast<std::size_t>(power - first)] = rest.added_to(T(-(sum * 4) / T(power)));
            }
        }
    }

    // Theorem A1 for n, n + stride, ..: 2/n is left as it was for the first of them.
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

    // Forgets the poles that are certainly beyond the limit, from the far end.
    static void leave_out(std::vector<tracked_pole>& poles, const W& limit) {
        while (!poles.empty() && certainly_less(limit, poles.back().square)) {
            poles.pop_back();
        }
    }

    // The powers n of the poles with their weights, as table_of has them: from the polar form, on rounding scalars from
    // the block before.
    void begin_block(std::vector<tracked_pole>& poles, long n, bool anew, std::vector<T>& begins) const {
        begins.clear();
        begins.reserve(poles.size() * 2);
        for (tracked_pole& pole : poles) {
            if constexpr (proved_scalar<T>) {
                pole.power = pole.to_the(n);
            } else {
                if (!anew && pole.first_step) {
                    pole.step = pole.to_the(block * view_->powers().stride);
                    pole.first_step = false;
                }
                pole.power = anew ? pole.to_the(n) : pole.power * pole.step;
            }
            begins.push_back(narrow<T>(W(pole.power.re * pole.weight)));
            begins.push_back(narrow<T>(W(pole.power.im * pole.weight)));
        }
    }

    born_precision<T> born_;
    long precision_ = digits<T>();
    W scale_;
    std::optional<singularity_view<W>> view_;
};

}  // namespace libration
