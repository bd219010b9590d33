// A user-defined number type: a double that counts its multiplications.
#pragma once

#include <cmath>
#include <libration/scalar/scalar.hpp>

struct counting {
    double value = 0;
    static inline long multiplications = 0;

    counting() = default;
    explicit counting(double x) : value(x) {}

    counting& operator+=(counting b) { return *this = *this + b; }
    counting& operator-=(counting b) { return *this = *this - b; }
    counting& operator*=(counting b) { return *this = *this * b; }
    counting& operator/=(counting b) { return *this = *this / b; }
    friend counting operator-(counting a) { return counting(-a.value); }
    friend counting operator+(counting a, counting b) { return counting(a.value + b.value); }
    friend counting operator-(counting a, counting b) { return counting(a.value - b.value); }
    friend counting operator*(counting a, counting b) {
        ++multiplications;
        return counting(a.value * b.value);
    }
    friend counting operator/(counting a, counting b) { return counting(a.value / b.value); }
    friend counting operator+(counting a, int n) { return counting(a.value + n); }
    friend counting operator-(counting a, int n) { return counting(a.value - n); }
    friend counting operator*(counting a, int n) { return counting(a.value * n); }
    friend counting operator/(counting a, int n) { return counting(a.value / n); }
    friend counting operator/(int n, counting a) { return counting(n / a.value); }
    friend counting operator+(int n, counting a) { return counting(n + a.value); }
    friend counting operator-(int n, counting a) { return counting(n - a.value); }
    friend auto operator<=>(counting a, counting b) { return a.value <=> b.value; }
    friend bool operator==(counting a, counting b) { return a.value == b.value; }
    friend auto operator<=>(counting a, int n) { return a.value <=> n; }
    friend bool operator==(counting a, int n) { return a.value == n; }

    friend counting sqrt(counting x) { return counting(std::sqrt(x.value)); }
    friend counting exp(counting x) { return counting(std::exp(x.value)); }
    friend counting log(counting x) { return counting(std::log(x.value)); }
    friend counting sin(counting x) { return counting(std::sin(x.value)); }
    friend counting cosh(counting x) { return counting(std::cosh(x.value)); }
    friend counting tan(counting x) { return counting(std::tan(x.value)); }
    friend counting sinh(counting x) { return counting(std::sinh(x.value)); }
    friend counting tanh(counting x) { return counting(std::tanh(x.value)); }
    friend counting atan(counting x) { return counting(std::atan(x.value)); }
    friend counting ldexp(counting x, int e) { return counting(std::ldexp(x.value, e)); }
    friend counting abs(counting x) { return counting(std::abs(x.value)); }
    friend counting atan2(counting y, counting x) { return counting(std::atan2(y.value, x.value)); }
    friend counting cos(counting x) { return counting(std::cos(x.value)); }
};

template <>
struct libration::scalar_traits<counting> : libration::default_scalar_traits<counting> {
    using of_double = scalar_traits<double>;
    using wide = mpfr;
    static constexpr bool fixed = true;
    static int digits() { return of_double::digits(); }
    static counting epsilon() { return counting(of_double::epsilon()); }
    static counting pi() { return counting(of_double::pi()); }
    static counting from_rational(const rational& q) { return counting(of_double::from_rational(q)); }
    static long binary_exponent(const counting& x) { return of_double::binary_exponent(x.value); }
    static bool holds_exponent(long e) { return of_double::holds_exponent(e); }
    static mpfr widen(const counting& x) { return of_double::widen(x.value); }
    static counting narrow(const mpfr& x) { return counting(of_double::narrow(x)); }
};

static_assert(libration::scalar<counting>);
