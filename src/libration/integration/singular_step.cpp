#include "libration/integration/singular_step.hpp"

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "../expansion/set_values.hpp"
#include "../expansion/step_norms.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/scalar/proved.hpp"

namespace libration::ode {

namespace {

// The step is at most 2^-bits_a_power times the proved radius.
constexpr long bits_a_power = 3;
constexpr int more_powers = 24;

[[noreturn]] void refuse_start(const std::string& why) {
    throw error(error_kind::argument, error_subject::problem, "", "has a singular initial point " + why);
}

void require_bounded_steps(const tape& of) {
    if (of.root() != 1) {
        refuse_start("with powers of a root of the distance, which is not proved: choose another initial point");
    }
    for (const tape_state& each : of.states()) {
        if (each.derivative > 1) {
            refuse_start("with second derivatives, which is not proved: choose another initial point");
        }
    }
    for (const tape_step& each : of.steps()) {
        if (!norms_of_steps::bounds(each)) {
            refuse_start("where it takes " + std::string(name_of(each.function)) +
                         ", which is not proved there: write it with exp, log, sin, cos, sinh, cosh, powers and "
                         "quotients, or choose another initial point");
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
    require_bounded_steps(of);
    return of;
}

tail_bound tail_of(const tape& of, const taylor_expansion<ball>& expansion, int degree) {
    const double log_of_radius = estimated_radius(expansion, of.orders().size());
    const auto bound = first_tail(log_of_radius < no_radius ? log_of_radius : 0, [&](const magnitude& radius) {
        return bounded_singular_tail(of, expansion, degree, radius);
    });
    if (bound) {
        return *bound;
    }
    throw precision_exhausted("the first step from a singular initial point");
}

}  // namespace

singular_series::singular_series(const explicit_system& system, long bits, int degree, const proof_route& route)
    : of_(tape_of(system)), expansion_(of_, degree + route.more_terms + longest_lag(of_) + 1, route.product) {
    const precision_scope scope(decimal_digits(bits) + 10);
    expansion_.about_start();
    tail_ = tail_of(of_, expansion_, degree + route.more_terms);
}

// |e^(l)| for e = O(s^(N+1)) of the norm `error`: n .. (n-l+1) |s|^(n-l)/rho^n is largest at n = N + 1 if its quotients
// (n+1)/(n+1-l) |s|/rho are at most 1 from there on.
magnitude singular_series::bound(std::size_t unknown, const magnitude& distance, unsigned long derivative) const {
    const auto first = static_cast<unsigned long>(tail_.degree) + 1;
    const ball longest = tail_.radius.exact() * magnitude(first + 1 - derivative).exact();
    if (!certainly_less(distance.exact() * magnitude(first + 1).exact(), longest)) {
        throw precision_exhausted("a derivative near the edge of the disc about a singular initial point");
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

singular_step proved_singular_step(const explicit_system& system, long bits, const proof_route& route) {
    const precision_scope scope(decimal_digits(bits) + 10);
    auto series = std::make_shared<const singular_series>(system, bits,
                                                          static_cast<int>(bits / bits_a_power) + more_powers, route);
    const long exponent = series->radius().exponent() - 1 - bits_a_power;
    const rational power = exponent < 0 ? rational(1, integer(1) << static_cast<unsigned>(-exponent))
                                        : rational(integer(1) << static_cast<unsigned>(exponent));
    const rational step = power * rational(route.step_eighths, 8);
    const ball distance = from_rational<ball>(step);  // exact: three bits
    auto state = series->at(distance);
    return {first_order_form(system).about_points(system.point() + number(step)), std::move(series), distance,
            std::move(state)};
}

namespace {

std::string variation_of(const std::string& name) { return "variation of " + name; }

// The system together with the derivative of its solution with respect to initial value l of unknown k.
equation_system with_variation(const explicit_system& system, std::size_t k, std::size_t l) {
    equation_system made;
    made.variable = system.variable();
    const expression point(system.point());
    const auto& unknowns = system.unknowns();
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        const auto& [name, order] = unknowns[i];
        const expression here = unknown(name);
        const expression varied = unknown(variation_of(name));
        expression sum(0);
        for (const unknown_function& each : unknowns) {
            for (int j = 0; j < each.order; ++j) {
                sum = sum + partial(system.right()[i], unknown(each.name, j)) * unknown(variation_of(each.name), j);
            }
        }
        made.add(unknown(name, order), system.right()[i]);
        made.add(unknown(variation_of(name), order), sum);
        for (std::size_t j = 0; j < system.starts()[i].size(); ++j) {
            const int order_of_start = static_cast<int>(j);
            made.begin(derivative(here, order_of_start), expression(system.starts()[i][j]), point);
            made.begin(derivative(varied, order_of_start), i == k && j == l ? 1 : 0, point);
        }
    }
    return made;
}

// The derivatives with respect to that initial value at a distance; std::nullopt if the equation fixes it.
std::optional<std::vector<ball>> varied_state(const explicit_system& given, std::size_t k, std::size_t l,
                                              const ball& distance, long bits, const proof_route& route) {
    const explicit_system system(with_variation(given, k, l));
    std::optional<singular_series> series;
    try {
        series.emplace(system, bits, static_cast<int>(bits / bits_a_power) + more_powers, route);
    } catch (const error& refusal) {
        if (refusal.kind() == error_kind::argument) {
            return std::nullopt;
        }
        throw;
    }
    const std::vector<ball> state = series->at(distance);
    std::vector<ball> varied;
    for (const unknown_function& each : given.unknowns()) {
        std::size_t place = 0;
        for (const unknown_function& other : system.unknowns()) {
            if (other.name == variation_of(each.name)) {
                varied.insert(varied.end(), state.begin() + static_cast<std::ptrdiff_t>(place),
                              state.begin() + static_cast<std::ptrdiff_t>(place) + other.order);
            }
            place += static_cast<std::size_t>(other.order);
        }
    }
    return varied;
}

}  // namespace

ball_matrix derivative_beyond_start(const explicit_system& system, const ball& distance, long bits,
                                    const proof_route& route) {
    const precision_scope scope(decimal_digits(bits) + 10);
    const std::size_t size = first_order_form(system).leaves.size();
    ball_matrix result(size);
    for (std::size_t k = 0; k < system.unknowns().size(); ++k) {
        for (std::size_t l = 0; l < system.starts()[k].size(); ++l) {
            const auto column = varied_state(system, k, l, distance, bits, route);
            if (!column && system.starts()[k][l].sign() != 0) {
                throw error(error_kind::undecided, error_subject::problem, "",
                            "fixes " + primed(system.unknowns()[k].name, static_cast<int>(l)) +
                                " at its singular initial point, so that the dependence on it cannot be proved");
            }
            for (std::size_t i = 0; i < size; ++i) {
                result[i].push_back(column ? (*column)[i] : ball(0));
            }
        }
    }
    return result;
}

}  // namespace libration::ode
