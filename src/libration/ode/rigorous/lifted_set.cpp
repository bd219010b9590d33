#include "lifted_set.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "ball_polynomial.hpp"
#include "dense_matrix.hpp"
#include "fast_modes.hpp"
#include "libration/ode/ball/step_pieces.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

// log2 of the size of unit vectors relative to that of the set: they replace directions in which it has no width.
constexpr long size_of_units = -40;

bool are_finite(const std::vector<ball>& values) {
    return std::ranges::all_of(values, [](const ball& each) { return is_finite(each); });
}

// Unknown i, with its derivatives with respect to the given ones, added to the set.
void add_unknown(tube_set& set, const ball& at_centre, const std::vector<ball>& derivatives) {
    const ball centre = midpoint_alone(at_centre);
    magnitude rest(at_centre - centre);
    for (std::size_t j = 0; j < derivatives.size(); ++j) {
        rest.add_product(magnitude(derivatives[j]), set.added[j]);
    }
    for (auto& column : set.columns) {
        column.push_back(inner_product(derivatives.data(), 1, column.data(), 1, static_cast<int>(derivatives.size())));
    }
    set.centre.push_back(centre);
    set.added.push_back(rest);
}

// The exponents of the widths of the first unknowns, 0 for those without one.
std::vector<long> exponents_of(std::size_t count, const tube_set& set) {
    std::vector<long> result;
    for (std::size_t i = 0; i < count; ++i) {
        const magnitude reach = set.reach(i);
        result.push_back(reach.is_zero() ? 0 : reach.exponent());
    }
    return result;
}

// The radius of each column: a block of two with the Euclidean norm lies in a box.
std::vector<magnitude> radii_of_columns(const tube_set& set) {
    std::vector<magnitude> result;
    for (std::size_t b = 0; b < set.blocks.size(); ++b) {
        result.insert(result.end(), set.blocks[b], set.radii[b]);
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

std::optional<tube_set> lifted_set(const lifted_system& of, const ball& time, const tube_set& given) {
    const std::size_t count = of.leaves.size();
    if (count == of.given) {
        return given;
    }
    std::vector<ball> hull;
    for (std::size_t i = 0; i < of.given; ++i) {
        hull.push_back(widened(given.centre[i] + 0, given.reach(i)));
    }
    const auto at_centre = lifted_values(of, time, given.centre);
    const auto varied = varied_values(of, time, hull);
    if (!are_finite(at_centre) || !are_finite(varied)) {
        return std::nullopt;
    }
    tube_set result = given;
    for (std::size_t i = of.given; i < count; ++i) {
        std::vector<ball> derivatives;
        for (std::size_t j = 0; j < of.given; ++j) {
            derivatives.push_back(varied[count * (j + 1) + i]);
        }
        add_unknown(result, at_centre[i], derivatives);
    }
    return result;
}

std::optional<tube_set> set_of_first(std::size_t count, const tube_set& of) {
    tube_set result{{of.centre.begin(), of.centre.begin() + static_cast<std::ptrdiff_t>(count)},
                    {},
                    std::vector<std::size_t>(count, 1),
                    {},
                    std::vector<magnitude>(count),
                    count};
    const auto radii = radii_of_columns(of);
    if (of.columns.size() == count && of.centre.size() == count) {
        result.columns = of.columns;
        result.radii = radii;
        result.added = of.added;
        return result;
    }
    const auto scales = exponents_of(count, of);
    dense_matrix columns(count, of.columns.size());
    for (std::size_t k = 0; k < of.columns.size(); ++k) {
        for (std::size_t i = 0; i < count; ++i) {
            columns(i, k) = shifted(of.columns[k][i], -scales[i]);
        }
    }
    const dense_matrix basis = longest_directions(columns, radii);
    const auto back = inverse(basis);
    if (!back) {
        return std::nullopt;
    }
    const dense_matrix turned = product(*back, columns);
    for (std::size_t i = 0; i < count; ++i) {
        magnitude radius;
        for (std::size_t k = 0; k < radii.size(); ++k) {
            radius.add_product(magnitude(turned(i, k)), radii[k]);
        }
        for (std::size_t k = 0; k < count; ++k) {
            radius.add_product(magnitude((*back)(i, k)), of.added[k].shifted(-scales[k]));
        }
        result.radii.push_back(radius);
        result.columns.emplace_back();
        for (std::size_t k = 0; k < count; ++k) {
            result.columns.back().push_back(shifted(basis(k, i), scales[k]));
        }
    }
    return result;
}

}  // namespace libration::ode
