#include "model_expansion.hpp"

#include <stdexcept>

#include "libration/scalar/ball/functions.hpp"

namespace libration::ode {

model_expansion::model_expansion(const tape& of, int order, const monomial_set& in)
    : tape_(&of), order_(order), in_(&in), states_(of.orders().size(), -1) {
    for (const number& each : of.constants()) {
        constants_.push_back(constant_value<ball>::of(each));
    }
    for (const tape_state& each : of.states()) {
        states_[static_cast<std::size_t>(each.unknown)] = each.step;
    }
}

void model_expansion::about(const ball& point, const std::vector<taylor_model>& state) {
    point_ = point;
    const auto length = static_cast<std::size_t>(order_) + 1;
    steps_.assign(tape_->steps().size(), {});
    unknowns_.assign(states_.size(), {});
    for (std::size_t i = 0; i < unknowns_.size(); ++i) {
        unknowns_[i].reserve(length);
        unknowns_[i].push_back(state[i]);
    }
    for (std::size_t n = 0; n + 1 < length; ++n) {
        for (std::size_t k = 0; k < steps_.size(); ++k) {
            steps_[k].push_back(computed(tape_->steps()[k], n));
        }
        const ball factor = ball(1) / ball(static_cast<long>(n) + 1);
        for (std::size_t i = 0; i < unknowns_.size(); ++i) {
            unknowns_[i].push_back(factor * steps_[static_cast<std::size_t>(tape_->outputs()[i])][n]);
        }
    }
}

ball model_expansion::factor_of(const tape_step& step) const {
    return step.constant >= 0 ? constants_[static_cast<std::size_t>(step.constant)]
                              : ball(ball(step.numerator) / ball(step.denominator));
}

taylor_model model_expansion::computed(const tape_step& step, std::size_t n) const {
    const auto left = [&]() -> const std::vector<taylor_model>& { return steps_[static_cast<std::size_t>(step.left)]; };
    const auto right = [&]() -> const std::vector<taylor_model>& {
        return steps_[static_cast<std::size_t>(step.right)];
    };
    switch (step.kind) {
        case operation::constant:
            return n == 0 ? taylor_model(*in_, constants_[static_cast<std::size_t>(step.constant)])
                          : taylor_model(*in_);
        case operation::variable: return n > 1 ? taylor_model(*in_) : taylor_model(*in_, n == 0 ? point_ : ball(1));
        case operation::state: return unknowns_[static_cast<std::size_t>(step.left)][n];
        case operation::sum: return left()[n] + right()[n];
        case operation::difference: return left()[n] - right()[n];
        case operation::scaled: return factor_of(step) * left()[n];
        case operation::raised:
            return n == 0 ? left()[0] + constants_[static_cast<std::size_t>(step.constant)] : left()[n];
        case operation::by_variable: return n == 0 ? point_ * left()[0] : (point_ * left()[n]) + left()[n - 1];
        case operation::product: return product_coefficient(left(), right(), n);
        case operation::square: return product_coefficient(left(), left(), n);
        case operation::delayed:
        case operation::quotient:
        case operation::slope:
        case operation::square_root:
        case operation::power:
        case operation::function:
        case operation::primitive:
        case operation::companion: break;
    }
    throw std::logic_error("Taylor models are expanded with products and sums alone");
}

taylor_model model_expansion::at(std::size_t unknown, const ball& distance) const {
    std::vector<ball> powers{ball(1)};
    for (int n = 1; n <= order_; ++n) {
        powers.push_back(pow(distance, n));
    }
    return linear_combination(powers, unknowns_[unknown]);
}

std::vector<magnitude> model_expansion::sizes_of(std::size_t unknown) const {
    std::vector<magnitude> sizes;
    for (const taylor_model& each : unknowns_[unknown]) {
        sizes.push_back(each.size());
    }
    return sizes;
}

series_sizes model_expansion::sizes() const {
    series_sizes result{order_, {}, {}, magnitude(point_)};
    for (const ball& each : constants_) {
        result.constants.emplace_back(each);
    }
    for (const auto& of_step : steps_) {
        auto& row = result.of_steps.emplace_back();
        for (const taylor_model& each : of_step) {
            row.push_back(each.size());
        }
    }
    for (std::size_t i = 0; i < states_.size(); ++i) {
        if (states_[i] >= 0) {
            result.of_steps[static_cast<std::size_t>(states_[i])].push_back(unknowns_[i].back().size());
        }
    }
    return result;
}

}  // namespace libration::ode
