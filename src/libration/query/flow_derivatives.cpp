#include "libration/query/flow_derivatives.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "../expansion/differentiated_numbers.hpp"
#include "libration/equation/dependency.hpp"
#include "proving_runs.hpp"

namespace libration::ode {

namespace {

parametric_system opened_with(const equation_system& given, const std::vector<std::string>& parameters,
                              const std::vector<std::string>& unknowns) {
    parametric_system open = opened(given, parameters);
    return unknowns.empty() ? open : closed_part(open, unknowns);
}

// For each index in the state, whether its unknown depends on that of each other index.
std::vector<std::vector<bool>> dependencies_of(const explicit_system& system) {
    const dependency_graph graph(system);
    std::vector<std::size_t> unknown_of;
    for (std::size_t k = 0; k < system.unknowns().size(); ++k) {
        unknown_of.insert(unknown_of.end(), static_cast<std::size_t>(system.unknowns()[k].order), k);
    }
    std::vector<std::vector<bool>> depends;
    for (const std::size_t k : unknown_of) {
        const auto needed = graph.closure(k);
        auto& row = depends.emplace_back();
        for (const std::size_t other : unknown_of) {
            row.push_back(std::ranges::binary_search(needed, other));
        }
    }
    return depends;
}

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

// The given numbers in the working precision, and the derivatives of the initial values with respect to them.
state_derivatives derivatives_at_start(const parametric_system& open) {
    state_derivatives result;
    for (const number& each : open.values) {
        result.values.push_back(constant_value<ball>::of(each));
    }
    expression_values<ball> by_numbers(open.leaves, ball(0));
    for (const ball& each : result.values) {
        by_numbers.push_back(each);
    }
    for (const expression& each : open.starts) {
        result.starts.push_back(by_numbers.of(each));
        auto& row = result.by_values.emplace_back();
        for (const expression& leaf : open.leaves) {
            row.push_back(by_numbers.of(partial(each, leaf)));
        }
    }
    return result;
}

class derivative_runs {
public:
    derivative_runs(const equation_system& given, const std::vector<number>& times,
                    const std::vector<std::string>& numbers, long digits)
        : asked_(numbers_of(given, numbers)),
          numbers_(numbers),
          flow_(with_derivative_errors([&] { return opened_flow(given, asked_.parameters); })),
          times_(times),
          digits_(digits) {
        result_.by.resize(times.size());
    }

    partial_derivatives result(const march_watch& watch, const proof_route& route, const step_observer& observer) {
        proving_runs runs(flow_.system(), times_, digits_, watch,
                          {[this](proved_march& march, std::size_t time, const std::vector<ball>& /*state*/) {
                               return proved(march, time);
                           },
                           flow_.own(), bits_of_first_run(digits_)},
                          route, observer);
        result_.trajectory = runs.part();
        miss_undecided();
        return std::move(result_);
    }

private:
    // Runs with more bits for derivatives that are not distinguished from 0: few, since most of these are 0.
    static constexpr int most_runs_at_zero = 2;

    // Whether the derivatives have their digits, or are given up.
    bool proved(proved_march& march, std::size_t time) {
        const precision_scope scope(decimal_digits(march.bits()));
        const state_derivatives all = flow_.at(march, times_[time]);
        bool narrow = true;
        bool at_zero = false;
        auto& rows = result_.by[time];
        rows.resize(flow_.own().size());
        for (std::size_t k = 0; k < rows.size(); ++k) {
            rows[k].resize(asked_.columns.size());
            for (std::size_t j = 0; j < asked_.columns.size(); ++j) {
                const auto& [of_start, index] = asked_.columns[j];
                const std::size_t row = flow_.own()[k];
                const ball& value = of_start ? all.by_starts[row][flow_.own()[index]] : all.by_values[row][index];
                const bool undecided = !is_kept(rows[k][j], value);
                at_zero = at_zero || (undecided && contains_zero(value));
                narrow = narrow && !(undecided && !contains_zero(value));
            }
        }
        return narrow && (!at_zero || ++runs_at_zero_ > most_runs_at_zero);
    }

    // The decimal, which is kept from run to run, or a bound. False without a decimal.
    bool is_kept(known_value& kept, const ball& value) const {
        improve(kept, value, digits_);
        return kept.decimal.has_value();
    }

    void miss_undecided() {
        for (std::size_t time = 0; time < times_.size() && !result_.trajectory.missing; ++time) {
            for (std::size_t k = 0; k < result_.by[time].size(); ++k) {
                const auto& row = result_.by[time][k];
                const auto undecided = std::ranges::find_if(row, [](const auto& each) { return !each.decimal; });
                if (undecided != row.end()) {
                    result_.trajectory.missing =
                        error(error_kind::undecided, error_subject::time, text_of_time(times_[time]),
                              "has a derivative of " + flow_.names()[k] + " by " +
                                  numbers_[static_cast<std::size_t>(undecided - row.begin())] +
                                  " that is not distinguished from 0: its size is below " + undecided->bound);
                    break;
                }
            }
        }
    }

    static differentiated_numbers numbers_of(const equation_system& given, const std::vector<std::string>& numbers) {
        const explicit_system system(given);
        return {given, names_of_state(system), system.point(), numbers};
    }

    differentiated_numbers asked_;
    const std::vector<std::string>& numbers_;
    opened_flow flow_;
    const std::vector<number>& times_;
    long digits_;
    int runs_at_zero_ = 0;
    partial_derivatives result_;
};

}  // namespace

opened_flow::opened_flow(const equation_system& given, const std::vector<std::string>& parameters,
                         const std::vector<std::string>& unknowns)
    : open_(opened_with(given, parameters, unknowns)), form_(open_.system), depends_(dependencies_of(open_.system)) {
    const auto of_problem = given.unknowns();
    std::size_t place = 0;
    for (const unknown_function& each : open_.system.unknowns()) {
        const bool is_own = std::ranges::find(of_problem, each.name) != of_problem.end();
        for (int j = 0; j < each.order; ++j, ++place) {
            if (is_own) {
                own_.push_back(place);
                names_.push_back(form_.names[place]);
            }
        }
    }
}

state_derivatives opened_flow::at(proved_march& march, const number& time) const {
    const ball t = constant_value<ball>::of(time);
    if (open_.system.singular() && contains_zero(t - constant_value<ball>::of(open_.system.point()))) {
        throw error(error_kind::undecided, error_subject::time, "",
                    "is a singular initial point, where derivatives by initial values and parameters are not proved: "
                    "choose times after it");
    }
    state_derivatives result = derivatives_at_start(open_);
    result.by_starts = march.derivative_at(t);
    for (std::size_t i = 0; i < depends_.size(); ++i) {
        for (std::size_t j = 0; j < depends_.size(); ++j) {
            if (!depends_[i][j]) {
                result.by_starts[i][j] = ball(0);
            }
        }
    }
    result.by_values = rows_of_product(result.by_starts, result.by_values);
    return result;
}

partial_derivatives proved_derivatives(const equation_system& given, const std::vector<number>& times,
                                       const std::vector<std::string>& numbers, long digits, const march_watch& watch,
                                       const proof_route& route, const step_observer& observer) {
    return derivative_runs(given, times, numbers, digits).result(watch, route, observer);
}

}  // namespace libration::ode
