// The parts of singularity_search that follow an estimate to a singularity and examine it by a loop.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "singularity_search.hpp"

namespace libration::ode {

namespace {

constexpr int loop_points = 16;
// The least relative change of the unknowns after a turn that is not rounding.
constexpr double least_change = 1e-6;
// Ratios that agree within this tolerance indicate one singularity.
constexpr double good_agreement = 0.03;
constexpr double better_agreement = 0.003;
constexpr int most_approaches = 14;
// Fraction of the distance: estimates that change by less have converged.
constexpr double settled_part = 0.05;
constexpr int enough_settled = 4;
constexpr int polishing_steps = 10;
constexpr double polishing_part = 0.5;
constexpr double axis_part = 1e-3;
// Laurent coefficients from values on a loop; those below laurent_slack relative to the values are 0.
constexpr int laurent_points = 64;
constexpr int laurent_terms = 12;
constexpr double laurent_slack = 1e-6;

}  // namespace

// Follows the estimates of every group from the newest point to singularities that are not yet known. Next to one that
// was found for a group the others are examined again: theirs may be in the disc resolved by it.
void singularity_search::look_at_last() {
    const std::size_t here = points_.size() - 1;
    for (std::size_t group = 0; group < groups_.size(); ++group) {
        if (!look_at(group) || groups_.size() == 1) {
            continue;
        }
        const point near = points_.back();
        for (std::size_t other = 0; other < groups_.size(); ++other) {
            if (other != group) {
                return_to(near);
                look_at(other);
            }
        }
        return_to(points_[here]);
    }
}

// Appends the same point again as the newest one.
void singularity_search::return_to(const point& of) {
    point again = of;
    std::vector<complex> values;
    for (const auto& each : again.coefficients) {
        values.push_back(each[0]);
    }
    series_.about(as_number(again.at), values);
    points_.push_back(std::move(again));
}

// Follows the estimate of the newest point for a group; returns whether there was one to follow.
bool singularity_search::look_at(std::size_t group) {
    const auto estimate = series_.nearest(groups_[group]);
    if (!estimate || !(estimate->agreement < good_agreement)) {
        return false;
    }
    const plane_point at = points_.back().at + as_point(estimate->distance);
    bool mirrored = false;
    int turns = 0;
    const plane_point inside = folded(at, mirrored, turns);
    if (!(std::abs(at) < 1.2 * within_)) {
        return false;
    }
    // By rounding errors the solution becomes one that is singular at the initial point itself.
    if (of_.singular && std::abs(at) < believed_part * points_.front().radius) {
        return false;
    }
    const double away = std::abs(as_point(estimate->distance));
    const auto near = [&](const plane_point& z, double reach) { return std::abs(inside - z) < reach; };
    if (std::ranges::any_of(found_,
                            [&](const candidate& each) {
                                return each.group == group && near(each.at, std::max(0.5 * each.reach, 0.1 * away));
                            }) ||
        std::ranges::any_of(refused_,
                            [&](const refusal& each) { return each.group == group && near(each.at, 0.02 * away); })) {
        return false;
    }
    approach(at, group);
    return true;
}

// The location as estimated from closer points; intermediate points are discarded.
plane_point singularity_search::polished(plane_point centre, std::size_t group) {
    const std::size_t count = points_.size();
    double best = 1;
    plane_point result = centre;
    for (int k = 0; k < polishing_steps; ++k) {
        const point& from = points_.back();
        const plane_point next = from.at + polishing_part * (centre - from.at);
        if (!(std::abs(next - from.at) < 0.6 * from.radius)) {
            break;
        }
        expand(next, values_at(from, next), static_cast<int>(points_.size()) - 1);
        const auto estimate = series_.nearest(groups_[group]);
        if (!estimate || !(estimate->agreement < good_agreement)) {
            break;
        }
        centre = next + as_point(estimate->distance);
        const double error = estimate->agreement * std::abs(as_point(estimate->distance));
        if (k == 0 || error < best) {
            best = error;
            result = centre;
        }
    }
    points_.resize(count);
    return_to(points_.back());
    points_.pop_back();
    return result;
}

// Moves a location next to the edge of the sector onto it: the only singularity in its loop is its own mirror image.
plane_point singularity_search::on_axis(const plane_point& z, double reach) const {
    for (const double angle : {0.0, std::numbers::pi / rotation_}) {
        const plane_point axis = std::polar(1.0, angle);
        const double along = (z * std::conj(axis)).real();
        if (along > 0 && std::abs(z - along * axis) < axis_part * reach) {
            return along * axis;
        }
    }
    return z;
}

// Whether the loop of the last points encloses one pole, at this location: in the Laurent series about it, from the
// values on the circle, the coefficients beyond the order of the pole are 0.
bool singularity_search::is_one_pole(const candidate& loop, const plane_point& place) const {
    const std::size_t first = points_.size() - 1 - loop_points;
    const plane_point arm = points_[first].at - loop.at;
    for (const std::size_t leaf : of_.functions) {
        if (std::ranges::find(groups_[loop.group], leaf) == groups_[loop.group].end()) {
            continue;
        }
        const plane_point exponent =
            as_point(series_.exponent(leaf, as_number(place - points_.back().at), search_order));
        const double order = std::clamp(std::round(-exponent.real()), 0.0, 1.0 * laurent_terms);
        std::vector<plane_point> sums(laurent_terms, 0);
        double size = 0;
        for (int k = 0; k < laurent_points; ++k) {
            const plane_point turn = std::polar(1.0, 2 * std::numbers::pi * k / laurent_points);
            const plane_point z = loop.at + arm * turn;
            const auto near = static_cast<std::size_t>((k * loop_points + laurent_points / 2) / laurent_points);
            plane_point term = as_point(values_at(points_[first + near], z)[leaf]) * turn;
            size = std::max(size, std::abs(term));
            for (plane_point& sum : sums) {
                sum += term / (1.0 * laurent_points);
                term *= (z - place) / loop.reach;
            }
        }
        for (auto k = static_cast<std::size_t>(order); k < sums.size(); ++k) {
            if (!(std::abs(sums[k]) < laurent_slack * size)) {
                return false;
            }
        }
    }
    return true;
}

// Stores the candidate in the sector, at the polished location, unless it is already known.
void singularity_search::keep(candidate made, plane_point place) {
    bool mirrored = false;
    int turns = 0;
    made.at = on_axis(folded(place, mirrored, turns), made.reach);
    for (plane_point& each : made.path) {
        each *= std::polar(1.0, -turns * 2 * std::numbers::pi / rotation_);
        each = mirrored ? std::conj(each) : each;
    }
    const bool known = std::ranges::any_of(found_, [&](const candidate& each) {
        return each.group == made.group && std::abs(each.at - made.at) < 0.2 * std::max(each.reach, made.reach);
    });
    if (!known) {
        found_.push_back(std::move(made));
    }
}

// Approaches a guess until a loop around it encloses no other singularity.
void singularity_search::approach(const plane_point& guess, std::size_t group) {
    plane_point centre = guess;
    plane_point aim = guess;
    int settled = 0;
    for (int attempt = 0; attempt < most_approaches; ++attempt) {
        const auto estimate = series_.nearest(groups_[group]);
        const double away = std::abs(points_.back().at - centre);
        if (estimate && estimate->agreement < good_agreement) {
            const plane_point again = points_.back().at + as_point(estimate->distance);
            if (std::abs(again - aim) > 0.5 * std::abs(points_.back().at - aim) + 0.1 * away) {
                break;  // the estimate is elsewhere
            }
            settled = std::abs(again - centre) < settled_part * away ? settled + 1 : 0;
            centre = again;
            if (estimate->agreement < better_agreement) {
                if (const auto loop = loop_round(centre, group)) {
                    const plane_point place = polished(centre, group);
                    if (!loop->single_valued || is_one_pole(*loop, place)) {
                        keep(*loop, place);
                        return;
                    }
                    centre = aim = place;  // of several in the loop the nearest one
                    settled = 0;
                }
            }
            // No loop of any size closes if singularities of other sheets accumulate.
            if (settled >= enough_settled) {
                keep({centre, std::abs(points_.back().at - centre), false, false,
                      path_to(static_cast<int>(points_.size()) - 1), group},
                     polished(centre, group));
                return;
            }
        }
        // Continue from the nearest existing point.
        const point& from = points_.back();
        const plane_point way = centre - from.at;
        const double part = std::min(0.5, search_step * from.radius / std::max(std::abs(way), 1e-300));
        if (!(part > 0.05) || points() >= most_points_) {
            break;
        }
        const plane_point next = from.at + part * way;
        expand(next, values_at(from, next), static_cast<int>(points_.size()) - 1);
    }
    bool mirrored = false;
    int turns = 0;
    refused_.push_back({folded(guess, mirrored, turns), group});
}

bool singularity_search::is_changed(const point& before, const point& after, const leaf_group& of) const {
    return std::ranges::any_of(of, [&](std::size_t i) {
        const plane_point first = as_point(before.coefficients[i][0]);
        const plane_point last = as_point(after.coefficients[i][0]);
        const double size = std::max({std::abs(first), std::abs(last), 1e-300});
        return !(std::abs(last - first) < least_change * size);
    });
}

// Once around from the newest point: the radius of convergence at every point of the loop must be determined by its
// centre.
std::optional<candidate> singularity_search::loop_round(const plane_point& centre, std::size_t group) {
    const std::size_t first = points_.size() - 1;
    const plane_point arm = points_.back().at - centre;
    const double reach = std::abs(arm);
    bool alone = true;
    for (int k = 1; k <= loop_points && alone; ++k) {
        const point& from = points_.back();
        const plane_point next = centre + arm * std::polar(1.0, 2 * std::numbers::pi * k / loop_points);
        alone = points() < most_points_ && std::abs(next - from.at) < 0.6 * from.radius;
        if (alone) {
            expand(next, values_at(from, next), static_cast<int>(points_.size()) - 1);
            alone = points_.back().radius > 0.7 * reach && points_.back().radius < 1.5 * reach;
        }
    }
    std::optional<candidate> made;
    if (alone) {
        const bool changed = is_changed(points_[first], points_.back(), carried_);
        const bool group_changed = changed && is_changed(points_[first], points_.back(), groups_[group]);
        made = candidate{centre, reach, !changed, !group_changed, path_to(static_cast<int>(first)), group};
    }
    if (!made || !made->single_valued) {
        points_.resize(first + 1);  // on other sheets, or unusable
    }
    // The series of the last point again, for what follows.
    return_to(points_.back());
    points_.pop_back();
    return made;
}

}  // namespace libration::ode
