// The right-hand sides of a system of first order and their derivatives, at states in a rounding scalar.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "libration/equation/first_order_form.hpp"
#include "libration/expansion/tape.hpp"
#include "libration/expansion/taylor_expansion.hpp"

namespace libration::ode {

/// f and, with derivatives, f_y of y' = f(t, y): the coefficients of degree 0 of the steps of a tape, so that every
/// function of the equations is available. Not for several threads at once.
template <rounding_scalar T>
class right_sides {
public:
    using place = std::pair<std::size_t, std::size_t>;

    right_sides(const first_order_form& form, const number& point, bool with_derivatives)
        : tape_(tape_of(form, point, with_derivatives, places_)),
          expansion_(tape_, 1),
          state_(form.leaves.size(), std::vector<T>(1)) {}
    right_sides(const right_sides&) = delete;
    right_sides& operator=(const right_sides&) = delete;

    std::size_t size() const { return state_.size(); }
    /// The rows and columns of the entries of f_y that are not identically 0; empty without derivatives.
    const std::vector<place>& places() const { return places_; }

    /// Computes at a time and a state of size() values. Throws error if a function is not available in T.
    void compute_at(const T& time, const T* state) {
        for (std::size_t i = 0; i < state_.size(); ++i) {
            state_[i][0] = state[i];
        }
        expansion_.about(time, state_);
    }
    const T& slope(std::size_t i) const { return expansion_.right_side(static_cast<int>(i))[0]; }
    const T& entry(std::size_t k) const { return expansion_.watched(static_cast<int>(k))[0]; }

private:
    static tape tape_of(const first_order_form& form, const number& point, bool with_derivatives,
                        std::vector<place>& places) {
        std::vector<expression> derivatives;
        for (std::size_t i = 0; with_derivatives && i < form.leaves.size(); ++i) {
            for (std::size_t j = 0; j < form.leaves.size(); ++j) {
                expression by = partial(form.slopes[i], form.leaves[j]);
                if (!by.is(0)) {
                    places.emplace_back(i, j);
                    derivatives.push_back(std::move(by));
                }
            }
        }
        return tape::about_points(form.about_points(point), derivatives);
    }

    std::vector<place> places_;
    tape tape_;
    taylor_expansion<T> expansion_;
    solution_state<T> state_;
};

}  // namespace libration::ode
