// The equation of a connecting orbit as a map of its unknowns, in balls.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "libration/equation/parametric_system.hpp"
#include "libration/equation/text/limit_condition.hpp"
#include "libration/integration/proof_route.hpp"
#include "libration/query/states.hpp"
#include "manifold_end.hpp"

namespace libration::ode {

/// Values of the first unknowns at a time, and their derivatives by the free numbers.
struct differentiable_start {
    std::vector<ball> values;
    ball_matrix by_numbers;
};
/// These for all numbers of a box; std::nullopt if more bits are needed.
using start_rule =
    std::function<std::optional<differentiable_start>(const std::vector<ball>& numbers, long bits, long error_bits)>;

/// F = Phi_T(start) - P(theta): the unknowns are the free numbers, the free coordinates of the equilibria at the start
/// and at the end, the angle of the start on an unstable manifold of dimension 2, and theta at the end.
class connection_map {
public:
    connection_map(const equation_system& system, const std::vector<std::string>& unknowns,
                   const std::vector<limit_condition>& limits, proof_route route, march_watch watch);

    const parametric_system& open() const { return open_; }
    const first_order_form& form() const { return form_; }
    bool has_two_ends() const { return left_.has_value(); }
    int direction() const { return direction_; }
    manifold_end& right() { return *right_; }
    const manifold_end& right() const { return *right_; }
    const manifold_end& left() const { return *left_; }  ///< of two ends
    /// Free numbers and coordinates, and all unknowns.
    std::size_t numbers() const { return open_.leaves.size(); }
    std::size_t coordinates() const;
    std::size_t size() const;
    std::size_t dimension() const { return right_->moving().size(); }
    std::size_t left_variables() const { return left_ ? left_->variables() : 0; }
    std::vector<std::string> names(const std::vector<std::string>& unknowns) const;

    /// Chooses coordinates at both ends for first guesses of numbers and coordinates, and the side of the start on a
    /// curve. False if no manifold is proved there; without `proved` no proof is tried.
    bool choose(const std::vector<double>& at, int side, bool proved = true);
    /// Whether the equations or the limits depend on a free number.
    bool depends_on_numbers() const;
    /// Whether the end is reached along the fastest of the directions alone.
    bool is_fast() const { return fast_; }
    /// The numbers on which an end depends: of all unknowns.
    std::vector<double> right_numbers(const std::vector<double>& x) const;

    std::vector<ball> numbers_of_right(const std::vector<ball>& x) const;
    std::vector<ball> numbers_of_left(const std::vector<ball>& x) const;
    std::size_t left_coordinates() const { return left_ ? left_->rest().coordinates.size() : 0; }
    std::size_t right_coordinates() const { return right_->rest().coordinates.size(); }
    bool has_angle() const { return left_ && left_->variables() == 2; }
    /// The coordinates of the start on the unstable manifold, of two ends.
    std::vector<ball> theta_at_start(const std::vector<ball>& x) const;
    /// The start, with its derivatives by all unknowns. std::nullopt where theorem W is not shown.
    struct start {
        std::vector<ball> values;
        ball_matrix by_unknowns;
    };
    std::optional<start> start_at(const std::vector<ball>& x, long bits, long error_bits) const;
    /// The degree of the series for so many bits.
    int degree_for(long bits) const;
    const proof_route& route() const { return route_; }
    /// The state at the start for first guesses, in double.
    std::vector<double> start_near(const std::vector<double>& x) const;

    start_rule begins = {};  ///< instead of the initial values of the first unknowns
    bool may_rest = false;   ///< whether the equilibrium itself is a solution that is meant
    double time = 0;         ///< T >= 0
    int degree = 0;          ///< of the series; 0: by the bits, for proofs
    double radius = 0.25;    ///< a bound of theta, for the degree

    std::optional<enclosed_map> operator()(const std::vector<ball>& x, long bits, long error_bits) const;

private:
    std::optional<start> start_on_manifold(const std::vector<ball>& x, long bits) const;

    parametric_system open_;
    first_order_form form_;
    std::optional<manifold_end> left_, right_;
    int direction_ = 1;
    double side_ = 1;
    bool fast_ = false;  // along the fastest directions
    std::vector<std::vector<expression>> by_start_;
    proof_route route_;
    march_watch watch_;
};

}  // namespace libration::ode
