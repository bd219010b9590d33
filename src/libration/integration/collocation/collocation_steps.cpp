#include "collocation_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "libration/scalar/inner_product.hpp"

namespace libration::ode {

namespace {

// Of the guess: Newton's method converges from there.
constexpr long double tolerance_of_guess = 1e-3L;
constexpr long double part_of_largest_start = 1e-8L;

template <class T>
T times_power_of_2(const T& x, long exponent) {
    using std::ldexp;
    return T(ldexp(x, static_cast<int>(exponent)));
}

// Of |x| 2^-scale.
template <class T>
double log10_of(const T& x, long scale) {
    const long exponent = binary_exponent(x);
    if (exponent == exponent_of_zero) {
        return -std::numeric_limits<double>::infinity();
    }
    const auto mantissa = convert<long double>(times_power_of_2(x, -exponent));
    return static_cast<double>(std::log10(std::fabs(mantissa))) +
           static_cast<double>(exponent - scale) * std::log10(2.);
}

}  // namespace

template <ordered_scalar T>
collocation_steps<T>::collocation_steps(const first_order_form& form, const number& point,
                                        const step_tolerance& tolerance)
    : tolerance_(tolerance), slopes_of_(form, point, false), derivatives_of_(form, point, true), guide_(equations()) {}

// The right-hand sides in long double, of which the derivatives determine the corrections of Newton's method.
template <ordered_scalar T>
stiff_equations collocation_steps<T>::equations() {
    return {derivatives_of_.places(),
            [this](long double time, const std::vector<long double>& state, bool with_entries) {
                derivatives_of_.compute_at(time, state.data());
                stiff_equations::result all;
                for (std::size_t i = 0; i < state.size(); ++i) {
                    all.slopes.push_back(derivatives_of_.slope(i));
                }
                for (std::size_t k = 0; with_entries && k < derivatives_of_.places().size(); ++k) {
                    all.entries.push_back(derivatives_of_.entry(k));
                }
                return all;
            }};
}

template <ordered_scalar T>
bool collocation_steps<T>::is_smooth_over(const T& time, const std::vector<T>& state, const T& length) {
    std::vector<long double> rounded;
    for (const T& each : state) {
        rounded.push_back(convert<long double>(each));
        if (rounded.back() == 0 && each != 0) {
            return false;  // below the range of long double
        }
    }
    return guide_.is_smooth_over_steps(convert<long double>(time), rounded, convert<long double>(length), state.size());
}

template <ordered_scalar T>
void collocation_steps<T>::begin(const T& time, std::vector<T> state, const T& length) {
    if (!nodes_) {
        nodes_ = std::make_unique<node_matrices<T>>(tolerance_.degree);
    }
    time_ = time;
    start_ = std::move(state);
    length_ = length;
    change_length(1);
    prepared_ = false;
    growth_.restart();
}

// Rounded to a few bits, so that times and halves are exact in most steps.
template <ordered_scalar T>
void collocation_steps<T>::change_length(double factor) {
    constexpr int bits = 24;
    const long exponent = binary_exponent(length_);
    const auto mantissa = convert<long double>(times_power_of_2(length_, -exponent)) * factor;
    length_ = times_power_of_2(T(static_cast<long>(std::lround(std::ldexp(mantissa, bits)))), exponent - bits);
    half_ = T(length_ / 2);
}

template <ordered_scalar T>
bool collocation_steps<T>::prepare() {
    for (int rejected = 0; !prepared_ && rejected < length_growth::most_rejections; ++rejected) {
        if (T(time_ + length_) == time_) {
            return false;
        }
        switch (solve()) {
            case outcome::solved:
                growth_.accept(factor_);
                prepared_ = true;
                return true;
            case outcome::too_long: change_length(length_growth::reduction(factor_)); break;
            case outcome::failed: change_length(0.5); break;
        }
        growth_.restart();
    }
    return prepared_;
}

template <ordered_scalar T>
void collocation_steps<T>::step() {
    time_ = T(time_ + length_);
    start_.assign(values_.end() - static_cast<std::ptrdiff_t>(size()), values_.end());
    prepared_ = false;
    change_length(growth_.factor());
}

template <ordered_scalar T>
typename collocation_steps<T>::outcome collocation_steps<T>::solve() {
    if (!guess() || !iterate()) {
        return outcome::failed;
    }
    interpolate();
    return measure_tail();
}

// Values at the nodes to a few digits, and the scales.
template <ordered_scalar T>
bool collocation_steps<T>::guess() {
    stiff_guide::request asked;
    long double largest = 0;
    for (const T& each : start_) {
        asked.start.push_back(convert<long double>(each));
        largest = std::max(largest, std::fabs(asked.start.back()));
    }
    const auto least = std::ldexp(1.0L, static_cast<int>(tolerance_.least_scale));
    for (const long double each : asked.start) {
        asked.floors.push_back(each == 0 ? std::max(least, part_of_largest_start * largest) : least);
    }
    asked.time = convert<long double>(time_);
    asked.length = convert<long double>(length_);
    asked.tolerance = tolerance_of_guess;
    std::vector<long double> parts;
    for (const T& each : nodes_->places) {
        parts.push_back((convert<long double>(each) + 1) / 2);
    }
    const auto states = guide_.states(asked, parts);
    if (!states) {
        return false;
    }
    values_.clear();
    scales_.assign(size(), tolerance_.least_scale);
    for (const auto& state : *states) {
        for (std::size_t i = 0; i < size(); ++i) {
            if (!std::isfinite(state[i])) {
                return false;
            }
            values_.push_back(convert<T>(state[i]));
            scales_[i] = std::max({scales_[i], binary_exponent(state[i]), binary_exponent(start_[i])});
        }
    }
    return true;
}

template <ordered_scalar T>
bool collocation_steps<T>::factor() {
    const std::size_t n = size();
    std::vector<long double> jacobians(nodes_->size() * n * n, 0);
    const auto half = convert<long double>(half_);
    std::vector<long double> state(n);
    for (std::size_t k = 0; k < nodes_->size(); ++k) {
        for (std::size_t i = 0; i < n; ++i) {
            state[i] = convert<long double>(values_[k * n + i]);
        }
        derivatives_of_.compute_at(convert<long double>(time_at(k)), state.data());
        for (std::size_t place = 0; place < derivatives_of_.places().size(); ++place) {
            const auto [row, column] = derivatives_of_.places()[place];
            jacobians[(k * n + row) * n + column] =
                times_power_of_2(derivatives_of_.entry(place) * half, scales_[column] - scales_[row]);
        }
    }
    return matrix_.factor(nodes_->rounded_integrals, jacobians, n);
}

// Corrects the values; returns the decimal logarithm of the largest correction relative to the scale.
template <ordered_scalar T>
double collocation_steps<T>::correct() {
    const std::size_t n = size();
    slopes_.resize(values_.size());
    for (std::size_t k = 0; k < nodes_->size(); ++k) {
        slopes_of_.compute_at(time_at(k), &values_[k * n]);
        for (std::size_t i = 0; i < n; ++i) {
            slopes_[k * n + i] = T(slopes_of_.slope(i) * half_);
        }
    }
    std::vector<T> residuals(values_.size());
    long largest = exponent_of_zero;
    for (std::size_t k = 0; k < nodes_->size(); ++k) {
        for (std::size_t i = 0; i < n; ++i) {
            const T sum = inner_product(&nodes_->integrals[k * nodes_->size()], 1, &slopes_[i], static_cast<int>(n),
                                        static_cast<int>(nodes_->size()));
            T& residual = residuals[k * n + i];
            residual = times_power_of_2(T(T(start_[i] - values_[k * n + i]) + sum), -scales_[i]);
            if (!(T(residual - residual) == 0)) {  // not finite
                return std::numeric_limits<double>::infinity();
            }
            largest = std::max(largest, binary_exponent(residual));
        }
    }
    if (largest == exponent_of_zero) {
        return -std::numeric_limits<double>::infinity();
    }
    std::vector<long double> right;
    right.reserve(residuals.size());
    for (const T& each : residuals) {
        right.push_back(convert<long double>(times_power_of_2(each, -largest)));
    }
    long double most = 0;
    const auto corrections = matrix_.solved(right);
    for (std::size_t k = 0; k < values_.size(); ++k) {
        if (!std::isfinite(corrections[k])) {
            return std::numeric_limits<double>::infinity();
        }
        most = std::max(most, std::fabs(corrections[k]));
        values_[k] += times_power_of_2(convert<T>(corrections[k]), largest + scales_[k % n]);
    }
    return log10_of(most, -largest);
}

// Newton's method until the next correction would be negligible, or corrections have become as small as rounding
// permits.
template <ordered_scalar T>
bool collocation_steps<T>::iterate() {
    if (!factor()) {
        return false;
    }
    double last = 0;
    int factorisations = 1;
    for (int k = 0; k < newton_control::most_iterations; ++k) {
        const double now = correct();
        if (!(now < newton_control::diverged)) {
            return false;
        }
        const double gain = k > 0 ? now - last : 0;
        if (now < -tolerance_.aimed || (gain < newton_control::none && now + gain < -tolerance_.aimed)) {
            return true;
        }
        if (k > 0 && gain > newton_control::none && now < -tolerance_.accepted) {
            return true;
        }
        if (k > 0 && gain > newton_control::gain) {
            if (factorisations == newton_control::most_factorisations) {
                return false;
            }
            if (!factor()) {
                return false;
            }
            ++factorisations;
        }
        last = now;
    }
    return false;
}

// The polynomials through the values at the nodes and at the beginning: the interpolant of the nodes plus a multiple of
// T_{N+1} - T_N, which vanishes at all nodes.
template <ordered_scalar T>
void collocation_steps<T>::interpolate() {
    const std::size_t count = nodes_->size();
    coefficients_.assign(size() * (count + 1), T(0));
    for (std::size_t i = 0; i < size(); ++i) {
        T* const of = &coefficients_[i * (count + 1)];
        T rest = start_[i];
        for (std::size_t l = 0; l < count; ++l) {
            of[l] = inner_product(&nodes_->coefficients[l * count], 1, &values_[i], static_cast<int>(size()),
                                  static_cast<int>(count));
            rest = l % 2 == 0 ? T(rest - of[l]) : T(rest + of[l]);
        }
        const T half = count % 2 == 0 ? T(rest / 2) : T(-rest / 2);
        of[count] += half;
        of[count - 1] -= half;
    }
}

// True if the last Chebyshev coefficients are small enough and no unknown decays too much; sets the factor by which the
// length is to change.
template <ordered_scalar T>
typename collocation_steps<T>::outcome collocation_steps<T>::measure_tail() {
    const std::size_t count = nodes_->size();
    step_measure measured{.tail = -std::numeric_limits<double>::infinity(), .reached = 4};
    for (std::size_t i = 0; i < size(); ++i) {
        const T* const of = &coefficients_[i * (count + 1)];
        // Without the multiple of T_{N+1} - T_N: a jump at the beginning is not resolved, and decays.
        const T jump = of[count];
        for (std::size_t l = count - 1; l >= 2; --l) {
            const double here = log10_of(l + 1 == count ? T(of[l] + jump) : of[l], scales_[i]);
            measured.tail = l + 3 >= count ? std::max(measured.tail, here) : measured.tail;
            if (here > -tolerance_.aimed) {
                measured.reached = std::max(measured.reached, l);
                if (l + 3 < count) {
                    break;
                }
            }
        }
        if (scales_[i] > tolerance_.least_scale) {
            measured.note_decay(log10_of(start_[i], scales_[i]), log10_of(values_[count / 2 * size() + i], scales_[i]),
                                log10_of(values_[(count - 1) * size() + i], scales_[i]));
        }
    }
    factor_ = measured.factor(tolerance_.aimed, tolerance_.degree);
    return measured.is_acceptable(tolerance_.accepted) ? outcome::solved : outcome::too_long;
}

// By Clenshaw's recurrence.
template <ordered_scalar T>
std::vector<T> collocation_steps<T>::values_at(const T& distance) const {
    if (distance == 0) {
        return start_;  // without rounding
    }
    const std::size_t count = nodes_->size() + 1;
    const T x = T(distance / half_ - 1);
    const T twice = T(2 * x);
    std::vector<T> result;
    for (std::size_t i = 0; i < size(); ++i) {
        const T* const of = &coefficients_[i * count];
        T above(0);
        T next(0);
        for (std::size_t l = count - 1; l > 0; --l) {
            T here = T(T(twice * above) - next + of[l]);
            next = std::exchange(above, std::move(here));
        }
        result.push_back(T(T(x * above) - next + of[0]));
    }
    return result;
}

template class collocation_steps<long double>;
template class collocation_steps<quad>;
template class collocation_steps<mpfr>;

}  // namespace libration::ode
