#include "model_rule.hpp"

#include <algorithm>
#include <utility>

#include "../../expansion/set_values.hpp"
#include "libration/integration/taylor/step_length.hpp"
#include "lifted_models.hpp"
#include "model_tail.hpp"

namespace libration::ode {

namespace {

// The products of a multiplication of two models, and those of the models of the derivative of the flow.
constexpr std::size_t most_products = 40'000;
constexpr std::size_t most_products_of_derivative = 200;

// The degrees in the time, and log2 of the tails relative to the widths of the set.
constexpr int order_of_box = 12;
constexpr int order_of_derivative = 12;
constexpr double wanted_tail = -24;
constexpr double wanted_tail_of_derivative = -16;

// The bits of an unknown that rounding leaves in the long run.
constexpr long rounding_bits = 30;
// log2 of the shortest step relative to the time that has passed.
constexpr long log2_of_shortest = -8;
constexpr long most_model_steps = 100'000;
constexpr long cost_of_model_step = 8;

// The system of a polynomial form as given, all of whose unknowns have variations.
polynomial_form with_all_given(polynomial_form of) {
    of.given = of.leaves.size();
    of.added.clear();
    of.gradients.clear();
    return of;
}

ball_matrix ranges_of(const model_matrix& all) {
    ball_matrix result;
    for (const auto& row : all) {
        auto& ranges = result.emplace_back();
        for (const taylor_model& each : row) {
            ranges.push_back(each.range());
        }
    }
    return result;
}

model_matrix product_of(const model_matrix& a, const model_matrix& b) {
    model_matrix result;
    std::vector<taylor_model> column;
    for (const auto& row : a) {
        auto& products = result.emplace_back();
        for (std::size_t j = 0; j < b.front().size(); ++j) {
            column.clear();
            for (std::size_t k = b.size(); k-- > 0;) {
                column.push_back(b[k][j]);
            }
            products.push_back(product_coefficient(row, column, row.size() - 1));
        }
    }
    return result;
}

// Whether the error of an unknown is wider than its polynomial ever was: smaller boxes are enclosed better.
bool is_lost(const model_state& at) {
    for (std::size_t i = 0; i < at.widest.size(); ++i) {
        const magnitude reach = at.set.reach(i);
        if (at.widest[i] < reach && at.set.models[i].norm() * magnitude::of(1, -rounding_bits) < reach) {
            return true;
        }
    }
    return false;
}

}  // namespace

taylor_model model_series::of_box_at(std::size_t i, const ball& distance) const {
    taylor_model result = of_box.at(i, distance);
    result.add_to_rest(tail->at(i, magnitude(distance)));
    return result;
}

model_matrix model_series::derivative_of_flow(const ball& distance) const {
    const std::size_t count = errors.size();
    model_matrix map(count);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j < count; ++j) {
            const std::size_t index = count * (j + 1) + i;
            map[i].push_back(of_set.at(index, distance));
            map[i].back().add_to_rest(set_tail->at(index, magnitude(distance)));
        }
    }
    return map;
}

model_step::model_step(flow_state from, const ball& length, std::size_t given,
                       std::shared_ptr<const model_series> series)
    : step(std::move(from), length, {model_rule::working_bits, order_of_box, step_method::taylor, cost_of_model_step}),
      given_(given),
      series_(std::move(series)) {}

std::vector<ball> model_step::values(const ball& distance) const {
    const precision_scope few(decimal_digits(model_rule::working_bits));
    std::vector<ball> values;
    for (std::size_t i = 0; i < given_; ++i) {
        values.push_back(widened(series_->of_box_at(i, distance).range(), reaches()[i]));
    }
    return values;
}

std::vector<ball> model_step::narrow_values(const ball& distance) const {
    std::vector<ball> values;
    for (std::size_t i = 0; i < given_; ++i) {
        values.push_back(narrow_value(i, distance, log2_of_excess_at_times, std::nullopt));
    }
    return values;
}

ball model_step::narrow_value(std::size_t i, const ball& distance, long log2_of_excess,
                              std::optional<enough_bounds> enough) const {
    const precision_scope few(decimal_digits(model_rule::working_bits));
    if (enough) {
        enough = enough->before_widening(reaches()[i]);
    }
    return widened(narrow_range(series_->of_box_at(i, distance), log2_of_excess, enough), reaches()[i]);
}

// The errors are small next to the widths of the values, so that one bound for the whole step suffices.
const std::vector<magnitude>& model_step::reaches() const {
    std::call_once(has_reaches_, [this] {
        const ball_matrix map = ranges_of(series_->derivative_of_flow(widened(ball(0), magnitude(length()))));
        for (std::size_t i = 0; i < given_; ++i) {
            reaches_.push_back(series_->errors.reach(map, i));
        }
    });
    return reaches_;
}

model_matrix model_step::models_of_derivative(const ball& distance) const {
    model_matrix map = series_->derivative_of_flow(distance);
    map.erase(map.begin() + static_cast<std::ptrdiff_t>(given_), map.end());
    return product_of(map, model_state::of(from())->derivative);
}

ball_matrix model_step::derivative(const ball& distance) const {
    const precision_scope few(decimal_digits(model_rule::working_bits));
    return ranges_of(models_of_derivative(distance));
}

ball_matrix model_step::narrow_derivative(const ball& distance) const {
    const precision_scope few(decimal_digits(model_rule::working_bits));
    ball_matrix result;
    for (const auto& row : models_of_derivative(distance)) {
        auto& ranges = result.emplace_back();
        for (const taylor_model& each : row) {
            ranges.push_back(narrow_range(each, log2_of_excess_at_times, std::nullopt));
        }
    }
    return result;
}

flow_state model_step::end() const {
    const precision_scope few(decimal_digits(model_rule::working_bits));
    const model_state& at = *model_state::of(from());
    const model_matrix map = series_->derivative_of_flow(length());
    std::vector<taylor_model> models;
    std::vector<magnitude> added;
    std::vector<magnitude> widest = at.widest;
    std::vector<long> scales;
    for (std::size_t i = 0; i < at.set.models.size(); ++i) {
        taylor_model& model = models.emplace_back(series_->of_box_at(i, length()));
        added.push_back(model.rest());
        model.drop_rest();
        widest[i] = std::max(widest[i], model.width());
        scales.push_back(widest[i].is_zero() ? 0 : widest[i].exponent());
    }
    model_set set{std::move(models), at.set.errors.image(ranges_of(map), added).settled(scales)};
    return {end_time(),
            {},
            {},
            std::make_shared<model_state>(std::move(set), product_of(map, at.derivative), std::move(widest))};
}

model_rule::model_rule(const explicit_system& system, std::size_t variables)
    : point_(system.point()),
      lifted_(lifted(system)),
      monomials_(monomial_set::of_cost(variables, most_products)),
      few_monomials_(monomial_set::of_cost(variables, most_products_of_derivative)),
      tape_(tape::about_points(lifted_.system)),
      varied_tape_(tape::about_points(with_variations(with_all_given(lifted_)))) {}

flow_state model_rule::start_from(const state_set& start) const {
    const precision_scope few(decimal_digits(working_bits));
    flow_state result{constant_value<ball>::of(point_), start, {}, {}};
    const std::vector<magnitude> radii = start.errors.radii_of_columns();
    std::vector<taylor_model> given;
    for (std::size_t i = 0; i < start.centre.size(); ++i) {
        std::vector<ball> linear;
        for (std::size_t j = 0; j < monomials_.variables(); ++j) {
            linear.push_back(start.errors.columns()[j][i] * radii[j].exact());
        }
        given.emplace_back(monomials_, start.centre[i], linear).add_to_rest(start.errors.added()[i]);
    }
    auto all = lifted_models(lifted_, given);
    if (!all) {
        return result;
    }
    std::vector<magnitude> rests;
    std::vector<magnitude> widest;
    for (taylor_model& each : *all) {
        rests.push_back(each.rest());
        each.drop_rest();
        widest.push_back(each.width());
    }
    const std::size_t count = all->size();
    const auto varied = varied_values(lifted_, result.time, start.hull());
    model_matrix derivative;
    for (std::size_t i = 0; i < count; ++i) {
        auto& row = derivative.emplace_back();
        for (std::size_t j = 0; j < lifted_.given; ++j) {
            row.emplace_back(few_monomials_, varied[count * (j + 1) + i]);
        }
    }
    result.more = std::make_shared<model_state>(model_set{*std::move(all), lohner_set(std::move(rests))},
                                                std::move(derivative), std::move(widest));
    return result;
}

void model_rule::begin(const flow_state& start) {
    origin_ = start.time;
    steps_ = 0;
}

std::shared_ptr<model_series> model_rule::expanded(const ball& time, const model_set& set) const {
    auto made =
        std::make_shared<model_series>(model_series{model_expansion(tape_, order_of_box, monomials_),
                                                    model_expansion(varied_tape_, order_of_derivative, few_monomials_),
                                                    {},
                                                    {},
                                                    set.errors});
    made->of_box.about(time, set.models);
    made->tail = tail_of(tape_, made->of_box);
    if (!made->tail) {
        return nullptr;
    }
    std::vector<taylor_model> state;
    for (std::size_t i = 0; i < set.models.size(); ++i) {
        state.push_back(set.models[i].truncated(few_monomials_));
        state.back().add_to_rest(set.reach(i));
    }
    for (std::size_t j = 0; j < set.models.size(); ++j) {
        for (std::size_t i = 0; i < set.models.size(); ++i) {
            state.emplace_back(few_monomials_, ball(i == j ? 1 : 0));
        }
    }
    made->of_set.about(time, state);
    made->set_tail = tail_of(varied_tape_, made->of_set);
    return made->set_tail ? made : nullptr;
}

// The longest step whose tails are small relative to the widths of the set, or to 2^-rounding_bits of unknowns without a
// width.
magnitude model_rule::wanted_length(const model_series& series, const model_set& set) const {
    const std::size_t count = set.models.size();
    const auto longest_by = [](const tail_bound& tail, std::size_t i, double allowed) {
        const double error = log_of(tail.error[i]);
        return error == nothing ? largest_tried : log_of(tail.radius) + (allowed - error) / (tail.degree + 1);
    };
    std::vector<double> widths;
    for (std::size_t i = 0; i < count; ++i) {
        const magnitude rounding = set.models[i].norm() * magnitude::of(1, -rounding_bits);
        widths.push_back(log_of(std::max(set.width(i), rounding)));
    }
    const double widest = *std::ranges::max_element(widths);
    for (double& each : widths) {
        each = each != nothing ? each : widest != nothing ? widest : 0;
    }
    double least = largest_tried;
    for (std::size_t i = 0; i < count; ++i) {
        least = std::min(least, longest_by(*series.tail, i, widths[i] + wanted_tail));
        for (std::size_t j = 0; j < count; ++j) {
            const double wanted = widths[i] - widths[j] + wanted_tail_of_derivative;
            least = std::min(least, longest_by(*series.set_tail, count * (j + 1) + i, wanted));
        }
    }
    return power_of_two(least);
}

next_step model_rule::next(const flow_state& from, const ball& rest) {
    const precision_scope few(decimal_digits(working_bits));
    const model_state* const at = model_state::of(from);
    const auto series = at != nullptr && !is_lost(*at) ? expanded(from.time, at->set) : nullptr;
    if (series == nullptr) {
        return {{}, stop::precision};
    }
    // Whatever is wanted: the bounds hold within their radii only.
    const magnitude length = std::min(
        {wanted_length(*series, at->set), series->tail->radius.shifted(-1), series->set_tail->radius.shifted(-1)});
    if (steps_ >= most_model_steps || length <= magnitude(from.time - origin_) * magnitude::of(1, log2_of_shortest)) {
        return {{}, stop::step_too_small};
    }
    ++steps_;
    const ball signed_length = arb_is_negative(rest.handle()) != 0 ? -length.exact() : length.exact();
    return {std::make_shared<model_step>(from, signed_length, lifted_.given, series), stop::none};
}

}  // namespace libration::ode
