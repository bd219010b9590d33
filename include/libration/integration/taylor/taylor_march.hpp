// The solution of any system from its initial point to any time, by Taylor series in steps of adaptive length.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/equation/defined_zero.hpp"
#include "libration/expansion/taylor_expansion.hpp"
#include "libration/integration/integrator.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

/// The order ln(1/epsilon)/2 of least cost for steps of R/e^2, rounded up, plus two [JorbaZou2005].
constexpr int taylor_order(int bits) { return static_cast<int>((34658L * bits) / 100'000) + 3; }

/// mantissa 2^exponent.
struct step_length {
    int mantissa = 0;
    long exponent = 0;
};

/// |c_n| as a binary exponent, or exponent_of_zero.
struct coefficient_size {
    int degree = 0;
    long exponent = 0;
};

/// The accuracy of the steps of an integration: the last term of each is about 2^-bits of the size of the solution.
struct step_accuracy {
    int bits = 0;
    int order = 1;

    /// With the order of least cost: taylor_order if products of series dominate, as they do in mpfr; a somewhat larger
    /// order, and longer steps with it, in a fixed scalar, where the work done once per coefficient takes as long.
    template <class T>
    static step_accuracy of(int bits) {
        return {bits, scalar_traits<T>::fixed ? bits * 11 / 20 : taylor_order(bits)};
    }
};

/// The least of (size / |c_n|)^(1/n) / e^2 over the last coefficients: R/e^2, at which they fall below epsilon times
/// the size of the solution, within a factor of 2^(2/n); mantissa 0 if they are all 0. The same for every scalar.
step_length taylor_step(long size, const std::vector<coefficient_size>& last);
/// The same with R 2^(-bits/order) instead of R/e^2.
step_length taylor_step(long size, const std::vector<coefficient_size>& last, const step_accuracy& accuracy);

/// An integration in real time in the arithmetic of T. Errors: some epsilon of the largest component per step,
/// amplified by the flow; nothing is proved. A step ends where the next expansion begins; in between, the polynomial is
/// the solution (dense output), so that it does not depend on the requested times. Steps also end before the
/// singularities of parts that the solution does not show (hidden_parts), except from a singular initial point.
template <ordered_scalar T>
class taylor_march {
public:
    static constexpr long most_steps = 10'000'000;

    /// Throws error if there is no series at the initial point (tape::about_start). A fast product is useful at many
    /// digits.
    explicit taylor_march(const explicit_system& system, const series::block_product<T>* fast = nullptr)
        : taylor_march(system, step_accuracy{0, taylor_order(digits<T>())}, fast) {}

    /// With steps of a chosen accuracy, less than that of the scalar: shorter series and longer steps. 0 bits mean
    /// steps of R/e^2.
    taylor_march(const explicit_system& system, const step_accuracy& accuracy,
                 const series::block_product<T>* fast = nullptr)
        : hidden_(system.singular() ? std::vector<expression>() : hidden_parts(system)),
          start_(hidden_.empty() ? tape::about_start(system) : tape::about_points(system, hidden_)),
          points_(tape::about_points(system, hidden_)),
          accuracy_(accuracy),
          first_(start_, accuracy.order, fast),
          other_(points_, accuracy.order, fast),
          origin_(constant_value<T>::of(system.point())) {
        first_.about_start();
        restart();
    }

    /// The unknowns and their lower derivatives at time t, forwards or backwards. Throws error if the steps become too
    /// small before t: there is a singularity near.
    const solution_state<T>& advance_to(const T& t) {
        for (long steps = 0; step_towards(t); ++steps) {
            if (steps >= most_steps) {
                throw_not_reached(t);
            }
        }
        if (at_start_ && t == origin_) {
            state_ = start_state();
        } else {
            current().at(T(t - centre_), state_);
        }
        return state_;
    }

    /// Replaces the initial point by another one, which is not singular, and the state there.
    void begin_at(const T& time, solution_state<T> state) {
        origin_ = time;
        begin_ = std::move(state);
        restart();
    }

    /// Takes one step towards time t unless the current series reaches it. Returns false in that case. Throws like
    /// advance_to.
    bool step_towards(const T& t) {
        const int forward = t < origin_ ? -1 : 1;
        if (way_ != 0 && (forward != way_ || T((t - centre_) * way_) < 0)) {
            restart();  // before the centre, or on the other side of the initial point
        }
        if (reaches(t)) {
            return false;
        }
        way_ = forward;
        require_step(t);
        move(T(centre_ + length_ * forward));
        return true;
    }

    /// The point of the current series.
    const T& centre() const { return centre_; }
    int order() const { return accuracy_.order; }
    /// Coefficient n = 0 .. order() of an unknown or a lower derivative of it about centre(); not about a singular
    /// initial point.
    const T* coefficients(int unknown, int derivative) const { return current().coefficients(unknown, derivative); }

    /// Number of steps begun so far.
    long steps() const { return steps_; }
    /// The length of the current step; 0 if the series is a polynomial, which is valid everywhere.
    const T& length() const { return length_; }

    /// Throws the error for a time that most_steps steps do not reach.
    [[noreturn]] void throw_not_reached(const T& t) const {
        throw error(error_kind::argument, error_subject::time, to_decimal(t, 10),
                    "is not reached: the steps become too small near " + to_decimal(centre_, 10) +
                        ", where a singularity is close");
    }

private:
    const taylor_expansion<T>& current() const { return at_start_ ? first_ : other_; }

    void restart() {
        way_ = 0;
        centre_ = origin_;
        at_start_ = !begin_;
        if (begin_) {
            other_.about(origin_, *begin_);
        }
        measure(at_start_ ? start_.root() : 1);
    }

    bool reaches(const T& t) const {
        using std::abs;
        return unlimited_ || T(abs(T(t - centre_))) <= length_;
    }

    void move(const T& to) {
        current().at(T(to - centre_), next_);
        at_start_ = false;
        centre_ = to;
        other_.about(to, next_);
        measure(1);
        ++steps_;
    }

    // Computes the length of the step from the last coefficients, some of which a symmetry may have omitted.
    void measure(int root) {
        const tape& of = at_start_ ? start_ : points_;
        const int order = current().order();
        const int window = at_start_ ? std::max(2, of.stride()) : 2;
        sizes_.clear();
        for (int n = order - window + 1; n <= order; ++n) {
            sizes_.push_back({n, size_of(n)});
        }
        const long size = std::max(1L, size_of(0));
        const step_length h = accuracy_.bits == 0 ? taylor_step(size, sizes_) : taylor_step(size, sizes_, accuracy_);
        using std::ldexp;
        unlimited_ = h.mantissa == 0;
        length_ = unlimited_ ? T(0) : T(ldexp(T(h.mantissa), static_cast<int>(h.exponent)));
        for (int i = 1; i < root; ++i) {
            length_ *= T(ldexp(T(h.mantissa), static_cast<int>(h.exponent)));
        }
        for (std::size_t which = 0; which < hidden_.size(); ++which) {
            limit_by(static_cast<int>(which));
        }
    }

    // Parts that do not change the solution limit it where they are defined.
    void limit_by(int hidden) {
        using std::ldexp;
        const T* const a = current().watched(hidden);
        const int last = current().order() - *std::max_element(points_.orders().begin(), points_.orders().end());
        sizes_.clear();
        for (int n = std::max(1, last - 1); n <= last; ++n) {
            sizes_.push_back({n, binary_exponent(a[n])});
        }
        const step_length h = taylor_step(std::max(1L, binary_exponent(a[0])), sizes_);
        const T most = T(ldexp(T(h.mantissa), static_cast<int>(h.exponent)));
        if (h.mantissa != 0 && (unlimited_ || most < length_)) {
            unlimited_ = false;
            length_ = most;
        }
    }

    // The binary exponent of the largest coefficient of degree n.
    long size_of(int n) const {
        long largest = exponent_of_zero;
        const tape& of = at_start_ ? start_ : points_;
        for (int i = 0; i < static_cast<int>(of.orders().size()); ++i) {
            const int count = of.is_singular() ? 1 : of.orders()[static_cast<std::size_t>(i)];
            for (int j = 0; j < count; ++j) {
                largest = std::max(largest, binary_exponent(current().coefficients(i, j)[n]));
            }
        }
        return largest;
    }

    void require_step(const T& t) const {
        if (T(centre_ + length_ / 64) == centre_ || !(length_ > 0)) {
            throw_not_reached(t);
        }
    }

    solution_state<T> start_state() const {
        solution_state<T> result;
        for (const auto& of_unknown : start_.starts()) {
            auto& values = result.emplace_back();
            for (const number& each : of_unknown) {
                values.push_back(constant_value<T>::of(each));
            }
        }
        return result;
    }

    std::vector<expression> hidden_;  // watched by both tapes
    tape start_, points_;
    step_accuracy accuracy_;
    taylor_expansion<T> first_, other_;
    T origin_;
    std::optional<solution_state<T>> begin_;  ///< if it is not the initial point of the system
    T centre_ = T(0);
    T length_ = T(0);
    bool unlimited_ = false;
    bool at_start_ = true;
    int way_ = 0;
    long steps_ = 1;
    solution_state<T> state_;
    solution_state<T> next_;               ///< at the next point
    std::vector<coefficient_size> sizes_;  ///< of the last coefficients; these two are kept, not to be allocated again
};

/// The computed part of a solution at a list of times.
template <class R>
struct partial_states {
    /// At each time, in order, the unknowns with their lower derivatives; an unknown that does not reach the time has
    /// no values there.
    std::vector<solution_state<R>> states;
    /// The reason for missing values, if any are missing.
    std::optional<error> missing;
    /// Where collocation was used, one entry per independent subsystem and direction of time.
    std::vector<collocation_use> collocation = {};

    /// Whether every unknown has values at time i.
    bool complete_at(std::size_t i) const {
        return std::ranges::none_of(states[i], [](const auto& values) { return values.empty(); });
    }
};

/// The states at times in any order by an integration with advance_to(t), as of taylor_march, for a system: forwards
/// through those from the initial point on, then backwards, each as far as it leads.
template <ordered_scalar T, class March>
partial_states<T> states_by(March& march, const explicit_system& system, const std::vector<number>& times) {
    std::vector<T> at;
    at.reserve(times.size());
    for (const number& each : times) {
        at.push_back(constant_value<T>::of(each));
    }
    const T origin = constant_value<T>::of(system.point());
    std::vector<std::size_t> order(times.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto is_forward = [&](std::size_t i) { return at[i] >= origin; };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return is_forward(a) != is_forward(b) ? is_forward(a) : is_forward(a) ? at[a] < at[b] : at[a] > at[b];
    });
    partial_states<T> result;
    result.states.assign(times.size(), solution_state<T>(system.unknowns().size()));
    std::array<bool, 2> ended{};  // backwards and forwards
    for (const std::size_t i : order) {
        bool& ended_here = ended[is_forward(i) ? 1 : 0];
        if (ended_here) {
            continue;
        }
        try {
            result.states[i] = march.advance_to(at[i]);
        } catch (const error& problem) {
            if (!problem.is_about(error_subject::time)) {
                throw;
            }
            ended_here = true;
            if (!result.missing) {
                result.missing = problem;
            }
        }
    }
    return result;
}

/// states_by() with Taylor series.
template <ordered_scalar T>
partial_states<T> march_as_far_as_possible(const explicit_system& system, const std::vector<number>& times,
                                           const series::block_product<T>* fast = nullptr) {
    taylor_march<T> march(system, fast);
    return states_by<T>(march, system, times);
}

/// These states if every time is reached. Throws like taylor_march::advance_to.
template <ordered_scalar T>
std::vector<solution_state<T>> march_through(const explicit_system& system, const std::vector<number>& times,
                                             const series::block_product<T>* fast = nullptr) {
    auto part = march_as_far_as_possible(system, times, fast);
    if (part.missing) {
        throw error(*part.missing);
    }
    return std::move(part.states);
}

#ifdef LIBRATION_COMPILED
extern template class taylor_march<double>;
extern template class taylor_march<mpfr>;
#endif

}  // namespace libration::ode
