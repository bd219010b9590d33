#include "start_values.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#include "libration/function/list.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

[[noreturn]] void refuse_value(const std::string& reason) {
    throw error(error_kind::argument, error_subject::number, "", reason);
}

bool is_zero(const number& x) { return x.sign() == 0; }

bool is_whole(const number& x) {
    const auto q = x.fraction();
    return q && denominator(*q) == 1;
}

}  // namespace

// The values are in the domains, or folding would have thrown; only branch points remain to be checked.
void start_values::require_analytic(const expression& e, const number& argument) {
    if (e.kind() == node_kind::power) {
        const number& exponent = e.right().constant();
        if (!is_whole(exponent) && is_zero(argument)) {
            refuse_value("takes a non-integer power of 0");
        }
        return;
    }
    if (e.kind() != node_kind::function) {
        return;
    }
    const function::singular_points singular =
        function::with_function(e.function(), [](auto of) { return function::singular_points(of.singular); });
    for (int i = 0; i < singular.count; ++i) {
        const number distance = argument - number(rational(singular.points[static_cast<std::size_t>(i)]));
        if (is_zero(distance)) {
            refuse_value(singular.reason);
        }
    }
}

number start_values::of_leaf(const expression& leaf) const {
    const auto value = of_leaf_(leaf);
    if (!value) {
        refuse_value("has no value");
    }
    return *value;
}

number start_values::of_operation(const expression& e) const {
    if (e.kind() == node_kind::power && e.left().kind() == node_kind::parameter && e.right().constant().sign() > 0) {
        return {};  // s^r, which represents a power of the series' variable
    }
    const number& left = done_.at(e.left());
    require_analytic(e, left);
    switch (e.kind()) {
        case node_kind::sum: return left + done_.at(e.right());
        case node_kind::product: return left * done_.at(e.right());
        case node_kind::quotient: return left / done_.at(e.right());
        case node_kind::power: return power(left, e.right().constant());
        case node_kind::function: return with_argument(e, expression(left)).constant();
        case node_kind::constant:
        case node_kind::variable:
        case node_kind::unknown:
        case node_kind::parameter: break;
    }
    throw std::logic_error("a leaf is not an operation");
}

number start_values::computed(const expression& e) const {
    switch (e.kind()) {
        case node_kind::constant: return e.constant();
        case node_kind::variable:
        case node_kind::unknown:
        case node_kind::parameter: return of_leaf(e);
        case node_kind::sum:
        case node_kind::product:
        case node_kind::quotient:
        case node_kind::power:
        case node_kind::function: break;
    }
    return of_operation(e);
}

number start_values::value_of(const expression& e) {
    return done_.of(e, [this](const expression& each) { return computed(each); });
}

std::optional<std::string> start_values::refusal_of(const expression& e) {
    try {
        value_of(e);
        return std::nullopt;
    } catch (const error& problem) {
        return problem.reason();
    }
}

leaf_value leaves_at_start(const explicit_system& of) {
    return [&of, places = places_of(of.unknowns())](const expression& leaf) -> std::optional<number> {
        if (leaf.kind() == node_kind::variable) {
            return of.point();
        }
        if (leaf.kind() == node_kind::parameter) {
            return number();  // s
        }
        const auto& of_unknown = of.starts()[places.at(leaf.name())];
        const auto order = static_cast<std::size_t>(leaf.derivative());
        return order < of_unknown.size() ? std::optional(of_unknown[order]) : std::nullopt;
    };
}

void refuse_second_start(const equation_system& given, const expression& of) {
    std::vector<place> places;
    for (const start& each : given.starts) {
        if (same_form(each.of, of)) {
            places.push_back(each.at);
        }
    }
    const std::string first = places.at(0).line == 0 ? ""
                                                     : ", the first one at line " + std::to_string(places.at(0).line) +
                                                           ", column " + std::to_string(places.at(0).column);
    refuse(primed(of.name(), of.derivative()), places.at(1), "has two initial values" + first + ": give it only one");
}

}  // namespace libration::ode
