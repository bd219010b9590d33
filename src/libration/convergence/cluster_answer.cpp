#include "cluster_answer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "apparent_root.hpp"

namespace libration::convergence {

namespace {

constexpr double widening = 8;
constexpr double found_share = 10;
constexpr double finest_width = 1e-57;
constexpr double unknown_exponent = 100;  // as an uncertainty

// The consensus at earlier lengths: the one before, and the last and the last but one of at most 0.93 of the length.
struct earlier_consensus {
    const root_consensus* before = nullptr;
    const root_consensus* older = nullptr;
    const root_consensus* oldest = nullptr;
};

earlier_consensus earlier_than(const root_cluster& cluster, std::size_t at) {
    earlier_consensus found;
    const double limit = 0.93 * cluster.history[at]->length;
    for (std::size_t i = at; i-- > 0;) {
        if (!cluster.history[i]) {
            continue;
        }
        const root_consensus* const each = &*cluster.history[i];
        found.before = found.before != nullptr ? found.before : each;
        if (each->length <= limit) {
            if (found.older != nullptr) {
                found.oldest = each;
                break;
            }
            found.older = each;
        }
    }
    return found;
}

// The largest of three moves; std::nullopt without a length of at most 0.93 of it.
template <class Distance>
std::optional<double> drift_of(const root_cluster& cluster, std::size_t at, const Distance& distance) {
    const auto earlier = earlier_than(cluster, at);
    if (earlier.older == nullptr) {
        return std::nullopt;
    }
    const root_consensus& now = *cluster.history[at];
    const double oldest = earlier.oldest == nullptr ? 0 : distance(now, *earlier.oldest) / 4;
    return std::max({distance(now, *earlier.before), distance(now, *earlier.older), oldest});
}

double moved(const root_consensus& a, const root_consensus& b) { return a.distance_to(b) / a.modulus(); }

// The last four lengths agree within four times their widths and drifts, the last one to a hundredth.
bool is_persistent(const root_cluster& cluster) {
    constexpr std::size_t count = 4;
    const std::size_t size = cluster.history.size();
    if (size < count) {
        return false;
    }
    const auto reach = [&](std::size_t i) {
        const root_consensus& at = *cluster.history[i];
        return 4 * std::max(width_of(at), drift_of(cluster, i, moved).value_or(0)) * at.modulus();
    };
    for (std::size_t i = size - count; i < size; ++i) {
        if (!cluster.history[i]) {
            return false;
        }
    }
    const double last = reach(size - 1);
    for (std::size_t i = size - count; i < size; ++i) {
        if (cluster.history[i]->distance_to(cluster.now()) > reach(i) + last) {
            return false;
        }
    }
    return last < 0.01 * cluster.now().modulus();
}

// Whether b lies at the angle of a multiple of 30 degrees from a, but not at a.
bool is_related(const placed_cluster& a, const placed_cluster& b) {
    const auto z = a.consensus().place();
    const auto w = b.consensus().place();
    if (std::abs(z.imag()) < 1e-9 && std::abs(w.imag()) < 1e-9) {
        return z.real() * w.real() < 0;
    }
    const double turns = (std::arg(z) - std::arg(w)) * 6 / std::numbers::pi;
    const double nearest = std::round(turns);
    return std::abs(turns - nearest) < 4 * (a.uncertainty + b.uncertainty) + 1e-6 && std::fmod(nearest, 12) != 0;
}

// Whether the position is so sharp that nothing is joined to a pole or a logarithm. Fits of a pure one converge
// geometrically, like 10^(-n/2) and faster, down to the noise of the list; those of a psi series with weak logarithms, such
// as the one of a Duffing oscillator with a damping of 1/100, were never sharper than 10^(-n/6).
bool is_pure(const root_cluster& cluster, std::size_t at) {
    const int n = cluster.history[at]->length;
    return position_uncertainty(cluster, at) <= std::max(std::pow(10.0, -n / 3.0), 64 * n * cluster.noise);
}

// Whether those that determine an exponent, if any, agree with those that assume one.
bool is_plausible_assumption(const root_consensus& found) {
    if (!found.determined) {
        return true;
    }
    const double away = std::abs(mpfr(found.exponent.value - found.determined->value).convert_to<double>());
    return away <= widening * std::max(found.determined->spread, found.determined->step);
}

// The kind that the consensus of one length alone shows.
singularity_kind kind_alone(const root_cluster& cluster, std::size_t at) {
    const root_consensus& found = *cluster.history[at];
    const auto [exponent, uncertainty] = exponent_at(cluster, at);
    const double t = exponent.convert_to<double>();
    if (found.irregular || (found.type == 21 && (std::abs(t) > 8 || uncertainty > 1))) {
        return singularity_kind::irregular;
    }
    if (uncertainty > 0.3) {
        return singularity_kind::unknown;
    }
    if (found.type == 22 || found.type == 32 || found.type == 33) {
        return singularity_kind::confluent;
    }
    const double nearest = std::round(t);
    if (uncertainty < 0.05 && abs(mpfr(exponent - mpfr(nearest))) <= std::max(uncertainty, 1e-12)) {
        return nearest < 0        ? singularity_kind::pole
               : found.type == 11 ? singularity_kind::logarithm
                                  : singularity_kind::unknown;
    }
    // A psi series with weak logarithms looks like a pole whose exponent is not quite an integer.
    constexpr double beside_a_pole = 1e-3;
    if (nearest < 0 && std::abs(t - nearest) < beside_a_pole) {
        return singularity_kind::unknown;
    }
    return singularity_kind::algebraic;
}

}  // namespace

double width_of(const root_consensus& consensus) {
    return std::max({consensus.spread, consensus.step, finest_width}) / consensus.modulus();
}

double position_uncertainty(const root_cluster& cluster, std::size_t at) {
    const root_consensus& found = *cluster.history[at];
    const double raw = width_of(found);
    if (raw < 1e-45 && found.exact) {
        return widening * raw;
    }
    const auto drift = drift_of(cluster, at, moved);
    const double factor = found.share >= 30 ? widening : 2.5 * widening;
    return factor * (drift ? std::max(raw, *drift) : 5 * raw);
}

placed_cluster placed(const root_cluster& cluster) {
    const std::size_t last = cluster.history.size() - 1;
    const double at_last = position_uncertainty(cluster, last);
    placed_cluster best{&cluster, last, at_last};
    for (std::size_t i = 0; i < last; ++i) {
        if (!cluster.history[i] || cluster.history[i]->exact || cluster.history[i]->share < found_share) {
            continue;
        }
        const double uncertainty = 3 * position_uncertainty(cluster, i);
        const double away = moved(cluster.now(), *cluster.history[i]);
        if (uncertainty < best.uncertainty / 3 && away <= uncertainty + at_last) {
            best = {&cluster, i, uncertainty};
        }
    }
    return best;
}

std::pair<mpfr, double> exponent_at(const root_cluster& cluster, std::size_t at) {
    const root_consensus& found = *cluster.history[at];
    const bool by_top = !found.assumed || found.exact || (is_pure(cluster, at) && is_plausible_assumption(found));
    const auto vote_of = [&](const root_consensus& each) -> const exponent_vote& {
        return !by_top && each.determined ? *each.determined : each.exponent;
    };
    const exponent_vote& vote = vote_of(found);
    if (!by_top && !found.determined) {
        return {vote.value, unknown_exponent};
    }
    const double width = std::max({vote.spread, vote.step, 1e-50});
    if (found.exact && found.spread < 1e-45 && width < 1e-6) {
        return {vote.value, widening * width};
    }
    const auto drift = drift_of(cluster, at, [&](const root_consensus& x, const root_consensus& y) {
        return std::abs(mpfr(vote_of(x).value - vote_of(y).value).convert_to<double>());
    });
    return {vote.value, widening * (drift ? std::max(width, *drift) : 5 * width)};
}

singularity_kind kind_at(const root_cluster& cluster, std::size_t at) {
    const singularity_kind kind = kind_alone(cluster, at);
    if (cluster.history[at]->exact) {
        return kind;
    }
    const bool simple = kind == singularity_kind::pole || kind == singularity_kind::logarithm;
    if (simple) {
        return is_pure(cluster, at) ? kind : singularity_kind::unknown;
    }
    if (kind == singularity_kind::confluent && is_pure(cluster, at)) {
        return kind;
    }
    int held = 0;
    for (std::size_t i = at; i-- > 0 && held < 2;) {
        if (!cluster.history[i] || kind_alone(cluster, i) != kind) {
            return singularity_kind::unknown;
        }
        ++held;
    }
    return held == 2 ? kind : singularity_kind::unknown;
}

std::vector<const root_cluster*> strong_clusters(const approximant_family& family,
                                                 const std::vector<root_cluster>& clusters, double least) {
    std::vector<const root_cluster*> strong;
    for (const auto& each : clusters) {
        if (each.now().share >= least || (each.now().share >= 4 && is_persistent(each))) {
            strong.push_back(&each);
        }
    }
    std::ranges::stable_sort(strong, {}, [](const auto* each) { return each->now().modulus(); });
    while (!strong.empty() && nature_of_nearest(family, strong) == nature_of_root::regular) {
        strong.erase(strong.begin());
    }
    return strong;
}

std::vector<placed_cluster> ring_of(const std::vector<const root_cluster*>& strong) {
    std::vector<placed_cluster> all;
    for (const auto* each : strong) {
        all.push_back(placed(*each));
    }
    const placed_cluster nearest = *std::ranges::min_element(all, {}, &placed_cluster::upper);
    std::vector<placed_cluster> ring;
    for (const auto& each : all) {
        if (each.lower() <= nearest.upper() &&
            (each.of == nearest.of || each.uncertainty < 1e-40 || is_related(nearest, each))) {
            ring.push_back(each);
        }
    }
    std::ranges::stable_sort(ring, [](const auto& a, const auto& b) {
        if (a.uncertainty != b.uncertainty) {
            return a.uncertainty < b.uncertainty;
        }
        return a.consensus().exponent.value < b.consensus().exponent.value;
    });
    return ring;
}

std::optional<double> doubtful_nearer(const approximant_family& family, const std::vector<root_cluster>& clusters,
                                      double below) {
    for (const auto* each : strong_clusters(family, clusters, 3)) {
        const root_consensus& now = each->now();
        const double width = width_of(now);
        const auto earlier = earlier_than(*each, each->history.size() - 1);
        const auto is_near = [&](const root_consensus* at) { return at->distance_to(now) < 0.03 * now.modulus(); };
        // Fits of a rounded list place roots by its noise, other ones at each length.
        const bool of_noise = each->noise > 0 && (earlier.older == nullptr || !is_near(earlier.older));
        const bool stays = !of_noise && (earlier.before == nullptr || is_near(earlier.before));
        if (stays && now.share < found_share && width < 0.01 && now.modulus() * (1 + 4 * width) < below) {
            return now.modulus();
        }
    }
    return std::nullopt;
}

}  // namespace libration::convergence
