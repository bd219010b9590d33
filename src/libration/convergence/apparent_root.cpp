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

// Up to three equations, exact ones or else, at the length of the root, the sharpest of those that agree on it.
std::vector<differential_relation> relations_at(const approximant_family& family, const root_consensus& root) {
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
    std::vector<differential_relation> relations;
    for (const std::size_t each : tracks) {
        const auto& track = family.tracks[each];
        const int length = std::min(root.exact ? family.order : root.length, track.degree + 110);
        if (auto relation = relation_of(family.scaled, track, length, bits_for(family.order))) {
            relations.push_back(*std::move(relation));
        }
    }
    return relations;
}

// As many terms as these many products give, 2000 at least.
int affordable_terms(const std::vector<differential_relation>& relations) {
    constexpr std::size_t most_products = 600'000;
    std::size_t most = 1;
    for (const auto& each : relations) {
        std::size_t size = 0;
        for (const auto& q : each.q) {
            size += q.size();
        }
        most = std::max(most, size);
    }
    return static_cast<int>(std::max<std::size_t>(2000, most_products / most));
}

// What follows after the first `length` + 1 by these equations, as far as they agree to 10^-6; empty if there is only one.
std::vector<mpfr> continuation(const approximant_family& family, const std::vector<differential_relation>& relations,
                               int length, int count) {
    if (relations.size() < 2) {
        return {};
    }
    std::vector<std::vector<mpfr>> all;
    all.reserve(relations.size());
    for (const auto& each : relations) {
        all.push_back(continued_by(each, family.scaled, length, count));
    }
    const auto first = static_cast<std::size_t>(length) + 1;
    std::size_t end = first;
    const auto agree = [&](std::size_t i) {
        const mpfr size = std::max(mpfr(abs(all[0][i])), mpfr(abs(all[0][i - 1])));  // of two, since one may be 0
        return std::ranges::all_of(
            all, [&](const auto& each) { return isfinite(each[i]) && abs(each[i] - all[0][i]) <= size / 1'000'000; });
    };
    while (end < all[0].size() && agree(end)) {
        ++end;
    }
    return {all[0].begin() + static_cast<std::ptrdiff_t>(first), all[0].begin() + static_cast<std::ptrdiff_t>(end)};
}

// By whether the list continued by the equations of the sharpest place falls as for the singularity at `next` (none:
// faster than any) or as for one at `root`.
nature_of_root nature_by_growth(const approximant_family& family, const root_consensus& root,
                                const root_consensus* next, const root_consensus& sharpest) {
    const double y = std::log2(root.modulus());
    const double ratio = next == nullptr ? 0 : std::log2(next->modulus()) - y;
    if (next != nullptr && (ratio <= 0 || (!root.exact && ratio < 0.02))) {
        return nature_of_root::undecided;
    }
    const precision_scope scope(decimal_digits(bits_for(family.order)));
    const auto relations = relations_at(family, sharpest);
    const int n = sharpest.exact ? family.order : sharpest.length;
    const int most = root.exact ? affordable_terms(relations) : 2000;
    const int asked =
        next == nullptr ? 2 * n : std::min(most, std::max(2 * n, static_cast<int>(std::min(60 / ratio, 1e6))));
    const auto ahead = continuation(family, relations, n, asked);
    const int w = std::max(6, n / 8);
    const auto m = static_cast<int>(ahead.size());
    if (m < 3 * w) {
        return nature_of_root::undecided;
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
    if (singular - regular <= gap) {
        return nature_of_root::undecided;
    }
    return fall < (singular + regular) / 2 ? nature_of_root::regular : nature_of_root::singular;
}

// An exponent 0, 1, .. of equations that agree, or a regular singular point of exact ones.
bool may_be_apparent(const root_consensus& at) {
    const auto t = at.exponent.value.convert_to<double>();
    const auto fraction = [](double x) { return std::abs(x - std::round(x)); };
    const double width = std::max({fraction(at.exponent.spread), at.exponent.step, fraction(t)});
    const bool is_power = !at.assumed && t > -0.5 && width < 0.02;
    return std::abs(t) < 9 && (at.exact ? at.is_regular_type() : is_power);
}

}  // namespace

nature_of_root nature_of_nearest(const approximant_family& family, const std::vector<const root_cluster*>& strong) {
    // Each at the length where it is sharpest: the noise of a list spoils the longer ones.
    const auto place = [](const auto* each) -> const root_consensus& { return placed(*each).consensus(); };
    const root_consensus& first = place(strong.front());
    if (!may_be_apparent(first)) {
        return nature_of_root::singular;
    }
    const root_consensus& sharpest =
        place(*std::ranges::min_element(strong, {}, [&](const auto* each) { return width_of(place(each)); }));
    if (!first.exact && first.orders == 1 && sharpest.orders > 1) {
        return nature_of_root::regular;
    }
    return nature_by_growth(family, first, strong.size() > 1 ? &place(strong[1]) : nullptr, sharpest);
}

}  // namespace libration::convergence
