#include "found_eigenvalues.hpp"

#include <algorithm>

#include "found_values.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/equation/text/limit_condition.hpp"
#include "libration/query/well/eigenvalues.hpp"

namespace libration {

namespace {

std::vector<ode::limit_condition> read_limits(const problem& of, const std::vector<std::string>& conditions) {
    std::vector<ode::limit_condition> limits;
    for (const std::string& each : conditions) {
        limits.push_back(about(error_subject::conditions, [&] { return ode::parse_limit(of.equations(), each); }));
        if (limits.back().amplitude) {
            throw error(error_kind::argument, error_subject::condition, each,
                        "has an amplitude, and eigenfunctions have any factor: leave it out");
        }
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

answer answer_of_eigenvalues(const ode::eigenvalues& found, const std::vector<std::string>& names) {
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

}  // namespace

answer well_found(const problem& of, const std::string& energy, const std::vector<std::string>& conditions,
                  const request& how, bool without_guess) {
    ode::eigenvalue_question question{of.equations(), energy, read_limits(of, conditions), 1, {}, how.printed_digits()};
    if (!without_guess) {
        const precision_scope scope(40);
        question.near =
            midpoint_of(ode::constant_value<ball>::of(ode::number_with_values(ode::parameter(energy), of.equations())))
                .convert_to<double>();
    }
    return answer_of_eigenvalues(eigenvalues_by(question, how), {energy});
}

answer find_eigenvalues(const problem& of, const std::string& energy, const std::vector<std::string>& limits,
                        long count, const request& how) {
    const auto found =
        eigenvalues_by({of.equations(), energy, read_limits(of, limits), count, {}, how.printed_digits()}, how);
    std::vector<std::string> names;
    for (const auto& each : found.values) {
        names.push_back(energy + "_" + std::to_string(each.index));
    }
    return answer_of_eigenvalues(found, names);
}

}  // namespace libration
