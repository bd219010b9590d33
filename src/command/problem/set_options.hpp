// The options of a command for enclosures of all solutions of a problem: of sets of initial values and parameters, over
// spans of time, and at events.
#pragma once

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

#include "libration/query/sets/event_counts.hpp"
#include "libration/query/sets/set_events.hpp"
#include "libration/query/sets/solution_sets.hpp"
#include "problem_options.hpp"
#include "solution_table.hpp"

namespace libration {

/// --over A:B:N, spans of time, and --parts N, the cost of enclosures.
class set_options {
public:
    void add_to(CLI::App& command);
    /// Whether enclosures are requested: by --over, or by a set in the problem.
    bool given(const problem_options& problem) const { return over_ || has_sets(problem); }
    /// The enclosures of all solutions at the times, or over the spans if there are no times: a row for each time or
    /// span and each unknown, time,unknown,lower,upper,rigour,time_typed or from,to,unknown,lower,upper,rigour, with
    /// bounds rounded outwards to the resolution of their distance, at most so many digits. A line on stderr states the
    /// parts. Throws input_error.
    partial_table enclosures(const problem_options& problem, const std::optional<std::string>& times, long digits,
                             const ode::proof_route& route) const;
    /// Whether the problem has sets.
    static bool has_sets(const problem_options& problem) {
        return problem.is_chosen() && !problem.equations().sets.empty();
    }
    /// The events of all solutions: rows event,quantity,lower,upper,rigour for the time and each unknown. Throws
    /// input_error.
    partial_table events(const problem_options& problem, ode::set_event_request request, long digits,
                         const ode::proof_route& route) const;
    /// The possible numbers of events: rows events,rigour. Throws input_error.
    partial_table event_counts(const problem_options& problem, ode::event_count_request request, long digits,
                               const ode::proof_route& route) const;

private:
    std::vector<exact> ends_of_spans() const;
    std::size_t most_parts() const;

    std::optional<std::string> over_, parts_;
};

}  // namespace libration
