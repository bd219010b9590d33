// The singularities relative to any point of a motion, and a bound of the terms that a sum omits from a coefficient.
//
// Theorem A, from a point s0. omega has simple poles with the residues -2i sigma at s0 + z in the upper half plane and
// the conjugate ones below, sigma = +-1: in time since the bottom, 2k cn has sigma = (-1)^(m+j) at 2m T* + i(2j+1)
// K~', 2 dn of rotation and 2/cosh of the separatrix have (-1)^j times the direction [DLMF 22.4, 4.28]. The integral of
// omega(s) (s-s0)^-n over growing boxes of the lattice that avoid the poles tends to 0, because omega is bounded on
// them (on the separatrix it decreases exponentially to both sides), so for n >= 3
//     a_n = -(1/n) sum of residue (pole - s0)^-n = -(4/n) sum_{z, Im z > 0} sigma Im z^-n.
// Theorem A1. The poles at a distance of at least d add at most (2/n) d^(4-n) S4, n >= 4, where S4 = sum |z|^-4 over
// both half planes: 2|z|^-n <= 2 d^(4-n) |z|^-4.
// Here S4 <= pi^2/(4 R^2 K~'^2) + pi^4/(64 T*^2 K~'^2), on the separatrix its first term alone. For the column nearest
// to s0 |z|^-4 <= R^-2 y^-2, and 2 sum y^-2 over y = (2j+1) K~' is pi^2/(4 K~'^2). The other columns are at |x| >=
// (2k-1) T*, k = 1, 2, .., on both sides, since the nearest is at most T* away; there |z|^4 >= 4 x^2 y^2, and the sum
// of 4/(4 x^2 y^2) is (pi^2/8)^2/(T*^2 K~'^2).
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "libration/pendulum/coefficients.hpp"
#include "libration/pendulum/singularities.hpp"

namespace libration::pendulum {

/// A pole of omega in the upper half plane, relative to the expansion point, and sigma, doubled if the symmetry of the
/// point makes the contribution of its mirror image the same.
template <scalar T>
struct seen_pole {
    T along;
    T height;
    T square;  ///< of its distance
    int weight;
};

/// The powers first, first + stride, .. are those that are nonzero by symmetry in theta - theta_0.
struct power_pattern {
    int first = 0;
    int stride = 1;

    bool has(long n) const { return n % stride == first; }
    /// The first of them from n on.
    long next(long n) const { return n + ((first - n) % stride + stride) % stride; }
};

/// By parity; at E = 1 T* = K~', and z -> i conj(z) maps the poles about the top onto themselves with the same sigma
/// and Im z^-n to -Im i^n z^-n for even n: only n = 2 mod 4 is left.
template <scalar T>
power_pattern powers_about(const motion& m, const phase<T>& at) {
    switch (parity_about(m, at)) {
        case series::parity::any: return {0, 1};
        case series::parity::odd: return {1, 2};
        case series::parity::even: break;
    }
    return m.energy() && *m.energy() == 1 ? power_pattern{2, 4} : power_pattern{0, 2};
}

/// The lattice of a motion from one of its points, in dimensionless time.
template <scalar T>
class singularity_view {
public:
    singularity_view(const motion& m, singularity_lattice<T> lattice, phase<T> at)
        : lattice_(std::move(lattice)),
          at_(std::move(at)),
          powers_(powers_about(m, at_)),
          radius_(lattice_.radius(at_)) {
        const int quarter = lattice_.single_column ? 0 : elliptic::quarter_of_four(at_.quarter);
        from_bottom_ = quarter % 2 == 0;
        alternates_ = m.regime() == regime::libration;
        sign_ = alternates_ ? (quarter < 2 ? 1 : -1) : m.direction();
    }

    const power_pattern& powers() const { return powers_; }
    const T& radius() const { return radius_; }
    const singularity_lattice<T>& lattice() const { return lattice_; }
    bool symmetric() const { return at_.side == 0; }

    /// The bound of S4.
    T fourth_powers() const {
        const T square = pi<T>() * pi<T>();
        const T height = lattice_.height * lattice_.height;
        T nearest = square / (radius_ * radius_ * height * 4);
        if (lattice_.single_column) {
            return nearest;
        }
        return nearest + square * square / (lattice_.effective_period * lattice_.effective_period * height * 64);
    }

    /// All poles that are not certainly farther than `reach`, the nearest first; of mirror images one, with both
    /// weights.
    std::vector<seen_pole<T>> within(const T& reach) const {
        const T limit = reach * reach;
        std::vector<seen_pole<T>> all;
        int column = symmetric() && from_bottom_ ? 0 : 1;
        while (add_column(column, limit, all)) {
            ++column;
        }
        column = 0;
        while (!symmetric() && add_column(column, limit, all)) {
            --column;
        }
        std::sort(all.begin(), all.end(), [](const seen_pole<T>& a, const seen_pole<T>& b) {
            return certainly_less(midpoint(a.square), midpoint(b.square));
        });
        return all;
    }

private:
    // Adds a column, numbered from left to right, 0 next to the point or left of it; false if it is beyond the
    // limit, as are all that follow.
    bool add_column(int column, const T& limit, std::vector<seen_pole<T>>& all) const {
        if (lattice_.single_column && column != 0) {
            return false;
        }
        const T along = lattice_.effective_period * (2 * column - (from_bottom_ ? 0 : 1)) - at_.offset;
        const T square = along * along;
        if (certainly_less(limit, square)) {
            return false;
        }
        const int mirrored = symmetric() && column != 0 ? 2 : 1;
        int sign = alternates_ && column % 2 != 0 ? -sign_ : sign_;
        for (int row = 0;; ++row, sign = -sign) {
            const T height = lattice_.height * (2 * row + 1);
            T distance = square + height * height;
            if (certainly_less(limit, distance)) {
                return true;
            }
            all.push_back({along, height, std::move(distance), sign * mirrored});
        }
    }

    singularity_lattice<T> lattice_;
    phase<T> at_;
    power_pattern powers_;
    T radius_;
    bool from_bottom_;
    bool alternates_;
    int sign_;
};

/// The view from a phase; std::nullopt for the equilibria, whose theta is constant.
template <scalar T>
std::optional<singularity_view<T>> view_from(const motion& m, const phase<T>& at) {
    auto lattice = singularities<T>(m);
    if (!lattice) {
        return std::nullopt;
    }
    return singularity_view<T>(m, std::move(*lattice), at);
}

}  // namespace libration::pendulum
