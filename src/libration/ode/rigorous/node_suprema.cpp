#include <flint/fmpq.h>

#include <algorithm>

#include "libration/ode/ball/step_pieces.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "matrix/dense_matrix.hpp"
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

// The zeros of T_M, M even, positive ones first: x_(M-1-k) = -x_k.
struct node_suprema::nodes {
    nodes(int degree, std::size_t length, long bits) : count(16 * std::max(1, (3 * degree + 31) / 32)) {
        const precision_scope scope(decimal_digits(bits));
        fmpq_t part;
        fmpq_init(part);
        for (int j = 0; j < 4 * count; ++j) {
            fmpq_set_si(part, j, static_cast<ulong>(2 * count));
            arb_cos_pi_fmpq(cosines.emplace_back().handle(), part, ball::working_bits());
        }
        fmpq_clear(part);
        for (int k = 0; k < count / 2; ++k) {
            auto& row = powers.emplace_back();
            for (std::size_t l = 0; l < length; ++l) {
                row.push_back(l == 0 ? ball(1) : row.back() * place(k));
            }
        }
    }

    const ball& place(int k) const { return cosines[static_cast<std::size_t>(2 * k + 1)]; }
    // 1/cos(pi m/(2M)).
    magnitude factor(int degree) const {
        return magnitude(1U) / magnitude::below(cosines[static_cast<std::size_t>(degree)]);
    }
    // The values of a polynomial in powers of x.
    std::vector<ball> values(const ball_polynomial& a) const {
        std::vector<ball> result(static_cast<std::size_t>(count));
        const int terms = static_cast<int>(a.size());
        for (int k = 0; k < count / 2; ++k) {
            const auto& x = powers[static_cast<std::size_t>(k)];
            const ball even = terms > 0 ? inner_product(a.data(), 2, x.data(), 2, (terms + 1) / 2) : ball(0);
            const ball odd = terms > 1 ? inner_product(a.data() + 1, 2, x.data() + 1, 2, terms / 2) : ball(0);
            result[static_cast<std::size_t>(k)] = even + odd;
            result[static_cast<std::size_t>(count - 1 - k)] = even - odd;
        }
        return result;
    }
    // Values by node, row by row, of a list of polynomials, rounded to so many bits.
    std::vector<std::vector<ball>> values(const std::vector<ball_polynomial>& all, long bits) const {
        std::vector<std::vector<ball>> result(static_cast<std::size_t>(count));
        for (const ball_polynomial& each : all) {
            const std::vector<ball> row = values(each);
            for (std::size_t k = 0; k < row.size(); ++k) {
                arb_set_round(result[k].emplace_back().handle(), row[k].handle(), bits);
            }
        }
        return result;
    }
    // Chebyshev coefficients of the polynomial of this degree, below M, with these values.
    std::vector<ball> coefficients(const std::vector<ball>& at, int degree) const {
        std::vector<ball> result;
        for (int l = 0; l <= degree; ++l) {
            ball sum(0);
            for (int k = 0; k < count; ++k) {
                const int turns = static_cast<int>(static_cast<long>(l) * (2 * k + 1) % (4 * count));
                arb_addmul(sum.handle(), at[static_cast<std::size_t>(k)].handle(),
                           cosines[static_cast<std::size_t>(turns)].handle(), ball::working_bits());
            }
            result.push_back(sum * (l == 0 ? 1L : 2L) / count);
        }
        return result;
    }

    int count;
    std::vector<ball> cosines;  ///< cos(pi j/(2M))
    std::vector<std::vector<ball>> powers;
};

// Values at the nodes, one after the other, and what is known of them.
struct node_suprema::sampled {
    sampled(const node_suprema& rule, const tube_candidate& of, const nodes& at, long bits, long frame_bits,
            long node_bits)
        : by(rule), found(of), half(shifted(of.on.length, -1)) {
        std::vector<ball_polynomial> slopes;
        {
            const precision_scope scope(decimal_digits(bits));
            for (const ball_polynomial& each : of.curve) {
                slopes.push_back(derivative_of(each));
            }
            curve = at.values(of.curve, bits);
            curve_slopes = at.values(slopes, bits);
        }
        const precision_scope scope(decimal_digits(frame_bits));
        slopes.clear();
        for (const ball_polynomial& each : of.frame.columns) {
            slopes.push_back(derivative_of(each));
        }
        frame = at.values(of.frame.columns, node_bits);
        frame_slopes = at.values(slopes, node_bits);
        inverse = at.values(of.frame.inverse, node_bits);
    }

    // f and its derivative in scaled unknowns, in the working precision.
    polynomial_map::result<ball> derivatives(std::size_t k, const ball& x) const {
        std::vector<ball> state;
        for (std::size_t i = 0; i < curve[k].size(); ++i) {
            state.push_back(shifted(curve[k][i], found.scales[i]));
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
    // J V - V'.
    dense_matrix moved(std::size_t k, const std::vector<ball>& entries) const {
        const std::size_t n = by.map_.size();
        dense_matrix result(n, n);
        for (std::size_t i = 0; i < n * n; ++i) {
            result.entries[i] = -frame_slopes[k][i];
        }
        for (std::size_t place = 0; place < entries.size(); ++place) {
            const auto [i, m] = by.map_.places()[place];
            for (std::size_t j = 0; j < n; ++j) {
                arb_addmul(result(i, j).handle(), entries[place].handle(), frame[k][m * n + j].handle(),
                           ball::working_bits());
            }
        }
        return result;
    }

    const node_suprema& by;
    const tube_candidate& found;
    ball half;
    std::vector<std::vector<ball>> curve, curve_slopes, frame, frame_slopes, inverse;
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
        inverse = degree_of(of.frame.inverse);
        linear = inverse + frame + largest(all.entries);
        defect = inverse + std::max(curve, largest(all.slopes));
    }

    int curve, frame, inverse, linear, defect;
};

step_suprema node_suprema::of(const tube_candidate& found) {
    const degrees of(map_, found);
    const auto length = static_cast<std::size_t>(std::max({of.curve, of.frame, of.inverse}) + 1);
    const nodes at(std::max(of.linear, of.defect), length, bits_);
    const sampled values(*this, found, at, bits_, frame_bits_, node_bits_);
    const auto blocks = blocks_of(found.frame.blocks);
    block_values in_blocks(4 * blocks.size());
    step_suprema most;
    for (std::size_t k = 0; k < values.curve.size(); ++k) {
        add_node(values, k, at.place(static_cast<int>(k)), most, in_blocks);
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
void node_suprema::add_node(const sampled& values, std::size_t k, const ball& x, step_suprema& most,
                            block_values& in_blocks) const {
    const std::size_t n = map_.size();
    const dense_matrix w{n, n, values.inverse[k]};
    const auto all = values.derivatives(k, x);
    std::vector<ball> defect;
    for (std::size_t i = 0; i < n; ++i) {
        defect.push_back(values.curve_slopes[k][i] - all.slopes[i]);
    }
    keep_larger(most.defect, product(w, defect));
    const precision_scope few(decimal_digits(node_bits_));
    const dense_matrix linear = product(w, values.moved(k, all.entries));
    dense_matrix unit = product(w, dense_matrix{n, n, values.frame[k]});
    for (std::size_t i = 0; i < n; ++i) {
        unit(i, i) -= 1L;
    }
    keep_larger(most.linear, linear.entries);
    keep_larger(most.unit, unit.entries);
    keep_larger(most.frame, values.frame[k]);
    keep_larger(most.inverse, values.inverse[k]);
    keep_larger(most.curve, values.curve[k]);
    const auto blocks = blocks_of(values.found.frame.blocks);
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        const std::size_t i = blocks[b].begin;
        in_blocks[4 * b].push_back(linear(i, i));
        if (blocks[b].size == 2) {
            in_blocks[4 * b + 1].push_back(linear(i + 1, i + 1));
            in_blocks[4 * b + 2].push_back(linear(i, i + 1) + linear(i + 1, i));
            in_blocks[4 * b + 3].push_back(-in_blocks[4 * b + 2].back());
        }
    }
}

}  // namespace libration::ode
