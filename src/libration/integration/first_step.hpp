// The first step from a regular singular initial point, by theorem S.
#pragma once

#include <utility>

#include "libration/equation/explicit_system.hpp"
#include "libration/integration/singular_step.hpp"
#include "libration/integration/step.hpp"

namespace libration::ode {

class singular_first_step : public step {
public:
    /// From the initial point of the system, with so many bits, and of the derivative by the initial values.
    singular_first_step(flow_state from, const explicit_system& of, const singular_step& first, long bits,
                        long error_bits, const proof_route& route)
        : step(std::move(from), first.length, {bits, first.series->degree()}),
          of_(of),
          first_(first),
          bits_(bits),
          error_bits_(error_bits),
          route_(route) {}

    std::vector<ball> values(const ball& distance) const override;
    /// Throws like derivative_beyond_start.
    ball_matrix derivative(const ball& distance) const override;
    flow_state end() const override;

private:
    explicit_system of_;
    singular_step first_;
    long bits_, error_bits_;
    proof_route route_;
};

}  // namespace libration::ode
