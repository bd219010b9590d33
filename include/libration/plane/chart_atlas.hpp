// The charts of a solution: the given system, and the coordinates in which its poles are zeros.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "libration/plane/regular_coordinates.hpp"
#include "libration/plane/series_disc.hpp"

namespace libration::ode {

/// Chart 0 is the system itself. Of an equation that has regular_coordinates chart 1 consists of these, v = 1/y first: there
/// y = 1/v is meromorphic, with its poles at the zeros of v.
class chart_atlas {
public:
    /// y is the unknown or lower derivative with index `shown`; of an equation with chart 1 it is the unknown. `size` is that of
    /// y beyond which chart 1 is used.
    chart_atlas(const explicit_system& system, double size, std::size_t shown = 0);

    bool has_poles() const { return regular_.has_value(); }
    const regular_coordinates& regular() const { return *regular_; }
    const plane_system& chart(std::size_t k) const { return k == 0 ? given_ : *beyond_; }
    /// The chart for a state in chart `now`, with hysteresis.
    std::size_t chosen(std::size_t now, const std::vector<complex_ball>& state) const;
    /// A state in another chart, at an offset from the initial point.
    std::vector<complex_ball> converted(std::size_t from, std::size_t to, const complex_ball& offset,
                                        const std::vector<complex_ball>& state) const;
    /// y from the coordinates of a chart; not finite where v may be 0.
    complex_ball value(std::size_t chart, const std::vector<complex_ball>& state) const {
        return chart == 0 ? state[shown_] : complex_ball(1) / state[0];
    }
    complex_ball time(const complex_ball& offset) const;

private:
    plane_system given_;
    std::optional<regular_coordinates> regular_;
    std::optional<plane_system> beyond_;
    std::size_t order_;
    double size_;
    std::size_t shown_;
};

}  // namespace libration::ode
