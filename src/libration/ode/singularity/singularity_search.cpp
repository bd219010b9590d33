#include "singularity_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

namespace libration::ode {

namespace {

constexpr int search_order = 44;
// Fractions of a radius: up to which values are used, and up to which the series is taken to converge.
constexpr double search_step = 0.5;
constexpr double believed_part = 0.8;
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
constexpr int most_intermediate_points = 40;
constexpr double least_progress = 0.95;
constexpr double least_search_cell = 1e-4;
constexpr int polishing_steps = 10;
constexpr double polishing_part = 0.5;
constexpr double axis_part = 1e-3;
// Laurent coefficients from values on a loop; those below laurent_slack relative to the values are 0.
constexpr int laurent_points = 64;
constexpr int laurent_terms = 12;
constexpr double laurent_slack = 1e-6;

complex_number<double> as_number(const plane_point& z) { return {z.real(), z.imag()}; }
plane_point as_point(const complex_number<double>& z) { return {z.re, z.im}; }

// |a - b|^2; comparisons with many points need neither a square root nor the overflow protection of hypot.
double squared_distance(const plane_point& a, const plane_point& b) { return std::norm(a - b); }

}  // namespace

singularity_search::singularity_search(const path_system& of, std::vector<leaf_group> groups, int rotation,
                                       long most_points, const plane_watch& watch)
    : of_(of),
      watch_(watch),
      groups_(std::move(groups)),
      carried_(of.lifted.given),
      rotation_(rotation),
      most_points_(most_points),
      series_(of, search_order) {
    std::iota(carried_.begin(), carried_.end(), std::size_t{0});
    series_.about_start();
    add_expanded({0, 0}, -1);
}

void singularity_search::expand(const plane_point& at, const std::vector<complex>& values, int parent) {
    series_.about(as_number(at), values);
    add_expanded(at, parent);
}

void singularity_search::add_expanded(const plane_point& at, int parent) {
    point made{at, std::exp2(series_.log_of_radius(parent < 0 ? std::max(2, rotation_) : 1)), {}, parent};
    for (std::size_t i = 0; i < series_.carried(); ++i) {
        const complex* const a = series_.coefficients(i);
        made.coefficients.emplace_back(a, a + search_order + 1);
    }
    if (std::isnan(made.radius) || !(made.radius > 0)) {
        made.radius = 0;
    }
    points_.push_back(std::move(made));
    if (watch_) {
        watch_(plane_step::point);
    }
}

std::vector<complex_number<double>> singularity_search::values_at(const point& of, const plane_point& at) {
    const complex s = as_number(at - of.at);
    std::vector<complex> values;
    for (const auto& a : of.coefficients) {
        complex sum = a.back();
        for (std::size_t n = a.size() - 1; n-- > 0;) {
            sum = sum * s + a[n];
        }
        values.push_back(sum);
    }
    return values;
}

// The plane is cut behind each branch point, as seen from the initial point.
bool singularity_search::crosses_cut(const plane_point& from, const plane_point& to) const {
    return std::ranges::any_of(found_, [&](const candidate& each) {
        if (each.single_valued) {
            return false;
        }
        // Multiplied by the conjugate of the branch point p, which becomes |p|^2, the cut is the real axis from there.
        const double x = each.at.real();
        const double y = each.at.imag();
        const double a = from.imag() * x - from.real() * y;
        const double b = to.imag() * x - to.real() * y;
        if ((a > 0) == (b > 0)) {
            return false;
        }
        const double square = std::norm(each.at);
        const auto on_axis = [square](double height, const plane_point& z) {
            return height * height < 1e-24 * std::norm(z) * square;
        };
        if (on_axis(a, from) || on_axis(b, to)) {
            return false;
        }
        const double along_from = from.real() * x + from.imag() * y;
        const double along_to = to.real() * x + to.imag() * y;
        return along_from + a / (a - b) * (along_to - along_from) > square;
    });
}

int singularity_search::best_parent(const plane_point& at) const {
    int best = -1;
    double least = 1e300;
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const double part = squared_distance(at, points_[i].at) / (points_[i].radius * points_[i].radius);
        if (part < least && !crosses_cut(points_[i].at, at)) {
            least = part;
            best = static_cast<int>(i);
        }
    }
    return best;
}

bool singularity_search::add_point(const plane_point& at) {
    double left = std::numeric_limits<double>::infinity();
    for (int k = 0; k < most_intermediate_points; ++k) {
        const int parent = best_parent(at);
        if (parent < 0 || points() >= most_points_) {
            return false;
        }
        const point& from = points_[static_cast<std::size_t>(parent)];
        const plane_point way = at - from.at;
        const double reach = search_step * from.radius;
        const bool arrives = std::abs(way) <= reach;
        if (!(from.radius > 0) || (!arrives && !(std::abs(way) < least_progress * left))) {
            return false;
        }
        left = std::abs(way);
        const plane_point next = arrives ? at : from.at + way / std::abs(way) * (0.9 * reach);
        expand(next, values_at(from, next), parent);
        look_at_last();
        if (arrives) {
            return true;
        }
    }
    return false;
}

std::vector<plane_point> singularity_search::path_to(int index) const {
    std::vector<plane_point> path;
    for (int i = index; i > 0; i = points_[static_cast<std::size_t>(i)].parent) {
        path.push_back(points_[static_cast<std::size_t>(i)].at);
    }
    std::ranges::reverse(path);
    return path;
}

bool singularity_search::is_explained(const cell& of) const {
    std::array<plane_point, 5> corners{std::polar(of.r1, of.a1), std::polar(of.r1, of.a2), std::polar(of.r2, of.a1),
                                       std::polar(of.r2, of.a2), std::polar((of.r1 + of.r2) / 2, (of.a1 + of.a2) / 2)};
    const auto all_in = [&](const plane_point& centre, double radius) {
        return std::ranges::all_of(corners,
                                   [&](const plane_point& z) { return squared_distance(z, centre) < radius * radius; });
    };
    if (std::ranges::any_of(found_, [&](const candidate& each) { return all_in(each.at, each.reach); })) {
        return true;
    }
    // If a cut goes through the cell, each side of it needs a separate point whose disc contains the whole cell.
    std::array<bool, 5> explained{};
    for (const point& each : points_) {
        if (all_in(each.at, believed_part * each.radius)) {
            for (std::size_t k = 0; k < corners.size(); ++k) {
                explained[k] = explained[k] || !crosses_cut(each.at, corners[k]);
            }
        }
    }
    return std::ranges::all_of(explained, [](bool each) { return each; });
}

// Maps into the sector of arguments 0 .. pi/rotation.
plane_point singularity_search::folded(plane_point z, bool& mirrored, int& turns) const {
    const double sector = 2 * std::numbers::pi / rotation_;
    turns = static_cast<int>(std::lround(std::arg(z) / sector));
    z *= std::polar(1.0, -turns * sector);
    mirrored = z.imag() < 0;
    return mirrored ? std::conj(z) : z;
}

std::optional<plane_point> singularity_search::value_at(const plane_point& offset, std::size_t leaf) const {
    // Only the reflection: the effect of a rotation on an unknown is not available here.
    const bool below = offset.imag() < 0;
    const plane_point z = below ? std::conj(offset) : offset;
    const point* best = nullptr;
    double least = believed_part * believed_part;
    for (const point& each : points_) {
        const double part = squared_distance(z, each.at) / (each.radius * each.radius);
        if (part < least && !crosses_cut(each.at, z)) {
            least = part;
            best = &each;
        }
    }
    if (best == nullptr) {
        return std::nullopt;
    }
    const plane_point value = as_point(values_at(*best, z)[leaf]);
    return below ? std::conj(value) : value;
}

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
        for (std::size_t k = static_cast<std::size_t>(order); k < sums.size(); ++k) {
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

void singularity_search::search(double within) {
    within_ = within;
    unexplained_ = 0;
    std::priority_queue<cell> cells;
    cells.push({0, within, 0, std::numbers::pi / rotation_});
    while (!cells.empty()) {
        const cell now = cells.top();
        cells.pop();
        if (is_explained(now)) {
            continue;
        }
        const double length = now.r2 - now.r1;
        const double width = (now.a2 - now.a1) * now.r2;
        if (std::max(length, width) < least_search_cell * within || points() >= most_points_) {
            ++unexplained_;
            continue;
        }
        if (std::max(length, width) < 0.7 * within) {
            add_point(std::polar((now.r1 + now.r2) / 2, (now.a1 + now.a2) / 2));
            if (is_explained(now)) {
                continue;
            }
        }
        const double r = (now.r1 + now.r2) / 2;
        const double a = (now.a1 + now.a2) / 2;
        if (width > 1.5 * length) {
            cells.push({now.r1, now.r2, now.a1, a});
            cells.push({now.r1, now.r2, a, now.a2});
        } else if (length > 1.5 * width) {
            cells.push({now.r1, r, now.a1, now.a2});
            cells.push({r, now.r2, now.a1, now.a2});
        } else {
            cells.push({now.r1, r, now.a1, a});
            cells.push({now.r1, r, a, now.a2});
            cells.push({r, now.r2, now.a1, a});
            cells.push({r, now.r2, a, now.a2});
        }
    }
}

}  // namespace libration::ode
