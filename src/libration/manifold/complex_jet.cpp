#include "complex_jet.hpp"

#include <algorithm>
#include <utility>

#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

bool is_real(const complex_ball& z) { return arb_is_zero(z.im.handle()) != 0; }

void add_complex_product(complex_ball& sum, const complex_ball& a, const complex_ball& b) {
    const slong bits = ball::working_bits();
    arb_addmul(sum.re.handle(), a.re.handle(), b.re.handle(), bits);
    if (!is_real(a)) {
        arb_addmul(sum.im.handle(), a.im.handle(), b.re.handle(), bits);
        arb_submul(sum.re.handle(), a.im.handle(), b.im.handle(), bits);
    }
    if (!is_real(b)) {
        arb_addmul(sum.im.handle(), a.re.handle(), b.im.handle(), bits);
    }
}

complex_ball inverse_of(const complex_ball& z) {
    if (is_real(z)) {
        return {ball(1) / z.re, ball(0)};
    }
    return complex_ball(ball(1), ball(0)) / z;
}

}  // namespace

complex_jet complex_jet::operator-() const {
    complex_jet result(-value);
    for (const complex_ball& each : slopes) {
        result.slopes.push_back(-each);
    }
    return result;
}

complex_jet& complex_jet::operator+=(const complex_jet& b) {
    value += b.value;
    if (slopes.size() < b.slopes.size()) {
        slopes.resize(b.slopes.size(), complex_ball(ball(0), ball(0)));
    }
    for (std::size_t k = 0; k < b.slopes.size(); ++k) {
        slopes[k] += b.slopes[k];
    }
    return *this;
}

complex_jet& complex_jet::operator-=(const complex_jet& b) { return *this += -b; }

void complex_jet::add_product(const complex_jet& a, const complex_jet& b) {
    if (a.is_zero() || b.is_zero()) {
        return;
    }
    add_complex_product(value, a.value, b.value);
    const std::size_t count = std::max(a.slopes.size(), b.slopes.size());
    if (slopes.size() < count) {
        slopes.resize(count, complex_ball(ball(0), ball(0)));
    }
    for (std::size_t k = 0; k < a.slopes.size(); ++k) {
        add_complex_product(slopes[k], a.slopes[k], b.value);
    }
    for (std::size_t k = 0; k < b.slopes.size(); ++k) {
        add_complex_product(slopes[k], a.value, b.slopes[k]);
    }
}

complex_jet reciprocal(const complex_jet& a) {
    complex_jet result(inverse_of(a.value));
    const complex_ball by = -(result.value * result.value);
    for (const complex_ball& each : a.slopes) {
        result.slopes.emplace_back(each * by);
    }
    return result;
}

complex_jet conjugate(const complex_jet& a) {
    complex_jet result(conjugate(a.value));
    for (const complex_ball& each : a.slopes) {
        result.slopes.push_back(conjugate(each));
    }
    return result;
}

jet_matrix unit_jets(std::size_t size) {
    jet_matrix result(size, std::vector<complex_jet>(size));
    for (std::size_t i = 0; i < size; ++i) {
        result[i][i] = complex_ball(ball(1), ball(0));
    }
    return result;
}

std::vector<complex_jet> product(const jet_matrix& a, const std::vector<complex_jet>& x) {
    std::vector<complex_jet> result(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < x.size(); ++j) {
            result[i].add_product(a[i][j], x[j]);
        }
    }
    return result;
}

jet_matrix product(const jet_matrix& a, const jet_matrix& b) {
    jet_matrix result(a.size(), std::vector<complex_jet>(b.empty() ? 0 : b.front().size()));
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t k = 0; k < b.size(); ++k) {
            for (std::size_t j = 0; j < b[k].size(); ++j) {
                result[i][j].add_product(a[i][k], b[k][j]);
            }
        }
    }
    return result;
}

std::optional<jet_matrix> inverse(const jet_matrix& a) {
    const std::size_t size = a.size();
    jet_matrix left = a;
    jet_matrix right = unit_jets(size);
    const auto below = [](const complex_jet& x) {
        return std::max(magnitude::below(x.value.re), magnitude::below(x.value.im));
    };
    for (std::size_t k = 0; k < size; ++k) {
        std::size_t best = k;
        for (std::size_t i = k + 1; i < size; ++i) {
            best = below(left[best][k]) < below(left[i][k]) ? i : best;
        }
        if (below(left[best][k]).is_zero()) {
            return std::nullopt;
        }
        std::swap(left[k], left[best]);
        std::swap(right[k], right[best]);
        const complex_jet by = reciprocal(left[k][k]);
        for (std::size_t j = 0; j < size; ++j) {
            left[k][j] = left[k][j] * by;
            right[k][j] = right[k][j] * by;
        }
        for (std::size_t i = 0; i < size; ++i) {
            if (i == k || left[i][k].is_zero()) {
                continue;
            }
            const complex_jet factor = -left[i][k];
            for (std::size_t j = 0; j < size; ++j) {
                left[i][j].add_product(factor, left[k][j]);
                right[i][j].add_product(factor, right[k][j]);
            }
        }
    }
    return right;
}

}  // namespace libration::ode
