// Certificates of printed values: files from which a program in integers proves them again (docs/certificates.md).
#pragma once

#include <string>
#include <vector>

#include "libration/ode/explicit_system.hpp"
#include "libration/problem/answer.hpp"
#include "libration/problem/problem.hpp"
#include "libration/scalar/exact.hpp"

namespace libration {

/// Decimals with `digits` digits, or 0 for a number below 10^-digits; a list for each row.
struct printed_rows {
    std::vector<std::vector<std::string>> of;
    long digits = 0;
};

/// The content of the file, compressed by zlib, that proves that each decimal differs by less than one unit of its last
/// digit from the exact value: of the unknowns and their lower derivatives, in the order of names_of_state(), at each of
/// the times. Of the callbacks of the request `reached` and `progress` are called. Throws error of the subject
/// "certificate" as ode::certificate_of, and for a time that is not a fraction.
std::string certificate_of_states(const ode::explicit_system& system, const std::vector<exact>& times,
                                  const printed_rows& states, const request& how);

/// The same for a condition g = 0: the first zeros after the initial point, only those at which g increases (way 1) or
/// decreases (-1) with time, or all of them (0). Each row has the time and the unknowns. The certificate proves that the
/// condition has no other zeros before the last of them, except those crossed in the other direction, which it lists
/// too.
std::string certificate_of_events(const ode::explicit_system& system, const ode::expression& g, int way,
                                  const printed_rows& events, const request& how);

/// The same for a root of find_unknowns: a parameter or an initial value f''(0), with its decimal, for which one
/// condition such as f'(5) = 1 holds. The certificate proves the values at time 5 for the fractions one unit of the last
/// digit below and above it, and that the solution exists up to there for all numbers between them: by continuity one of
/// these satisfies the condition, if its value lies between those two. Throws error of the subject "certificate" for
/// other conditions, and for a parameter on which an initial value depends.
std::string certificate_of_root(const problem& of, const std::string& unknown, const std::string& condition,
                                const std::string& decimal, const request& how);

}  // namespace libration
