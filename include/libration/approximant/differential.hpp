// Differential approximants of f = sum a_n x^n [GuttmannJoyce1972, HunterBaker1979]: linear differential equations
//     sum_{k <= M} Q_k(x) D^k f(x) = P(x) + O(x^(n+1)),   D = x d/dx,   Q_M(0) = 1,   deg P = L,
// with polynomials Q_k that are fitted to a_0 .. a_n. The singularities of f are among the roots of Q_M; the exponents
// there are the roots of an indicial equation. Coefficient m > L of the equation is
//     sum_{k,j} q_kj (m - j)^k a_{m-j} = 0,   a_n = 0 for n < 0.
// The unknowns of a track (M, L, o) are ordered by degree, and the fit of length n uses the first n - L of them: the
// systems of all lengths are leading blocks of one matrix, so that one elimination solves all of them.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "libration/scalar/complex_number.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration {

/// A sequence of fits: the order M = 0 .. 3 of the equation, the degree L of P, the offset o by which Q_M is longer than
/// usual, and the lowest k with a nonzero Q_k. M = 0 is the Pade approximant of f, M = 1 with lowest = 1 that of D f.
/// For the class f of a function x^first f(x^stride) with symmetry, D = x d/dx + first/stride, so that D f is a class of
/// that function's derivative; roots and exponents are those of f.
struct differential_track {
    int order = 1;
    int degree = 0;
    int offset = 0;
    int lowest = 0;
    int first = 0;
    int stride = 1;
};

/// A fitted equation: Q_k = sum_j q[k][j] x^j, k = 0 .. M, with q[M][0] = 1.
struct differential_relation {
    differential_track track;
    bool exact = false;  ///< satisfied by more coefficients than it has unknowns, to its working precision
    std::vector<std::vector<mpfr>> q;
};

/// A root of Q_M, read as one of multiplicity m at which e of the lower polynomials determine the exponents
/// (f ~ (1 - x/x0)^exponent): the zeros v of
///     sum_{l <= e} c_l v (v-1) .. (v-e+l+1),   c_l = x0^(M-l) Q_{M-l}^((m-l))(x0)/(m-l)!,   exponent = v + M - e.
struct differential_root {
    complex_number<mpfr> position;                ///< im >= 0
    complex_number<mpfr> exponent = {};           ///< the one with the smallest real part
    std::optional<double> second = std::nullopt;  ///< real part of the next one
    int multiplicity = 1, lower = 1;              ///< m and e; of a Pade approximant e = 0, exponent -m
    bool assumed = false;                         ///< the exponent is that of a Pade approximant, whatever f is
    bool irregular = false;                       ///< of an exact equation: an irregular singular point

    int type() const { return 10 * multiplicity + lower; }
    /// All e = m exponents are determined: a regular singular point of the equation.
    bool is_regular() const { return (multiplicity == lower || lower == 0) && !irregular; }
};

/// The fit of one track to a_0 .. a_length: the roots of Q_M in an annulus.
struct differential_fit {
    std::size_t track = 0;  ///< its index among the tracks
    int length = 0;
    bool exact = false;
    std::optional<double> next_error =
        std::nullopt;  ///< log10 of the relative error with which it predicts a_(length+1)
    std::vector<differential_root> roots = {};
};

/// The moduli between which roots are computed (none if inner >= outer); of exact equations 0.3 times the inner to 3 times the outer one.
struct root_annulus {
    double inner, outer;
};

/// Calls work(0) .. work(count - 1), each once, in any order and on any threads.
using task_runner = std::function<void(std::size_t count, const std::function<void(std::size_t)>& work)>;

/// One after the other on this thread.
inline void run_in_order(std::size_t count, const std::function<void(std::size_t)>& work) {
    for (std::size_t i = 0; i < count; ++i) {
        work(i);
    }
}

/// The fits of all tracks to a_0 .. a_n for each n in `lengths` (ascending) for which the system is regular and has at
/// least five unknowns; without an annulus, which leaves the predictions alone, also those of consistent singular systems. An equation that is fitted to all coefficients but the last three and satisfied by these, to the
/// working precision, is exact, and one fit of the whole list. Systems have at most 110 unknowns: an equation
/// that is exact so far is tested on the remaining coefficients by its recurrence. The list should be scaled to a radius
/// of about 1. Linear algebra in `bits` bits, roots in 320. A task of `run` is a track of U unknowns, O(U^3/3) products.
std::vector<differential_fit> differential_fits(std::span<const mpfr> a, std::span<const differential_track> tracks,
                                                std::span<const int> lengths, root_annulus within, long bits,
                                                const task_runner& run = run_in_order);

/// The equation of a track from a_0 .. a_length, in `bits` bits, or from all of these but three if it satisfies these
/// three and so is exact; std::nullopt if there are fewer than five unknowns or more than 110, or no solution.
std::optional<differential_relation> relation_of(std::span<const mpfr> a, const differential_track& track, int length,
                                                 long bits);

/// a_0 .. a_length and `count` further coefficients by the recurrence of the equation. O(U) each.
std::vector<mpfr> continued_by(const differential_relation& relation, std::span<const mpfr> a, int length, int count);

}  // namespace libration
