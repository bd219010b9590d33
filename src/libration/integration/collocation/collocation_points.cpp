#include "collocation_points.hpp"

#include <flint/fmpq.h>

namespace libration::ode {

namespace {

// cos(2 pi k/count), k < count.
std::vector<ball> cosines(int count) {
    std::vector<ball> result(static_cast<std::size_t>(count));
    fmpq_t part;
    fmpq_init(part);
    for (int k = 0; k < count; ++k) {
        fmpq_set_si(part, 2L * k, static_cast<ulong>(count));
        arb_cos_pi_fmpq(result[static_cast<std::size_t>(k)].handle(), part, ball::working_bits());
    }
    fmpq_clear(part);
    return result;
}

// T_l in powers of x, column l.
dense_matrix chebyshev_powers(std::size_t count) {
    dense_matrix result(count, count);
    for (std::size_t l = 0; l < count; ++l) {
        if (l < 2) {
            result(l, l) = ball(1);
            continue;
        }
        for (std::size_t k = 0; k <= l; ++k) {
            result(k, l) = (k > 0 ? result(k - 1, l - 1) * 2 : ball(0)) - result(k, l - 2);
        }
    }
    return result;
}

// Coefficients of the integral from -1 of sum_k c_k T_k, by those of it.
dense_matrix integrated(const dense_matrix& coefficients) {
    const std::size_t count = coefficients.rows;
    dense_matrix result(count + 1, coefficients.columns);
    const auto term = [&](std::size_t k, std::size_t j) { return k < count ? coefficients(k, j) : ball(0); };
    for (std::size_t j = 0; j < coefficients.columns; ++j) {
        ball at_left(0);
        for (std::size_t l = 1; l <= count; ++l) {
            const ball before = l == 1 ? coefficients(0, j) * 2 : term(l - 1, j);
            result(l, j) = (before - term(l + 1, j)) / static_cast<long>(2 * l);
            at_left += l % 2 == 0 ? result(l, j) : -result(l, j);
        }
        result(0, j) = -at_left;
    }
    return result;
}

}  // namespace

collocation_points::collocation_points(int degree, long bits) : degree_(degree) {
    const precision_scope scope(decimal_digits(bits));
    const auto size = static_cast<std::size_t>(degree) + 1;
    const int round = 2 * degree + 1;
    const std::vector<ball> turned = cosines(round);
    const auto cosine = [&](std::size_t k, std::size_t node) -> const ball& {
        return turned[k * (size - 1 - node) % static_cast<std::size_t>(round)];
    };
    coefficients_ = dense_matrix(size, size);
    dense_matrix values(size, size + 1);
    for (std::size_t i = 0; i < size; ++i) {
        places_.push_back(cosine(1, i));
        for (std::size_t k = 0; k <= size; ++k) {
            values(i, k) = cosine(k, i);
        }
        for (std::size_t k = 0; k < size; ++k) {
            const long weight = (i + 1 == size ? 1 : 2) * (k == 0 ? 1 : 2);
            coefficients_(k, i) = cosine(k, i) * weight / round;
        }
    }
    integral_coefficients_ = integrated(coefficients_);
    coefficients_.keep_midpoints();
    integral_coefficients_.keep_midpoints();
    values.keep_midpoints();
    integrals_ = product(values, integral_coefficients_);
    integrals_.keep_midpoints();
    powers_ = chebyshev_powers(size + 1);
    for (ball& each : places_) {
        mag_zero(arb_radref(each.handle()));
    }
    for (const ball& each : integrals_.entries) {
        rounded_.push_back(as_double(each));
    }
}

std::vector<ball> collocation_points::powers(const std::vector<ball>& chebyshev) const {
    std::vector<ball> result;
    for (std::size_t k = 0; k < chebyshev.size(); ++k) {
        result.push_back(inner_product(&powers_.entries[k * powers_.columns], 1, chebyshev.data(), 1,
                                       static_cast<int>(chebyshev.size())));
    }
    return result;
}

}  // namespace libration::ode
