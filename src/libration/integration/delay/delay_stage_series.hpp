// The series of a stage of a delay differential equation, and those of the derivatives of its solutions with respect to
// their values at the beginning of a step.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "../../expansion/set_values.hpp"
#include "delay_step.hpp"
#include "libration/equation/delay_system.hpp"
#include "libration/equation/polynomial_form.hpp"
#include "libration/integration/lohner_set.hpp"
#include "libration/integration/taylor/taylor_march.hpp"

namespace libration::ode {

// The equations of a stage in polynomial form, and their series.
template <field R>
struct stage_series {
    stage_series(delay_stage made, int order)
        : stage(std::move(made)),
          form(lifted_about_points(stage.system)),
          steps(tape::about_points(form.system)),
          expansion(steps, order) {}

    delay_stage stage;
    polynomial_form form;
    tape steps;
    taylor_expansion<R> expansion;
};

// In low precision, of every solution that begins in a set, with the derivatives by the leaves. The inputs do not depend on
// the beginning of the step.
class stage_variations {
public:
    static constexpr long bits = 64;

    stage_variations(const polynomial_form& form, std::size_t leaves)
        : form_(form),
          leaves_(leaves),
          steps_(tape::about_points(with_variations(columns_of(form, leaves)))),
          expansion_(steps_, taylor_order(bits)) {}

    // From enclosures of the state and the coefficients of the known slopes, of degree below that of the expansion; false
    // if a value is not finite.
    bool expand(const ball& time, const std::vector<ball>& state, const std::vector<known_series<ball>>& known) {
        auto all = lifted_values(form_, time, state);
        const std::size_t count = all.size();
        expression_values<ball> values(form_.leaves, time);
        for (std::size_t i = 0; i < count; ++i) {
            values.push_back(all[i]);
        }
        for (std::size_t j = 0; j < leaves_; ++j) {
            std::vector<ball> column;
            for (std::size_t i = 0; i < count; ++i) {
                column.push_back(i < form_.given ? ball(i == j ? 1 : 0) : varied(i - form_.given, column, values));
            }
            all.insert(all.end(), column.begin(), column.end());
        }
        const bool finite = all_finite(all);
        if (finite) {
            time_ = time;
            expansion_.about(time, as_state(all), known);
        }
        return finite;
    }

    int order() const { return expansion_.order(); }

    // Bounds up to a length; false if there are none.
    bool bound(const magnitude& length, const std::vector<known_remainder>& known) {
        bound_ = bounded_remainder(steps_, expansion_, time_, length, known);
        return bound_.has_value();
    }

    // The derivative of leaf i by the value of leaf j, and its own by the time, at every distance of a ball.
    ball_matrix values_at(const ball& distance) const {
        return matrix_of([&](int index) {
            return widened(value_of(series(index), distance), bound_->error[static_cast<std::size_t>(index)]);
        });
    }
    ball_matrix slopes_at(const ball& distance) const {
        return matrix_of([&](int index) {
            auto slopes = series(index);
            for (std::size_t n = 0; n + 1 < slopes.size(); ++n) {
                slopes[n] = slopes[n + 1] * static_cast<int>(n + 1);
            }
            slopes.pop_back();
            return widened(value_of(slopes, distance), bound_->slope_error[static_cast<std::size_t>(index)]);
        });
    }

private:
    // With columns for the leaves only.
    static polynomial_form columns_of(polynomial_form form, std::size_t leaves) {
        form.given = leaves;
        return form;
    }

    ball varied(std::size_t added, const std::vector<ball>& column, expression_values<ball>& values) const {
        ball sum(0);
        for (const auto& [k, by] : form_.gradients[added]) {
            sum += values.of(by) * column[k];
        }
        return sum;
    }

    std::vector<ball> series(int index) const {
        const ball* const a = expansion_.coefficients(index);
        return {a, a + expansion_.order() + 1};
    }

    template <class Entry>
    ball_matrix matrix_of(const Entry& entry) const {
        const std::size_t count = form_.leaves.size();
        ball_matrix result(leaves_);
        for (std::size_t i = 0; i < leaves_; ++i) {
            for (std::size_t j = 0; j < leaves_; ++j) {
                result[i].push_back(entry(static_cast<int>(count * (j + 1) + i)));
            }
        }
        return result;
    }

    const polynomial_form& form_;
    std::size_t leaves_;
    tape steps_;
    taylor_expansion<ball> expansion_;
    ball time_;
    std::optional<remainder_bound> bound_;
};

}  // namespace libration::ode
