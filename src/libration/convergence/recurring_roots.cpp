#include "recurring_roots.hpp"

#include <algorithm>
#include <limits>

namespace libration::convergence {

namespace {

constexpr std::size_t fewest_fits = 3;

using rows_of_places = std::vector<std::vector<std::complex<double>>>;

// The roots of each fit at N, N - 1 and N - 2 that has any; only of the exact ones if there are three.
rows_of_places last_roots(const approximant_family& family) {
    rows_of_places all;
    rows_of_places exact;
    for (const auto& fit : family.fits) {
        if (fit.length < family.order - 2 || fit.roots.empty()) {
            continue;
        }
        std::vector<std::complex<double>> places;
        for (const auto& root : fit.roots) {
            places.push_back(
                std::complex<double>(root.position.re.convert_to<double>(), root.position.im.convert_to<double>()));
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
    return found;
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
