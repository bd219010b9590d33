#include "libration/expansion/tail_bound.hpp"

#include <algorithm>
#include <cmath>

#include "kept_bounds.hpp"
#include "set_values.hpp"
#include "step_norms.hpp"

namespace libration::ode {

namespace {

// s with defects_i ||f_i(p), degrees >= N|| + gains_i G_i(s) <= s_i for all i, or its image under the map, which is not
// larger; G by of_state(s, state). The s_i of known unknowns are given.
template <class OfState>
std::optional<std::vector<magnitude>> kept_by_map(const tape& of, const norms_of_steps& norms,
                                                  const magnitude& of_defect, const magnitude& gain,
                                                  const OfState& of_state, std::size_t steps,
                                                  const std::vector<known_remainder>& known = {}) {
    std::vector<magnitude> defect;
    for (const int output : of.outputs()) {
        defect.push_back(norms.rest(output) * of_defect);
    }
    const auto set_known = [&](std::vector<magnitude>& s) {
        for (const known_remainder& each : known) {
            s[static_cast<std::size_t>(each.unknown)] = each.error;
        }
    };
    set_known(defect);
    const auto image = [&](const std::vector<magnitude>& s) {
        std::vector<magnitude> result = defect;
        const auto changes = norms.changes([&](const tape_step& state) { return of_state(s, state); }, steps);
        // A function that is not defined on the disc has no bound, also if a factor 0 hides it.
        const bool bounded =
            norms.are_finite() && std::ranges::all_of(changes, [](const magnitude& each) { return each.is_finite(); });
        for (std::size_t i = 0; i < result.size(); ++i) {
            if (!bounded) {
                result[i] = magnitude(1U) / magnitude();
            }
            result[i] += changes[static_cast<std::size_t>(of.outputs()[i])] * gain;
        }
        set_known(result);
        return result;
    };
    return kept_bounds(image, defect, set_known);
}

}  // namespace

namespace {

// The parts of a number that may be complex.
const ball& real_part(const ball& x) { return x; }
const ball& real_part(const complex_number<ball>& x) { return x.re; }
magnitude size_of_imaginary_part(const ball& /*x*/) { return {}; }
magnitude size_of_imaginary_part(const complex_number<ball>& x) { return magnitude(x.im); }

// At least |x|, and a whole number.
unsigned long whole_above(const ball& x) {
    constexpr double largest = 1'000'000;
    const double above = magnitude(x).above();
    return above < largest ? static_cast<unsigned long>(std::ceil(above)) : static_cast<unsigned long>(largest);
}

// By the coefficients of powers, (r over j) is at most that of (1 - z)^-ceil|r|; those of the logarithm are at most 1.
template <field R>
function_kernel kernel_of(const tape& of, const tape_step& step, const taylor_expansion<R>& expansion, const R& value) {
    const auto centre = [&](int operand) -> const R& { return expansion.of_step(operand)[0]; };
    switch (step.kind) {
        case operation::quotient: return {{}, least_size_of(centre(step.right)), 1};
        case operation::square_root: return {size_of(value), least_size_of(centre(step.left)), 1};
        case operation::power: {
            const ball exponent = constant_value<ball>::of(of.constants()[static_cast<std::size_t>(step.constant)]);
            return {size_of(value), least_size_of(centre(step.left)), whole_above(exponent)};
        }
        case operation::function: break;
        case operation::constant:
        case operation::variable:
        case operation::state:
        case operation::sum:
        case operation::difference:
        case operation::scaled:
        case operation::raised:
        case operation::by_variable:
        case operation::delayed:
        case operation::product:
        case operation::square:
        case operation::slope:
        case operation::primitive:
        case operation::companion: return {};
    }
    const R& c = centre(step.left);
    const auto is = [&](function_kind f) { return step.function == f; };
    if (is(function_kind::log)) {
        return {magnitude(1U), least_size_of(c), 1};
    }
    if (is(function_kind::sin) || is(function_kind::cosrel)) {
        return {exponential(size_of_imaginary_part(c)), {}, 0};
    }
    if (is(function_kind::sinh)) {
        return {exponential(magnitude(real_part(c))), {}, 0};
    }
    if (is(function_kind::exp) || is(function_kind::exprel)) {
        const magnitude size(exp(real_part(c)));
        return {is(function_kind::exp) ? size : std::max(magnitude(1U), size), {}, 0};
    }
    return {};
}

}  // namespace

template <field R>
series_sizes sizes_of(const tape& of, const taylor_expansion<R>& expansion, const R& point, int degree) {
    series_sizes result{degree, {}, {}, size_of(point), {}};
    for (const number& each : of.constants()) {
        result.constants.push_back(size_of(constant_value<R>::of(each)));
    }
    const auto count = static_cast<std::size_t>(degree);
    result.of_steps.reserve(of.steps().size());
    for (std::size_t i = 0; i < of.steps().size(); ++i) {
        const R* const a = expansion.of_step(static_cast<int>(i));
        result.kernels.push_back(kernel_of(of, of.steps()[i], expansion, a[0]));
        auto& row = result.of_steps.emplace_back();
        row.reserve(count + 1);
        for (std::size_t j = 0; j < count + (of.steps()[i].kind == operation::state ? 1 : 0); ++j) {
            row.push_back(size_of(a[j]));
        }
    }
    return result;
}

std::optional<std::vector<magnitude>> kept_remainders(const tape& of, const norms_of_steps& norms, int degree,
                                                      const magnitude& radius, std::size_t steps) {
    const auto order = static_cast<unsigned long>(degree);
    return kept_by_map(
        of, norms, radius / (order + 1), radius / (order + 2),
        [](const std::vector<magnitude>& errors, const tape_step& state) {
            return errors[static_cast<std::size_t>(state.left)];
        },
        steps);
}

std::optional<tail_bound> bounded_tail(const tape& of, const series_sizes& sizes, const magnitude& radius) {
    auto s = kept_remainders(of, norms_of_steps(of, sizes, radius), sizes.degree, radius, of.steps().size());
    return s ? std::optional(tail_bound{radius, sizes.degree, *std::move(s)}) : std::nullopt;
}

std::optional<remainder_bound> bounded_remainder(const tape& of, const taylor_expansion<ball>& expansion,
                                                 const ball& point, const magnitude& length,
                                                 const std::vector<known_remainder>& known) {
    const int degree = expansion.order();
    const series_sizes sizes = sizes_of(of, expansion, point, degree);
    const norms_of_steps norms(of, sizes, length);
    const auto part_of = [](const std::vector<magnitude>& errors, const tape_step& state) {
        return errors[static_cast<std::size_t>(state.left)];
    };
    auto s = kept_by_map(of, norms, length / (static_cast<unsigned long>(degree) + 1), length, part_of,
                         of.steps().size(), known);
    if (!s) {
        return std::nullopt;
    }
    const auto changes = norms.changes([&](const tape_step& state) { return part_of(*s, state); });
    remainder_bound result;
    for (const int output : of.outputs()) {
        result.slope_error.push_back(norms.rest(output) + changes[static_cast<std::size_t>(output)]);
    }
    result.error = *std::move(s);
    return result;
}

namespace {

// Whether n .. (n-q+1) - sum_l w_l n .. (n-l+1) is positive for all n > degree, by its value with |w| for n = degree +
// 1.
bool determines_coefficients(const std::vector<number>& weights, int degree) {
    ball least = falling(degree + 1, static_cast<int>(weights.size()));
    for (std::size_t l = 0; l < weights.size(); ++l) {
        least -= abs(constant_value<ball>::of(weights[l])) * falling(degree + 1, static_cast<int>(l));
    }
    return arb_is_positive(least.handle()) != 0;
}

}  // namespace

std::optional<tail_bound> bounded_singular_tail(const tape& of, const taylor_expansion<ball>& expansion, int degree,
                                                const magnitude& radius) {
    for (std::size_t i = 0; i < of.outputs().size(); ++i) {
        if (!determines_coefficients(of.weights()[i][i], degree)) {
            return std::nullopt;
        }
    }
    // ||e^(l)|| for ||s^q e^(q)|| = 1.
    const auto part = [&](std::size_t unknown, int l) {
        const ball quotient = falling(degree + 1, l) / falling(degree + 1, of.orders()[unknown]);
        return magnitude(quotient) / pow(radius, static_cast<unsigned long>(l));
    };
    const series_sizes sizes = sizes_of(of, expansion, ball(0), degree);
    const norms_of_steps norms(of, sizes, radius);
    auto s = kept_by_map(
        of, norms, magnitude(1U), magnitude(1U),
        [&](const std::vector<magnitude>& highest, const tape_step& state) {
            const auto unknown = static_cast<std::size_t>(state.left);
            return highest[unknown] * part(unknown, state.right);
        },
        of.steps().size());
    if (!s) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < s->size(); ++i) {
        (*s)[i] = (*s)[i] * part(i, 0);
    }
    return tail_bound{radius, degree, *std::move(s)};
}

template series_sizes sizes_of(const tape&, const taylor_expansion<ball>&, const ball&, int);
template series_sizes sizes_of(const tape&, const taylor_expansion<complex_number<ball>>&, const complex_number<ball>&,
                               int);

}  // namespace libration::ode
