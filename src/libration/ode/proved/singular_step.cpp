#include "libration/ode/proved/singular_step.hpp"

#include <algorithm>
#include <concepts>
#include <string>
#include <utility>

#include "libration/ode/ball/fast_product.hpp"
#include "libration/ode/first_order_form.hpp"
#include "libration/scalar/proved.hpp"
#include "set_values.hpp"

namespace libration::ode {

namespace {

// The step is at most 2^-bits_a_power of the proved radius.
constexpr long bits_a_power = 3;
constexpr int more_powers = 24;

[[noreturn]] void refuse_start(const std::string& why) {
    throw error(error_kind::argument, "problem", "", "starts where its equation is singular, " + why);
}

void require_polynomials(const tape& of) {
    if (of.root() != 1) {
        refuse_start("with powers of a root of the distance, which is not proved: choose another start");
    }
    for (const tape_state& each : of.states()) {
        if (each.derivative > 1) {
            refuse_start("with second derivatives, which is not proved: choose another start");
        }
    }
    using enum operation;
    for (const tape_step& each : of.steps()) {
        switch (each.kind) {
            case constant:
            case variable:
            case state:
            case sum:
            case difference:
            case scaled:
            case raised:
            case delayed:
            case product:
            case square: break;
            default: refuse_start("with more than products of its unknowns, which is not proved: choose another start");
        }
    }
}

int longest_lag(const tape& of) {
    int longest = 0;
    for (const tape_step& each : of.steps()) {
        longest = std::max(longest, each.lag);
    }
    return longest;
}

tape tape_of(const explicit_system& system) {
    tape of = tape::about_start(system);
    require_polynomials(of);
    return of;
}

tail_bound tail_of(const tape& of, const taylor_expansion<ball>& expansion, int degree) {
    magnitude size;
    const std::size_t unknowns = of.orders().size();
    for (std::size_t i = 0; i < unknowns; ++i) {
        size = std::max(size, magnitude(expansion.coefficients(static_cast<int>(i))[0]));
    }
    const double log_of_radius = estimated_radius(expansion, unknowns, size.is_zero() ? magnitude(1U) : size);
    const magnitude estimate = power_of_two(log_of_radius < no_radius ? log_of_radius : 0);
    magnitude radius;
    for (const unsigned long part : tried_parts) {
        radius = estimate * magnitude::of(part * 328, -15);
        if (auto bound = bounded_singular_tail(of, expansion, degree, radius)) {
            return *bound;
        }
    }
    for (int half = 0; half < tried_halves; ++half) {
        radius *= magnitude::of(1, -1);
        if (auto bound = bounded_singular_tail(of, expansion, degree, radius)) {
            return *bound;
        }
    }
    throw precision_exhausted("the first step from a singular start");
}

// n .. (n - l + 1)
ball falling(int n, int l) {
    ball result(1);
    for (int j = 0; j < l; ++j) {
        result *= n - j;
    }
    return result;
}

}  // namespace

singular_series::singular_series(const explicit_system& system, long bits, int degree)
    : of_(tape_of(system)), expansion_(of_, degree + longest_lag(of_) + 1, fast_product<ball>()) {
    const precision_scope scope(decimal_digits(bits) + 10);
    expansion_.about_start();
    tail_ = tail_of(of_, expansion_, degree);
}

// |e^(l)| for e = O(s^(N+1)) of the norm `error`: n .. (n-l+1) |s|^(n-l)/rho^n is largest at n = N + 1 where its quotients
// (n+1)/(n+1-l) |s|/rho are at most 1 from there on.
magnitude singular_series::bound(std::size_t unknown, const magnitude& distance, unsigned long derivative) const {
    const auto first = static_cast<unsigned long>(tail_.degree) + 1;
    const ball longest = tail_.radius.exact() * magnitude(first + 1 - derivative).exact();
    if (!certainly_less(distance.exact() * magnitude(first + 1).exact(), longest)) {
        throw precision_exhausted("a derivative near the edge of the disc about a singular start");
    }
    magnitude result = tail_.error[unknown] * pow(distance / tail_.radius, first - derivative);
    for (unsigned long j = 0; j < derivative; ++j) {
        result = result * magnitude(first - j) / tail_.radius;
    }
    return result;
}

template <field R>
std::vector<R> singular_series::at(const R& distance) const {
    const magnitude away = size_of(distance);
    std::vector<R> values;
    for (std::size_t i = 0; i < of_.orders().size(); ++i) {
        const ball* const a = expansion_.coefficients(static_cast<int>(i));
        for (int l = 0; l < of_.orders()[i]; ++l) {
            R sum(0);
            for (int n = tail_.degree; n >= l; --n) {
                sum = sum * distance + a[n] * falling(n, l);
            }
            const magnitude rest = bound(i, away, static_cast<unsigned long>(l));
            if constexpr (std::same_as<R, ball>) {
                values.push_back(widened(std::move(sum), rest));
            } else {
                values.emplace_back(widened(std::move(sum.re), rest), widened(std::move(sum.im), rest));
            }
        }
    }
    return values;
}

template std::vector<ball> singular_series::at(const ball&) const;
template std::vector<complex_number<ball>> singular_series::at(const complex_number<ball>&) const;

singular_step proved_singular_step(const explicit_system& system, long bits) {
    const precision_scope scope(decimal_digits(bits) + 10);
    const singular_series series(system, bits, static_cast<int>(bits / bits_a_power) + more_powers);
    const long exponent = series.radius().exponent() - 1 - bits_a_power;
    const ball distance = magnitude::of(1, exponent).exact();
    const rational step = exponent < 0 ? rational(1, integer(1) << static_cast<unsigned>(-exponent))
                                       : rational(integer(1) << static_cast<unsigned>(exponent));
    return {first_order_form(system).about_points(system.point() + number(step)), series.at(distance),
            series.at(hull(ball(0), distance))};
}

}  // namespace libration::ode
