// The largest |f| on an interval, proved: by subdivision of polynomials with bounded tails, not by samples.
//
// On a piece with the midpoint m and the half width h, f, f' and f'' are enclosed by Horner's rule on the ball m +- h, and
// |f| <= |f(m)| + h max|f'| there. A piece
//   1. whose |f| is below a value that |f| takes somewhere counts for nothing;
//   2. on which f' has no zero has its largest |f| at an end;
//   3. on which |f''| >= mu > 0 has, beside its ends, at most one stationary point x. For any s in the piece
//      |s - x| <= |f'(s)|/mu, and the extreme value of f lies between f(s) and f(s) -+ f'(s)^2/(2 mu): for f'' > 0,
//      f(y) >= f(s) + f'(s) (y - s) + mu/2 (y - s)^2, whose least value that is, and f(s) is not below the least;
//   4. is cut in two otherwise.
// In 3 the point s comes from Newton's iteration; nothing is taken on trust from it. The result is the hull of what may be
// the maximum. Where two far places share it to the working precision, the value is proved, and the place is not narrow.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "libration/scalar/ball.hpp"
#include "libration/series/arithmetic.hpp"

namespace libration {

/// Enclosures of a function and of its first two derivatives.
struct enclosed_two_jet {
    ball value;
    ball slope;
    ball curvature;
};

/// A function of s in [-1, 1], the part [from, to] of the caller's variable: a polynomial with a tail whose coefficients
/// obey |c_j| <= scale ratio^j for every j > J, the order of the polynomial.
class enclosed_panel {
public:
    /// Throws precision_exhausted where ratio < 1 is not certain.
    enclosed_panel(power_series<ball> kept, const ball& scale, const ball& ratio, rational from, rational to)
        : kept_(std::move(kept)), from_(std::move(from)), to_(std::move(to)) {
        require_below(ratio, ball(1), "the rate of a tail");
        // With n = J + 1: sum_{j>=n} q^j = q^n/(1-q), sum j q^j <= n q^n/(1-q)^2, sum j(j-1) q^j <= n(n-1) q^n/(1-q)^3,
        // because n + i <= n (1 + i) and (n+i)(n+i-1) <= n(n-1) (i+1)(i+2)/2 for n >= 2.
        const long n = std::max(2, kept_.order() + 1);
        const ball gap = 1 - ratio;
        tail_.value = scale * pow(ratio, kept_.order() + 1) / gap;
        tail_.slope = tail_.value * n / gap;
        tail_.curvature = tail_.slope * (n - 1) / gap;
    }

    int order() const { return kept_.order(); }

    /// On a ball of s, for those of its numbers that are in [-1, 1].
    enclosed_two_jet at(const ball& s) const {
        enclosed_two_jet sum{kept_[kept_.order()], ball(), ball()};
        for (int n = kept_.order() - 1; n >= 0; --n) {
            sum.curvature = sum.curvature * s + sum.slope * 2;
            sum.slope = sum.slope * s + sum.value;
            sum.value = sum.value * s + kept_[n];
        }
        return {enclose(sum.value, tail_.value), enclose(sum.slope, tail_.slope),
                enclose(sum.curvature, tail_.curvature)};
    }

    /// The caller's variable at s.
    ball place_of(const ball& s) const {
        return from_rational<ball>(rational((from_ + to_) / 2)) + s * from_rational<ball>(rational((to_ - from_) / 2));
    }

private:
    power_series<ball> kept_;
    rational from_;
    rational to_;
    enclosed_two_jet tail_;
};

/// An enclosure of the largest |f| and of where it is attained.
struct proved_maximum {
    ball value;
    ball place;
};

/// The search behind largest_magnitude().
class maximum_search {
public:
    explicit maximum_search(const std::vector<enclosed_panel>& panels) : panels_(panels) {}

    /// Throws precision_exhausted where the working precision does not part the pieces.
    proved_maximum result() {
        std::vector<piece> left;
        for (std::size_t i = 0; i < panels_.size(); ++i) {
            for (const int s : {-1, 0, 1}) {
                consider(panels_[i].at(ball(s)).value, panels_[i].place_of(ball(s)));
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

    // Whether nothing of the piece is left to be found.
    bool is_settled(const piece& p) {
        const enclosed_panel& f = panels_[p.panel];
        const ball half = ldexp(ball(1), -p.level);
        const ball all = enclose(p.centre, half);
        const enclosed_two_jet over = f.at(all);
        const ball reach = abs(f.at(p.centre).value) + abs(over.slope) * half;
        if (certainly_less(abs(over.value), lower_) || certainly_less(reach, lower_)) {
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

    // Takes an end into account; the sign of the slope there, 0 where it is not decided.
    int consider_end(const enclosed_panel& f, const ball& s) {
        const enclosed_two_jet at = f.at(s);
        consider(at.value, f.place_of(s));
        return contains_zero(at.slope) ? 0 : decided_sign(at.slope);
    }

    // The stationary point of a piece that bends by at least `least`; false where Newton's iteration did not come near it.
    bool is_found(const enclosed_panel& f, const ball& centre, const ball& all, const ball& least) {
        ball s = centre;
        for (int step = doublings(digits<ball>()) + 3; step > 0; --step) {
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
    ball lower_;  ///< |f| is not below this somewhere; exact
    std::vector<candidate> candidates_;
};

/// The largest |f| over all panels, as narrow as the working precision makes it. Cost: a few Horner evaluations of order
/// J for each halving next to a stationary point; their number follows the shape of f and hardly the precision. Throws
/// precision_exhausted where the working precision does not part the pieces, as where f is 0.
inline proved_maximum largest_magnitude(const std::vector<enclosed_panel>& panels) {
    return maximum_search(panels).result();
}

}  // namespace libration
