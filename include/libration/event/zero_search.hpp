// Enclosures of the zeros of a function of the solution: theorem E.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "libration/equation/first_order_form.hpp"
#include "libration/expansion/start_sign.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/integration/integration.hpp"
#include "libration/integration/kept_integrations.hpp"

namespace libration::ode {

/// A zero of g, isolated in its enclosure, and the unknowns there. `way` is the direction as t increases, independent of
/// that of the search; `any` if g touches 0 without a change of its sign.
struct proved_event {
    ball time;
    std::vector<ball> state;
    crossing way = crossing::any;
    ball_matrix flow = {};               ///< the derivative of the flow up to that time, if it is kept
    std::optional<number> exactly = {};  ///< the time of a zero of higher order (exact_zero_near)
};

/// The reason why a search returns no event.
enum class search_end {
    none,
    time,       ///< no event up to the given end; the next zero is certainly beyond it
    horizon,    ///< no event within so many steps of the integrator, up to reached()
    precision,  ///< an enclosure is too wide: more bits are needed to continue
    steps,      ///< the steps of the integrator become too small, as near a singularity
    undecided   ///< in undecided() this precision does not determine whether g has a zero
};

struct exact_zero;

/// An interval of times in which g is not distinguished from 0, with |g| <= value and |g'| <= slope there.
struct undecided_place {
    ball from, to;
    magnitude value, slope;
    /// Whether the search stopped because the step was cut into most_pieces_of_a_step pieces: then more bits do not
    /// help.
    bool too_many_pieces = false;
};

/// The beginning of a search along the steps from a set of states at the point of the system.
struct search_start {
    /// A ball that contains the time after which zeros are searched, and no time before the point; the point itself if
    /// there is none. The solutions are continued back from that time to the point by the equations.
    std::optional<ball> begins = {};
    int sign = 1;   ///< of g directly after that time
    int order = 0;  ///< of the first nonzero derivative of g at that time, which has this sign
};

/// The beginning of a search from all states of a set, directly after the point of the system.
struct set_start {
    state_set states;
    int sign = 1;                  ///< of g at the point, or of its derivative if g is 0 for all of them
    bool at_zero = false;          ///< whether it is
    bool keeps_derivative = true;  ///< by the states
};

/// All zeros of gamma(t) = g(t, y(t)) in the open interval after the initial point, in order: theorem E.
///
/// Pieces S of a step are processed in order. Let m be in S, gamma(S) and gamma'(S) = Dg(y) f(y) enclosed on the
/// enclosure of y.
///   - gamma(S) or gamma(m) + gamma'(S) (S - m) excludes 0: no zero in S.
///   - gamma'(S) or gamma'(m) + gamma''(S) (S - m) excludes 0: gamma is monotone on S. If it moves away from 0 from an
///     end with a known sign there is no zero; otherwise the sign at the other end decides. If that is unknown the
///     piece remains open, and the pieces after it, monotone in the same direction, are joined to it until a sign is
///     certain: opposite signs at both ends mean exactly one zero, equal signs none. It lies in m - gamma(m)/gamma'(S)
///     of one of the joined pieces.
///   - gamma''(S) excludes 0: gamma turns at most once on S. The point is enclosed by Newton's method for gamma', and
///     gamma is monotone before and after it, if the signs of gamma' at its ends prove it.
/// On a step of theorem K gamma'(S) is enclosed by g_t(y) + sum_i g_(y_i)(y) y_i', y_i' from step::slopes, as
/// large terms of f cancel along a stiff solution; gamma'' is not used there.
///   - A function of t alone that is not decided on S may have a zero of higher order there at an exact number
///     (exact_zero_near): of even order it touches 0, which is found if crossings in both directions are searched.
///   - otherwise S is halved, at 0 and over several orders of magnitude by exponents, so that no scale is favoured. If
///     the radius of gamma(m) is as large as the variation of gamma on S, halving is useless: `undecided`.
/// The signs of joined pieces are those of points after the initial point: the sign directly after it is exact
/// (start_sign.hpp). If gamma and its first k - 1 derivatives vanish at the initial point, gamma^(k) excludes 0 on the
/// first piece, so that gamma(t) = gamma^(k)(x) (t - t0)^k/k! is nonzero on it except at the initial point.
class zero_search {
public:
    /// g in unknowns, their lower derivatives and the variable of the system. Integrates from the initial point of the
    /// system with so many bits, in the direction of time (< 0: backwards); `watch` is called after each step. Throws
    /// error like sign_at_start, and for a singular initial point if g may be 0 there, or backwards.
    zero_search(const explicit_system& system, const expression& g, long bits, int direction = 1,
                const proof_route& route = {}, march_watch watch = {});
    /// The same along kept steps of the system, of which at least so many bits are needed.
    zero_search(const explicit_system& system, const expression& g, const kept_part& kept, long bits, int direction = 1,
                const proof_route& route = {}, march_watch watch = {});
    /// The same in the direction of time (< 0: backwards) from a set of any width: an event is one of every solution, in
    /// the enclosures of its time and state.
    zero_search(const explicit_system& system, const expression& g, const set_start& start, long bits, int direction,
                const proof_route& route = {}, march_watch watch = {});

    /// The same forwards along the steps of a solution, which satisfies the equations of the system at least near its
    /// initial point, and of which they enclose the values and, if it does not satisfy them everywhere, the slopes. The
    /// steps must outlive this object, and may be shared.
    zero_search(const explicit_system& system, const expression& g, step_sequence& along, long bits,
                march_watch watch = {});
    /// The same from a set of states. A zero whose time is not certainly after start.begins need not be one of the
    /// solution.
    zero_search(const explicit_system& system, const expression& g, step_sequence& along, const search_start& start,
                long bits);

    /// Maximum number of pieces of one step of a search.
    static constexpr long most_pieces_of_a_step = 4'000;
    /// Maximum number of steps without an event in a search without an end.
    static constexpr long usual_horizon = 5'000;

    /// The initial point as an event if g is exactly 0 there; std::nullopt otherwise.
    std::optional<proved_event> at_start() const;
    /// The next zero that is crossed in this direction and is not certainly beyond `end`; std::nullopt for the reason
    /// end(). The horizon applies without an end, or if it is given; a search that reached it, or an earlier end,
    /// continues when called again, with the same direction.
    std::optional<proved_event> next(crossing way, const std::optional<number>& end,
                                     const std::optional<long>& horizon = std::nullopt);

    /// Where the tangent of g at the beginning of the step that is searched next is 0, as a distance of time from there;
    /// infinite if g moves away from 0 or that step is not made. An estimate, on which no proof depends.
    double distance_by_tangent() const;
    /// The beginning of the step that is searched, or the time up to which the solution is proved to exist.
    const ball& reached() const { return time_; }
    /// The number of that step, and the steps up to there, of which one of collocation counts as several.
    std::size_t number_of_step() const { return number_; }
    long steps() const { return steps_; }
    /// Whether the sign of g is certain at reached(), so that all zeros before are known.
    bool is_decided() const { return !open_ && pieces_.empty(); }
    /// The derivative of the flow at reached(), if it is kept.
    std::optional<ball_matrix> derivative();
    /// Where its own integration used collocation.
    const collocation_use& collocation() const { return own_->collocation(); }
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
        int sign;  // of g, or of its derivative
    };

    zero_search(const explicit_system& system, const expression& g, std::shared_ptr<integration> own,
                step_sequence* along, long bits, int direction, march_watch watch);
    void begin_at(const number& point);
    void begin_at_singular(const flow_state& start);
    // Rounded outwards; the bounds of a step are still valid, since they are those of the distance itself.
    ball span_of(const step_piece& p) const { return hull(p.from, p.to) * direction_; }
    sample sampled(const ball& distance) const;
    const expression& curvature();
    expression_values<ball> values_at(const ball& distance) const;
    ball of_state(const expression& e, const ball& distance) const { return values_at(distance).of(e); }
    ball slope_at(const ball& distance, expression_values<ball>& values) const;
    int sign_at(const ball& distance) const;
    crossing way_of_next() const;
    bool covers_beginning(const step_piece& p) const;
    bool is_start(const step_piece& p) const { return start_.order > 0 && number_ == 0 && p.at_0(); }
    void leave_step();
    bool begin_step(const std::optional<ball>& end, long last_step);
    verdict judged(step_piece& p);
    verdict judged_at_start(const step_piece& p);
    verdict undecided_on(const step_piece& p, const sample& all);
    std::optional<proved_event> examined(step_piece p);
    std::optional<proved_event> with_sign(int sign);
    std::optional<proved_event> passed(const step_piece& p, int slope);
    std::optional<proved_event> at_exact_zero(const step_piece& p, const exact_zero& zero);
    std::optional<proved_event> joined();
    void add_part(step_piece p);
    bool narrowed_by_signs(step_piece& p) const;
    void split(const step_piece& p);
    bool split_at_turn(const step_piece& p);

    first_order_form form_;
    expression g_, slope_;
    std::vector<expression> gradient_;     // the derivatives of g with respect to the leaves, and to the variable
    std::optional<expression> curvature_;  // computed on demand
    kept_integrations* kept_ = nullptr;    // of which the integration is one
    std::shared_ptr<integration> own_;
    step_sequence& along_;
    long bits_, digits_;
    int direction_;
    march_watch watch_;
    start_sign start_;
    std::optional<ball> after_;           // the end of the ball in which a search from a set begins
    int sign_ = 1;                        // of g when it was last certain
    crossing way_ = crossing::any;        // of the zeros that are enclosed
    bool open_ = false;                   // g has been monotone towards 0 since then
    std::vector<proved_event> parts_;     // and the possible locations of its zero on these pieces
    std::vector<step_piece> pieces_;      // of the current step, the next one last
    long examined_ = 0;                   // number of halved pieces
    std::size_t number_ = 0;              // of the step that is being examined
    const step* step_ = nullptr;          // that step
    ball time_;                           // its beginning, or the end of the one before
    long steps_ = 0;                      // up to there
    bool has_own_slopes_ = false;         // step::slopes
    std::optional<number> touched_;       // the last time at which g touches 0
    std::optional<proved_event> beyond_;  // found behind the end of a search
    search_end end_ = search_end::none;
    std::optional<undecided_place> undecided_;
};

}  // namespace libration::ode
