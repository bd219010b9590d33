#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>

#include "certificate_text.hpp"
#include "certified_root.hpp"
#include "libration/equation/parametric_system.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/problem/certificate.hpp"
#include "libration/query/shooting/periodic_orbit.hpp"

namespace libration {

namespace {

[[noreturn]] void refuse_root(const std::string& reason) {
    throw error(error_kind::argument, error_subject::certificate, "", reason + ": leave the certificate out");
}

std::size_t place_in_state(const ode::explicit_system& system, const std::string& name) {
    const auto names = ode::names_of_state(system);
    return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
}

bool contains_leaf(const ode::expression& in, const ode::expression& leaf) {
    bool found = false;
    each_leaf(in, [&](const ode::expression& each) {
        found = found || (each.kind() == ode::node_kind::unknown && each.name() == leaf.name());
    });
    return found;
}

// Numbers of a problem as initial values: a parameter becomes a constant unknown, unless it is an initial value and
// nothing else, as in f''(0) = k.
class unknown_numbers {
public:
    unknown_numbers(const ode::equation_system& equations, std::vector<std::string> names)
        : equations_(equations), names_(std::move(names)) {
        for (const std::string& each : names_) {
            const auto point = each.find('(');
            unknowns_.push_back(point == std::string::npos ? unknown_of_parameter(each) : each.substr(0, point));
        }
    }

    /// With these values, in the order of the names.
    ode::explicit_system system(const std::vector<rational>& values) const {
        ode::equation_system changed = equations_;
        for (std::size_t k = 0; k < names_.size(); ++k) {
            changed = ode::changed(changed, names_[k] + " = " + values[k].str());
        }
        return constants_.empty() ? ode::explicit_system(changed) : ode::opened(changed, constants_).system;
    }

    /// The unknown or lower derivative of which each is the initial value.
    const std::vector<std::string>& unknowns() const { return unknowns_; }

private:
    std::string unknown_of_parameter(const std::string& name) {
        const ode::parametric_system open = ode::opened(equations_, {name});
        const ode::expression& leaf = open.leaves.front();
        const auto state = ode::names_of_state(open.system);
        std::vector<std::size_t> others;
        for (std::size_t k = 0; k < open.starts.size(); ++k) {
            if (state[k] != name && contains_leaf(open.starts[k], leaf)) {
                others.push_back(k);
            }
        }
        if (others.empty()) {
            constants_.push_back(name);
            return name;
        }
        const bool in_equations = std::ranges::any_of(
            open.system.right(), [&](const ode::expression& right) { return contains_leaf(right, leaf); });
        if (others.size() > 1 || in_equations || !same_form(open.starts[others.front()], leaf)) {
            refuse_root("does not contain parameters on which an initial value depends, as on " + name);
        }
        return state[others.front()];
    }

    const ode::equation_system& equations_;
    std::vector<std::string> names_, unknowns_, constants_;
};

// f'(5) = 1: a value at a time.
struct value_at_time {
    std::string name;
    rational time, value;
};

value_at_time read_condition(const ode::equation_system& equations, const std::string& condition) {
    const std::string contained =
        "contains roots of conditions such as y(1) = 1/2, with fractions, and not of " + condition;
    try {
        const auto equals = condition.find('=');
        const ode::start left = ode::parse_value_at_time(equations, condition.substr(0, equals));
        const auto value =
            ode::parse_constant(condition.substr(equals == std::string::npos ? 0 : equals + 1)).fraction();
        const auto time = left.point.fraction();
        if (value && time) {
            return {ode::primed(left.of.name(), left.of.derivative()), *time, *value};
        }
    } catch (const error& problem) {
        if (problem.kind() != error_kind::argument) {
            throw;
        }
    }
    refuse_root(contained);
}

// The root with its unknowns in the order of the state.
certified_root in_order(const unknown_numbers& numbers, const std::vector<std::string>& decimals, long digits) {
    certified_root root;
    std::vector<ode::decimal_interval> intervals;
    std::vector<rational> middles;
    for (const std::string& each : decimals) {
        intervals.push_back(ode::within_one_unit(each, digits));
        middles.emplace_back((intervals.back().low + intervals.back().high) / 2);
    }
    const ode::explicit_system system = numbers.system(middles);
    std::vector<std::size_t> places;
    for (const std::string& each : numbers.unknowns()) {
        places.push_back(place_in_state(system, each));
    }
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t k) { return places[k]; });
    for (const std::size_t k : order) {
        root.places.push_back(places[k]);
        root.starts.push_back(intervals[k]);
    }
    root.system = [&numbers, order](const std::vector<rational>& values) {
        std::vector<rational> given(order.size());
        for (std::size_t k = 0; k < order.size(); ++k) {
            given[order[k]] = values[k];
        }
        return numbers.system(given);
    };
    return root;
}

}  // namespace

std::string certificate_of_root(const problem& of, const std::vector<std::string>& unknowns,
                                const std::vector<std::string>& conditions, const std::vector<std::string>& decimals,
                                const request& how, const certificate_notes& notes) {
    std::vector<value_at_time> ends;
    std::ranges::transform(conditions, std::back_inserter(ends),
                           [&](const std::string& each) { return read_condition(of.equations(), each); });
    const unknown_numbers numbers(of.equations(), unknowns);
    certified_root root = in_order(numbers, decimals, how.printed_digits());
    const ode::explicit_system system(of.equations());
    root.time = ends.front().time;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        if (ends[i].time != root.time) {
            refuse_root("contains conditions at one time, and " + conditions[i] + " is at another one than " +
                        conditions.front());
        }
        root.conditions.push_back({place_in_state(system, ends[i].name), ends[i].value});
    }
    return compressed_certificate(text_of_root(root, how), notes);
}

std::string certificate_of_orbit(const problem& of, const std::vector<std::string>& decimals, const request& how,
                                 const certificate_notes& notes) {
    const ode::explicit_system system(of.equations());
    if (ode::has_families_of_orbits(system)) {
        refuse_root("of a periodic orbit does not contain the theorem about its integrals, which this one needs");
    }
    const auto point = system.point().fraction();
    if (!point) {
        refuse_root("contains a fraction as initial time, and this one is another number");
    }
    const std::size_t held = ode::unknown_on_section(system);
    const auto state = ode::names_of_state(system);
    std::vector<std::string> names;
    std::vector<std::string> moved;
    for (std::size_t k = 0; k < state.size(); ++k) {
        if (k != held) {
            names.push_back(state[k] + "(" + point->str() + ")");
            moved.push_back(decimals[k]);
        }
    }
    const unknown_numbers numbers(of.equations(), names);
    certified_root root = in_order(numbers, moved, how.printed_digits());
    root.period = ode::within_one_unit(decimals.back(), how.printed_digits());
    root.period->low += *point;
    root.period->high += *point;
    for (std::size_t k = 0; k < state.size(); ++k) {
        root.conditions.push_back({k, std::nullopt});
    }
    return compressed_certificate(text_of_root(root, how), notes);
}

}  // namespace libration
