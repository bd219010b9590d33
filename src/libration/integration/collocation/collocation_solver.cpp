#include "collocation_solver.hpp"

#include <algorithm>
#include <cmath>

#include "../../algebra/rounded_matrix.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "step_control.hpp"

namespace libration::ode {

namespace {

constexpr double log10_of_2 = 0.30102999566398120;

double log10_of(const magnitude& x) { return log_of(x) * log10_of_2; }

}  // namespace

collocation_accuracy collocation_accuracy::for_bits(long bits, int more_terms) {
    collocation_accuracy result;
    result.accepted = static_cast<double>(bits) * log10_of_2 - 5;
    result.aimed = result.accepted + 4;
    result.degree = std::max(24, static_cast<int>(1.6 * result.aimed)) + more_terms;
    result.bits = static_cast<long>(result.aimed / log10_of_2) + 64;
    result.node_bits = 128;
    result.frame_bits = result.node_bits + 2L * result.degree;
    result.product_bits = result.bits + 2L * result.degree + 64;
    return result;
}

collocation_solver::collocation_solver(const polynomial_map& map, const stiff_guide& guide,
                                       const collocation_points& nodes, const collocation_accuracy& accuracy,
                                       const std::vector<ball>& constants)
    : map_(map), guide_(guide), nodes_(nodes), accuracy_(accuracy), constants_(constants) {}

collocation_solver::outcome collocation_solver::solve(const step_interval& on, const tube_set& start,
                                                      const std::vector<magnitude>& floors) {
    const precision_scope scope(decimal_digits(accuracy_.bits));
    on_ = on;
    start_ = &start;
    modes_.reset();
    factor_ = 0.5;
    if (!guess(start, floors) || !factor_matrix()) {
        return outcome::failed;
    }
    const outcome ended = iterate();
    if (ended != outcome::solved) {
        return ended;
    }
    compute_slopes();
    return measure_tail() ? outcome::solved : outcome::too_long;
}

// Values at the nodes to a few digits, and the scales.
bool collocation_solver::guess(const tube_set& start, const std::vector<magnitude>& floors) {
    stiff_guide::request asked;
    for (std::size_t i = 0; i < count(); ++i) {
        asked.start.push_back(as_long_double(start.centre[i]));
        asked.floors.push_back(as_long_double(floors[i].exact()));
    }
    const long double largest =
        std::fabs(*std::ranges::max_element(asked.start, {}, [](long double y) { return std::fabs(y); }));
    for (std::size_t i = 0; i < count(); ++i) {
        if (asked.start[i] == 0) {
            asked.floors[i] = std::max(asked.floors[i], 1e-8L * largest);
        }
    }
    asked.time = as_long_double(on_.start);
    asked.length = as_long_double(on_.length);
    std::vector<long double> parts;
    for (const ball& each : nodes_.places()) {
        parts.push_back((as_long_double(each) + 1) / 2);
    }
    const auto states = guide_.states(asked, parts);
    if (!states) {
        return false;
    }
    scales_.assign(count(), 0);
    for (std::size_t i = 0; i < count(); ++i) {
        magnitude most = std::max(magnitude(start.centre[i]), floors[i]);
        for (const auto& each : *states) {
            most = std::max(most, magnitude(exactly(each[i])));
        }
        scales_[i] = most.is_zero() ? 0 : most.exponent();
    }
    values_.clear();
    for (const auto& each : *states) {
        for (std::size_t i = 0; i < count(); ++i) {
            values_.push_back(shifted(exactly(each[i]), -scales_[i]));
        }
    }
    return std::ranges::all_of(values_, [](const ball& each) { return is_finite(each); });
}

void collocation_solver::compute_jacobians() {
    const precision_scope few(decimal_digits(accuracy_.node_bits));
    jacobians_.clear();
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        std::vector<ball> state;
        for (std::size_t i = 0; i < count(); ++i) {
            state.push_back(shifted(values_[k * count() + i], scales_[i]));
        }
        const ball time = on_.start + half() * (nodes_.places()[k] + 1);
        const auto all = map_.in(number_ring<ball>{constants_, time}, state, true);
        dense_matrix& j = jacobians_.emplace_back(count(), count());
        for (std::size_t place = 0; place < all.entries.size(); ++place) {
            const auto [row, column] = map_.places()[place];
            j(row, column) = shifted(all.entries[place] * half(), scales_[column] - scales_[row]);
        }
        j.keep_midpoints();
    }
}

void collocation_solver::compute_slopes() {
    slopes_.clear();
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        std::vector<ball> state;
        for (std::size_t i = 0; i < count(); ++i) {
            state.push_back(shifted(values_[k * count() + i], scales_[i]));
        }
        const ball time = on_.start + half() * (nodes_.places()[k] + 1);
        const auto f = map_.in(number_ring<ball>{constants_, time}, state, false).slopes;
        for (std::size_t i = 0; i < count(); ++i) {
            slopes_.push_back(midpoint_alone(shifted(f[i] * half(), -scales_[i])));
        }
    }
}

// The matrix of Newton's method, with the Jacobians in the basis of modes.
bool collocation_solver::factor_matrix() {
    compute_jacobians();
    const precision_scope few(decimal_digits(accuracy_.node_bits));
    const bool again = modes_.has_value();
    if (!again) {
        modes_ = modes_of(jacobians_[nodes_.size() / 2], accuracy_.node_bits, accuracy_.slowest_fast);
        if (!modes_) {
            return false;
        }
        basis_ = modes_->basis();
        auto back = inverse(basis_);
        if (!back) {
            return false;
        }
        to_basis_ = std::move(*back);
        to_basis_.keep_midpoints();
    }
    auto turned = jacobians_in_modes();
    stiffness_ = 1;
    for (const auto& each : turned) {
        for (const double entry : each) {
            stiffness_ = std::max(stiffness_, std::fabs(entry));
        }
    }
    if (again) {
        return matrix_.update(std::move(turned));
    }
    std::vector<std::size_t> blocks{modes_->slow.size()};
    blocks.insert(blocks.end(), modes_->fast_blocks.begin(), modes_->fast_blocks.end());
    return matrix_.factor(nodes_.rounded_integrals(), std::move(turned), blocks);
}

std::vector<std::vector<double>> collocation_solver::jacobians_in_modes() const {
    std::vector<std::vector<double>> result;
    const std::size_t n = count();
    if (n < least_size_in_double) {
        for (const dense_matrix& each : jacobians_) {
            result.push_back(in_double(product(to_basis_, product(each, basis_)).entries));
        }
        return result;
    }
    const auto basis = in_double(basis_.entries);
    const auto back = in_double(to_basis_.entries);
    for (const dense_matrix& each : jacobians_) {
        result.push_back(product(back, product(in_double(each.entries), basis, n, n), n, n));
    }
    return result;
}

std::vector<ball> collocation_solver::residual() const {
    std::vector<ball> result;
    const auto n = static_cast<int>(count());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        for (std::size_t c = 0; c < count(); ++c) {
            const ball sum = inner_product(&nodes_.integrals().entries[i * nodes_.size()], 1, &slopes_[c], n,
                                           static_cast<int>(nodes_.size()));
            const ball begin = shifted(start_->centre[c], -scales_[c]);
            result.push_back(midpoint_alone(begin + sum - values_[i * count() + c]));
        }
    }
    return result;
}

// Replaces residuals by corrections, and returns the size of these; component a at node k in column j is at ((k n) + a)
// columns + j.
magnitude collocation_solver::correct(std::vector<ball>& residual, std::size_t columns) const {
    const auto n = static_cast<int>(count());
    const auto turn = [&](const dense_matrix& by, const std::vector<ball>& of, std::vector<magnitude>& sizes) {
        std::vector<ball> result;
        result.reserve(of.size());
        sizes.assign(columns, {});
        for (std::size_t row = 0; row < nodes_.size() * count(); ++row) {
            const ball* at_node = &of[(row - row % count()) * columns];
            for (std::size_t j = 0; j < columns; ++j) {
                result.push_back(midpoint_alone(
                    inner_product(&by.entries[row % count() * count()], 1, at_node + j, static_cast<int>(columns), n)));
                sizes[j] = std::max(sizes[j], magnitude(result.back()));
            }
        }
        return result;
    };
    std::vector<magnitude> sizes;
    std::vector<ball> turned = turn(to_basis_, residual, sizes);
    std::vector<long> exponents;
    for (const magnitude& each : sizes) {
        if (!each.is_finite()) {
            return each;
        }
        exponents.push_back(each.is_zero() ? 0 : each.exponent());
    }
    std::vector<double> right;
    right.reserve(turned.size());
    for (std::size_t i = 0; i < turned.size(); ++i) {
        right.push_back(as_double(shifted(turned[i], -exponents[i % columns])));
    }
    const std::vector<double> solved = matrix_.solved(right, columns);
    for (std::size_t i = 0; i < turned.size(); ++i) {
        turned[i] = std::isfinite(solved[i]) ? shifted(exactly(solved[i]), exponents[i % columns]) : exactly(1e300);
    }
    residual = turn(basis_, turned, sizes);
    return *std::max_element(sizes.begin(), sizes.end());
}

collocation_solver::outcome collocation_solver::iterate() {
    double last = 0;
    int factorisations = 1;
    for (int k = 0; k < newton_control::most_iterations; ++k) {
        compute_slopes();
        std::vector<ball> step = residual();
        const magnitude size = correct(step, 1);
        const double now = size.is_finite() ? log10_of(size) : newton_control::diverged;
        if (now >= newton_control::diverged) {
            return outcome::failed;
        }
        for (std::size_t i = 0; i < values_.size(); ++i) {
            values_[i] = midpoint_alone(values_[i] + step[i]);
        }
        if (now < -accuracy_.accepted - 6) {
            return outcome::solved;
        }
        if (k > 0 && now - last > newton_control::gain) {
            if (factorisations < newton_control::most_factorisations) {
                if (!factor_matrix()) {
                    return outcome::failed;
                }
                ++factorisations;
            } else if (now - last > newton_control::none) {
                return outcome::failed;
            }
        }
        last = now;
    }
    return outcome::failed;
}

// True if the last Chebyshev coefficients are small enough and no given unknown decays too much; sets the next length.
bool collocation_solver::measure_tail() {
    const auto last = nodes_.size();
    step_measure measured{.tail = -1e300, .reached = 5};
    for (std::size_t c = 0; c < count(); ++c) {
        bool found = false;
        for (std::size_t l = last; l >= 2; --l) {
            const ball a = inner_product(&nodes_.coefficients_of_integral().entries[l * last], 1, &slopes_[c],
                                         static_cast<int>(count()), static_cast<int>(last));
            const double size = log10_of(magnitude::midpoint_of(a));
            measured.tail = l + 2 >= last ? std::max(measured.tail, size) : measured.tail;
            found = found || size > -accuracy_.aimed;
            measured.reached = size > -accuracy_.aimed ? std::max(measured.reached, l) : measured.reached;
            if (found && l + 2 < last) {
                break;
            }
        }
        if (c < map_.given() && start_->reach(c) < magnitude::below(start_->centre[c])) {
            measured.note_decay(log10_of(magnitude(start_->centre[c]).shifted(-scales_[c])),
                                log10_of(magnitude::midpoint_of(values_[last / 2 * count() + c])),
                                log10_of(magnitude::midpoint_of(values_[(last - 1) * count() + c])));
        }
    }
    factor_ = measured.factor(accuracy_.aimed, accuracy_.degree);
    return measured.is_acceptable(accuracy_.accepted);
}

}  // namespace libration::ode
