#include "rational_function.hpp"

#include <algorithm>
#include <utility>

#include "libration/scalar/error.hpp"
#include "libration/scalar/scalar.hpp"

namespace libration::ode {

namespace {

rational_polynomial with_signs_changed(const rational_polynomial& p) {
    std::vector<rational> c = p.coefficients();
    for (std::size_t i = 1; i < c.size(); i += 2) {
        c[i] = -c[i];
    }
    return c;
}

}  // namespace

rational_function::rational_function(rational_polynomial above, rational_polynomial below) {
    if (below.is_zero()) {
        throw error(error_kind::argument, error_subject::problem, "", "divides by 0 in the potential");
    }
    const auto common = common_divisor(below, above);
    const rational unit = rational(1) / below.coefficients().back();
    above_ = divided(above, common).quotient * unit;
    below_ = divided(below, common).quotient * unit;
}

rational_function operator+(const rational_function& a, const rational_function& b) {
    return {a.above_ * b.below_ + b.above_ * a.below_, a.below_ * b.below_};
}

rational_function operator*(const rational_function& a, const rational_function& b) {
    return {a.above_ * b.above_, a.below_ * b.below_};
}

rational_function operator/(const rational_function& a, const rational_function& b) {
    return {a.above_ * b.below_, a.below_ * b.above_};
}

rational_function rational_function::of_negative() const {
    return {with_signs_changed(above_), with_signs_changed(below_)};
}

rational_function rational_function::of_inverse() const {
    const auto size = static_cast<std::size_t>(std::max(above_.degree(), below_.degree()) + 1);
    const auto reversed = [&](const rational_polynomial& p) -> rational_polynomial {
        std::vector<rational> c = p.coefficients();
        c.resize(size);
        std::ranges::reverse(c);
        return c;
    };
    return {reversed(above_), reversed(below_)};
}

rational_function rational_function::of_sum(const rational& c) const {
    const auto shifted = [&](const rational_polynomial& p) {
        rational_polynomial result;
        for (int i = p.degree(); i >= 0; --i) {
            result = result * rational_polynomial(std::vector<rational>{c, 1}) + rational_polynomial(p[i]);
        }
        return result;
    };
    return {shifted(above_), shifted(below_)};
}

rational_function rational_function::derivative() const {
    return {above_.derivative() * below_ - above_ * below_.derivative(), below_ * below_};
}

rational_function power(const rational_function& of, long n) {
    if (n < 0) {
        return rational_function(1) / power(of, -n);
    }
    rational_function result(1);
    for (long k = 0; k < n; ++k) {
        result = result * of;
    }
    return result;
}

std::vector<ball> balls_of(const rational_polynomial& p) {
    std::vector<ball> result;
    for (const rational& each : p.coefficients()) {
        result.push_back(from_rational<ball>(each));
    }
    return result;
}

}  // namespace libration::ode
