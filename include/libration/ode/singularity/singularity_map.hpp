// The singularities of the solution of any system in the complex plane of time, found by continuing it: heuristic.
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "libration/ode/explicit_system.hpp"
#include "libration/scalar/complex_number.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration::ode {

enum class singularity_kind {
    pole,         ///< exponent -m, and one value round it
    branch_pole,  ///< leading exponent -m, but another value after a turn: logarithms or complex powers further on
    algebraic,    ///< a fraction as exponent
    logarithm,    ///< of an unknown that has no power before it
    complex_power,
    unclear  ///< no power is seen: exponent, coefficient and resonances have no value
};

/// Words for people and tables: "pole of order 2".
std::string words_of(singularity_kind kind, double exponent);

/// A singularity of the branch that is reached from the start along its path.
struct found_singularity {
    /// Relative to the start, and how far off it may be: the difference of two estimates.
    complex_number<mpfr> offset;
    mpfr uncertainty;
    singularity_kind kind = singularity_kind::pole;
    /// The unknown that is singular there, of its strongly connected component the most singular one (its index counts
    /// the unknowns of the whole system with their lower derivatives), and its behaviour:
    /// coefficient (t - t*)^exponent for a whole exponent, coefficient (1 - (t - t0)/(t* - t0))^exponent for another,
    /// coefficient log(t - t*) for a logarithm.
    std::size_t unknown = 0;
    std::complex<double> exponent;
    std::complex<double> coefficient;
    /// The exponents of every unknown and lower derivative of the component; 0 for others, and for those whose ratios of
    /// coefficients do not settle.
    std::vector<std::complex<double>> exponents;
    /// The resonances r: a perturbation of the leading behaviour grows like (t - t*)^(exponent + r), r = -1 among them
    /// for the place itself. Empty where the local analysis does not apply.
    std::vector<std::complex<double>> resonances;
    /// Corners of the path from the start to its neighbourhood, relative to the start.
    std::vector<std::complex<double>> path;
    /// Whether a turn round it leaves the unknowns of the component as they were.
    bool single_valued = true;
};

/// A value of an unknown in the plane, in double precision.
struct plane_value {
    std::complex<double> offset;  ///< from the start
    std::complex<double> value;
    bool known = false;  ///< in the disc of convergence of some point of the search
};

/// What a search is to find.
struct singularity_request {
    /// Those with |t - t0| below; twice the nearest where it is not given.
    std::optional<double> within;
    /// Digits of the places.
    long digits = 15;
    /// At most so many points of expansion for each component.
    long most_points = 6'000;
    /// Whether to stop at the nearest ones: those of the least modulus.
    bool nearest_alone = false;
    /// The values of the first unknown on a square of so many points across, of half side `within`.
    int portrait = 0;
};

/// What it found, by modulus and then by argument; of mirror images each, and of one place each component that is
/// singular there.
struct singularity_map {
    std::vector<found_singularity> all;
    double within = 0;
    /// Whether every point within was reached, but for what hides behind branch points.
    bool complete = true;
    /// How many points of the plane stayed unexplained, where it is not complete.
    long unexplained = 0;
    long points = 0;
    /// Whether the equation has entire solutions, by its form.
    bool entire = false;
    /// The portrait that was asked for, row by row from below.
    std::vector<plane_value> portrait;
};

/// Continues the solution from point to point of the disc, from cell to cell of a fan of angles and moduli, in double
/// precision, until every cell lies in the disc of convergence of a point, or in a disc round a singularity that a loop
/// of such points goes round; a branch point hides what is behind it as seen from the start. Each place is then refined
/// in mpfr: the path is walked again, and halved towards it.
///
/// Each strongly connected component of the dependency graph has a search of its own, in the system of its unknowns and
/// of those that they depend on, and in units in which the series about the start fits into double (a power of two for
/// the time and for each unknown). A singularity is found from the coefficients of the unknowns of the component alone:
/// where these are regular at a singularity of what they depend on, they have none there. Throws error where the start
/// is singular in powers of a root, or where a path is not followed.
singularity_map singularities_of(const explicit_system& system, const singularity_request& request);

}  // namespace libration::ode
