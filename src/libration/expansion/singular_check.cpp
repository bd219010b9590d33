#include "singular_check.hpp"

#include <algorithm>

#include "libration/expansion/taylor_expansion.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

// Exact numbers as coefficients of a series.
struct exact_coefficient {
    number value;

    exact_coefficient(int n = 0) : value(rational(n)) {}
    explicit exact_coefficient(const number& of) : value(of) {}

    exact_coefficient operator-() const { return exact_coefficient(-value); }
    exact_coefficient& operator+=(const exact_coefficient& b) { return *this = exact_coefficient(value + b.value); }
    exact_coefficient& operator-=(const exact_coefficient& b) { return *this = exact_coefficient(value - b.value); }
    exact_coefficient& operator*=(const exact_coefficient& b) { return *this = exact_coefficient(value * b.value); }
    exact_coefficient& operator/=(const exact_coefficient& b) { return *this = exact_coefficient(value / b.value); }
    friend exact_coefficient operator+(exact_coefficient a, const exact_coefficient& b) { return a += b; }
    friend exact_coefficient operator-(exact_coefficient a, const exact_coefficient& b) { return a -= b; }
    friend exact_coefficient operator*(exact_coefficient a, const exact_coefficient& b) { return a *= b; }
    friend exact_coefficient operator/(exact_coefficient a, const exact_coefficient& b) { return a /= b; }
    friend bool operator==(const exact_coefficient& a, const exact_coefficient& b) {
        return (a.value - b.value).sign() == 0;
    }
    friend exact_coefficient pow(const exact_coefficient& base, const exact_coefficient& exponent) {
        return exact_coefficient(power(base.value, exponent.value));
    }
};

template <>
struct constant_value<exact_coefficient> {
    static exact_coefficient of(const number& x) { return exact_coefficient(x); }
};

template <>
exact_coefficient function_value<exact_coefficient>(function_kind f, const exact_coefficient& x,
                                                    const rational* order) {
    return exact_coefficient(has_order(f) ? apply(f, *order, x.value) : apply(f, x.value));
}

namespace {

// Decided exactly: a number near 0 is nonzero.
bool vanishes(const std::string& name, const exact_coefficient& x) {
    try {
        return x.value.sign() == 0;
    } catch (const error& problem) {
        if (problem.kind() != error_kind::undecided) {
            throw;
        }
        refuse(name, {},
               "is not proved to have a power series with these initial values, since a difference of the sides of "
               "the equation may be 0 or not: choose numbers that decide it, or another initial point");
    }
}

}  // namespace

void require_consistent_start(const tape& made, const explicit_system& of) {
    const int root = made.root();
    const int highest = *std::ranges::max_element(made.orders());
    taylor_expansion<exact_coefficient> series(made, root * (highest - 1));
    series.about_start();
    for (std::size_t i = 0; i < of.unknowns().size(); ++i) {
        const unknown_function& unknown = of.unknowns()[i];
        const exact_coefficient* const y = series.coefficients(static_cast<int>(i));
        const exact_coefficient* const right = series.right_side(static_cast<int>(i));
        for (int n = 0; n <= root * (unknown.order - 1); ++n) {
            exact_coefficient left = y[n];
            for (int l = 0; l < unknown.order; ++l) {
                left = left * (n - l * root) / root;
            }
            if (!vanishes(unknown.name, left - right[n])) {
                refuse(unknown.name, {},
                       "has no power series with these initial values, since the equation contradicts " +
                           primed(unknown.name, n / root) +
                           "(t0), or the solution has a logarithm: choose another initial point");
            }
        }
        for (const tape_state& state : made.states()) {
            for (int n = 1; state.unknown == static_cast<int>(i) && n < root * state.derivative; ++n) {
                if (n % root != 0 && !vanishes(unknown.name, y[n])) {
                    refuse(
                        primed(unknown.name, state.derivative), {},
                        "is infinite at the initial point and occurs in the equations: choose another initial point");
                }
            }
        }
    }
}

}  // namespace libration::ode
