#include "linear_steps.hpp"

#include <algorithm>
#include <utility>

#include "libration/equation/constant_value.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

void add_scaled(std::vector<complex_jet>& sum, const complex_jet& by, const std::vector<complex_jet>& of) {
    sum.resize(std::max(sum.size(), of.size()));
    for (std::size_t j = 0; j < of.size(); ++j) {
        sum[j].add_product(by, of[j]);
    }
}

class steps_at_rest {
public:
    steps_at_rest(const field_at_rest& field, const jet_matrix& q) : field_(field) {
        const auto& states = field.of->states();
        for (const tape_step& step : field.of->steps()) {
            done_.push_back(step.kind == operation::state ? linear_step() : value_of(step));
            if (step.kind == operation::state) {
                const auto state = std::ranges::find(states, static_cast<int>(done_.size()) - 1, &tape_state::step);
                done_.back() = of_state(static_cast<std::size_t>(state->unknown), q);
            }
        }
    }
    std::vector<linear_step> result() && { return std::move(done_); }

private:
    linear_step of_state(std::size_t unknown, const jet_matrix& q) const {
        const auto place = std::ranges::find(field_.moving, unknown);
        linear_step result{field_.centre[unknown], {}, 0};
        if (place != field_.moving.end()) {
            result.linear = q[static_cast<std::size_t>(place - field_.moving.begin())];
            result.degree = 1;
        }
        return result;
    }

    static complex_jet constant_on(const tape& of, const tape_step& step) {
        return real_jet(step.constant < 0
                            ? ball(step.numerator) / step.denominator
                            : constant_value<ball>::of(of.constants()[static_cast<std::size_t>(step.constant)]));
    }

    linear_step sum(const tape_step& step, int sign) const {
        const linear_step& a = at(step.left);
        const linear_step& b = at(step.right);
        const complex_jet factor = real_jet(ball(sign));
        linear_step result{a.centre,
                           a.linear,
                           std::max(a.degree, b.degree),
                           polynomial_operation::sum,
                           static_cast<std::size_t>(step.left),
                           static_cast<std::size_t>(step.right),
                           factor};
        result.centre.add_product(factor, b.centre);
        add_scaled(result.linear, factor, b.linear);
        return result;
    }

    linear_step multiple(const tape_step& step, const complex_jet& factor, const complex_jet& constant) const {
        const linear_step& a = at(step.left);
        linear_step result{
            constant, {}, a.degree, polynomial_operation::multiple, static_cast<std::size_t>(step.left), 0, factor};
        result.centre.add_product(factor, a.centre);
        add_scaled(result.linear, factor, a.linear);
        return result;
    }

    linear_step product_of(int left, int right) const {
        const linear_step& a = at(left);
        const linear_step& b = at(right);
        linear_step result{a.centre * b.centre,
                           {},
                           a.degree + b.degree,
                           polynomial_operation::product,
                           static_cast<std::size_t>(left),
                           static_cast<std::size_t>(right)};
        add_scaled(result.linear, a.centre, b.linear);
        add_scaled(result.linear, b.centre, a.linear);
        return result;
    }

    linear_step value_of(const tape_step& step) const {
        const auto is = [&](operation kind) { return step.kind == kind; };
        if (is(operation::constant)) {
            return {constant_on(*field_.of, step), {}};
        }
        if (is(operation::sum) || is(operation::difference)) {
            return sum(step, is(operation::sum) ? 1 : -1);
        }
        if (is(operation::scaled)) {
            return multiple(step, constant_on(*field_.of, step), {});
        }
        if (is(operation::raised)) {
            return multiple(step, real_jet(ball(1)), constant_on(*field_.of, step));
        }
        if (is(operation::product) || is(operation::square)) {
            return product_of(step.left, is(operation::square) ? step.left : step.right);
        }
        throw error(
            error_kind::undecided, error_subject::problem, "",
            "depends on time, or has a right-hand side without a polynomial form: conditions at infinity require "
            "an autonomous system of polynomials and of functions that solve such equations");
    }

    const linear_step& at(int step) const { return done_[static_cast<std::size_t>(step)]; }

    const field_at_rest& field_;
    std::vector<linear_step> done_;
};

}  // namespace

std::vector<linear_step> linear_steps(const field_at_rest& field, const jet_matrix& q) {
    return steps_at_rest(field, q).result();
}

jet_matrix linear_part(const field_at_rest& field) {
    const auto steps = linear_steps(field, unit_jets(field.moving.size()));
    jet_matrix result;
    for (const std::size_t i : field.moving) {
        auto row = steps[static_cast<std::size_t>(field.of->outputs()[i])].linear;
        row.resize(field.moving.size());
        if (field.direction < 0) {
            std::ranges::transform(row, row.begin(), [](const complex_jet& x) { return -x; });
        }
        result.push_back(std::move(row));
    }
    return result;
}

}  // namespace libration::ode
