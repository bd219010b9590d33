#include "libration/plane/series_disc.hpp"

#include <array>
#include <optional>
#include <utility>

#include "../expansion/set_values.hpp"
#include "libration/equation/first_order_form.hpp"

namespace libration::ode {

namespace {

// The fractions of the estimated radius that are tried, times 2^15.
constexpr std::array<unsigned long, 8> parts_of_series_radius{31'000, 28'800, 26'500, 23'500,
                                                              20'000, 16'000, 11'000, 6'000};
constexpr long digits_of_wide_values = 20;
const magnitude useful_error = magnitude::of(1, -10);
const magnitude widest_disc = magnitude::of(1, 64);

// Whether the errors are small compared with the unknowns over the disc: without that its rim is of no use.
bool is_useful(const tail_bound& bound, const taylor_expansion<complex_ball>& expansion, std::size_t unknowns) {
    for (std::size_t i = 0; i < unknowns; ++i) {
        const complex_ball* const a = expansion.coefficients(static_cast<int>(i));
        magnitude norm;
        for (int n = expansion.order(); n >= 0; --n) {
            norm = norm * bound.radius + size_of(a[n]);
        }
        if (norm * useful_error < bound.error[i]) {
            return false;
        }
    }
    return true;
}

std::optional<tail_bound> tail_of(const tape& of, const taylor_expansion<complex_ball>& expansion,
                                  const complex_ball& point, std::size_t carried, std::size_t unknowns) {
    const double log_of_radius = estimated_radius(expansion, unknowns);
    if (log_of_radius < no_radius) {
        const series_sizes sizes = sizes_of(of, expansion, point, expansion.order());
        for (const unsigned long part : parts_of_series_radius) {
            auto bound = bounded_tail(of, sizes, libration::power_of_two(log_of_radius) * magnitude::of(part, -15));
            if (bound && is_useful(*bound, expansion, carried)) {
                return bound;
            }
        }
    }
    return tail_near(of, expansion, point, log_of_radius);
}

}  // namespace

complex_ball exact_point(const std::complex<double>& z) {
    complex_ball result;
    arb_set_d(result.re.handle(), z.real());
    arb_set_d(result.im.handle(), z.imag());
    return result;
}

std::complex<double> rounded_midpoint(const complex_ball& z) {
    return {arf_get_d(arb_midref(z.re.handle()), ARF_RND_NEAR), arf_get_d(arb_midref(z.im.handle()), ARF_RND_NEAR)};
}

plane_system::plane_system(const explicit_system& of)
    : form_(lifted_for_paths(beyond_start(of))), tape_(tape::about_points(form_.lifted.system)), origin_(of.point()) {}

std::vector<complex_ball> carried_start(const explicit_system& of, const plane_system& as) {
    std::vector<complex_ball> given;
    for (const auto& of_unknown : of.starts()) {
        for (const number& each : of_unknown) {
            given.emplace_back(constant_value<ball>::of(each));
        }
    }
    if (as.carried() == given.size()) {
        return given;
    }
    return as.form().given_of(lifted_values(lifted(of), complex_ball(constant_value<ball>::of(of.point())), given));
}

series_disc::series_disc(const plane_system& of, complex_ball centre, const std::vector<complex_ball>& carried,
                         int order)
    : centre_(std::move(centre)) {
    const complex_ball time(constant_value<ball>::of(of.origin()) + centre_.re, centre_.im);
    const auto all = lifted_values(of.form().lifted, time, carried);
    if (!all_finite(all)) {
        throw precision_exhausted("a point of the plane");
    }
    taylor_expansion<complex_ball> expansion(of.points(), order);
    expansion.about(time, as_state(all));
    auto tail = tail_of(of.points(), expansion, time, carried.size(), all.size());
    if (!tail) {
        throw precision_exhausted("the radius about a point of the plane");
    }
    tail_ = *std::move(tail);
    if (widest_disc < tail_.radius) {  // of a polynomial; its error holds in a smaller disc, too
        tail_.radius = widest_disc;
    }
    for (std::size_t i = 0; i < carried.size(); ++i) {
        const complex_ball* const first = expansion.coefficients(static_cast<int>(i));
        coefficients_.emplace_back(first, first + order + 1);
    }
}

magnitude series_disc::distance_of(const complex_ball& from_centre) const {
    if (!certainly_within(from_centre, radius())) {
        throw precision_exhausted("a point outside a disc");
    }
    return size_of(from_centre);
}

std::vector<complex_ball> series_disc::at(const complex_ball& offset) const {
    const complex_ball distance = offset - centre_;
    const magnitude away = distance_of(distance);
    std::vector<complex_ball> values;
    for (std::size_t i = 0; i < coefficients_.size(); ++i) {
        complex_ball sum(0);
        for (std::size_t n = coefficients_[i].size(); n-- > 0;) {
            sum = sum * distance + coefficients_[i][n];
        }
        const magnitude tail = tail_.at(i, away);
        values.emplace_back(widened(sum.re, tail), widened(sum.im, tail));
    }
    return values;
}

std::vector<complex_ball> series_disc::over(const complex_ball& offset) const {
    const precision_scope few(digits_of_wide_values);
    const complex_ball distance = offset - centre_;
    const magnitude away = distance_of(distance);
    const complex_ball middle = exact_midpoint(distance);
    const magnitude width = size_of(complex_ball(distance - middle));
    const magnitude farthest = size_of(middle) + width;
    std::vector<complex_ball> values;
    for (const std::vector<complex_ball>& a : coefficients_) {
        complex_ball value(0);
        complex_ball slope(0);
        magnitude curvature;
        for (std::size_t n = a.size(); n-- > 0;) {
            slope = slope * middle + value;
            value = value * middle + a[n];
            if (n > 1) {
                curvature = curvature * farthest + size_of(a[n]) * magnitude(n * (n - 1));
            }
        }
        const magnitude error = width * (size_of(slope) + curvature * width / 2) + tail_.at(values.size(), away);
        values.emplace_back(widened(value.re, error), widened(value.im, error));
    }
    return values;
}

}  // namespace libration::ode
