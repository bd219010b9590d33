// The steps of a tape with the addresses of their arrays, for hardware scalars about any point: looking the arrays up
// would take as long as the sums there.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <vector>

#include "libration/ode/step_lanes.hpp"
#include "libration/series/kernel.hpp"

namespace libration::ode {

/// sum_{k=first}^{last} a_k b_{n-k} in four independent partial sums.
template <std::floating_point R>
R sum_in_fours(const R* a, const R* b, int n, int first, int last) {
    std::array<R, 4> sums{R(0), R(0), R(0), R(0)};
    int k = first;
    for (; k + 3 <= last; k += 4) {
        sums[0] += a[k] * b[n - k];
        sums[1] += a[k + 1] * b[n - k - 1];
        sums[2] += a[k + 2] * b[n - k - 2];
        sums[3] += a[k + 3] * b[n - k - 3];
    }
    for (; k <= last; ++k) {
        sums[0] += a[k] * b[n - k];
    }
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
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
        for (const state& each : states_) {
            each.here[n + 1] = each.above[n] / static_cast<R>(n + 1);
        }
    }

private:
    struct step {
        operation kind;
        int index;
        R* result;
        const R* a;
        const R* b;
        R* behind;    // array of the next step
        R factor;     // the constant, or the numerator over a denominator
        int divisor;  // for multiples, if it is not 1
        function_kind function;
        const R* derivative;  // for a primitive
    };
    struct state {
        R* here;
        const R* above;
    };

    static bool computed(const step& each, int n);
    static bool computed_from_first(const step& each, int n);
    template <class Otherwise>
    static void run_one(const step& each, int n, const Otherwise& otherwise) {
        if (!computed(each, n)) {
            otherwise(each.index);
        }
    }

    std::vector<step> steps_;
    std::vector<std::size_t> place_of_;  // index of each step of the tape among these
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
        if (s.kind != operation::state && s.kind != operation::companion) {
            steps_.push_back({s.kind, i, array(i), s.left < 0 ? nullptr : array(s.left),
                              s.right < 0 ? nullptr : array(s.right), array(i + 1), factors.back(), s.denominator,
                              s.function, s.derivative < 0 ? nullptr : array(s.derivative)});
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
    if (n > 0 && !lanes_.empty()) {
        lanes_.take_states(n);
        for (const step_lanes::entry& each : lanes_.order()) {
            if (each.alone) {
                run_one(steps_[place_of_[each.first]], n, otherwise);
                lanes_.take(each, n);
            } else {
                lanes_.run(each, n);
            }
        }
        return;
    }
    for (const step& each : steps_) {
        run_one(each, n, otherwise);
    }
    if (!lanes_.empty()) {
        lanes_.begin();
    }
}

template <class R>
bool placed_steps<R>::computed(const step& each, int n) {
    const R* const a = each.a;
    const R* const b = each.b;
    R* const result = each.result;
    switch (each.kind) {
        case operation::sum: result[n] = a[n] + b[n]; return true;
        case operation::difference: result[n] = a[n] - b[n]; return true;
        case operation::product: result[n] = sum_in_fours(a, b, n, 0, n); return true;
        case operation::square: result[n] = square_in_fours(a, n, 0); return true;
        case operation::quotient: result[n] = (a[n] - sum_in_fours(b, result, n, 1, n)) / b[0]; return true;
        case operation::slope: series::slope_kernel(a, result, n); return true;
        case operation::scaled:
            result[n] = a[n] * each.factor;
            if (each.divisor != 1) {
                result[n] /= static_cast<R>(each.divisor);
            }
            return true;
        case operation::constant:
        case operation::variable:
        case operation::state:
        case operation::raised:
        case operation::by_variable:
        case operation::delayed:
        case operation::square_root:
        case operation::power:
        case operation::function:
        case operation::primitive:
        case operation::companion: break;
    }
    return n > 0 && computed_from_first(each, n);
}

// Operations whose coefficient at n = 0 is computed separately.
template <class R>
bool placed_steps<R>::computed_from_first(const step& each, int n) {
    const R* const a = each.a;
    const R* const b = each.b;
    R* const result = each.result;
    const auto degree = static_cast<R>(n);
    switch (each.kind) {
        case operation::constant: return true;
        case operation::raised: result[n] = a[n]; return true;
        case operation::square_root: result[n] = (a[n] - square_in_fours(result, n, 1)) / each.behind[0]; return true;
        case operation::primitive: result[n] = sum_in_fours(b, each.derivative, n - 1, 0, n - 1) / degree; return true;
        case operation::function:
            if (each.function != function_kind::sin) {
                return false;
            }
            result[n] = sum_in_fours(b, each.behind, n - 1, 0, n - 1) / degree;
            each.behind[n] = -sum_in_fours(b, result, n - 1, 0, n - 1) / degree;
            return true;
        case operation::power: {
            R* const slope = each.behind;
            const R rising = sum_in_fours(b, result, n - 1, 0, n - 1) * each.factor;
            const R falling = sum_in_fours(a, slope, n - 1, 1, n - 1);
            result[n] = (rising - falling) / (a[0] * degree);
            slope[n - 1] = result[n] * degree;
            return true;
        }
        case operation::variable:
        case operation::state:
        case operation::sum:
        case operation::difference:
        case operation::scaled:
        case operation::by_variable:
        case operation::delayed:
        case operation::product:
        case operation::square:
        case operation::quotient:
        case operation::slope:
        case operation::companion: break;
    }
    return false;
}

}  // namespace libration::ode
