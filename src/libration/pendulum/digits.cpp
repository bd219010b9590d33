#include "libration/pendulum/digits.hpp"

#include "given_question.hpp"
#include "libration/digits/agreed_values.hpp"
#include "libration/digits/bounded_value.hpp"
#include "libration/number/given_number.hpp"
#include "libration/pendulum/error_norm.hpp"
#include "libration/pendulum/exact_solution.hpp"
#include "libration/pendulum/period.hpp"
#include "libration/pendulum/point_coefficients.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/exponent_range.hpp"

namespace libration::rounded {

using namespace pendulum;

namespace {

// One number without an error bound.
template <class Compute>
rounded_decimal agreed(long digits, const Compute& compute, const std::function<std::vector<bool>()>& vanishing = {}) {
    const auto run = [&](long guard) {
        const precision_scope scope(given_digits(digits) + guard);
        return std::vector<mpfr>{compute()};
    };
    return {to_decimal(agreed_values(digits, run, vanishing).front(), digits)};
}

// One number with an error of at most this many epsilon of itself.
template <class Compute>
rounded_decimal bounded(long digits, int epsilons, const Compute& compute) {
    const auto run = [&] {
        const mpfr value = compute();
        return bounded_value{value, abs(value) * epsilon<mpfr>() * epsilons};
    };
    constexpr long lost = 4;
    return {to_decimal(value_within_bound(given_digits(digits), lost, run), digits)};
}

// A multiple of T*. The energies are within an epsilon and k, k', the rate and the unit within 4; the chain
// has at most 64 levels, each of which adds less than 2.
rounded_decimal quarters(const pendulum::given_motion& given, int count, long digits) {
    const pendulum::motion m = exact_motion(given);
    if (at_critical_energy(m.regime())) {
        return {"inf"};
    }
    constexpr int epsilons = 512;
    return bounded(digits, epsilons, [&] {
        const int factor = count == 0 ? quarters_per_period(m.regime()) : count;
        return mpfr(effective_period(energy_level_of<mpfr>(m)) * time_unit<mpfr>(m) * factor);
    });
}

// E or 2 - E, each within an epsilon.
rounded_decimal part_of_energy(const pendulum::motion& m, const std::optional<rational>& exactly, long digits,
                               mpfr pendulum::energy_pair<mpfr>::*part) {
    if (const auto text = short_decimal(exactly, given_digits(digits))) {
        return {*text};
    }
    return bounded(digits, 2, [&] { return energies<mpfr>(m).*part; });
}

}  // namespace

rounded_decimal theta(const pendulum::given_motion& motion, const std::string& time, long digits) {
    const pendulum::motion m = exact_motion(motion);
    const exact at = exact_time(m, time);
    return agreed(digits, [&] { return pendulum::exact_solution<mpfr>(m)(at).theta; });
}

rounded_decimal omega(const pendulum::given_motion& motion, const std::string& time, long digits) {
    const pendulum::motion m = exact_motion(motion);
    const exact at = exact_time(m, time);
    return agreed(digits, [&] { return mpfr(pendulum::exact_solution<mpfr>(m)(at).omega / time_unit<mpfr>(m)); });
}

rounded_decimal period(const pendulum::given_motion& motion, long digits) { return quarters(motion, 0, digits); }

rounded_decimal effective_period(const pendulum::given_motion& motion, long digits) {
    return quarters(motion, 1, digits);
}

rounded_decimal energy(const pendulum::given_motion& motion, long digits) {
    const pendulum::motion m = exact_motion(motion);
    return part_of_energy(m, m.energy(), digits, &pendulum::energy_pair<mpfr>::energy);
}

rounded_decimal gap(const pendulum::given_motion& motion, long digits) {
    const pendulum::motion m = exact_motion(motion);
    const auto exactly = m.energy() ? std::optional(rational(2 - *m.energy())) : std::nullopt;
    return part_of_energy(m, exactly, digits, &pendulum::energy_pair<mpfr>::gap);
}

rounded_decimal coefficient(const pendulum::given_motion& motion, const std::string& point, long n, long digits) {
    const whole_exponent_range exponents;  // of a_n ~ R^-n
    const pendulum::motion m = exact_motion(motion);
    const pendulum::expansion_point at = exact_point(m, point, n);
    return agreed(
        digits, [&] { return point_coefficients<mpfr>(m, at, n, n).front(); },
        [&] { return vanishing_at(m, at, n, n); });
}

rounded_decimal radius(const pendulum::given_motion& motion, const std::string& point, long digits) {
    const pendulum::motion m = exact_motion(motion);
    const pendulum::expansion_point at = exact_point(m, point, 0);
    if (at_rest(m.regime())) {
        return {"inf"};
    }
    return agreed(given_digits(digits),
                  [&] { return mpfr(*radius_about(pendulum::exact_solution<mpfr>(m), at) * time_unit<mpfr>(m)); });
}

rounded_decimal error_norm(const pendulum::given_motion& motion, pendulum::arc_method method, int order, long digits) {
    const pendulum::motion m = pendulum::motion::of_energy(energy_of_norm(exact_motion(motion), order));
    const long below = digits_below(m, order);
    return agreed(digits, [&] {
        const precision_scope wider(working_digits() + below);
        return pendulum::arc_errors(m).norm(method, order).norm;
    });
}

}  // namespace libration::rounded
