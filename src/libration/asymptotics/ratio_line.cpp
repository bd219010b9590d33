#include "libration/asymptotics/ratio_line.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "../algebra/dense_matrix.hpp"
#include "gamma_powers.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

// A singularity, and the exponent of its leading term if that decides how its coefficients grow.
struct leading_power {
    complex_ball place;
    bool real = false;
    bool nonzero = false;  // whether the coefficient of a singular term is proved to be nonzero
    std::optional<ball> exponent = {};
};

bool excludes_zero(const complex_ball& z) { return !contains_zero(z.re) || !contains_zero(z.im); }

leading_power of_pole(const pole_terms& of) {
    leading_power result{of.place, of.real};
    result.nonzero = excludes_zero(of.principal.back());
    if (result.nonzero) {
        result.exponent = ball(-static_cast<long>(of.principal.size()));
    }
    return result;
}

leading_power of_branch_point(const algebraic_point& of) {
    leading_power result{of.place, of.real};
    for (int j = -of.pole; j <= of.last(); ++j) {
        const bool analytic = j >= 0 && j % of.sheets == 0;
        if (analytic || is_zero_exactly(of.coefficient(j))) {
            continue;
        }
        result.nonzero = excludes_zero(of.coefficient(j));
        if (result.nonzero) {
            result.exponent = ball(j) / of.sheets;
        }
        break;
    }
    return result;
}

// Terms of which the first has the least Re a and the highest power of the logarithm.
leading_power of_terms(const std::vector<fixed_point_terms::singular_term>& all, const complex_ball& place, bool real) {
    leading_power result{place, real};
    result.nonzero = std::ranges::any_of(all, [](const auto& each) { return excludes_zero(each.coefficient); });
    if (all.empty() || !excludes_zero(all.front().coefficient)) {
        return result;
    }
    const auto& first = all.front();
    const bool natural = first.exact && denominator(*first.exact) == 1 && *first.exact >= 0;
    const bool like_a_power =
        first.power == (natural ? 1 : 0) && is_exact(first.exponent.im) && contains_zero(first.exponent.im);
    const bool alone = std::all_of(all.begin() + 1, all.end(), [&](const auto& each) {
        return certainly_less(first.exponent.re, each.exponent.re);
    });
    if (like_a_power && alone) {
        result.exponent = first.exponent.re;
    }
    return result;
}

std::vector<leading_power> all_of(const coefficient_law& law) {
    std::vector<leading_power> all;
    for (const pole_terms& each : law.poles()) {
        all.push_back(of_pole(each));
    }
    for (const branch_terms& each : law.branch_points()) {
        all.push_back(of_branch_point(each.of()));
    }
    for (const fixed_point_terms& each : law.fixed_points()) {
        all.push_back(of_terms(each.leading(), each.place(), each.is_real()));
    }
    for (const movable_terms& each : law.movable_points()) {
        all.push_back(of_terms(each.leading(), each.of().place, each.of().real));
    }
    for (leading_power& each : all) {
        if (each.exponent) {
            *each.exponent -= law.shift();
        }
    }
    return all;
}

// Those that are not proved to be farther than another one.
std::vector<leading_power> nearest_of(const coefficient_law& law) {
    std::vector<leading_power> all = all_of(law);
    std::vector<leading_power> nearest;
    for (const leading_power& each : all) {
        const ball modulus = modulus_in_balls(each.place);
        if (std::ranges::none_of(all, [&](const leading_power& other) {
                return certainly_less(modulus_in_balls(other.place), modulus);
            })) {
            nearest.push_back(each);
        }
    }
    return nearest;
}

}  // namespace

std::optional<ratio_line> line_of_ratios(const coefficient_law& law) {
    const std::vector<leading_power> nearest = nearest_of(law);
    int count = 0;
    for (const leading_power& each : nearest) {
        count += each.real ? 1 : 2;
    }
    if (nearest.empty() || count != law.stride() || !nearest.front().exponent) {
        return std::nullopt;
    }
    // The rotations and the mirror image of t* are among them, so that t*^p is real.
    complex_ball power(1);
    for (int k = 0; k < law.stride(); ++k) {
        power = power * nearest.front().place;
    }
    return ratio_line{law.stride(), ball(1) / power.re, *nearest.front().exponent};
}

std::optional<ball> radius_of_law(const coefficient_law& law) {
    std::optional<ball> lower, upper;
    for (const leading_power& each : all_of(law)) {
        const ball modulus = modulus_in_balls(each.place);
        if (!lower || certainly_less(lower_bound(modulus), *lower)) {
            lower = lower_bound(modulus);
        }
        if (each.nonzero && (!upper || certainly_less(upper_bound(modulus), *upper))) {
            upper = upper_bound(modulus);
        }
    }
    if (!lower || !upper) {
        return std::nullopt;
    }
    return hull(*lower, *upper);
}

}  // namespace libration::ode
