// Linear systems with constant coefficients, by the exponential of their matrix.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/scalar/ball/magnitude.hpp"
#include "libration/scalar/ball/value.hpp"

namespace libration::ode {

/// y' = A y + b with constant A and b, y the unknowns with their lower derivatives in the order of names_of_state:
///     (y(t), 1) = exp((t - t0) [A b; 0 0]) (y(t0), 1),
/// without the last row and column for b = 0. For every t, stiff or not, the cost is that of some dozens of products of
/// matrices [Arb, arb_mat_exp: scaling and squaring in balls]; if A has few entries and the largest row sum of
/// |A (t - t0)| is moderate, that of as many products of A and a vector and some dozens more, by the Taylor series of y
/// or of e^(c t) y (docs/theorems/equations.md).
class linear_flow {
public:
    /// std::nullopt unless the equations have this form by exact arithmetic, at a regular initial point.
    static std::optional<linear_flow> of(const explicit_system& system);

    /// Replaces balls that contain 0 by 0 where a value is proved to be 0.
    using zeros_at = std::function<void(std::vector<ball>& state)>;
    /// The state at a time; each unknown is an exact 0 or has about as many bits, relative to itself. std::nullopt if
    /// that requires many times the precision, as for an unknown that decays to nothing while others do not, one
    /// that is 0 for a reason that neither balls nor put_zeros show, or if a value is beyond 2^(2^30).
    std::optional<std::vector<ball>> at(const number& time, long bits, const zeros_at& put_zeros = {}) const;

private:
    // A nonzero entry of a row.
    struct entry {
        std::size_t column;
        number value;
    };

    explicit linear_flow(const explicit_system& system) : point_(system.point()) {}
    bool read(const explicit_system& system);
    ball elapsed(const number& time) const;
    // The nonzero entries of the rows of a matrix.
    using rows_of_balls = std::vector<std::vector<std::pair<std::size_t, ball>>>;
    // By the matrix plus shift, whose largest row sum is `norm`, with so many bits.
    struct series_plan {
        magnitude shift, norm;
        long bits;
    };

    rows_of_balls scaled_rows(const ball& gone, const magnitude& shift) const;
    std::optional<series_plan> planned_series(const number& time, long bits) const;
    std::vector<ball> rounded_state(const number& time, long bits) const;
    std::vector<ball> by_exponential(const number& time, long bits) const;
    std::optional<std::vector<ball>> by_series(const number& time, long bits) const;
    static std::vector<ball> product(const rows_of_balls& rows, const std::vector<ball>& x);
    std::vector<bool> changing(const std::vector<ball>& first_term) const;
    bool is_homogeneous() const;

    number point_;
    std::vector<number> starts_, constants_;
    std::vector<std::vector<entry>> rows_;  ///< of A
};

}  // namespace libration::ode
