// The search of eigenvalues by their indices.
#pragma once

#include <functional>
#include <map>
#include <optional>

#include "libration/digits/known_value.hpp"
#include "libration/scalar/error.hpp"
#include "well_problem.hpp"

namespace libration::ode {

/// The eigenvalues of one well problem.
class eigenvalue_search {
public:
    /// `watch` is called before each computation of a solution with its bits.
    eigenvalue_search(well_problem of, std::function<void(long bits)> watch);

    /// The number of eigenvalues below E, or below a number near it; E becomes that number.
    long below(ball& e);
    /// Whether so many eigenvalues are below an E that is tried.
    bool has(long count);
    /// The eigenvalue of an index for which has(index + 1) holds.
    known_value digits_of(long index, long digits);
    /// A number below which not more than below(it) eigenvalues are, the largest one that was tried.
    ball largest() const;

private:
    struct bracket {
        ball low, high;  // exact
    };
    struct iterate {
        ball e, slope;                        // and dw/dE
        double log2_slope_error, log2_error;  // relative and absolute, roughly
        double log2_least;                    // of a size of E, for an eigenvalue 0
    };
    iterate first_iterate(const bracket& around);
    bool improve(iterate& at, const bracket& around, long bits);
    bracket isolated(long index);
    bracket narrowed(bracket around, long index, long narrow);
    std::optional<ball> value(const ball& e, long bits);

    well_problem of_;
    std::function<void(long)> watch_;
    struct exact_order {
        bool operator()(const ball& a, const ball& b) const {
            return arf_cmp(arb_midref(a.handle()), arb_midref(b.handle())) < 0;
        }
    };
    std::map<ball, long, exact_order> known_;  // the number of eigenvalues below exact numbers
    bool complete_ = false;
};

}  // namespace libration::ode
