#include "libration/problem/find.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <stdexcept>

#include "../query/connection/homoclinic_limits.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/number/two_proofs.hpp"
#include "libration/problem/known_facts.hpp"
#include "libration/problem/proved_answer.hpp"
#include "libration/query/connection/connection.hpp"
#include "libration/query/shooting/periodic_orbit.hpp"
#include "libration/query/shooting/proved_unknowns.hpp"
#include "libration/query/shooting/solution_branch.hpp"
#include "libration/query/well/eigenvalues.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration {

namespace {

struct found_values {
    std::vector<std::string> names;
    std::vector<proved_decimal> values;
};

// Reports the progress of each integration.
ode::march_watch watch_of(const request& how) {
    return [&how](const ball& reached, long bits) {
        if (how.reached) {
            how.reached(midpoint_of(reached).convert_to<double>(), bits);
        }
    };
}

// An error about the problem becomes one about the conditions or the unknowns, which caused it.
template <class Work>
auto about(error_subject subject, const Work& work) {
    try {
        return work();
    } catch (const error& problem) {
        if (problem.kind() != error_kind::argument || !problem.is_about(error_subject::problem)) {
            throw;
        }
        throw error(problem.kind(), subject, problem.value(), problem.reason());
    }
}

// find(digits, route) once, or twice with a comparison.
template <class Find>
answer found_by(const request& how, const Find& find) {
    const auto checked = checked_products(how.check);
    const found_values found = find(how.printed_digits(), ode::proof_route{});
    if (how.check) {
        const found_values second =
            find(how.printed_digits() + ode::more_digits_of_second_proof, ode::proof_route::second());
        for (std::size_t i = 0; i < found.names.size(); ++i) {
            require_agreement(found.values[i], second.values[i], found.names[i]);
        }
    }
    answer result{.names = {"name", "value"}, .rows = {}, .rigour = "proved"};
    for (std::size_t i = 0; i < found.names.size(); ++i) {
        result.rows.push_back({text_value(found.names[i]), {found.values[i].text, found.values[i].uncertainty}});
    }
    return result;
}

found_values found_for_infinity(const problem& of, const std::vector<std::string>& unknowns,
                                const std::string& condition, long digits) {
    return {unknowns, about(error_subject::conditions,
                            [&] { return proved_for_infinity(of.equations(), unknowns, condition, digits); })};
}

// By theorem C.
answer connection_found(const problem& of, const std::vector<std::string>& unknowns,
                        const std::vector<std::string>& conditions, const request& how,
                        const std::vector<std::string>& without_guess) {
    ode::connection_question question{of.equations(), unknowns, {}, without_guess, 0};
    for (const std::string& each : conditions) {
        if (!is_at_infinity(each)) {
            throw error(error_kind::argument, error_subject::condition, each,
                        "is given together with one at infinity: write it as an initial value of the problem");
        }
        question.limits.push_back(
            about(error_subject::conditions, [&] { return ode::parse_limit(of.equations(), each); }));
    }
    std::vector<answer_note> notes;
    answer result = found_by(how, [&](long digits, const ode::proof_route& route) {
        question.digits = digits;
        const auto found =
            about(error_subject::unknowns, [&] { return ode::proved_connection(question, route, watch_of(how)); });
        notes = {{"proved", found.proved}, {"not claimed", found.not_claimed}};
        for (const ode::connection_number& each : found.more) {
            notes.push_back({each.name, each.value.text});
        }
        return found_values{unknowns, found.values};
    });
    result.notes = std::move(notes);
    return result;
}

std::vector<ode::limit_condition> read_limits(const problem& of, const std::vector<std::string>& conditions) {
    std::vector<ode::limit_condition> limits;
    for (const std::string& each : conditions) {
        limits.push_back(about(error_subject::conditions, [&] { return ode::parse_limit(of.equations(), each); }));
    }
    return limits;
}

// Once, or twice with a comparison.
ode::eigenvalues eigenvalues_by(ode::eigenvalue_question question, const request& how) {
    const auto checked = checked_products(how.check);
    auto found = ode::proved_eigenvalues(question, watch_of(how));
    if (how.check) {
        question.digits += ode::more_digits_of_second_proof;
        const auto second = ode::proved_eigenvalues(question, watch_of(how));
        for (std::size_t i = 0; i < std::min(found.values.size(), second.values.size()); ++i) {
            const auto enclosure = [](const known_value& x) {
                return x.decimal.value_or(proved_decimal{"0", x.bound});
            };
            require_agreement(enclosure(found.values[i].value), enclosure(second.values[i].value),
                              question.energy + "_" + std::to_string(found.values[i].index));
        }
    }
    return found;
}

answer answer_of(const ode::eigenvalues& found, const std::vector<std::string>& names) {
    answer result{.names = {"name", "value"}, .rows = {}, .rigour = "proved"};
    if (!found.proved.empty()) {
        result.notes.push_back({"proved", found.proved});
    }
    for (std::size_t i = 0; i < found.values.size(); ++i) {
        result.rows.push_back({text_value(names[i]), value_in_answer(found.values[i].value)});
        if (!found.values[i].value.decimal) {
            result.notes.push_back({names[i], "between -" + found.values[i].value.bound + " and " +
                                                  found.values[i].value.bound + ", which is not distinguished from 0"});
        }
    }
    result.missing = found.missing;
    return result;
}

// The eigenvalue near the value that the problem has, the lowest one without a first guess.
answer well_found(const problem& of, const std::string& energy, const std::vector<std::string>& conditions,
                  const request& how, bool without_guess) {
    ode::eigenvalue_question question{of.equations(), energy, read_limits(of, conditions), 1, {}, how.printed_digits()};
    if (!without_guess) {
        const precision_scope scope(40);
        question.near =
            midpoint_of(ode::constant_value<ball>::of(ode::number_with_values(ode::parameter(energy), of.equations())))
                .convert_to<double>();
    }
    return answer_of(eigenvalues_by(question, how), {energy});
}

answer found_at_infinity(const problem& of, const std::vector<std::string>& unknowns,
                         const std::vector<std::string>& conditions, const request& how,
                         const std::vector<std::string>& without_guess) {
    if (std::ranges::all_of(conditions, is_at_infinity) && ode::is_well(of.equations(), unknowns)) {
        return well_found(of, unknowns.front(), conditions, how, !without_guess.empty());
    }
    if (conditions.size() > 1 || !is_decided_by_lemma(of.equations(), unknowns, conditions.front())) {
        return connection_found(of, unknowns, conditions, how, without_guess);
    }
    if (how.check) {
        throw error(error_kind::argument, error_subject::check, "",
                    "compares two proofs, and this condition at infinity has only one, by a lemma: leave it out");
    }
    return found_by(how, [&](long digits, const ode::proof_route& /*route*/) {
        return found_for_infinity(of, unknowns, conditions.front(), digits);
    });
}

void require_distinct(const std::vector<std::string>& unknowns) {
    for (auto each = unknowns.begin(); each != unknowns.end(); ++each) {
        if (std::find(unknowns.begin(), each, *each) != each) {
            throw error(error_kind::argument, error_subject::unknowns, *each, "is given twice: give it once");
        }
    }
}

ode::conditions_at_times read_conditions(const problem& of, const std::vector<std::string>& conditions) {
    ode::conditions_at_times all;
    for (const std::string& each : conditions) {
        about(error_subject::conditions, [&] { ode::add_condition(all, of.equations(), each); });
    }
    return all;
}

void require_as_many(const std::vector<std::string>& conditions, const std::vector<std::string>& unknowns) {
    if (conditions.size() != unknowns.size()) {
        throw error(error_kind::argument, "number of conditions", std::to_string(conditions.size()),
                    "is not that of the unknowns, " + std::to_string(unknowns.size()));
    }
}

std::string name_of_point(ode::branch_point_kind kind) {
    switch (kind) {
        case ode::branch_point_kind::solution: return "solution";
        case ode::branch_point_kind::turning_point: return "turning point";
    }
    throw std::logic_error("a kind of point without a name");
}

std::string reason_of_end(ode::branch_end end, const std::string& where) {
    switch (end) {
        case ode::branch_end::left: return "leaves the range at " + where;
        case ode::branch_end::closed: return "is closed: it returns to its first point";
        case ode::branch_end::no_more: return "is followed up to " + where + ", without a point in the last steps";
        case ode::branch_end::not_continued: return "cannot be continued beyond " + where;
    }
    throw std::logic_error("an end without a reason");
}

std::optional<error> reason_of_missing(const ode::branch_result& result) {
    if (!result.unproved.empty()) {
        return error(error_kind::undecided, "branch", "",
                     "has points that are not proved, " + std::to_string(result.unproved.size()) + "; the first is " +
                         result.unproved.front());
    }
    if (result.end == ode::branch_end::not_continued) {
        return error(error_kind::undecided, "branch", "", reason_of_end(result.end, result.where));
    }
    return std::nullopt;
}

answer branch_by(const ode::branch_question& question, const request& how, const ode::proof_route& route) {
    answer result{.names = {"point", question.parameter}, .rows = {}, .rigour = "proved"};
    result.names.insert(result.names.end(), question.unknowns.begin(), question.unknowns.end());
    const auto add = [&](const ode::branch_point& point) {
        auto& row = result.rows.emplace_back();
        row.push_back(text_value(name_of_point(point.kind)));
        std::ranges::transform(point.values, std::back_inserter(row), value_in_answer);
        if (how.progress) {
            how.progress(0);  // the number of points is not known
        }
    };
    try {
        const auto branch = ode::follow_branch(question, add, route, watch_of(how));
        result.notes.push_back({"end", reason_of_end(branch.end, branch.where)});
        result.missing = reason_of_missing(branch);
    } catch (const error& problem) {
        if (problem.kind() != error_kind::undecided || result.rows.empty()) {
            throw;
        }
        result.missing = problem;
    }
    return result;
}

// Throws std::runtime_error if the points of two proofs disagree.
void require_same_points(const answer& first, const answer& second) {
    if (first.rows.size() != second.rows.size()) {
        throw std::runtime_error(
            "the two proofs disagree on the number of points: " + std::to_string(first.rows.size()) +
            " by the first, " + std::to_string(second.rows.size()) + " by the second");
    }
    for (std::size_t i = 0; i < first.rows.size(); ++i) {
        for (std::size_t k = 1; k < first.names.size(); ++k) {
            const auto enclosure = [](const answer_value& x) {
                return proved_decimal{x.text.empty() ? "0" : x.text, x.bound};
            };
            require_agreement(enclosure(first.rows[i][k]), enclosure(second.rows[i][k]), first.names[k]);
        }
    }
}

std::optional<ode::number> period_in(const std::string& typed) {
    if (typed.empty()) {
        return std::nullopt;
    }
    const ode::number period = ode::parse_constant(typed).constant();
    if (period.sign() <= 0) {
        throw error(error_kind::argument, "period", typed,
                    "is not positive: give a time after which the orbit returns");
    }
    return period;
}

// A bound is kept as 0 with that uncertainty.
found_values values_of_orbit(const ode::periodic_orbit& orbit) {
    found_values found{orbit.names, orbit.start};
    found.names.emplace_back("period");
    found.values.push_back(orbit.period);
    const auto add = [&](const std::string& name, const known_value& value) {
        found.names.push_back(name);
        found.values.push_back(value.decimal ? *value.decimal : proved_decimal{"0", value.bound});
    };
    for (std::size_t k = 0; k < orbit.multipliers.size(); ++k) {
        const auto& each = orbit.multipliers[k];
        const std::string name = "multiplier " + std::to_string(k + 1);
        add(each.is_real ? name : name + ", real part", each.real);
        if (!each.is_real) {
            add(name + ", imaginary part", each.imaginary);
        }
    }
    return found;
}

std::string joined_by_commas(const std::vector<std::string>& names) {
    std::string all;
    for (const std::string& each : names) {
        all += (all.empty() ? "" : ", ") + each;
    }
    return all;
}

std::string text_of_stability(const ode::periodic_orbit& orbit) {
    switch (orbit.stability) {
        case ode::orbit_stability::attracting:
            return "asymptotically stable: all multipliers but one are less than 1 in absolute value";
        case ode::orbit_stability::on_circle:
            return "linearly stable up to the multipliers that are exactly 1: all others are simple and of absolute "
                   "value 1; stability of the nonlinear equations does not follow";
        case ode::orbit_stability::unstable: return "unstable: a multiplier is greater than 1 in absolute value";
        case ode::orbit_stability::undecided: break;
    }
    return "not decided by the multipliers";
}

// Nothing for an isolated orbit without further questions.
std::vector<answer_note> notes_of_orbit(const ode::periodic_orbit& orbit, const ode::orbit_question& question) {
    std::vector<answer_note> notes;
    if (!orbit.held.empty()) {
        notes.push_back({"given", "the orbit is one of a family; kept as given: " + joined_by_commas(orbit.held)});
    }
    if (orbit.by_reversal) {
        notes.push_back({"symmetry", "proved at half the period, by a reversal of time"});
    }
    for (const std::string& each : orbit.integrals) {
        notes.push_back({"integral", each});
    }
    if (notes.empty() && !question.multipliers && !question.period) {
        return notes;
    }
    notes.push_back({"period", orbit.is_shortest_period ? "no shorter time is a period"
                                                        : "whether a shorter time is a period is not proved"});
    for (std::size_t k = 0; k < orbit.multipliers.size(); ++k) {
        if (!orbit.multipliers[k].reason.empty()) {
            notes.push_back({"multiplier " + std::to_string(k + 1), "exactly 1, by " + orbit.multipliers[k].reason});
        }
    }
    if (question.multipliers) {
        notes.push_back({"stability", text_of_stability(orbit)});
    }
    return notes;
}

}  // namespace

answer find_branch(const problem& of, const std::vector<std::string>& unknowns,
                   const std::vector<std::string>& conditions, const branch_values& along, const request& how) {
    auto names = unknowns;
    names.push_back(along.parameter);
    require_distinct(names);
    require_as_many(conditions, unknowns);
    if (!along.values.empty()) {
        about(error_subject::along,
              [&] { return ode::changed(of.equations(), along.parameter + " = " + along.values.front()); });
    }
    ode::branch_question question{of.equations(),  unknowns,     read_conditions(of, conditions),
                                  along.parameter, along.values, how.printed_digits()};
    const auto checked = checked_products(how.check);
    answer found = about(error_subject::unknowns, [&] { return branch_by(question, how, {}); });
    if (how.check && !found.missing) {
        question.digits += ode::more_digits_of_second_proof;
        require_same_points(found, branch_by(question, how, ode::proof_route::second()));
    }
    return found;
}

answer find_unknowns(const problem& of, const std::vector<std::string>& unknowns,
                     const std::vector<std::string>& conditions, const request& how,
                     const std::vector<std::string>& without_guess) {
    require_distinct(unknowns);
    if (std::ranges::any_of(conditions, is_at_infinity)) {
        return found_at_infinity(of, unknowns, conditions, how, without_guess);
    }
    require_as_many(conditions, unknowns);
    const auto read = read_conditions(of, conditions);
    return found_by(how, [&](long digits, const ode::proof_route& route) {
        return found_values{unknowns, about(error_subject::unknowns, [&] {
                                return ode::proved_unknowns(of.equations(), unknowns, read, digits, route,
                                                            watch_of(how));
                            })};
    });
}

answer find_eigenvalues(const problem& of, const std::string& energy, const std::vector<std::string>& limits,
                        long count, const request& how) {
    const auto found =
        eigenvalues_by({of.equations(), energy, read_limits(of, limits), count, {}, how.printed_digits()}, how);
    std::vector<std::string> names;
    for (const auto& each : found.values) {
        names.push_back(energy + "_" + std::to_string(each.index));
    }
    return answer_of(found, names);
}

std::vector<std::string> homoclinic_conditions(const problem& of) {
    return ode::homoclinic_limits(ode::explicit_system(of.equations()));
}

answer find_periodic_orbit(const problem& of, const request& how, const orbit_options& options) {
    const ode::explicit_system system(of.equations());
    ode::orbit_question question{how.printed_digits(), period_in(options.period), options.multipliers};
    std::optional<ode::periodic_orbit> first;
    answer result = found_by(how, [&](long digits, const ode::proof_route& route) {
        question.digits = digits;
        const auto orbit = ode::proved_periodic_orbit(system, question, route, watch_of(how));
        if (!first) {
            first = orbit;
        }
        return values_of_orbit(orbit);
    });
    for (auto& row : result.rows) {
        if (row.back().text == "0" && row.back().bound != "0") {
            row.back().text = "";  // only a bound is known
        }
    }
    result.notes = notes_of_orbit(*first, question);
    return result;
}

}  // namespace libration
