#include "examined_list.hpp"

#include <cmath>
#include <utility>

namespace libration::convergence {

std::unique_ptr<examined_list> examined(std::span<const mpfr> b, coefficient_class of, double noise,
                                        const task_runner& run) {
    auto found = std::make_unique<examined_list>();
    const precision_scope scope(decimal_digits(bits_for(static_cast<int>(b.size()))));
    found->family = family_of(b, of, noise, run);
    if (static_cast<int>(b.size()) >= fewest_coefficients || found->family.is_exact()) {
        found->clusters = clusters_of(found->family);
        for (auto& each : found->clusters) {
            each.noise = noise;
        }
        found->strong = strong_clusters(found->family, found->clusters);
    }
    return found;
}

std::unique_ptr<examined_list> with_cuts(std::unique_ptr<examined_list> whole, std::span<const mpfr> b,
                                         coefficient_class of, double noise, const task_runner& run) {
    const double last = static_cast<double>(b.size()) - 1;
    if (whole->family.is_exact() && !whole->family.has_exact_root()) {
        return whole;
    }
    for (const double part : {0.8, 0.62, 0.48, 0.37, 0.28}) {
        const auto kept = static_cast<std::size_t>(std::lround(part * last)) + 1;
        if (kept < fewest_coefficients) {
            break;
        }
        auto found = examined(b.first(kept), of, noise, run);
        // An equation that a cut satisfies and the whole list does not was met by chance.
        if (!found->strong.empty() && !found->family.is_exact()) {
            return found;
        }
    }
    return whole;
}

}  // namespace libration::convergence
