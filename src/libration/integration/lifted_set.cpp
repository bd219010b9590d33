#include "lifted_set.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "../algebra/dense_matrix.hpp"
#include "collocation/ball_polynomial.hpp"
#include "collocation/fast_modes.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

// log2 of the size of unit vectors relative to that of the set: they replace directions in which it has no width.
constexpr long size_of_units = -40;

bool are_finite(const std::vector<ball>& values) {
    return std::ranges::all_of(values, [](const ball& each) { return is_finite(each); });
}

// The exponents of the widths of the first unknowns, 0 for those without one.
std::vector<long> exponents_of(std::size_t count, const state_set& set) {
    std::vector<long> result;
    for (std::size_t i = 0; i < count; ++i) {
        const magnitude reach = set.reach(i);
        result.push_back(reach.is_zero() ? 0 : reach.exponent());
    }
    return result;
}

dense_matrix longest_directions(const dense_matrix& columns, const std::vector<magnitude>& radii) {
    ball_columns candidates;
    for (std::size_t k = 0; k < columns.columns; ++k) {
        std::vector<ball> each = columns.column(k);
        for (ball& entry : each) {
            entry = midpoint_alone(entry * radii[k].exact());
        }
        candidates.push_back(std::move(each));
    }
    const dense_matrix units = dense_matrix::unit(columns.rows);
    for (std::size_t k = 0; k < columns.rows; ++k) {
        candidates.push_back(shifted(units.column(k), size_of_units));
    }
    ball_columns basis;
    extend_orthonormal(basis, std::move(candidates), columns.rows, true);
    dense_matrix result(columns.rows, columns.rows);
    for (std::size_t k = 0; k < basis.size(); ++k) {
        result.set_column(k, basis[k]);
    }
    return result;
}

}  // namespace

std::optional<tube_set> lifted_set(const polynomial_form& of, const ball& time, const state_set& given) {
    const std::size_t count = of.leaves.size();
    if (count == of.given) {
        return tube_set{given, given.errors.columns().size()};
    }
    const auto at_centre = lifted_values(of, time, given.centre);
    const auto varied = varied_values(of, time, given.hull());
    if (!are_finite(at_centre) || !are_finite(varied)) {
        return std::nullopt;
    }
    tube_set result{given, given.errors.columns().size()};
    for (std::size_t i = of.given; i < count; ++i) {
        std::vector<ball> derivatives;
        for (std::size_t j = 0; j < of.given; ++j) {
            derivatives.push_back(varied[count * (j + 1) + i]);
        }
        result.centre.push_back(midpoint_alone(at_centre[i]));
        result.errors.add_coordinate(derivatives, magnitude(at_centre[i] - result.centre.back()));
    }
    return result;
}

std::optional<state_set> set_of_first(std::size_t count, const state_set& of) {
    const lohner_set& errors = of.errors;
    const auto radii = errors.radii_of_columns();
    const std::vector<std::size_t> single(count, 1);
    std::vector<ball> centre(of.centre.begin(), of.centre.begin() + static_cast<std::ptrdiff_t>(count));
    if (errors.columns().size() == count && of.centre.size() == count) {
        return state_set{std::move(centre), lohner_set(errors.columns(), single, radii, errors.added())};
    }
    const auto scales = exponents_of(count, of);
    dense_matrix columns(count, radii.size());
    for (std::size_t k = 0; k < radii.size(); ++k) {
        for (std::size_t i = 0; i < count; ++i) {
            columns(i, k) = shifted(errors.columns()[k][i], -scales[i]);
        }
    }
    const dense_matrix basis = longest_directions(columns, radii);
    const auto back = inverse(basis);
    if (!back) {
        return std::nullopt;
    }
    const dense_matrix turned = product(*back, columns);
    ball_matrix of_basis(count);
    std::vector<magnitude> of_radii(count);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < radii.size(); ++k) {
            of_radii[i].add_product(magnitude(turned(i, k)), radii[k]);
        }
        for (std::size_t k = 0; k < count; ++k) {
            of_radii[i].add_product(magnitude((*back)(i, k)), errors.added()[k].shifted(-scales[k]));
            of_basis[i].push_back(shifted(basis(k, i), scales[k]));
        }
    }
    return state_set{std::move(centre),
                     lohner_set(std::move(of_basis), single, std::move(of_radii), std::vector<magnitude>(count))};
}

}  // namespace libration::ode
