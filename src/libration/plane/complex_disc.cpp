#include "libration/plane/complex_disc.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "../expansion/set_values.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

// The number of bits of the centre in addition to those determined by the width of the set.
constexpr long bits_below_complex_set = 24;
// The order of the variations: the radii of theorem T are within a few hundredths of the radii of convergence.
constexpr int complex_set_order = 44;
// Steps of paths are at most 2/3 of a radius.
constexpr double terms_for_a_bit = 1.75;
// For the only series about a singular initial point: at 0.8 of its radius the remainder is below the rounding.
constexpr double singular_terms_for_a_bit = 3.2;
// The fractions of an estimated radius that are tried; the estimate may be below the radius by a power of the order.
constexpr std::array<unsigned long, 8> parts_of_estimate{125, 116, 108, 100, 92, 82, 70, 55};

// Exponents of powers of two near the sizes of the unknowns; that of the largest one for unknowns that are 0.
std::vector<long> scales_of(const std::vector<complex_ball>& centre) {
    std::vector<long> scales;
    long largest = std::numeric_limits<long>::min();
    for (const complex_ball& each : centre) {
        const magnitude size = size_of(each);
        scales.push_back(size.is_zero() ? std::numeric_limits<long>::min() : size.exponent());
        largest = std::max(largest, scales.back());
    }
    for (long& each : scales) {
        if (each == std::numeric_limits<long>::min()) {
            each = largest == std::numeric_limits<long>::min() ? 0 : largest;
        }
    }
    return scales;
}

// The number of bits that are significant for the width of the set.
long bits_of(const complex_set& set, long most) {
    long needed = 0;
    for (std::size_t i = 0; i < set.centre.size(); ++i) {
        const magnitude size = size_of(set.centre[i]);
        const magnitude width = hypotenuse(set.errors.reach(i), set.errors.reach(set.centre.size() + i));
        const long exponent = size.is_zero() ? set.scales[i] : size.exponent();
        needed = std::max(needed, width.is_zero() ? most : exponent - (width.exponent() + set.scales[i]));
    }
    return std::clamp(needed + bits_below_complex_set, complex_flow::usual_error_bits,
                      std::max(most, complex_flow::usual_error_bits));
}

std::optional<tail_bound> tail_about(const tape& of, const taylor_expansion<complex_ball>& expansion,
                                     const complex_ball& point, std::size_t unknowns) {
    double log_of_radius = estimated_radius(expansion, unknowns);
    if (log_of_radius == no_radius) {  // at an equilibrium only the variations have a finite radius
        log_of_radius = estimated_radius(expansion, of.orders().size());
    }
    for (const unsigned long part : parts_of_estimate) {
        if (log_of_radius == no_radius) {
            break;
        }
        const magnitude radius = power_of_two(log_of_radius) * magnitude::of(part * 328, -15);
        if (auto bound = bounded_tail(of, expansion, point, radius)) {
            return bound;
        }
    }
    return tail_near(of, expansion, point, log_of_radius);
}

}  // namespace

complex_set set_about(const complex_ball& offset, const std::vector<complex_ball>& values) {
    std::vector<complex_ball> centre = values;
    for (complex_ball& each : centre) {
        each = exact_midpoint(each);
    }
    std::vector<long> scales = scales_of(centre);
    std::vector<magnitude> widths;
    for (const bool imaginary : {false, true}) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            const ball off = imaginary ? ball(values[i].im - centre[i].im) : ball(values[i].re - centre[i].re);
            widths.push_back(magnitude(off) * magnitude::of(1, -scales[i]));
        }
    }
    return {offset, std::move(centre), std::move(scales), lohner_set(std::move(widths))};
}

std::vector<complex_ball> values_of(const complex_set& set) {
    std::vector<complex_ball> values;
    const std::size_t count = set.centre.size();
    for (std::size_t i = 0; i < count; ++i) {
        const magnitude scale = magnitude::of(1, set.scales[i]);
        values.emplace_back(widened(set.centre[i].re + 0, set.errors.reach(i) * scale),
                            widened(set.centre[i].im + 0, set.errors.reach(count + i) * scale));
    }
    return values;
}

complex_ball exact_difference(const complex_ball& a, const complex_ball& b) {
    return {exact_sum(a.re, -b.re), exact_sum(a.im, -b.im)};
}

complex_ball exact_midpoint(const complex_ball& z) { return {exact_midpoint(z.re), exact_midpoint(z.im)}; }

bool certainly_within(const complex_ball& z, const magnitude& r) {
    const ball limit = r.exact();
    return certainly_less(ball(z.re * z.re + z.im * z.im), ball(limit * limit));
}

complex_flow::complex_flow(const explicit_system& system, long bits, const proof_route& route, without_start)
    : form_(lifted_for_paths(beyond_start(system))),
      tape_(tape::about_points(form_.lifted.system)),
      varied_tape_(tape::about_points(with_variations(form_.lifted))),
      given_(first_order_form(system).leaves.size()),
      bits_(bits),
      route_(route) {
    const precision_scope scope(decimal_digits(bits));
    origin_ = constant_value<ball>::of(system.point());
}

complex_flow complex_flow::about_points(const explicit_system& system, long bits, const proof_route& route) {
    return {system, bits, route, without_start()};
}

complex_flow::complex_flow(const explicit_system& system, long bits, const proof_route& route)
    : complex_flow(system, bits, route, without_start()) {
    const precision_scope scope(decimal_digits(bits));
    if (system.singular()) {
        singular_ = std::make_shared<singular_series>(
            system, bits, static_cast<int>(static_cast<double>(bits) * singular_terms_for_a_bit), route);
        start_ = singular_->at(ball(0));
        return;
    }
    start_ = enclosed_start(system, bits);
    if (form_.lifted.given != given_) {
        start_ = form_.given_of(lifted_values(lifted(system), origin_, start_));
    }
}

complex_set complex_flow::start() const {
    const precision_scope scope(decimal_digits(bits_));
    std::vector<complex_ball> values;
    for (const ball& each : start_) {
        values.emplace_back(each);
    }
    return set_about(complex_ball(0), values);
}

complex_disc::complex_disc(const complex_flow& flow, complex_set about)
    : flow_(&flow), set_(std::move(about)), bits_(bits_of(set_, flow.bits_)) {
    if (flow.route_.watch) {
        flow.route_.watch(plane_step::disc);
    }
    expand();
}

complex_disc::complex_disc(const complex_flow& flow)
    : flow_(&flow), set_(flow.start()), bits_(bits_of(set_, flow.bits_)), singular_(flow.singular_) {
    if (!singular_) {
        expand();
    }
}

void complex_disc::expand() {
    const complex_flow& flow = *flow_;
    const auto time = [&] { return complex_ball(flow.origin_ + set_.offset.re, set_.offset.im); };
    {
        const precision_scope scope(decimal_digits(complex_flow::usual_error_bits));
        const auto varied = varied_values(flow.form_.lifted, time(), values_of(set_));
        if (!all_finite(varied)) {
            throw precision_exhausted("a point of a path");
        }
        of_set_ = std::make_unique<taylor_expansion<complex_ball>>(flow.varied_tape_,
                                                                   complex_set_order + flow.route_.more_terms);
        of_set_->about(time(), as_state(varied));
        set_tail_ = tail_about(flow.varied_tape_, *of_set_, time(), flow.form_.lifted.leaves.size());
    }
    if (!set_tail_) {
        throw precision_exhausted("the radius about a point of a path");
    }
    const precision_scope scope(decimal_digits(bits_));
    const auto all = lifted_values(flow.form_.lifted, time(), set_.centre);
    const int order = static_cast<int>(static_cast<double>(bits_) * terms_for_a_bit) + flow.route_.more_terms;
    of_centre_ = std::make_unique<taylor_expansion<complex_ball>>(flow.tape_, order);
    of_centre_->about(time(), as_state(all));
    tail_ = bounded_tail(flow.tape_, *of_centre_, time(), set_tail_->radius);
    if (!tail_) {
        throw precision_exhausted("the series about a point of a path");
    }
}

// The unknowns at a distance from the centre of the set.
std::vector<complex_ball> complex_disc::image_at(const complex_ball& distance) const {
    if (singular_) {
        return singular_->at(distance);
    }
    std::vector<complex_ball> image;
    const auto state = of_centre_->at(distance);
    const magnitude away = size_of(distance);
    for (std::size_t i = 0; i < set_.centre.size(); ++i) {
        const magnitude tail = tail_->at(i, away);
        image.emplace_back(widened(state[i][0].re, tail), widened(state[i][0].im, tail));
    }
    return image;
}

// The derivative of the flow with respect to the initial set, in the scales before and after, real parts first.
ball_matrix complex_disc::scaled_map(const complex_ball& distance, const std::vector<long>& scales) const {
    const auto state = of_set_->at(distance);
    const std::size_t count = flow_->form_.lifted.leaves.size();
    const std::size_t size = set_.centre.size();
    const magnitude away = size_of(distance);
    ball_matrix map(2 * size, std::vector<ball>(2 * size, ball(0)));
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j < size; ++j) {
            const std::size_t index = count * (j + 1) + i;
            const magnitude tail = set_tail_->at(index, away);
            const long shift = set_.scales[j] - scales[i];
            const ball re = ldexp(widened(state[index][0].re, tail), shift);
            const ball im = ldexp(widened(state[index][0].im, tail), shift);
            map[i][j] = re;
            map[i][size + j] = -im;
            map[size + i][j] = im;
            map[size + i][size + j] = re;
        }
    }
    return map;
}

complex_set complex_disc::moved_to(const complex_ball& offset) const {
    const std::size_t size = set_.centre.size();
    complex_set result{offset, {}, {}, lohner_set()};
    const complex_ball distance = exact_difference(offset, set_.offset);
    if (!certainly_within(distance, radius())) {
        throw error(error_kind::argument, "offset", "", "is not inside the disc");
    }
    std::vector<magnitude> added;
    {
        const precision_scope scope(decimal_digits(bits_));
        const std::vector<complex_ball> image = image_at(distance);
        for (const complex_ball& each : image) {
            result.centre.push_back(exact_midpoint(each));
        }
        result.scales = scales_of(result.centre);
        for (const bool imaginary : {false, true}) {
            for (std::size_t i = 0; i < size; ++i) {
                const ball off =
                    imaginary ? ball(image[i].im - result.centre[i].im) : ball(image[i].re - result.centre[i].re);
                added.push_back(magnitude(off) * magnitude::of(1, -result.scales[i]));
            }
        }
    }
    if (singular_) {  // the initial values are as accurate as the series
        result.errors = lohner_set(std::move(added));
        return result;
    }
    const precision_scope few(decimal_digits(complex_flow::usual_error_bits));
    result.errors = set_.errors.moved(scaled_map(distance, result.scales), added);
    return result;
}

std::vector<complex_ball> complex_disc::values_over(const complex_ball& offset) const {
    const precision_scope few(decimal_digits(complex_flow::usual_error_bits));
    const complex_ball distance = offset - set_.offset;
    if (!certainly_within(distance, radius())) {
        throw error(error_kind::argument, "offset", "", "is not inside the disc");
    }
    const auto state = of_set_->at(distance);
    const magnitude away = size_of(distance);
    std::vector<complex_ball> values;
    for (std::size_t i = 0; i < set_.centre.size(); ++i) {
        const magnitude tail = set_tail_->at(i, away);
        values.emplace_back(widened(state[i][0].re, tail), widened(state[i][0].im, tail));
    }
    return values;
}

complex_ball complex_disc::integral(std::size_t unknown, const complex_ball& offset, const complex_ball& centre,
                                    const ball& scale, int power) const {
    if (singular_) {
        throw error(error_kind::argument, "offset", "",
                    "is on a path from a singular initial point, along which integrals are not available");
    }
    const precision_scope few(decimal_digits(complex_flow::usual_error_bits));
    const complex_ball distance = exact_difference(offset, set_.offset);
    const complex_ball from = exact_difference(set_.offset, centre) / scale;
    const complex_ball slope(ball(1) / scale);
    const complex_ball* const first = of_set_->coefficients(static_cast<int>(unknown));
    std::vector<complex_ball> terms(first, first + of_set_->order() + 1);
    magnitude largest(1U);
    for (int k = 0; k < power; ++k) {  // multiply by from + slope s
        terms.emplace_back(0);
        for (std::size_t n = terms.size(); n-- > 0;) {
            terms[n] = terms[n] * from + (n > 0 ? terms[n - 1] * slope : complex_ball(0));
        }
        largest *= size_of(from) + size_of(distance) * size_of(slope);
    }
    complex_ball sum(0);
    for (std::size_t n = terms.size(); n-- > 0;) {
        sum = sum * distance + terms[n] / static_cast<int>(n + 1);
    }
    sum = sum * distance;
    const magnitude tail = set_tail_->at(unknown, size_of(distance)) * largest * size_of(distance);
    return {widened(sum.re, tail), widened(sum.im, tail)};
}

}  // namespace libration::ode
