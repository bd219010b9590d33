// The first crossing of one of several surfaces by a branch of a hybrid solution.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "branch_beginning.hpp"
#include "libration/equation/hybrid_system.hpp"
#include "libration/event/zero_search.hpp"
#include "libration/hybrid/hybrid_path.hpp"

namespace libration::ode {

/// A surface with the crossings that matter, and the beginning of their search; without one, from the exact initial
/// values of the system.
struct watched_surface {
    surface of;
    crossing way = crossing::any;
    std::optional<search_start> start = {};
};

/// A surface that is crossed.
struct crossed_surface {
    surface of;
    crossing way = crossing::up;
};

/// A crossing: an event, or a time that is known exactly, at which several surfaces may be crossed.
struct found_crossing {
    std::vector<std::size_t> surfaces;
    std::vector<crossed_surface> crossed;
    std::optional<proved_event> event = {};
    std::optional<number> exactly = {};
};

/// Where a store is expected to become empty.
struct emptying_plan {
    std::optional<std::size_t> surface = {};  ///< its number; std::nullopt if no store is
    number before = {};                       ///< up to here other surfaces are searched for before
    number about = {};                        ///< the expected time
    int left = 0;                             ///< attempts
    std::size_t step = 0;                     ///< its sign
    std::optional<path_event> event = {};     ///< once it is proved

    /// The next time before, after this one.
    void advance(const number& from) {
        before = from + (about - from) * number(rational(3, 4));
        surface = left-- > 0 ? surface : std::nullopt;
    }
};

/// Surfaces at known times are compared as exact numbers; each other one has a separate event search, all of which
/// advance together, so that none goes far beyond the first crossing. A crossing is the first one if its enclosure is
/// separated from the others. Functions of the variable alone that are exactly 0 at a common time are crossed together:
/// each has only one zero in its enclosure.
class branch_search {
public:
    /// Along the steps of the branch, which all searches share. They and the system must outlive this object. Zeros are
    /// searched after `begins`.
    branch_search(const explicit_system& system, std::vector<watched_surface> surfaces, ball begins, long bits,
                  step_sequence& along);

    /// The first crossing that is not certainly beyond `end`; std::nullopt for the reason end(). Without an end it is
    /// searched for so many steps of the integrator. Steps before those at which the searches pause are forgotten.
    std::optional<found_crossing> next(const std::optional<number>& end, long horizon);
    /// Continues the search for a surface behind the crossing that was found.
    void resume(std::size_t surface);

    /// The steps that were searched, for each surface.
    long steps() const;
    /// Of the surface for which the most were searched.
    long most_steps() const;
    path_end end() const { return end_; }
    /// Whether no other surface than this one is crossed up to the end of the last step of the branch, after which it has
    /// none.
    bool is_last_before_end(std::size_t surface) const;
    /// What is not decided, or where the steps become too small.
    const std::string& reason() const { return reason_; }
    /// Where the search ended without a decision, the time up to which no surface is crossed.
    bool has_reached() const { return reached_.has_value(); }
    const ball& reached() const { return *reached_; }

    std::optional<emptying_plan> emptying;  ///< of the branch, on demand

private:
    struct watched {
        watched_surface of;
        std::unique_ptr<zero_search> search = {};
        std::optional<proved_event> found = {};
        bool over = false;               // no crossing before the end
        bool passed = false;             // the known time, which is the only zero
        std::optional<ball> limit = {};  // the search ended there
        long steps = 0;
        path_end why = path_end::none;
        std::string reason = {};
    };

    std::optional<std::size_t> first_known_time(const std::optional<number>& end);
    std::vector<watched*> in_order(const std::optional<number>& end);
    bool advance(watched& each, const std::optional<number>& end, long horizon);
    void read_end(watched& each, bool has_end, long horizon);
    std::optional<found_crossing> first_of(const std::optional<std::size_t>& known);
    std::optional<found_crossing> crossing_at(std::size_t first, const ball& time);
    std::optional<number> common_time(const std::vector<std::size_t>& surfaces) const;
    static bool is_zero_at(const watched& each, const number& time);
    void reach(const ball& time);
    void forget_searched_steps();
    std::nullopt_t ended(path_end why, const std::string& reason);

    const explicit_system& system_;
    std::vector<watched> watched_;
    ball begins_;
    long bits_;
    step_sequence& along_;
    path_end end_ = path_end::none;
    std::string reason_;
    std::optional<ball> reached_;
};

}  // namespace libration::ode
