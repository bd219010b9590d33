// The options of a command for the events of a problem.
#pragma once

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

#include "libration/query/proved_events.hpp"
#include "libration/query/sets/event_counts.hpp"
#include "libration/query/sets/set_events.hpp"
#include "problem_options.hpp"

namespace libration {

/// The value of an option for a number of things, from 1 to `most`. Throws input_error.
int positive_count(const char* option, const std::string& value, int most, const char* of_what);

/// --until "x = 0" and the options that depend on it: --count, --crossing, --before, --from-start, --horizon, --how-many.
class event_options {
public:
    void add_to(CLI::App& command);
    /// Whether --until is given.
    bool given() const { return until_.has_value(); }
    /// The condition of --until as it is given.
    const std::string& condition() const { return *until_; }
    /// Throws input_error.
    ode::event_request request(const solution& of, const ode::explicit_system& system) const;
    /// The same for all solutions of a set.
    ode::set_event_request request_for_sets() const;
    /// Whether the number of events is requested: --how-many.
    bool asks_how_many() const { return how_many_; }
    /// The request of --how-many, which --before ends.
    ode::event_count_request request_for_counts() const;

private:
    /// What all requests have.
    template <class Request>
    void read_into(Request& request) const;

    std::optional<std::string> until_, count_, way_, before_, horizon_;
    bool from_start_ = false, how_many_ = false;
};

}  // namespace libration
