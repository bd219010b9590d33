// The linear systems of a track of differential approximants, of all lengths at once.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "libration/approximant/differential.hpp"
#include "libration/scalar/inner_product.hpp"
#include "libration/scalar/precision_scope.hpp"

namespace libration {

/// Coefficient m of sum_k Q_k D^k f, and the largest of its terms.
struct coefficient_of_equation {
    mpfr value, largest;
};

coefficient_of_equation coefficient_of(const differential_relation& relation, std::span<const mpfr> a, int m);

/// a_m from a_0 .. a_(m-1).
mpfr next_by(const differential_relation& relation, std::span<const mpfr> a, int m);

/// Gaussian elimination that grows by one equation and one unknown at a time, in the working precision. An equation is
/// reduced by all previous ones; its pivot is its largest entry among the unknowns in use. If all of these are below
/// 2^(-4/5 bits) of its first size, the equation is pending: it waits for further unknowns. An equation 0 = 0, from zeros at
/// the beginning of the list, is left out. The unknown of (k, j) multiplies ((m-j+first/stride)/N)^k a_{m-j}, N the last index.
class differential_system {
public:
    /// Of lengths up to `last`.
    differential_system(std::span<const mpfr> a, const differential_track& track, int last);

    /// Adds the equation of the next coefficient and an unknown. Whether no equation is pending: the system is regular.
    bool add();

    int last() const { return track_.degree + static_cast<int>(columns_.size()); }
    int length() const { return track_.degree + unknowns_; }
    int unknowns() const { return unknowns_; }

    /// The right-hand sides of the equations that are pending vanish, too.
    bool is_consistent() const;

    /// The solution, 0 for the unknowns without a pivot.
    differential_relation relation() const;

private:
    struct unknown {
        int power;  ///< k of D^k
        int shift;  ///< j of x^j
        int index;  ///< its number in the order of the track
    };
    struct equation {
        std::vector<mpfr> entries;  ///< by columns_, the right-hand side last
        long size = 0;              ///< the largest binary exponent before the reduction
    };

    std::size_t width() const { return columns_.size() + 1; }
    const mpfr& term(int power, int n) const {
        return terms_[static_cast<std::size_t>(power)][static_cast<std::size_t>(n)];
    }
    void order_unknowns(int count);
    equation written(int m) const;
    void reduce(equation& row) const;
    bool place(equation& row);
    void add_pivot(equation&& row, std::size_t column);

    differential_track track_;
    std::span<const mpfr> a_;
    std::vector<std::vector<mpfr>> terms_;  ///< ((n+first/stride)/N)^k a_n
    long threshold_;
    int unknowns_ = 0;
    std::size_t pivots_ = 0;
    std::vector<unknown> columns_;  ///< those with a pivot first, in the order of the pivots
    std::vector<mpfr> reduced_;     ///< equations by pivots, `width()` entries each; the pivots are 1
    std::vector<equation> pending_;
};

}  // namespace libration
