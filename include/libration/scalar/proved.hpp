// The proved scalar `ball` by name alone: what scalar/ball.hpp defines is declared here, where templates and the
// concept see it, so that no other header needs FLINT and the order of includes does not matter.
#pragma once

#include <concepts>
#include <string>
#include <vector>

#include "libration/scalar/error.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration {

class ball;
struct exact;

/// A scalar whose results contain the truth: only the ball.
template <class T>
concept proved_scalar = std::same_as<T, ball>;

/// A decision (a sign, a branch, a digit) that the enclosures at hand do not prove: repeat with more digits.
class precision_exhausted : public error {
public:
    explicit precision_exhausted(const std::string& what)
        : error(error_kind::undecided, what, "", "is not decided by this many digits") {}
};

/// What the functions of the same names are for rounding scalars; on balls every result contains the exact one.
template <proved_scalar T>
int digits();
template <proved_scalar T>
T epsilon();
template <proved_scalar T>
T pi();
template <proved_scalar T>
T enclose(const T& value, const T& bound);
template <proved_scalar T>
long binary_exponent(const T& x);
template <proved_scalar T>
T widen(const T& x);
template <proved_scalar T>
T narrow(const T& x);
template <proved_scalar T>
T midpoint(const T& x);
/// sum_i x[i x_step] y[i y_step], i < count, with one rounding at the end: what a convolution is made of.
template <proved_scalar T>
T sum_of_products(const T* x, int x_step, const T* y, int y_step, int count);
/// The product and the quotient of two whole sequences, as series of the shorter length.
template <proved_scalar T>
std::vector<T> whole_product(const std::vector<T>& a, const std::vector<T>& b);
template <proved_scalar T>
std::vector<T> whole_quotient(const std::vector<T>& a, const std::vector<T>& b);
template <proved_scalar T>
bool certainly_less(const T& a, const T& b);
template <proved_scalar T>
T from_rational(const rational& q);
template <proved_scalar T>
T from_exact(const exact& number);

}  // namespace libration
