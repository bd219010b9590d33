// The mean of a solution of a linear equation on the circle of its law: from pieces in the gaps between the slits, and the local
// expansions next to these.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "../algebra/dense_matrix.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "linear_law.hpp"
#include "local_matching.hpp"

namespace libration::ode {

namespace {

constexpr double half_turn_of_circle = std::numbers::pi;
constexpr double part_for_tips = 0.88;
constexpr double part_for_pieces = 0.4;
constexpr double reach_of_pieces = 0.85;
constexpr int arcs_of_tip = 12;
constexpr long bits_of_pieces = 60;
constexpr int terms_at_tips = 8;
constexpr double angle_margin_of_arcs = 1e-9;
constexpr double least_angle_of_slits = 1e-6;
constexpr int most_pieces_of_circle = 3'000;
// Of a gap, where the path reaches the circle: not a simple fraction, since symmetric equations have singular points there.
constexpr double part_of_gap = 0.4567;

}  // namespace

// A closed sector from 0, and the slits at its sides, as indices of inside_.
struct linear_law::gap {
    double from = 0, to = 0;
    std::optional<std::size_t> first, last;
};

std::vector<linear_law::gap> linear_law::gaps() const {
    struct side {
        double angle;
        std::optional<std::size_t> slit;
    };
    std::vector<side> sides;
    for (std::size_t i = 0; i < inside_.size(); ++i) {
        if (!structures_[places_[inside_[i]].factor].has_single_values()) {
            sides.push_back({places_[inside_[i]].angle, i});
        }
    }
    std::ranges::sort(sides, {}, &side::angle);
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
        if (sides[i + 1].angle - sides[i].angle < least_angle_of_slits) {
            throw error(
                error_kind::undecided, error_subject::problem, "",
                "has two singular points on one ray from its initial point, or close to one ray; take a smaller "
                "RHO as --within");
        }
    }
    if (sides.empty() || sides.front().angle > 0) {
        sides.insert(sides.begin(), {0, {}});
    }
    if (sides.back().angle < half_turn_of_circle) {
        sides.push_back({half_turn_of_circle, {}});
    }
    std::vector<gap> result;
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
        result.push_back({sides[i].angle, sides[i + 1].angle, sides[i].slit, sides[i + 1].slit});
    }
    return result;
}

// The angle from a slit up to which its expansion is used, inside a gap and less than a half turn.
double linear_law::width_of_tip(const fixed_point_terms& of, double widest) const {
    const double u = rho_ / std::abs(rounded_midpoint(of.place()));
    const ball& reach = of.parts().front().series.reach();
    const double radius = part_for_tips * arf_get_d(arb_midref(reach.handle()), ARF_RND_DOWN);
    const double cosine = (1 + u * u - radius * radius) / (2 * u);
    return std::min({widest, half_turn_of_circle * (1 - least_angle_of_slits),
                     cosine > -1 ? std::acos(std::min(cosine, 1.0)) : half_turn_of_circle});
}

// |x|^2 = 1 + u^2 - 2 u cos(phi) increases with the angle phi from the slit.
void linear_law::add_tip(const fixed_point_terms& of, double width) {
    const ball u = exactly(rho_) / modulus_in_balls(of.place());
    const auto distance_at = [&](double angle) {
        return sqrt(ball((u - 1) * (u - 1) + u * 2 * (1 - cos(exactly(angle)))));
    };
    for (int i = 0; i < arcs_of_tip; ++i) {
        const double from = i == 0 ? 0 : width * i / arcs_of_tip - angle_margin_of_arcs;
        const double to = width * (i + 1) / arcs_of_tip + angle_margin_of_arcs;
        const ball low = lower_bound(distance_at(std::max(from, 0.0)));
        const ball high = upper_bound(distance_at(to));
        ball sum(0);
        for (const local_part& each : of.parts()) {
            sum += each.series.bound(low, high);
        }
        mean_ += magnitude(sum) * magnitude::at_least(to - from, 0);
    }
}

// Adds the bound over the part of the circle between the angles that the piece about its centre covers; returns half its width.
double linear_law::add_piece(const state& at, const complex_ball& centre, double low, double high,
                             const std::vector<complex_ball>& all) {
    if (watch_) {
        watch_(plane_step::disc);
    }
    ++discs_;
    const double distance = distance_from(centre, all);
    const double radius = part_for_pieces * distance;
    const frobenius_series series =
        series_about(equation_, centre, at, all, {reach_of_pieces * distance, radius, bits_of_pieces, 0});
    const double width = 2 * std::asin(std::min(1.0, radius / (2 * rho_))) - angle_margin_of_arcs;
    if (!(width > 10 * angle_margin_of_arcs)) {
        throw precision_exhausted("the discs on a circle");
    }
    const double angle = std::arg(rounded_midpoint(centre));
    const double part = std::min(angle + width, high) - std::max(angle - width, low);
    const ball end = exactly(radius);
    mean_ += magnitude(series.bound(end, end)) * magnitude::at_least(std::max(part, 0.0) + 2 * angle_margin_of_arcs, 0);
    return width;
}

void linear_law::add_gap(const gap& over, const std::vector<fixed_point_terms>& tips) {
    const double whole = over.to - over.from;
    const double first = over.first ? width_of_tip(tips[*over.first], whole) : 0;
    const double last = over.last ? width_of_tip(tips[*over.last], whole - first) : 0;
    if (over.first) {
        add_tip(tips[*over.first], first);
    }
    if (over.last && last > 0) {
        add_tip(tips[*over.last], last);
    }
    const double low = over.from + first;
    const double high = over.to - last;
    if (high - low <= angle_margin_of_arcs) {
        return;
    }
    const std::vector<complex_ball> all = zeros();
    const double middle = low + part_of_gap * (high - low);
    const complex_ball begin = exact_point(std::polar(rho_, middle));
    const state at_middle = walked_from_start(begin, all);
    for (const int direction : {1, -1}) {
        state now = at_middle;
        complex_ball centre = begin;
        double angle = middle;
        for (int k = 0;; ++k) {
            const double width =
                add_piece(now, centre, direction > 0 ? middle : low, direction > 0 ? high : middle, all);
            if (direction > 0 ? angle + width >= high : angle - width <= low) {
                break;
            }
            if (k > most_pieces_of_circle) {
                throw precision_exhausted("the discs on a circle");
            }
            const double next =
                direction > 0 ? std::min(angle + 0.9 * width, high) : std::max(angle - 0.9 * width, low);
            const complex_ball to = exact_point(std::polar(rho_, next));
            now = moved(now, centre, to, all);
            centre = to;
            angle = next;
        }
    }
}

void linear_law::bound_circle() {
    mean_ = magnitude();
    if (places_.empty()) {
        const ball rho = exactly(rho_);
        const frobenius_series series = series_about_start({2 * rho_, rho_, bits_of_pieces, 0}, zeros());
        mean_ = magnitude(series.bound(rho, rho));
        return;
    }
    const std::vector<fixed_point_terms> tips = terms(terms_at_tips);
    for (const gap& each : gaps()) {
        add_gap(each, tips);
    }
    mean_ *= magnitude::at_least(1 / half_turn_of_circle * (1 + least_angle_of_slits), 0);
}

}  // namespace libration::ode
