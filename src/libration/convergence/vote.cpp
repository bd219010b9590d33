#include "libration/convergence/vote.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "recurring_roots.hpp"

namespace libration::convergence {

namespace {

constexpr double finest_step = 1e-58;
constexpr std::size_t fewest_voters = 3;

std::complex<double> place_of(const complex_number<mpfr>& z) {
    return {z.re.convert_to<double>(), z.im.convert_to<double>()};
}

double distance(const complex_number<mpfr>& a, const complex_number<mpfr>& b) { return std::abs(place_of(a - b)); }

double distance(const mpfr& a, const mpfr& b) { return std::abs(mpfr(a - b).convert_to<double>()); }

struct voter {
    double step;
    double exponent_step;
    const differential_root* root;
    bool exact;
    std::size_t track;
};

// The types of roots of a fit near a place, and the nearest root of each; of an exact equation the single one that the
// multiplicity of the place determines.
std::map<int, const differential_root*> candidates(const differential_fit& fit, const std::complex<double>& centre,
                                                   double territory) {
    std::map<int, const differential_root*> nearest;
    const auto away = [&](const differential_root* root) { return std::abs(place_of(root->position) - centre); };
    for (const auto& root : fit.roots) {
        if (away(&root) < territory) {
            auto& best = nearest[root.type()];
            best = best == nullptr || away(&root) < away(best) ? &root : best;
        }
    }
    if (!fit.exact || nearest.size() < 2) {
        return nearest;
    }
    const auto first = std::ranges::min_element(nearest, {}, [&](const auto& each) { return away(each.second); });
    const auto middle = place_of(first->second->position);
    std::vector<const differential_root*> here;
    for (const auto& root : fit.roots) {
        if (std::abs(place_of(root.position) - middle) < 1e-6 * std::abs(centre)) {
            here.push_back(&root);
        }
    }
    const auto* best = *std::ranges::max_element(
        here, {}, [](const auto* root) { return std::pair(root->lower, root->multiplicity); });
    if (best->type() == 21) {  // next to a confirmed simple root
        const auto simple = std::ranges::find_if(here, [](const auto* root) { return root->type() == 11; });
        best = simple != here.end() ? *simple : best;
    }
    return {{best->type(), best}};
}

double root_mean_square(double a, double b) { return std::sqrt((a * a + b * b) / 2); }

// The voters at a length: of each track and type the root at it and at the two lengths before.
std::vector<voter> voters_at(const approximant_family& family, int length, const std::complex<double>& centre,
                             double territory) {
    std::map<std::pair<std::size_t, int>, std::map<int, std::pair<const differential_root*, bool>>> by_track;
    for (const auto& fit : family.fits) {
        if (fit.length > length - 3 && fit.length <= length) {
            for (const auto& [type, root] : candidates(fit, centre, territory)) {
                by_track[{fit.track, type}][fit.length] = {root, fit.exact};
            }
        }
    }
    std::vector<voter> voters;
    for (const auto& [track, by_length] : by_track) {
        const auto& [root, exact] = by_length.rbegin()->second;
        if (exact) {
            voters.push_back({finest_step, finest_step, root, true, track.first});
        } else if (by_length.size() == 3) {
            const auto* const before = by_length.at(length - 1).first;
            const auto* const first = by_length.at(length - 2).first;
            voters.push_back({std::max(finest_step, root_mean_square(distance(root->position, before->position),
                                                                     distance(before->position, first->position))),
                              root_mean_square(distance(root->exponent.re, before->exponent.re),
                                               distance(before->exponent.re, first->exponent.re)),
                              root, false, track.first});
        }
    }
    std::ranges::stable_sort(voters, {}, &voter::step);
    return voters;
}

// Only the exact voters if there are three; of those only the regular ones if there are three.
void keep_qualified(std::vector<voter>& voters) {
    constexpr std::size_t most = 60;
    const auto keep_if_three = [&](auto qualified) {
        if (std::ranges::count_if(voters, qualified) >= static_cast<std::ptrdiff_t>(fewest_voters)) {
            std::erase_if(voters, [&](const auto& each) { return !qualified(each); });
            return true;
        }
        return false;
    };
    if (keep_if_three([](const voter& v) { return v.exact; })) {
        keep_if_three([](const voter& v) { return v.root->is_regular(); });
    }
    voters.resize(std::min(voters.size(), most));
}

// The value at which the weights of those up to it reach half of all.
template <class T>
T weighted_median(const std::vector<T>& values, const std::vector<double>& weights) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t i, std::size_t k) { return values[i] < values[k]; });
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    double sum = 0;
    for (const std::size_t i : order) {
        sum += weights[i];
        if (sum >= total / 2) {
            return values[i];
        }
    }
    return values[order.back()];
}

double weighted_quantile(const std::vector<double>& values, const std::vector<double>& weights, double part) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t i, std::size_t k) { return values[i] < values[k]; });
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    double sum = 0;
    for (const std::size_t i : order) {
        sum += weights[i];
        if (sum >= part * total) {
            return values[i];
        }
    }
    return values[order.back()];
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t n = values.size();
    return n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

// The leader of the vote, and the log of its share.
std::pair<std::size_t, double> leader_of(const std::vector<voter>& voters, double territory) {
    constexpr double width = 4;
    constexpr double trust = 0.7;
    std::pair<std::size_t, double> best{0, -std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < voters.size(); ++i) {
        double sum = 0;
        for (const auto& other : voters) {
            const double apart = distance(voters[i].root->position, other.root->position) / (width * other.step);
            sum += std::log(trust * territory / (width * other.step) / std::pow(1 + apart * apart, 1.5) + 1 - trust);
        }
        if (sum > best.second) {
            best = {i, sum};
        }
    }
    best.second /= static_cast<double>(voters.size());
    return best;
}

// Those within 12 of their own steps of the leader.
std::vector<voter> members_of(const std::vector<voter>& voters, const voter& leader) {
    constexpr double within = 12;
    std::vector<voter> members;
    for (const auto& each : voters) {
        if (distance(leader.root->position, each.root->position) <= within * each.step) {
            members.push_back(each);
        }
    }
    return members;
}

// The members whose steps are at most ten times the third smallest, at most 15.
std::vector<voter> top_of(const std::vector<voter>& members) {
    constexpr std::size_t most = 15;
    std::vector<voter> top;
    for (const auto& each : members) {
        if (each.step <= 10 * members[2].step && top.size() < most) {
            top.push_back(each);
        }
    }
    return top;
}

bool determines_exponent(const voter& each) { return !each.root->assumed; }

exponent_vote exponent_of(const std::vector<voter>& voters) {
    std::vector<double> weights;
    std::vector<mpfr> exponents;
    std::vector<double> steps;
    for (const auto& each : voters) {
        weights.push_back(1 / each.step);
        exponents.push_back(each.root->exponent.re);
        steps.push_back(each.exponent_step);
    }
    exponent_vote found{.value = weighted_median(exponents, weights)};
    std::vector<double> away;
    for (const mpfr& each : exponents) {
        away.push_back(distance(each, found.value));
    }
    found.spread = weighted_quantile(away, weights, 0.75);
    found.step = median(steps);
    return found;
}

// From the voters that determine an exponent, if there are three.
void add_exponents(root_consensus& found, std::vector<voter> top, std::vector<voter> members) {
    const auto assumes = [](const voter& each) { return !determines_exponent(each); };
    found.assumed = std::ranges::count_if(top, determines_exponent) < static_cast<std::ptrdiff_t>(fewest_voters);
    if (found.assumed) {
        std::erase_if(members, assumes);
        if (members.size() >= fewest_voters) {
            found.determined = exponent_of(top_of(members));
        }
    } else {
        std::erase_if(top, assumes);
    }
    found.exponent = exponent_of(top);
    std::vector<double> second;
    std::map<int, int> types;
    int irregular = 0;
    for (const auto& each : top) {
        if (each.root->second) {
            second.push_back(*each.root->second);
        }
        ++types[each.root->type()];
        irregular += each.root->irregular ? 1 : 0;
    }
    found.second = second.empty() ? 0 : median(second);
    found.type = std::ranges::max_element(types, {}, [](const auto& each) { return each.second; })->first;
    found.irregular = 2 * irregular > static_cast<int>(top.size());
}

// Of members that determine an exponent, unless the top ones do not.
void add_members(root_consensus& found, std::vector<voter> members) {
    found.agreeing = static_cast<int>(members.size());
    if (!found.assumed) {
        std::erase_if(members, [](const voter& each) { return !determines_exponent(each); });
    }
    double products = 0;
    double squares = 0;
    for (const auto& each : members) {
        const double x = mpfr(each.root->position.re - found.position.re).convert_to<double>();
        const double y = mpfr(each.root->exponent.re - found.exponent.value).convert_to<double>();
        products += x * y;
        squares += x * x;
        found.members.emplace_back(each.root->position.re.convert_to<double>(),
                                   each.root->exponent.re.convert_to<double>());
    }
    found.slope = squares > 0 ? products / squares : 0;
    std::vector<double> residuals;
    for (const auto& each : members) {
        const double x = mpfr(each.root->position.re - found.position.re).convert_to<double>();
        const double y = mpfr(each.root->exponent.re - found.exponent.value).convert_to<double>();
        residuals.push_back(std::abs(y - found.slope * x));
    }
    found.residual = median(residuals);
}

std::optional<root_consensus> consensus_at(const approximant_family& family, int length,
                                           const std::complex<double>& centre, double territory) {
    auto voters = voters_at(family, length, centre, territory);
    if (voters.size() < fewest_voters) {
        return std::nullopt;
    }
    keep_qualified(voters);
    const auto [lead, log_share] = leader_of(voters, territory);
    const auto members = members_of(voters, voters[lead]);
    if (members.size() < fewest_voters) {
        return std::nullopt;
    }
    const auto top = top_of(members);
    std::vector<double> weights;
    std::vector<mpfr> re;
    std::vector<mpfr> im;
    std::vector<double> steps;
    for (const auto& each : top) {
        weights.push_back(1 / each.step);
        re.push_back(each.root->position.re);
        im.push_back(each.root->position.im);
        steps.push_back(each.step);
    }
    root_consensus found;
    found.length = length;
    found.position = {weighted_median(re, weights), weighted_median(im, weights)};
    std::vector<double> away;
    for (const auto& each : top) {
        away.push_back(distance(each.root->position, found.position));
    }
    found.spread = weighted_quantile(away, weights, 0.75);
    found.step = median(steps);
    found.share = std::exp(log_share);
    found.exact = std::ranges::any_of(top, &voter::exact);
    for (const auto& each : top) {
        found.tracks.push_back(each.track);
    }
    std::set<int> orders;
    for (const auto& each : members) {
        orders.insert(family.tracks[each.track].order);
    }
    found.orders = static_cast<int>(orders.size());
    add_exponents(found, top, members);
    add_members(found, members);
    return found;
}

}  // namespace

double root_consensus::distance_to(const root_consensus& other) const { return distance(position, other.position); }

std::vector<root_cluster> clusters_of(const approximant_family& family) {
    const auto found = recurring_roots(family);
    const double reach = family.is_exact() ? 10 : 1.6;
    double nearest = std::numeric_limits<double>::infinity();
    double nearest_sharp = nearest;
    for (const auto& each : found) {
        nearest = std::min(nearest, std::abs(each.at));
        if (each.distance < 0.01 * std::abs(each.at)) {
            nearest_sharp = std::min(nearest_sharp, std::abs(each.at));
        }
    }
    const double limit = reach * (std::isfinite(nearest_sharp) ? nearest_sharp : nearest);
    std::vector<root_cluster> clusters;
    for (const auto& each : found) {
        if (each.at.imag() < -1e-12 * std::abs(each.at) || std::abs(each.at) > limit) {
            continue;
        }
        root_cluster cluster{.centre = each.at, .distance = each.distance, .history = {}};
        const double territory = territory_of(each, found);
        for (const int length : family.lengths) {
            cluster.history.push_back(consensus_at(family, length, each.at, territory));
        }
        if (cluster.history.back()) {
            clusters.push_back(std::move(cluster));
        }
    }
    return clusters;
}

}  // namespace libration::convergence
