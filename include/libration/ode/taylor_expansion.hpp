// Taylor coefficients of the solution of any system of differential equations, in any field.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "libration/ode/constant_value.hpp"
#include "libration/ode/function_value.hpp"
#include "libration/ode/placed_steps.hpp"
#include "libration/ode/tape.hpp"
#include "libration/series/arithmetic.hpp"
#include "libration/series/blocked_sums.hpp"
#include "libration/series/kernel.hpp"

namespace libration::ode {

/// The values of the unknowns and their lower derivatives at a point: [unknown][derivative].
template <field R>
using solution_state = std::vector<std::vector<R>>;

/// The series about one point: coefficient n of each step of the tape from the lower ones, by the kernels of series/,
/// and y^(j)_{n+1} = y^(j+1)_n/(n + 1). Exact over fractions, an enclosure of each coefficient on balls, otherwise
/// rounded as the kernels do. O(N^2) products for each step that is a product or a function, O(N) for the others; a
/// symmetry of the initial values (tape::about_start) divides that by its square. With a fast product of whole
/// sequences (blocked_sums.hpp; ode/ball/fast_product.hpp) about O(N) for each such step. The arrays are allocated once
/// and can be used for any number of points.
template <field R>
class taylor_expansion {
public:
    /// Up to the power N >= 0 of each unknown. Throws error for N < 0, and for constants that R cannot represent. The
    /// tape and the product must outlive this object.
    taylor_expansion(const tape& of, int order, const series::block_product<R>* fast = nullptr);

    /// Expands about the initial point of the system. The tape must be made by tape::about_start, or by
    /// tape::about_points if that is the same. Throws error if a function or an initial value is not available in R.
    void about_start();
    /// Expands about another point, which may be complex, from the state there. Not for a singular tape.
    void about(const R& point, const solution_state<R>& state);

    int order() const { return order_; }
    /// Coefficient n = 0 .. N of (t - t0)^(n/root), all zero before the first call of about.
    const R* coefficients(int unknown) const { return array(states_[static_cast<std::size_t>(unknown)][0]); }
    /// Coefficients of y^(q), or of s^q y^(q) on a singular tape, as far as they were needed.
    const R* right_side(int unknown) const { return array(tape_->outputs()[static_cast<std::size_t>(unknown)]); }
    /// Coefficients of a derivative of an unknown below its order; not for a singular tape.
    const R* coefficients(int unknown, int derivative) const {
        return array(states_[static_cast<std::size_t>(unknown)][static_cast<std::size_t>(derivative)]);
    }
    series::power_series<R> series_of(int unknown) const {
        const R* const first = coefficients(unknown);
        return series::power_series<R>(std::vector<R>(first, first + order_ + 1));
    }
    /// Coefficients of a step of the tape, likewise; not in double, where they may be in lanes instead.
    const R* of_step(int step) const requires(!std::same_as<R, double>) { return array(step); }
    /// Coefficients of an observed expression, as far as the right-hand sides were needed.
    const R* watched(int which) const { return array(tape_->watched()[static_cast<std::size_t>(which)]); }
    /// The polynomials of degree N of the unknowns and of their lower derivatives, by Horner's rule, at a distance from
    /// the point; if the root is not 1, at nonzero distances only, and by the principal value of the root.
    solution_state<R> at(const R& distance) const;

private:
    R* array(int step) { return arrays_.data() + static_cast<std::size_t>(step) * length_; }
    const R* array(int step) const { return arrays_.data() + static_cast<std::size_t>(step) * length_; }
    series::progression degrees_of(int step) const {
        const int residue = tape_->steps()[static_cast<std::size_t>(step)].residue;
        return {stride_, residue < 0 ? 0 : residue};
    }
    bool due(const tape_step& step, int n) const;

    void run_placed(int steps_until) requires std::floating_point<R>;
    void clear();
    void run();
    void run_singular();
    void set_newest(int unknown, int n, const R& value);
    R solved(int unknown, int n) const;
    void step(int index, int at);
    R multiple(const tape_step& s, const R& a) const;
    void linear_step(const tape_step& s, int index, int n);
    void function_step(const tape_step& s, int index, int n);
    void set_centre(const tape_step& s, int index);
    template <class F>
    void set_kept(const tape_step& s, int index);
    void own_step(const tape_step& s, int index, int n);
    R centre(const tape_step& s) const;

    const tape* tape_;
    int order_;
    int stride_ = 1;  // of the tape about the initial point, 1 elsewhere
    bool exact_ = false;
    std::size_t length_;
    std::vector<R> constants_;
    std::vector<std::vector<std::vector<R>>> weights_;
    std::vector<std::vector<int>> states_;  // steps of the derivatives of each unknown
    std::vector<R> arrays_;
    series::blocked_sums<R> sums_;
    placed_steps<R> placed_;  // in hardware scalars, about any point except the initial one
    R point_ = R(0);
};

template <field R>
taylor_expansion<R>::taylor_expansion(const tape& of, int order, const series::block_product<R>* fast)
    : tape_(&of), order_(order), sums_(fast, order) {
    if (order < 0) {
        throw error(error_kind::argument, "order", std::to_string(order), "of a series is negative");
    }
    int highest = 0;
    for (const int q : of.orders()) {
        highest = std::max(highest, q);
        states_.emplace_back(static_cast<std::size_t>(q), -1);
    }
    for (const tape_state& each : of.states()) {
        states_[static_cast<std::size_t>(each.unknown)][static_cast<std::size_t>(each.derivative)] = each.step;
    }
    for (const number& each : of.constants()) {
        constants_.push_back(constant_value<R>::of(each));
    }
    for (const auto& right : of.weights()) {
        auto& rows = weights_.emplace_back();
        for (const auto& of_unknown : right) {
            auto& row = rows.emplace_back();
            for (const number& each : of_unknown) {
                row.push_back(constant_value<R>::of(each));
            }
        }
    }
    length_ = static_cast<std::size_t>(order) + static_cast<std::size_t>(highest) + 1;
    arrays_.assign(of.steps().size() * length_, R(0));
}

// Removes remainders of an expansion about another point if a symmetry skips coefficients.
template <field R>
void taylor_expansion<R>::clear() {
    const R zero(0);
    for (R& each : arrays_) {
        each = zero;
    }
}

template <field R>
void taylor_expansion<R>::about_start() {
    clear();
    sums_.restart();
    stride_ = tape_->stride();
    exact_ = true;
    point_ = constant_value<R>::of(tape_->point());
    if (tape_->is_singular()) {
        run_singular();
        return;
    }
    for (std::size_t i = 0; i < states_.size(); ++i) {
        for (std::size_t j = 0; j < states_[i].size(); ++j) {
            array(states_[i][j])[0] = constant_value<R>::of(tape_->starts()[i][j]);
        }
    }
    run();
}

template <field R>
void taylor_expansion<R>::about(const R& point, const solution_state<R>& state) {
    if (stride_ != 1) {
        clear();
    }
    sums_.restart();
    stride_ = 1;
    exact_ = false;
    point_ = point;
    for (std::size_t i = 0; i < states_.size(); ++i) {
        for (std::size_t j = 0; j < states_[i].size(); ++j) {
            array(states_[i][j])[0] = state[i][j];
        }
    }
    run();
}

template <field R>
bool taylor_expansion<R>::due(const tape_step& step, int n) const {
    if (stride_ == 1) {
        return !exact_ || step.residue >= 0 || (is_function(step.kind) && step.kind != operation::square_root);
    }
    if (step.kind == operation::slope) {
        --n;  // lags by one degree
    }
    const bool pair = step.odd;  // is computed together with an even one
    return (step.residue >= 0 && n % stride_ == step.residue) || (pair && n % stride_ == 0);
}

template <field R>
void taylor_expansion<R>::run() {
    int lowest = static_cast<int>(length_);
    for (const int q : tape_->orders()) {
        lowest = std::min(lowest, q);
    }
    if constexpr (std::is_floating_point_v<R>) {
        if (stride_ == 1 && !exact_) {
            run_placed(order_ - lowest);
            return;
        }
    }
    const int count = static_cast<int>(tape_->steps().size());
    for (int n = 0; n < order_; ++n) {
        for (int i = 0; i < count && n + lowest <= order_; ++i) {
            step(i, n);
        }
        for (std::size_t i = 0; i < states_.size(); ++i) {
            const R* above = array(tape_->outputs()[i]);
            for (std::size_t j = states_[i].size(); j-- > 0;) {
                R* const here = array(states_[i][j]);
                if (stride_ == 1 || degrees_of(states_[i][j]).holds(n + 1)) {
                    here[n + 1] = n == 0 ? above[n] : R(above[n] / (n + 1));
                }
                above = here;
            }
        }
    }
}

template <field R>
void taylor_expansion<R>::run_placed(int steps_until) requires std::floating_point<R> {
    if (placed_.empty()) {
        placed_ = placed_steps<R>(*tape_, arrays_.data(), length_, constants_, states_);
    }
    for (int n = 0; n < order_; ++n) {
        if (n <= steps_until) {
            placed_.run(n, [&](int index) { step(index, n); });
        }
        placed_.advance(n);
    }
}

// y_n and the corresponding coefficients of the derivatives, whose index n - l root must exist if y_n is nonzero.
template <field R>
void taylor_expansion<R>::set_newest(int unknown, int n, const R& value) {
    const int root = tape_->root();
    R derived = value;
    const auto& of_unknown = states_[static_cast<std::size_t>(unknown)];
    for (std::size_t l = 0; l < of_unknown.size(); ++l) {
        const int index = n - static_cast<int>(l) * root;
        if (of_unknown[l] >= 0 && index >= 0) {
            array(of_unknown[l])[index] = derived;
        }
        derived = R(derived * index);
        if (root != 1) {
            derived = R(derived / root);
        }
    }
}

// y_{k,n} from (n/root)(n/root - 1) .. y_n - sum weights (n/root) .. y_n = coefficient n of the right-hand side without
// y_n.
template <field R>
R taylor_expansion<R>::solved(int unknown, int n) const {
    const auto k = static_cast<std::size_t>(unknown);
    const int root = tape_->root();
    R falling(1);
    R factor(0);
    for (std::size_t l = 0; l < weights_[k][k].size(); ++l) {
        factor -= weights_[k][k][l] * falling;
        falling = R(falling * (n - static_cast<int>(l) * root) / root);
    }
    return array(tape_->outputs()[k])[n] / R(falling + factor);
}

template <field R>
void taylor_expansion<R>::run_singular() {
    const int count = static_cast<int>(tape_->steps().size());
    const int unknowns = static_cast<int>(states_.size());
    const int root = tape_->root();
    for (int n = 0; n <= order_; ++n) {
        std::vector<bool> given;
        for (int k = 0; k < unknowns; ++k) {
            const auto& starts = tape_->starts()[static_cast<std::size_t>(k)];
            const auto j = static_cast<std::size_t>(n / root);
            given.push_back(n % root == 0 && j < starts.size());
            R value(0);
            if (given.back()) {
                value = constant_value<R>::of(starts[j]);
                for (int i = 2; i <= static_cast<int>(j); ++i) {
                    value = R(value / i);
                }
            }
            set_newest(k, n, value);
        }
        for (int i = 0; i < count; ++i) {
            step(i, n);
        }
        for (int k = 0; k < unknowns; ++k) {
            if (!given[static_cast<std::size_t>(k)]) {
                set_newest(k, n, solved(k, n));
            }
        }
        for (int i = 0; i < count; ++i) {
            if (tape_->steps()[static_cast<std::size_t>(i)].newest) {
                step(i, n);
            }
        }
    }
}

template <field R>
void taylor_expansion<R>::step(int index, int at) {
    const tape_step& s = tape_->steps()[static_cast<std::size_t>(index)];
    const int n = at - s.lag;
    if (n < 0 || s.kind == operation::state || s.kind == operation::companion || !due(s, n)) {
        return;
    }
    if (is_linear(s.kind)) {
        linear_step(s, index, n);
    } else {
        function_step(s, index, n);
    }
}

template <field R>
void taylor_expansion<R>::linear_step(const tape_step& s, int index, int n) {
    R& result = array(index)[n];
    const R* const a = s.left < 0 ? nullptr : array(s.left);
    const R* const b = s.right < 0 ? nullptr : array(s.right);
    switch (s.kind) {
        case operation::constant:
            if (n == 0) {
                result = constants_[static_cast<std::size_t>(s.constant)];
            }
            return;
        case operation::variable:
            if (n == (tape_->is_singular() ? tape_->root() : 1)) {
                result = R(1);
            } else if (n == 0 && !tape_->is_singular()) {
                result = point_;
            }
            return;
        case operation::sum: result = R(a[n] + b[n]); return;
        case operation::difference: result = R(a[n] - b[n]); return;
        case operation::raised:
            result = n == 0 ? R(a[n] + constants_[static_cast<std::size_t>(s.constant)]) : a[n];
            return;
        case operation::by_variable: result = n == 0 ? R(point_ * a[0]) : R(point_ * a[n] + a[n - 1]); return;
        case operation::delayed: result = n < s.shift ? R(0) : a[n - s.shift]; return;
        case operation::scaled: result = multiple(s, a[n]); return;
        case operation::state:
        case operation::product:
        case operation::square:
        case operation::quotient:
        case operation::slope:
        case operation::square_root:
        case operation::power:
        case operation::function:
        case operation::primitive:
        case operation::companion: return;
    }
}

template <field R>
R taylor_expansion<R>::multiple(const tape_step& s, const R& a) const {
    if (s.constant >= 0) {
        return R(a * constants_[static_cast<std::size_t>(s.constant)]);
    }
    const R result = s.numerator == 1 ? a : s.numerator == -1 ? R(-a) : R(a * s.numerator);
    return s.denominator == 1 ? result : R(result / s.denominator);
}

// f(x_0), or the exact value at the initial point.
template <field R>
R taylor_expansion<R>::centre(const tape_step& s) const {
    if (exact_ && s.centre) {
        return constant_value<R>::of(*s.centre);
    }
    const rational order = s.kind == operation::primitive && s.constant >= 0
                               ? tape_->constants()[static_cast<std::size_t>(s.constant)].fraction().value()
                               : rational(0);
    return function_value<R>(s.function, array(s.left)[0], &order);
}

// The values that are specific to the functions themselves.
template <field R>
void taylor_expansion<R>::set_centre(const tape_step& s, int index) {
    R& value = array(index)[0];
    if (s.kind == operation::power) {
        value = exact_ && s.centre ? constant_value<R>::of(*s.centre)
                                   : power_value<R>(array(s.left)[0], constants_[static_cast<std::size_t>(s.constant)]);
        return;
    }
    value = centre(s);
    if (s.kind == operation::square_root) {
        array(index + 1)[0] = R(value * 2);
    } else if (s.kind == operation::function) {
        function::with_function(s.function, [&](auto of) {
            using each = decltype(of);
            if constexpr (requires { each::values_kept; }) {
                set_kept<each>(s, index);
            }
        });
    }
}

// The values of the companions that the recurrence of a function needs.
template <field R>
template <class F>
void taylor_expansion<R>::set_kept(const tape_step& s, int index) {
    const auto call = [](function_kind f, const R& x) { return function_value<R>(f, x); };
    for (int i = 0; i < F::values_kept; ++i) {
        const auto& exact = tape_->steps()[static_cast<std::size_t>(index + 1 + i)].centre;
        array(index + 1 + i)[0] =
            exact_ && exact ? constant_value<R>::of(*exact) : F::first_kept(i, array(s.left)[0], call);
    }
}

template <field R>
void taylor_expansion<R>::own_step(const tape_step& s, int index, int n) {
    function::with_function(s.function, [&](auto of) {
        using each = decltype(of);
        if constexpr (requires { each::kept; }) {
            function::series_arrays<R> arrays{array(s.left),
                                              array(s.right),
                                              array(index),
                                              {},
                                              degrees_of(s.left),
                                              degrees_of(s.right),
                                              series::progression(stride_, 0)};
            for (int i = 0; i < each::kept; ++i) {
                arrays.kept[static_cast<std::size_t>(i)] = array(index + 1 + i);
            }
            each::next_coefficient(arrays, n, sums_);
        }
    });
}

template <field R>
void taylor_expansion<R>::function_step(const tape_step& s, int index, int n) {
    using namespace series;
    if (n == 0 && is_function(s.kind)) {
        set_centre(s, index);
    }
    R* const result = array(index);
    const R* const a = array(s.left);
    const R* const b = s.right < 0 ? nullptr : array(s.right);
    const progression of_a = degrees_of(s.left);
    const progression of_slope = s.right < 0 ? of_a : degrees_of(s.right);
    const progression even(stride_, 0);
    switch (s.kind) {
        case operation::product: product_kernel(a, b, result, n, of_a, sums_); return;
        case operation::square: square_kernel(a, result, n, of_a, sums_); return;
        case operation::quotient: quotient_kernel(a, b, result, n, even, sums_); return;
        case operation::slope: slope_kernel(a, result, n); return;
        case operation::square_root: square_root_kernel(a, array(index + 1)[0], result, n, even, sums_); return;
        case operation::power: {
            const R& r = constants_[static_cast<std::size_t>(s.constant)];
            power_kernel(a, b, r, array(index + 1), result, n, even, sums_);
            return;
        }
        case operation::function: own_step(s, index, n); return;
        case operation::primitive:
            if (n > 0) {  // n w_n = sum_{k=1}^{n} k u_k f'(u)_{n-k}
                result[n] = R(sums_.product(b, array(s.derivative), n - 1, of_slope) / n);
            }
            return;
        case operation::constant:
        case operation::variable:
        case operation::state:
        case operation::sum:
        case operation::difference:
        case operation::scaled:
        case operation::raised:
        case operation::by_variable:
        case operation::delayed:
        case operation::companion: return;
    }
}

template <field R>
solution_state<R> taylor_expansion<R>::at(const R& distance) const {
    const int root = tape_->root();
    const R base = root == 1 ? distance : power_value<R>(distance, R(R(1) / root));
    solution_state<R> result;
    result.reserve(states_.size());
    if constexpr (std::is_floating_point_v<R>) {
        if (!tape_->is_singular()) {  // the series of the derivatives are available
            for (const auto& of_unknown : states_) {
                auto& values = result.emplace_back();
                values.reserve(of_unknown.size());
                for (const int step : of_unknown) {
                    const R* const y = array(step);
                    R value = y[order_];
                    for (int n = order_ - 1; n >= 0; --n) {
                        value = value * distance + y[n];
                    }
                    values.push_back(value);
                }
            }
            return result;
        }
    }
    for (std::size_t i = 0; i < states_.size(); ++i) {
        auto& of_unknown = result.emplace_back();
        series::power_series<R> y = series_of(static_cast<int>(i));
        R scale(1);
        for (std::size_t j = 0; j < states_[i].size(); ++j) {
            of_unknown.push_back(R(evaluate_value(y, base) * scale));
            if (root == 1) {
                y = series::derivative(y);
                continue;
            }
            for (int n = 0; n <= order_; ++n) {  // (n/root - j) s^(n/root - j - 1)
                y[n] = R(y[n] * (n - static_cast<int>(j) * root) / root);
            }
            scale /= distance;
        }
    }
    return result;
}

#ifdef LIBRATION_COMPILED
extern template class taylor_expansion<double>;
extern template class taylor_expansion<long double>;
extern template class taylor_expansion<quad>;
extern template class taylor_expansion<mpfr>;
extern template class taylor_expansion<rational>;
extern template class taylor_expansion<complex_number<double>>;
extern template class taylor_expansion<complex_number<mpfr>>;
#endif

}  // namespace libration::ode
