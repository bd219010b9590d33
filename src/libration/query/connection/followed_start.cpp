#include "followed_start.hpp"

#include "../../algebra/dense_matrix.hpp"
#include "libration/integration/proved_march.hpp"

namespace libration::ode {

differentiable_start typed_start(const parametric_system& open, const std::vector<ball>& numbers) {
    expression_values<ball> values(open.leaves, ball(0));
    for (const ball& each : numbers) {
        values.push_back(each);
    }
    differentiable_start result;
    for (const expression& each : open.starts) {
        result.values.push_back(values.of(each));
        auto& row = result.by_numbers.emplace_back();
        for (const expression& leaf : open.leaves) {
            row.push_back(values.of(partial(each, leaf)));
        }
    }
    return result;
}

std::optional<differentiable_start> followed_start(const parametric_system& open, const differentiable_start& from,
                                                   double time, long bits, long error_bits, const march_watch& watch,
                                                   const proof_route& route) {
    proved_march march(open.system, from.values, bits, error_bits, watch, route);
    march.keep_derivative();
    const ball target = constant_value<ball>::of(open.system.point()) + exactly(time);
    const auto state = march.at(target);
    if (!state) {
        return std::nullopt;
    }
    return differentiable_start{*state, product(march.derivative_at(target), from.by_numbers)};
}

}  // namespace libration::ode
