// What finds unknowns, orbits and eigenvalues has in common: progress, subjects of errors, second proofs.
#pragma once

#include <string>
#include <vector>

#include "libration/number/two_proofs.hpp"
#include "libration/problem/find.hpp"
#include "libration/problem/known_facts.hpp"
#include "libration/problem/proved_answer.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"

namespace libration {

struct found_values {
    std::vector<std::string> names;
    std::vector<proved_decimal> values;
};

/// Reports the progress of each integration.
inline ode::march_watch watch_of(const request& how) {
    return [&how](const ball& reached, long bits) {
        if (how.reached) {
            how.reached(midpoint_of(reached).convert_to<double>(), bits);
        }
    };
}

/// An error about the problem becomes one about the conditions or the unknowns, which caused it.
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

/// find(digits, route) once, or twice with a comparison.
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

}  // namespace libration
