// The singularities of the solution of any system in the complex t-plane, found by continuation: heuristic.
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/integration/plane_watch.hpp"
#include "libration/scalar/complex_number.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration::ode {

enum class singularity_kind {
    pole,         ///< exponent -m, single-valued around it
    branch_pole,  ///< leading exponent -m, but multivalued: logarithms or complex powers in later terms
    algebraic,    ///< fractional exponent
    logarithm,    ///< of an unknown without a leading power
    complex_power,
    unclear  ///< no power was determined: exponent, coefficient and resonances have no value
};

/// Description for messages and tables: "pole of order 2".
std::string words_of(singularity_kind kind, double exponent);

/// A singularity of the branch reached from the initial point along its path.
struct found_singularity {
    /// Relative to the initial point, and its uncertainty: the difference of two estimates.
    complex_number<mpfr> offset;
    mpfr uncertainty;
    singularity_kind kind = singularity_kind::pole;
    /// The unknown that is singular there, the most singular one of its strongly connected component (its index counts
    /// the unknowns of the whole system with their lower derivatives), and its behaviour: coefficient (t - t*)^exponent
    /// for an integer exponent, coefficient (1 - (t - t0)/(t* - t0))^exponent for any other, coefficient log(t - t*)
    /// for a logarithm.
    std::size_t unknown = 0;
    std::complex<double> exponent;
    std::complex<double> coefficient;
    /// The exponents of every unknown and lower derivative of the component; 0 for others, and for those whose ratios
    /// of coefficients do not converge.
    std::vector<std::complex<double>> exponents;
    /// The resonances r: a perturbation of the leading behaviour grows like (t - t*)^(exponent + r), among them r = -1,
    /// which shifts the location itself. Empty if the local analysis does not apply.
    std::vector<std::complex<double>> resonances;
    /// Corners of the path from the initial point to its neighbourhood, relative to the initial point.
    std::vector<std::complex<double>> path;
    /// Whether a loop around it leaves the unknowns of the component unchanged.
    bool single_valued = true;
};

/// A value of an unknown in the plane, in double precision.
struct plane_value {
    std::complex<double> offset;  ///< from the initial point
    std::complex<double> value;
    bool known = false;  ///< whether it is in the disc of convergence of some point of the search
};

/// The request of a search.
struct singularity_request {
    /// Bound of |t - t0|; by default twice the distance of the nearest singularity.
    std::optional<double> within;
    /// Digits of the locations.
    long digits = 15;
    /// Maximum number of expansion points per component.
    long most_points = 6'000;
    /// Whether to stop at the nearest singularities: those of the least modulus.
    bool nearest_alone = false;
    /// The number of points per side of a square of half side `within` on which the first unknown is evaluated; 0 for
    /// none.
    int portrait = 0;
    /// Called for each expansion point.
    plane_watch watch = {};
};

/// The singularities found, by modulus and then by argument; mirror images are listed separately, and so are the
/// components that are singular at the same location.
struct singularity_map {
    std::vector<found_singularity> all;
    double within = 0;
    /// Whether every point within the bound was reached, except the points hidden behind branch points.
    bool complete = true;
    /// The number of unresolved points of the plane if it is not complete.
    long unexplained = 0;
    long points = 0;
    /// Whether the equation has entire solutions, by its form.
    bool entire = false;
    /// What the callback threw to end the work after the search: singularities that were not refined yet are left out.
    std::optional<error> ended = {};
    /// The requested portrait, row by row from below.
    std::vector<plane_value> portrait;
};

/// Continues the solution from point to point of the disc, from cell to cell of a polar grid, in double precision,
/// until every cell is in the disc of convergence of a point, or in a disc around a singularity that a loop of such
/// points encloses; a branch point hides the points behind it as seen from the initial point. Each location is then
/// refined in mpfr: the path is followed again, and its distance to the singularity is halved repeatedly.
///
/// Each strongly connected component of the dependency graph is searched separately, in the system of its unknowns and
/// of those that they depend on, and in units in which the series about the initial point fits into double (a power of
/// two for the time and for each unknown). A singularity is found from the coefficients of the unknowns of the
/// component only: if these are regular at a singularity of the unknowns that they depend on, they have none there.
/// Throws error if the initial point is singular in powers of a root, or if a path cannot be followed, and what the
/// callback throws during the search.
singularity_map singularities_of(const explicit_system& system, const singularity_request& request);

}  // namespace libration::ode
