// Bounds of the slopes of the right-hand sides of a system over a tube, for theorem G.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/expansion/ball_expansion.hpp"
#include "slope_matrix.hpp"

namespace libration::ode {

/// The derivatives df_i/dy_j that are not identically 0 by the form of the equations of first order, evaluated in balls,
/// with common subexpressions once. The right-hand sides themselves are evaluated too: where all values are finite, f is
/// defined and continuously differentiable.
class slope_bounds {
public:
    explicit slope_bounds(const explicit_system& of);
    slope_bounds(const slope_bounds&) = delete;
    slope_bounds& operator=(const slope_bounds&) = delete;

    /// M of theorem G for y' = f (direction 1) or, backwards, y' = -f (-1): M_ii >= sup of direction df_i/dy_i, M_ij >=
    /// sup |df_i/dy_j| over the box of the unknowns and their lower derivatives at the times of a ball. std::nullopt if a
    /// bound is not finite.
    std::optional<slope_matrix> over(const ball& time, const std::vector<ball>& box, int direction);

private:
    struct entry {
        std::size_t row = 0, column = 0;
    };

    // The system of first order, with its entries, by rows.
    struct differentiated {
        explicit differentiated(const explicit_system& of);

        explicit_system system;
        std::vector<entry> entries;
        std::vector<expression> derivatives;
    };

    explicit slope_bounds(const differentiated& of);

    std::vector<entry> entries_;
    std::size_t size_;
    tape tape_;
    taylor_expansion<ball> values_;
};

}  // namespace libration::ode
