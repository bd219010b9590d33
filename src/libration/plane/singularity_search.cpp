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

constexpr int most_intermediate_points = 40;
constexpr double least_progress = 0.95;
constexpr double least_search_cell = 1e-4;

// |a - b|^2; comparisons with many points need neither a square root nor the overflow protection of hypot.
double squared_distance(const plane_point& a, const plane_point& b) { return std::norm(a - b); }

}  // namespace

singularity_search::singularity_search(const path_system& of, std::vector<leaf_group> groups, int rotation,
                                       long most_points, const plane_watch& watch)
    : of_(of),
      watch_(watch),
      groups_(std::move(groups)),
      carried_(of.form.lifted.given),
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
