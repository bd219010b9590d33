#include "stable_equilibrium.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "../algebra/bound_matrix.hpp"
#include "decay_basis.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

constexpr int most_newton_corrections = 60;
constexpr int most_krawczyk_boxes = 10;
using place_list = std::vector<std::size_t>;

std::vector<ball> at_places(const std::vector<ball>& of, const place_list& places) {
    std::vector<ball> result;
    for (const std::size_t k : places) {
        result.push_back(of[k]);
    }
    return result;
}

// As many functions as unknowns; the other unknowns are fixed. The functions are some of the slopes, or some of the
// eliminated unknowns.
struct part_of_field {
    const reduced_field& f;
    place_list functions, unknowns;
    bool of_eliminated = false;

    std::size_t size() const { return unknowns.size(); }
    std::vector<ball> at(const std::vector<ball>& x) const {
        return at_places(of_eliminated ? f.eliminated_of(x) : f.slopes(x), functions);
    }
    dense_matrix derivative(const std::vector<ball>& x) const {
        const dense_matrix whole = of_eliminated ? dense_matrix(0, 0) : f.derivative(x);
        dense_matrix result(size(), size());
        for (std::size_t i = 0; i < size(); ++i) {
            for (std::size_t j = 0; j < size(); ++j) {
                result(i, j) =
                    of_eliminated ? f.relation_slope(functions[i], unknowns[j], x) : whole(functions[i], unknowns[j]);
            }
        }
        return result;
    }
    // Near the inverse of the derivative.
    std::optional<dense_matrix> approximate_inverse(const std::vector<ball>& x) const {
        auto result = inverse(derivative(x));
        if (result) {
            result->keep_midpoints();
        }
        return result;
    }
};

magnitude largest_in(const std::vector<ball>& values) {
    magnitude result;
    for (const ball& each : values) {
        result = std::max(result, magnitude(each));
    }
    return result;
}

// Newton's method, until its corrections no longer decrease.
std::optional<std::vector<ball>> improved(const part_of_field& f, std::vector<ball> x) {
    magnitude last;
    for (int k = 0; k < most_newton_corrections; ++k) {
        const auto a = f.approximate_inverse(x);
        if (!a) {
            return std::nullopt;
        }
        const auto correction = product(*a, f.at(x));
        const magnitude size = largest_in(correction);
        if (size.is_zero() || (k > 0 && !(size + size < last))) {
            break;
        }
        last = size;
        for (std::size_t i = 0; i < f.size(); ++i) {
            x[f.unknowns[i]] = midpoint_alone(x[f.unknowns[i]] - correction[i]);
        }
    }
    const bool finite = std::ranges::all_of(x, [](const ball& each) { return is_finite(each); });
    return finite ? std::optional(std::move(x)) : std::nullopt;
}

// Bounds of |A f(x)| + |1 - A f_y(X)| r over the box X with these radii r.
std::vector<magnitude> krawczyk_radii(const part_of_field& f, const dense_matrix& a, const std::vector<ball>& x,
                                      const std::vector<magnitude>& radii) {
    std::vector<ball> box = x;
    for (std::size_t i = 0; i < f.size(); ++i) {
        box[f.unknowns[i]] = widened(x[f.unknowns[i]], radii[i]);
    }
    const auto offset = product(a, f.at(x));
    const dense_matrix slopes = product(a, f.derivative(box));
    std::vector<magnitude> result;
    for (std::size_t i = 0; i < f.size(); ++i) {
        magnitude sum(offset[i]);
        for (std::size_t j = 0; j < f.size(); ++j) {
            sum.add_product(magnitude(ball(i == j ? 1 : 0) - slopes(i, j)), radii[j]);
        }
        result.push_back(std::move(sum));
    }
    return result;
}

std::optional<std::vector<ball>> zero_in_box(const part_of_field& f, const std::vector<ball>& near) {
    auto x = improved(f, near);
    const auto a = x ? f.approximate_inverse(*x) : std::nullopt;
    if (!a) {
        return std::nullopt;
    }
    const magnitude scale = std::max(largest_in(*x), magnitude(1U));
    std::vector<magnitude> radii(f.size(), scale.shifted(-2 * ball::working_bits()));
    for (int k = 0; k < most_krawczyk_boxes; ++k) {
        const auto inner = krawczyk_radii(f, *a, *x, radii);
        if (std::ranges::equal(inner, radii, [](const magnitude& i, const magnitude& r) { return i < r; })) {
            for (std::size_t i = 0; i < f.size(); ++i) {
                (*x)[f.unknowns[i]] = widened((*x)[f.unknowns[i]], inner[i]);
            }
            return x;
        }
        for (std::size_t i = 0; i < f.size(); ++i) {
            radii[i] = (inner[i] + radii[i]).shifted(1);
        }
    }
    return std::nullopt;
}

// A zero of the part, near `at`, in a box.
std::optional<std::vector<ball>> zero_inside(const part_of_field& part, const std::vector<ball>& at,
                                             const std::vector<ball>& box) {
    auto found = zero_in_box(part, at);
    const bool inside =
        found && std::ranges::equal(box, *found, [](const ball& a, const ball& b) { return contains(a, b); });
    return inside ? found : std::nullopt;
}

// The zero with exact zeros for the unknowns that contain 0, if the slopes that do not vanish with them determine
// the other ones.
std::optional<std::vector<ball>> with_exact_zeros(const reduced_field& f, const std::vector<ball>& zero) {
    std::vector<ball> box = zero;
    std::vector<ball> at = zero;
    part_of_field part{f, {}, {}};
    for (std::size_t k = 0; k < zero.size(); ++k) {
        if (contains_zero(zero[k])) {
            box[k] = at[k] = ball(0);
        } else {
            at[k] = midpoint_alone(zero[k]);
            part.unknowns.push_back(k);
        }
    }
    const auto slopes = f.slopes(box);
    for (std::size_t k = 0; k < slopes.size(); ++k) {
        if (arb_is_zero(slopes[k].handle()) == 0) {
            part.functions.push_back(k);
        }
    }
    if (part.size() == zero.size() || part.functions.size() != part.size()) {
        return std::nullopt;
    }
    return zero_inside(part, at, zero);
}

// The whole state of the same zero with exact zeros for the unknowns that contain 0, eliminated ones too, if all slopes
// vanish with them: as many kept unknowns are determined by the eliminated ones that are 0.
std::optional<std::vector<ball>> state_with_exact_zeros(const reduced_field& f, const std::vector<ball>& zero) {
    std::vector<ball> state = f.state_of(zero);
    for (ball& each : state) {
        each = contains_zero(each) ? ball(0) : each;
    }
    const auto slopes = f.slopes_of_state(state);
    if (!std::ranges::all_of(slopes, [](const ball& each) { return arb_is_zero(each.handle()) != 0; })) {
        return std::nullopt;
    }
    std::vector<ball> at = zero;
    part_of_field part{f, {}, {}, true};
    for (std::size_t k = 0; k < zero.size(); ++k) {
        at[k] = contains_zero(zero[k]) ? ball(0) : midpoint_alone(zero[k]);
        if (!contains_zero(zero[k])) {
            part.unknowns.push_back(k);
        }
    }
    for (std::size_t e = 0; e < f.eliminated().size(); ++e) {
        if (arb_is_zero(state[f.eliminated()[e]].handle()) != 0) {
            part.functions.push_back(e);
        }
    }
    const auto other = part.functions.size() == part.size() ? zero_inside(part, at, zero) : std::nullopt;
    if (!other) {
        return std::nullopt;
    }
    auto found = f.state_of(*other);
    for (std::size_t k = 0; k < state.size(); ++k) {
        found[k] = arb_is_zero(state[k].handle()) != 0 ? ball(0) : found[k];
    }
    return found;
}

// An upper bound of the logarithmic norm of a diagonal block in the Euclidean norm [Gershgorin, symmetric part].
ball logarithmic_norm(const dense_matrix& m, column_block block) {
    const std::size_t k = block.begin;
    if (block.size == 1) {
        return upper_bound(m(k, k));
    }
    const ball beside = upper_bound(abs((m(k, k + 1) + m(k + 1, k)) / 2));
    const ball first = upper_bound(m(k, k) + beside);
    const ball second = upper_bound(m(k + 1, k + 1) + beside);
    return exactly_less(first, second) ? second : first;
}

// Theorem Q for these blocks.
bool is_approached_by(const reduced_field& f, const std::vector<ball>& zero, const std::vector<ball>& states,
                      const block_basis& basis) {
    const auto rows = inverse(basis.columns);
    if (!rows) {
        return false;
    }
    std::vector<ball> offset;
    for (std::size_t k = 0; k < zero.size(); ++k) {
        offset.push_back(states[k] - zero[k]);
    }
    const auto parts = product(*rows, offset);
    const std::vector<magnitude> sizes(parts.begin(), parts.end());
    const auto blocks = blocks_of(basis.blocks);
    magnitude distance;
    for (const column_block& each : blocks) {
        distance = std::max(distance, norm_of(sizes.data(), each));
    }
    std::vector<ball> box = zero;
    for (std::size_t i = 0; i < zero.size(); ++i) {
        magnitude reach;
        for (std::size_t k = 0; k < zero.size(); ++k) {
            reach.add_product(magnitude(basis.columns(i, k)), distance);
        }
        box[i] = widened(zero[i], reach);
    }
    const dense_matrix in_basis = product(*rows, product(f.derivative(box), basis.columns));
    const bound_matrix sizes_in_basis(in_basis.entries.begin(), in_basis.entries.end());
    return std::ranges::all_of(blocks, [&](const column_block& each) {
        ball growth = logarithmic_norm(in_basis, each);
        for (const column_block& other : blocks) {
            if (other.begin != each.begin) {
                growth += norm_of(sizes_in_basis, zero.size(), each, other).exact();
            }
        }
        return arb_is_negative(growth.handle()) != 0;
    });
}

}  // namespace

std::optional<std::vector<ball>> enclosed_zero(const reduced_field& f, const std::vector<ball>& near) {
    place_list all(f.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    std::vector<ball> x;
    std::ranges::transform(near, std::back_inserter(x), [](const ball& each) { return midpoint_alone(each); });
    auto zero = zero_in_box({f, all, all}, x);
    if (zero) {
        if (auto exact = with_exact_zeros(f, *zero)) {
            return exact;
        }
    }
    return zero;
}

std::vector<ball> state_at_zero(const reduced_field& f, const std::vector<ball>& zero) {
    auto exact = state_with_exact_zeros(f, zero);
    return exact ? *std::move(exact) : f.state_of(zero);
}

bool is_approached(const reduced_field& f, const std::vector<ball>& zero, const std::vector<ball>& states) {
    const dense_matrix derivative = f.derivative(zero);
    return std::ranges::any_of(std::array{basis_of_eigenvectors, scaled_schur_basis}, [&](const auto& choose) {
        const auto basis = choose(derivative);
        return basis && is_approached_by(f, zero, states, *basis);
    });
}

}  // namespace libration::ode
