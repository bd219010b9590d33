#include "libration/plane/charted_covering.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <queue>
#include <utility>

#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "place_words.hpp"

namespace libration::ode {

namespace {

// Relative to the radius of a disc: far above the rounding errors of the doubles, at most 1e-15 rho.
constexpr double covering_margin = 1e-9;
constexpr double least_radius = 1e-5;
constexpr double angle_margin = 1e-9;
constexpr double widest_sector = 1.6;
// The longest step of a chain relative to the radius, and the least one for which a piece is made.
constexpr double longest_step = 0.45;
constexpr double least_step = 0.12;
constexpr double inner_part = 0.8;
constexpr int deepest_cell = 40;

std::size_t parts_for(double length, double longest) {
    return static_cast<std::size_t>(std::max(1.0, std::ceil(length / longest)));
}

struct queued_cell {
    plane_cell cell;
    int depth = 0;

    friend bool operator>(const queued_cell& a, const queued_cell& b) { return a.cell.r1 > b.cell.r1; }
};

}  // namespace

std::vector<std::complex<double>> plane_cell::corners() const {
    return {std::polar(r1, a1), std::polar(r1, a2), std::polar(r2, a1), std::polar(r2, a2)};
}

// The farthest points of a cell from the middle of its angles at its mean modulus are corners, or the middle of the outer
// arc.
complex_ball plane_cell::enclosure() const {
    const std::complex<double> middle = std::polar((r1 + r2) / 2, (a1 + a2) / 2);
    double width = r2 - std::abs(middle);
    for (const auto& each : corners()) {
        width = std::max(width, std::abs(each - middle));
    }
    width = width * (1 + covering_margin) + r2 * 1e-14;
    complex_ball result = exact_point(middle);
    const magnitude by = magnitude::at_least(width, 0);
    return {widened(result.re, by), widened(result.im, by)};
}

std::vector<plane_cell> plane_cell::halves() const {
    const double middle = (r1 + r2) / 2;
    const double angle = (a1 + a2) / 2;
    if (r2 - r1 > r2 * (a2 - a1)) {
        return {{r1, middle, a1, a2}, {middle, r2, a1, a2}};
    }
    return {{r1, r2, a1, angle}, {r1, r2, angle, a2}};
}

std::vector<plane_sector> upper_sectors(const std::vector<covering_tip>& tips) {
    constexpr double half_turn = std::numbers::pi;
    struct ray {
        double angle;
        std::vector<std::size_t> tips;
    };
    std::vector<ray> rays{{0, {}}, {half_turn, {}}};
    for (std::size_t k = 0; k < tips.size(); ++k) {
        const double angle = std::arg(tips[k].place);
        const auto same =
            std::ranges::find_if(rays, [&](const ray& each) { return std::abs(each.angle - angle) < angle_margin; });
        if (same != rays.end() && same->tips.empty() && tips[k].place.imag() == 0) {
            same->tips.push_back(k);
        } else if (same != rays.end()) {
            throw error(error_kind::undecided, error_subject::problem, "",
                        "has two branch points on one ray from its initial point, or close to one ray");
        } else {
            rays.push_back({angle, {k}});
        }
    }
    std::ranges::sort(rays, {}, &ray::angle);
    std::vector<plane_sector> sectors;
    for (std::size_t i = 0; i + 1 < rays.size(); ++i) {
        const double from = rays[i].angle;
        const double to = rays[i + 1].angle;
        const std::size_t parts = parts_for(to - from, widest_sector);
        for (std::size_t k = 0; k < parts; ++k) {
            const auto at = [&](std::size_t j) {
                return j == parts ? to : from + (to - from) * static_cast<double>(j) / static_cast<double>(parts);
            };
            plane_sector sector{at(k), at(k + 1), {}};
            for (const ray* each : {&rays[i], &rays[i + 1]}) {
                const double farthest =
                    std::max(std::abs(sector.from - each->angle), std::abs(sector.to - each->angle));
                if (farthest < half_turn - angle_margin) {
                    sector.tips.insert(sector.tips.end(), each->tips.begin(), each->tips.end());
                }
            }
            sectors.push_back(std::move(sector));
        }
    }
    return sectors;
}

charted_covering::charted_covering(const explicit_system& system, const chart_atlas& atlas,
                                   const covering_request& asked)
    : atlas_(atlas), asked_(asked) {
    const precision_scope scope(decimal_digits(asked.bits));
    add_piece(0, 0, carried_start(system, atlas.chart(0)), 0);
    for (const plane_sector& each : upper_sectors(asked.tips)) {
        cover(each);
    }
}

void charted_covering::refuse_at(std::complex<double> place, const std::string& why) const {
    throw error(error_kind::undecided, error_subject::problem, "",
                "has a covering of |t - t0| <= " + std::to_string(asked_.rho) + " that does not close near " +
                    words_of_place(place) + ": " + why);
}

void charted_covering::add_piece(std::size_t chart, std::complex<double> centre, const std::vector<complex_ball>& state,
                                 double base) {
    if (pieces_.size() >= asked_.most_pieces) {
        refuse_at(centre, "it takes more than " + std::to_string(asked_.most_pieces) + " discs");
    }
    if (asked_.watch) {
        asked_.watch(plane_step::disc);
    }
    covering_piece piece{series_disc(atlas_.chart(chart), exact_point(centre), state, asked_.order), chart, centre, 0,
                         std::max(std::abs(centre), base)};
    arf_t radius;
    arf_init(radius);
    arf_set_mag(radius, piece.disc.radius().handle());
    piece.radius = arf_get_d(radius, ARF_RND_DOWN);
    arf_clear(radius);
    if (!(piece.radius > least_radius * asked_.rho)) {
        refuse_at(centre,
                  "the discs become too small there, near a singularity of a kind without a chart, or where the "
                  "solution grows fast");
    }
    pieces_.push_back(std::move(piece));
}

bool charted_covering::is_held(const plane_cell& cell, const plane_sector& sector,
                               const std::vector<std::size_t>& own) {
    const auto corners = cell.corners();
    const auto all_within = [&](std::complex<double> place, double radius) {
        return std::ranges::all_of(
            corners, [&](std::complex<double> z) { return std::abs(z - place) < radius * (1 - covering_margin); });
    };
    const double r1 = cell.r1 * (1 - covering_margin / 1000);
    for (const std::size_t k : sector.tips) {
        const covering_tip& tip = asked_.tips[k];
        if (tip.base < r1 && all_within(tip.place, tip.radius)) {
            cells_.push_back({cell, k, true});
            return true;
        }
    }
    // The arguments of the cell are within a sector, so within a half turn of that of the centre, where the distance from it
    // increases with the difference.
    for (std::size_t i = own.size(); i-- > 0;) {
        const covering_piece& piece = pieces_[own[i]];
        if (piece.base < r1 && all_within(piece.centre, piece.radius)) {
            cells_.push_back({cell, own[i], false});
            return true;
        }
    }
    return false;
}

// Of the pieces with a base of at most |c| the one in which c has the smallest relative distance; the number of pieces if c is
// in none.
std::size_t charted_covering::nearest(std::complex<double> c, const std::vector<std::size_t>& own) const {
    std::size_t best = pieces_.size();
    double least = 0.97;
    for (const std::size_t each : own) {
        const covering_piece& piece = pieces_[each];
        const double part = std::abs(c - piece.centre) / piece.radius;
        if (piece.base <= std::abs(c) && part < least) {
            least = part;
            best = each;
        }
    }
    return best;
}

std::size_t charted_covering::reach(std::size_t from, std::complex<double> c, std::vector<std::size_t>& own) {
    for (std::size_t now = from;;) {
        const std::complex<double> rest = c - pieces_[now].centre;
        const double part = std::abs(rest) / pieces_[now].radius;
        const bool last = part <= longest_step;
        const std::complex<double> next = last ? c : pieces_[now].centre + rest * (inner_part * longest_step / part);
        const complex_ball offset = exact_point(next);
        const std::vector<complex_ball> state = pieces_[now].disc.at(offset);
        const std::size_t chart = atlas_.chosen(pieces_[now].chart, state);
        const double base = pieces_[now].base;
        add_piece(chart, next, atlas_.converted(pieces_[now].chart, chart, offset, state), base);
        now = pieces_.size() - 1;
        own.push_back(now);
        if (last) {
            return now;
        }
    }
}

void charted_covering::cover(const plane_sector& sector) {
    std::vector<std::size_t> own{0};
    std::priority_queue<queued_cell, std::vector<queued_cell>, std::greater<>> queue;
    const double inner = std::min(inner_part * pieces_[0].radius, asked_.rho / 2);
    const std::size_t parts = parts_for(sector.to - sector.from, 0.6);
    for (std::size_t k = 0; k < parts; ++k) {
        const auto at = [&](std::size_t j) {
            return j == parts
                       ? sector.to
                       : sector.from + (sector.to - sector.from) * static_cast<double>(j) / static_cast<double>(parts);
        };
        queue.push({{inner, asked_.rho, at(k), at(k + 1)}, 0});
    }
    while (!queue.empty()) {
        const auto [cell, depth] = queue.top();
        queue.pop();
        if (is_held(cell, sector, own)) {
            continue;
        }
        const std::complex<double> c = std::polar(cell.r1 * (1 - covering_margin), (cell.a1 + cell.a2) / 2);
        if (depth > deepest_cell) {
            refuse_at(c, "a singularity of a kind without a chart may be there");
        }
        const std::size_t from = nearest(c, own);
        if (from < pieces_.size()) {
            const covering_piece& piece = pieces_[from];
            double size = 0;
            for (const auto& each : cell.corners()) {
                size = std::max(size, std::abs(each - c));
            }
            if (std::abs(c - piece.centre) > least_step * piece.radius && size < 4 * piece.radius) {
                try {
                    reach(from, c, own);
                } catch (const precision_exhausted&) {
                    refuse_at(c, "the precision of " + std::to_string(asked_.bits) + " bits is exhausted there");
                }
                if (is_held(cell, sector, own)) {
                    continue;
                }
            }
        }
        const double length = cell.r2 - cell.r1;
        const double width = cell.r2 * (cell.a2 - cell.a1);
        if (length > 1.5 * width || length * 1.5 < width) {
            for (const plane_cell& each : cell.halves()) {
                queue.push({each, depth + 1});
            }
        } else {
            for (const plane_cell& half : cell.halves()) {
                for (const plane_cell& each : half.halves()) {
                    queue.push({each, depth + 1});
                }
            }
        }
    }
}

}  // namespace libration::ode
