#include "libration/problem/find.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <stdexcept>

#include "../query/connection/homoclinic_limits.hpp"
#include "connection_notes.hpp"
#include "found_eigenvalues.hpp"
#include "found_values.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/problem/known_facts.hpp"
#include "libration/problem/proved_answer.hpp"
#include "libration/query/connection/connection.hpp"
#include "libration/query/shooting/proved_unknowns.hpp"
#include "libration/query/shooting/solution_branch.hpp"
#include "libration/query/well/eigenvalues.hpp"

namespace libration {

namespace {

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
        notes = notes_of(found);
        for (const ode::connection_number& each : found.more) {
            notes.push_back({each.name, each.value.text, each.kind});
        }
        return found_values{unknowns, found.values};
    });
    result.notes = std::move(notes);
    return result;
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

std::vector<std::string> homoclinic_conditions(const problem& of) {
    return ode::homoclinic_limits(ode::explicit_system(of.equations()));
}

}  // namespace libration
