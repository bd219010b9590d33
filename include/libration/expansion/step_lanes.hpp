// Independent steps of a tape with the same operation, side by side in the lanes of SIMD vectors, in double.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "libration/expansion/tape.hpp"

namespace libration::ode {

/// Several steps of one kind, side by side; its members are indices into a row.
struct lane_group {
    operation kind;
    std::size_t lanes;
    std::size_t left;
    std::size_t right;
    std::size_t result;
    /// The beginning of the indices from which the operands are gathered first; none if they are already contiguous.
    std::ptrdiff_t gathered_left;
    std::ptrdiff_t gathered_right;
    /// The beginning of the factors: those of multiples; for square roots, twice the root.
    std::size_t factors;
};

/// Row n contains coefficient n of everything that groups read and write.
struct lane_rows {
    std::size_t length = 0;
    std::vector<double> numbers;
    std::vector<std::int64_t> indices;
    std::vector<double> factors;

    double* row(int n) { return numbers.data() + static_cast<std::size_t>(n) * length; }
};

/// The steps of a tape in an order in which operands come first, those of one kind and the same depth together:
/// products, squares, quotients, square roots, sums, differences and multiples, at most sixteen together. No groups if
/// these would have fewer than three steps on average. One loop over the degrees computes a group. Each lane sums in
/// the same order as a single step, and fuses no product with a sum: coefficients are identical to the last bit to
/// those of single steps wherever the compiler does not fuse either, as by default on x86-64.
class step_lanes {
public:
    /// Consecutive single steps, or consecutive groups.
    struct entry {
        bool alone;
        std::size_t first;  ///< the first of alone(), or the first group
        std::size_t count;
        /// The transfers from the arrays of steps into rows after single steps, and back after groups.
        std::size_t first_transfer;
        std::size_t transfers;
    };

    step_lanes() = default;
    /// For a tape about any point, whose step i has its coefficients at arrays + i length, which must not move.
    /// factors[i] is the constant of step i, or the factor numerator/denominator if it has none.
    step_lanes(const tape& of, double* arrays, std::size_t length, const std::vector<double>& factors);

    /// Whether there is no group.
    bool empty() const { return groups_.empty(); }
    const std::vector<entry>& order() const { return order_; }
    /// The single steps, in their order.
    const std::vector<int>& alone() const { return alone_; }
    /// To be called after the coefficients 0 of all steps.
    void begin();
    /// To be called after coefficient n > 0 of the unknowns.
    void take_states(int n);
    /// To be called after coefficient n > 0 of single steps.
    void take(const entry& alone, int n);
    /// Computes coefficient n > 0 of some groups; the coefficients that are read from the arrays are stored there.
    void run(const entry& groups, int n);

private:
    // A coefficient at `array` + n and its position in row n.
    struct transfer {
        double* array;
        std::size_t place;
    };

    class builder;

    std::vector<entry> order_;
    std::vector<int> alone_;
    std::vector<lane_group> groups_;
    std::vector<transfer> states_;
    std::vector<transfer> transfers_;
    std::vector<transfer> starts_;  // of each position
    lane_rows rows_;
};

}  // namespace libration::ode
