#include <algorithm>
#include <array>

#include "../../algebra/rounded_matrix.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "node_frames.hpp"
#include "step_suprema.hpp"

namespace libration::ode {

namespace {

// Degrees of polynomials, at least.
struct degree_ring {
    static int constant(int) { return 0; }
    static int variable() { return 1; }
    static int sum(int a, int b) { return std::max(a, b); }
    static int difference(int a, int b) { return std::max(a, b); }
    static int product(int a, int b) { return a + b; }
    static int multiple(int, int a) { return a; }
    static int ratio(int, int, int a) { return a; }
};

int degree_of(const ball_polynomial& a) { return a.empty() ? 0 : static_cast<int>(a.size()) - 1; }
int degree_of(const std::vector<ball_polynomial>& all) {
    int most = 0;
    for (const ball_polynomial& each : all) {
        most = std::max(most, degree_of(each));
    }
    return most;
}
int largest(const std::vector<int>& of) { return of.empty() ? 0 : *std::ranges::max_element(of); }

// The midpoints of equal parts of [-1, 1], and T_0, T_1, .. of them.
class midpoints_of_parts {
public:
    midpoints_of_parts(int parts, int degree) : values_(static_cast<std::size_t>(parts)) {
        for (int k = 0; k < parts; ++k) {
            const ball x = ball(2L * k + 1 - parts) / parts;
            for (int l = 0; l <= degree; ++l) {
                arb_chebyshev_t_ui(values_[static_cast<std::size_t>(k)].emplace_back().handle(), static_cast<ulong>(l),
                                   x.handle(), ball::working_bits());
            }
        }
    }

    // Upper bounds of sum_l c_l T_l, with their signs, on the parts: the value at the midpoint plus half of the length
    // times the sum of the |coefficients| of the derivative.
    std::vector<ball> upper_bounds(const std::vector<ball>& c) const {
        std::vector<ball> slope(c.size() + 1);
        magnitude reach;
        for (std::size_t l = c.size(); l-- > 1;) {
            slope[l - 1] = slope[l + 1] + c[l] * static_cast<long>(2 * l);
            reach += l == 1 ? magnitude(shifted(slope[0], -1)) : magnitude(slope[l - 1]);
        }
        std::vector<ball> bounds;
        for (const auto& each : values_) {
            const ball value = inner_product(c.data(), 1, each.data(), 1, static_cast<int>(c.size()));
            bounds.push_back(upper_bound(widened(value, reach / static_cast<unsigned long>(values_.size()))));
        }
        return bounds;
    }

private:
    std::vector<std::vector<ball>> values_;
};

void keep_larger(bound_matrix& most, const std::vector<ball>& values) {
    most.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        most[i] = std::max(most[i], magnitude(values[i]));
    }
}

}  // namespace

// The curve at the nodes k and M - 1 - k.
struct node_suprema::sampled {
    sampled(const node_suprema& rule, const tube_candidate& of, const chebyshev_zeros& at)
        : by(rule), found(of), places(at), half(shifted(of.on.length, -1)) {
        const precision_scope scope(decimal_digits(rule.bits_));
        polynomials = derivatives_of(of.curve);
    }

    void move_to(int k) {
        const precision_scope scope(decimal_digits(by.bits_));
        curve = places.values(found.curve, k, by.bits_);
        slopes = places.values(polynomials, k, by.bits_);
    }

    // f and its derivative in scaled unknowns, in the working precision; `side` is 0 at node k.
    polynomial_map::result<ball> derivatives(std::size_t side, const ball& x) const {
        std::vector<ball> state;
        for (std::size_t i = 0; i < curve[side].size(); ++i) {
            state.push_back(shifted(curve[side][i], found.scales[i]));
        }
        const ball time = found.on.start + half * (x + 1);
        auto all = by.map_.in(number_ring<ball>{by.constants_, time}, state, true);
        for (std::size_t i = 0; i < state.size(); ++i) {
            all.slopes[i] = shifted(all.slopes[i] * half, -found.scales[i]);
        }
        for (std::size_t place = 0; place < all.entries.size(); ++place) {
            const auto [i, m] = by.map_.places()[place];
            all.entries[place] = shifted(all.entries[place] * half, found.scales[m] - found.scales[i]);
        }
        return all;
    }

    const node_suprema& by;
    const tube_candidate& found;
    const chebyshev_zeros& places;
    ball half;
    std::vector<ball_polynomial> polynomials;  ///< the derivatives of the curve
    std::array<std::vector<ball>, 2> curve, slopes;
};

// Degrees, at least, of the polynomials whose suprema are bounded.
struct node_suprema::degrees {
    degrees(const polynomial_map& map, const tube_candidate& of) {
        std::vector<int> state;
        for (const ball_polynomial& each : of.curve) {
            state.push_back(degree_of(each));
        }
        const auto all = map.in(degree_ring(), state, true);
        curve = largest(state);
        frame = degree_of(of.frame.columns);
        inverse = std::max(degree_of(of.frame.inverse), degree_of(of.frame.change));
        linear = inverse + frame + largest(all.entries);
        defect = inverse + std::max(curve, largest(all.slopes));
    }

    int curve, frame, inverse, linear, defect;
};

dense_matrix inverse_of_frame(dense_matrix inverse, std::vector<ball> change, std::size_t slow) {
    if (change.empty()) {
        return inverse;
    }
    const std::size_t n = inverse.rows;
    const dense_matrix of_slow(
        slow, n, {inverse.entries.begin(), inverse.entries.begin() + static_cast<std::ptrdiff_t>(slow * n)});
    const dense_matrix added = product({n, slow, std::move(change)}, of_slow);
    for (std::size_t i = 0; i < n * n; ++i) {
        inverse.entries[i] += added.entries[i];
    }
    return inverse;
}

step_suprema node_suprema::of(const tube_candidate& found) {
    const degrees of(map_, found);
    const auto length = static_cast<std::size_t>(std::max({of.curve, of.frame, of.inverse}) + 1);
    const chebyshev_zeros at(std::max(of.linear, of.defect), length, bits_);
    sampled values(*this, found, at);
    const bool is_constant = of.frame == 0 && of.inverse == 0;
    const bool in_double = !found.frame.change.empty() || (is_constant && map_.size() >= least_size_in_double);
    const auto frames = in_double ? frames_in_double(found.frame, at, frame_bits_)
                                  : frames_in_balls(found.frame, at, frame_bits_, node_bits_);
    const auto blocks = blocks_of(found.frame.blocks);
    block_values in_blocks(4 * blocks.size());
    step_suprema most;
    for (int k = 0; k < at.count() / 2; ++k) {
        values.move_to(k);
        add_node(values, *frames, k, most, in_blocks);
        add_node(values, *frames, at.count() - 1 - k, most, in_blocks);
    }
    const auto enlarge = [&](bound_matrix& suprema, int degree) {
        for (magnitude& each : suprema) {
            each *= at.factor(degree);
        }
    };
    enlarge(most.linear, of.linear);
    enlarge(most.unit, of.linear);
    enlarge(most.frame, of.frame);
    enlarge(most.inverse, of.inverse);
    enlarge(most.curve, of.curve);
    enlarge(most.defect, of.defect);
    const midpoints_of_parts midpoints(parts_of_rate, of.linear);
    const precision_scope few(decimal_digits(node_bits_));
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        if (blocks[b].size == 1 && blocks[b].begin < found.frame.slow) {
            most.rates.push_back(most.linear[blocks[b].begin * (map_.size() + 1)].exact());
            continue;
        }
        const auto bounds = [&](std::size_t which) {
            const auto& at_nodes = in_blocks[4 * b + which];
            return at_nodes.empty() ? std::vector<ball>()
                                    : midpoints.upper_bounds(at.coefficients(at_nodes, of.linear));
        };
        most.rates.push_back(rate_of({bounds(0), bounds(1), bounds(2), bounds(3)}));
    }
    return most;
}

// The values at node k; those of a block in the order of block_bounds.
void node_suprema::add_node(const sampled& values, node_frames& frames, int k, step_suprema& most,
                            block_values& in_blocks) const {
    const std::size_t side = k < values.places.count() / 2 ? 0 : 1;
    const auto all = values.derivatives(side, values.places.place(k));
    const node_frame here = frames.at(k, {map_.places(), all.entries});
    std::vector<ball> defect;
    for (std::size_t i = 0; i < map_.size(); ++i) {
        defect.push_back(values.slopes[side][i] - all.slopes[i]);
    }
    keep_larger(most.defect, product(here.inverse, defect));
    keep_larger(most.linear, here.linear.entries);
    keep_larger(most.unit, here.unit.entries);
    keep_larger(most.frame, here.frame.entries);
    keep_larger(most.inverse, here.inverse.entries);
    keep_larger(most.curve, values.curve[side]);
    const precision_scope few(decimal_digits(node_bits_));
    const auto blocks = blocks_of(values.found.frame.blocks);
    const auto add = [&](std::size_t place, const ball& value) {
        in_blocks[place].resize(static_cast<std::size_t>(values.places.count()));
        in_blocks[place][static_cast<std::size_t>(k)] = value;
    };
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        const std::size_t i = blocks[b].begin;
        add(4 * b, here.linear(i, i));
        if (blocks[b].size == 2) {
            const ball sum = here.linear(i, i + 1) + here.linear(i + 1, i);
            add(4 * b + 1, here.linear(i + 1, i + 1));
            add(4 * b + 2, sum);
            add(4 * b + 3, -sum);
        }
    }
}

}  // namespace libration::ode
