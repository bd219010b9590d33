// The steps of a tape with the addresses of their arrays, for hardware scalars about any point: looking the arrays up
// would take as long as the sums there.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "libration/expansion/step_kernels.hpp"
#include "libration/expansion/step_lanes.hpp"

namespace libration::ode {

/// The steps of a tape that are computed, in an order in which operands come first and, where possible, the next step
/// uses the result of the one before.
std::vector<int> steps_in_chains(const tape& of);

/// The steps of a tape whose step i has its coefficients at arrays + i length; the tape and the arrays must not move.
/// In double, steps with the same operation run in lanes.
template <class R>
class placed_steps {
public:
    placed_steps() = default;
    /// states[i][j] is the step of derivative j of unknown i.
    placed_steps(const tape& of, R* arrays, std::size_t length, const std::vector<R>& constants,
                 const std::vector<std::vector<int>>& states);

    bool empty() const { return all_integrals_.empty(); }
    /// Coefficients n = first .. last of all steps from the lower ones, and n + 1 of the unknowns and their lower
    /// derivatives; otherwise(i, n) computes coefficient n of step i if it requires more than sums.
    void run(int first, int last, const std::function<void(int, int)>& otherwise);
    /// Coefficient n + 1 of the unknowns and their lower derivatives.
    void advance(int n) { run_steps<R>({}, all_integrals_, n, n, {}); }

private:
    using step = placed_step<R>;

    // a_n factor as a sum.
    void set_multiple(step& to, const R& factor) {
        to.rule = coefficient_rule::linear;
        to.factor = factor;
        to.other = 1;
        to.b = nothing_.data();
    }
    void join();
    static coefficient_rule rule_of(const tape_step& step);
    static bool begins_with_value(operation kind);

    std::vector<step> begin_;  // for coefficient 0
    std::vector<step> later_;  // those with coefficients after coefficient 0
    std::vector<placed_integral<R>> all_integrals_;
    std::vector<placed_integral<R>> integrals_;  // those that are not formed with a step
    std::vector<R> nothing_;                     // -0, which changes no sum
    step_lanes lanes_;
};

template <class R>
placed_steps<R>::placed_steps(const tape& of, R* arrays, std::size_t length, const std::vector<R>& constants,
                              const std::vector<std::vector<int>>& states) {
    const auto array = [&](int i) { return i < 0 ? nullptr : arrays + static_cast<std::size_t>(i) * length; };
    std::vector<R> factors;
    std::vector<step> steps;  // of each step of the tape
    nothing_.assign(length, -R(0));
    for (int i = 0; i < static_cast<int>(of.steps().size()); ++i) {
        const tape_step& s = of.steps()[static_cast<std::size_t>(i)];
        const auto divisor = static_cast<R>(s.denominator);
        factors.push_back(s.constant >= 0      ? constants[static_cast<std::size_t>(s.constant)]
                          : s.has_one_factor() ? static_cast<R>(s.numerator) / divisor
                                               : static_cast<R>(s.numerator));
        steps.push_back({rule_of(s), newest_operand::none, i, array(i), array(s.left), array(s.right), factors.back(),
                         divisor, nullptr, array(i + 1), array(s.derivative)});
        if (s.kind == operation::sum || s.kind == operation::difference) {
            steps.back().factor = 1;
            steps.back().other = s.kind == operation::sum ? 1 : -1;
        } else if (s.kind == operation::scaled && s.has_one_factor()) {
            set_multiple(steps.back(), factors.back());
        }
    }
    for (std::size_t i = 0; i < states.size(); ++i) {
        const R* above = array(of.outputs()[i]);
        for (std::size_t j = states[i].size(); j-- > 0;) {
            all_integrals_.push_back({array(states[i][j]), above});
            above = array(states[i][j]);
        }
    }
    if constexpr (std::same_as<R, double>) {
        lanes_ = step_lanes(of, arrays, length, factors);
    }
    const std::vector<int> chains = steps_in_chains(of);
    for (const int i : chains) {
        begin_.push_back(steps[static_cast<std::size_t>(i)]);
        if (begins_with_value(of.steps()[static_cast<std::size_t>(i)].kind)) {
            begin_.back().rule = coefficient_rule::otherwise;
        }
    }
    for (const int i : lanes_.empty() ? chains : lanes_.alone()) {
        if (of.steps()[static_cast<std::size_t>(i)].kind != operation::constant || !lanes_.empty()) {
            later_.push_back(steps[static_cast<std::size_t>(i)]);
            if (later_.back().rule == coefficient_rule::raised) {
                set_multiple(later_.back(), 1);
            }
        }
    }
    if (lanes_.empty()) {
        integrals_ = all_integrals_;
        join();
    }
}

// Notes the operands that are the newest, and forms integrals where the integrand is.
template <class R>
void placed_steps<R>::join() {
    const R* before = nullptr;
    for (step& each : later_) {
        if (before != nullptr) {
            each.newest = each.a == before   ? newest_operand::a
                          : each.b == before ? newest_operand::b
                                             : newest_operand::none;
        }
        before = each.rule == coefficient_rule::slope ? nullptr : each.result;
        const auto integral = std::ranges::find(integrals_, before, &placed_integral<R>::a);
        if (integral != integrals_.end()) {
            each.integral = integral->result;
            integrals_.erase(integral);
        }
    }
}

template <class R>
void placed_steps<R>::run(int first, int last, const std::function<void(int, int)>& otherwise) {
    if (first == 0 && last >= 0) {
        run_steps<R>(begin_, all_integrals_, 0, 0, otherwise);
        if (!lanes_.empty()) {
            lanes_.begin();
        }
        ++first;
    }
    if (lanes_.empty()) {
        run_steps<R>(later_, integrals_, first, last, otherwise);
        return;
    }
    for (int n = first; n <= last; ++n) {
        lanes_.take_states(n);
        for (const step_lanes::entry& each : lanes_.order()) {
            if (each.alone) {
                run_steps<R>(std::span(later_).subspan(each.first, each.count), {}, n, n, otherwise);
                lanes_.take(each, n);
            } else {
                lanes_.run(each, n);
            }
        }
        advance(n);
    }
}

template <class R>
coefficient_rule placed_steps<R>::rule_of(const tape_step& step) {
    switch (step.kind) {
        case operation::constant: return coefficient_rule::constant;
        case operation::sum:
        case operation::difference: return coefficient_rule::linear;
        case operation::scaled: return step.has_one_factor() ? coefficient_rule::linear : coefficient_rule::fraction;
        case operation::raised: return coefficient_rule::raised;
        case operation::product: return coefficient_rule::product;
        case operation::square: return coefficient_rule::square;
        case operation::quotient: return coefficient_rule::quotient;
        case operation::slope: return coefficient_rule::slope;
        case operation::square_root: return coefficient_rule::square_root;
        case operation::primitive: return coefficient_rule::primitive;
        case operation::power: return coefficient_rule::power;
        case operation::function:
            return step.function == function_kind::sin ? coefficient_rule::sine_cosine : coefficient_rule::otherwise;
        case operation::variable:
        case operation::state:
        case operation::by_variable:
        case operation::delayed:
        case operation::companion: break;
    }
    return coefficient_rule::otherwise;
}

// Whether coefficient 0 does not follow the rule of the others.
template <class R>
bool placed_steps<R>::begins_with_value(operation kind) {
    switch (kind) {
        case operation::variable:
        case operation::by_variable:
        case operation::delayed:
        case operation::square_root:
        case operation::power:
        case operation::function:
        case operation::primitive: return true;
        case operation::constant:
        case operation::raised:
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

}  // namespace libration::ode
