// The file of --certificate: from it a program in integers proves the printed values (docs/certificates.md).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "libration/problem/certificate.hpp"
#include "libration/query/proved_events.hpp"
#include "problem/problem_options.hpp"
#include "text/table.hpp"

namespace libration {

/// The problem as it was typed, statement by statement, with its changes by --set: the notes of a certificate.
certificate_notes notes_of(const problem_options& problem);

/// Writes the certificate of a table of states, a row per time. Throws input_error that names the option for a problem
/// or a time that the format does not contain, and for a file that cannot be written; error of the kind undecided if the
/// values are not proved by collocation.
void certify_states(const std::string& path, const ode::explicit_system& system, const std::vector<exact>& times,
                    const table& states, const request& how, const certificate_notes& notes);

/// The same of the events found for a request, a row each.
void certify_events(const std::string& path, const ode::explicit_system& system, const ode::event_request& request,
                    const table& events, const libration::request& how, const certificate_notes& notes);

/// The same of a root of find_unknowns, and of find_periodic_orbit.
void certify_root(const std::string& path, const problem& of, const std::vector<std::string>& unknowns,
                  const std::vector<std::string>& conditions, const answer& found, const request& how,
                  const certificate_notes& notes);
void certify_orbit(const std::string& path, const problem& of, const answer& found, const request& how,
                   const certificate_notes& notes);

/// Calls write(request) with the progress of a certificate of so many digits.
void with_certificate_progress(long digits, const std::function<void(const request&)>& write);

/// Runs libration-check, a program in integers that shares no code with the library (check/c), on the
/// file. Throws error of the kind undecided with the first condition that fails, and if the program is not found.
void check_certificate(const std::string& path);

}  // namespace libration
