#include "well_side.hpp"

#include <algorithm>
#include <cmath>

#include "../../algebra/dense_matrix.hpp"
#include "libration/algebra/ball_matrix.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/scalar.hpp"
#include "polynomial_range.hpp"
#include "zero_count.hpp"

namespace libration::ode {

namespace {

constexpr long first_quarters = -160;
constexpr long last_quarters = 160;
constexpr int most_far_steps = 100'000;
constexpr int most_doublings_of_far = 12;
constexpr int most_halvings_at_pole = 60;
constexpr long bits_of_shortest_step = 100;
constexpr double size_of_counted_step = 1;
constexpr double least_size_of_step = 4;
constexpr double bits_per_size = 24;

}  // namespace

well_side::well_side(const well_equation& of, well_end end, ball m)
    : well_(of), end_(std::move(end)), m_(std::move(m)) {
    if (end_.point && !well_.exponential) {
        read_pole();
    }
    if (!end_.point && tends_to_infinity() && well_.potential.sign_at_infinity() < 0) {
        throw error(error_kind::argument, error_subject::problem, "",
                    "has a potential that tends to -infinity at an end at infinity, where no solution decays like an "
                    "exponential function: change the sign, or the end");
    }
}

void well_side::read_pole() {
    const rational_function from_end = well_.potential.of_sum(*end_.point).of_negative();
    std::vector<rational> above = from_end.above().coefficients();
    std::vector<rational> below = from_end.below().coefficients();
    std::size_t order = 0;
    while (below.front() == 0) {
        below.erase(below.begin());
        ++order;
    }
    if (order == 0) {
        return;
    }
    const bool decided = order < 2 || (order == 2 && rational(above.front() / below.front()) > 0);
    if (!decided || end_.value != 0) {
        throw error(error_kind::undecided, error_subject::problem, "",
                    "has a pole of the potential at an end, and only psi = 0 where V is about g/x^2, g > 0, or g/x, "
                    "is supported there");
    }
    above.insert(above.begin(), 2 - order, rational(0));
    pole_ = {std::move(above), std::move(below)};
}

bool well_side::tends_to_infinity() const { return well_.potential.degree() > 0; }

std::optional<rational> well_side::continuum() const {
    if (end_.point || tends_to_infinity()) {
        return std::nullopt;
    }
    return well_.potential.degree() == 0 ? rational(well_.potential.above().coefficients().back() / well_.weight)
                                         : rational(0);
}

double well_side::potential_near(double s) const {
    const auto value = [s](const rational_polynomial& p) {
        double sum = 0;
        for (int i = p.degree(); i >= 0; --i) {
            sum = sum * s + p[i].convert_to<double>();
        }
        return sum;
    };
    return value(well_.potential.above()) / value(well_.potential.below());
}

// V - c E = above/below.
well_side::quotient_at well_side::quotient(const ball& e) const {
    quotient_at q{balls_of(well_.potential.above()), balls_of(well_.potential.below())};
    const ball product = from_rational<ball>(well_.weight) * e;
    q.above.resize(std::max(q.above.size(), q.below.size()), ball(0));
    for (std::size_t i = 0; i < q.below.size(); ++i) {
        q.above[i] -= product * q.below[i];
    }
    return q;
}

// below psi_ss = above psi, or with s = exp(r x), below r^2 (s^2 psi_ss + s psi_s) = above psi.
second_order_equation well_side::equation(const quotient_at& q) const {
    if (!well_.exponential) {
        return {q.below, {}, q.above};
    }
    const ball rate = from_rational<ball>(well_.rate);
    const ball square = rate * rate;
    return {times({ball(0), ball(0), square}, q.below), times({ball(0), square}, q.below), q.above};
}

// Points with distances from m that grow like powers of 2 with three between them.
ball well_side::point_at(long k) const {
    const long power = k >= 0 ? k / 4 : -((-k + 3) / 4);
    const ball distance = ldexp(ball(4 + (k - 4 * power)), power - 2);
    return well_.exponential ? m_ + m_ * distance : m_ + distance;
}

// ds/dx.
ball well_side::speed(const ball& s) const { return well_.exponential ? from_rational<ball>(well_.rate) * s : ball(1); }

ball well_side::first_point(const quotient_at& q) const {
    for (long k = first_quarters; k <= last_quarters; ++k) {
        const ball from = point_at(k);
        if (is_positive_from(q.above, from) && is_positive_from(q.below, from)) {
            return from;
        }
    }
    throw error(error_kind::undecided, error_subject::problem, "",
                "has no bound beyond which V - E > 0 is seen: E is in the continuous spectrum, or a decaying solution "
                "is not seen at infinity");
}

// Where the error of the slope has decreased by so many bits between there and `from`, roughly.
ball well_side::far_point(const quotient_at& q, const ball& from, long bits) const {
    constexpr double half_of_log_two = 0.347;
    const double wanted = half_of_log_two * static_cast<double>(bits) + 1;
    const precision_scope scope(decimal_digits(64));
    double sum = 0;
    ball s = from;
    for (int k = 0; k < most_far_steps && sum < wanted; ++k) {
        const ball distance = well_.exponential ? s : s - m_;
        const ball step = ldexp(ball(1), magnitude(distance).exponent() - 5);
        s += step;
        const double root = std::sqrt(std::max(0., as_double(value_at(q.above, s) / value_at(q.below, s))));
        sum += root * as_double(step / speed(s));
    }
    return s;
}

std::optional<ball> well_side::barrier(const quotient_at& q, const ball& far) const {
    const ball value = value_at(q.above, far) / value_at(q.below, far);
    if (!tends_to_infinity()) {
        const std::size_t n = std::max(q.above.size(), q.below.size()) - 1;
        const ball range = range_from(q.above, n, far) / range_from(q.below, n, far);
        if (arb_is_positive(range.handle()) == 0 || arb_is_positive(far.handle()) == 0) {
            return std::nullopt;
        }
        return -sqrt(range);
    }
    // Q = N/D, Q' = A/D^2, Q'' = B/D^3 with ' = d/dx = sigma d/ds.
    const ball_polynomial sigma =
        well_.exponential ? ball_polynomial{ball(0), from_rational<ball>(well_.rate)} : ball_polynomial{ball(1)};
    const ball_polynomial d_slope = slope_of(q.below);
    const ball_polynomial a = times(sigma, added(times(slope_of(q.above), q.below), -1, times(q.above, d_slope)));
    const ball_polynomial b = times(sigma, added(times(slope_of(a), q.below), -2, times(a, d_slope)));
    const ball_polynomial test = added(added({}, 5, times(a, a)), -4, times(q.above, b));
    if (!is_nonnegative_from(a, far) || !is_nonnegative_from(test, far)) {
        return std::nullopt;
    }
    const ball below = value_at(q.below, far);
    const ball by_x = value_at(a, far) / (below * below);
    return hull(-sqrt(value), -sqrt(value) - by_x / (value * 4));
}

// The solution that decays at s = exp(r x) -> inf, where Q has a limit.
std::optional<ball> well_side::regular_slope(const quotient_at& q, const ball& far) const {
    const ball rate = from_rational<ball>(well_.rate);
    regular_equation of{q.above, times({rate * rate}, q.below), 0};
    const std::size_t size = std::max(of.above.size(), of.below.size());
    for (ball_polynomial* each : {&of.above, &of.below}) {  // in 1/s
        each->resize(size, ball(0));
        std::ranges::reverse(*each);
    }
    const auto found = regular_solution_at(of, ball(1) / far);
    return found ? std::optional(-rate * found->slope / found->value) : std::nullopt;
}

// From the pole at the right end.
std::optional<end_state> well_side::at_pole(const ball& e, const second_order_equation& of, bool counts_zeros) const {
    regular_equation about{balls_of(pole_->above), balls_of(pole_->below), 1};
    const ball product = from_rational<ball>(well_.weight) * e;
    about.above.resize(std::max(about.above.size(), about.below.size() + 2), ball(0));
    for (std::size_t i = 0; i < about.below.size(); ++i) {
        about.above[i + 2] -= product * about.below[i];
    }
    const ball end = from_rational<ball>(*end_.point);
    ball distance = ldexp(ball(1), magnitude(end - m_).exponent() - 2);
    for (int k = 0; k < most_halvings_at_pole; ++k, distance = ldexp(distance, -1)) {
        const auto found = regular_solution_at(about, distance);
        if (found && found->is_positive) {
            return carried(of, end - distance, {found->value, -found->slope / distance, 0}, counts_zeros);
        }
    }
    return std::nullopt;
}

// z at a point from which on Q > 0.
std::optional<ball> well_side::slope_from_infinity(const quotient_at& q, const ball& from) const {
    const slong bits = ball::working_bits();
    const bool regular = well_.exponential && !tends_to_infinity();
    ball far = regular ? from : far_point(q, from, bits);
    std::optional<ball> z;
    for (int k = 0; k < most_doublings_of_far && !z; ++k) {  // where the inequalities begin to hold
        far += k == 0 ? ball(0) : well_.exponential ? far : far - m_;
        z = regular ? regular_slope(q, far) : barrier(q, far);
    }
    if (!z) {
        throw error(
            error_kind::undecided, error_subject::problem, "",
            "has a potential of which no barrier at infinity is found: 5 V'^2 >= 4 (V - E) V'' is not shown there");
    }
    const second_order_equation of = equation(q);
    const magnitude width = magnitude::radius_of(*z);
    end_state u{ball(1), exact_midpoint(*z)};
    const magnitude beyond = width + magnitude(abs(*z)).shifted(4 - bits);  // with the rounding of the midpoint
    end_state v{ball(0), ball(1)};
    ball s = far;
    const double size = least_size_of_step + static_cast<double>(bits) / bits_per_size;
    while (arb_gt(s.handle(), from.handle()) != 0) {
        const auto step = second_order_step::towards(of, s, from, size);
        if (!step) {
            return std::nullopt;
        }
        const ball before = speed(s);
        s += step->length();
        const ball after = speed(s);
        for (end_state* each : {&u, &v}) {
            const auto solution = step->solution(each->value, each->slope / before);
            if (!solution) {
                return std::nullopt;
            }
            *each = {solution->value(ball(1)), solution->slope(ball(1)) * after};
        }
    }
    const ball rest = lower_bound(u.value - (beyond * magnitude(v.value)).exact());
    if (arb_is_positive(rest.handle()) == 0) {
        return std::nullopt;
    }
    const magnitude error = beyond / (magnitude::below(u.value) * magnitude::below(rest));
    return widened(u.slope / u.value, error);
}

std::optional<end_state> well_side::carried(const second_order_equation& of, ball from, end_state state,
                                            bool counts_zeros) const {
    const double size = counts_zeros ? size_of_counted_step
                                     : least_size_of_step + static_cast<double>(ball::working_bits()) / bits_per_size;
    int sign = 1;  // of psi
    while (arb_gt(from.handle(), m_.handle()) != 0) {
        const auto step = second_order_step::towards(of, from, m_, size);
        const bool stands =
            step && magnitude(step->length()).exponent() < magnitude(from - m_).exponent() - bits_of_shortest_step;
        if (!step || stands) {
            throw error(error_kind::undecided, error_subject::problem, "",
                        "has a singular point between its ends, which is not supported");
        }
        const auto solution = step->solution(state.value, state.slope / speed(from));
        if (!solution) {
            return std::nullopt;
        }
        from += step->length();
        state.value = solution->value(ball(1));
        state.slope = solution->slope(ball(1)) * speed(from);
        if (counts_zeros) {
            const auto more = zeros_in_step(*solution, sign);
            if (!more) {
                return std::nullopt;
            }
            state.zeros += *more;
            sign = *more % 2 == 0 ? sign : -sign;
        }
    }
    return state;
}

std::optional<end_state> well_side::at(const ball& e, bool counts_zeros) const {
    const quotient_at q = quotient(e);
    const second_order_equation of = equation(q);
    if (pole_) {
        return at_pole(e, of, counts_zeros);
    }
    if (end_.point) {
        const ball from = well_.exponential ? ball(1) : from_rational<ball>(*end_.point);
        return carried(of, from, {from_rational<ball>(end_.value), from_rational<ball>(end_.slope), 0}, counts_zeros);
    }
    const ball from = first_point(q);
    const auto z = slope_from_infinity(q, from);
    return z ? carried(of, from, {ball(1), *z, 0}, counts_zeros) : std::nullopt;
}

}  // namespace libration::ode
