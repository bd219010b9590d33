#include "differentiated_numbers.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "libration/equation/text/parse.hpp"

namespace libration::ode {

namespace {

[[noreturn]] void refuse_unknown_number(const std::string& name) {
    refuse_derivative(name, "is neither a parameter nor an initial value of the problem: choose one that is");
}

// x'(0) as the name x' of the value that starts there.
std::string name_of_start_at(const equation_system& given, const number& point, const std::string& typed) {
    try {
        const start read = parse_value_at_time(given, typed);
        if ((read.point.constant() - point).sign() == 0) {
            return primed(read.of.name(), read.of.derivative());
        }
    } catch (const error&) {
        refuse_unknown_number(typed);
    }
    refuse_unknown_number(typed);
}

// The first of these names on which the value of a parameter depends, by way of others too.
std::optional<std::string> dependence_on(const equation_system& given, const std::string& name,
                                         const std::vector<std::string>& names) {
    std::set<std::string> seen{name};
    std::vector<std::string> open{name};
    while (!open.empty()) {
        const definition* const next = given.parameter_of(open.back());
        open.pop_back();
        if (next == nullptr) {
            continue;
        }
        std::optional<std::string> found;
        each_leaf(next->value, [&](const expression& leaf) {
            if (leaf.kind() == node_kind::parameter && seen.insert(leaf.name()).second) {
                open.push_back(leaf.name());
                if (std::ranges::find(names, leaf.name()) != names.end()) {
                    found = leaf.name();
                }
            }
        });
        if (found) {
            return found;
        }
    }
    return std::nullopt;
}

}  // namespace

void require_independent(const equation_system& given, const std::vector<std::string>& parameters) {
    for (const std::string& each : parameters) {
        if (const auto other = dependence_on(given, each, parameters)) {
            refuse_derivative(each,
                              "depends on " + *other +
                                  ", so that the derivative by one of them does not hold the other fixed: ask for "
                                  "one at a time");
        }
    }
}

void refuse_derivative(const std::string& name, const std::string& reason) {
    throw error(error_kind::argument, error_subject::derivatives, name, reason);
}

differentiated_numbers::differentiated_numbers(const equation_system& given, const std::vector<std::string>& state,
                                               const number& point, const std::vector<std::string>& numbers) {
    for (auto each = numbers.begin(); each != numbers.end(); ++each) {
        if (std::find(numbers.begin(), each, *each) != each) {
            refuse_derivative(*each, "is given twice: give it once");
        }
        if (each->find('(') == std::string::npos) {
            columns.push_back({false, parameters.size()});
            parameters.push_back(*each);
            continue;
        }
        const auto found = std::ranges::find(state, name_of_start_at(given, point, *each));
        if (found == state.end()) {
            refuse_unknown_number(*each);
        }
        columns.push_back({true, static_cast<std::size_t>(found - state.begin())});
    }
    require_independent(given, parameters);
}

}  // namespace libration::ode
