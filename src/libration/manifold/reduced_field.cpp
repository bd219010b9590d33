#include "reduced_field.hpp"

#include <algorithm>

#include "libration/equation/constant_value.hpp"
#include "libration/equation/defined_zero.hpp"

namespace libration::ode {

reduced_field::reduced_field(const explicit_system& of) : form_(of), sums_(conserved_sums_of(form_)) {
    for (const std::size_t k : sums_.kept) {
        auto& row = partials_.emplace_back();
        for (const expression& leaf : form_.leaves) {
            row.push_back(partial(form_.slopes[k], leaf));
        }
    }
    keep_domain();
    depends_on_time_ = std::ranges::any_of(form_.slopes, [](const expression& each) { return each.has_variable(); });
}

// The theorem needs slopes that are differentiable, so that their derivatives have no value where the slopes have none.
void reduced_field::keep_domain() {
    std::vector<expression> all;
    for (const auto& row : partials_) {
        all.insert(all.end(), row.begin(), row.end());
    }
    for (const expression& lost : parts_lost(form_.slopes, {}, all)) {
        if (!partials_.empty()) {
            expression& entry = partials_.front()[sums_.kept.front()];
            entry = entry + zero_where_defined(lost);
        }
    }
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
        ball value = start_of(sums_.eliminated[i]);
        for (std::size_t k = 0; k < kept.size(); ++k) {
            const ball start = start_of(sums_.kept[k]);
            value += from_rational<ball>(sums_.coefficients[i][k]) * (kept[k] - start);
            if (sums_.logarithms[i][k] != 0) {
                value += from_rational<ball>(sums_.logarithms[i][k]) * log(kept[k] / start);
            }
        }
        state[sums_.eliminated[i]] = std::move(value);
    }
    return state;
}

ball reduced_field::start_of(std::size_t unknown) const { return constant_value<ball>::of(form_.starts[unknown]); }

std::vector<ball> reduced_field::slopes_of_state(const std::vector<ball>& state) const {
    expression_values<ball> values(form_.leaves, ball(0));
    for (const ball& each : state) {
        values.push_back(each);
    }
    std::vector<ball> result;
    for (const expression& each : form_.slopes) {
        result.push_back(values.of(each));
    }
    return result;
}

std::vector<ball> reduced_field::eliminated_of(const std::vector<ball>& kept) const {
    const auto state = state_of(kept);
    std::vector<ball> result;
    for (const std::size_t e : sums_.eliminated) {
        result.push_back(state[e]);
    }
    return result;
}

ball reduced_field::relation_slope(std::size_t e, std::size_t k, const std::vector<ball>& kept) const {
    ball result = from_rational<ball>(sums_.coefficients[e][k]);
    if (sums_.logarithms[e][k] != 0) {
        result += from_rational<ball>(sums_.logarithms[e][k]) / kept[k];
    }
    return result;
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
                entry += values.of(partials_[i][sums_.eliminated[e]]) * relation_slope(e, j, kept);
            }
            result(i, j) = std::move(entry);
        }
    }
    return result;
}

}  // namespace libration::ode
