// Bounds that a monotone map does not enlarge, by iteration.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "libration/scalar/ball/magnitude.hpp"

namespace libration::ode {

/// s with image(s) <= s, or rather image(image(image(s))), which is not larger, from the first s on, each time
/// enlarged by an eighth; after(s) restores what is given in it. std::nullopt if none is found, or if the image is not finite.
template <class Image, class After>
std::optional<std::vector<magnitude>> kept_bounds(const Image& image, std::vector<magnitude> s, const After& after) {
    constexpr int most_attempts = 40;
    const auto nonzero = [](const std::vector<magnitude>& all) {
        return std::ranges::count_if(all, [](const magnitude& each) { return !each.is_zero(); });
    };
    const magnitude inflation = magnitude(9U) / 8U;
    // In a chain of unknowns a defect reaches one more of them with each attempt; these attempts are not counted.
    for (int attempt = 0; attempt < most_attempts;) {
        const auto next = image(s);
        attempt += nonzero(next) > nonzero(s) ? 0 : 1;
        if (!std::ranges::all_of(next, [](const magnitude& each) { return each.is_finite(); })) {
            return std::nullopt;
        }
        if (std::ranges::equal(next, s, [](const magnitude& a, const magnitude& b) { return a <= b; })) {
            return image(image(next));
        }
        for (std::size_t i = 0; i < s.size(); ++i) {
            s[i] = next[i] * inflation;
        }
        after(s);
    }
    return std::nullopt;
}

}  // namespace libration::ode
