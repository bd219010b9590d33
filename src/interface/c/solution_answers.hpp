// Answers of a solution to questions of the C interface.
#pragma once

#include <string>

#include "answers.hpp"
#include "guarded.hpp"
#include "handles.hpp"
#include "libration/problem/certificate.hpp"
#include "libration/problem/solution.hpp"

namespace libration::c {

/// Coefficients first .. last about a point, through the corners of a path; both may be NULL. Throws error of the kind
/// argument for corners without a point, and as require_powers.
series_request request_of(const char* point, const char* corners, long first, long last);

/// The first `count` events; throws error of the kind argument for a count below 1.
known_states events_of(const solution& of, const char* condition, long count, long digits);
/// The same with "crossing = up; before = 10; from_start = yes; horizon = 100" or some of them; `settings` may be NULL.
known_states events_of(const libration_problem& p, const solution& of, const char* condition, const char* settings,
                       long count, long digits, const watcher& watch);

/// The request of a proof of so many digits, whose progress is that of the callback.
request watched(long digits, const watcher& watch);

/// The decimals of a table of which every cell is a number, from a column on.
printed_rows decimals_of(const libration_table& of, std::size_t first, long digits);

/// Writes a file next to it, and replaces it when it is complete. Throws error of the subject "path".
void write_file(const std::string& path, const std::string& content);

/// The states at times, and their certificate in a file.
libration_table certified_states(const libration_problem& p, const solution& of, const char* times, long digits,
                                 const char* path, const watcher& watch);
/// The same for the first `count` events.
libration_table certified_events(const libration_problem& p, const solution& of, const char* condition, long count,
                                 long digits, const char* path, const watcher& watch);

}  // namespace libration::c
