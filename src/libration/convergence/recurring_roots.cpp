#include "recurring_roots.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

namespace libration::convergence {

namespace {

constexpr std::size_t fewest_fits = 3;

using rows_of_places = std::vector<std::vector<std::complex<double>>>;

// The roots of each fit at N, N - 1 and N - 2 that has any, of all multiplicities that they may be read with or of 1; only
// of the exact fits if there are three.
rows_of_places last_roots(const approximant_family& family, bool simple_only = false) {
    rows_of_places all;
    rows_of_places exact;
    for (const auto& fit : family.fits) {
        if (fit.length < family.order - 2 || fit.roots.empty()) {
            continue;
        }
        std::vector<std::complex<double>> places;
        for (const auto& root : fit.roots) {
            if (!simple_only || root.multiplicity == 1) {
                places.emplace_back(root.position.re.convert_to<double>(), root.position.im.convert_to<double>());
            }
        }
        if (fit.exact) {
            exact.push_back(places);
        }
        all.push_back(std::move(places));
    }
    return exact.size() >= fewest_fits ? exact : all;
}

double nearest_distance(const std::vector<std::complex<double>>& places, const std::complex<double>& z) {
    double best = std::numeric_limits<double>::infinity();
    for (const auto& place : places) {
        best = std::min(best, std::abs(place - z));
    }
    return best;
}

// Two places within the territory of one at which a fifth of the fits have roots, to a twentieth of their distance.
std::optional<std::pair<recurring_root, recurring_root>> parts_of(const recurring_root& place, double territory,
                                                                  const rows_of_places& fits) {
    constexpr double close = 0.05;
    const std::size_t asked = std::max<std::size_t>(4, fits.size() / 5);
    rows_of_places near;
    for (const auto& places : fits) {
        auto& here = near.emplace_back();
        std::ranges::copy_if(places, std::back_inserter(here),
                             [&](const auto& z) { return std::abs(z - place.at) < territory; });
        if (here.size() < 2) {
            near.pop_back();
        }
    }
    for (const auto& here : near) {
        for (std::size_t i = 0; i < here.size(); ++i) {
            for (std::size_t k = i + 1; k < here.size(); ++k) {
                const double reach = close * std::abs(here[i] - here[k]);
                const auto agreeing = static_cast<std::size_t>(std::ranges::count_if(near, [&](const auto& other) {
                    return nearest_distance(other, here[i]) < reach && nearest_distance(other, here[k]) < reach;
                }));
                if (agreeing >= asked) {
                    return std::pair{recurring_root{here[i], reach}, recurring_root{here[k], reach}};
                }
            }
        }
    }
    return std::nullopt;
}

}  // namespace

std::vector<recurring_root> recurring_roots(const approximant_family& family) {
    const rows_of_places fits = last_roots(family);
    constexpr std::size_t most = 12;
    if (fits.size() < fewest_fits) {
        return {};
    }
    const std::size_t half = std::max<std::size_t>(2, fits.size() / 2);
    std::vector<recurring_root> all;
    std::vector<double> to_others;
    for (std::size_t i = 0; i < fits.size(); ++i) {
        for (const auto& z : fits[i]) {
            to_others.clear();
            for (std::size_t k = 0; k < fits.size(); ++k) {
                if (k != i) {
                    to_others.push_back(nearest_distance(fits[k], z));
                }
            }
            const auto middle = to_others.begin() + static_cast<std::ptrdiff_t>(half - 1);
            std::ranges::nth_element(to_others, middle);
            all.push_back({z, *middle});
        }
    }
    std::ranges::stable_sort(
        all, [](const auto& a, const auto& b) { return a.distance * std::abs(b.at) < b.distance * std::abs(a.at); });
    std::vector<recurring_root> found;
    for (const auto& each : all) {
        const double size = std::abs(each.at);
        const double d = std::max(each.distance, 1e-15 * size);
        if (d > 0.06 * size || found.size() == most) {
            break;
        }
        const bool taken = std::ranges::any_of(found, [&](const auto& other) {
            const double apart = std::abs(each.at - other.at);
            return apart < std::max({3 * d, 3 * other.distance, 1e-9 * size}) || d > 0.4 * apart;
        });
        if (!taken) {
            found.push_back({each.at, d});
        }
    }
    const rows_of_places simple = last_roots(family, true);
    std::vector<recurring_root> divided;
    for (const auto& each : found) {
        if (const auto parts = parts_of(each, territory_of(each, found), simple)) {
            divided.push_back(parts->first);
            divided.push_back(parts->second);
        } else {
            divided.push_back(each);
        }
    }
    return divided;
}

double territory_of(const recurring_root& cluster, const std::vector<recurring_root>& all) {
    double size = std::abs(cluster.at) / 4;
    for (const auto& other : all) {
        if (const double away = std::abs(cluster.at - other.at); away > 0) {
            size = std::min(size, 0.4 * away);
        }
        if (const double away = std::abs(cluster.at - std::conj(other.at));
            away > std::max(3 * cluster.distance, 1e-9)) {
            size = std::min(size, 0.4 * away);
        }
    }
    return std::max(size, 3 * cluster.distance);
}

}  // namespace libration::convergence
