// Steps of collocation in rounded arithmetic, without proof.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "libration/equation/first_order_form.hpp"
#include "libration/scalar/scalar.hpp"
#include "newton_matrix.hpp"
#include "node_matrices.hpp"
#include "right_sides.hpp"
#include "step_control.hpp"
#include "step_tolerance.hpp"
#include "stiff_guide.hpp"

namespace libration::ode {

/// Collocation at Chebyshev-Radau nodes from step to step: u(x_i) = u(-1) + sum_k S_ik f(u(x_k)) by Newton's method, whose
/// corrections are computed in double (newton_matrix) and whose residuals in T. The length is such that
/// the last Chebyshev coefficients of each unknown are negligible relative to that unknown, and that no unknown decays
/// by more than about 10^-2.4, so that each has its own digits; it may grow without limit where the solution is smooth,
/// whatever the eigenvalues of f_y are. Nothing is proved.
template <ordered_scalar T>
class collocation_steps {
public:
    collocation_steps(const first_order_form& form, const number& point, const step_tolerance& tolerance);

    std::size_t size() const { return slopes_of_.size(); }
    /// Whether the solution is smooth over many explicit steps of this length (stiff_guide).
    bool is_smooth_over(const T& time, const std::vector<T>& state, const T& length);

    /// Begins at a state; `length` is tried first, its sign is the direction.
    void begin(const T& time, std::vector<T> state, const T& length);
    /// Prepares a step from reached(), the same until step() is called; false if no length leads to one.
    bool prepare();
    void step();

    const T& reached() const { return time_; }
    const std::vector<T>& state() const { return start_; }
    /// Of the prepared step.
    const T& length() const { return length_; }
    /// The unknowns at a distance from reached(), between 0 and length().
    std::vector<T> values_at(const T& distance) const;

private:
    enum class outcome { solved, too_long, failed };

    outcome solve();
    bool guess();
    bool factor();
    bool iterate();
    double correct();
    void interpolate();
    outcome measure_tail();
    void change_length(double factor);
    stiff_equations equations();
    T time_at(std::size_t node) const { return T(time_ + half_ * (nodes_->places[node] + 1)); }

    step_tolerance tolerance_;
    right_sides<T> slopes_of_;
    right_sides<long double> derivatives_of_;
    stiff_guide guide_;
    std::unique_ptr<node_matrices<T>> nodes_;
    newton_matrix matrix_;
    T time_ = T(0), length_ = T(0), half_ = T(0);
    bool prepared_ = false;
    double factor_ = 1;
    length_growth growth_;
    std::vector<T> start_;
    std::vector<long> scales_;     ///< binary exponents of the unknowns over the step
    std::vector<T> values_;        ///< node after node
    std::vector<T> slopes_;        ///< f times half of the length
    std::vector<T> coefficients_;  ///< of the polynomials, unknown after unknown
};

}  // namespace libration::ode
