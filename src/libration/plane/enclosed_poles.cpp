#include "libration/plane/enclosed_poles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr double box_margin = 1e-9;
// Half sides of the boxes that are tried, relative to rho.
constexpr std::array box_sides{0.05, 0.02, 0.005, 1e-3, 1e-4};
constexpr int most_zero_corrections = 50;
constexpr int deepest_pole_cell = 22;
constexpr int first_newton_depth = 3;
constexpr int most_climb_steps = 400;
constexpr double climb_part = 0.45;

bool excludes_zero(const complex_ball& z) { return !contains_zero(z.re) || !contains_zero(z.im); }

complex_ball box_about(std::complex<double> centre, double half_side) {
    const complex_ball middle = exact_point(centre);
    const magnitude by = magnitude::at_least(half_side, 0);
    return {widened(middle.re, by), widened(middle.im, by)};
}

// Whether every number of the ball is inside the box.
bool box_contains(const complex_ball& box, const complex_ball& z) {
    return contains(box.re, z.re) && contains(box.im, z.im);
}

bool boxes_meet(const complex_ball& a, const complex_ball& b) { return overlaps(a.re, b.re) && overlaps(a.im, b.im); }

// A zero of the polynomial of one coordinate, by Newton's method in double, from a place in the disc.
std::optional<std::complex<double>> zero_near(const series_disc& disc, double radius, std::size_t coordinate,
                                              std::complex<double> from) {
    std::vector<std::complex<double>> a;
    for (const complex_ball& each : disc.coefficients(coordinate)) {
        a.push_back(rounded_midpoint(each));
    }
    const std::complex<double> centre = rounded_midpoint(disc.centre());
    std::complex<double> z = from - centre;
    for (int k = 0; k < most_zero_corrections; ++k) {
        std::complex<double> value = 0;
        std::complex<double> slope = 0;
        for (std::size_t n = a.size(); n-- > 0;) {
            slope = slope * z + value;
            value = value * z + a[n];
        }
        const std::complex<double> step = value / slope;
        if (!std::isfinite(step.real()) || !std::isfinite(step.imag()) || std::abs(z) > radius) {
            return std::nullopt;
        }
        z -= step;
        if (std::abs(step) < 1e-14 * radius) {
            return centre + z;
        }
    }
    return std::nullopt;
}

class pole_search {
public:
    pole_search(const chart_atlas& atlas, const charted_covering& covering, double rho)
        : atlas_(atlas), covering_(covering), rho_(rho) {}

    std::vector<pole_box> found() {
        for (const covered_cell& each : covering_.cells()) {
            if (!each.in_tip && covering_.pieces()[each.holder].chart == 1) {
                decide(each.cell, each.holder, 0);
            }
        }
        return boxes_;
    }

private:
    void decide(const plane_cell& cell, std::size_t piece, int depth) {
        if (is_in_box(cell)) {
            return;
        }
        try {
            if (excludes_zero(covering_.pieces()[piece].disc.over(cell.enclosure())[0])) {
                return;
            }
        } catch (const precision_exhausted&) {
            // the enclosure of the cell leaves the disc
        }
        if (depth >= first_newton_depth && add_box(cell, piece) && is_in_box(cell)) {
            return;
        }
        if (depth > deepest_pole_cell) {
            const std::complex<double> place = cell.corners().front();
            throw error(error_kind::undecided, error_subject::problem, "",
                        "is not proved to have, or to have no, pole near " + std::to_string(place.real()) + " + " +
                            std::to_string(place.imag()) + "i");
        }
        for (const plane_cell& each : cell.halves()) {
            decide(each, piece, depth + 1);
        }
    }

    bool is_in_box(const plane_cell& cell) const {
        const double sagitta = cell.r2 * (1 - std::cos((cell.a2 - cell.a1) / 2));
        return std::ranges::any_of(boxes_, [&](const pole_box& box) {
            return std::ranges::all_of(cell.corners(), [&](std::complex<double> z) { return box.holds(z, sagitta); });
        });
    }

    bool add_box(const plane_cell& cell, std::size_t piece) {
        const covering_piece& in = covering_.pieces()[piece];
        const std::size_t q = atlas_.regular().simple_zero();
        auto place = zero_near(in.disc, in.radius, q, std::polar((cell.r1 + cell.r2) / 2, (cell.a1 + cell.a2) / 2));
        if (!place) {
            return false;
        }
        for (const double side : box_sides) {
            const double half = side * rho_;
            const bool real = std::abs(place->imag()) <= half * (1 + box_margin);
            const std::complex<double> centre = real ? place->real() : *place;
            if (!real && centre.imag() < 0) {  // the mirror image of one above the real axis
                continue;
            }
            if (auto box = isolated(piece, centre, half, real)) {
                keep(std::move(*box));
                return true;
            }
        }
        return false;
    }

    // Interval Newton in a box.
    std::optional<pole_box> isolated(std::size_t piece, std::complex<double> centre, double half, bool real) const {
        const series_disc& disc = covering_.pieces()[piece].disc;
        const std::size_t q = atlas_.regular().simple_zero();
        const complex_ball box = box_about(centre, half);
        try {
            const auto over = disc.over(box);
            const complex_ball time = atlas_.time(box);
            const complex_ball slope = atlas_.regular().slopes(time, over)[q];
            if (!excludes_zero(slope)) {
                return std::nullopt;
            }
            const complex_ball middle = exact_point(centre);
            const complex_ball next = middle - disc.at(middle)[q] / slope;
            const bool is_zero_of_v =
                atlas_.regular().order() == 1 || excludes_zero(atlas_.regular().factor(time, over));
            if (!box_contains(box, next) || !is_zero_of_v) {
                return std::nullopt;
            }
            return pole_box{centre, half, piece, next, real};
        } catch (const precision_exhausted&) {
            return std::nullopt;
        }
    }

    // The same pole in another disc lies in the box that is there; boxes that only meet are not decided.
    void keep(pole_box box) {
        for (const pole_box& each : boxes_) {
            const complex_ball other = box_about(each.centre, each.half_side);
            if (box_contains(other, box.place)) {
                return;
            }
            if (boxes_meet(other, box.place) || (boxes_meet(box_about(box.centre, box.half_side), each.place))) {
                throw error(error_kind::undecided, error_subject::problem, "",
                            "has poles near " + std::to_string(box.centre.real()) + " + " +
                                std::to_string(box.centre.imag()) + "i whose boxes are not separated");
            }
        }
        boxes_.push_back(std::move(box));
    }

    const chart_atlas& atlas_;
    const charted_covering& covering_;
    double rho_;
    std::vector<pole_box> boxes_;
};

// The disc in chart 1 in whose inner part the pole lies, at the end of the straight line to it.
series_disc climbed(const explicit_system& system, const chart_atlas& atlas, std::complex<double> goal, int order) {
    std::size_t chart = 0;
    complex_ball here(0);
    std::vector<complex_ball> state = carried_start(system, atlas.chart(0));
    for (int k = 0; k < most_climb_steps; ++k) {
        const std::size_t next = atlas.chosen(chart, state);
        state = atlas.converted(chart, next, here, state);
        chart = next;
        series_disc disc(atlas.chart(chart), here, state, order);
        const std::complex<double> rest = goal - rounded_midpoint(here);
        const double radius = mag_get_d(disc.radius().handle());
        if (chart == 1 && std::abs(rest) < climb_part * radius) {
            return disc;
        }
        const double part = std::min(1.0, climb_part * radius / std::abs(rest));
        // In chart 0 the pole itself is not inside the disc.
        here = exact_point(rounded_midpoint(here) + rest * (part == 1 ? 0.7 : part));
        state = disc.at(here);
    }
    throw precision_exhausted("a path to a pole");
}

}  // namespace

bool pole_box::holds(std::complex<double> z, double margin) const {
    const std::complex<double> from = z - centre;
    return std::max(std::abs(from.real()), std::abs(from.imag())) + margin < half_side * (1 - box_margin);
}

bool pole_box::contains(const complex_ball& z) const { return box_contains(box_about(centre, half_side), z); }

std::vector<pole_box> enclosed_poles(const chart_atlas& atlas, const charted_covering& covering, double rho) {
    return atlas.has_poles() ? pole_search(atlas, covering, rho).found() : std::vector<pole_box>{};
}

pole_terms terms_of_pole(const explicit_system& system, const chart_atlas& atlas, const pole_box& box) {
    const regular_coordinates& regular = atlas.regular();
    const long bits = ball::working_bits();
    const std::size_t q = regular.simple_zero();
    const int order = static_cast<int>(bits) + 20;
    const std::complex<double> goal =
        box.real ? std::complex<double>(rounded_midpoint(box.place).real()) : rounded_midpoint(box.place);
    const series_disc last = climbed(system, atlas, goal, order);
    complex_ball place = exact_point(goal);
    for (long known = 40; known < 2 * bits; known *= 2) {  // Newton, at the midpoint, with the slope there
        const auto state = last.at(place);
        place = exact_midpoint(place - state[q] / regular.slopes(atlas.time(place), state)[q]);
        if (box.real) {
            place.im = ball(0);
        }
    }
    // Interval Newton: the correction from the midpoint by the slopes over a box.
    std::optional<complex_ball> proved;
    for (long less = 10; less < bits && !proved; less += 12) {
        const magnitude half = size_of(place) * magnitude::of(1, less - bits);
        const complex_ball around{widened(place.re, half), widened(place.im, half)};
        const complex_ball slope = regular.slopes(atlas.time(around), last.at(around))[q];
        const complex_ball next = place - last.at(place)[q] / slope;
        if (box_contains(around, next)) {
            proved = next;
        }
    }
    if (!proved) {
        throw precision_exhausted("the place of a pole");
    }
    if (box.real) {
        proved->im = ball(0);
    }
    if (!box.contains(*proved)) {
        throw precision_exhausted("the pole in a box");
    }
    auto state = last.at(*proved);
    state[0] = complex_ball(0);
    if (regular.order() == 2) {
        state[1] = complex_ball(0);
    }
    constexpr int terms = 8;
    taylor_expansion<complex_ball> expansion(atlas.chart(1).points(), terms);
    const auto all = lifted_values(atlas.chart(1).form().lifted, atlas.time(*proved), state);
    solution_state<complex_ball> start;
    for (const complex_ball& each : all) {
        start.push_back({each});
    }
    expansion.about(atlas.time(*proved), start);
    const complex_ball* const v = expansion.coefficients(0);
    pole_terms result{*proved, {}, box.real};
    // 1/v = tau^-o u, u = 1/(v_o + v_(o+1) tau + ..); c_j is the coefficient of tau^(o-j) in u.
    const int o = regular.order();
    std::vector<complex_ball> u{complex_ball(1) / v[o]};
    for (int k = 1; k < o; ++k) {
        complex_ball sum(0);
        for (int j = 1; j <= k; ++j) {
            sum = sum + v[o + j] * u[static_cast<std::size_t>(k - j)];
        }
        u.push_back(-sum * u[0]);
    }
    for (int j = 1; j <= o; ++j) {
        result.principal.push_back(u[static_cast<std::size_t>(o - j)]);
    }
    if (box.real) {
        for (complex_ball& each : result.principal) {
            each.im = ball(0);
        }
    }
    return result;
}

}  // namespace libration::ode
