#include <algorithm>

#include "libration/expansion/step_pieces.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "step_suprema.hpp"

namespace libration::ode {

namespace {

std::vector<ball_polynomial> rounded(const std::vector<ball_polynomial>& of) {
    std::vector<ball_polynomial> result = of;
    for (ball_polynomial& each : result) {
        for (ball& a : each) {
            arb_set_round(a.handle(), a.handle(), ball::working_bits());
        }
    }
    return result;
}

// p' - f for scaled unknowns p and the time x, from f itself.
std::vector<ball_polynomial> defect_by(const std::vector<ball_polynomial>& slopes, const step_interval& on,
                                       const std::vector<long>& scales, const std::vector<ball_polynomial>& curve) {
    const ball half = shifted(on.length, -1);
    std::vector<ball_polynomial> defect;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        defect.push_back(difference_of(derivative_of(curve[i]), shifted(multiple_of(half, slopes[i]), -scales[i])));
    }
    return defect;
}

}  // namespace

ball rate_of(const block_bounds& of) {
    if (of.second.empty()) {
        return *std::ranges::max_element(of.first, exactly_less);
    }
    std::optional<ball> most;
    for (std::size_t k = 0; k < of.first.size(); ++k) {
        const magnitude coupling = std::max(magnitude(of.plus[k]), magnitude(of.minus[k])).shifted(-1);
        const magnitude difference = magnitude(of.first[k] - of.second[k]).shifted(-1);
        const ball mean = shifted(of.first[k] + of.second[k], -1);
        const ball rate = upper_bound(mean + hypotenuse(coupling, difference).exact());
        if (!most || exactly_less(*most, rate)) {
            most = rate;
        }
    }
    return *most;
}

block_bounds coefficient_suprema::bounds_of(const std::vector<ball_polynomial>& linear, std::size_t size,
                                            column_block b) {
    const std::size_t first = b.begin * size + b.begin;
    block_bounds result{forms_.upper_bounds(linear[first], parts_of_rate), {}, {}, {}};
    if (b.size == 2) {
        const std::size_t second = first + size + 1;
        const ball_polynomial beside = sum_of(linear[first + 1], linear[second - 1]);
        result.second = forms_.upper_bounds(linear[second], parts_of_rate);
        result.plus = forms_.upper_bounds(beside, parts_of_rate);
        result.minus = forms_.upper_bounds(multiple_of(ball(-1), beside), parts_of_rate);
    }
    return result;
}

// f and f_y along a curve.
polynomial_map::result<ball_polynomial> coefficient_suprema::on_curve(const step_interval& on,
                                                                      const std::vector<long>& scales,
                                                                      const std::vector<ball_polynomial>& curve,
                                                                      bool with_entries) const {
    const ball half = shifted(on.length, -1);
    std::vector<ball_polynomial> state;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        state.push_back(shifted(curve[i], scales[i]));
    }
    return map_.in(polynomial_ring{constants_, {on.start + half, half}}, state, with_entries);
}

std::vector<ball_polynomial> coefficient_suprema::defect(const step_interval& on, const std::vector<long>& scales,
                                                         const std::vector<ball_polynomial>& curve) const {
    return defect_by(on_curve(on, scales, curve, false).slopes, on, scales, curve);
}

step_suprema coefficient_suprema::of(const tube_candidate& found) {
    const std::size_t n = map_.size();
    const ball half = shifted(found.on.length, -1);
    const auto& w = found.frame.inverse;
    step_suprema result;
    for (const ball_polynomial& each : found.curve) {
        result.curve.push_back(forms_.supremum(each));
    }
    const auto all = on_curve(found.on, found.scales, found.curve, true);
    const auto defect = defect_by(all.slopes, found.on, found.scales, found.curve);
    for (std::size_t i = 0; i < n; ++i) {
        ball_polynomial sum;
        for (std::size_t k = 0; k < n; ++k) {
            sum = sum_of(sum, product_of(w[i * n + k], defect[k]));
        }
        result.defect.push_back(forms_.supremum(sum));
    }
    const precision_scope few(decimal_digits(frame_bits_));
    std::vector<ball_polynomial> derivative(n * n);
    const auto entries = rounded(all.entries);
    for (std::size_t k = 0; k < entries.size(); ++k) {
        const auto [i, m] = map_.places()[k];
        derivative[i * n + m] = shifted(multiple_of(half, entries[k]), found.scales[m] - found.scales[i]);
    }
    add_linear(found, derivative, result);
    return result;
}

// W (J V - V'), W V - 1, V, W and the rates of blocks.
void coefficient_suprema::add_linear(const tube_candidate& found, const std::vector<ball_polynomial>& derivative,
                                     step_suprema& to) {
    const std::size_t n = map_.size();
    const auto& v = found.frame.columns;
    const auto& w = found.frame.inverse;
    std::vector<ball_polynomial> moved(n * n);
    for (const auto& [i, m] : map_.places()) {
        for (std::size_t j = 0; j < n; ++j) {
            moved[i * n + j] = sum_of(moved[i * n + j], product_of(derivative[i * n + m], v[m * n + j]));
        }
    }
    for (std::size_t k = 0; k < n * n; ++k) {
        moved[k] = difference_of(moved[k], derivative_of(v[k]));
        to.frame.push_back(forms_.supremum(v[k]));
        to.inverse.push_back(forms_.supremum(w[k]));
    }
    std::vector<ball_polynomial> linear(n * n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            ball_polynomial unit = {ball(i == j ? -1 : 0)};
            for (std::size_t k = 0; k < n; ++k) {
                linear[i * n + j] = sum_of(linear[i * n + j], product_of(w[i * n + k], moved[k * n + j]));
                unit = sum_of(unit, product_of(w[i * n + k], v[k * n + j]));
            }
            to.linear.push_back(forms_.supremum(linear[i * n + j]));
            to.unit.push_back(forms_.supremum(unit));
        }
    }
    for (const column_block& b : blocks_of(found.frame.blocks)) {
        // For slow columns the supremum of the entry suffices.
        const bool slow = b.size == 1 && b.begin < found.frame.slow;
        to.rates.push_back(slow ? to.linear[b.begin * n + b.begin].exact() : rate_of(bounds_of(linear, n, b)));
    }
}

}  // namespace libration::ode
