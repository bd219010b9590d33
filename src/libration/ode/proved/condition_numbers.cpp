#include "libration/ode/proved/condition_numbers.hpp"

#include <algorithm>
#include <array>

#include "libration/ode/first_order_form.hpp"
#include "libration/ode/opened_system.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proving_runs.hpp"

namespace libration::ode {

namespace {

constexpr long digits_of_moves = 20;

// Parameters that can be opened: not exponents, and not those used only in other parameters.
std::vector<std::string> names_to_open(const equation_system& system) {
    std::vector<std::string> names;
    for (const definition& each : system.parameters) {
        names.push_back(each.name);
        try {
            opened(system, names);
        } catch (const error&) {
            names.pop_back();
        }
    }
    return names;
}

opened_system opened_with(const equation_system& given, const std::vector<std::string>& unknowns) {
    opened_system open = opened(given, names_to_open(given));
    return unknowns.empty() ? open : closed_part(open, unknowns);
}

ball rounding_of(const ball& x) {
    ball nearest;
    arf_set_round(arb_midref(nearest.handle()), arb_midref(x.handle()), 53, ARF_RND_NEAR);
    return nearest - x;
}

// The input in the working precision.
struct given_numbers {
    explicit given_numbers(const opened_system& open) {
        for (const number& each : open.values) {
            values.push_back(constant_value<ball>::of(each));
        }
        expression_values<ball> by_numbers(open.leaves, ball(0));
        for (const ball& each : values) {
            by_numbers.push_back(each);
        }
        for (const expression& each : open.starts) {
            starts.push_back(by_numbers.of(each));
            auto& row = by_values.emplace_back();
            for (const expression& leaf : open.leaves) {
                row.push_back(by_numbers.of(partial(each, leaf)));
            }
        }
    }

    std::vector<ball> values, starts;
    ball_matrix by_values;  ///< derivatives of the initial values with respect to the values
};

// a b for a square matrix and one with the same number of rows.
ball_matrix rows_of_product(const ball_matrix& a, const ball_matrix& b) {
    ball_matrix result;
    const std::size_t columns = b.front().size();  // a system has at least one unknown
    for (const auto& row : a) {
        auto& sums = result.emplace_back(columns, ball(0));
        for (std::size_t j = 0; j < columns; ++j) {
            for (std::size_t k = 0; k < row.size(); ++k) {
                sums[j] += row[k] * b[k][j];
            }
        }
    }
    return result;
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

// The system with its parameters opened, and the indices of the unknowns of the problem in its state.
struct dependence::open_problem {
    open_problem(const equation_system& given, const std::vector<std::string>& asked)
        : open(opened_with(given, asked)), form(open.system) {
        const auto unknowns = given.unknowns();
        std::size_t place = 0;
        for (const unknown_function& each : open.system.unknowns()) {
            const bool of_problem = std::ranges::find(unknowns, each.name) != unknowns.end();
            for (int j = 0; j < each.order; ++j, ++place) {
                if (of_problem) {
                    own.push_back(place);
                    names.push_back(form.names[place]);
                }
            }
        }
    }

    opened_system open;
    first_order_form form;
    std::vector<std::size_t> own;
    std::vector<std::string> names;
};

dependence::dependence(const equation_system& given, const std::vector<std::string>& unknowns)
    : open_(std::make_unique<const open_problem>(given, unknowns)) {}

dependence::~dependence() = default;

const explicit_system& dependence::system() const { return open_->open.system; }

const std::vector<std::size_t>& dependence::own() const { return open_->own; }

const std::vector<std::string>& dependence::names() const { return open_->names; }

std::optional<std::vector<moved_value>> dependence::moved(const proved_march& march, const number& time,
                                                          const std::vector<ball>& state, long negligible) const {
    const precision_scope scope(decimal_digits(march.bits()));
    const ball t = constant_value<ball>::of(time);
    if (open_->open.system.singular() && contains_zero(t - constant_value<ball>::of(open_->open.system.point()))) {
        throw error(error_kind::undecided, "time", "",
                    "is a singular initial point, where condition numbers are not proved: choose times after it");
    }
    const given_numbers given(open_->open);
    const ball_matrix flow = march.derivative_at(t);
    const ball_matrix by_values = rows_of_product(flow, given.by_values);
    const auto slopes = open_->form.slopes_at(state, t);
    std::vector<moved_value> result;
    for (const std::size_t i : open_->own) {
        ball by_start(0);
        ball by_parameters(0);
        ball by_rounding(0);
        for (const std::size_t j : open_->own) {
            by_start += abs(flow[i][j]) * abs(given.starts[j]);
            by_rounding += flow[i][j] * rounding_of(given.starts[j]);
        }
        for (std::size_t p = 0; p < given.values.size(); ++p) {
            by_parameters += abs(by_values[i][p]) * abs(given.values[p]);
            by_rounding += by_values[i][p] * rounding_of(given.values[p]);
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
                      {[&](const proved_march& march, std::size_t index, const std::vector<ball>& state) {
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
