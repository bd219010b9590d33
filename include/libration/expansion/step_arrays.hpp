// The coefficient arrays of the steps of a tape about one point, and how each coefficient follows from the lower ones.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "libration/equation/constant_value.hpp"
#include "libration/equation/function_value.hpp"
#include "libration/expansion/tape.hpp"
#include "libration/scalar/error.hpp"
#include "libration/series/blocked_sums.hpp"
#include "libration/series/kernel.hpp"

namespace libration::ode {

/// The arrays are allocated once and can be used for any number of points. The caller sets the coefficients of the
/// states, of any derivative of an unknown, in increasing order; compute() derives those of the other steps.
template <field R>
class step_arrays {
public:
    /// For coefficients 0 .. N of the unknowns. Throws error for N < 0, and for constants that R cannot represent. The
    /// tape and the product must outlive this object.
    step_arrays(const tape& of, int order, const series::block_product<R>* fast);

    /// Coefficient n = 0, 1, .. of a step.
    R* array(int step) { return arrays_.data() + static_cast<std::size_t>(step) * length_; }
    const R* array(int step) const { return arrays_.data() + static_cast<std::size_t>(step) * length_; }
    std::size_t length() const { return length_; }
    const std::vector<R>& constants() const { return constants_; }
    /// The degrees of the coefficients of a step that may differ from 0.
    series::progression degrees_of(int step) const {
        const int residue = tape_->steps()[static_cast<std::size_t>(step)].residue;
        return {stride_, residue < 0 ? 0 : residue};
    }
    bool about_start() const { return exact_; }

    /// Begins at the initial point of the tape, with its exact values, or at another point.
    void begin_at_start();
    void begin_at(const R& point);
    /// Coefficient `at`, less the lag of the step, of a step that is not a state.
    void compute(int index, int at);

private:
    void clear();
    bool due(const tape_step& step, int n) const;
    void set_multiple(const tape_step& s, const R& a, R& result) const;
    void linear_step(const tape_step& s, int index, int n);
    void function_step(const tape_step& s, int index, int n);
    void set_centre(const tape_step& s, int index);
    template <class F>
    void set_kept(const tape_step& s, int index);
    void begin_table(const tape_step& s, int index);
    void next_in_table(const tape_step& s, int index, int n);
    void own_step(const tape_step& s, int index, int n);
    R centre(const tape_step& s) const;

    const tape* tape_;
    int stride_ = 1;  // of the tape about the initial point, 1 elsewhere
    bool exact_ = false;
    std::size_t length_;
    std::vector<R> constants_;
    std::vector<R> arrays_;
    series::blocked_sums<R> sums_;
    std::vector<std::vector<R>> tables_;  // of steps with a table, row after row; empty otherwise
    R point_ = R(0);
};

template <field R>
step_arrays<R>::step_arrays(const tape& of, int order, const series::block_product<R>* fast)
    : tape_(&of), sums_(fast, order) {
    if (order < 0) {
        throw error(error_kind::argument, "order", std::to_string(order), "of a series is negative");
    }
    int highest = 0;
    for (const int q : of.orders()) {
        highest = std::max(highest, q);
    }
    for (const number& each : of.constants()) {
        constants_.push_back(constant_value<R>::of(each));
    }
    length_ = static_cast<std::size_t>(order) + static_cast<std::size_t>(highest) + 1;
    arrays_.assign(of.steps().size() * length_, R(0));
}

// Removes remainders of an expansion about another point if a symmetry skips coefficients.
template <field R>
void step_arrays<R>::clear() {
    const R zero(0);
    for (R& each : arrays_) {
        each = zero;
    }
}

template <field R>
void step_arrays<R>::begin_at_start() {
    clear();
    sums_.restart();
    stride_ = tape_->stride();
    exact_ = true;
    point_ = constant_value<R>::of(tape_->point());
}

template <field R>
void step_arrays<R>::begin_at(const R& point) {
    if (stride_ != 1) {
        clear();
    }
    sums_.restart();
    stride_ = 1;
    exact_ = false;
    point_ = point;
}

template <field R>
bool step_arrays<R>::due(const tape_step& step, int n) const {
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
void step_arrays<R>::compute(int index, int at) {
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
void step_arrays<R>::linear_step(const tape_step& s, int index, int n) {
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
        case operation::scaled: set_multiple(s, a[n], result); return;
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

// In place, which saves allocations.
template <field R>
void step_arrays<R>::set_multiple(const tape_step& s, const R& a, R& result) const {
    if (s.constant >= 0) {
        result = R(a * constants_[static_cast<std::size_t>(s.constant)]);
        return;
    }
    if (s.numerator == 1) {
        result = a;
    } else {
        result = s.numerator == -1 ? R(-a) : R(a * s.numerator);
    }
    if (s.denominator != 1) {
        result = R(result / s.denominator);
    }
}

// f(x_0), or the exact value at the initial point.
template <field R>
R step_arrays<R>::centre(const tape_step& s) const {
    if (exact_ && s.centre) {
        return constant_value<R>::of(*s.centre);
    }
    const R& at = array(s.left)[0];
    if (s.constant >= 0) {
        const rational order = tape_->constants()[static_cast<std::size_t>(s.constant)].fraction().value();
        return function_value<R>(s.function, at, &order);
    }
    return function_value<R>(s.function, at);  // allocates nothing
}

// The values that are specific to the functions themselves.
template <field R>
void step_arrays<R>::set_centre(const tape_step& s, int index) {
    R& value = array(index)[0];
    if (s.kind == operation::power) {
        value = exact_ && s.centre ? constant_value<R>::of(*s.centre)
                                   : power_value<R>(array(s.left)[0], constants_[static_cast<std::size_t>(s.constant)]);
        return;
    }
    if (function::with_function(s.function, [](auto of) { return function::in_table<decltype(of)>; }) &&
        s.kind == operation::function) {
        begin_table(s, index);
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
void step_arrays<R>::set_kept(const tape_step& s, int index) {
    const auto call = [](function_kind f, const R& x) { return function_value<R>(f, x); };
    for (int i = 0; i < F::values_kept; ++i) {
        const int companion = index + 1 + i;
        const auto& exact = tape_->steps()[static_cast<std::size_t>(companion)].centre;
        array(companion)[0] =
            exact_ && exact ? constant_value<R>::of(*exact) : F::first_kept(i, array(s.left)[0], call);
    }
}

// Row j of the table is the series of f^(j)(x)/j!.
template <field R>
void step_arrays<R>::begin_table(const tape_step& s, int index) {
    const rational order = tape_->constants()[static_cast<std::size_t>(s.constant)].fraction().value();
    const R& at = array(s.left)[0];
    const auto values = function::with_function(s.function, [&](auto of) {
        using each = decltype(of);
        if constexpr (function::in_table<each>) {
            return series_values<each>(function::relative_order(order), at, static_cast<int>(length_));
        } else {
            return std::vector<R>();
        }
    });
    tables_.resize(tape_->steps().size());
    auto& table = tables_[static_cast<std::size_t>(index)];
    table.assign(length_ * length_, R(0));
    for (std::size_t j = 0; j < length_; ++j) {
        table[j * length_] = values[j];
    }
    array(index)[0] = values[0];
    array(index + 1)[0] = length_ > 1 ? values[1] : R(0);
}

// n g_{j,n} = (j + 1) sum_{k=1}^{n} k x_k g_{j+1,n-k} for g_j = f^(j)(x)/j!. The first two rows are the step and its companion.
template <field R>
void step_arrays<R>::next_in_table(const tape_step& s, int index, int n) {
    const R* const slope = array(s.right);
    auto& table = tables_[static_cast<std::size_t>(index)];
    const auto rows = static_cast<int>(length_) - n;
    for (int j = 0; j < rows && n > 0; ++j) {
        R* const row = table.data() + static_cast<std::size_t>(j) * length_;
        const R* const above = row + length_;
        const R sum = j + 1 < static_cast<int>(length_)
                          ? series::product_coefficient(slope, above, n - 1, degrees_of(s.right))
                          : R(0);
        row[n] = R(sum * (j + 1) / n);
    }
    if (n > 0) {
        array(index)[n] = table[static_cast<std::size_t>(n)];
        array(index + 1)[n] = length_ > 1 ? table[length_ + static_cast<std::size_t>(n)] : R(0);
    }
}

template <field R>
void step_arrays<R>::own_step(const tape_step& s, int index, int n) {
    function::with_function(s.function, [&](auto of) {
        using each = decltype(of);
        if constexpr (function::in_table<each>) {
            next_in_table(s, index, n);
        } else if constexpr (requires { each::kept; }) {
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
void step_arrays<R>::function_step(const tape_step& s, int index, int n) {
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

#ifdef LIBRATION_COMPILED
extern template class step_arrays<double>;
extern template class step_arrays<long double>;
extern template class step_arrays<quad>;
extern template class step_arrays<mpfr>;
extern template class step_arrays<rational>;
extern template class step_arrays<complex_number<double>>;
extern template class step_arrays<complex_number<mpfr>>;
#endif

}  // namespace libration::ode
