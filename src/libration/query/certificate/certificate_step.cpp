#include "certificate_step.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "libration/expansion/step_pieces.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

// The tube at the end may be wider by 2^-2 from the rounding of p, which adds to the defects of other steps, and by 2^-5
// from that of the frame, which multiplies with that of other steps.
constexpr long loss_of_curve = -2;
constexpr long loss_of_frame = -5;
constexpr long finest_frame = 120;
constexpr long grain = 2;

ball rounded_to_integer(const ball& x) { return from_rational<ball>(rational(nearest_integer(x))); }

void drop_zeros(integer_list& of) {
    while (!of.empty() && arb_is_zero(of.back().handle()) != 0) {
        of.pop_back();
    }
}

// From Chebyshev coefficients c_j = 2 a_j, c_0 = a_0.
integer_list rounded_list(const std::vector<ball>& chebyshev, long bits) {
    integer_list result;
    for (std::size_t j = 0; j < chebyshev.size(); ++j) {
        result.push_back(rounded_to_integer(shifted(chebyshev[j], bits - (j > 0 ? 1 : 0))));
    }
    drop_zeros(result);
    return result;
}

// rounded_list() such that each coefficient of the derivative, d_j = d_(j+2) + 2 (j+1) a_(j+1), is rounded by at most
// its own step 2 (j+1), and the value at -1 by half a unit: errors do not accumulate.
integer_list rounded_curve(const std::vector<ball>& chebyshev, long bits) {
    const std::size_t size = chebyshev.size();
    std::vector<ball> exact(size + 2);
    for (std::size_t j = size; j-- > 1;) {
        exact[j - 1] = exact[j + 1] + shifted(chebyshev[j], bits) * static_cast<long>(j);
    }
    integer_list result(size);
    std::vector<ball> slope(size + 2);
    ball at_left(0);
    ball exact_at_left = shifted(chebyshev.front(), bits);
    for (std::size_t j = size; j-- > 1;) {
        const auto step = static_cast<long>(2 * j);
        result[j] = rounded_to_integer((exact[j - 1] - slope[j + 1]) / step);
        slope[j - 1] = slope[j + 1] + result[j] * step;
        const long sign = j % 2 == 0 ? 1 : -1;
        at_left += result[j] * (2 * sign);
        exact_at_left += shifted(chebyshev[j], bits) * sign;
    }
    result.front() = rounded_to_integer(exact_at_left - at_left);
    drop_zeros(result);
    return result;
}

ball_polynomial exact_powers(const integer_list& of, long bits) {
    std::vector<ball> chebyshev;
    for (std::size_t j = 0; j < of.size(); ++j) {
        chebyshev.push_back(shifted(of[j], (j > 0 ? 1 : 0) - bits));
    }
    auto result = chebyshev_form::in_powers(chebyshev);
    if (!std::ranges::all_of(result, is_exact)) {
        throw std::logic_error("a polynomial of a certificate is not exact in the working precision");
    }
    return result;
}

// Bounds of |y_i - p_i| at the end of a step, for scaled unknowns.
std::vector<magnitude> reaches(const solution_tube& of) {
    constexpr long bits_of_bounds = 64;
    const lohner_set end = of.end(bits_of_bounds, bits_of_bounds).errors;
    std::vector<magnitude> result;
    for (std::size_t i = 0; i < of.scales.size(); ++i) {
        magnitude sum;
        for (std::size_t j = 0, b = 0; b < end.blocks().size(); j += end.blocks()[b++]) {
            for (std::size_t k = j; k < j + end.blocks()[b]; ++k) {
                sum.add_product(magnitude(end.columns()[k][i]), end.radii()[b]);
            }
        }
        result.push_back(sum.shifted(-of.scales[i]));
    }
    return result;
}

// Whether the tube at the end is negligible or at most 1 + 2^loss times as wide as that of the polynomials that are not
// rounded.
bool keeps_width(const std::optional<solution_tube>& rounded, const std::vector<magnitude>& reference, long loss,
                 const magnitude& negligible) {
    if (!rounded) {
        return false;
    }
    const auto now = reaches(*rounded);
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (!(now[i] <= std::max(reference[i] + reference[i].shifted(loss), negligible))) {
            return false;
        }
    }
    return true;
}

}  // namespace

// The polynomials of a step, rounded in parts.
struct step_rounding::attempt {
    attempt(tube_proof& prover, const tube_candidate& candidate, const tube_set& set, magnitude least)
        : by(prover), found(candidate), start(set), negligible(std::move(least)) {
        const auto all = [&](const std::vector<ball_polynomial>& of) {
            std::vector<std::vector<ball>> result;
            result.reserve(of.size());
            for (const ball_polynomial& each : of) {
                result.push_back(by.chebyshev(each));
            }
            return result;
        };
        curve = all(found.curve);
        frame = all(found.frame.columns);
        inverse = all(found.frame.inverse);
    }

    void round_curve(tube_candidate& to, long bits) {
        step.curve_bits = bits;
        step.curve.clear();
        to.curve.clear();
        for (const auto& each : curve) {
            step.curve.push_back(rounded_curve(each, bits));
            to.curve.push_back(exact_powers(step.curve.back(), bits));
        }
    }
    void round_frame(tube_candidate& to, long bits) {
        const std::size_t n = curve.size();
        step.frame_bits.assign(n, bits);
        step.frame.clear();
        to.frame.columns.clear();
        for (const auto& each : frame) {
            step.frame.push_back(rounded_list(each, bits));
            to.frame.columns.push_back(exact_powers(step.frame.back(), bits));
        }
    }
    void round_inverse(tube_candidate& to, long slow_bits, long fast_bits) {
        const std::size_t n = curve.size();
        step.inverse_bits.clear();
        step.inverse.clear();
        to.frame.inverse.clear();
        for (std::size_t i = 0; i < n; ++i) {
            const long bits = i < found.frame.slow ? slow_bits : fast_bits;
            step.inverse_bits.push_back(bits);
            for (std::size_t j = 0; j < n; ++j) {
                step.inverse.push_back(rounded_list(inverse[i * n + j], bits));
                to.frame.inverse.push_back(exact_powers(step.inverse.back(), bits));
            }
        }
    }

    std::optional<solution_tube> rounded(const exponents& bits) {
        tube_candidate candidate = found;
        round_curve(candidate, bits.curve);
        round_frame(candidate, bits.frame);
        round_inverse(candidate, bits.slow_rows, bits.fast_rows);
        return by.tube(candidate, start, supremum_rule::coefficients);
    }

    // The least number of bits, to within `grain`, for which `try_bits` keeps the width; `most` if none does. From a
    // guess on by steps that are doubled, then by halves.
    template <class Try>
    long least_bits(long guess, long most, long loss, const std::vector<magnitude>& reference, const Try& try_bits) {
        const auto keeps = [&](long bits) {
            tube_candidate candidate = found;
            try_bits(candidate, bits);
            return keeps_width(by.tube(candidate, start, supremum_rule::coefficients), reference, loss, negligible);
        };
        long bits = std::min(guess, most);
        long too_few = 0;
        long stride = grain;
        if (keeps(bits)) {
            for (; bits > stride && keeps(bits - stride); stride *= 2) {
                bits -= stride;
            }
            too_few = std::max(bits - stride, 0L);
        } else {
            for (bool enough = false; !enough && bits < most; stride *= 2) {
                too_few = bits;
                bits = std::min(bits + stride, most);
                enough = keeps(bits);
            }
        }
        while (bits - too_few > grain) {
            const long middle = (bits + too_few) / 2;
            (keeps(middle) ? bits : too_few) = middle;
        }
        return bits;
    }

    tube_proof& by;
    const tube_candidate& found;
    const tube_set& start;
    magnitude negligible;
    std::vector<std::vector<ball>> curve, frame, inverse;
    certificate_step step;
};

std::optional<solution_tube> step_rounding::tube(tube_proof& by, const tube_candidate& found, const tube_set& start) {
    const auto unrounded = by.tube(found, start, supremum_rule::coefficients);
    if (!unrounded) {
        return std::nullopt;
    }
    const auto reference = reaches(*unrounded);
    const precision_scope scope(decimal_digits(by.bits()));
    attempt here(by, found, start, magnitude::of(1, -negligible_bits_));
    exponents bits;
    bits.curve = here.least_bits(last_.curve, finest_, loss_of_curve, reference,
                                 [&](tube_candidate& to, long k) { here.round_curve(to, k); });
    bits.frame = here.least_bits(last_.frame, finest_frame, loss_of_frame, reference,
                                 [&](tube_candidate& to, long k) { here.round_frame(to, k); });
    bits.slow_rows = here.least_bits(last_.slow_rows, finest_frame, loss_of_frame, reference,
                                     [&](tube_candidate& to, long k) { here.round_inverse(to, k, finest_frame); });
    bits.fast_rows = here.least_bits(last_.fast_rows, finest_frame, loss_of_frame, reference,
                                     [&](tube_candidate& to, long k) { here.round_inverse(to, finest_frame, k); });
    last_ = bits;
    auto proved = here.rounded(bits);
    while (!keeps_width(proved, reference, loss_of_curve + 1, here.negligible) && bits.frame < finest_frame) {
        bits = {std::min(bits.curve + 1, finest_), bits.frame + 1, bits.slow_rows + 1, bits.fast_rows + 1};
        proved = here.rounded(bits);
    }
    if (proved) {
        here.step.length = found.on.length;
        here.step.scales = found.scales;
        here.step.blocks = found.frame.blocks;
        here.step.first = proved->first;
        here.step.last = proved->last;
        step_ = std::move(here.step);
    }
    return proved;
}

}  // namespace libration::ode
