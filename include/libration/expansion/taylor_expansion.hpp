// Taylor coefficients of the solution of any system of differential equations, in any field.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "libration/expansion/coefficient_digits.hpp"
#include "libration/expansion/placed_steps.hpp"
#include "libration/expansion/step_arrays.hpp"
#include "libration/series/arithmetic.hpp"

namespace libration::ode {

/// The values of the unknowns and their lower derivatives at a point: [unknown][derivative].
template <field R>
using solution_state = std::vector<std::vector<R>>;

/// Coefficients 0 .. N of an unknown of first order that are known from elsewhere, instead of those by its equation.
template <field R>
struct known_series {
    int unknown = 0;
    std::vector<R> coefficients;
};

/// The series about one point: coefficient n of each step of the tape from the lower ones, by the kernels of series/,
/// and y^(j)_{n+1} = y^(j+1)_n/(n + 1). Exact over fractions, an enclosure of each coefficient on balls, otherwise
/// rounded as the kernels do. O(N^2) products for each step that is a product or a function, O(N) for the others; a
/// symmetry of the initial values (tape::about_start) divides that by its square. With a fast product of whole
/// sequences (blocked_sums.hpp; expansion/fast_product.hpp) about O(N) for each such step. The arrays are allocated once
/// and can be used for any number of points. Of mpfr and balls, what follows from coefficient n has the digits of
/// coefficient_digits.
template <field R>
class taylor_expansion {
public:
    /// Up to the power N >= 0 of each unknown. Throws error for N < 0, and for constants that R cannot represent. The
    /// tape and the product must outlive this object.
    taylor_expansion(const tape& of, int order, const series::block_product<R>* fast = nullptr);

    /// Expands about the initial point of the system. The tape must be made by tape::about_start, or by
    /// tape::about_points if that is the same. Throws error if a function or an initial value is not available in R.
    void about_start();
    /// Expands about another point, which may be complex, from the state there. Not for a singular tape. The values of
    /// known unknowns in the state are not used.
    void about(const R& point, const solution_state<R>& state, const std::vector<known_series<R>>& known = {});

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
    /// The same into a state that may have been used before: then nothing is allocated in hardware scalars.
    void at(const R& distance, solution_state<R>& state) const;

private:
    void values_at(const R& distance, solution_state<R>& state) const requires std::floating_point<R>;
    R* array(int step) { return arrays_.array(step); }
    const R* array(int step) const { return arrays_.array(step); }

    void run_placed(int steps_until, const std::vector<known_series<R>>& known) requires std::floating_point<R>;
    void run(const std::vector<known_series<R>>& known = {});
    void set_known(int n, const std::vector<known_series<R>>& known);
    void run_singular();
    void set_newest(int unknown, int n, const R& value);
    R solved(int unknown, int n) const;

    const tape* tape_;
    int order_;
    step_arrays<R> arrays_;
    std::vector<std::vector<std::vector<R>>> weights_;
    std::vector<std::vector<int>> states_;  // steps of the derivatives of each unknown
    placed_steps<R> placed_;                // in hardware scalars, about any point except the initial one
};

template <field R>
taylor_expansion<R>::taylor_expansion(const tape& of, int order, const series::block_product<R>* fast)
    : tape_(&of), order_(order), arrays_(of, order, fast) {
    for (const int q : of.orders()) {
        states_.emplace_back(static_cast<std::size_t>(q), -1);
    }
    for (const tape_state& each : of.states()) {
        states_[static_cast<std::size_t>(each.unknown)][static_cast<std::size_t>(each.derivative)] = each.step;
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
}

template <field R>
void taylor_expansion<R>::about_start() {
    arrays_.begin_at_start();
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
void taylor_expansion<R>::about(const R& point, const solution_state<R>& state,
                                const std::vector<known_series<R>>& known) {
    arrays_.begin_at(point);
    for (std::size_t i = 0; i < states_.size(); ++i) {
        for (std::size_t j = 0; j < states_[i].size(); ++j) {
            array(states_[i][j])[0] = state[i][j];
        }
    }
    set_known(0, known);
    run(known);
}

template <field R>
void taylor_expansion<R>::set_known(int n, const std::vector<known_series<R>>& known) {
    for (const known_series<R>& each : known) {
        array(states_[static_cast<std::size_t>(each.unknown)][0])[n] = each.coefficients[static_cast<std::size_t>(n)];
    }
}

template <field R>
void taylor_expansion<R>::run(const std::vector<known_series<R>>& known) {
    int lowest = static_cast<int>(arrays_.length());
    for (const int q : tape_->orders()) {
        lowest = std::min(lowest, q);
    }
    if constexpr (std::is_floating_point_v<R>) {
        if (!arrays_.about_start()) {
            run_placed(order_ - lowest, known);
            return;
        }
    }
    const int count = static_cast<int>(tape_->steps().size());
    for (int n = 0; n < order_; ++n) {
        const coefficient_scope fewer_digits(n);
        for (int i = 0; i < count && n + lowest <= order_; ++i) {
            arrays_.compute(i, n);
        }
        for (std::size_t i = 0; i < states_.size(); ++i) {
            const R* above = array(tape_->outputs()[i]);
            for (std::size_t j = states_[i].size(); j-- > 0;) {
                R* const here = array(states_[i][j]);
                if (arrays_.degrees_of(states_[i][j]).holds(n + 1)) {
                    here[n + 1] = n == 0 ? above[n] : R(above[n] / (n + 1));
                }
                above = here;
            }
        }
        set_known(n + 1, known);
    }
}

template <field R>
void taylor_expansion<R>::run_placed(int steps_until,
                                     const std::vector<known_series<R>>& known) requires std::floating_point<R> {
    if (placed_.empty()) {
        placed_ = placed_steps<R>(*tape_, arrays_.array(0), arrays_.length(), arrays_.constants(), states_);
    }
    const std::function<void(int, int)> otherwise = [this](int index, int n) { arrays_.compute(index, n); };
    const int last = std::min(steps_until, order_ - 1);
    if (known.empty()) {
        placed_.run(0, last, otherwise);
    } else {
        for (int n = 0; n <= last; ++n) {
            placed_.run(n, n, otherwise);
            set_known(n + 1, known);
        }
    }
    for (int n = std::max(last + 1, 0); n < order_; ++n) {
        placed_.advance(n);
        set_known(n + 1, known);
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
            arrays_.compute(i, n);
        }
        for (int k = 0; k < unknowns; ++k) {
            if (!given[static_cast<std::size_t>(k)]) {
                set_newest(k, n, solved(k, n));
            }
        }
        for (int i = 0; i < count; ++i) {
            if (tape_->steps()[static_cast<std::size_t>(i)].newest) {
                arrays_.compute(i, n);
            }
        }
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
            values_at(distance, result);
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

template <field R>
void taylor_expansion<R>::at(const R& distance, solution_state<R>& state) const {
    if constexpr (std::is_floating_point_v<R>) {
        if (!tape_->is_singular()) {
            values_at(distance, state);
            return;
        }
    }
    state = at(distance);
}

template <field R>
void taylor_expansion<R>::values_at(const R& distance, solution_state<R>& state) const requires std::floating_point<R> {
    polynomial_values<R> several(order_, distance);
    state.resize(states_.size());
    for (std::size_t i = 0; i < states_.size(); ++i) {
        state[i].resize(states_[i].size());
        for (std::size_t j = 0; j < states_[i].size(); ++j) {
            several.add(array(states_[i][j]), state[i][j]);
        }
    }
    several.end();
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
