#include "turning_point.hpp"

#include <algorithm>
#include <optional>

namespace libration::ode {

namespace {

class extension {
public:
    extension(const parametric_system& open, const conditions_at_times& conditions, std::size_t pivot)
        : open_(open), conditions_(conditions), form_(open.system) {
        const std::size_t unknowns = open.leaves.size() - 1;
        for (std::size_t j = 0; j < unknowns; ++j) {
            if (j != pivot) {
                added_.push_back(unknown("y" + std::to_string(open.leaves.size() + added_.size())));
            }
            direction_.push_back(j == pivot ? expression(1) : added_.back());
        }
        direction_.emplace_back();  // of lambda: 0
        const std::size_t count = form_.leaves.size();
        for (std::size_t k = 0; k < count; ++k) {
            variations_.push_back(unknown("y" + std::to_string(count + k)));
        }
    }

    parametric_system system() const {
        std::vector<expression> leaves = form_.leaves;
        leaves.insert(leaves.end(), variations_.begin(), variations_.end());
        std::vector<expression> slopes = form_.slopes;
        for (const expression& each : form_.slopes) {
            slopes.push_back(derivative_along(each, form_.leaves, variations_));
        }
        parametric_system result{explicit_system::first_order(leaves, std::move(slopes), open_.system.point()),
                                 {},
                                 open_.starts,
                                 open_.leaves,
                                 {}};
        for (const expression& each : open_.starts) {
            result.starts.push_back(derivative_along(each, open_.leaves, direction_));
        }
        result.leaves.insert(result.leaves.end(), added_.begin(), added_.end());
        return result;
    }

    // The conditions and their derivatives, with the times in the leaves of the free numbers.
    conditions_at_times conditions() const {
        conditions_at_times result;
        const std::size_t count = conditions_.differences().size();
        std::vector<expression> renamed;  // the leaves of the values, of which some may be equal now
        for (std::size_t k = 0; k < conditions_.values().size(); ++k) {
            renamed.push_back(result.at(form_.leaves[index_of(k)], open_.others[count + k]));
        }
        std::vector<expression> leaves = open_.leaves;
        std::vector<expression> weights = direction_;
        const std::size_t values = result.values().size();
        for (std::size_t k = 0; k < values; ++k) {
            leaves.push_back(result.leaves()[k]);
            weights.push_back(variation_of(value_at_time(result.values()[k]), result));
        }
        for (std::size_t i = 0; i < count; ++i) {
            result.add(with_leaves(open_.others[i], renamed));
        }
        for (std::size_t i = 0; i < count; ++i) {
            result.add(derivative_along(expression(result.differences()[i]), leaves, weights));
        }
        return result;
    }

private:
    std::size_t index_of(std::size_t value) const {
        const expression& of = conditions_.values()[value].of;
        const auto found =
            std::ranges::find_if(form_.given, [&](const expression& each) { return same_form(each, of); });
        return static_cast<std::size_t>(found - form_.given.begin());
    }

    expression with_leaves(const expression& e, const std::vector<expression>& by) const {
        return replaced(e, [&](const expression& leaf) -> std::optional<expression> {
            const auto found = std::ranges::find_if(conditions_.leaves(),
                                                    [&](const expression& each) { return same_form(each, leaf); });
            return found == conditions_.leaves().end()
                       ? std::nullopt
                       : std::optional(by[static_cast<std::size_t>(found - conditions_.leaves().begin())]);
        });
    }

    // u + y' dt/dx v for a value at its time.
    expression variation_of(const value_at_time& value, conditions_at_times& result) const {
        const auto leaf =
            std::ranges::find_if(form_.leaves, [&](const expression& each) { return same_form(each, value.of); });
        const auto index = static_cast<std::size_t>(leaf - form_.leaves.begin());
        const expression later = derivative_along(value.time, open_.leaves, direction_);
        expression sum = result.at(variations_[index], value.time);
        if (!later.is(0)) {
            const expression slope = replaced(form_.slopes[index], [&](const expression& of) {
                return std::optional(of.kind() == node_kind::variable ? value.time : result.at(of, value.time));
            });
            sum = sum + slope * later;
        }
        return sum;
    }

    const parametric_system& open_;
    const conditions_at_times& conditions_;
    first_order_form form_;
    std::vector<expression> added_;       // the leaves of the components of v that are not fixed
    std::vector<expression> direction_;   // v, then 0
    std::vector<expression> variations_;  // u
};

}  // namespace

shooting turning_point_conditions(const shooting& conditions, const std::vector<number>& values,
                                  const std::vector<number>& direction, std::size_t pivot, const proof_route& route,
                                  const march_watch& watch) {
    const extension extended(conditions.open(), conditions.conditions(), pivot);
    parametric_system system = extended.system();
    conditions_at_times all = extended.conditions();
    system.values = values;
    for (std::size_t j = 0; j < direction.size(); ++j) {
        if (j != pivot) {
            system.values.push_back(direction[j]);
        }
    }
    system.others = all.differences();
    for (const value_at_time& each : all.values()) {
        system.others.push_back(each.time);
    }
    return {system, std::move(all), route, watch};
}

}  // namespace libration::ode
