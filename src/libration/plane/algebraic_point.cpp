#include "libration/plane/algebraic_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "ray_state.hpp"

namespace libration::ode {

namespace {

constexpr int most_branch_steps = 400;
constexpr double branch_step = 0.4;
// The base relative to the branch point: farther from it if the expansion does not reach so far.
constexpr std::array base_parts{0.87, 0.95, 0.98, 0.995, 0.999};
constexpr long digits_of_norms = 20;
// The radii s_1 that are tried.
constexpr double longest_reach = 0.9;
constexpr double growth_of_reach = 1.1;
constexpr int most_reaches = 60;

using coefficient_row = std::vector<complex_ball>;

ball modulus(const complex_ball& z) { return sqrt(ball(z.re * z.re + z.im * z.im)); }

complex_ball unit_root(int q, int k) {
    const ball angle = pi<ball>() * (2 * k) / q;
    return {cos(angle), sin(angle)};
}

complex_ball any_root(const complex_ball& z, int q) {
    // Away from the cut of the principal root.
    const bool turned = rounded_midpoint(z).real() < 0;
    const flint_complex of(turned ? -z : z);
    flint_complex root;
    acb_root_ui(root.handle(), of.handle(), static_cast<ulong>(q), ball::working_bits());
    const ball half = pi<ball>() / q;
    return turned ? complex_ball(root.number() * complex_ball{cos(half), sin(half)}) : root.number();
}

// a b, as far as both reach.
coefficient_row product_of(const coefficient_row& a, const coefficient_row& b) {
    coefficient_row result;
    for (std::size_t n = 0; n < std::min(a.size(), b.size()); ++n) {
        complex_ball sum(0);
        for (std::size_t k = 0; k <= n; ++k) {
            sum = sum + a[k] * b[n - k];
        }
        result.push_back(sum);
    }
    return result;
}

coefficient_row quotient_of(const coefficient_row& a, const coefficient_row& b) {
    coefficient_row result;
    for (std::size_t n = 0; n < std::min(a.size(), b.size()); ++n) {
        complex_ball sum = a[n];
        for (std::size_t k = 1; k <= n; ++k) {
            sum = sum - b[k] * result[n - k];
        }
        result.push_back(sum / b[0]);
    }
    return result;
}

// a^(1/q) with a root of a_0: n a_0 p_n = sum (k/q - (n - k)) a_k p_(n-k).
coefficient_row root_of(const coefficient_row& a, int q, const complex_ball& first) {
    coefficient_row p{first};
    for (std::size_t n = 1; n < a.size(); ++n) {
        complex_ball sum(0);
        for (std::size_t k = 1; k <= n; ++k) {
            const long weight = static_cast<long>(k) - static_cast<long>(n - k) * q;
            sum = sum + a[k] * p[n - k] * ball(weight);
        }
        p.push_back(sum / (a[0] * ball(static_cast<long>(n) * q)));
    }
    return p;
}

struct expansion_of_tip {
    const uniformizing_chart& chart;
    series_disc disc;  // about s* = 0
    complex_ball place;
    complex_ball sigma;    // of the base
    complex_ball at_base;  // the principal x there
};

// Bounds of theorem T over |sigma| <= s_1.
class tip_norms {
public:
    tip_norms(const expansion_of_tip& of, const ball& x1, double s1) : of_(of), x1_(x1) { arb_set_d(s1_.handle(), s1); }

    const ball& s1() const { return s1_; }

    // Whether |om| < 1; then reach and size of the branch point.
    std::optional<std::pair<ball, ball>> bounds() const {
        const int q = of_.chart.sheets();
        const auto first = static_cast<std::size_t>(q);
        const ball om = upper_bound(norm_beyond(0, first + 1, first) / modulus(of_.disc.coefficients(0)[first]));
        if (!certainly_less(om, ball(1))) {
            return std::nullopt;
        }
        const ball root = ball(1) / q;
        const ball reach = lower_bound(x1_ * s1_ * pow(ball(1 - om), root));
        if (of_.chart.pole() == 0) {
            return std::pair(reach, upper_bound(norm_beyond(1, 0, 0)));
        }
        const ball least = modulus(of_.disc.coefficients(1)[1]) - norm_beyond(1, 2, 1);
        if (!certainly_less(ball(0), least)) {
            return std::nullopt;
        }
        return std::pair(reach, upper_bound(x1_ * pow(ball(1 + om), root) / least));
    }

private:
    // sum over n >= first of |coefficient n| s1^(n - less), and the error of the polynomial.
    ball norm_beyond(std::size_t unknown, std::size_t first, std::size_t less) const {
        const coefficient_row& a = of_.disc.coefficients(unknown);
        ball sum(0);
        for (std::size_t n = a.size(); n-- > first;) {
            sum = sum + ball(size_of(a[n]).exact()) * pow(s1_, static_cast<long>(n) - static_cast<long>(less));
        }
        const ball part = s1_ / of_.disc.radius().exact();
        return sum + of_.disc.error(unknown).exact() * pow(part, static_cast<long>(of_.disc.order() + 1)) /
                         pow(s1_, static_cast<long>(less));
    }

    const expansion_of_tip& of_;
    ball x1_, s1_;
};

expansion_of_tip expanded_tip(const explicit_system& system, const chart_atlas& atlas, const uniformizing_chart& chart,
                              std::complex<double> base, int order) {
    const plane_system in_s(chart.system());
    if (in_s.carried() != chart.system().unknowns().size()) {
        throw error(error_kind::undecided, error_subject::problem, "",
                    "contains functions of several values, with which branch points have no chart");
    }
    const long bits = ball::working_bits();
    const int path_order = static_cast<int>(bits) + 20;
    const complex_ball origin(atlas.time(complex_ball(0)));
    std::vector<complex_ball> state =
        chart.from(atlas.time(exact_point(base)), state_on_ray(system, atlas, base, path_order));
    series_disc disc(in_s, complex_ball(0), state, path_order);
    complex_ball s(0);
    std::vector<complex_ball> corners;
    for (int k = 0, known = 20; k < most_branch_steps && known < 4 * bits; ++k) {
        const auto [zero, slope] = chart.zero_and_slope(disc.at(s));
        complex_ball step = exact_midpoint(zero / slope);
        const double radius = mag_get_d(disc.radius().handle());
        const double length = size_of(step).above();
        if (!std::isfinite(length)) {
            throw precision_exhausted("the place of a branch point");
        }
        if (length > branch_step * radius) {
            step = exact_point(rounded_midpoint(step) * (branch_step * radius / length));
        } else {
            known *= 2;
        }
        s = exact_midpoint(s - step);
        if (size_of(complex_ball(s - disc.centre())).above() > branch_step * radius) {
            if (!certainly_within(exact_difference(s, disc.centre()), disc.radius())) {
                throw precision_exhausted("the place of a branch point");
            }
            disc = series_disc(in_s, s, disc.at(s), path_order);
            corners.push_back(s);
        }
    }
    // Interval Newton in boxes of increasing size.
    std::optional<complex_ball> proved;
    for (long less = 10; less < bits && !proved; less += 12) {
        const magnitude half = disc.radius() * magnitude::of(1, less - bits);
        const complex_ball around{widened(s.re, half), widened(s.im, half)};
        const complex_ball slope = chart.zero_and_slope(disc.at(around)).second;
        const complex_ball next = s - chart.zero_and_slope(disc.at(s)).first / slope;
        if (contains(around.re, next.re) && contains(around.im, next.im)) {
            proved = next;
        }
    }
    if (!proved) {
        throw precision_exhausted("the place of a branch point");
    }
    const std::vector<complex_ball> at_zero = chart.at_zero(disc.at(*proved));
    const complex_ball place = at_zero[0] - origin;
    const flint_complex part(complex_ball(1) - exact_point(base) / place);
    flint_complex root;
    acb_root_ui(root.handle(), part.handle(), static_cast<ulong>(chart.sheets()), bits);
    expansion_of_tip tip{chart, series_disc(in_s, complex_ball(0), at_zero, order), place, -*proved, root.number()};
    // The path from s = 0, where the disc about s* shall have the state of the base, lies in that disc.
    for (const complex_ball& each : corners) {
        if (!certainly_within(each - *proved, tip.disc.radius())) {
            throw precision_exhausted("the path to a branch point");
        }
    }
    return tip;
}

// x/sigma, its root of unity chosen at the base; throws if none is shown.
coefficient_row root_at_base(const expansion_of_tip& of, std::size_t count) {
    const int q = of.chart.sheets();
    coefficient_row w;
    for (std::size_t i = 0; i < count; ++i) {
        w.push_back(-of.disc.coefficients(0)[i + static_cast<std::size_t>(q)] / of.place);
    }
    coefficient_row x = root_of(w, q, any_root(w[0], q));
    for (int k = 0; k < q; ++k) {
        const complex_ball turn = unit_root(q, k);
        const complex_ball ratio = x[0] * of.sigma * turn / of.at_base;
        // |arg| < pi/q: all other roots are 2 pi/q apart, and arg (1 + om)^(1/q) is below pi/(2q).
        const ball angle = atan2(ratio.im, ratio.re);
        if (is_finite(angle) && certainly_less(abs(angle), ball(pi<ball>() / q))) {
            for (complex_ball& each : x) {
                each = each * turn;
            }
            return x;
        }
    }
    throw precision_exhausted("the root at a branch point");
}

std::optional<algebraic_point> algebraic_point_from(const expansion_of_tip& of, std::complex<double> base, int last) {
    const int q = of.chart.sheets();
    const int p = of.chart.pole();
    const auto count = static_cast<std::size_t>(last + p) + 2;
    const coefficient_row x = root_at_base(of, count);
    algebraic_point result;
    result.place = of.place;
    result.sheets = q;
    result.pole = p;
    result.base = base;
    std::optional<ball> s1;
    {
        const precision_scope few(digits_of_norms);
        // s_1 from |sigma| of the base on, inside the disc.
        const double end = longest_reach * mag_get_d(of.disc.radius().handle());
        double next = size_of(of.sigma).above() * growth_of_reach;
        for (int k = 0; k < most_reaches && next < end; ++k, next *= growth_of_reach) {
            const tip_norms norms(of, modulus(x[0]), next);
            const auto bounds = norms.bounds();
            if (bounds && (!s1 || certainly_less(result.reach, bounds->first))) {
                result.reach = bounds->first;
                result.size = bounds->second;
                s1 = norms.s1();
            }
        }
    }
    if (!s1 || !certainly_less(modulus(of.sigma), *s1) || !certainly_less(modulus(of.at_base), result.reach)) {
        return std::nullopt;
    }
    // b = y x^p as a series in sigma; [x^n] b = (1/n) [sigma^(n-1)] b' (sigma/x)^n.
    const coefficient_row& y = of.disc.coefficients(1);
    coefficient_row b(y.begin() + p, y.begin() + p + static_cast<std::ptrdiff_t>(count));
    if (p == 1) {
        b = quotient_of(x, b);
    }
    coefficient_row slope;
    for (std::size_t n = 1; n < count; ++n) {
        slope.push_back(b[n] * ball(static_cast<long>(n)));
    }
    coefficient_row one(count, complex_ball(0));
    one[0] = complex_ball(1);
    const coefficient_row inverse = quotient_of(one, x);
    coefficient_row power = inverse;
    result.coefficients.push_back(b[0]);
    for (std::size_t n = 1; n < count - 1; ++n) {
        complex_ball sum(0);
        for (std::size_t k = 0; k < n; ++k) {
            sum = sum + slope[k] * power[n - 1 - k];
        }
        result.coefficients.push_back(sum / ball(static_cast<long>(n)));
        power = product_of(power, inverse);
    }
    return result;
}

}  // namespace

magnitude algebraic_point::bound_over(const ball& x) const {
    const precision_scope few(digits_of_norms);
    const ball above = upper_bound(x);
    if (!certainly_less(above, reach)) {
        return magnitude(1U) / magnitude(0U);
    }
    magnitude sum;
    for (std::size_t k = coefficients.size(); k-- > 0;) {
        sum = sum * magnitude(above) + size_of(coefficients[k]);
    }
    const ball part = above / reach;
    sum += magnitude(ball(size * pow(part, static_cast<long>(coefficients.size())) / (1 - part)));
    for (int k = 0; k < pole; ++k) {
        sum = sum / magnitude::below(x);
    }
    return sum;
}

algebraic_point algebraic_point_near(const explicit_system& system, const chart_atlas& atlas,
                                     const uniformizing_chart& chart, const complex_ball& near, int last) {
    const std::complex<double> place = rounded_midpoint(near);
    const bool real = place.imag() == 0;
    for (const double part : base_parts) {
        const std::complex<double> base = place * part;
        std::optional<algebraic_point> found;
        try {
            found = algebraic_point_from(expanded_tip(system, atlas, chart, base, 2 * last + 60), base, last);
        } catch (const precision_exhausted&) {
            continue;  // closer to it the path in s is shorter
        }
        if (found) {
            if (real) {
                // Path, base and corrections are real: so is the only zero in a box about them, and y for real t before it.
                found->real = true;
                found->place.im = ball(0);
                for (complex_ball& each : found->coefficients) {
                    each.im = ball(0);
                }
            }
            return *std::move(found);
        }
    }
    throw precision_exhausted("the expansion at a branch point");
}

}  // namespace libration::ode
