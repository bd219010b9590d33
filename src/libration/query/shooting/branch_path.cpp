#include "branch_path.hpp"

#include <algorithm>
#include <cmath>

#include "../../algebra/dense_matrix.hpp"
#include "libration/digits/precision_loop.hpp"

namespace libration::ode {

namespace {

constexpr long bits_of_path = 128;
constexpr double longest_branch_step = 0.1;
constexpr double shortest_branch_step = 1e-9;
constexpr double growth_of_step = 1.5;
constexpr double least_cosine = 0.95;         // 18 degrees
constexpr double small_turn = 0.99;           // after which steps grow
constexpr double settled_correction = 1e-10;  // of Newton's method, relative to the weights
constexpr int most_corrections = 8;
constexpr int most_bisections = 60;

// The rows of a map with one more row, and the right-hand side with which they are solved.
std::optional<std::vector<double>> bordered_solution(std::vector<double> rows, const std::vector<double>& last,
                                                     const std::vector<double>& right) {
    rows.insert(rows.end(), last.begin(), last.end());
    real_lu<double> factors;
    if (!factors.factor(rows, last.size())) {
        return std::nullopt;
    }
    auto solution = factors.solved(right);
    const bool finite = std::ranges::all_of(solution, [](double each) { return std::isfinite(each); });
    return finite ? std::optional(std::move(solution)) : std::nullopt;
}

double weighted_product(const std::vector<double>& weights, const std::vector<double>& a,
                        const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += weights[i] * weights[i] * a[i] * b[i];
    }
    return sum;
}

}  // namespace

double weighted_length(const std::vector<double>& weights, const std::vector<double>& a) {
    return std::sqrt(weighted_product(weights, a, a));
}

branch_piece::branch_piece(const branch_node& from, const branch_node& to) : from_(from), to_(to) {
    std::vector<double> chord;
    for (std::size_t i = 0; i < from.z.size(); ++i) {
        chord.push_back(to.z[i] - from.z[i]);
    }
    length_ = weighted_length(to.weights, chord);
}

std::vector<double> branch_piece::at(double part) const {
    const double rest = 1 - part;
    std::vector<double> z;
    for (std::size_t i = 0; i < from_.z.size(); ++i) {
        z.push_back(rest * rest * (1 + 2 * part) * from_.z[i] + part * part * (3 - 2 * part) * to_.z[i] +
                    length_ * part * rest * (rest * from_.tangent[i] - part * to_.tangent[i]));
    }
    return z;
}

double branch_piece::part_at(double lambda) const {
    const bool rising = from_.z.back() < to_.z.back();
    double low = 0;
    double high = 1;
    for (int i = 0; i < most_bisections; ++i) {
        const double middle = (low + high) / 2;
        ((at(middle).back() < lambda) == rising ? low : high) = middle;
    }
    return (low + high) / 2;
}

std::optional<branch_path::linear_map> branch_path::map_at(const std::vector<double>& z) const {
    const precision_scope scope(decimal_digits(bits_of_path));
    std::vector<ball> exact;
    exact.reserve(z.size());
    for (const double each : z) {
        exact.push_back(exactly(each));
    }
    const auto map = f_(exact, bits_of_path, run_bits::usual_error_bits);
    if (!map) {
        return std::nullopt;
    }
    linear_map result;
    for (std::size_t i = 0; i < map->value.size(); ++i) {
        result.value.push_back(as_double(map->value[i]));
        for (const ball& each : map->derivative[i]) {
            result.rows.push_back(as_double(each));
        }
    }
    return result;
}

std::vector<double> branch_path::weights_at(const std::vector<double>& z) const {
    std::vector<double> weights;
    weights.reserve(z.size());
    for (const double each : z) {
        weights.push_back(1 / std::max(1.0, std::abs(each)));
    }
    weights.back() = 1 / range_;
    return weights;
}

std::optional<branch_node> branch_path::begin(const std::vector<double>& z, double direction) const {
    std::vector<double> along(z.size(), 0);
    along.back() = direction;
    return node_at(z, along);
}

std::optional<branch_node> branch_path::node_at(const std::vector<double>& z,
                                                const std::vector<double>& tangent_near) const {
    const auto map = map_at(z);
    if (!map) {
        return std::nullopt;
    }
    std::vector<double> right(z.size(), 0);
    right.back() = 1;
    auto tangent = bordered_solution(map->rows, tangent_near, right);
    if (!tangent) {
        return std::nullopt;
    }
    const auto weights = weights_at(z);
    const double length = weighted_length(weights, *tangent);
    for (double& each : *tangent) {
        each /= length;
    }
    return branch_node{z, *std::move(tangent), weights};
}

std::optional<branch_node> branch_path::corrected(const branch_node& from, double step) const {
    std::vector<double> predicted = from.z;
    std::vector<double> across;
    for (std::size_t i = 0; i < predicted.size(); ++i) {
        predicted[i] += step * from.tangent[i];
        across.push_back(from.weights[i] * from.weights[i] * from.tangent[i]);
    }
    std::vector<double> z = predicted;
    for (int i = 0; i < most_corrections; ++i) {
        const auto map = map_at(z);
        if (!map) {
            return std::nullopt;
        }
        std::vector<double> right = map->value;
        double beyond = 0;
        for (std::size_t k = 0; k < z.size(); ++k) {
            beyond += across[k] * (z[k] - predicted[k]);
        }
        right.push_back(beyond);
        const auto correction = bordered_solution(map->rows, across, right);
        if (!correction) {
            return std::nullopt;
        }
        for (std::size_t k = 0; k < z.size(); ++k) {
            z[k] -= (*correction)[k];
        }
        const double size = weighted_length(from.weights, *correction);
        if (size < settled_correction) {
            return node_at(z, from.tangent);
        }
        if (!(size < step)) {
            return std::nullopt;
        }
    }
    return std::nullopt;
}

std::optional<branch_node> branch_path::next(const branch_node& from) {
    for (; step_ >= shortest_branch_step; step_ /= 2) {
        auto node = corrected(from, step_);
        const double cosine = node ? weighted_product(node->weights, node->tangent, from.tangent) /
                                         weighted_length(node->weights, from.tangent)
                                   : 0;
        if (cosine >= least_cosine) {
            if (cosine >= small_turn) {
                step_ = std::min(longest_branch_step, step_ * growth_of_step);
            }
            return node;
        }
    }
    return std::nullopt;
}

}  // namespace libration::ode
