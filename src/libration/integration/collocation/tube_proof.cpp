#include "tube_proof.hpp"

#include <algorithm>

#include "../../algebra/dense_matrix.hpp"
#include "../../expansion/growth.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

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

// A bound of |t| on a step.
magnitude bound_of_time(const step_interval& on) {
    return std::max(magnitude(on.start), magnitude(on.start + on.length));
}

}  // namespace

// Suprema on the step, of scaled unknowns and with the time x.
struct tube_proof::bounds {
    std::size_t size = 0;
    std::vector<column_block> blocks;
    step_suprema of;
    bound_matrix correction;        ///< n of K2
    std::vector<magnitude> defect;  ///< |d|, by rows
    magnitude half, time;
    const std::vector<long>* scales = nullptr;

    // A bound of |f_y(t, y) - J| in the tube with radii below `radii`.
    bound_matrix change_of_derivative(const polynomial_map& map, const std::vector<magnitude>& constants,
                                      const std::vector<magnitude>& radii) const {
        std::vector<bounded_change> state;
        for (std::size_t i = 0; i < size; ++i) {
            magnitude reach;
            for (std::size_t b = 0; b < blocks.size(); ++b) {
                reach.add_product(norm_of(&of.frame[i * size], blocks[b]), radii[b]);
            }
            state.push_back({of.curve[i].shifted((*scales)[i]), reach.shifted((*scales)[i])});
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
        bound_matrix more = product_of_bounds(of.inverse, product_of_bounds(change, of.frame, size, size), size, size);
        bound_matrix whole = sum_of_bounds(of.linear, more);
        const bound_matrix by_correction = product_of_bounds(correction, whole, size, size);
        more = sum_of_bounds(more, by_correction);
        whole = sum_of_bounds(whole, by_correction);
        comparison_system result;
        for (std::size_t b = 0; b < blocks.size(); ++b) {
            // mu(M + E) <= mu(M) + ||E||.
            result.diagonal.push_back(upper_bound(of.rates[b] + norm_of(more, size, blocks[b], blocks[b]).exact()));
            for (const column_block& other : blocks) {
                result.beside.push_back(norm_of(whole, size, blocks[b], other));
            }
            result.defect.push_back(norm_of(defect.data(), blocks[b]));
        }
        return result;
    }
};

tube_proof::tube_proof(const polynomial_map& map, long bits, long frame_bits, long node_bits)
    : map_(map),
      bits_(bits),
      constants_(map.enclosed_constants(bits)),
      by_coefficients_(map, constants_, bits, frame_bits),
      by_nodes_(map, constants_, bits, frame_bits, node_bits) {
    for (const ball& each : constants_) {
        constant_bounds_.emplace_back(each);
    }
}

std::vector<ball> tube_proof::chebyshev(const ball_polynomial& of) {
    const precision_scope scope(decimal_digits(bits_));
    return by_coefficients_.forms().coefficients(of);
}

// |V^-1 (y - p)| at the left end for y in the set, by V^-1 = (1 + N) W.
std::vector<magnitude> tube_proof::start_radii(const tube_candidate& of, const tube_set& start,
                                               const bound_matrix& correction) const {
    const std::size_t n = map_.size();
    const lohner_set& errors = start.errors;
    dense_matrix back(n, n);
    std::vector<ball> gap;
    for (std::size_t i = 0; i < n; ++i) {
        gap.push_back(shifted(start.centre[i], -of.scales[i]) - value_of(of.curve[i], ball(-1)));
        for (std::size_t j = 0; j < n; ++j) {
            back(i, j) = value_of(of.frame.inverse[i * n + j], ball(-1));
        }
    }
    std::vector<ball> change;
    for (const ball_polynomial& each : of.frame.change) {
        change.push_back(value_of(each, ball(-1)));
    }
    back = inverse_of_frame(std::move(back), std::move(change), of.frame.slow);
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

std::vector<magnitude> tube_proof::slope_errors(const solution_tube& of) {
    const precision_scope scope(decimal_digits(bits_));
    const std::size_t n = map_.size();
    const auto blocks = blocks_of(of.blocks);
    chebyshev_form& forms = by_coefficients_.forms();
    std::vector<bounded_change> state;
    for (std::size_t i = 0; i < n; ++i) {
        bound_matrix row;
        for (std::size_t j = 0; j < n; ++j) {
            row.push_back(forms.supremum(of.frame[i * n + j]));
        }
        magnitude reach;
        for (std::size_t b = 0; b < blocks.size(); ++b) {
            reach.add_product(norm_of(row.data(), blocks[b]), std::max(of.first[b], of.last[b]));
        }
        state.push_back({forms.supremum(of.curve[i]).shifted(of.scales[i]), reach.shifted(of.scales[i])});
    }
    const auto change = map_.in(change_ring{constant_bounds_, bound_of_time(of.on)}, state, false).slopes;
    const auto defect = by_coefficients_.defect(of.on, of.scales, of.curve);
    const magnitude half = magnitude::below(of.on.length).shifted(-1);
    std::vector<magnitude> errors;
    for (std::size_t i = 0; i < n; ++i) {
        errors.push_back((forms.supremum(defect[i]) / half).shifted(of.scales[i]) + change[i].change);
    }
    return errors;
}

std::optional<solution_tube> tube_proof::tube(const tube_candidate& of, const tube_set& start, supremum_rule by) {
    const precision_scope scope(decimal_digits(bits_));
    bounds known;
    known.size = map_.size();
    known.blocks = blocks_of(of.frame.blocks);
    known.half = magnitude(of.on.length).shifted(-1);
    known.time = bound_of_time(of.on);
    known.scales = &of.scales;
    known.of = by == supremum_rule::nodes ? by_nodes_.of(of) : by_coefficients_.of(of);
    auto correction = bound_of_inverse(known.of.unit, known.size);
    if (!correction) {
        return std::nullopt;
    }
    known.correction = std::move(*correction);
    known.defect = sum_of_bounds(known.of.defect, product_of_bounds(known.correction, known.of.defect, known.size, 1));
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
