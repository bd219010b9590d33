#include "libration/convergence/family.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <utility>

namespace libration::convergence {

namespace {

constexpr std::ptrdiff_t fewest_exact = 3;

std::complex<double> place_of(const differential_root& root) {
    return {root.position.re.convert_to<double>(), root.position.im.convert_to<double>()};
}

// Whether a multiple root only lies between others: between two simple ones, or between a simple and a double one.
bool lies_between(const differential_root& root, const std::vector<differential_root>& all) {
    const auto z = place_of(root);
    std::vector<std::complex<double>> simple;
    std::vector<std::complex<double>> twofold;
    for (const auto& other : all) {
        const double away = std::abs(place_of(other) - z) / std::abs(z);
        if (other.multiplicity == 1 && away > 1e-12 && away < 0.08) {
            simple.push_back(place_of(other));
        } else if (other.multiplicity == 2 && away > 1e-9 && away < 0.08) {
            twofold.push_back(place_of(other));
        }
    }
    const auto balanced = [&](const auto& s, double weight_s, const auto& t, double weight_t) {
        return std::abs(weight_s * s + weight_t * t - (weight_s + weight_t) * z) < 0.3 * std::abs(s - t);
    };
    for (std::size_t i = 0; i < simple.size(); ++i) {
        for (std::size_t k = i + 1; k < simple.size() && root.multiplicity == 2; ++k) {
            if (balanced(simple[i], 1, simple[k], 1)) {
                return true;
            }
        }
        for (const auto& d : twofold) {
            if (root.multiplicity == 3 && (balanced(simple[i], 1, d, 2) || balanced(simple[i], 2, d, 1))) {
                return true;
            }
        }
    }
    return root.multiplicity == 3 && simple.size() >= 3;
}

void drop_between(std::vector<differential_root>& roots) {
    std::vector<differential_root> kept;
    for (const auto& root : roots) {
        if (root.multiplicity == 1 || !lies_between(root, roots)) {
            kept.push_back(root);
        }
    }
    roots = std::move(kept);
}

}  // namespace

bool approximant_family::is_exact() const {
    return std::ranges::count_if(fits, [](const auto& fit) { return fit.exact; }) >= fewest_exact;
}

bool approximant_family::has_exact_root() const {
    return std::ranges::any_of(fits, [](const auto& fit) { return fit.exact && !fit.roots.empty(); });
}

std::vector<differential_track> tracks_for(int order, coefficient_class of) {
    constexpr std::array degrees{0,  1,  2,  3,  4,  5,   6,   8,   10,  13,  16,  20,  25, 31,
                                 39, 48, 58, 70, 85, 100, 120, 145, 175, 210, 250, 300, 360};
    std::vector<differential_track> tracks;
    for (int m = 1; m <= 3; ++m) {
        for (const int degree : degrees) {
            for (int offset = 0; offset <= 1; ++offset) {
                if (degree <= order - 4 * m - 4 && (offset == 0 || (m > 1 && degree <= 6))) {
                    tracks.push_back({m, degree, offset});
                }
            }
        }
    }
    constexpr int dense = 24;
    for (int degree = 0; degree <= order - 6; ++degree) {
        const bool taken = degree <= dense || std::ranges::find(degrees, degree) != degrees.end();
        if (taken && 10 * degree >= 3 * order) {
            tracks.push_back({.order = 0, .degree = degree});
            tracks.push_back({.order = 1, .degree = degree, .lowest = 1});
        }
    }
    for (auto& track : tracks) {
        track.first = of.first;
        track.stride = of.stride;
    }
    return tracks;
}

std::vector<int> voting_lengths(int order) {
    constexpr std::size_t most = 6;
    std::vector<int> lengths;
    for (double g = 14; std::lround(g) < order; g *= 1.15) {
        if (static_cast<double>(std::lround(g)) >= 0.38 * order) {
            lengths.push_back(static_cast<int>(std::lround(g)));
        }
    }
    if (lengths.size() > most) {
        lengths.erase(lengths.begin(), lengths.end() - static_cast<std::ptrdiff_t>(most));
    }
    lengths.push_back(order);
    return lengths;
}

approximant_family family_of(std::span<const mpfr> b, coefficient_class of, double noise, const task_runner& run) {
    approximant_family family;
    family.order = static_cast<int>(b.size()) - 1;
    const long bits = bits_for(family.order, noise);
    family.unit = level_unit(b);
    family.scaled = in_unit(b, family.unit, bits);
    family.tracks = tracks_for(family.order, of);
    family.lengths = voting_lengths(family.order);
    std::vector<int> fitted;
    for (const int length : family.lengths) {
        for (int fewer = 2; fewer >= 0; --fewer) {
            fitted.push_back(length - fewer);
        }
    }
    std::ranges::sort(fitted);
    fitted.erase(std::ranges::unique(fitted).begin(), fitted.end());
    const auto fit = [&](root_annulus within) {
        family.fits = differential_fits(family.scaled, family.tracks, fitted, within, bits, run);
        for (auto& each : family.fits) {
            if (each.exact) {
                drop_between(each.roots);
            }
        }
    };
    fit({0.6, 1.4});
    if (family.is_exact() && !family.has_exact_root()) {
        fit({0.02, 50});
    }
    return family;
}

}  // namespace libration::convergence
