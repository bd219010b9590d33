#include "libration/problem/known_facts.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "known/known_problems.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/scalar/error.hpp"

namespace libration {

namespace {

std::string without_blanks(const std::string& text) {
    std::string plain;
    std::ranges::copy_if(text, std::back_inserter(plain), [](char c) { return c != ' '; });
    return plain;
}

// The right-hand side of the condition if its left side is this one.
std::optional<std::string> right_side(const std::string& condition, const std::string& left) {
    const std::string plain = without_blanks(condition);
    return plain.starts_with(left + "=") ? std::optional(plain.substr(left.size() + 1)) : std::nullopt;
}

// Whether the problem is the one of the catalogue, except for its parameters.
bool is_of_catalogue(const ode::equation_system& system, const std::string& name) {
    const auto known = ode::parse(problem_text(name));
    const auto same = [](const ode::equation& a, const ode::equation& b) {
        return same_form(a.left, b.left) && same_form(a.right, b.right);
    };
    const auto same_start = [](const ode::start& a, const ode::start& b) {
        return same_form(a.of, b.of) && same_form(a.point, b.point) && same_form(a.value, b.value);
    };
    return std::ranges::equal(system.equations, known.equations, same) &&
           std::ranges::equal(system.starts, known.starts, same_start);
}

bool determines(const condition_at_infinity& condition, const std::vector<std::string>& unknowns) {
    return std::ranges::all_of(unknowns, [&](const std::string& name) {
        return std::ranges::find(condition.unknowns, name) != condition.unknowns.end();
    });
}

// "blasius for k with f'(inf), ..., painleve_1 for u(0) and u'(0) with u(-inf)".
std::string conditions_in_words() {
    std::string all;
    for (const known_facts& each : all_known_facts()) {
        if (each.condition) {
            std::string names;
            for (const std::string& name : each.condition->unknowns) {
                names += (names.empty() ? "" : " and ") + name;
            }
            all += (all.empty() ? "" : ", ") + each.problem + " for " + names + " with " + each.condition->of;
        }
    }
    return all;
}

}  // namespace

const std::vector<known_facts>& all_known_facts() {
    static const std::vector<known_facts> all{
        facts_of_blasius(),  facts_of_falkner_skan(), facts_of_flierl_petviashvili(),
        facts_of_kepler(),   facts_of_painleve_1(),   facts_of_pendulum(),
        facts_of_rayleigh(), facts_of_sakiadis(),     facts_of_seir(),
        facts_of_sir(),      facts_of_sir_japan(),    facts_of_thomas_fermi()};
    return all;
}

const known_facts* known_facts_of(const std::string& problem) {
    const auto found = std::ranges::find(all_known_facts(), problem, &known_facts::problem);
    return found == all_known_facts().end() ? nullptr : &*found;
}

const known_facts* known_facts_of(const ode::equation_system& system) {
    if (!system.is_ordinary()) {
        return nullptr;
    }
    const auto found = std::ranges::find_if(
        all_known_facts(), [&](const known_facts& each) { return is_of_catalogue(system, each.problem); });
    return found == all_known_facts().end() ? nullptr : &*found;
}

bool is_at_infinity(const std::string& condition) {
    const std::string plain = without_blanks(condition);
    return plain.find("(inf)") != std::string::npos || plain.find("(-inf)") != std::string::npos;
}

bool is_decided_by_lemma(const ode::equation_system& system, const std::vector<std::string>& unknowns,
                         const std::string& condition) {
    const known_facts* const facts = known_facts_of(system);
    if (facts == nullptr || !facts->condition || !determines(*facts->condition, unknowns)) {
        return false;
    }
    const auto limit = right_side(condition, facts->condition->of);
    try {
        return limit && facts->condition->holds(*limit);
    } catch (const error&) {
        return false;  // not a number, but more words
    }
}

std::vector<proved_decimal> proved_for_infinity(const ode::equation_system& system,
                                                const std::vector<std::string>& unknowns, const std::string& condition,
                                                long digits) {
    const known_facts* const facts = known_facts_of(system);
    const bool about = facts != nullptr && facts->condition && determines(*facts->condition, unknowns);
    const auto limit = about ? right_side(condition, facts->condition->of) : std::nullopt;
    if (!limit) {
        throw error(error_kind::undecided, error_subject::condition, condition,
                    "is at infinity, and no lemma is available for this problem; the catalogue has lemmas for " +
                        conditions_in_words());
    }
    const condition_at_infinity& known = *facts->condition;
    if (!known.holds(*limit)) {
        throw error(error_kind::argument, error_subject::condition, condition,
                    "is not a condition for which " + facts->problem + " has a lemma: give the value " + known.limits);
    }
    const auto all = known.values(system, *limit, digits);
    std::vector<proved_decimal> asked;
    asked.reserve(unknowns.size());
    for (const std::string& name : unknowns) {
        asked.push_back(
            all[static_cast<std::size_t>(std::ranges::find(known.unknowns, name) - known.unknowns.begin())]);
    }
    return asked;
}

std::optional<std::vector<proved_decimal>> limits_by_lemma(const ode::equation_system& system, long digits) {
    const known_facts* const facts = known_facts_of(system);
    return facts != nullptr && facts->limits ? std::optional(facts->limits(system, digits)) : std::nullopt;
}

std::vector<std::string> problems_with_far_behaviour() {
    std::vector<std::string> names;
    for (const known_facts& each : all_known_facts()) {
        if (each.far) {
            names.push_back(each.problem);
        }
    }
    return names;
}

far_behaviour far_behaviour_of(const std::string& problem, const ode::equation_system& given, long digits,
                               const std::string& free) {
    const known_facts* const facts = known_facts_of(problem);
    if (facts == nullptr || !facts->far) {
        throw error(error_kind::argument, error_subject::problem, problem, "has no known asymptotic behaviour");
    }
    const precision_scope scope(2 * digits + 20);
    return facts->far(given, digits, free);
}

}  // namespace libration
