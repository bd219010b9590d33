// The classical fourth-order Runge-Kutta method with a fixed step for any equation, as a baseline for other methods.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/expansion/taylor_expansion.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/scalar.hpp"

namespace libration::ode {

/// k1 = F(t, y), k2 = F(t + h/2, y + h k1/2), k3 = F(t + h/2, y + h k2/2), k4 = F(t + h, y + h k3), and then
/// y + h (k1 + 2 k2 + 2 k3 + k4)/6, for the unknowns and their derivatives below the order as one first-order system.
/// The error at a fixed time is O(h^4), without a bound. All in T; four evaluations of the equations a step.
template <rounding_scalar T>
class fixed_runge_kutta {
public:
    static constexpr long most_steps = 200'000'000;

    /// At the initial point. Throws error if that is singular.
    fixed_runge_kutta(const explicit_system& system, T step)
        : tape_(tape::about_points(regular(system))),
          slopes_(tape_, highest(tape_.orders())),
          step_(std::move(step)),
          time_(constant_value<T>::of(system.point())) {
        for (const auto& derivatives : system.starts()) {
            auto& own = state_.emplace_back();
            for (const number& each : derivatives) {
                own.push_back(constant_value<T>::of(each));
            }
        }
    }
    fixed_runge_kutta(const fixed_runge_kutta&) = delete;
    fixed_runge_kutta& operator=(const fixed_runge_kutta&) = delete;
    ~fixed_runge_kutta() = default;

    /// The state at time t, from that of the last call, in steps of h, the last one shortened or lengthened to arrive.
    /// Throws error when that needs more than most_steps steps.
    const solution_state<T>& advance_to(const T& t) {
        const integer steps = nearest_integer(widen(T((t - time_) / step_)));
        if (abs(steps) > most_steps) {
            throw error(
                error_kind::argument, error_subject::time, "",
                "needs " + integer(abs(steps)).str() + " Runge-Kutta steps, more than " + std::to_string(most_steps));
        }
        const long count = steps.convert_to<long>();
        const T h = count < 0 ? T(-step_) : step_;
        const T start = time_;
        for (long i = 0; i < std::labs(count); ++i) {
            make_step(h);
            time_ = start + h * T(i + 1);
        }
        make_step(T(t - time_));
        time_ = t;
        return state_;
    }

private:
    static const explicit_system& regular(const explicit_system& system) {
        if (system.singular()) {
            throw error(error_kind::argument, error_subject::start, "", "is singular: a step has no slope there");
        }
        return system;
    }
    static int highest(const std::vector<int>& orders) {
        int most = 1;
        for (const int each : orders) {
            most = each > most ? each : most;
        }
        return most;
    }

    // dy/dt at a time and a state: the next derivative, and that of the equations.
    solution_state<T> slope(const T& time, const solution_state<T>& at) {
        slopes_.about(time, at);
        solution_state<T> result = at;
        for (std::size_t i = 0; i < at.size(); ++i) {
            for (std::size_t k = 0; k + 1 < at[i].size(); ++k) {
                result[i][k] = at[i][k + 1];
            }
            result[i].back() = slopes_.right_side(static_cast<int>(i))[0];
        }
        return result;
    }

    static solution_state<T> moved(const solution_state<T>& from, const solution_state<T>& along, const T& by) {
        solution_state<T> result = from;
        for (std::size_t i = 0; i < from.size(); ++i) {
            for (std::size_t k = 0; k < from[i].size(); ++k) {
                result[i][k] += by * along[i][k];
            }
        }
        return result;
    }

    void make_step(const T& h) {
        const T half = h / 2;
        const auto k1 = slope(time_, state_);
        const auto k2 = slope(T(time_ + half), moved(state_, k1, half));
        const auto k3 = slope(T(time_ + half), moved(state_, k2, half));
        const auto k4 = slope(T(time_ + h), moved(state_, k3, h));
        for (std::size_t i = 0; i < state_.size(); ++i) {
            for (std::size_t k = 0; k < state_[i].size(); ++k) {
                state_[i][k] += h * (k1[i][k] + (k2[i][k] + k3[i][k]) * 2 + k4[i][k]) / 6;
            }
        }
    }

    tape tape_;
    taylor_expansion<T> slopes_;
    T step_;
    T time_;
    solution_state<T> state_;
};

}  // namespace libration::ode
