#include "libration/problem/find.hpp"

#include <algorithm>
#include <cstddef>

#include "libration/digits/proved/two_proofs.hpp"
#include "libration/ode/parse.hpp"
#include "libration/ode/proved/proved_root.hpp"
#include "libration/problem/known_facts.hpp"

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
auto about(const char* subject, const Work& work) {
    try {
        return work();
    } catch (const error& problem) {
        if (problem.kind() != error_kind::argument || problem.subject() != "problem") {
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
    return {unknowns,
            about("conditions", [&] { return proved_for_infinity(of.equations(), unknowns, condition, digits); })};
}

void require_distinct(const std::vector<std::string>& unknowns) {
    for (auto each = unknowns.begin(); each != unknowns.end(); ++each) {
        if (std::find(unknowns.begin(), each, *each) != each) {
            throw error(error_kind::argument, "unknowns", *each, "is given twice: give it once");
        }
    }
}

std::vector<ode::point_condition> read_conditions(const problem& of, const std::vector<std::string>& conditions) {
    std::vector<ode::point_condition> all;
    for (const std::string& each : conditions) {
        const ode::start read = about("conditions", [&] { return ode::parse_point_condition(of.equations(), each); });
        all.push_back({read.of.name(), read.of.derivative(), read.point.constant(), read.value.constant()});
    }
    return all;
}

}  // namespace

answer find_unknowns(const problem& of, const std::vector<std::string>& unknowns,
                     const std::vector<std::string>& conditions, const request& how) {
    require_distinct(unknowns);
    const auto at_infinity = std::ranges::find_if(conditions, is_at_infinity);
    if (at_infinity != conditions.end()) {
        if (conditions.size() > 1) {
            throw error(error_kind::argument, "condition", *at_infinity,
                        "is at infinity, which is decided alone: give it without the others");
        }
        if (how.check) {
            throw error(error_kind::argument, "check", "",
                        "compares two proofs, and a condition at infinity has only one, by a lemma");
        }
        return found_by(how, [&](long digits, const ode::proof_route& /*route*/) {
            return found_for_infinity(of, unknowns, conditions.front(), digits);
        });
    }
    if (conditions.size() != unknowns.size()) {
        throw error(error_kind::argument, "number of conditions", std::to_string(conditions.size()),
                    "is not that of the unknowns, " + std::to_string(unknowns.size()));
    }
    const auto read = read_conditions(of, conditions);
    return found_by(how, [&](long digits, const ode::proof_route& route) {
        return found_values{unknowns, about("unknowns", [&] {
                                return ode::proved_unknowns(of.equations(), unknowns, read, digits, route,
                                                            watch_of(how));
                            })};
    });
}

answer find_periodic_orbit(const problem& of, const request& how) {
    const ode::explicit_system system(of.equations());
    return found_by(how, [&](long digits, const ode::proof_route& route) {
        auto orbit = ode::proved_periodic_orbit(system, digits, route, watch_of(how));
        orbit.names.emplace_back("period");
        orbit.start.push_back(orbit.period);
        return found_values{orbit.names, orbit.start};
    });
}

}  // namespace libration
