// A scalar that counts the operations performed on it: the cost of an algorithm in any arithmetic.
#pragma once

#include <cmath>
#include <utility>

#include "libration/scalar/scalar.hpp"

namespace libration {

/// Operations between two numbers; those with a machine integer, which cost less in high precision, are counted
/// separately.
struct operation_count {
    long multiplications = 0;
    long by_zero = 0;  ///< multiplications with a factor 0
    long divisions = 0;
    long additions = 0;    ///< and subtractions
    long by_integers = 0;  ///< all four with an int
};

/// A double that counts its operations. The count is per thread.
class counted {
public:
    counted() = default;
    explicit counted(double value) : value_(value) {}
    explicit counted(int value) : value_(value) {}

    double value() const { return value_; }
    static operation_count& so_far() {
        thread_local operation_count count;
        return count;
    }

    counted operator-() const { return counted(-value_); }
    friend counted operator+(const counted& a, const counted& b) {
        ++so_far().additions;
        return counted(a.value_ + b.value_);
    }
    friend counted operator-(const counted& a, const counted& b) {
        ++so_far().additions;
        return counted(a.value_ - b.value_);
    }
    friend counted operator*(const counted& a, const counted& b) {
        ++so_far().multiplications;
        so_far().by_zero += a.value_ == 0 || b.value_ == 0 ? 1 : 0;
        return counted(a.value_ * b.value_);
    }
    friend counted operator/(const counted& a, const counted& b) {
        ++so_far().divisions;
        return counted(a.value_ / b.value_);
    }
    friend counted operator+(const counted& a, int b) { return by_integer(a.value_ + b); }
    friend counted operator-(const counted& a, int b) { return by_integer(a.value_ - b); }
    friend counted operator-(int a, const counted& b) { return by_integer(a - b.value_); }
    friend counted operator*(const counted& a, int b) { return by_integer(a.value_ * b); }
    friend counted operator/(const counted& a, int b) { return by_integer(a.value_ / b); }
    counted& operator+=(const counted& b) { return *this = *this + b; }
    counted& operator-=(const counted& b) { return *this = *this - b; }
    counted& operator*=(const counted& b) { return *this = *this * b; }
    counted& operator/=(const counted& b) { return *this = *this / b; }

    friend counted sqrt(const counted& x) { return counted(std::sqrt(x.value_)); }
    friend counted exp(const counted& x) { return counted(std::exp(x.value_)); }
    friend counted log(const counted& x) { return counted(std::log(x.value_)); }
    friend counted sin(const counted& x) { return counted(std::sin(x.value_)); }
    friend counted cos(const counted& x) { return counted(std::cos(x.value_)); }

private:
    static counted by_integer(double result) {
        ++so_far().by_integers;
        return counted(result);
    }

    double value_ = 0;
};

/// The operations on counted numbers in work().
template <class Work>
operation_count count_operations(const Work& work) {
    const operation_count before = std::exchange(counted::so_far(), {});
    work();
    return std::exchange(counted::so_far(), before);
}

/// The arithmetic is that of double.
template <>
struct scalar_traits<counted> : default_scalar_traits<counted> {
    static constexpr bool fixed = true;
    using wide = mpfr;

    static constexpr int digits() { return scalar_traits<double>::digits(); }
    static counted epsilon() { return counted(scalar_traits<double>::epsilon()); }
    static counted pi() { return counted(scalar_traits<double>::pi()); }
    static counted from_rational(const rational& q) { return counted(scalar_traits<double>::from_rational(q)); }
    static long binary_exponent(const counted& x) { return scalar_traits<double>::binary_exponent(x.value()); }
    static bool holds_exponent(long exponent) { return scalar_traits<double>::holds_exponent(exponent); }
    static bool certainly_less(const counted& a, const counted& b) { return a.value() < b.value(); }
    static mpfr widen(const counted& x) { return scalar_traits<double>::widen(x.value()); }
    static counted narrow(const mpfr& x) { return counted(scalar_traits<double>::narrow(x)); }
};

static_assert(scalar<counted>);

}  // namespace libration
