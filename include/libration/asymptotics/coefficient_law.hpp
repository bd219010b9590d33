// The law of all Taylor coefficients of a solution, proved: theorems L2, A, B, F and D.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "libration/asymptotics/fixed_point_terms.hpp"
#include "libration/asymptotics/movable_terms.hpp"
#include "libration/asymptotics/singular_terms.hpp"
#include "libration/integration/plane_watch.hpp"
#include "libration/plane/charted_covering.hpp"

namespace libration::ode {

class linear_law;

/// The request of a law.
struct law_request {
    /// The unknown, by its index, and the order of its derivative.
    std::size_t unknown = 0;
    int derivative = 0;
    /// rho; by default between the moduli of the singularities that a search finds up to twice the nearest.
    std::optional<double> within = {};
    /// The last index J of the expansions at branch points.
    int terms = 60;
    plane_watch watch = {};
};

/// For the coefficients a_n of (t - t0)^n of one unknown or derivative y, F its continuation,
///     a_n = sum over the singularities in |t - t0| <= rho of their terms + E_n,   |E_n| <= C rho^-n + bounds of the branch points,
/// where F has no other singularity in |t - t0| <= rho (theorem L2). C bounds the mean of |y| on the circle. Either all
/// singularities are poles of an equation with regular_coordinates (theorem A, for all n >= 0), or all are branch points with a
/// uniformizing_chart (theorem B), or all are regular singular points of a linear equation (theorem F), or all are movable
/// singularities of a polynomial system with a dominant balance, of one or several kinds (theorem D).
/// y may be a derivative of the function of the equation that is covered, or its primitive: see shift().
class coefficient_law {
public:
    /// Throws error of the kind undecided if no law is proved: for a singularity without a chart, with its place; if a covering
    /// does not close; if no singularity is found and no rho is given.
    static coefficient_law of(const explicit_system& system, const law_request& asked);

    double rho() const { return rho_; }
    const magnitude& mean() const { return mean_; }
    std::size_t discs() const { return discs_; }
    std::size_t charts() const { return charts_; }
    /// The poles with Im >= 0.
    const std::vector<pole_terms>& poles() const { return poles_; }
    /// The branch points with Im >= 0.
    const std::vector<branch_terms>& branch_points() const { return branch_points_; }
    /// The singular points of a linear equation with Im >= 0 where one of its solutions is not analytic.
    const std::vector<fixed_point_terms>& fixed_points() const { return fixed_points_; }
    /// The movable singularities of a system with Im >= 0.
    const std::vector<movable_terms>& movable_points() const { return movable_points_; }
    bool has_singularities() const {
        return !poles_.empty() || !branch_points_.empty() || !fixed_points_.empty() || !movable_points_.empty();
    }
    /// y is the derivative of this order of the function f of the covered equation; -1: a primitive of it. With b_n the coefficients of f,
    /// a_n = (n + shift)!/n! b_(n+shift).
    int shift() const { return shift_; }
    /// The equation of f.
    const explicit_system& system() const { return system_; }
    /// Whether all coefficients with indices other than residue + k stride are 0, by the exact zeros of the initial values.
    int stride() const { return stride_; }
    int residue() const { return (residue_ % stride_ + stride_) % stride_; }
    bool vanishes(long n) const { return stride_ > 1 && (n - residue()) % stride_ != 0; }

    /// The constants to the working precision. Throws precision_exhausted.
    void sharpen();
    /// a_n for n >= first(); the working precision of the constants is that of sharpen().
    ball value(long n) const;
    /// a_n/a_(n-1), n > first(), the ratios of Domb and Sykes; not finite where a_(n-1) may be 0.
    ball ratio(long n) const { return value(n) / value(n - 1); }
    /// A bound of |E_n|, the least of all J.
    ball error_bound(long n) const;
    /// The least n for which the law is proved: of branch points with J = terms.
    long first(int terms = 0) const;
    int last_term() const { return last_term_; }

private:
    explicit coefficient_law(explicit_system system) : system_(std::move(system)) {}
    void cover(const law_request& asked);
    void cover_linear(const linear_equation& equation, const law_request& asked);
    long first_of_function(int terms) const;
    void sharpen_movable();
    void set_exact_parts(const pole_box& box, pole_terms& of) const;
    int best_terms(long n) const;
    ball bound_of_function(long n, int terms) const;
    ball circle_bound(long n) const;

    explicit_system system_;
    std::shared_ptr<const chart_atlas> atlas_;
    std::optional<uniformizing_chart> uniformizing_;
    std::vector<pole_box> boxes_;
    std::vector<complex_ball> near_;  ///< enclosures of the branch points
    double rho_ = 0;
    magnitude mean_;
    std::size_t discs_ = 0, charts_ = 1;
    int shift_ = 0, stride_ = 1, residue_ = 0, last_term_ = 0;
    std::vector<pole_terms> poles_;
    std::vector<branch_terms> branch_points_;
    std::shared_ptr<const linear_law> linear_;
    std::vector<fixed_point_terms> fixed_points_;
    std::vector<movable_terms> movable_points_;
    long bits_of_movable_ = 0;  ///< of their constants
    std::size_t shown_ = 0;     ///< of the unknowns and lower derivatives of the covered equation
};

}  // namespace libration::ode
