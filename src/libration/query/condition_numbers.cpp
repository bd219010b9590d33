#include "libration/query/condition_numbers.hpp"

#include <algorithm>
#include <array>

#include "libration/equation/parametric_system.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proving_runs.hpp"

namespace libration::ode {

namespace {

constexpr long digits_of_moves = 20;

bool is_binary(node_kind kind) {
    return kind == node_kind::sum || kind == node_kind::product || kind == node_kind::quotient ||
           kind == node_kind::power;
}

// Whether an expression contains a parameter, itself or in the definition of another one.
bool contains(const equation_system& system, const expression& e, const std::string& name) {
    if (e.kind() == node_kind::parameter) {
        const auto of = std::ranges::find(system.parameters, e.name(), &definition::name);
        return e.name() == name || (of != system.parameters.end() && contains(system, of->value, name));
    }
    return (is_binary(e.kind()) && (contains(system, e.left(), name) || contains(system, e.right(), name))) ||
           (e.kind() == node_kind::function && contains(system, e.left(), name));
}

// Whether an exponent in an expression contains a parameter.
bool has_in_exponent(const equation_system& system, const expression& e, const std::string& name) {
    if (e.kind() == node_kind::function) {
        return has_in_exponent(system, e.left(), name);
    }
    return is_binary(e.kind()) && ((e.kind() == node_kind::power && contains(system, e.right(), name)) ||
                                   has_in_exponent(system, e.left(), name) || has_in_exponent(system, e.right(), name));
}

// Parameters that can be opened: not exponents, nor those of the initial point, nor those that only other parameters
// contain.
std::vector<std::string> names_to_open(const equation_system& system) {
    std::vector<std::string> names;
    for (const definition& each : system.parameters) {
        if (std::ranges::any_of(system.equations, [&](const equation& of) {
                return has_in_exponent(system, of.left, each.name) || has_in_exponent(system, of.right, each.name);
            })) {
            continue;
        }
        names.push_back(each.name);
        try {
            opened(system, names);
        } catch (const error&) {
            names.pop_back();
        }
    }
    return names;
}

ball rounding_of(const ball& x) {
    ball nearest;
    arf_set_round(arb_midref(nearest.handle()), arb_midref(x.handle()), 53, ARF_RND_NEAR);
    return nearest - x;
}

// Three digits if the change is not negligible compared with the value, otherwise 0; std::nullopt if more bits are
// needed.
std::optional<mpfr> settled(const ball& moved, const ball& size, long negligible) {
    if (!is_finite(moved)) {
        return std::nullopt;
    }
    const precision_scope few(digits_of_moves);
    const mpfr middle = abs(midpoint_of(moved));
    const mpfr radius = midpoint_of(radius_of(moved));
    if (radius * 2048 <= middle || contains_zero(size)) {
        return middle;
    }
    const mpfr least = midpoint_of(lower_bound(size)) * pow(mpfr(10), -negligible);
    if (middle + radius <= least) {
        return mpfr(0);
    }
    return std::nullopt;
}

constexpr long negligible_condition = 9;

}  // namespace

dependence::dependence(const equation_system& given, const std::vector<std::string>& unknowns)
    : flow_(given, names_to_open(given), unknowns) {}

std::optional<std::vector<moved_value>> dependence::moved(proved_march& march, const number& time,
                                                          const std::vector<ball>& state, long negligible) const {
    const precision_scope scope(decimal_digits(march.bits()));
    const ball t = constant_value<ball>::of(time);
    const state_derivatives all = flow_.at(march, time);
    const auto slopes = flow_.form().slopes_at(state, t);
    std::vector<moved_value> result;
    for (const std::size_t i : own()) {
        ball by_start(0);
        ball by_parameters(0);
        ball by_rounding(0);
        for (const std::size_t j : own()) {
            by_start += abs(all.by_starts[i][j]) * abs(all.starts[j]);
            by_rounding += all.by_starts[i][j] * rounding_of(all.starts[j]);
        }
        for (std::size_t p = 0; p < all.values.size(); ++p) {
            by_parameters += abs(all.by_values[i][p]) * abs(all.values[p]);
            by_rounding += all.by_values[i][p] * rounding_of(all.values[p]);
        }
        const ball size = abs(state[i]);
        const auto of_start = settled(by_start, size, negligible_condition);
        const auto of_parameters = settled(by_parameters, size, negligible_condition);
        const auto of_time = settled(abs(slopes[i]) * abs(t), size, negligible_condition);
        const auto of_rounding = settled(by_rounding, size, negligible);
        const std::array moves{of_start, of_parameters, of_time, of_rounding};
        if (!std::ranges::all_of(moves, [](const auto& each) { return each.has_value(); })) {
            return std::nullopt;
        }
        result.push_back({*of_start, *of_parameters, *of_time, *of_rounding});
    }
    return result;
}

std::vector<conditioned_state> proved_conditions(const equation_system& given, const std::vector<number>& times,
                                                 long digits, const march_watch& watch) {
    constexpr long further_digits = 10;
    const dependence on(given);
    std::vector<conditioned_state> result(times.size());
    proving_runs runs(on.system(), times, digits, watch,
                      {[&](proved_march& march, std::size_t index, const std::vector<ball>& state) {
                           auto moved = on.moved(march, times[index], state, digits + further_digits);
                           if (moved) {
                               result[index].moved = std::move(*moved);
                           }
                           return moved.has_value();
                       },
                       on.own()});
    auto values = all_digits(runs.part());
    for (std::size_t i = 0; i < times.size(); ++i) {
        result[i].values = std::move(values[i]);
    }
    return result;
}

}  // namespace libration::ode
