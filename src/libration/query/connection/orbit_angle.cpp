// The angle at which the manifolds of a connecting orbit intersect.
#include <algorithm>
#include <utility>

#include "connection_orbit.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

// The determinant of X^T X for the columns of X, by elimination with the largest pivots.
ball gram_determinant(const std::vector<std::vector<ball>>& columns) {
    const std::size_t n = columns.size();
    ball_matrix gram(n, std::vector<ball>(n));
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            for (std::size_t k = 0; k < columns[i].size(); ++k) {
                gram[i][j] += columns[i][k] * columns[j][k];
            }
        }
    }
    ball result(1);
    for (std::size_t k = 0; k < n; ++k) {
        const auto largest = std::max_element(
            gram.begin() + static_cast<std::ptrdiff_t>(k), gram.end(),
            [k](const auto& a, const auto& b) { return magnitude::below(abs(a[k])) < magnitude::below(abs(b[k])); });
        if (largest != gram.begin() + static_cast<std::ptrdiff_t>(k)) {
            std::swap(*largest, gram[k]);
            result = -result;
        }
        result *= gram[k][k];
        for (std::size_t i = k + 1; i < n; ++i) {
            const ball factor = gram[i][k] / gram[k][k];
            for (std::size_t j = k + 1; j < n; ++j) {
                gram[i][j] -= factor * gram[k][j];
            }
        }
    }
    return result;
}

// Each column minus its part along a direction.
void make_orthogonal(std::vector<std::vector<ball>>& columns, const std::vector<ball>& direction) {
    ball square(0);
    for (const ball& each : direction) {
        square += each * each;
    }
    for (auto& column : columns) {
        ball along(0);
        for (std::size_t i = 0; i < column.size(); ++i) {
            along += column[i] * direction[i];
        }
        for (std::size_t i = 0; i < column.size(); ++i) {
            column[i] -= along / square * direction[i];
        }
    }
}

std::vector<ball> column_of(const ball_matrix& rows, std::size_t j) {
    std::vector<ball> result;
    for (const auto& row : rows) {
        result.push_back(row[j]);
    }
    return result;
}

}  // namespace

// The derivative of the flow from the start to a time of the map, in the whole state, which contains the free numbers.
std::optional<dense_matrix> connection_orbit::flow_to(const ball& time, const std::vector<ball>& start, long bits,
                                                      std::vector<ball>& state) const {
    proved_march march(map_.open().system, start, bits, bits, {}, map_.route());
    march.keep_derivative();
    const ball target = constant_value<ball>::of(map_.open().system.point()) + time;
    const auto reached = march.at(target);
    if (!reached) {
        return std::nullopt;
    }
    state = *reached;
    dense_matrix result(state.size(), state.size());
    const auto rows = march.derivative_at(target);
    for (std::size_t i = 0; i < state.size(); ++i) {
        for (std::size_t j = 0; j < state.size(); ++j) {
            result(i, j) = rows[i][j];
        }
    }
    return result;
}

std::optional<ball> connection_orbit::angle(long bits) const {
    const precision_scope scope(decimal_digits(bits));
    const std::size_t numbers = map_.numbers();
    if (!map_.has_two_ends() || places_.size() + numbers != map_.form().leaves.size()) {
        return std::nullopt;
    }
    const auto from = map_.start_at(x_, bits, run_bits::usual_error_bits);
    const auto end = map_.right().at(map_.numbers_of_right(x_), theta_at_end(), map_.degree_for(bits), true);
    if (!from || !end) {
        return std::nullopt;
    }
    std::vector<ball> state;
    const auto to_end = flow_to(exactly(map_.time), from->values, bits, state);
    const auto here = to_end ? flow_to(phase_, from->values, bits, state) : std::nullopt;
    const auto back = here ? inverse(*to_end) : std::nullopt;
    if (!back) {
        return std::nullopt;
    }
    const dense_matrix from_end = product(*here, *back);
    const std::size_t first = map_.size() - map_.right().variables();
    const auto is_of_end = [&](std::size_t i) {
        return i >= numbers + map_.left_coordinates() && i < numbers + map_.coordinates();
    };
    std::vector<std::vector<ball>> of_start, of_end;
    for (std::size_t i = 0; i < first; ++i) {
        if (!is_of_end(i)) {
            of_start.push_back(product(*here, column_of(from->by_unknowns, i)));
        }
    }
    for (std::size_t i = 0; i < map_.size(); ++i) {
        if (i >= numbers && i < first && !is_of_end(i)) {
            continue;
        }
        const std::size_t of_right = i < numbers ? i : i - map_.left_coordinates();
        const auto& moving = map_.right().moving();
        std::vector<ball> column(state.size());
        for (std::size_t k = 0; k < state.size(); ++k) {
            const auto place = static_cast<std::size_t>(std::ranges::find(moving, k) - moving.begin());
            if (place < moving.size()) {
                column[k] = i < first ? end->by_numbers[place][of_right] : end->by_theta[place][i - first];
            } else if (i < numbers) {
                column[k] = from->by_unknowns[k][i];  // 1 for the number itself
            }
        }
        of_end.push_back(product(from_end, column));
    }
    // Both spaces contain the direction of the solution, at the end a combination of the last columns.
    const auto direction = map_.form().slopes_at(state, phase_);
    make_orthogonal(of_start, direction);
    make_orthogonal(of_end, direction);
    std::optional<ball> best;
    for (std::size_t j = of_end.size() - map_.right().variables(); j < of_end.size(); ++j) {
        auto each = of_end;
        each.erase(each.begin() + static_cast<std::ptrdiff_t>(j));
        if (of_start.empty() || each.empty()) {
            return std::nullopt;
        }
        auto both = of_start;
        both.insert(both.end(), each.begin(), each.end());
        const ball sine = sqrt(gram_determinant(both) / (gram_determinant(of_start) * gram_determinant(each)));
        if (is_finite(sine) && (!best || magnitude::radius_of(sine) < magnitude::radius_of(*best))) {
            best = sine;
        }
    }
    const auto result = best ? std::optional(asin(*best)) : std::nullopt;
    return result && is_finite(*result) ? result : std::nullopt;
}

}  // namespace libration::ode
