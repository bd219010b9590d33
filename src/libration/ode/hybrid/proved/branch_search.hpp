// The first crossing of one of several surfaces by a branch of a hybrid solution.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "libration/ode/hybrid/hybrid_system.hpp"
#include "libration/ode/hybrid/proved/hybrid_path.hpp"
#include "libration/ode/proved/event_search.hpp"

namespace libration::ode {

/// A surface with the crossings that matter, and the beginning of their search; without one, from the exact initial
/// values of the system.
struct watched_surface {
    surface of;
    crossing way = crossing::any;
    std::optional<search_start> start = {};
};

/// A crossing: an event, or the known time of a surface.
struct found_crossing {
    std::size_t surface = 0;
    std::optional<proved_event> event = {};
};

/// Surfaces at known times are compared as exact numbers; each other one has an event search of its own, all of which
/// advance together, so that none goes far beyond the first crossing. A crossing is the first one if its enclosure is
/// separated from the others.
class branch_search {
public:
    /// The system must outlive this object. Zeros are searched after `begins`.
    branch_search(const explicit_system& system, std::vector<watched_surface> surfaces, const ball& begins, long bits,
                  const proof_route& route, const march_watch& watch);

    /// The first crossing that is not certainly beyond `end`; std::nullopt for the reason end(). Without an end it is
    /// searched for so many steps of the integrator.
    std::optional<found_crossing> next(const std::optional<number>& end, long horizon);
    /// Continues the search for a surface behind the crossing that was found.
    void resume(std::size_t surface);

    const surface& surface_at(std::size_t index) const { return watched_[index].of.of; }
    path_end end() const { return end_; }
    /// What is not decided, or where the steps become too small.
    const std::string& reason() const { return reason_; }
    /// Where the search ended without a decision, the time up to which no surface is crossed.
    bool has_reached() const { return reached_.has_value(); }
    const ball& reached() const { return *reached_; }

private:
    struct watched {
        watched_surface of;
        std::unique_ptr<event_search> search = {};
        std::optional<proved_event> found = {};
        bool over = false;               // no crossing before the end
        std::optional<ball> limit = {};  // the search ended there
        long steps = 0;
        path_end why = path_end::none;
        std::string reason = {};
    };

    std::optional<std::size_t> first_known_time(const std::optional<number>& end);
    bool advance(watched& each, const std::optional<number>& end, long steps, long horizon);
    void read_end(watched& each, bool has_end, long horizon);
    std::optional<found_crossing> first_of(const std::optional<std::size_t>& known);
    bool separated(const found_crossing& first, const ball& time);
    std::nullopt_t ended(path_end why, const std::string& reason);

    const explicit_system& system_;
    std::vector<watched> watched_;
    ball begins_;
    long bits_;
    const proof_route& route_;
    const march_watch& watch_;
    path_end end_ = path_end::none;
    std::string reason_;
    std::optional<ball> reached_;
};

/// An exact ball as a number.
number number_of(const ball& exact);
/// A number as a ball.
inline ball enclosed_number(const number& x) { return constant_value<ball>::of(x); }

}  // namespace libration::ode
