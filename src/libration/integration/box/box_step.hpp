// A step of theorem G: the series through the middle of a box, and radii that grow by the comparison system.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "libration/expansion/tail_bound.hpp"
#include "libration/integration/step.hpp"
#include "libration/series/power_series.hpp"

namespace libration::ode {

/// Radii of the box at every distance from the end of the piece before up to `end`, which is exact.
struct box_piece {
    ball end;
    std::vector<magnitude> most;
};

/// The series of the given unknowns about the middle of a box with their tails, up to the length in one direction, and
/// the radii of the errors on pieces, one after the other.
struct box_series {
    std::vector<series::power_series<ball>> centre;
    tail_bound tail;
    long bits = 0;
    std::vector<box_piece> pieces;
    std::vector<magnitude> last;  ///< the radii at the end

    /// The unknowns of the solution through the middle.
    std::vector<ball> flow_of_centre(const ball& distance) const;
};

class box_step : public step {
public:
    box_step(flow_state from, std::shared_ptr<const box_series> series, ball length)
        : step(std::move(from), std::move(length),
               {series->bits, series->centre.front().order(), step_method::comparison, cost_of(series->centre.size())}),
          series_(std::move(series)) {}

    std::vector<ball> values(const ball& distance) const override;
    /// There is none: throws std::logic_error.
    ball_matrix derivative(const ball& distance) const override;
    /// With a box as the set, without columns.
    flow_state end() const override;

private:
    // Of a step with so many unknowns, in steps with few.
    static long cost_of(std::size_t unknowns) { return 1 + static_cast<long>(unknowns / 128); }

    std::shared_ptr<const box_series> series_;
};

/// The box with these radii, without columns: memory linear in the number of unknowns.
lohner_set thin_box(std::vector<magnitude> radii);

}  // namespace libration::ode
