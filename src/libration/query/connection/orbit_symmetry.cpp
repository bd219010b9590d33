#include "orbit_symmetry.hpp"

#include <algorithm>
#include <bit>

#include "../../equation/reversal.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/equation/parametric_system.hpp"

namespace libration::ode {

namespace {

constexpr std::size_t most_components = 12;

// The limits of a component of the state.
struct component_limits {
    std::optional<expression> at_start, at_end;
    bool fast_at_start = false, fast_at_end = false;
    bool are_equal = false;
};

bool is_initial_value(const std::string& name) { return name.find('(') != std::string::npos; }

// std::nullopt where a limit at -inf is not the image of one at inf under any reflection.
std::optional<std::vector<component_limits>> limits_by_component(const std::vector<std::string>& names,
                                                                 const std::vector<limit_condition>& limits,
                                                                 const std::vector<expression>& values) {
    std::vector<component_limits> result(names.size());
    for (std::size_t i = 0; i < limits.size(); ++i) {
        const auto place = std::ranges::find(names, primed(limits[i].of.name(), limits[i].of.derivative()));
        if (place == names.end()) {
            return std::nullopt;
        }
        component_limits& of = result[static_cast<std::size_t>(place - names.begin())];
        (limits[i].direction > 0 ? of.at_end : of.at_start) = values[i];
        (limits[i].direction > 0 ? of.fast_at_end : of.fast_at_start) = limits[i].fast;
    }
    for (component_limits& of : result) {
        if (of.at_start && (!of.at_end || of.fast_at_start != of.fast_at_end)) {
            return std::nullopt;
        }
        of.are_equal = of.at_start && is_zero_sum(*of.at_start - *of.at_end);
    }
    return result;
}

// By the components with the sign -1, as bits; std::nullopt if the image of a limit is another.
std::optional<orbit_symmetry> symmetry_with(const first_order_form& form, const std::vector<component_limits>& limits,
                                            const number& point, std::size_t mask) {
    orbit_symmetry result{.of = form.given, .signs = {}, .centre = {}, .point = point};
    for (std::size_t k = 0; k < limits.size(); ++k) {
        const bool changes = (mask >> k) % 2 == 1;
        if (limits[k].at_start && !changes && !limits[k].are_equal) {
            return std::nullopt;
        }
        result.signs.push_back(changes ? -1 : 1);
        result.centre.push_back(changes && limits[k].at_start ? (*limits[k].at_start + *limits[k].at_end) / 2
                                                              : expression(0));
    }
    return is_reversal(form, result.signs, result.centre) ? std::optional(result) : std::nullopt;
}

std::vector<std::size_t> masks_in_order(const std::vector<component_limits>& limits) {
    std::size_t equal = 0;
    for (std::size_t k = 0; k < limits.size(); ++k) {
        equal |= (limits[k].are_equal ? std::size_t{1} : std::size_t{0}) << k;
    }
    std::vector<std::size_t> masks;
    for (std::size_t mask = (std::size_t{1} << limits.size()) - 1; mask-- > 1;) {
        masks.push_back(mask);
    }
    std::ranges::stable_sort(
        masks, {}, [&](std::size_t mask) { return std::pair(std::popcount(mask & equal), std::popcount(mask)); });
    return masks;
}

std::string text_at(const std::string& name, const std::string& time) { return name + "(" + time + ")"; }

}  // namespace

bool is_two_sided(const std::vector<limit_condition>& limits) {
    return std::ranges::any_of(limits, [](const auto& each) { return each.direction > 0; }) &&
           std::ranges::any_of(limits, [](const auto& each) { return each.direction < 0; });
}

equation_system with_idle_starts(equation_system system) {
    const auto highest = system.highest_derivatives();
    const expression point = system.starts.empty() ? expression(0) : system.starts.front().point;
    for (const std::string& name : system.unknowns()) {
        for (int order = 0; order < highest.at(name); ++order) {
            const auto of = unknown(name, order);
            if (std::ranges::none_of(system.starts, [&](const start& each) { return same_form(each.of, of); })) {
                system.begin(of, 0, point);
            }
        }
    }
    return system;
}

std::optional<expression> orbit_symmetry::centre_of(const expression& component) const {
    for (std::size_t k = 0; k < of.size(); ++k) {
        if (signs[k] < 0 && same_form(of[k], component)) {
            return centre[k];
        }
    }
    return std::nullopt;
}

std::string orbit_symmetry::text() const {
    const auto at = point.fraction();
    const std::string twice = at ? rational(2 * *at).str() : "2*t_0";
    const std::string reversed = twice == "0" ? "-t" : twice + " - t";
    std::string all;
    for (std::size_t k = 0; k < of.size(); ++k) {
        if (of[k].derivative() != 0) {
            continue;
        }
        const std::string name = of[k].name();
        all += all.empty() ? "" : ", ";
        all += signs[k] > 0 || centre[k].is(0)
                   ? text_at(name, reversed) + (signs[k] > 0 ? " = " : " = -") + text_at(name, "t")
                   : text_at(name, "t") + " + " + text_at(name, reversed) + " = " + text_at(name, "-inf") + " + " +
                         text_at(name, "inf");
    }
    return all;
}

std::optional<orbit_symmetry> symmetry_between(const equation_system& system,
                                               const std::vector<limit_condition>& limits,
                                               const std::vector<std::string>& unknowns) {
    if (!is_two_sided(limits) || !system.open.empty() || !system.is_ordinary() ||
        !std::ranges::all_of(unknowns, is_initial_value)) {
        return std::nullopt;
    }
    std::vector<expression> values;
    std::ranges::transform(limits, std::back_inserter(values), &limit_condition::value);
    const equation_system complete = with_idle_starts(system);
    const parametric_system open = opened(complete, {}, values);
    const first_order_form form(open.system);
    const auto by_component = limits_by_component(form.names, limits, open.others);
    if (!by_component || form.names.size() > most_components ||
        std::ranges::any_of(form.slopes, [](const expression& each) { return each.has_variable(); })) {
        return std::nullopt;
    }
    if (unknowns.empty()) {
        for (const std::size_t mask : masks_in_order(*by_component)) {
            if (auto found = symmetry_with(form, *by_component, open.system.point(), mask)) {
                return found;
            }
        }
        return std::nullopt;
    }
    std::size_t mask = 0;
    for (std::size_t k = 0; k < form.given.size(); ++k) {
        const std::string name = name_of_start(form.given[k], complete.starts.front().point);
        mask |= (std::ranges::find(unknowns, name) == unknowns.end() ? std::size_t{1} : std::size_t{0}) << k;
    }
    return symmetry_with(form, *by_component, open.system.point(), mask);
}

std::optional<orbit_symmetry> symmetry_of(const connection_question& question) {
    if (question.unknowns.empty()) {
        return std::nullopt;
    }
    auto found = symmetry_between(question.system, question.limits, question.unknowns);
    if (!found) {
        return std::nullopt;
    }
    const first_order_form form{explicit_system(with_idle_starts(question.system))};
    for (std::size_t k = 0; k < form.starts.size(); ++k) {
        if (found->signs[k] < 0 && !(expression(form.starts[k]) - found->centre[k]).is(0)) {
            return std::nullopt;
        }
    }
    return found;
}

}  // namespace libration::ode
