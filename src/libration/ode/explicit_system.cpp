#include "libration/ode/explicit_system.hpp"

#include <algorithm>
#include <map>
#include <unordered_set>
#include <utility>

#include "libration/ode/dependency.hpp"
#include "libration/scalar/error.hpp"
#include "linear_solution.hpp"
#include "singular_form.hpp"
#include "start_values.hpp"

namespace libration::ode {

namespace {

// The highest derivative of each unknown in the equations.
std::map<std::string, int> orders_of(const std::vector<equation>& equations) {
    std::map<std::string, int> orders;
    std::unordered_set<const void*> done;
    const auto note = [&](const expression& leaf) {
        if (leaf.kind() == node_kind::unknown) {
            int& order = orders[leaf.name()];
            order = std::max(order, leaf.derivative());
        }
    };
    for (const equation& each : equations) {
        each_leaf(each.left, done, note);
        each_leaf(each.right, done, note);
    }
    return orders;
}

number constant_of(const expression& e, const equation_system& given) { return with_values(e, given).constant(); }

// Calls what throws with the number alone, and says whose number it is.
template <class Operation>
auto named(const std::string& name, const place& at, const Operation& operation) {
    try {
        return operation();
    } catch (const error& problem) {
        if (problem.subject() == "problem") {
            throw;
        }
        refuse(name, at, problem.reason());
    }
}

bool same_number(const number& a, const number& b) {
    const auto difference = (a - b).plain();
    return difference && difference->coefficient == 0;
}

}  // namespace

explicit_system::explicit_system(const equation_system& given) : variable_(given.variable) {
    read_unknowns(given);
    read_starts(given);
    start_values values(leaves_at_start(*this));
    std::vector<equation> equations;
    for (const equation& each : given.equations) {
        named("equation", each.at, [&] {
            equations.push_back({with_values(each.left, given), with_values(each.right, given), each.at});
            return 0;
        });
    }
    std::vector<expression> targets;
    for (const unknown_function& each : unknowns_) {
        targets.push_back(unknown(each.name, each.order));
    }
    right_ = linear_solution(equations, targets, [&](const expression& c) {
        return !values.refusal_of(c) && values.value_of(c).sign() != 0;
    });
    for (std::size_t i = 0; i < right_.size(); ++i) {
        const auto reason = values.refusal_of(right_[i]);
        if (!reason) {
            continue;
        }
        singular_ = singular_form(unknowns_, right_, point_, values);
        if (!singular_) {
            refuse(primed(unknowns_[i].name, unknowns_[i].order), {},
                   "has no value at the start, for its right side " + *reason + ": choose another start");
        }
        break;
    }
    for (const equation& each : given.invariants) {
        invariants_.push_back(with_values(each.left, given));
    }
    for (const definition& each : given.exact) {
        exact_.push_back({each.name, with_values(each.value, given), each.at});
    }
}

explicit_system explicit_system::first_order(const std::vector<expression>& unknowns, std::vector<expression> right,
                                             const number& point) {
    explicit_system result;
    for (const expression& each : unknowns) {
        result.unknowns_.push_back({each.name(), 1});
    }
    result.right_ = std::move(right);
    result.point_ = point;
    return result;
}

void explicit_system::read_unknowns(const equation_system& given) {
    const auto orders = orders_of(given.equations);
    for (const std::string& name : given.unknowns()) {
        const int order = orders.at(name);
        if (order == 0) {
            refuse(name, {}, "occurs without a derivative: add an equation for " + name + "'");
        }
        unknowns_.push_back({name, order});
    }
    if (unknowns_.empty()) {
        refuse("", {}, "has no unknown: write an equation with a derivative, as y' = y");
    }
    if (given.equations.size() != unknowns_.size()) {
        std::string names;
        for (const unknown_function& each : unknowns_) {
            names += (names.empty() ? "" : ", ") + each.name;
        }
        refuse("", {},
               "has " + std::to_string(given.equations.size()) + " equations for " + std::to_string(unknowns_.size()) +
                   " unknowns (" + names + "): give as many of both");
    }
}

void explicit_system::read_starts(const equation_system& given) {
    const start* first = nullptr;
    std::vector<std::vector<std::optional<number>>> found;
    for (const unknown_function& each : unknowns_) {
        found.emplace_back(static_cast<std::size_t>(each.order));
    }
    for (const start& each : given.starts) {
        const std::string name = primed(each.of.name(), each.of.derivative());
        const number at = named(name, each.at, [&] { return constant_of(each.point, given); });
        if (first != nullptr && !same_number(at, point_)) {
            refuse(name, each.at,
                   "starts at another point than " + primed(first->of.name(), first->of.derivative()) +
                       ": give all starts at one point");
        }
        first = first == nullptr ? &each : first;
        point_ = at;
        const auto which = std::ranges::find(unknowns_, each.of.name(), &unknown_function::name);
        if (which == unknowns_.end()) {
            refuse(name, each.at, "is a start of no unknown: leave it out");
        }
        auto& of_unknown = found[static_cast<std::size_t>(which - unknowns_.begin())];
        const auto order = static_cast<std::size_t>(each.of.derivative());
        if (order >= of_unknown.size()) {
            refuse(name, each.at, "has no start of its own, for the equations give it: leave it out");
        }
        if (of_unknown[order]) {
            refuse(name, each.at, "has two starts: give it one");
        }
        of_unknown[order] = named(name, each.at, [&] { return constant_of(each.value, given); });
    }
    for (std::size_t i = 0; i < unknowns_.size(); ++i) {
        auto& values = starts_.emplace_back();
        for (std::size_t j = 0; j < found[i].size(); ++j) {
            if (!found[i][j]) {
                const std::string name = primed(unknowns_[i].name, static_cast<int>(j));
                refuse(name, {}, "has no start: add " + name + "(0) = number");
            }
            values.push_back(*found[i][j]);
        }
    }
}

}  // namespace libration::ode
