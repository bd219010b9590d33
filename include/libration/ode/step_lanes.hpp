// Steps of a tape that do the same and do not need each other, side by side in the lanes of vectors, in double.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "libration/ode/tape.hpp"

namespace libration::ode {

/// Some steps of one kind, side by side; numbers of places in a row.
struct lane_group {
    operation kind;
    std::size_t lanes;
    std::size_t left;
    std::size_t right;
    std::size_t result;
    /// Where the indices begin of the places that the operands are gathered from before; none where they stand there.
    std::ptrdiff_t gathered_left;
    std::ptrdiff_t gathered_right;
    /// Where the factors begin: of multiples; of square roots, twice the root.
    std::size_t factors;
};

/// Coefficient n of all that groups read and write stands in row n.
struct lane_rows {
    std::size_t length = 0;
    std::vector<double> numbers;
    std::vector<std::int64_t> indices;
    std::vector<double> factors;

    double* row(int n) { return numbers.data() + static_cast<std::size_t>(n) * length; }
};

/// The steps of a tape in an order in which operands come first, those of one kind together where they wait for as
/// many others: products, squares, quotients, square roots, sums, differences and multiples, sixteen at most together.
/// None where that would be less than three on average. One loop over the degrees serves a group. Each lane sums in the
/// order in which one step alone does, and fuses no product with a sum: coefficients are the same to the last bit as
/// alone wherever the compiler does not fuse either, as on x86-64 unless it is told to.
class step_lanes {
public:
    /// One step by itself, or groups one after the other.
    struct entry {
        bool alone;
        std::size_t first;  ///< the step, or the first group
        std::size_t count;
        /// What goes from the arrays of steps into rows after a step, and back after groups.
        std::size_t first_transfer;
        std::size_t transfers;
    };

    step_lanes() = default;
    /// For a tape about any point, whose step i has its coefficients at arrays + i length, which have to stay there.
    /// factors[i] is the constant of step i, or its numerator where it has none.
    step_lanes(const tape& of, double* arrays, std::size_t length, const std::vector<double>& factors);

    /// Whether there is no group.
    bool empty() const { return groups_.empty(); }
    const std::vector<entry>& order() const { return order_; }
    /// After the coefficients 0 of all steps.
    void begin();
    /// Coefficient n > 0 of the unknowns is there.
    void take_states(int n);
    /// Coefficient n > 0 of a step that runs by itself is there.
    void take(const entry& alone, int n);
    /// Computes coefficient n > 0 of some groups; in the arrays are afterwards those that are read there.
    void run(const entry& groups, int n);

private:
    // Coefficients at `array` + n and in a place of row n.
    struct transfer {
        double* array;
        std::size_t place;
    };

    class builder;

    std::vector<entry> order_;
    std::vector<lane_group> groups_;
    std::vector<transfer> states_;
    std::vector<transfer> transfers_;
    std::vector<transfer> starts_;  // of each place
    lane_rows rows_;
};

}  // namespace libration::ode
