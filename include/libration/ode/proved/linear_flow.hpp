// Linear systems with constant coefficients, by the exponential of their matrix.
#pragma once

#include <optional>
#include <vector>

#include "libration/ode/explicit_system.hpp"
#include "libration/scalar/ball/value.hpp"

namespace libration::ode {

/// y' = A y + b with constant A and b, y the unknowns with their lower derivatives in the order of names_of_state:
///     (y(t), 1) = exp((t - t0) [A b; 0 0]) (y(t0), 1),
/// without the last row and column for b = 0. For every t, stiff or not, the cost is that of some dozens of products of
/// matrices [Arb, arb_mat_exp: scaling and squaring in balls].
class linear_flow {
public:
    /// std::nullopt unless the equations have this form by exact arithmetic, at a regular initial point.
    static std::optional<linear_flow> of(const explicit_system& system);

    /// The state at a time; each unknown is an exact 0 or has about as many bits, relative to itself. std::nullopt if
    /// that requires many times the precision, as for an unknown that decays to nothing while others do not, one
    /// that is 0 for a reason that balls do not show, or if a value is beyond 2^(2^30).
    std::optional<std::vector<ball>> at(const number& time, long bits) const;

private:
    explicit linear_flow(const explicit_system& system) : point_(system.point()) {}
    bool read(const explicit_system& system);
    std::vector<ball> rounded_state(const number& time, long bits) const;
    bool is_homogeneous() const;

    number point_;
    std::vector<number> starts_, constants_;
    std::vector<std::vector<number>> rows_;  ///< of A
};

}  // namespace libration::ode
