#include "known_directions.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "../../algebra/dense_matrix.hpp"
#include "../../equation/linear_invariance.hpp"
#include "../../equation/power_sum.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

constexpr double independent_direction = 1e-6;

bool is_zero_form(const expression& e) {
    try {
        power_sums sums;
        return !sums.relations(std::vector<power_sum>{sums.of(e)}).empty();
    } catch (const no_power_sum&) {
        return false;
    }
}

// e with each of these linear expressions set to 0, if that determines a leaf.
class zero_averages {
public:
    zero_averages(const first_order_form& form, const std::vector<first_integral>& integrals) : form_(form) {
        for (const first_integral& each : integrals) {
            if (each.degree == 1 && is_slope_of_linear_function(each.value)) {
                add(set_in(each.value));
            }
        }
    }

    expression set_in(expression e) const {
        for (const auto& [leaf, value] : values_) {
            e = replaced(
                e, [&](const expression& each) { return same_form(each, leaf) ? std::optional(value) : std::nullopt; });
        }
        return e;
    }

private:
    bool is_slope_of_linear_function(const expression& integral) const {
        try {
            power_sums sums;
            std::vector<power_sum> all{sums.of(integral)};
            for (const expression& slope : form_.slopes) {
                all.push_back(sums.of(slope));
            }
            const auto found = sums.relations(all);
            return std::ranges::any_of(found, [](const auto& factors) { return factors.front() != 0; });
        } catch (const no_power_sum&) {
            return false;
        }
    }

    void add(const expression& linear) {
        for (const expression& leaf : form_.leaves) {
            const auto slope = partial(linear, leaf).fraction();
            if (slope && *slope != 0) {
                values_.emplace_back(leaf, leaf - linear * expression(rational(1 / *slope)));
                const auto& [of, value] = values_.back();
                values_.back().second = cleared(value, of);
                return;
            }
        }
    }

    // The value without the leaf itself, which occurs in it with the factor 0.
    static expression cleared(const expression& value, const expression& leaf) {
        return replaced(value, [&](const expression& each) {
            return same_form(each, leaf) ? std::optional(expression()) : std::nullopt;
        });
    }

    const first_order_form& form_;
    std::vector<std::pair<expression, expression>> values_;
};

// Adds the direction if it is independent of those before, in double precision, with columns divided by scales.
bool is_independent(std::vector<std::vector<double>>& basis, const std::vector<ball>& direction) {
    std::vector<double> rest;
    double size = 0;
    for (const ball& each : direction) {
        rest.push_back(as_double(each));
        size = std::max(size, std::abs(rest.back()));
    }
    if (!(size > independent_direction)) {
        return false;
    }
    for (const auto& each : basis) {
        double product = 0;
        for (std::size_t i = 0; i < rest.size(); ++i) {
            product += each[i] * rest[i];
        }
        for (std::size_t i = 0; i < rest.size(); ++i) {
            rest[i] -= product * each[i];
        }
    }
    double norm = 0;
    for (const double each : rest) {
        norm += each * each;
    }
    norm = std::sqrt(norm);
    if (!(norm > independent_direction * size)) {
        return false;
    }
    for (double& each : rest) {
        each /= norm;
    }
    basis.push_back(std::move(rest));
    return true;
}

}  // namespace

known_directions::known_directions(const first_order_form& form, const std::vector<first_integral>& integrals)
    : form_(form), integrals_(integrals) {
    const zero_averages averages(form, integrals);
    fields_.push_back({form.slopes, {}});
    for (auto& components : affine_symmetries_of(form)) {
        field each{std::move(components), {}};
        for (std::size_t k = 0; k < integrals.size(); ++k) {
            expression along;
            for (std::size_t i = 0; i < each.components.size(); ++i) {
                along = along + integrals[k].gradient[i] * each.components[i];
            }
            if (!is_zero_form(averages.set_in(along))) {
                each.conflicts.push_back(k);
            }
        }
        fields_.push_back(std::move(each));
    }
}

known_directions::at_state known_directions::at(const std::vector<ball>& state) const {
    at_state result;
    expression_values<ball> values(form_.leaves, ball(0));
    for (const ball& each : state) {
        values.push_back(each);
    }
    const auto evaluated = [&](const std::vector<expression>& of) {
        std::vector<ball> row;
        for (const expression& each : of) {
            row.push_back(values.of(each));
        }
        return row;
    };
    std::vector<std::vector<double>> basis;
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < integrals_.size(); ++k) {
        auto row = evaluated(integrals_[k].gradient);
        if (std::ranges::all_of(row, [](const ball& each) { return is_finite(each); }) && is_independent(basis, row)) {
            result.gradients.push_back(std::move(row));
            result.names.push_back("the integral " + integrals_[k].text);
            chosen.push_back(k);
        }
    }
    basis.clear();
    for (std::size_t f = 0; f < fields_.size(); ++f) {
        const bool conflicts = std::ranges::any_of(
            fields_[f].conflicts, [&](std::size_t k) { return std::ranges::find(chosen, k) != chosen.end(); });
        auto column = conflicts ? std::vector<ball>() : evaluated(fields_[f].components);
        if (!conflicts && is_independent(basis, column)) {
            result.fields.push_back(std::move(column));
            result.names.push_back(f == 0 ? "the direction of the orbit" : "a symmetry of the equations");
        }
    }
    return result;
}

}  // namespace libration::ode
