#include "libration/plane/radius_bound.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "disc_path.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

constexpr int loop_corners = 16;
// For a covering: the longest step relative to the radius, times 2^15, and the maximum number of steps to the centre of
// a cell.
constexpr unsigned long way_part = 26'214;  // 0.8 of 2^15
constexpr int most_way_discs = 12;

std::complex<double> rounded_place(const complex_ball& z) {
    return {arf_get_d(arb_midref(z.re.handle()), ARF_RND_NEAR), arf_get_d(arb_midref(z.im.handle()), ARF_RND_NEAR)};
}

// exp(2 pi i turn) for an exact fraction of a turn.
complex_ball unit_at(const ball& turn) {
    complex_ball result;
    const ball twice = ldexp(turn, 1);
    arb_sin_cos_pi(result.im.handle(), result.re.handle(), twice.handle(), ball::working_bits());
    return result;
}

constexpr const char* too_small_discs =
    "the discs become too small: a singularity is near, or the precision is insufficient";

// A polar cell r1 <= |z| <= r2, arguments 2 pi t1 .. 2 pi t2; all exact.
struct polar_cell {
    ball r1, r2, t1, t2;
};

class covering_search {
public:
    covering_search(const complex_flow& flow, ball rho, const plane_symmetry& symmetry, const covering_limits& limits)
        : flow_(flow), rho_(std::move(rho)), limits_(limits) {
        finest_ = magnitude(rho_) * magnitude::of(1, -limits.finest_bits);
        // Beyond the axis of symmetry, because the end must be exact.
        last_turn_ = ball(1) / ball(2 * symmetry.rotation) + ldexp(ball(1), -40L);
        last_turn_ = exact_midpoint(last_turn_);
    }

    covering result() {
        covering found;
        try {
            discs_.push_back(std::make_unique<complex_disc>(flow_));
            note(*discs_.back());
            const ball inner = exact_midpoint(ldexp(discs_.front()->radius().exact() * 3, -2));
            nearest_missing_ = inner;
            found.complete = !certainly_less(inner, rho_) || cover({inner, rho_, ball(0), last_turn_});
            found.covered = found.complete ? rho_ : nearest_missing_;
            found.reason = reason_;
        } catch (const precision_exhausted&) {
            found.reason = "the initial point has no proved radius with so many bits";
            found.covered = ball(0);
        }
        found.discs = std::move(made_);
        return found;
    }

private:
    // Depth first: paths go through the discs of the cells that contain this one.
    bool cover(const polar_cell& cell) {
        for (std::size_t i = discs_.size(); i-- > 0;) {
            if (holds(*discs_[i], cell, i == 0)) {
                return true;
            }
        }
        const auto centre = inner_middle(cell);
        if (!add_disc(centre)) {
            nearest_missing_ = cell.r1;
            return false;
        }
        const bool whole = holds(*discs_.back(), cell, false) || cover_parts(cell);
        discs_.pop_back();
        return whole;
    }

    bool cover_parts(const polar_cell& cell) {
        const ball length = cell.r2 - cell.r1;
        const ball width = (cell.t2 - cell.t1) * 6 * cell.r2;
        if (magnitude(length) < finest_ && magnitude(width) < finest_) {
            reason_ = "the discs become as small as the cells: a singularity is near";
            nearest_missing_ = cell.r1;
            return false;
        }
        const ball middle = exact_half(cell.r1, cell.r2);
        const ball turn = exact_half(cell.t1, cell.t2);
        if (certainly_less(ball(length * 2), width)) {
            return cover({cell.r1, cell.r2, cell.t1, turn}) && cover({cell.r1, cell.r2, turn, cell.t2});
        }
        if (certainly_less(ball(width * 2), length)) {
            return cover({cell.r1, middle, cell.t1, cell.t2}) && cover({middle, cell.r2, cell.t1, cell.t2});
        }
        return cover({cell.r1, middle, cell.t1, turn}) && cover({cell.r1, middle, turn, cell.t2}) &&
               cover({middle, cell.r2, cell.t1, turn}) && cover({middle, cell.r2, turn, cell.t2});
    }

    static ball exact_half(const ball& a, const ball& b) { return exact_midpoint(ldexp(a + b, -1L)); }

    // On the bisector, a little inside the inner arc, so that its modulus is not larger, whatever its rounding.
    static complex_ball inner_middle(const polar_cell& cell) {
        const ball inside = cell.r1 - ldexp(cell.r2 - cell.r1, -6L);
        const complex_ball way = unit_at(exact_half(cell.t1, cell.t2));
        return exact_midpoint(way * inside);
    }

    // Whether the four corners are in the open disc, and its centre is not farther from 0 than the cell.
    static bool holds(const complex_disc& disc, const polar_cell& cell, bool about_start) {
        const complex_ball& c = disc.about().offset;
        if (about_start) {
            return certainly_less(cell.r2, disc.radius().exact());
        }
        if (!certainly_less(ball(c.re * c.re + c.im * c.im), ball(cell.r1 * cell.r1))) {
            return false;
        }
        for (const ball* turn : {&cell.t1, &cell.t2}) {
            const complex_ball way = unit_at(*turn);
            for (const ball* r : {&cell.r2, &cell.r1}) {
                if (!certainly_within(way * *r - c, disc.radius())) {
                    return false;
                }
            }
        }
        return true;
    }

    // By steps from the disc that contains the centre best, among those whose centres are not farther from 0: the
    // moduli on a straight path are below that of its end.
    bool add_disc(const complex_ball& centre) {
        const complex_disc* best = nullptr;
        magnitude least = magnitude(static_cast<unsigned long>(most_way_discs));
        const ball farthest = centre.re * centre.re + centre.im * centre.im;
        for (const auto& each : discs_) {
            const complex_ball& c = each->about().offset;
            const magnitude part = size_of(exact_difference(centre, c)) / each->radius();
            const bool inside = certainly_less(ball(c.re * c.re + c.im * c.im), farthest);
            if (inside && part < least) {
                least = part;
                best = each.get();
            }
        }
        if (best == nullptr) {
            reason_ = too_small_discs;
            return false;
        }
        try {
            std::unique_ptr<complex_disc> way;
            for (int k = 0; k < most_way_discs; ++k) {
                if (static_cast<long>(made_.size()) >= limits_.most_discs) {
                    reason_ = "it takes more than " + std::to_string(limits_.most_discs) + " discs";
                    return false;
                }
                const complex_disc& from = way ? *way : *best;
                const complex_ball back = exact_difference(from.about().offset, centre);
                const magnitude longest = flow_.route().shortened(from.radius() * magnitude::of(way_part, -15));
                const bool last = size_of(back) <= longest;
                const ball part = last ? ball(1) : ball(longest.exact() / size_of(back).exact());
                // The step is rounded and its end is not: it is inside the disc, however small that is.
                const complex_ball next =
                    last ? centre : exact_difference(from.about().offset, exact_midpoint(back * part));
                if (!last && !certainly_less(ball(next.re * next.re + next.im * next.im), farthest)) {
                    throw precision_exhausted("the modulus of a corner");
                }
                auto made = std::make_unique<complex_disc>(flow_, from.moved_to(next));
                note(*made);
                if (last) {
                    discs_.push_back(std::move(made));
                    return true;
                }
                way = std::move(made);
            }
        } catch (const precision_exhausted&) {
            reason_ = "the precision is insufficient near a singularity";
            return false;
        }
        reason_ = too_small_discs;
        return false;
    }

    void note(const complex_disc& disc) {
        made_.push_back({rounded_place(disc.about().offset), mag_get_d(disc.radius().handle())});
    }

    const complex_flow& flow_;
    ball rho_;
    covering_limits limits_;
    magnitude finest_;
    ball last_turn_;
    std::vector<std::unique_ptr<complex_disc>> discs_;  // those of the cells that contain the current one
    std::vector<covering_disc> made_;
    ball nearest_missing_;
    std::string reason_;
};

}  // namespace

plane_symmetry symmetry_of(const explicit_system& system) { return {std::max(1, tape::about_start(system).stride())}; }

covering covered_disc(const complex_flow& flow, const ball& rho, const plane_symmetry& symmetry,
                      const covering_limits& limits) {
    const precision_scope scope(decimal_digits(flow.bits()));
    return covering_search(flow, rho, symmetry, limits).result();
}

loop_result loop_about(const complex_flow& flow, const std::vector<complex_ball>& corners, const complex_ball& centre,
                       const magnitude& reach, int most_power, const std::vector<std::size_t>& of) {
    const precision_scope scope(decimal_digits(flow.bits()));
    loop_result result;
    disc_path path(flow);
    const auto none = [](const complex_disc&, const complex_ball&) {};
    for (const complex_ball& each : corners) {
        path.go_to(each, none);
    }
    // The polygon begins on the side from which the path comes.
    const complex_ball from = path.now().about().offset;
    const complex_ball back = from - centre;
    const ball distance = sqrt(ball(back.re * back.re + back.im * back.im));
    const complex_ball first = exact_midpoint(back / distance * reach.exact());
    std::vector<complex_ball>& polygon = result.polygon;
    for (int k = 0; k <= loop_corners; ++k) {
        const complex_ball turned = first * unit_at(ball(k % loop_corners) / ball(loop_corners));
        polygon.push_back(exact_midpoint(centre + turned));
    }
    path.go_to(polygon.front(), none);
    result.reach = size_of(exact_difference(polygon.front(), centre));
    const std::vector<complex_ball> before = values_of(path.now().about());
    const std::size_t powers = static_cast<std::size_t>(most_power) + 1;
    std::vector<complex_ball> sums(of.size() * powers, complex_ball(0));
    for (std::size_t k = 1; k < polygon.size(); ++k) {
        path.go_to(polygon[k], [&](const complex_disc& disc, const complex_ball& to) {
            result.reach = std::max(result.reach, size_of(exact_difference(to, centre)));
            for (std::size_t i = 0; i < of.size(); ++i) {
                for (std::size_t power = 0; power < powers; ++power) {
                    complex_ball& sum = sums[i * powers + power];
                    sum = sum + disc.integral(of[i], to, centre, reach.exact(), static_cast<int>(power));
                }
            }
        });
    }
    result.farthest = path.farthest();
    result.discs = path.discs();
    const std::vector<complex_ball> after = values_of(path.now().about());
    for (std::size_t k = 0; k < of.size(); ++k) {
        for (std::size_t power = 0; power < powers; ++power) {
            if (certainly_not_zero(sums[k * powers + power])) {
                result.evidence = loop_evidence::integral;
                result.unknown = of[k];
                result.power = static_cast<int>(power);
                result.value = sums[k * powers + power];
                return result;
            }
        }
    }
    for (const std::size_t i : of) {
        const complex_ball change = after[i] - before[i];
        if (certainly_not_zero(change)) {
            result.evidence = loop_evidence::change;
            result.unknown = i;
            result.value = change;
            return result;
        }
    }
    return result;
}

}  // namespace libration::ode
