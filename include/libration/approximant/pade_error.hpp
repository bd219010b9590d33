// The largest |f| on an interval, rigorously: by subdivision of polynomials with bounded tails, not by sampling.
//
// On a piece with the midpoint m and the half width h, f, f' and f'' are enclosed by Horner's rule on the ball m +- h,
// and |f| <= |f(m)| + h max|f'| there. A piece
//   1. on which |f| is below a value that |f| attains elsewhere is discarded;
//   2. on which f' has no zero attains its largest |f| at an end;
//   3. on which |f''| >= mu > 0 has at most one stationary point x in addition to its ends. For any s in the piece
//      |s - x| <= |f'(s)|/mu, and the extreme value of f lies between f(s) and f(s) -+ f'(s)^2/(2 mu): for f'' > 0,
//      f(y) >= f(s) + f'(s) (y - s) + mu/2 (y - s)^2, whose minimum that is, and f(s) is not below the minimum;
//   4. is bisected otherwise.
// In 3 the point s comes from Newton's iteration; nothing is assumed about it. The result is the hull of all
// possible maxima. If two distant points share the maximum to the working precision, the value is proved, and
// the location is not narrow.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "libration/approximant/panel_enclosure.hpp"

namespace libration {

/// An enclosure of the largest |f| and of where it is attained.
struct proved_maximum {
    ball value;
    ball place;
};

/// The search behind largest_magnitude().
class maximum_search {
public:
    /// With this number of steps of Newton's iteration, at least 0; by default as many as reach full precision.
    explicit maximum_search(const std::vector<enclosed_panel>& panels, std::optional<int> steps = {})
        : panels_(panels), steps_(steps.value_or(doublings(digits<ball>()) + 3)) {
        const precision_scope few(rough_digits);
        rough_.reserve(panels.size());
        for (const enclosed_panel& panel : panels) {
            rough_.push_back(panel.rounded());
        }
    }

    /// Throws precision_exhausted if the working precision does not separate the pieces.
    proved_maximum result() {
        std::vector<piece> left;
        for (std::size_t i = 0; i < panels_.size(); ++i) {
            for (const int s : {-1, 0, 1}) {
                consider(panels_[i].value_at(ball(s)), panels_[i].place_of(ball(s)));
            }
            left.push_back({i, ball(0), 0});
        }
        for (long taken = 0; !left.empty(); ++taken) {
            if (taken == most_pieces) {
                throw precision_exhausted("a maximum");
            }
            const piece next = std::move(left.back());
            left.pop_back();
            if (!is_settled(next)) {
                const ball quarter = ldexp(ball(1), -next.level - 1);
                left.push_back({next.panel, next.centre - quarter, next.level + 1});
                left.push_back({next.panel, next.centre + quarter, next.level + 1});
            }
        }
        return gathered();
    }

private:
    static constexpr long most_pieces = 20'000;
    static constexpr long rough_digits = 19;      // of a ball that needs no allocated memory
    static constexpr long most_rough_level = 12;  // below this level, differences of neighbours would need more digits

    struct piece {
        std::size_t panel;
        ball centre;
        long level;  ///< half width 2^-level
    };
    struct candidate {
        ball magnitude;
        ball place;
    };

    void consider(const ball& value, const ball& place) {
        ball magnitude = abs(value);
        const ball lower = lower_bound(magnitude);
        if (certainly_less(lower_, lower)) {
            lower_ = lower;
        }
        if (!certainly_less(magnitude, lower_)) {
            candidates_.push_back({std::move(magnitude), place});
        }
    }

    // Whether the piece needs no further search.
    bool is_settled(const piece& p) {
        if (const auto roughly = is_settled_roughly(p)) {
            return *roughly;
        }
        const enclosed_panel& f = panels_[p.panel];
        const ball half = ldexp(ball(1), -p.level);
        const ball all = enclose(p.centre, half);
        const enclosed_two_jet over = f.at(all);
        if (is_below(f, over, p.centre, half)) {
            return true;
        }
        const bool bends = !contains_zero(over.curvature);
        if (contains_zero(over.slope) && !bends) {
            return false;
        }
        const ball left = p.centre - half;
        const ball right = p.centre + half;
        const int at_left = consider_end(f, left);
        const int at_right = consider_end(f, right);
        return !contains_zero(over.slope) || at_left * at_right > 0 ||
               is_found(f, p.centre, all, lower_bound(abs(over.curvature)));
    }

    // is_settled() by enclosures in few digits, which are equally rigorous; std::nullopt if they do not decide.
    std::optional<bool> is_settled_roughly(const piece& p) const {
        if (p.level > most_rough_level) {
            return std::nullopt;
        }
        const precision_scope few(rough_digits);
        const enclosed_panel& f = rough_[p.panel];
        const ball half = ldexp(ball(1), -p.level);
        const ball all = enclose(p.centre, half);
        if (certainly_less(abs(f.value_at(all)), lower_)) {
            return true;  // most pieces, at a third of the cost of the next line
        }
        const enclosed_two_jet over = f.at(all);
        if (is_below(f, over, p.centre, half)) {
            return true;
        }
        return contains_zero(over.slope) && contains_zero(over.curvature) ? std::optional(false) : std::nullopt;
    }

    // Whether |f| is everywhere below a value that it attains elsewhere.
    bool is_below(const enclosed_panel& f, const enclosed_two_jet& over, const ball& centre, const ball& half) const {
        if (certainly_less(abs(over.value), lower_)) {
            return true;
        }
        const ball reach = abs(f.value_at(centre)) + abs(over.slope) * half;
        return certainly_less(reach, lower_);
    }

    // Takes an end into account; returns the sign of the slope there, 0 if it is not decided.
    int consider_end(const enclosed_panel& f, const ball& s) {
        const series::jet<ball> at = f.jet_at(s);
        consider(at.value, f.place_of(s));
        return contains_zero(at.slope) ? 0 : decided_sign(at.slope);
    }

    // The stationary point of a piece with |f''| at least `least`; false if Newton's iteration did not come close to
    // it.
    bool is_found(const enclosed_panel& f, const ball& centre, const ball& all, const ball& least) {
        ball s = centre;
        for (int step = steps_; step > 0; --step) {
            const enclosed_two_jet at = f.at(s);
            const ball next = midpoint(ball(s - at.slope / at.curvature));
            if (!contains(all, next)) {
                return false;
            }
            s = next;
        }
        const enclosed_two_jet at = f.at(s);
        const ball error = at.slope * at.slope / (least * 2);
        if (!certainly_less(ldexp(error, digits<ball>() / 2), lower_)) {
            return false;
        }
        consider(enclose(at.value, error), f.place_of(enclose(s, ball(at.slope / least))));
        return true;
    }

    proved_maximum gathered() const {
        proved_maximum all{lower_, ball()};
        bool first = true;
        for (const candidate& c : candidates_) {
            if (!certainly_less(c.magnitude, lower_)) {
                all.value = hull(all.value, upper_bound(c.magnitude));
                all.place = first ? c.place : hull(all.place, c.place);
                first = false;
            }
        }
        return all;
    }

    const std::vector<enclosed_panel>& panels_;
    std::vector<enclosed_panel> rough_;  ///< in few digits
    int steps_;
    ball lower_;  ///< |f| attains at least this value somewhere; exact
    std::vector<candidate> candidates_;
};

/// The largest |f| over all panels, as narrow as the working precision allows. Cost: a few Horner evaluations of order
/// J per bisection near a stationary point, most of them in 19 digits; their number depends on the shape of f and
/// hardly on the precision. If `steps` is given, Newton's iteration stops after that many steps: pieces are then
/// bisected until they suffice.
/// Throws precision_exhausted if the working precision does not separate the pieces, for example if f is 0.
inline proved_maximum largest_magnitude(const std::vector<enclosed_panel>& panels, std::optional<int> steps = {}) {
    return maximum_search(panels, steps).result();
}

}  // namespace libration
