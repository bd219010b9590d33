// A scalar that counts the operations done with it: what an algorithm costs whatever the arithmetic.
//
// Include it before every other header of the library: a concept sees the functions digits<T>(), pi<T>() and so on of a
// type only where they are declared before the concept.
#pragma once

#include <cmath>
#include <concepts>
#include <utility>

#include "libration/scalar/constants.hpp"
#include "libration/scalar/convert.hpp"
#include "libration/scalar/enclose.hpp"
#include "libration/scalar/precision.hpp"

namespace libration {

/// Operations between two numbers; those with a machine integer, which cost less in high precision, are apart.
struct operation_count {
    long multiplications = 0;
    long by_zero = 0;  ///< of the multiplications, those with a factor 0
    long divisions = 0;
    long additions = 0;    ///< and subtractions
    long by_integers = 0;  ///< all four with an int
};

/// A double that counts. The count belongs to the thread.
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

/// The type counted, for the functions of its arithmetic: those of double.
template <class T>
concept counting_scalar = std::same_as<T, counted>;

template <counting_scalar T>
int digits() {
    return digits<double>();
}
template <counting_scalar T>
T epsilon() {
    return T(epsilon<double>());
}
template <counting_scalar T>
T pi() {
    return T(pi<double>());
}
template <counting_scalar T>
T enclose(const T& value, const T& /*bound*/) {
    return value;
}
template <counting_scalar T>
long binary_exponent(const T& x) {
    return binary_exponent(x.value());
}
template <>
struct wide_scalar<counted> {
    using type = mpfr;
};
template <counting_scalar T>
mpfr widen(const T& x) {
    return widen(x.value());
}
template <counting_scalar T>
T narrow(const mpfr& x) {
    return T(narrow<double>(x));
}
template <counting_scalar T>
T from_rational(const rational& q) {
    return T(from_rational<double>(q));
}

}  // namespace libration

#include "libration/scalar/concept.hpp"

static_assert(libration::scalar<libration::counted>, "include counted.hpp before the other headers of the library");
