#include "apparent_root.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cluster_answer.hpp"

namespace libration::convergence {

namespace {

// log2 of the largest of some coefficients.
double log2_largest(const std::vector<mpfr>& values, std::size_t first, std::size_t end) {
    double largest = -1e9;
    for (std::size_t i = first; i < end; ++i) {
        largest = std::max(largest, log_size(values[i]) / std::numbers::ln2);
    }
    return largest;
}

// The list continued by up to three equations, exact ones or else the sharpest of those that agree on a root, as far as
// they agree to 10^-6; empty if there is only one.
std::vector<mpfr> continuation(const approximant_family& family, const root_consensus& root, int count) {
    const long bits = bits_for(family.order);
    const precision_scope scope(decimal_digits(bits));
    std::vector<std::size_t> tracks;
    for (const auto& fit : family.fits) {
        if (fit.exact) {
            tracks.push_back(fit.track);
        }
    }
    for (const std::size_t each : tracks.empty() ? root.tracks : std::vector<std::size_t>()) {
        if (std::ranges::find(tracks, each) == tracks.end()) {
            tracks.push_back(each);
        }
    }
    tracks.resize(std::min<std::size_t>(tracks.size(), 3));
    std::vector<std::vector<mpfr>> all;
    for (const std::size_t each : tracks) {
        const auto& track = family.tracks[each];
        const int length = std::min(family.order, track.degree + 110);
        if (const auto relation = relation_of(family.scaled, track, length, bits)) {
            all.push_back(continued_by(*relation, family.scaled, family.order, count));
        }
    }
    if (all.size() < 2) {
        return {};
    }
    const std::size_t first = family.scaled.size();
    std::size_t end = first;
    const auto agree = [&](std::size_t i) {
        return std::ranges::all_of(all, [&](const auto& each) {
            return isfinite(each[i]) && abs(each[i] - all[0][i]) <= abs(all[0][i]) / 1'000'000;
        });
    };
    while (end < all[0].size() && agree(end)) {
        ++end;
    }
    return {all[0].begin() + static_cast<std::ptrdiff_t>(first), all[0].begin() + static_cast<std::ptrdiff_t>(end)};
}

// Whether the list continued by the equations of the sharpest place falls as for the singularity at `next` (none: faster
// than any) rather than as for one at `root`: the solution is regular at `root`.
bool is_apparent(const approximant_family& family, const root_consensus& root, const root_consensus* next,
                 const root_consensus& sharpest) {
    const double y = std::log2(root.modulus());
    const double ratio = next == nullptr ? 0 : std::log2(next->modulus()) - y;
    if (next != nullptr && ratio < 0.02) {
        return false;
    }
    const int n = family.order;
    const int asked = next == nullptr ? 2 * n : std::min(2000, std::max(2 * n, static_cast<int>(60 / ratio)));
    const auto ahead = continuation(family, sharpest, asked);
    const int w = std::max(6, n / 8);
    const auto m = static_cast<int>(ahead.size());
    if (m < 3 * w) {
        return false;
    }
    const auto ends = ahead.size();
    const auto window = static_cast<std::size_t>(w);
    const double growth = std::log2(static_cast<double>(n + m) / (n + w / 2.0));
    const double fall =
        log2_largest(ahead, ends - window, ends) + (n + m) * y - log2_largest(ahead, 0, window) - (n + w / 2.0) * y;
    const double singular = -(root.exponent.value.convert_to<double>() + 1) * growth;
    const double regular =
        next == nullptr ? singular - 60
                        : -(std::clamp(next->exponent.value.convert_to<double>(), -9.0, 9.0) + 1) * growth - m * ratio;
    // A place that is much less sharp than one further out is hardly singular: a smaller gap decides.
    const double gap = width_of(root) > 1e6 * width_of(sharpest) ? 2 : 8;
    return singular - regular > gap && fall < (singular + regular) / 2;
}

// An exponent 0, 1, .. of equations that agree, or a regular singular point of exact ones.
bool may_be_apparent(const root_consensus& at) {
    const double t = at.exponent.value.convert_to<double>();
    const auto fraction = [](double x) { return std::abs(x - std::round(x)); };
    const double width = std::max({fraction(at.exponent.spread), at.exponent.step, fraction(t)});
    const bool is_power = !at.assumed && t > -0.5 && width < 0.02;
    return std::abs(t) < 9 && (at.exact ? at.is_regular_type() : is_power);
}

}  // namespace

bool is_regular_point(const approximant_family& family, const std::vector<const root_cluster*>& strong) {
    const root_consensus& first = strong.front()->now();
    if (!may_be_apparent(first)) {
        return false;
    }
    const root_consensus& sharpest =
        (*std::ranges::min_element(strong, {}, [](const auto* each) { return width_of(each->now()); }))->now();
    if (!first.exact && first.orders == 1 && sharpest.orders > 1) {
        return true;
    }
    return is_apparent(family, first, strong.size() > 1 ? &strong[1]->now() : nullptr, sharpest);
}

}  // namespace libration::convergence
