#include <algorithm>
#include <cmath>

#include "../../algebra/rounded_matrix.hpp"
#include "collocation_solver.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

// Log2 of the norm of their inverses from which the slow columns are chosen again.
constexpr long kept_inverse = 10;    // 2^10
constexpr long usable_inverse = 20;  // 2^20
constexpr int most_refinements = 6;
// Smaller than every radius, so that the columns of the error set have priority.
constexpr long last_resort = -100'000;

// The decimal digits of frames: an error e of a frame lets the radii of slow modes grow by e + e^2 |lambda| per step,
// lambda of the fastest mode and with the time x.
double digits_of_frame(double stiffness) { return std::clamp(4 + std::log10(stiffness) / 2, 7., 15.); }

dense_matrix of_columns(const ball_columns& slow, const ball_columns& fast) {
    const std::size_t size = slow.size() + fast.size();
    dense_matrix result(size, size);
    for (std::size_t k = 0; k < size; ++k) {
        result.set_column(k, k < slow.size() ? slow[k] : fast[k - slow.size()]);
    }
    return result;
}

bool has_inverse_below(const ball_columns& slow, const ball_columns& fast, long exponent) {
    const auto back = inverse(of_columns(slow, fast));
    return back && back->largest() < magnitude::of(1, exponent);
}

std::vector<ball> of_length_1(std::vector<ball> v) {
    ball_columns unit;
    extend_orthonormal(unit, {std::move(v)}, 1, false);
    return unit.front();
}

}  // namespace

// The slow columns at the start of the step: those at the end of the previous step if their number is the same and they
// are far enough from each other and from the fast ones, so that no wrapping occurs. Otherwise the subspace of their
// longest combinations with slow modes of the middle, and in it, along the fast columns, a basis of the largest columns
// of the error set, by Lohner's rule.
bool collocation_solver::slow_start(ball_columns& slow) {
    // The columns of an error set times their radii may be nearly dependent.
    const precision_scope scope(decimal_digits(accuracy_.product_bits));
    const std::size_t asked = modes_->slow.size();
    ball_columns old;
    ball_columns lengths_1;
    for (std::size_t j = 0; j < start_->errors.columns().size(); ++j) {
        std::vector<ball> scaled;
        for (std::size_t i = 0; i < count(); ++i) {
            scaled.push_back(midpoint_alone(shifted(start_->errors.columns()[j][i], -scales_[i])));
        }
        if (j < start_->slow) {
            lengths_1.push_back(of_length_1(scaled));
        }
        old.push_back(std::move(scaled));
    }
    if (asked == start_->slow && has_inverse_below(lengths_1, modes_->fast, kept_inverse)) {
        slow = lengths_1;
        return true;
    }
    const ball_columns followed(old.begin(), old.begin() + static_cast<std::ptrdiff_t>(start_->slow));
    extend_orthonormal(slow, asked < start_->slow ? followed : lengths_1, std::min(asked, start_->slow), true);
    extend_orthonormal(slow, modes_->slow, asked - slow.size(), true);
    if (!has_inverse_below(slow, modes_->fast, usable_inverse)) {
        slow = modes_->slow;
    }
    const auto back = inverse(of_columns(slow, modes_->fast));
    if (!back) {
        return false;
    }
    ball_columns errors;
    std::size_t column = 0;
    for (std::size_t b = 0; b < start_->errors.blocks().size(); ++b) {
        for (std::size_t k = 0; k < start_->errors.blocks()[b]; ++k) {
            const std::vector<ball> parts = product(*back, old[column++]);
            std::vector<ball> sum(count());
            for (std::size_t i = 0; i < count(); ++i) {
                for (std::size_t a = 0; a < asked; ++a) {
                    sum[i] += slow[a][i] * parts[a];
                }
                sum[i] = midpoint_alone(sum[i] * start_->errors.radii()[b].exact());
            }
            errors.push_back(std::move(sum));
        }
    }
    for (const auto& each : slow) {
        errors.push_back(shifted(each, last_resort));
    }
    ball_columns along_errors;
    extend_orthonormal(along_errors, std::move(errors), asked, true);
    if (has_inverse_below(along_errors, modes_->fast, usable_inverse)) {
        slow = std::move(along_errors);
    }
    return true;
}

// J s at the nodes, by the entries of J that are not identically 0.
std::vector<ball> collocation_solver::slopes_of_columns(const std::vector<ball>& at_nodes, std::size_t columns) const {
    std::vector<ball> result(at_nodes.size());
    const std::size_t stride = count() * columns;
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        for (const auto& [i, m] : map_.places()) {
            const ball& entry = jacobians_[k](i, m);
            for (std::size_t j = 0; j < columns; ++j) {
                arb_addmul(result[k * stride + i * columns + j].handle(), entry.handle(),
                           at_nodes[k * stride + m * columns + j].handle(), ball::working_bits());
            }
        }
    }
    for (ball& each : result) {
        each = midpoint_alone(each);
    }
    return result;
}

// The solutions of s' = J s with these initial values at the nodes, in the order of correct(), by the factors of
// Newton's matrix.
std::optional<std::vector<ball>> collocation_solver::slow_columns(const ball_columns& start) const {
    const std::size_t columns = start.size();
    const std::size_t stride = count() * columns;
    std::vector<ball> begin;
    for (std::size_t i = 0; i < stride; ++i) {
        begin.push_back(start[i % columns][i / columns]);
    }
    std::vector<ball> now;
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        now.insert(now.end(), begin.begin(), begin.end());
    }
    for (int refined = 0; refined < most_refinements && columns > 0; ++refined) {
        const std::vector<ball> slopes = slopes_of_columns(now, columns);
        std::vector<ball> rest;
        rest.reserve(now.size());
        for (std::size_t i = 0; i < now.size(); ++i) {
            const ball sum =
                inner_product(&nodes_.integrals().entries[i / stride * nodes_.size()], 1, &slopes[i % stride],
                              static_cast<int>(stride), static_cast<int>(nodes_.size()));
            rest.push_back(midpoint_alone(begin[i % stride] + sum - now[i]));
        }
        const magnitude correction = correct(rest, columns);
        const double size = log_of(correction) * std::log10(2.);
        if (!(size < 20)) {
            return std::nullopt;
        }
        for (std::size_t i = 0; i < now.size(); ++i) {
            now[i] = midpoint_alone(now[i] + rest[i]);
        }
        // The next correction would be smaller by as much as this one.
        if (size < -digits_of_frame(stiffness_) / 2 - 2) {
            break;
        }
    }
    return now;
}

// slow_columns() in double alone: to the digits to which `matrix_` refines its solutions.
std::optional<std::vector<ball>> collocation_solver::rounded_slow_columns(const ball_columns& start) {
    const std::size_t columns = start.size();
    if (!matrix_.update(jacobians_in_modes())) {
        return std::nullopt;
    }
    std::vector<double> begin;
    for (std::size_t i = 0; i < count() * columns; ++i) {
        begin.push_back(as_double(start[i % columns][i / columns]));
    }
    begin = product(in_double(to_basis_.entries), begin, count(), columns);
    std::vector<double> right;
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        right.insert(right.end(), begin.begin(), begin.end());
    }
    const std::vector<double> solved = matrix_.solved(right, columns);
    const std::vector<double> basis = in_double(basis_.entries);
    const auto stride = static_cast<std::ptrdiff_t>(begin.size());
    std::vector<ball> result;
    for (auto at = solved.begin(); at != solved.end(); at += stride) {
        for (const double each : product(basis, {at, at + stride}, count(), columns)) {
            if (!std::isfinite(each)) {
                return std::nullopt;
            }
            result.push_back(exactly(each));
        }
    }
    return result;
}

// Powers of x of the interpolant, without Chebyshev coefficients below 10^below of its largest one.
ball_polynomial collocation_solver::interpolated(const ball* in_nodes, int stride, double below) const {
    std::vector<ball> chebyshev;
    std::vector<double> sizes;
    double largest = -1e300;
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        chebyshev.push_back(midpoint_alone(inner_product(&nodes_.coefficients().entries[k * nodes_.size()], 1, in_nodes,
                                                         stride, static_cast<int>(nodes_.size()))));
        sizes.push_back(log_of(magnitude(chebyshev.back())) * std::log10(2.));
        largest = std::max(largest, sizes.back());
    }
    std::size_t kept = 0;
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        kept = sizes[k] > std::min(0., largest) + below ? k + 1 : kept;
    }
    chebyshev.resize(kept);
    const precision_scope scope(decimal_digits(accuracy_.frame_bits));
    auto result = nodes_.powers(chebyshev);
    for (ball& each : result) {
        each = midpoint_alone(each);
    }
    return result;
}

// V at a node, from slow columns at all nodes.
dense_matrix collocation_solver::frame_at(const std::vector<ball>& slow, std::size_t node) const {
    const std::size_t n = count();
    const std::size_t columns = modes_->slow.size();
    dense_matrix here(n, n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            here(i, j) = j < columns ? slow[(node * n + i) * columns + j] : modes_->fast[j - columns][i];
        }
    }
    return here;
}

void collocation_solver::interpolate_columns(const std::vector<ball>& slow, double below, moving_frame& frame) const {
    const std::size_t n = count();
    const std::size_t columns = modes_->slow.size();
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            frame.columns.push_back(j < columns
                                        ? interpolated(&slow[i * columns + j], static_cast<int>(n * columns), below)
                                        : ball_polynomial{modes_->fast[j - columns][i]});
        }
    }
}

bool collocation_solver::interpolate_frame(const std::vector<ball>& slow, moving_frame& frame) const {
    const std::size_t n = count();
    std::vector<ball> back;
    magnitude largest(1U);
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        auto inverted = inverse(frame_at(slow, k));
        if (!inverted) {
            return false;
        }
        largest = std::max(largest, inverted->largest());
        inverted->keep_midpoints();
        back.insert(back.end(), inverted->entries.begin(), inverted->entries.end());
    }
    const double below = -digits_of_frame(stiffness_) - log_of(largest) * std::log10(2.);
    interpolate_columns(slow, below, frame);
    for (std::size_t i = 0; i < n * n; ++i) {
        frame.inverse.push_back(interpolated(&back[i], static_cast<int>(n * n), below));
    }
    return true;
}

// By the inverse W of V in the middle: as fast columns are constant, W V has the columns (A, F) of slow modes, A square,
// and is the unit matrix elsewhere, so that its inverse is 1 + H, H = (A^-1 - 1, -F A^-1).
bool collocation_solver::interpolate_by_change(const std::vector<ball>& slow, moving_frame& frame) const {
    const std::size_t n = count();
    const std::size_t columns = modes_->slow.size();
    auto back = inverse(frame_at(slow, nodes_.size() / 2));
    if (!back) {
        return false;
    }
    back->keep_midpoints();
    magnitude largest = std::max(magnitude(1U), back->largest());
    const std::vector<double> rounded = in_double(back->entries);
    const auto length = static_cast<std::ptrdiff_t>(n * columns);
    const auto length_of_square = static_cast<std::ptrdiff_t>(columns * columns);
    std::vector<double> unit(columns * columns, 0);
    for (std::size_t j = 0; j < columns; ++j) {
        unit[j * (columns + 1)] = 1;
    }
    std::vector<ball> changes;
    for (std::size_t k = 0; k < nodes_.size() && columns > 0; ++k) {
        const auto begin = slow.begin() + static_cast<std::ptrdiff_t>(k) * length;
        const auto moved = product(rounded, in_double({begin, begin + length}), n, columns);
        const auto split = moved.begin() + length_of_square;
        real_lu<double> lu;
        if (!lu.factor({moved.begin(), split}, columns)) {
            return false;
        }
        const auto inverted = lu.solved(unit, columns);
        std::vector<double> change = inverted;
        const auto others = product({split, moved.end()}, inverted, n - columns, columns);
        for (std::size_t j = 0; j < columns; ++j) {
            change[j * (columns + 1)] -= 1;
        }
        for (const double each : others) {
            change.push_back(-each);
        }
        for (const double each : change) {
            if (!std::isfinite(each)) {
                return false;
            }
            changes.push_back(exactly(each));
        }
    }
    for (const ball& each : changes) {
        largest = std::max(largest, magnitude(each));
    }
    const double below = -digits_of_frame(stiffness_) - log_of(largest) * std::log10(2.);
    interpolate_columns(slow, below, frame);
    for (const ball& each : back->entries) {
        frame.inverse.push_back({each});
    }
    for (std::size_t i = 0; i < n * columns; ++i) {
        frame.change.push_back(interpolated(&changes[i], static_cast<int>(n * columns), below));
    }
    return true;
}

std::optional<tube_candidate> collocation_solver::candidate(bool by_change) {
    tube_candidate result{on_, scales_, {}, {}};
    {
        const precision_scope scope(decimal_digits(accuracy_.product_bits));
        const auto last = static_cast<int>(nodes_.size());
        for (std::size_t c = 0; c < count(); ++c) {
            std::vector<ball> chebyshev;
            for (std::size_t l = 0; l <= nodes_.size(); ++l) {
                chebyshev.push_back(inner_product(&nodes_.coefficients_of_integral().entries[l * nodes_.size()], 1,
                                                  &slopes_[c], static_cast<int>(count()), last));
            }
            auto curve = nodes_.powers(chebyshev);
            curve.front() += shifted(start_->centre[c], -scales_[c]);
            for (ball& each : curve) {
                each = midpoint_alone(each);
            }
            result.curve.push_back(std::move(curve));
        }
    }
    const precision_scope few(decimal_digits(accuracy_.node_bits));
    compute_jacobians();
    ball_columns begin;
    if (!slow_start(begin)) {
        return std::nullopt;
    }
    const auto slow = by_change ? rounded_slow_columns(begin) : slow_columns(begin);
    if (!slow || !(by_change ? interpolate_by_change(*slow, result.frame) : interpolate_frame(*slow, result.frame))) {
        return std::nullopt;
    }
    result.frame.slow = begin.size();
    result.frame.blocks.assign(begin.size(), 1);
    result.frame.blocks.insert(result.frame.blocks.end(), modes_->fast_blocks.begin(), modes_->fast_blocks.end());
    return result;
}

}  // namespace libration::ode
