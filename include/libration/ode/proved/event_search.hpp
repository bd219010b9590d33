// Where a function of the solution is 0, enclosed: theorem E.
#pragma once

#include <optional>
#include <vector>

#include "libration/ode/first_order_form.hpp"
#include "libration/ode/proved/proved_march.hpp"

namespace libration::ode {

/// The way in which a function passes 0 as time goes on.
enum class crossing { any, up, down };

/// A zero of g, alone in its enclosure, and the unknowns there.
struct proved_event {
    ball time;
    std::vector<ball> state;
    crossing way = crossing::any;
};

/// The zeros of g(t, y(t)) after the start, in their order, none left out. On a piece of a step either the ball of g
/// excludes 0, or that of its derivative along the solution, Dg(y) f(y) on the enclosure of y, does, and the signs at
/// the ends decide; else the piece is halved. A zero is then narrowed by Newton's method on balls: m - g(m)/g'(S) holds
/// it for m in S. A zero where the derivative vanishes too is not told from none: precision_exhausted.
class event_search {
public:
    /// g in unknowns, their lower derivatives and the variable of the system. A march from the start of the system in
    /// so many bits, in the direction of time (< 0: backwards).
    event_search(const explicit_system& system, const expression& g, long bits, int direction = 1,
                 const proof_route& route = {});

    static constexpr long most_steps_between = 100'000;

    /// The next zero that is passed this way. Nothing where the search ends: stopped(), or there is none up to the end.
    /// Throws error of the kind undecided where there is none for so many steps.
    std::optional<proved_event> next(crossing way, const std::optional<number>& end);

    const proved_march& march() const { return march_; }
    /// Whether the march stopped before the end.
    bool stopped() const { return stopped_; }

private:
    struct sample {
        ball value;
        ball slope;
        std::vector<ball> state;
    };

    sample sampled(const ball& distance) const;
    void examine(const ball& from, const ball& to, int depth);
    std::optional<ball> bracket(const ball& from, const ball& to, const ball& slope) const;
    void add_event(const ball& within);
    bool is_start(const ball& distance) const;

    first_order_form form_;
    expression g_, slope_;
    bool zero_at_start_;
    proved_march march_;
    int direction_;
    std::vector<proved_event> found_;  // of the present step, the next one last
    std::optional<ball> last_;
    bool examined_ = false;
    bool stopped_ = false;
};

}  // namespace libration::ode
