#include "model_tail.hpp"

#include <algorithm>

#include "../../expansion/set_values.hpp"

namespace libration::ode {

std::optional<tail_bound> tail_of(const tape& of, const model_expansion& expansion) {
    double log_of_radius = no_radius;
    for (std::size_t i = 0; i < of.orders().size(); ++i) {
        const auto sizes = expansion.sizes_of(i);
        log_of_radius = std::min(log_of_radius, estimated_radius(sizes.data(), expansion.order(),
                                                                 [](const magnitude& each) { return each; }));
    }
    const series_sizes sizes = expansion.sizes();
    return first_tail(std::min(log_of_radius, largest_tried),
                      [&](const magnitude& radius) { return bounded_tail(of, sizes, radius); });
}

}  // namespace libration::ode
