#include <algorithm>
#include <numeric>
#include <utility>

#include "libration/ode/opened_system.hpp"
#include "libration/ode/proved/proved_root.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

std::vector<std::string> unknowns_in(const std::vector<point_condition>& conditions) {
    std::vector<std::string> names;
    for (const point_condition& each : conditions) {
        names.push_back(each.unknown);
    }
    return names;
}

// The conditions as functions of the free numbers of a system, of which only the unknowns that they depend on are
// integrated.
class shooting {
public:
    shooting(const equation_system& given, const std::vector<std::string>& names,
             const std::vector<point_condition>& conditions, const proof_route& route, const march_watch& watch)
        : open_(closed_part(opened(given, names), unknowns_in(conditions))),
          conditions_(conditions),
          route_(route),
          watch_(watch) {
        for (const expression& each : open_.starts) {
            std::vector<expression> row;
            for (const expression& leaf : open_.leaves) {
                row.push_back(partial(each, leaf));
            }
            slopes_.push_back(std::move(row));
        }
        for (const point_condition& each : conditions) {
            states_.push_back(state_of(each));
        }
    }

    const std::vector<number>& guess() const { return open_.values; }

    std::optional<enclosed_map> operator()(const std::vector<ball>& x, long bits, long error_bits) const {
        const precision_scope scope(decimal_digits(bits));
        expression_values<ball> values(open_.leaves, ball(0));
        for (const ball& each : x) {
            values.push_back(each);
        }
        std::vector<ball> start;
        ball_matrix by_x;
        for (std::size_t i = 0; i < open_.starts.size(); ++i) {
            start.push_back(values.of(open_.starts[i]));
            auto& row = by_x.emplace_back();
            for (const expression& each : slopes_[i]) {
                row.push_back(values.of(each));
            }
        }
        enclosed_map result{std::vector<ball>(conditions_.size()), ball_matrix(conditions_.size())};
        std::vector<std::size_t> order(conditions_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
            return (conditions_[b].time - conditions_[a].time).sign() > 0;
        });
        const auto first_after = std::ranges::find_if(
            order, [&](std::size_t i) { return (conditions_[i].time - open_.system.point()).sign() >= 0; });
        std::vector<std::size_t> backwards(order.begin(), first_after);
        std::ranges::reverse(backwards);
        const bool done = along(start, by_x, backwards, bits, error_bits, result) &&
                          along(start, by_x, {first_after, order.end()}, bits, error_bits, result);
        return done ? std::optional(std::move(result)) : std::nullopt;
    }

private:
    bool along(const std::vector<ball>& start, const ball_matrix& by_x, const std::vector<std::size_t>& order,
               long bits, long error_bits, enclosed_map& result) const {
        if (order.empty()) {
            return true;
        }
        proved_march march(open_.system, start, bits, error_bits, watch_, route_);
        march.keep_derivative();
        for (const std::size_t i : order) {
            const ball time = constant_value<ball>::of(conditions_[i].time);
            const auto state = march.at(time);
            if (!state) {
                return false;
            }
            result.value[i] = (*state)[states_[i]] - constant_value<ball>::of(conditions_[i].value);
            const ball_matrix all = product(march.derivative_at(time), by_x);
            result.derivative[i] = all[states_[i]];
        }
        return true;
    }

    std::size_t state_of(const point_condition& condition) const {
        std::size_t first = 0;
        for (const unknown_function& each : open_.system.unknowns()) {
            if (each.name == condition.unknown) {
                if (condition.derivative < each.order) {
                    return first + static_cast<std::size_t>(condition.derivative);
                }
                break;
            }
            first += static_cast<std::size_t>(each.order);
        }
        refuse(primed(condition.unknown, condition.derivative), {},
               "is not part of the state in a condition: choose an unknown or a lower derivative");
    }

    opened_system open_;
    std::vector<point_condition> conditions_;
    proof_route route_;
    march_watch watch_;
    std::vector<std::vector<expression>> slopes_;
    std::vector<std::size_t> states_;
};

}  // namespace

std::vector<proved_decimal> proved_unknowns(const equation_system& system, const std::vector<std::string>& names,
                                            const std::vector<point_condition>& conditions, long digits,
                                            const proof_route& route, const march_watch& watch) {
    const shooting shots(system, names, conditions, route, watch);
    return proved_root(
        [&](const std::vector<ball>& x, long bits, long error_bits) { return shots(x, bits, error_bits); },
        shots.guess(), digits);
}

}  // namespace libration::ode
