// Certificates of printed values: files from which a program in integers proves them again (docs/certificates.md).
#pragma once

#include <string>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/number/exact.hpp"
#include "libration/problem/answer.hpp"
#include "libration/problem/problem.hpp"

namespace libration {

/// Decimals with `digits` digits, or 0 for a number below 10^-digits; a list for each row.
struct printed_rows {
    std::vector<std::vector<std::string>> of;
    long digits = 0;
};

/// Lines that a certificate contains for its reader, such as the problem as it was typed, with its names; no part of what is proved.
using certificate_notes = std::vector<std::string>;

/// The content of the file, compressed by zlib, that proves that each decimal differs by less than one unit of its last
/// digit from the exact value: of the unknowns and their lower derivatives, in the order of names_of_state(), at each of
/// the times. Of the callbacks of the request `reached` and `progress` are called. Throws error of the subject
/// "certificate" as ode::certificate_of, and for a time that is not a fraction.
std::string certificate_of_states(const ode::explicit_system& system, const std::vector<exact>& times,
                                  const printed_rows& states, const request& how, const certificate_notes& notes = {});

/// The same for a condition g = 0: the first zeros after the initial point, only those at which g increases (way 1) or
/// decreases (-1) with time, or all of them (0). Each row has the time and the unknowns. The certificate proves that the
/// condition has no other zeros before the last of them, except those crossed in the other direction, which it lists
/// too.
std::string certificate_of_events(const ode::explicit_system& system, const ode::expression& g, int way,
                                  const printed_rows& events, const request& how, const certificate_notes& notes = {});

/// The same for a root of find_unknowns: parameters or initial values f''(0), with their decimals in this order, for which
/// as many conditions such as f'(5) = 1 hold, all at one time. The certificate proves that the conditions hold for
/// exactly one choice of the unknowns in a box, within one unit of the last digit of each. Throws error of the subject
/// "certificate" for other conditions, and for a parameter on which an initial value depends.
std::string certificate_of_root(const problem& of, const std::vector<std::string>& unknowns,
                                const std::vector<std::string>& conditions, const std::vector<std::string>& decimals,
                                const request& how, const certificate_notes& notes = {});

/// The same for a periodic orbit of find_periodic_orbit, whose rows are the decimals: the solution returns to its initial
/// point for exactly one choice of the period and of all initial values but that on the section.
std::string certificate_of_orbit(const problem& of, const std::vector<std::string>& decimals, const request& how,
                                 const certificate_notes& notes = {});

}  // namespace libration
