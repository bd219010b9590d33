#include "limits_of_unknowns.hpp"

#include <algorithm>
#include <utility>

#include "../query/connection/enclosed_decimal.hpp"
#include "../query/connection/marched_states.hpp"
#include "libration/scalar/ball/decimal.hpp"

namespace libration {

namespace {

ode::parametric_system opened_with_limits(const ode::equation_system& of, const std::vector<std::string>& unknowns,
                                          const std::vector<ode::limit_condition>& limits) {
    std::vector<ode::expression> values;
    for (const auto& each : limits) {
        values.push_back(each.value);
    }
    return opened(of, unknowns, values);
}

}  // namespace

ball enclosure_of(const proved_decimal& of) { return ode::enclosed(of); }

known_value known_of(const ball& value, long digits) {
    const auto decimal = to_proved_decimal(value, digits);
    return decimal ? known_value{decimal, ""} : known_value{std::nullopt, is_finite(value) ? bound_text(value) : ""};
}

limits_of_unknowns::limits_of_unknowns(const ode::equation_system& of, const std::vector<std::string>& unknowns,
                                       std::vector<ode::limit_condition> limits,
                                       const std::vector<proved_decimal>& values,
                                       const std::vector<std::string>& quantities)
    : limits_(std::move(limits)), open_(opened_with_limits(of, unknowns, limits_)), values_(open_.leaves, ball(0)) {
    const auto names = ode::names_of_state(open_.system);
    for (const std::string& each : quantities) {
        places_.push_back(static_cast<std::size_t>(std::ranges::find(names, each) - names.begin()));
    }
    for (const proved_decimal& each : values) {
        values_.push_back(enclosure_of(each));
    }
}

std::optional<std::vector<std::vector<ball>>> limits_of_unknowns::states(const std::vector<ball>& times, long bits,
                                                                         const ode::proof_route& route,
                                                                         const ode::march_watch& watch) {
    std::vector<ball> start;
    for (const ode::expression& each : open_.starts) {
        start.push_back(values_.of(each));
    }
    auto found = ode::marched_states(open_.system, start, times, bits, route, watch);
    for (std::size_t i = 0; found && i < found->size(); ++i) {
        std::vector<ball> row;
        for (const std::size_t k : places_) {
            row.push_back((*found)[i][k]);
        }
        (*found)[i] = std::move(row);
    }
    return found;
}

std::optional<answer_value> limits_of_unknowns::limit(const std::string& quantity, int direction, long digits,
                                                      bool rests, bool of_layer) {
    for (std::size_t i = 0; i < limits_.size(); ++i) {
        const auto& each = limits_[i];
        const std::string name = ode::primed(each.of.name(), each.of.derivative());
        if (each.direction != direction) {
            continue;
        }
        if (name == quantity) {
            const auto value = to_proved_decimal(values_.of(open_.others[i]), digits);
            return value ? std::optional(answer_value{value->text, value->uncertainty}) : std::nullopt;
        }
        if (of_layer && quantity == each.of.name() && each.of.derivative() == 1) {
            return answer_value{"inf", "0"};
        }
        if (rests && quantity == name + "'") {
            return answer_value{"0", "0"};
        }
    }
    return std::nullopt;
}

}  // namespace libration
