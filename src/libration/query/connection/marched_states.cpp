#include "marched_states.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "../../algebra/dense_matrix.hpp"

namespace libration::ode {

std::optional<std::vector<std::vector<ball>>> marched_states(const explicit_system& system,
                                                             const std::vector<ball>& start,
                                                             const std::vector<ball>& times, long bits,
                                                             const proof_route& route, const march_watch& watch) {
    const ball point = constant_value<ball>::of(system.point());
    std::vector<std::size_t> order(times.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return std::fabs(as_double(times[i] - point)); });
    std::vector<std::vector<ball>> result(times.size());
    for (const bool earlier : {false, true}) {
        std::optional<proved_march> march;
        for (const std::size_t i : order) {
            if ((arb_is_negative((times[i] - point).handle()) != 0) != earlier) {
                continue;
            }
            if (!march) {
                march.emplace(system, start, bits, run_bits::usual_error_bits, watch, route);
            }
            auto state = march->at(times[i]);
            if (!state) {
                return std::nullopt;
            }
            result[i] = *std::move(state);
        }
    }
    return result;
}

}  // namespace libration::ode
