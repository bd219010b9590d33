// What is proved of problems of the catalogue at infinity: each by a lemma of its own.
#pragma once

#include <string>
#include <vector>

#include "libration/ode/equation_system.hpp"
#include "libration/scalar/text/printed_number.hpp"
#include "text/table.hpp"

namespace libration {

/// Whether a condition speaks of infinity: f'(inf) = 1, u(-inf) = ...
bool is_at_infinity(const std::string& condition);

/// The parameters for which the condition holds: blasius k, falkner_skan s (b > 0), sakiadis G, with f'(inf)
/// (ode/proved/blasius_infinity.hpp, layers_at_infinity.hpp), thomas_fermi slope with y(inf) (neutral_atom.hpp); or the
/// start: painleve_1 u(0) and u'(0) with u(-inf) = -sqrt(-z/6), without oscillations (tritronquee.hpp). Throws error of
/// the kind undecided for a problem without a lemma, input_error for a limit that the lemma is not about.
std::vector<proved_decimal> proved_for_infinity(const ode::equation_system& system,
                                                const std::vector<std::string>& unknowns, const std::string& condition,
                                                long digits);

/// time,<unknown>...,digits,rigour,time_typed at the time inf: of sir what the epidemic leaves
/// (ode::epidemic_remainder). Throws error of the kind undecided for other problems.
table state_at_infinity(const ode::equation_system& system, long digits);

}  // namespace libration
