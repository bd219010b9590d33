// One end of a connecting orbit: points on the invariant manifold of an equilibrium, as a function of free numbers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "../../manifold/invariant_manifold.hpp"
#include "far_state.hpp"
#include "libration/algebra/krawczyk.hpp"

namespace libration::ode {

/// The stable manifold of an equilibrium (as t -> inf; the unstable one as t -> -inf), by theorem W. The numbers on
/// which it depends are the free numbers of the system, then the free coordinates of the equilibrium.
class manifold_end {
public:
    /// `constants[i]` is the number that the constant unknown i of the system is; others move.
    manifold_end(const first_order_form& form, const polynomial_form& lifted, far_state rest,
                 std::vector<expression> numbers, int direction);

    /// The indices of the given unknowns that move, and of those that are constant.
    const std::vector<std::size_t>& moving() const { return given_moving_; }
    const far_state& rest() const { return rest_; }
    std::size_t variables() const { return plan_.size(); }
    const frame_plan& plan() const { return plan_; }
    std::vector<double> rest_values(const std::vector<double>& numbers) const;
    /// The equilibrium for all numbers of a box, of moving().
    std::vector<ball> rest_at(const std::vector<ball>& numbers) const;
    /// theta of a point near the equilibrium in the linear approximation.
    std::vector<double> theta_near(const std::vector<double>& numbers, const std::vector<double>& given) const;

    /// Chooses the coordinates for these numbers, such that the series converges well for |theta| <= 1; a later call keeps
    /// them fixed. At most so many directions, the fastest. False if no proof is found there with any scale; without
    /// `proved` none is tried, and the scale is that of the first terms.
    bool choose(const std::vector<double>& numbers, std::size_t most, bool proved = true);
    /// The size of theta for which the number of terms is balanced.
    double good_radius() const;
    int least_degree() const;

    /// For all numbers of a box: the eigenvalue of each column, one that contains all of them in blocks of several, and the columns.
    struct decay {
        std::vector<complex_ball> rates;
        std::vector<std::vector<complex_ball>> columns;  ///< by rows: of moving()
        std::vector<bool> alone;  ///< whether the column is a real eigenvector in a block of its own
    };
    std::optional<decay> decay_at(const std::vector<ball>& numbers) const;

    struct enclosed {
        std::vector<ball> value;  ///< of moving()
        ball_matrix by_numbers;   ///< rows: of moving()
        ball_matrix by_theta;
    };
    /// The point P(theta) for all numbers of the box; a pair of conjugate coordinates is the real and imaginary part of
    /// the first. The terms up to `degree`; without `proved` the tail is left out. std::nullopt if theorem W is not shown.
    std::optional<enclosed> at(const std::vector<ball>& numbers, const std::vector<ball>& theta, int degree,
                               bool proved) const;
    /// By theorem W2, the solution through P(theta) at each of these times >= 0 after it, towards the equilibrium: P(theta(t)), theta_j(t)
    /// = theta_j exp(d_j t), of moving(). std::nullopt if theorem W is not shown, or if theta moves in another way.
    std::optional<std::vector<std::vector<ball>>> along(const std::vector<ball>& numbers,
                                                        const std::vector<ball>& theta, const std::vector<ball>& times,
                                                        int degree) const;

private:
    std::vector<complex_ball> coordinates(const std::vector<ball>& theta) const;
    std::vector<complex_jet> centre(const std::vector<complex_ball>& numbers, bool slopes) const;
    field_at_rest field(const std::vector<complex_ball>& numbers, bool slopes) const;
    std::optional<invariant_manifold> series(const std::vector<complex_ball>& numbers, bool slopes, int degree) const;

    far_state rest_;
    std::vector<expression> numbers_;
    int direction_;
    tape tape_;
    std::vector<expression> centres_;                 // of all unknowns of the polynomial form
    std::vector<std::vector<expression>> by_number_;  // their derivatives
    bool depends_ = false;                            // on the numbers
    std::vector<std::size_t> moving_, given_moving_;
    frame_plan plan_;
};

}  // namespace libration::ode
