#include "model_march.hpp"

#include <algorithm>
#include <utility>

#include "../../expansion/set_values.hpp"
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
constexpr long most_steps = 100'000;
constexpr long model_steps_unwatched = 8;

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

}  // namespace

model_step::model_step(const tape& of_box, const tape& varied, std::size_t given, const monomial_set& in,
                       const monomial_set& few)
    : of_box_(of_box, order_of_box, in), of_set_(varied, order_of_derivative, few), given_(given) {}

// The solution from p(a), with all errors in the rest.
taylor_model model_step::of_box_at(std::size_t i, const ball& distance) const {
    taylor_model result = of_box_.at(i, distance);
    result.add_to_rest(tail_->at(i, magnitude(distance)));
    return result;
}

model_matrix model_step::derivative_of_flow(const ball& distance) const {
    const std::size_t count = errors_.size();
    model_matrix map(count);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j < count; ++j) {
            const std::size_t index = count * (j + 1) + i;
            map[i].push_back(of_set_.at(index, distance));
            map[i].back().add_to_rest(set_tail_->at(index, magnitude(distance)));
        }
    }
    return map;
}

std::vector<ball> model_step::values_at(const ball& distance) const {
    const precision_scope few(decimal_digits(model_march::working_bits));
    std::vector<ball> values;
    for (std::size_t i = 0; i < given_; ++i) {
        values.push_back(widened(of_box_at(i, distance).range(), reaches()[i]));
    }
    return values;
}

std::vector<ball> model_step::narrow_values_at(const ball& distance) const {
    std::vector<ball> values;
    for (std::size_t i = 0; i < given_; ++i) {
        values.push_back(narrow_value_at(i, distance, log2_of_excess_at_times, std::nullopt));
    }
    return values;
}

ball model_step::narrow_value_at(std::size_t i, const ball& distance, long log2_of_excess,
                                 std::optional<enough_bounds> enough) const {
    const precision_scope few(decimal_digits(model_march::working_bits));
    if (enough) {
        enough = enough->before_widening(reaches()[i]);
    }
    return widened(narrow_range(of_box_at(i, distance), log2_of_excess, enough), reaches()[i]);
}

// The errors are small next to the widths of the values, so that one bound for the whole step suffices.
const std::vector<magnitude>& model_step::reaches() const {
    if (reaches_.empty()) {
        const ball_matrix map = ranges_of(derivative_of_flow(widened(ball(0), length_)));
        for (std::size_t i = 0; i < given_; ++i) {
            reaches_.push_back(errors_.reach(map, i));
        }
    }
    return reaches_;
}

model_march::model_march(const explicit_system& system, const state_set& start, std::size_t variables,
                         march_watch watch)
    : lifted_(lifted(system)),
      monomials_(monomial_set::of_cost(variables, most_products)),
      few_monomials_(monomial_set::of_cost(variables, most_products_of_derivative)),
      tape_(tape::about_points(lifted_.system)),
      varied_tape_(tape::about_points(with_variations(with_all_given(lifted_)))),
      watch_(std::move(watch)) {
    const precision_scope few(decimal_digits(working_bits));
    time_ = constant_value<ball>::of(system.point());
    origin_ = time_;
    begin_from(start);
}

void model_march::begin_from(const state_set& start) {
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
        end_ = march_end::precision;
        return;
    }
    std::vector<magnitude> rests;
    for (taylor_model& each : *all) {
        rests.push_back(each.rest());
        each.drop_rest();
        widest_.push_back(each.width());
    }
    const std::size_t count = all->size();
    const auto varied = varied_values(lifted_, time_, start.hull());
    for (std::size_t i = 0; i < count; ++i) {
        auto& row = derivative_.emplace_back();
        for (std::size_t j = 0; j < lifted_.given; ++j) {
            row.emplace_back(few_monomials_, varied[count * (j + 1) + i]);
        }
    }
    set_ = model_set{*std::move(all), lohner_set(std::move(rests))};
}

const enclosed_step* model_march::stopped(march_end why) {
    end_ = why;
    return nullptr;
}

// Whether the error of an unknown is wider than its polynomial ever was: smaller boxes are enclosed better.
bool model_march::is_lost() const {
    for (std::size_t i = 0; i < widest_.size(); ++i) {
        if (widest_[i] < set_->reach(i) && set_->models[i].norm() * magnitude::of(1, -rounding_bits) < set_->reach(i)) {
            return true;
        }
    }
    return false;
}

bool model_march::expand() {
    now_.emplace(model_step(tape_, varied_tape_, lifted_.given, monomials_, few_monomials_));
    now_->errors_ = set_->errors;
    now_->of_box_.about(time_, set_->models);
    now_->tail_ = tail_of(tape_, now_->of_box_);
    if (!now_->tail_) {
        return false;
    }
    std::vector<taylor_model> state;
    for (std::size_t i = 0; i < set_->models.size(); ++i) {
        state.push_back(set_->models[i].truncated(few_monomials_));
        state.back().add_to_rest(set_->reach(i));
    }
    for (std::size_t j = 0; j < set_->models.size(); ++j) {
        for (std::size_t i = 0; i < set_->models.size(); ++i) {
            state.emplace_back(few_monomials_, ball(i == j ? 1 : 0));
        }
    }
    now_->of_set_.about(time_, state);
    now_->set_tail_ = tail_of(varied_tape_, now_->of_set_);
    return now_->set_tail_.has_value();
}

// The longest step whose tails are small relative to the widths of the set, or to 2^-rounding_bits of unknowns without a
// width.
magnitude model_march::wanted_length() const {
    const std::size_t count = set_->models.size();
    const auto longest_by = [](const tail_bound& tail, std::size_t i, double allowed) {
        const double error = log_of(tail.error[i]);
        return error == nothing ? largest_tried : log_of(tail.radius) + (allowed - error) / (tail.degree + 1);
    };
    std::vector<double> widths;
    for (std::size_t i = 0; i < count; ++i) {
        const magnitude rounding = set_->models[i].norm() * magnitude::of(1, -rounding_bits);
        widths.push_back(log_of(std::max(set_->width(i), rounding)));
    }
    const double widest = *std::ranges::max_element(widths);
    for (double& each : widths) {
        each = each != nothing ? each : widest != nothing ? widest : 0;
    }
    double least = largest_tried;
    for (std::size_t i = 0; i < count; ++i) {
        least = std::min(least, longest_by(*now_->tail_, i, widths[i] + wanted_tail));
        for (std::size_t j = 0; j < count; ++j) {
            const double wanted = widths[i] - widths[j] + wanted_tail_of_derivative;
            least = std::min(least, longest_by(*now_->set_tail_, count * (j + 1) + i, wanted));
        }
    }
    return power_of_two(least);
}

ball_matrix model_march::derivative_at(const ball& distance, bool narrowly) const {
    const precision_scope few(decimal_digits(working_bits));
    model_matrix map = now_->derivative_of_flow(distance);
    map.erase(map.begin() + static_cast<std::ptrdiff_t>(lifted_.given), map.end());
    const model_matrix all = product_of(map, derivative_);
    if (!narrowly) {
        return ranges_of(all);
    }
    ball_matrix result;
    for (const auto& row : all) {
        auto& ranges = result.emplace_back();
        for (const taylor_model& each : row) {
            ranges.push_back(narrow_range(each, log2_of_excess_at_times, std::nullopt));
        }
    }
    return result;
}

const enclosed_step* model_march::prepare_towards(const ball& /*rest*/) {
    if (ready_) {
        return &*now_;
    }
    if (end_ != march_end::none) {
        return nullptr;
    }
    const precision_scope few(decimal_digits(working_bits));
    if (is_lost() || !expand()) {
        return stopped(march_end::precision);
    }
    // Whatever is wanted: the bounds hold within their radii only.
    now_->length_ = std::min({wanted_length(), now_->tail_->radius.shifted(-1), now_->set_tail_->radius.shifted(-1)});
    if (steps_ >= most_steps || now_->length_ <= magnitude(time_ - origin_) * magnitude::of(1, log2_of_shortest)) {
        return stopped(march_end::steps);
    }
    ready_ = true;
    return &*now_;
}

void model_march::take_prepared(int direction) {
    const precision_scope few(decimal_digits(working_bits));
    const ball distance = direction < 0 ? -now_->length_.exact() : now_->length_.exact();
    const model_matrix map = now_->derivative_of_flow(distance);
    std::vector<magnitude> added;
    std::vector<long> scales;
    for (std::size_t i = 0; i < set_->models.size(); ++i) {
        taylor_model& model = set_->models[i];
        model = now_->of_box_at(i, distance);
        added.push_back(model.rest());
        model.drop_rest();
        widest_[i] = std::max(widest_[i], model.width());
        scales.push_back(widest_[i].is_zero() ? 0 : widest_[i].exponent());
    }
    set_->errors = set_->errors.image(ranges_of(map), added).settled(scales);
    derivative_ = product_of(map, derivative_);
    arb_add(time_.handle(), time_.handle(), distance.handle(), ARF_PREC_EXACT);
    ready_ = false;
    if (++steps_ % model_steps_unwatched == 0 && watch_) {
        watch_(time_, working_bits);
    }
}

}  // namespace libration::ode
