// The law of a linear equation with polynomial coefficients: its singular points, its circle, and the local expansions.
#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <vector>

#include "libration/asymptotics/fixed_point_terms.hpp"
#include "libration/equation/explicit_system.hpp"
#include "libration/integration/plane_watch.hpp"

namespace libration::ode {

/// Theorem F [docs/asymptotics.md]. A solution has no other singularities than the zeros of p_r (Fuchs), so that it is analytic in |t - t0| <=
/// rho without the slits from these on, and paths in there lead to their local expansions and to the circle. At a singular t0 it is the
/// power series that theorem S determines, of the exponents 0, 1, ..: the series of Frobenius with its first coefficients.
class linear_law {
public:
    /// rho as given or between the moduli of the singular points, up to three times the least. Throws error of the kind undecided if an
    /// irregular singular point is inside, if a slit inside is longer than the distance to the next singular point allows, if two
    /// are on one ray, or if there is no singular point besides t0 and no rho. The system is that of the equation.
    linear_law(linear_equation of, explicit_system system, const std::optional<double>& within, plane_watch watch);

    double rho() const { return rho_; }
    /// Of the solutions, in |t - t0| = rho.
    const magnitude& mean() const { return mean_; }
    std::size_t discs() const { return discs_; }
    /// The singular points inside with Im >= 0 where a solution may have a singularity, with at least so many coefficients, to the working
    /// precision. Throws precision_exhausted.
    std::vector<fixed_point_terms> terms(int least) const;
    /// Computes mean().
    void bound_circle();

private:
    struct place {
        std::size_t factor = 0;
        complex_ball near;  ///< disjoint from all others
        double modulus = 0, angle = 0;
    };
    using state = std::vector<complex_ball>;  ///< y^(d)/d!, d < r
    struct gap;

    void find_places();
    double farthest_circle(std::size_t inside) const;
    void choose_circle(const std::optional<double>& within);
    void check_inside();
    std::vector<complex_ball> roots() const;
    std::vector<complex_ball> zeros() const { return others_than(places_.size(), roots()); }
    complex_ball root_at(std::size_t k) const;
    std::vector<complex_ball> others_than(std::size_t k, const std::vector<complex_ball>& all) const;
    static double distance_from(const complex_ball& z, const std::vector<complex_ball>& all);
    state moved(const state& from, const complex_ball& a, const complex_ball& b,
                const std::vector<complex_ball>& all) const;
    state walked(const state& from, const complex_ball& a, const complex_ball& b,
                 const std::vector<complex_ball>& all) const;
    frobenius_series series_about_start(series_demand demand, const std::vector<complex_ball>& zeros) const;
    state walked_from_start(const complex_ball& b, const std::vector<complex_ball>& zeros) const;
    fixed_point_terms terms_at(std::size_t k, int least) const;
    std::vector<gap> gaps() const;
    double width_of_tip(const fixed_point_terms& of, double widest) const;
    void add_tip(const fixed_point_terms& of, double width);
    void add_gap(const gap& over, const std::vector<fixed_point_terms>& tips);
    double add_piece(const state& at, const complex_ball& centre, double low, double high,
                     const std::vector<complex_ball>& all);

    linear_equation equation_;
    explicit_system system_;
    plane_watch watch_;
    std::optional<fuchsian_point> origin_;  ///< at t0 if it is a root of p_r
    int multiplicity_of_origin_ = 0;
    std::vector<fuchsian_point> structures_;
    std::vector<int> multiplicities_;
    std::vector<place> places_;        ///< all roots of p_r but t0
    std::vector<std::size_t> inside_;  ///< those in |t - t0| < rho with Im >= 0
    double rho_ = 0;
    magnitude mean_;
    mutable std::size_t discs_ = 0;
};

}  // namespace libration::ode
