// The steps of a tape with the addresses of their arrays, for hardware scalars about any point: looking the arrays up
// would take as long as the sums there.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <vector>

#include "libration/expansion/step_lanes.hpp"
#include "libration/series/kernel.hpp"

namespace libration::ode {

/// sum_{k=first}^{last} a_k b_{n-k}: the first and the last term, which may contain the newest coefficients, are added
/// to the others at the end, so that these need not wait for them; the others are in four independent partial sums.
template <std::floating_point R>
R sum_in_fours(const R* a, const R* b, int n, int first, int last) {
    if (first >= last) {
        return first == last ? a[first] * b[n - first] : R(0);
    }
    std::array<R, 4> sums{R(0), R(0), R(0), R(0)};
    int k = first + 1;
    for (; k + 3 < last; k += 4) {
        sums[0] += a[k] * b[n - k];
        sums[1] += a[k + 1] * b[n - k - 1];
        sums[2] += a[k + 2] * b[n - k - 2];
        sums[3] += a[k + 3] * b[n - k - 3];
    }
    if (k < last) {
        sums[0] += a[k] * b[n - k];
    }
    if (k + 1 < last) {
        sums[1] += a[k + 1] * b[n - k - 1];
    }
    if (k + 2 < last) {
        sums[2] += a[k + 2] * b[n - k - 2];
    }
    return ((sums[0] + sums[1]) + (sums[2] + sums[3])) + (a[first] * b[n - first] + a[last] * b[n - last]);
}

/// sum_{k=first}^{n-first} a_k a_{n-k}, each product once.
template <std::floating_point R>
R square_in_fours(const R* a, int n, int first) {
    const R half = sum_in_fours(a, a, n, first, (n + 1) / 2 - 1);
    return n % 2 == 0 && n >= 2 * first ? half + half + a[n / 2] * a[n / 2] : half + half;
}

/// The steps of a tape whose step i has its coefficients at arrays + i length; the tape and the arrays must not move.
/// In double, steps with the same operation run in lanes.
template <class R>
class placed_steps {
public:
    placed_steps() = default;
    /// states[i][j] is the step of derivative j of unknown i.
    placed_steps(const tape& of, R* arrays, std::size_t length, const std::vector<R>& constants,
                 const std::vector<std::vector<int>>& states);

    bool empty() const { return states_.empty(); }
    /// Coefficient n of all steps from the lower ones and those of the unknowns; otherwise(i) computes that of step i
    /// if it requires more than sums.
    template <class Otherwise>
    void run(int n, const Otherwise& otherwise);
    /// Coefficient n + 1 of the unknowns and their lower derivatives.
    void advance(int n) {
        const auto degree = static_cast<R>(n + 1);
        for (const state& each : states_) {
            each.here[n + 1] = each.above[n] / degree;
        }
    }

private:
    struct step;
    // Computes coefficient n of a step: a function that is selected once costs less than a switch for each coefficient.
    using kernel = void (*)(const step& of, int n);
    struct step {
        kernel compute;  // null if it requires more than sums
        R* result;
        const R* a;
        const R* b;
        R* behind;  // array of the next step
        R factor;   // the constant, or the numerator over a denominator
        R divisor;
        const R* derivative;  // for a primitive
        int index;
        bool begins_with_value;
    };
    struct state {
        R* here;
        const R* above;
    };

    static kernel kernel_of(const tape_step& step);
    static bool begins_with_value(operation kind);

    static void run_sum(const step& of, int n) { of.result[n] = of.a[n] + of.b[n]; }
    static void run_difference(const step& of, int n) { of.result[n] = of.a[n] - of.b[n]; }
    static void run_scaled(const step& of, int n) { of.result[n] = of.a[n] * of.factor; }
    static void run_fraction(const step& of, int n) { of.result[n] = of.a[n] * of.factor / of.divisor; }
    static void run_raised(const step& of, int n) { of.result[n] = of.a[n]; }
    static void run_constant(const step& of, int n) { of.result[n] = R(0); }
    static void run_slope(const step& of, int n) { series::slope_kernel(of.a, of.result, n); }
    static void run_product(const step& of, int n) { of.result[n] = sum_in_fours(of.a, of.b, n, 0, n); }
    static void run_square(const step& of, int n) { of.result[n] = square_in_fours(of.a, n, 0); }
    static void run_quotient(const step& of, int n) {
        of.result[n] = (of.a[n] - sum_in_fours(of.b, of.result, n, 1, n)) / of.b[0];
    }
    static void run_square_root(const step& of, int n) {
        of.result[n] = (of.a[n] - square_in_fours(of.result, n, 1)) / of.behind[0];
    }
    static void run_primitive(const step& of, int n) {
        of.result[n] = sum_in_fours(of.b, of.derivative, n - 1, 0, n - 1) / static_cast<R>(n);
    }
    static void run_sine_cosine(const step& of, int n);
    static void run_power(const step& of, int n);

    template <class Otherwise>
    static void run_one(const step& each, int n, const Otherwise& otherwise) {
        if (each.compute != nullptr) {
            each.compute(each, n);
        } else {
            otherwise(each.index);
        }
    }

    std::vector<step> steps_;
    std::vector<step> later_;            // those with coefficients after coefficient 0
    std::vector<std::size_t> place_of_;  // index of each step of the tape among steps_
    std::vector<state> states_;
    step_lanes lanes_;
};

template <class R>
placed_steps<R>::placed_steps(const tape& of, R* arrays, std::size_t length, const std::vector<R>& constants,
                              const std::vector<std::vector<int>>& states) {
    const auto array = [&](int i) { return arrays + static_cast<std::size_t>(i) * length; };
    std::vector<R> factors;
    for (int i = 0; i < static_cast<int>(of.steps().size()); ++i) {
        const tape_step& s = of.steps()[static_cast<std::size_t>(i)];
        factors.push_back(s.constant < 0 ? static_cast<R>(s.numerator)
                                         : constants[static_cast<std::size_t>(s.constant)]);
        place_of_.push_back(steps_.size());
        if (s.kind == operation::state || s.kind == operation::companion) {
            continue;
        }
        steps_.push_back({kernel_of(s), array(i), s.left < 0 ? nullptr : array(s.left),
                          s.right < 0 ? nullptr : array(s.right), array(i + 1), factors.back(),
                          static_cast<R>(s.denominator), s.derivative < 0 ? nullptr : array(s.derivative), i,
                          begins_with_value(s.kind)});
        if (s.kind != operation::constant) {
            later_.push_back(steps_.back());
        }
    }
    for (std::size_t i = 0; i < states.size(); ++i) {
        const R* above = array(of.outputs()[i]);
        for (std::size_t j = states[i].size(); j-- > 0;) {
            states_.push_back({array(states[i][j]), above});
            above = array(states[i][j]);
        }
    }
    if constexpr (std::same_as<R, double>) {
        lanes_ = step_lanes(of, arrays, length, factors);
    }
}

template <class R>
template <class Otherwise>
void placed_steps<R>::run(int n, const Otherwise& otherwise) {
    if (n == 0) {
        for (const step& each : steps_) {
            if (each.begins_with_value) {
                otherwise(each.index);
            } else {
                run_one(each, n, otherwise);
            }
        }
        if (!lanes_.empty()) {
            lanes_.begin();
        }
        return;
    }
    if (lanes_.empty()) {
        for (const step& each : later_) {
            run_one(each, n, otherwise);
        }
        return;
    }
    lanes_.take_states(n);
    for (const step_lanes::entry& each : lanes_.order()) {
        if (each.alone) {
            run_one(steps_[place_of_[each.first]], n, otherwise);
            lanes_.take(each, n);
        } else {
            lanes_.run(each, n);
        }
    }
}

template <class R>
typename placed_steps<R>::kernel placed_steps<R>::kernel_of(const tape_step& step) {
    switch (step.kind) {
        case operation::constant: return run_constant;
        case operation::sum: return run_sum;
        case operation::difference: return run_difference;
        case operation::scaled: return step.denominator == 1 ? run_scaled : run_fraction;
        case operation::raised: return run_raised;
        case operation::product: return run_product;
        case operation::square: return run_square;
        case operation::quotient: return run_quotient;
        case operation::slope: return run_slope;
        case operation::square_root: return run_square_root;
        case operation::primitive: return run_primitive;
        case operation::power: return run_power;
        case operation::function: return step.function == function_kind::sin ? run_sine_cosine : nullptr;
        case operation::variable:
        case operation::state:
        case operation::by_variable:
        case operation::delayed:
        case operation::companion: break;
    }
    return nullptr;
}

// Whether coefficient 0 does not follow the rule of the others.
template <class R>
bool placed_steps<R>::begins_with_value(operation kind) {
    switch (kind) {
        case operation::constant:
        case operation::variable:
        case operation::raised:
        case operation::by_variable:
        case operation::delayed:
        case operation::square_root:
        case operation::power:
        case operation::function:
        case operation::primitive: return true;
        case operation::state:
        case operation::sum:
        case operation::difference:
        case operation::scaled:
        case operation::product:
        case operation::square:
        case operation::quotient:
        case operation::slope:
        case operation::companion: break;
    }
    return false;
}

// Both sums in one loop, which reads the slope once.
template <class R>
void placed_steps<R>::run_sine_cosine(const step& of, int n) {
    const R* const slope = of.b;
    R* const sine = of.result;
    R* const cosine = of.behind;
    const int last = n - 1;
    std::array<R, 4> sums{R(0), R(0), R(0), R(0)};
    int k = 1;
    for (; k + 1 < last; k += 2) {
        sums[0] += slope[k] * cosine[last - k];
        sums[1] += slope[k] * sine[last - k];
        sums[2] += slope[k + 1] * cosine[last - k - 1];
        sums[3] += slope[k + 1] * sine[last - k - 1];
    }
    if (k < last) {
        sums[0] += slope[k] * cosine[last - k];
        sums[1] += slope[k] * sine[last - k];
    }
    R of_cosine = slope[0] * cosine[last];
    R of_sine = slope[0] * sine[last];
    if (last > 0) {
        of_cosine += slope[last] * cosine[0];
        of_sine += slope[last] * sine[0];
    }
    const auto degree = static_cast<R>(n);
    sine[n] = (of_cosine + (sums[0] + sums[2])) / degree;
    cosine[n] = -(of_sine + (sums[1] + sums[3])) / degree;
}

template <class R>
void placed_steps<R>::run_power(const step& of, int n) {
    const auto degree = static_cast<R>(n);
    R* const slope = of.behind;
    const R rising = sum_in_fours(of.b, of.result, n - 1, 0, n - 1) * of.factor;
    const R falling = sum_in_fours(of.a, slope, n - 1, 1, n - 1);
    of.result[n] = (rising - falling) / (of.a[0] * degree);
    slope[n - 1] = of.result[n] * degree;
}

}  // namespace libration::ode
