// Solutions with events and piecewise right-hand sides: enclosures, from branch to branch.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/equation/hybrid_system.hpp"
#include "libration/event/zero_search.hpp"

namespace libration::ode {

/// The reason why a path ends or is not continued.
enum class path_end {
    none,
    time,          ///< no event up to the requested time
    horizon,       ///< no event within so many steps of the integrator
    stop,          ///< an event ends the solution
    precision,     ///< more bits are needed
    undecided,     ///< this precision does not decide whether there is an event, or which one is first
    steps,         ///< the steps of the integrator become too small, as near a singularity
    sliding,       ///< both branches lead back to the surface between them, or the direction beyond it is not known
    accumulation,  ///< events follow each other in shorter and shorter intervals
};

/// An event of a path. Its time is a known number, or in a ball.
struct path_event {
    ball time;
    std::optional<number> exactly = {};
    crossing way = crossing::any;
    std::vector<ball> state;            ///< before the event; at a known time computed on demand
    std::vector<ball> on_the_way = {};  ///< at all times of the ball, on the branch before the event
    std::string text;                   ///< the condition as written
};

/// For each value of the state the number that it is exactly, if that is known; empty if none is.
using kept_values = std::vector<std::optional<number>>;

class branch_beginning;
struct initial_mode;
class branch_search;
struct crossed_surface;
struct found_crossing;

/// One branch of the solution, between two events.
struct path_piece {
    explicit path_piece(explicit_system of) : system(std::move(of)) {}

    explicit_system system;                       ///< from the state at its point
    std::unique_ptr<integration> along = {};      ///< the steps from that state
    step_values steps;                            ///< the values of the step functions
    std::optional<std::vector<ball>> state = {};  ///< at the point; std::nullopt for the exact initial values
    std::optional<state_set> set = {};            ///< the same less wide, if it is known
    std::optional<ball> begins = {};              ///< the time of the event at which it begins, unless that is exact
    std::vector<ball> on_the_way = {};            ///< the states at the times of that ball, after the event
    kept_values kept = {};                        ///< on the whole branch
};

/// The rule for the steps on all branches with these equations.
struct followed_mode {
    std::vector<expression> slopes;
    std::shared_ptr<step_rule> rule;
};

/// The solution of a hybrid system, by one run with so many bits, as a sequence of branches. Each is integrated from a
/// set (theorem V), once for all questions, up to the first zero of one of its surfaces (theorem E). Let T be a ball that
/// contains its time t*,
/// and A the states after the event. Z contains A + [-w, w] f(Z) for the right-hand side f of the next branch and w = the
/// diameter of T; so the solution of that branch through each state of A at t* exists at all times of T and is in Z
/// there, by Picard's theorem. At the lower end c of T it is in A + (c - T) f(Z): the next branch is integrated from this
/// set at the exact time c, and it is the solution from t* on. Known times are exact, and c is the time itself. What is
/// known of the solution as a set, and not as a box, continues in the next branch (crossing_set.hpp).
///
/// At the beginning of each branch mode_after (initial_mode.hpp) decides the values of all step functions, or the path
/// ends. A condition on step functions has one value on each branch. An event with such a condition happens where it does
/// not hold on the branch before and holds on the branch that would follow without resets, decided in the same way. A
/// condition on values that resets alone change (hybrid_system::is_kept) begins to hold by one: its event happens after
/// the resets of the others, at the same time.
class hybrid_path {
public:
    /// The maximum number of events.
    static constexpr long most_events = 100'000;

    /// The system must outlive this object. With `observed`, a function of the solution, its zeros are found by
    /// next_observed. Throws error for a singular initial point, and if the branch at the initial point is not unique.
    hybrid_path(const hybrid_system& system, long bits, proof_route route = {}, march_watch watch = {},
                const expression* observed = nullptr, crossing observed_way = crossing::any);
    ~hybrid_path();

    /// The state at a time, which increases from call to call up to `last`, the same in all calls; of an event the state
    /// after it, and at a time that is not distinguished from that of an event both; a derivative that may not exist
    /// there is unbounded. std::nullopt for the reason end().
    std::optional<std::vector<ball>> at(const number& time, const number& last);
    /// The next zero of the observed function, with the state before an event at the same time; without an end of the
    /// search within so many steps after the last such zero, on all branches.
    std::optional<path_event> next_observed(const std::optional<number>& end, long horizon);

    /// Whether the state of the last call is that before and after an event.
    bool at_event() const { return at_event_; }
    /// The branch of the last call.
    const path_piece& piece() const { return *piece_; }
    path_end end() const { return end_; }
    /// Why the path ends, for messages.
    const std::string& reason() const { return reason_; }
    /// The cost of the steps on all branches up to now, and of their searches for crossings, one for each surface.
    long steps() const;
    /// The number of events that change the solution or its branch.
    long events() const { return count_; }
    /// The time of the last of them, or the initial time.
    const ball& last_event() const { return last_time_; }
    long bits() const { return bits_; }
    /// The step functions of which the argument remained 0 on a branch, so that their values there, and not the signs
    /// of their arguments, decided the right-hand side; as written.
    const std::vector<std::string>& by_relation() const { return by_relation_; }

private:
    // After an event: the leaves in terms of their values before, and the states.
    struct entered_branch {
        std::vector<expression> leaves;
        std::vector<ball> state;
    };

    // An unknown, the argument of a sign, with the slope -h^exponent outflow for h > 0 and 0 beyond.
    struct emptying {
        std::size_t step, leaf;
        rational exponent;
        expression outflow;
    };

    std::optional<emptying> emptying_of(std::size_t step, const std::vector<ball>& state) const;
    bool is_in_other_argument(std::size_t step) const;
    bool find_empty_store();
    std::string reason_at_store() const;
    void look_for_emptying();
    bool find_planned_emptying();
    std::optional<bool> find_emptying(const std::optional<number>& end);
    bool continue_emptied();
    void note_relations(const std::vector<std::size_t>& steps);
    std::shared_ptr<step_rule> rule_of_branch();
    void begin_steps();
    bool search_branch(const branch_beginning* beginning);
    path_event event_of(const found_crossing& found) const;
    crossing way_of(const surface& of) const;
    int observed_orientation(const surface& of) const;
    bool is_observed(const surface& of, crossing way) const;
    bool happens(const crossing_effect& event, crossing way) const;
    bool has_effect(const surface& of, crossing way) const;
    bool find(const std::optional<number>& end, const std::optional<number>& farthest, long horizon);
    std::optional<std::vector<std::size_t>> happening_events();
    std::vector<expression> reset_leaves(const std::vector<std::size_t>& happening);
    bool is_stopped(const std::vector<std::size_t>& happening);
    bool reset_state(const std::vector<std::size_t>& happening, entered_branch& entered);
    std::vector<std::size_t> events_by_resets(const step_values& before, const step_values& after) const;
    std::vector<std::size_t> crossed_steps() const;
    std::vector<expression> zero_functions() const;
    std::optional<search_start> start_on(const surface& of, const branch_beginning& beginning);
    bool complete(path_event& event);
    bool accumulates();
    bool take();
    bool continue_on_branch();
    explicit_system branch_after(const entered_branch& entered, const step_values& values) const;
    bool add_saltation(entered_branch& entered, const step_values& values);
    bool enter_mode(entered_branch& entered, const initial_mode& mode, const branch_beginning& beginning);
    bool enter(const entered_branch& entered, const step_values& values, const branch_beginning& beginning);
    std::optional<state_set> set_behind_event(const entered_branch& entered, const path_piece& next);
    std::optional<std::vector<ball>> state_before(const number& time);
    static int before_or_after(const number& time, const path_event& event);
    bool certainly_before(const number& time) const;
    std::vector<ball> state_at_event() const;
    bool ended(path_end why, std::string reason = {});

    const hybrid_system& system_;
    long bits_;
    proof_route route_;
    march_watch watch_;
    const expression* observed_;
    crossing observed_way_;
    std::unique_ptr<path_piece> piece_;
    std::vector<followed_mode> modes_;       // up to now
    std::unique_ptr<branch_search> search_;  // on the branch
    std::size_t state_step_ = 0;             // of the last requested state on it
    long steps_ = 0;                         // on the branches before
    long unobserved_ = 0;                    // on those after the last zero of the observed function, of one surface
    std::optional<path_event> next_;         // at which the branch ends
    std::vector<crossed_surface> crossed_;   // there
    std::optional<std::size_t> emptied_;     // the sign of a store that is empty from then on
    std::vector<expression> reset_values_;   // of all resets there, also of those that a later one replaces
    std::optional<path_event> observed_event_;
    std::vector<ball> before_last_;  // on the branch before, at all times of the ball in which this one begins
    std::vector<bool> reset_last_;   // whether that event resets a value
    ball first_time_, last_time_;    // the initial time, and that of the last event
    long count_ = 0;                 // of events
    long shorter_ = 0;               // of the last intervals, those that were far shorter than the time
    bool at_event_ = false;
    std::vector<std::string> by_relation_;
    path_end end_ = path_end::none;
    std::string reason_;
};

}  // namespace libration::ode
