#include "rational_function.hpp"

#include <algorithm>
#include <utility>

#include "libration/scalar/error.hpp"
#include "libration/scalar/scalar.hpp"

namespace libration::ode {

namespace {

rational_polynomial without_leading_zeros(rational_polynomial p) {
    while (!p.empty() && p.back() == 0) {
        p.pop_back();
    }
    return p;
}

// Quotient and remainder, by a nonzero polynomial.
std::pair<rational_polynomial, rational_polynomial> divided(rational_polynomial a, const rational_polynomial& by) {
    rational_polynomial quotient(a.size() < by.size() ? 0 : a.size() - by.size() + 1);
    for (std::size_t k = quotient.size(); k-- > 0;) {
        quotient[k] = a[k + by.size() - 1] / by.back();
        for (std::size_t i = 0; i < by.size(); ++i) {
            a[k + i] -= quotient[k] * by[i];
        }
    }
    return {std::move(quotient), without_leading_zeros(std::move(a))};
}

rational_polynomial common_factor(rational_polynomial a, rational_polynomial b) {
    while (!b.empty()) {
        a = divided(std::move(a), b).second;
        std::swap(a, b);
    }
    return a;
}

rational_polynomial with_signs_changed(rational_polynomial p) {
    for (std::size_t i = 1; i < p.size(); i += 2) {
        p[i] = -p[i];
    }
    return p;
}

}  // namespace

rational_polynomial sum(rational_polynomial a, const rational_polynomial& b) {
    a.resize(std::max(a.size(), b.size()));
    for (std::size_t i = 0; i < b.size(); ++i) {
        a[i] += b[i];
    }
    return without_leading_zeros(std::move(a));
}

rational_polynomial product(const rational_polynomial& a, const rational_polynomial& b) {
    rational_polynomial result(a.empty() || b.empty() ? 0 : a.size() + b.size() - 1);
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t k = 0; k < b.size(); ++k) {
            result[i + k] += a[i] * b[k];
        }
    }
    return result;
}

rational_function::rational_function(rational_polynomial above, rational_polynomial below)
    : above_(without_leading_zeros(std::move(above))), below_(without_leading_zeros(std::move(below))) {
    if (below_.empty()) {
        throw error(error_kind::argument, error_subject::problem, "", "divides by 0 in the potential");
    }
    const auto common = common_factor(below_, above_);
    above_ = divided(std::move(above_), common).first;
    below_ = divided(std::move(below_), common).first;
    const rational last = below_.back();
    for (auto* const each : {&above_, &below_}) {
        for (rational& coefficient : *each) {
            coefficient /= last;
        }
    }
}

rational_function operator+(const rational_function& a, const rational_function& b) {
    return {sum(product(a.above_, b.below_), product(b.above_, a.below_)), product(a.below_, b.below_)};
}

rational_function operator*(const rational_function& a, const rational_function& b) {
    return {product(a.above_, b.above_), product(a.below_, b.below_)};
}

rational_function operator/(const rational_function& a, const rational_function& b) {
    return {product(a.above_, b.below_), product(a.below_, b.above_)};
}

rational_function rational_function::of_negative() const {
    return {with_signs_changed(above_), with_signs_changed(below_)};
}

rational_function rational_function::of_inverse() const {
    const std::size_t size = std::max(above_.size(), below_.size());
    const auto reversed = [&](rational_polynomial p) {
        p.resize(size);
        std::ranges::reverse(p);
        return p;
    };
    return {reversed(above_), reversed(below_)};
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
    for (const rational& each : p) {
        result.push_back(from_rational<ball>(each));
    }
    return result;
}

}  // namespace libration::ode
