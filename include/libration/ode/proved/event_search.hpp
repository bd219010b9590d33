// Where a function of the solution is 0, enclosed: theorem E.
#pragma once

#include <optional>
#include <vector>

#include "libration/ode/ball/start_sign.hpp"
#include "libration/ode/ball/step_pieces.hpp"
#include "libration/ode/first_order_form.hpp"
#include "libration/ode/proved/proved_march.hpp"

namespace libration::ode {

/// How a function passes 0 as t increases, in whichever direction it is searched.
enum class crossing { any, up, down };

/// A zero of g, alone in its enclosure, and the unknowns there. `way` is `any` where g touches 0 at the start.
struct proved_event {
    ball time;
    std::vector<ball> state;
    crossing way = crossing::any;
};

/// Why a search returns no event.
enum class search_end {
    none,
    time,       ///< there is none up to the given end, and the next zero is certainly beyond it
    horizon,    ///< there is none within so many steps of the integrator, up to march().reached()
    precision,  ///< an enclosure is too wide: with more bits it goes on
    steps,      ///< the steps of the integrator become too small, as they do near a singularity
    undecided   ///< undecided() is a place where these bits do not show whether g has a zero
};

/// Times between which g is not told from 0, with |g| <= value and |g'| <= slope there.
struct undecided_place {
    ball from, to;
    magnitude value, slope;
    /// Whether it was left because the step has been cut into most_pieces_of_a_step pieces: more bits are of no use then.
    bool too_many_pieces = false;
};

/// The zeros of gamma(t) = g(t, y(t)) in the open interval behind the start, in their order, none left out: theorem E.
///
/// Pieces S of a step are taken in order. Let m be in S, gamma(S) and gamma'(S) = Dg(y) f(y) enclosed on the enclosure
/// of y.
///   - gamma(S) or gamma(m) + gamma'(S) (S - m) excludes 0: no zero in S.
///   - gamma'(S) or gamma'(m) + gamma''(S) (S - m) excludes 0: gamma is monotone on S. Where it moves away from 0 from an end with a known sign there is
///     no zero; else the sign at the other end decides. Where that is not decided the piece stays open, and the pieces
///     behind it, monotone in the same direction, are joined to it until a sign is certain: opposite signs at both ends
///     are exactly one zero, the same sign is none. It lies in m - gamma(m)/gamma'(S) of one of the joined pieces.
///   - gamma''(S) excludes 0: gamma turns once at most on S. The place is enclosed by Newton's method for gamma', and
///     gamma is monotone before and behind it, where the signs of gamma' at its ends show it.
///   - else S is halved, at 0 and over several orders of magnitude by exponents, so that no scale is preferred. Where
///     the radius of gamma(m) is as large as what gamma varies by on S, halving is of no use: `undecided`.
/// The signs of joined pieces are those of points behind the start: the sign directly behind it is exact
/// (start_sign.hpp). Where gamma is 0 at the start with k derivatives that vanish, gamma^(k) excludes 0 on the first
/// piece, so that gamma(t) = gamma^(k)(x) (t - t0)^k/k! does on it without the start.
class event_search {
public:
    /// g in unknowns, their lower derivatives and the variable of the system. A march from the start of the system in
    /// so many bits, in the direction of time (< 0: backwards); `watch` is called after each step. Throws error as
    /// sign_at_start, and for a singular start where g has a zero within the first step, or backwards.
    event_search(const explicit_system& system, const expression& g, long bits, int direction = 1,
                 const proof_route& route = {}, march_watch watch = {});

    /// Pieces of one step after which a search gives up.
    static constexpr long most_pieces_of_a_step = 4'000;
    /// Steps without an event after which a search without an end gives up.
    static constexpr long usual_horizon = 5'000;

    /// The start as an event: where g is exactly 0 there.
    std::optional<proved_event> at_start() const;
    /// The next zero that is passed this way and is not certainly beyond `end`; std::nullopt for the reason end(). The
    /// horizon holds without an end, or where one is given; a search that ended by it goes on when called again.
    std::optional<proved_event> next(crossing way, const std::optional<number>& end,
                                     const std::optional<long>& horizon = std::nullopt);

    const proved_march& march() const { return march_; }
    search_end end() const { return end_; }
    const undecided_place& undecided() const { return *undecided_; }

private:
    struct sample {
        ball value;
        ball slope;
        std::vector<ball> state;
    };
    enum class finding { no_zero, monotone, open, undecided };
    struct verdict {
        finding kind;
        int sign;  // of g, or of its slope
    };

    void require_no_event_before_first_step(const ball& start);
    // Rounded outwards, where the bounds of a step hold too: they are those of the distance itself.
    ball span_of(const step_piece& p) const { return hull(p.from, p.to) * direction_; }
    sample sampled(const ball& distance) const;
    const expression& curvature();
    expression_values<ball> values_at(const ball& distance) const;
    ball of_state(const expression& e, const ball& distance) const { return values_at(distance).of(e); }
    int sign_at(const ball& distance) const;
    bool is_start(const step_piece& p) const { return start_.order > 0 && march_.steps() == 0 && p.at_0(); }
    bool begin_step(const std::optional<ball>& end, long last_step);
    verdict judged(step_piece& p);
    verdict judged_at_start(const step_piece& p);
    verdict undecided_on(const ball& span, const sample& all);
    std::optional<proved_event> examined(step_piece p);
    std::optional<proved_event> with_sign(int sign);
    std::optional<proved_event> passed(const step_piece& p, int slope);
    std::optional<proved_event> joined();
    void add_part(step_piece p);
    bool narrowed_by_signs(step_piece& p) const;
    void split(const step_piece& p);
    bool split_at_turn(const step_piece& p);

    first_order_form form_;
    expression g_, slope_;
    std::optional<expression> curvature_;  // made when it is needed
    proved_march march_;
    long digits_;
    int direction_;
    march_watch watch_;
    start_sign start_;
    int sign_ = 1;                     // of g where it was certain for the last time
    bool open_ = false;                // since then g was monotone towards 0
    std::vector<proved_event> parts_;  // and where on these pieces its zero can be
    std::vector<step_piece> pieces_;   // of the present step, the next one last
    long examined_ = 0;                // those that were halved
    bool examining_ = false;           // the present step is ready
    search_end end_ = search_end::none;
    std::optional<undecided_place> undecided_;
};

}  // namespace libration::ode
