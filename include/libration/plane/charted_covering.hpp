// Coverings of a disc in the complex plane with charts, slits and tips: theorem L2.
#pragma once

#include <complex>
#include <cstddef>
#include <string>
#include <vector>

#include "libration/integration/plane_watch.hpp"
#include "libration/plane/chart_atlas.hpp"

namespace libration::ode {

/// r1 <= |z| <= r2, a1 <= arg z <= a2, in doubles, which bound it exactly up to the margin of the covering.
struct plane_cell {
    double r1 = 0, r2 = 0, a1 = 0, a2 = 0;

    std::vector<std::complex<double>> corners() const;
    /// A ball that contains it.
    complex_ball enclosure() const;
    /// Its halves across the longer side.
    std::vector<plane_cell> halves() const;
};

/// D(place, radius) without the slit of a branch point, with a function that agrees with the solution at a base on the ray from
/// 0 to the place, of modulus `base`.
struct covering_tip {
    std::complex<double> place;
    double radius = 0;
    double base = 0;
};

/// A closed sector of an opening of at most 2 radians between slits, and the tips that may be used in it: those of the slits
/// of its gap which are less than a half turn from all of its points.
struct plane_sector {
    double from = 0, to = 0;
    std::vector<std::size_t> tips;
};

/// The sectors 0 <= arg z <= pi of the plane cut along the slits of these tips, which are not below the real axis: the lower
/// half plane is the mirror image. Throws error of the kind undecided for two slits on one ray.
std::vector<plane_sector> upper_sectors(const std::vector<covering_tip>& tips);

/// A disc of theorem T in a chart, and the largest modulus on its chain from 0.
struct covering_piece {
    series_disc disc;
    std::size_t chart = 0;
    std::complex<double> centre;
    double radius = 0;
    double base = 0;
};

/// A cell in a piece or, with in_tip, in a tip.
struct covered_cell {
    plane_cell cell;
    std::size_t holder = 0;
    bool in_tip = false;
};

/// What a covering needs.
struct covering_request {
    double rho = 0;
    std::vector<covering_tip> tips = {};
    long bits = 128;
    int order = 56;
    std::size_t most_pieces = 3'000;
    plane_watch watch = {};
};

/// Theorem L2 [docs/asymptotics.md]: if every z with 0 < |z| <= rho of every sector lies in the disc about 0, in a piece of a
/// chain in that sector with base <= |z|, or in a tip that the sector may use, with base <= |z|, the solution of a real
/// system continues to one meromorphic function in |t| <= rho without the slits, which is that of the piece or tip there. Its
/// poles are among the zeros of v in the pieces of chart 1. All comparisons of doubles keep a margin of 1e-9 of the radius
/// of the disc, which is at least 1e-5 rho. Throws error of the kind undecided with the place where it does not close.
class charted_covering {
public:
    charted_covering(const explicit_system& system, const chart_atlas& atlas, const covering_request& asked);

    const chart_atlas& atlas() const { return atlas_; }
    const std::vector<covering_piece>& pieces() const { return pieces_; }
    const std::vector<covered_cell>& cells() const { return cells_; }

private:
    void cover(const plane_sector& sector);
    bool is_held(const plane_cell& cell, const plane_sector& sector, const std::vector<std::size_t>& own);
    std::size_t nearest(std::complex<double> c, const std::vector<std::size_t>& own) const;
    std::size_t reach(std::size_t from, std::complex<double> c, std::vector<std::size_t>& own);
    void add_piece(std::size_t chart, std::complex<double> centre, const std::vector<complex_ball>& state, double base);
    [[noreturn]] void refuse_at(std::complex<double> place, const std::string& why) const;

    const chart_atlas& atlas_;
    covering_request asked_;
    std::vector<covering_piece> pieces_;
    std::vector<covered_cell> cells_;
};

}  // namespace libration::ode
