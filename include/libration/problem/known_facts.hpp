// Known facts about a problem of the catalogue beyond its text, as optional capabilities: a new fact is a member, a new
// problem a file in src/libration/problem/known/.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "libration/equation/equation_system.hpp"
#include "libration/problem/far_behaviour.hpp"
#include "libration/scalar/printed_number.hpp"

namespace libration {

class solution;

/// A condition at infinity that determines parameters or initial values, by a lemma (problem/known/).
struct condition_at_infinity {
    std::vector<std::string> unknowns;  ///< the unknowns that it determines: k, or u(0) and u'(0)
    std::string of;                     ///< its left side, f'(inf)
    std::string limits;                 ///< the right-hand sides to which the lemma applies, in words: above 0
    std::function<bool(const std::string& limit)> holds;
    /// The unknowns, each digit proved.
    std::function<std::vector<proved_decimal>(const ode::equation_system&, const std::string& limit, long digits)>
        values;
};

/// The known facts about one problem; an empty member is unknown.
struct known_facts {
    std::string problem;  ///< its name in the catalogue
    std::optional<condition_at_infinity> condition = {};
    /// The values of the unknowns at infinite time, each digit proved.
    std::function<std::vector<proved_decimal>(const ode::equation_system&, long digits)> limits = {};
    /// The asymptotic behaviour (far_behaviour_of).
    std::function<far_behaviour(const ode::equation_system&, long digits, const std::string& free)> far = {};
    /// The solution in closed form of any equations that are equivalent to the problem, whatever their names and
    /// parameters; nullptr for others.
    std::function<std::unique_ptr<solution>(const ode::equation_system&)> closed_form = {};
};

/// Of all problems with known facts, by name.
const std::vector<known_facts>& all_known_facts();

/// Of the problem of this name, nullptr if it has no known facts.
const known_facts* known_facts_of(const std::string& problem);

/// Of the problem of the catalogue that has these equations and initial values, possibly with other values of
/// parameters; nullptr if there is none with known facts.
const known_facts* known_facts_of(const ode::equation_system& system);

/// Whether a condition is one at infinity: f'(inf) = 1, u(-inf) = ...
bool is_at_infinity(const std::string& condition);

/// Whether proved_for_infinity() has a lemma for this condition.
bool is_decided_by_lemma(const ode::equation_system& system, const std::vector<std::string>& unknowns,
                         const std::string& condition);

/// The values of parameters or initial values for which a condition at infinity holds, each digit proved: blasius k,
/// falkner_skan s (b > 0), sakiadis G, with f'(inf), thomas_fermi slope, with y(inf) = 0, painleve_1 u(0) and u'(0),
/// with u(-inf) = -sqrt(-z/6), without oscillations. Throws error of the kind undecided for a problem without a lemma,
/// of the kind argument for a limit to which the lemma does not apply.
std::vector<proved_decimal> proved_for_infinity(const ode::equation_system& system,
                                                const std::vector<std::string>& unknowns, const std::string& condition,
                                                long digits);

/// The unknowns at infinite time, each digit proved, by a lemma on this problem: for sir the state after the epidemic.
/// std::nullopt for a problem without one.
std::optional<std::vector<proved_decimal>> limits_by_lemma(const ode::equation_system& system, long digits);

/// The problems of the catalogue with known asymptotic behaviour, by name.
std::vector<std::string> problems_with_far_behaviour();

/// The asymptotic behaviour of one of these, also with modified parameters. A free initial value (s of falkner_skan, G
/// of sakiadis, w0 of flierl_petviashvili; or `free` instead of it, as b) is an initial guess: from it the secant
/// method finds the value that meets the condition at infinity, at increasing distances, in mpfr of 2 digits + 20.
/// Throws error for another problem and if the method does not converge.
far_behaviour far_behaviour_of(const std::string& problem, const ode::equation_system& given, long digits,
                               const std::string& free = "");

}  // namespace libration
