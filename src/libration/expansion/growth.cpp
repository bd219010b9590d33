#include "growth.hpp"

#include <algorithm>

#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

constexpr int most_sweeps = 40;
// Enlarged by more than roundings of 30 bits.
magnitude enlarged(const magnitude& x) { return x + x.shifted(-20); }

// sum_(c != b) a_bc r_c + delta_b.
magnitude from_others(const comparison_system& system, std::size_t b, const std::vector<magnitude>& radii) {
    magnitude sum = system.defect[b];
    for (std::size_t c = 0; c < radii.size(); ++c) {
        if (c != b) {
            sum.add_product(system.beside[b * radii.size() + c], radii[c]);
        }
    }
    return sum;
}

// Computes one radius from the others; false unless 1 - L a is certainly greater than 1/8.
bool improve(const comparison_system& system, std::size_t b, long length, const magnitude& start, affine_radii& radii) {
    std::vector<magnitude> largest;
    for (std::size_t c = 0; c < radii.first.size(); ++c) {
        largest.push_back(std::max(radii.first[c], radii.last[c]));
    }
    const magnitude other = from_others(system, b, largest);
    const ball& rate = system.diagonal[b];
    const magnitude whole = other * magnitude(static_cast<unsigned long>(length));
    const ball divisor = ball(1) - rate * length;
    if (arb_is_positive((divisor - ball(1) / 8L).handle()) == 0) {
        return false;
    }
    magnitude& first = radii.first[b];
    magnitude& last = radii.last[b];
    first = std::max(first, start);
    if (arb_is_negative(rate.handle()) != 0) {
        const magnitude at_rest = enlarged(other / magnitude::below(rate));
        first = std::max(first, at_rest);
        last = std::max(at_rest, enlarged((first + whole) / magnitude::below(divisor)));
        first = std::max(first, last);
    } else {
        last = enlarged((first + whole) / magnitude::below(divisor));
    }
    return true;
}

// A r + delta at one end, as an upper bound in a ball.
ball right_side(const comparison_system& system, std::size_t b, const std::vector<magnitude>& radii) {
    return from_others(system, b, radii).exact() + system.diagonal[b] * radii[b].exact();
}

}  // namespace

bool satisfies(const comparison_system& system, const affine_radii& radii, long length) {
    const precision_scope scope(30);
    for (std::size_t b = 0; b < system.size(); ++b) {
        const ball slope = (radii.last[b].exact() - radii.first[b].exact()) / length;
        for (const auto* at_end : {&radii.first, &radii.last}) {
            const ball right = right_side(system, b, *at_end);
            if (arb_le(right.handle(), slope.handle()) == 0) {
                return false;
            }
        }
    }
    return true;
}

std::optional<affine_radii> affine_growth(const comparison_system& system, const std::vector<magnitude>& start,
                                          long length) {
    const precision_scope scope(30);
    affine_radii radii{start, start};
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        for (std::size_t b = 0; b < system.size(); ++b) {
            if (!improve(system, b, length, start[b], radii)) {
                return std::nullopt;
            }
        }
    }
    return satisfies(system, radii, length) ? std::optional(std::move(radii)) : std::nullopt;
}

}  // namespace libration::ode
