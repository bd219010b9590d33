#include "libration/equation/explicit_system.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "consistent_initial_values.hpp"
#include "index_reduction.hpp"
#include "libration/equation/defined_zero.hpp"
#include "libration/equation/node_values.hpp"
#include "libration/function/elementary/log.hpp"
#include "libration/scalar/error.hpp"
#include "removable_singularity.hpp"
#include "singular_form.hpp"
#include "smooth_equations.hpp"
#include "start_values.hpp"

namespace libration::ode {

namespace {

constexpr std::size_t most_named_unknowns = 8;

// The highest derivative of each unknown in the equations.
std::map<std::string, int> orders_of(const std::vector<equation>& equations) {
    std::map<std::string, int> orders;
    for (const equation& each : equations) {
        for (const expression* side : {&each.left, &each.right}) {
            each_leaf(*side, [&](const expression& leaf) {
                if (leaf.kind() == node_kind::unknown) {
                    int& order = orders[leaf.name()];
                    order = std::max(order, leaf.derivative());
                }
            });
        }
    }
    return orders;
}

// Calls an operation whose errors refer only to a number, and adds the name of the quantity to them.
template <class Operation>
auto named(const std::string& name, const place& at, const Operation& operation) {
    try {
        return operation();
    } catch (const error& problem) {
        if (problem.is_about(error_subject::problem)) {
            throw;
        }
        refuse(name, at, problem.reason() + (problem.is_about(error_subject::number) ? ": choose other numbers" : ""));
    }
}

// Whether x^y with an exponent that is not constant occurs, which is exp(y*log(x)).
bool has_written_power(const expression& e) {
    bool found = false;
    node_values<bool> done;
    done.of(e, [&](const expression& node) {
        const bool is_exponential = node.kind() == node_kind::function && node.function() == function_kind::exp &&
                                    node.left().kind() == node_kind::product;
        const auto is_logarithm = [](const expression& factor) {
            return factor.kind() == node_kind::function && factor.function() == function_kind::log;
        };
        found = found || (is_exponential && is_logarithm(node.left().right()));
        return found;
    });
    return found;
}

// The two sides with values of the parameters. Throws error about a number.
equation with_values_in(const equation& given, parameter_values& parameters) {
    try {
        return {with_removed_singularities(parameters.in(given.left)),
                with_removed_singularities(parameters.in(given.right)), given.at};
    } catch (const error& problem) {
        if (problem.is_about(error_subject::number) && problem.reason() == function::log_function::refusal &&
            (has_written_power(given.left) || has_written_power(given.right))) {
            throw error(problem.kind(), error_subject::number, "",
                        problem.reason() + " (x^y with an exponent that is not constant is exp(y*log(x)))");
        }
        throw;
    }
}

bool same_number(const number& a, const number& b) {
    const auto difference = (a - b).plain();
    return difference && difference->coefficient == 0;
}

}  // namespace

std::map<std::string, std::size_t> places_of(const std::vector<unknown_function>& unknowns) {
    std::map<std::string, std::size_t> places;
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        places.emplace(unknowns[i].name, i);
    }
    return places;
}

explicit_system::explicit_system(const equation_system& given) : variable_(given.variable) {
    require_smooth_equations(given);
    require_numbers(given);
    parameter_values parameters(given);
    read_unknowns(given);
    read_starts(given, parameters);
    std::vector<equation> equations;
    for (const equation& each : given.equations) {
        equations.push_back(named("equation", each.at, [&] { return with_values_in(each, parameters); }));
    }
    read_equations(equations);
    for (const equation& each : given.invariants) {
        invariants_.push_back(parameters.in(each.left));
    }
    for (const definition& each : given.exact) {
        exact_.push_back({each.name, parameters.in(each.value), each.at});
    }
}

void explicit_system::read_equations(const std::vector<equation>& equations) {
    std::vector<expression> highest;
    for (const unknown_function& each : unknowns_) {
        highest.push_back(unknown(each.name, each.order));
    }
    std::vector<equation> folded;
    for (const equation& each : equations) {
        folded.push_back({without_zeros(each.left), without_zeros(each.right), each.at});
    }
    const auto reduced_by = [&](start_values values) {
        return reduced(folded, highest,
                       [&](const expression& c) { return !values.refusal_of(c) && values.value_of(c).sign() != 0; });
    };
    reduced_system found = reduced_by(start_values(leaves_at_start(*this)));
    if (complete_starts(unknowns_, point_, found.algebraic, starts_)) {
        found = reduced_by(start_values(leaves_at_start(*this)));
    }
    right_ = std::move(found.right);
    keep_domain(equations, found.divisors);
    start_values values(leaves_at_start(*this));
    require_consistent(found.algebraic, values);
    std::ranges::transform(found.algebraic, std::back_inserter(algebraic_), &algebraic_equation::zero);
    for (std::size_t i = 0; i < right_.size(); ++i) {
        const auto reason = values.refusal_of(right_[i]);
        if (!reason) {
            continue;
        }
        singular_ = algebraic_.empty() ? singular_form(unknowns_, right_, point_, values) : std::nullopt;
        if (!singular_) {
            refuse(primed(unknowns_[i].name, unknowns_[i].order), {},
                   "cannot be expanded about the initial point, because its right-hand side " + *reason +
                       ": choose another initial point");
        }
        break;
    }
    // t z y' = 1 with z(0) = 1 is singular; z w' = 0 with z(0) = 0 does not determine w if z = 0 for all times.
    if (!std::ranges::all_of(found.doubtful,
                             [&](const expression& c) { return has_isolated_zero(c, point_, values); })) {
        refuse("", {},
               "has a coefficient of a highest derivative that is not proved nonzero at the initial point: choose "
               "another initial point, or equations that determine the highest derivatives");
    }
}

// The right-hand sides are undefined where the equations are, or where a divisor is 0: parts that the solution for the
// highest derivatives has removed are added to that of an unknown of the same equation, as unfolded zeros.
void explicit_system::keep_domain(const std::vector<equation>& equations, const std::vector<divisor>& divisors) {
    const auto places = places_of(unknowns_);
    const std::vector<expression> solved = right_;
    const auto keep = [&](const std::vector<expression>& parts, std::size_t place) {
        for (const expression& each : parts) {
            right_[place] = right_[place] + zero_where_defined(each);
        }
    };
    for (std::size_t i = 0; i < equations.size(); ++i) {
        const equation& each = equations[i];
        const auto lost = parts_lost({each.left, each.right}, {}, solved);
        std::optional<std::size_t> place;
        const auto look = [&](const expression& leaf) {
            if (leaf.kind() == node_kind::unknown) {
                const std::size_t here = places.at(leaf.name());
                const bool highest = leaf.derivative() == unknowns_[here].order;
                place = highest ? std::min(here, place.value_or(here)) : place;
            }
        };
        if (!lost.empty()) {
            each_leaf(each.left, look);
            each_leaf(each.right, look);
            keep(lost, place.value_or(i));
        }
    }
    start_values values(leaves_at_start(*this));
    for (const auto& [target, by] : divisors) {
        if (!values.refusal_of(1 / by)) {  // otherwise its zero at the initial point has to be isolated
            keep(parts_lost({1 / by}, {}, solved), target);
        }
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
        unknowns_.push_back({name, std::max(orders.at(name), 1)});
    }
    if (unknowns_.empty()) {
        refuse("", {}, "has no unknown: write an equation with a derivative, as y' = y");
    }
    if (given.equations.size() != unknowns_.size()) {
        std::string names;
        for (std::size_t i = 0; i < std::min(unknowns_.size(), most_named_unknowns); ++i) {
            names += (i == 0 ? "" : ", ") + unknowns_[i].name;
        }
        names += unknowns_.size() > most_named_unknowns ? ", ..." : "";
        refuse("", {},
               "has " + std::to_string(given.equations.size()) + " equations for " + std::to_string(unknowns_.size()) +
                   " unknowns (" + names + "): give the same number of both");
    }
}

void explicit_system::read_starts(const equation_system& given, parameter_values& parameters) {
    const start* first = nullptr;
    const auto orders = orders_of(given.equations);
    const auto places = places_of(unknowns_);
    std::vector<std::vector<std::optional<number>>> found;
    for (const unknown_function& each : unknowns_) {
        found.emplace_back(static_cast<std::size_t>(each.order));
    }
    for (const start& each : given.starts) {
        const std::string name = primed(each.of.name(), each.of.derivative());
        const number at = named(name, each.at, [&] { return parameters.number_of(each.point); });
        if (first != nullptr && !same_number(at, point_)) {
            refuse(name, each.at,
                   "has another initial point than " + primed(first->of.name(), first->of.derivative()) +
                       ": give all initial values at one point, or leave out the condition elsewhere and solve for an "
                       "initial value with `libration find --such-that`");
        }
        first = first == nullptr ? &each : first;
        point_ = at;
        const auto which = places.find(each.of.name());
        if (which == places.end()) {
            refuse(name, each.at, "is not an initial value of an unknown: leave it out");
        }
        auto& of_unknown = found[which->second];
        const auto order = static_cast<std::size_t>(each.of.derivative());
        if (order >= of_unknown.size()) {
            refuse(name, each.at, "is the highest derivative, and no initial value of the state: leave it out");
        }
        if (of_unknown[order]) {
            refuse_second_start(given, each.of);
        }
        of_unknown[order] = named(name, each.at, [&] { return parameters.number_of(each.value); });
    }
    for (std::size_t i = 0; i < unknowns_.size(); ++i) {
        auto& values = starts_.emplace_back();
        for (std::size_t j = 0; j < found[i].size(); ++j) {
            if (found[i][j]) {
                values.push_back(*found[i][j]);
            } else if (orders.at(unknowns_[i].name) > 0) {
                const std::string name = primed(unknowns_[i].name, static_cast<int>(j));
                refuse(name, {}, "has no initial value: add " + name + "(0) = number");
            }
        }
    }
}

std::vector<std::string> names_of_state(const explicit_system& system) {
    std::vector<std::string> names;
    for (const unknown_function& each : system.unknowns()) {
        for (int j = 0; j < each.order; ++j) {
            names.push_back(primed(each.name, j));
        }
    }
    return names;
}

}  // namespace libration::ode
