#include <algorithm>
#include <cmath>
#include <limits>

#include "libration/plane/frobenius_series.hpp"
#include "libration/scalar/ball/complex_values.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/convert.hpp"
#include "libration/scalar/error.hpp"

#if __has_include(<flint/acb_poly.h>)
#include <flint/acb_poly.h>
#else
#include <acb_poly.h>
#endif

namespace libration::ode {

namespace {

std::vector<complex_ball> simple_roots_of(const std::vector<complex_ball>& coefficients) {
    acb_poly_t p;
    acb_poly_init(p);
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
        acb_poly_set_coeff_acb(p, static_cast<slong>(k), flint_complex(coefficients[k]).handle());
    }
    const auto degree = static_cast<slong>(coefficients.size()) - 1;
    acb_ptr roots = _acb_vec_init(degree);
    const slong isolated = acb_poly_find_roots(roots, p, nullptr, 0, ball::working_bits());
    std::vector<complex_ball> result;
    for (slong k = 0; k < isolated; ++k) {
        flint_complex root;
        acb_set(root.handle(), roots + k);
        result.push_back(root.number());
    }
    _acb_vec_clear(roots, degree);
    acb_poly_clear(p);
    if (isolated < degree) {
        throw precision_exhausted("exponents of a singular point");
    }
    return result;
}

void require_no_integer_between(const std::vector<complex_ball>& exponents) {
    for (std::size_t i = 0; i < exponents.size(); ++i) {
        for (std::size_t k = i + 1; k < exponents.size(); ++k) {
            const complex_ball apart = exponents[i] - exponents[k];
            if (contains_zero(apart.im) && arb_contains_int(apart.re.handle()) != 0) {
                throw precision_exhausted("exponents of a singular point that may differ by an integer");
            }
        }
    }
}

}  // namespace

ball modulus_in_balls(const complex_ball& z) {
    ball result;
    acb_abs(result.handle(), flint_complex(z).handle(), ball::working_bits());
    return result;
}

double local_operator::nearest() const {
    double least = std::numeric_limits<double>::infinity();
    for (const complex_ball& each : zeros) {
        least = std::min(least, arf_get_d(arb_midref(lower_bound(modulus_in_balls(each)).handle()), ARF_RND_DOWN));
    }
    return least;
}

double local_operator::bits_lost(double reach) const {
    std::vector<double> sizes;
    for (const complex_ball& each : c.back()) {
        sizes.push_back(std::abs(rounded_midpoint(each / c.back()[0])));
    }
    const auto sum_at = [&](double x) {
        double sum = 0;
        for (std::size_t l = sizes.size() - 1; l > 0; --l) {
            sum = (sum + sizes[l]) * x;
        }
        return sum;
    };
    double x = reach;
    while (sum_at(x) > 1) {
        x *= 0.9;
    }
    return std::log2(reach / x);
}

local_operator operator_about(const linear_equation& of, const complex_ball& centre,
                              const std::vector<complex_ball>& roots) {
    const std::size_t order = of.order();
    local_operator result;
    result.place = centre;
    std::size_t longest = 1;
    for (std::size_t i = 0; i <= order; ++i) {
        std::vector<complex_ball> row(order - i, complex_ball(0));
        for (int j = 0; j <= of.coefficients()[i].degree(); ++j) {
            row.push_back(value_at(of.coefficients()[i].taylor_coefficient(j), centre));
        }
        longest = std::max(longest, row.size());
        result.c.push_back(std::move(row));
        if (i < order) {
            result.exponents.emplace_back(static_cast<int>(i));
        }
    }
    for (auto& each : result.c) {
        each.resize(longest, complex_ball(0));
    }
    for (const complex_ball& each : roots) {
        result.zeros.push_back(each - centre);
    }
    return result;
}

local_operator operator_at(const fuchsian_point& of, const complex_ball& place,
                           const std::vector<complex_ball>& others) {
    local_operator result;
    result.place = place;
    for (const auto& row : of.coefficients()) {
        result.c.emplace_back();
        for (const rational_polynomial& each : row) {
            result.c.back().push_back(value_at(each, place));
        }
    }
    for (const exponent_class& each : of.classes()) {
        for (const auto& [offset, multiplicity] : each.offsets) {
            for (int k = 0; k < multiplicity; ++k) {
                result.exponents.emplace_back(from_rational<ball>(each.exponent + offset));
            }
        }
    }
    if (!of.other_exponents().empty()) {
        std::vector<complex_ball> coefficients;
        for (const rational_polynomial& each : of.other_exponents()) {
            coefficients.push_back(value_at(each, place));
        }
        const std::vector<complex_ball> found = simple_roots_of(coefficients);
        require_no_integer_between(found);
        result.exponents.insert(result.exponents.end(), found.begin(), found.end());
    }
    for (const complex_ball& each : others) {
        result.zeros.push_back(of.is_start() ? each : complex_ball(1) - each / place);
    }
    return result;
}

}  // namespace libration::ode
