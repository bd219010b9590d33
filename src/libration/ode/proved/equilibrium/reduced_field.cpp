#include "reduced_field.hpp"

#include <algorithm>

#include "libration/ode/constant_value.hpp"

namespace libration::ode {

reduced_field::reduced_field(const explicit_system& of) : form_(of), sums_(conserved_sums_of(form_)) {
    for (const std::size_t k : sums_.kept) {
        auto& row = partials_.emplace_back();
        for (const expression& leaf : form_.leaves) {
            row.push_back(partial(form_.slopes[k], leaf));
        }
    }
    depends_on_time_ = std::ranges::any_of(form_.slopes, [](const expression& each) { return each.has_variable(); });
}

std::vector<ball> reduced_field::kept_of(const std::vector<ball>& state) const {
    std::vector<ball> kept;
    for (const std::size_t k : sums_.kept) {
        kept.push_back(state[k]);
    }
    return kept;
}

std::vector<ball> reduced_field::state_of(const std::vector<ball>& kept) const {
    std::vector<ball> state(form_.leaves.size());
    for (std::size_t k = 0; k < kept.size(); ++k) {
        state[sums_.kept[k]] = kept[k];
    }
    for (std::size_t i = 0; i < sums_.eliminated.size(); ++i) {
        ball value = constant_value<ball>::of(sums_.constants[i]);
        for (std::size_t k = 0; k < kept.size(); ++k) {
            value += constant_value<ball>::of(number(sums_.coefficients[i][k])) * kept[k];
        }
        state[sums_.eliminated[i]] = std::move(value);
    }
    return state;
}

expression_values<ball> reduced_field::values_at(const std::vector<ball>& kept) const {
    expression_values<ball> values(form_.leaves, ball(0));
    for (const ball& each : state_of(kept)) {
        values.push_back(each);
    }
    return values;
}

std::vector<ball> reduced_field::slopes(const std::vector<ball>& kept) const {
    auto values = values_at(kept);
    std::vector<ball> result;
    for (const std::size_t k : sums_.kept) {
        result.push_back(values.of(form_.slopes[k]));
    }
    return result;
}

dense_matrix reduced_field::derivative(const std::vector<ball>& kept) const {
    auto values = values_at(kept);
    dense_matrix result(size(), size());
    for (std::size_t i = 0; i < size(); ++i) {
        for (std::size_t j = 0; j < size(); ++j) {
            ball entry = values.of(partials_[i][sums_.kept[j]]);
            for (std::size_t e = 0; e < sums_.eliminated.size(); ++e) {
                entry += values.of(partials_[i][sums_.eliminated[e]]) *
                         constant_value<ball>::of(number(sums_.coefficients[e][j]));
            }
            result(i, j) = std::move(entry);
        }
    }
    return result;
}

}  // namespace libration::ode
