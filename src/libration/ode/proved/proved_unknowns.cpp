#include <algorithm>
#include <numeric>
#include <utility>

#include "libration/ode/proved/proved_root.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

// A system whose unknown numbers are unknown functions that do not change, and its starts by those numbers.
class shooting {
public:
    shooting(const equation_system& given, const std::vector<std::string>& names,
             const std::vector<point_condition>& conditions)
        : names_(names), guess_(), system_(with_unknown_numbers(given)), conditions_(conditions) {
        for (std::size_t i = 0; i < names.size(); ++i) {
            leaves_.push_back(unknown("y" + std::to_string(i)));
        }
        for (const expression& each : starts_) {
            std::vector<expression> row;
            for (const expression& leaf : leaves_) {
                row.push_back(partial(each, leaf));
            }
            slopes_.push_back(std::move(row));
        }
        for (const point_condition& each : conditions) {
            states_.push_back(state_of(each));
        }
    }

    const std::vector<number>& guess() const { return guess_; }

    std::optional<enclosed_map> operator()(const std::vector<ball>& x, long bits, long error_bits) const {
        const precision_scope scope(decimal_digits(bits));
        expression_values<ball> values(leaves_, ball(0));
        for (const ball& each : x) {
            values.push_back(each);
        }
        std::vector<ball> start;
        ball_matrix by_x;
        for (std::size_t i = 0; i < starts_.size(); ++i) {
            start.push_back(values.of(starts_[i]));
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
            order, [&](std::size_t i) { return (conditions_[i].time - system_.point()).sign() >= 0; });
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
        proved_march march(system_, start, bits, error_bits);
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
        for (const unknown_function& each : system_.unknowns()) {
            if (each.name == condition.unknown) {
                if (condition.derivative < each.order) {
                    return first + static_cast<std::size_t>(condition.derivative);
                }
                break;
            }
            first += static_cast<std::size_t>(each.order);
        }
        refuse(primed(condition.unknown, condition.derivative), {},
               "is no part of the state in a condition: choose an unknown or a lower derivative");
    }

    explicit_system with_unknown_numbers(const equation_system& given) {
        equation_system made = given;
        made.invariants.clear();
        made.exact.clear();
        std::vector<std::string> names = names_;
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (names[i].find('(') != std::string::npos) {
                names[i] = parameter_for_start(made, names[i], i);
            }
        }
        std::vector<expression> values;  // of the starts, with the numbers as leaves
        const auto as_leaves = [&](const expression& e) {
            return replaced(e, [&](const expression& leaf) -> std::optional<expression> {
                const auto at = std::ranges::find(names, leaf.name());
                return leaf.kind() == node_kind::parameter && at != names.end()
                           ? std::optional(unknown("y" + std::to_string(at - names.begin())))
                           : std::nullopt;
            });
        };
        for (const std::string& each : names) {
            const definition* const found = made.parameter_of(each);
            if (found == nullptr) {
                refuse(each, {}, "is no parameter and no start of the problem: choose one of its own");
            }
            guess_.push_back(with_values(found->value, made).constant());
        }
        return system_of(made, names, as_leaves);
    }

    // f''(0) = value becomes f''(0) = a parameter of that value.
    static std::string parameter_for_start(equation_system& made, const std::string& name, std::size_t index) {
        for (start& each : made.starts) {
            const std::string of = primed(each.of.name(), each.of.derivative()) + "(";
            if (name.starts_with(of)) {
                const std::string parameter_name = "unknown number " + std::to_string(index);
                made.parameters.push_back({parameter_name, each.value, {}});
                each.value = parameter(parameter_name);
                return parameter_name;
            }
        }
        refuse(name, {}, "is no start of the problem: choose one of its own");
    }

    template <class Replace>
    explicit_system system_of(const equation_system& made, const std::vector<std::string>& names,
                              const Replace& as_leaves) {
        equation_system open = made;
        const auto opened = [&](const expression& e) {
            return replaced(e, [&](const expression& leaf) -> std::optional<expression> {
                return leaf.kind() == node_kind::parameter && std::ranges::find(names, leaf.name()) != names.end()
                           ? std::optional(unknown(leaf.name()))
                           : std::nullopt;
            });
        };
        // Parameters that need the unknown numbers become formulas in them.
        equation_system others = made;
        std::erase_if(others.parameters,
                      [&](const definition& each) { return std::ranges::find(names, each.name) != names.end(); });
        const auto partly = [&](const expression& e) { return with_values_but(e, others, names); };
        for (equation& each : open.equations) {
            each.left = opened(partly(each.left));
            each.right = opened(partly(each.right));
        }
        for (std::size_t i = 0; i < names.size(); ++i) {
            open.add(derivative(unknown(names[i])));
            open.begin(unknown(names[i]), expression(guess_[i]),
                       made.starts.empty() ? expression() : made.starts.front().point);
        }
        explicit_system result(open);
        for (const unknown_function& each : result.unknowns()) {
            for (int j = 0; j < each.order; ++j) {
                const auto number_of = std::ranges::find(names, each.name);
                if (number_of != names.end()) {
                    starts_.push_back(unknown("y" + std::to_string(number_of - names.begin())));
                    continue;
                }
                const auto at = std::ranges::find_if(
                    made.starts, [&](const start& s) { return s.of.name() == each.name && s.of.derivative() == j; });
                starts_.push_back(as_leaves(partly(at->value)));
            }
        }
        return result;
    }

    // Parameters replaced by their values, those of the names left.
    static expression with_values_but(const expression& e, const equation_system& others,
                                      const std::vector<std::string>& names) {
        expression result = e;
        for (std::size_t depth = 0; depth <= others.parameters.size(); ++depth) {
            result = replaced(result, [&](const expression& leaf) -> std::optional<expression> {
                if (leaf.kind() != node_kind::parameter || std::ranges::find(names, leaf.name()) != names.end()) {
                    return std::nullopt;
                }
                const definition* const found = others.parameter_of(leaf.name());
                if (found == nullptr) {
                    refuse(leaf.name(), {}, "has no value: write " + leaf.name() + " = number");
                }
                return found->value;
            });
        }
        return result;
    }

    std::vector<std::string> names_;
    std::vector<number> guess_;
    std::vector<expression> starts_;  // by the unknown numbers y0, y1, ..
    explicit_system system_;
    std::vector<point_condition> conditions_;
    std::vector<expression> leaves_;
    std::vector<std::vector<expression>> slopes_;
    std::vector<std::size_t> states_;
};

}  // namespace

std::vector<proved_decimal> proved_unknowns(const equation_system& system, const std::vector<std::string>& names,
                                            const std::vector<point_condition>& conditions, long digits) {
    const shooting shots(system, names, conditions);
    return proved_root(
        [&](const std::vector<ball>& x, long bits, long error_bits) { return shots(x, bits, error_bits); },
        shots.guess(), digits);
}

}  // namespace libration::ode
