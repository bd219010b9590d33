#include "collocation_matrix.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "../../algebra/dense_matrix.hpp"
#include "../../algebra/rounded_matrix.hpp"

namespace libration::ode {

namespace {

constexpr std::size_t most_unknowns_of_whole = 2500;
constexpr int most_refinements_of_blocks = 60;
constexpr double enough_of_refinement = 1e-9;

double largest_of(const std::vector<double>& values) {
    double result = 0;
    for (const double each : values) {
        result = std::fabs(each) > result || std::isnan(each) ? std::fabs(each) : result;
    }
    return result;
}

}  // namespace

struct collocation_matrix::parts {
    // The modes begin, .. , begin + size - 1 over all nodes.
    struct block {
        std::size_t begin, size;
        real_lu<double> lu;
    };

    std::size_t nodes() const { return jacobians.size(); }

    // The factors of the modes of a block; index k size + a.
    bool factor(std::size_t begin, std::size_t size) {
        const std::size_t width = nodes() * size;
        std::vector<double> matrix(width * width, 0);
        for (std::size_t k = 0; k < nodes(); ++k) {
            for (std::size_t a = 0; a < size; ++a) {
                for (std::size_t c = 0; c < size; ++c) {
                    const double entry = jacobians[k][(begin + a) * modes + begin + c];
                    for (std::size_t i = 0; entry != 0 && i < nodes(); ++i) {
                        matrix[(i * size + a) * width + k * size + c] = -integrals[i * nodes() + k] * entry;
                    }
                }
            }
        }
        for (std::size_t i = 0; i < width; ++i) {
            matrix[i * width + i] += 1;
        }
        blocks.push_back({begin, size, {}});
        return blocks.back().lu.factor(matrix, width);
    }

    bool factor_blocks(const std::vector<std::size_t>& sizes) {
        blocks.clear();
        std::size_t begin = 0;
        for (const std::size_t each : sizes) {
            if (each > 0 && !factor(begin, each)) {
                return false;
            }
            begin += each;
        }
        return true;
    }

    // 1 - S (x) B times x.
    std::vector<double> times(const std::vector<double>& x, std::size_t columns) const {
        const auto length = static_cast<std::ptrdiff_t>(modes * columns);
        std::vector<double> moved;
        for (std::size_t k = 0; k < nodes(); ++k) {
            const auto begin = x.begin() + static_cast<std::ptrdiff_t>(k) * length;
            const auto here = product(jacobians[k], {begin, begin + length}, modes, columns);
            moved.insert(moved.end(), here.begin(), here.end());
        }
        std::vector<double> result = product(integrals, moved, nodes(), modes * columns);
        for (std::size_t i = 0; i < x.size(); ++i) {
            result[i] = x[i] - result[i];
        }
        return result;
    }

    // The solutions without the entries outside the blocks.
    std::vector<double> solved_by_blocks(const std::vector<double>& right, std::size_t columns) const {
        std::vector<double> result(right.size());
        std::vector<double> part;
        for (const block& each : blocks) {
            const std::size_t length = each.size * columns;
            const auto place = [&](std::size_t k) {
                return static_cast<std::ptrdiff_t>((k * modes + each.begin) * columns);
            };
            part.clear();
            for (std::size_t k = 0; k < nodes(); ++k) {
                const auto begin = right.begin() + place(k);
                part.insert(part.end(), begin, begin + static_cast<std::ptrdiff_t>(length));
            }
            part = each.lu.solved(part, columns);
            for (std::size_t k = 0; k < nodes(); ++k) {
                std::copy_n(part.begin() + static_cast<std::ptrdiff_t>(k * length), length, result.begin() + place(k));
            }
        }
        return result;
    }

    std::vector<double> integrals;
    std::vector<std::vector<double>> jacobians;
    std::size_t modes = 0;
    std::vector<block> blocks;
    bool refines = false;
};

collocation_matrix::collocation_matrix() : parts_(std::make_unique<parts>()) {}
collocation_matrix::~collocation_matrix() = default;

bool collocation_matrix::factor(const std::vector<double>& integrals, std::vector<std::vector<double>> jacobians,
                                const std::vector<std::size_t>& blocks) {
    parts& now = *parts_;
    now.integrals = integrals;
    now.jacobians = std::move(jacobians);
    now.modes = std::accumulate(blocks.begin(), blocks.end(), std::size_t{0});
    now.refines = now.nodes() * now.modes > most_unknowns_of_whole;
    return now.factor_blocks(now.refines ? blocks : std::vector{now.modes});
}

bool collocation_matrix::update(std::vector<std::vector<double>> jacobians) {
    parts& now = *parts_;
    now.jacobians = std::move(jacobians);
    return now.refines || now.factor_blocks({now.modes});
}

std::vector<double> collocation_matrix::solved(const std::vector<double>& right, std::size_t columns) const {
    const parts& now = *parts_;
    std::vector<double> x = now.solved_by_blocks(right, columns);
    double last = HUGE_VAL;
    for (int k = 0; now.refines && k < most_refinements_of_blocks; ++k) {
        std::vector<double> rest = now.times(x, columns);
        for (std::size_t i = 0; i < rest.size(); ++i) {
            rest[i] = right[i] - rest[i];
        }
        const std::vector<double> step = now.solved_by_blocks(rest, columns);
        const double size = largest_of(step);
        if (!(size < 2 * last)) {
            break;
        }
        last = size;
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] += step[i];
        }
        if (size <= enough_of_refinement * largest_of(x)) {
            break;
        }
    }
    return x;
}

}  // namespace libration::ode
