#include "tube_proof.hpp"

#include <algorithm>

#include "bound_matrix.hpp"
#include "dense_matrix.hpp"
#include "growth.hpp"
#include "libration/ode/ball/step_pieces.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

// The parts of a step in which the rate of a fast mode is bounded.
constexpr int parts_of_rate = 8;
// The length of a step in x.
constexpr long length_in_x = 2;
constexpr int most_tubes = 8;

// N with V^-1 = (1 + N) W, from |W V - 1| <= z; std::nullopt unless the row sums of z are below 1/4.
std::optional<bound_matrix> bound_of_inverse(const bound_matrix& z, std::size_t size) {
    magnitude most;
    for (std::size_t i = 0; i < size; ++i) {
        magnitude row;
        for (std::size_t j = 0; j < size; ++j) {
            row += z[i * size + j];
        }
        most = std::max(most, row);
    }
    if (!(most < magnitude::of(1, -2))) {
        return std::nullopt;
    }
    bound_matrix result = z;
    const bound_matrix squared = product_of_bounds(z, z, size, size);
    for (std::size_t i = 0; i < size; ++i) {
        magnitude row;
        for (std::size_t j = 0; j < size; ++j) {
            row += squared[i * size + j];
        }
        for (std::size_t j = 0; j < size; ++j) {
            result[i * size + j] += row * magnitude(4U) / 3U;
        }
    }
    return result;
}

std::vector<ball_polynomial> rounded(const std::vector<ball_polynomial>& of) {
    std::vector<ball_polynomial> result = of;
    for (ball_polynomial& each : result) {
        for (ball& a : each) {
            arb_set_round(a.handle(), a.handle(), ball::working_bits());
        }
    }
    return result;
}

// A bound of mu over the step: the largest eigenvalue of a symmetric 2 by 2 matrix increases with its diagonal entries
// and with the absolute value of the other one. For slow columns the supremum of the entry suffices.
ball rate_of_block(chebyshev_form& forms, const std::vector<ball_polynomial>& linear, std::size_t size, column_block b,
                   std::size_t slow, const bound_matrix& suprema) {
    const std::size_t first = b.begin * size + b.begin;
    if (b.size == 1 && b.begin < slow) {
        return suprema[first].exact();
    }
    const auto above = forms.upper_bounds(linear[first], parts_of_rate);
    if (b.size == 1) {
        return *std::ranges::max_element(above, exactly_less);
    }
    const std::size_t second = first + size + 1;
    const ball_polynomial beside = sum_of(linear[first + 1], linear[second - 1]);
    const auto below = forms.upper_bounds(linear[second], parts_of_rate);
    const auto plus = forms.upper_bounds(beside, parts_of_rate);
    const auto minus = forms.upper_bounds(multiple_of(ball(-1), beside), parts_of_rate);
    std::optional<ball> most;
    for (std::size_t k = 0; k < above.size(); ++k) {
        const magnitude coupling = std::max(magnitude(plus[k]), magnitude(minus[k])).shifted(-1);
        const magnitude difference = magnitude(above[k] - below[k]).shifted(-1);
        const ball mean = shifted(above[k] + below[k], -1);
        const ball rate = upper_bound(mean + hypotenuse(coupling, difference).exact());
        if (!most || exactly_less(*most, rate)) {
            most = rate;
        }
    }
    return *most;
}

}  // namespace

// Suprema on the step, of scaled unknowns and with the time x.
struct tube_proof::bounds {
    std::size_t size = 0;
    std::vector<column_block> blocks;
    bound_matrix linear, frame, inverse, correction;  ///< W (J V - V'), V, W, n of K2
    std::vector<magnitude> curve;
    std::vector<magnitude> defect;  ///< |d|, by rows
    std::vector<ball> rates;        ///< upper bounds of mu(W (J V - V')) of blocks
    magnitude half, time;
    const std::vector<long>* scales = nullptr;

    // A bound of |f_y(t, y) - J| in the tube with radii below `radii`.
    bound_matrix change_of_derivative(const polynomial_map& map, const std::vector<magnitude>& constants,
                                      const std::vector<magnitude>& radii) const {
        std::vector<bounded_change> state;
        for (std::size_t i = 0; i < size; ++i) {
            magnitude reach;
            for (std::size_t b = 0; b < blocks.size(); ++b) {
                reach.add_product(norm_of(&frame[i * size], blocks[b]), radii[b]);
            }
            state.push_back({curve[i].shifted((*scales)[i]), reach.shifted((*scales)[i])});
        }
        const auto all = map.in(change_ring{constants, time}, state, true);
        bound_matrix result(size * size);
        for (std::size_t k = 0; k < all.entries.size(); ++k) {
            const auto [i, j] = map.places()[k];
            result[i * size + j] = (half * all.entries[k].change).shifted((*scales)[j] - (*scales)[i]);
        }
        return result;
    }

    // a_bc and delta_b in that tube.
    comparison_system comparison(const bound_matrix& change) const {
        bound_matrix more = product_of_bounds(inverse, product_of_bounds(change, frame, size, size), size, size);
        bound_matrix whole = sum_of_bounds(linear, more);
        const bound_matrix by_correction = product_of_bounds(correction, whole, size, size);
        more = sum_of_bounds(more, by_correction);
        whole = sum_of_bounds(whole, by_correction);
        comparison_system result;
        for (std::size_t b = 0; b < blocks.size(); ++b) {
            // mu(M + E) <= mu(M) + ||E||.
            result.diagonal.push_back(upper_bound(rates[b] + norm_of(more, size, blocks[b], blocks[b]).exact()));
            for (const column_block& other : blocks) {
                result.beside.push_back(norm_of(whole, size, blocks[b], other));
            }
            result.defect.push_back(norm_of(defect.data(), blocks[b]));
        }
        return result;
    }
};

tube_proof::tube_proof(const polynomial_map& map, long bits, long frame_bits)
    : map_(map), bits_(bits), frame_bits_(frame_bits), forms_(bits) {
    const precision_scope scope(decimal_digits(bits));
    for (const number& each : map.constants()) {
        constants_.push_back(constant_value<ball>::of(each));
        constant_bounds_.emplace_back(constants_.back());
    }
}

std::vector<ball> tube_proof::chebyshev(const ball_polynomial& of) {
    const precision_scope scope(decimal_digits(bits_));
    return forms_.coefficients(of);
}

// Bounds the defect, W (J V - V'), W V - 1 and the quantities derived from them.
bool tube_proof::bound_linear_part(const tube_candidate& of, bounds& to) {
    const std::size_t n = map_.size();
    const ball half = shifted(of.on.length, -1);
    const auto& v = of.frame.columns;
    const auto& w = of.frame.inverse;
    std::vector<ball_polynomial> state;
    for (std::size_t i = 0; i < n; ++i) {
        state.push_back(shifted(of.curve[i], of.scales[i]));
    }
    auto all = map_.in(polynomial_ring{constants_, {of.on.start + half, half}}, state, true);
    std::vector<ball_polynomial> defect;
    for (std::size_t i = 0; i < n; ++i) {
        const auto slope = shifted(multiple_of(half, all.slopes[i]), -of.scales[i]);
        defect.push_back(difference_of(derivative_of(of.curve[i]), slope));
    }
    std::vector<magnitude> turned;
    for (std::size_t i = 0; i < n; ++i) {
        ball_polynomial sum;
        for (std::size_t k = 0; k < n; ++k) {
            sum = sum_of(sum, product_of(w[i * n + k], defect[k]));
        }
        turned.push_back(forms_.supremum(sum));
    }
    const precision_scope few(decimal_digits(frame_bits_));
    all.entries = rounded(all.entries);
    std::vector<ball_polynomial> moved(n * n);
    for (std::size_t k = 0; k < all.entries.size(); ++k) {
        const auto [i, m] = map_.places()[k];
        const auto entry = shifted(multiple_of(half, all.entries[k]), of.scales[m] - of.scales[i]);
        for (std::size_t j = 0; j < n; ++j) {
            moved[i * n + j] = sum_of(moved[i * n + j], product_of(entry, v[m * n + j]));
        }
    }
    std::vector<ball_polynomial> linear(n * n);
    bound_matrix z(n * n);
    for (std::size_t k = 0; k < n * n; ++k) {
        moved[k] = difference_of(moved[k], derivative_of(v[k]));
        to.frame.push_back(forms_.supremum(v[k]));
        to.inverse.push_back(forms_.supremum(w[k]));
    }
    for (std::size_t i = 0; i < n; ++i) {
        to.curve.push_back(forms_.supremum(of.curve[i]));
        for (std::size_t j = 0; j < n; ++j) {
            ball_polynomial unit = {ball(i == j ? -1 : 0)};
            for (std::size_t k = 0; k < n; ++k) {
                linear[i * n + j] = sum_of(linear[i * n + j], product_of(w[i * n + k], moved[k * n + j]));
                unit = sum_of(unit, product_of(w[i * n + k], v[k * n + j]));
            }
            to.linear.push_back(forms_.supremum(linear[i * n + j]));
            z[i * n + j] = forms_.supremum(unit);
        }
    }
    auto correction = bound_of_inverse(z, n);
    if (!correction) {
        return false;
    }
    to.correction = std::move(*correction);
    to.defect = sum_of_bounds(turned, product_of_bounds(to.correction, turned, n, 1));
    for (const column_block& b : to.blocks) {
        to.rates.push_back(rate_of_block(forms_, linear, n, b, of.frame.slow, to.linear));
    }
    return true;
}

// |V^-1 (y - p)| at the left end for y in the set, by V^-1 = (1 + N) W.
std::vector<magnitude> tube_proof::start_radii(const tube_candidate& of, const tube_set& start,
                                               const bound_matrix& correction) const {
    const std::size_t n = map_.size();
    const error_set& errors = start.errors;
    dense_matrix back(n, n);
    std::vector<ball> gap;
    for (std::size_t i = 0; i < n; ++i) {
        gap.push_back(shifted(start.centre[i], -of.scales[i]) - value_of(of.curve[i], ball(-1)));
        for (std::size_t j = 0; j < n; ++j) {
            back(i, j) = value_of(of.frame.inverse[i * n + j], ball(-1));
        }
    }
    bound_matrix beside(n);
    const std::vector<ball> of_gap = product(back, gap);
    for (std::size_t i = 0; i < n; ++i) {
        beside[i] = magnitude(of_gap[i]);
        for (std::size_t k = 0; k < n; ++k) {
            beside[i].add_product(magnitude(back(i, k)), errors.added()[k].shifted(-of.scales[k]));
        }
    }
    beside = sum_of_bounds(beside, product_of_bounds(correction, beside, n, 1));
    const std::size_t width = errors.columns().size();
    dense_matrix old(n, width);
    for (std::size_t j = 0; j < width; ++j) {
        for (std::size_t i = 0; i < n; ++i) {
            old(i, j) = shifted(errors.columns()[j][i], -of.scales[i]);
        }
    }
    bound_matrix turned;
    for (const ball& each : product(back, old).entries) {
        turned.emplace_back(each);
    }
    turned = sum_of_bounds(turned, product_of_bounds(correction, turned, n, width));
    const auto old_blocks = blocks_of(errors.blocks());
    std::vector<magnitude> radii;
    for (const column_block& b : blocks_of(of.frame.blocks)) {
        magnitude sum = norm_of(beside.data(), b);
        for (std::size_t c = 0; c < old_blocks.size(); ++c) {
            sum.add_product(norm_of(turned, width, b, old_blocks[c]), errors.radii()[c]);
        }
        radii.push_back(sum);
    }
    return radii;
}

std::optional<solution_tube> tube_proof::tube(const tube_candidate& of, const tube_set& start) {
    const precision_scope scope(decimal_digits(bits_));
    bounds known;
    known.size = map_.size();
    known.blocks = blocks_of(of.frame.blocks);
    known.half = magnitude(of.on.length).shifted(-1);
    known.time = std::max(magnitude(of.on.start), magnitude(of.on.start + of.on.length));
    known.scales = &of.scales;
    if (!bound_linear_part(of, known)) {
        return std::nullopt;
    }
    const auto begin = start_radii(of, start, known.correction);
    std::vector<magnitude> within;
    for (std::size_t b = 0; b < known.blocks.size(); ++b) {
        within.push_back(begin[b] * magnitude(4U) + norm_of(known.defect.data(), known.blocks[b]) * magnitude(8U));
    }
    for (int tried = 0; tried < most_tubes; ++tried) {
        const auto change = known.change_of_derivative(map_, constant_bounds_, within);
        const auto radii = affine_growth(known.comparison(change), begin, length_in_x);
        if (!radii) {
            return std::nullopt;
        }
        bool closed = true;
        for (std::size_t b = 0; b < within.size(); ++b) {
            const magnitude largest = std::max(radii->first[b], radii->last[b]);
            if (!(largest <= within[b])) {
                closed = false;
                within[b] = largest * magnitude(2U);
            }
        }
        if (closed) {
            return solution_tube{of.on,           of.scales,     of.curve,     of.frame.columns,
                                 of.frame.blocks, of.frame.slow, radii->first, radii->last};
        }
    }
    return std::nullopt;
}

}  // namespace libration::ode
