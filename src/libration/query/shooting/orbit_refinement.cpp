#include "orbit_refinement.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "libration/digits/precision_loop.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

constexpr int most_refinements = 40;
constexpr long guard_bits = 40;
constexpr long least_gain = 4;

ball exact_ball(const mpfr& x) {
    ball result;
    arf_set_mpfr(arb_midref(result.handle()), x.backend().data());
    return result;
}

}  // namespace

void refine(orbit_guess& guess, const rounded_flow& flow, const first_order_form& form,
            const std::optional<number>& held_period, const Eigen::MatrixXd& derivative, long bits) {
    const auto& chosen = guess.conditions;
    const bool half = !chosen.reversal.empty();
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(derivative);
    const precision_scope scope(decimal_digits(bits + guard_bits));
    std::vector<mpfr> start;
    for (const number& each : form.starts) {
        start.push_back(constant_value<mpfr>::of(each));
    }
    for (std::size_t k = 0; k < chosen.free.size(); ++k) {
        start[chosen.free[k]] = midpoint_of(guess.unknowns[k]);
    }
    mpfr period = chosen.is_period_free ? midpoint_of(guess.unknowns.back())
                  : held_period         ? constant_value<mpfr>::of(*held_period)
                                        : mpfr(guess.period);
    Eigen::VectorXd scaled(static_cast<Eigen::Index>(chosen.rows.size()));
    long exponent = 0;
    for (int k = 0; k < most_refinements && exponent > -bits; ++k) {
        const auto end = flow.at(start, half ? mpfr(period / 2) : period);
        if (!end) {
            return;
        }
        std::vector<mpfr> rest;
        mpfr largest = 0;
        for (const std::size_t row : chosen.rows) {
            rest.push_back(half ? (*end)[row] : mpfr((*end)[row] - start[row]));
            largest = std::max(largest, mpfr(abs(rest.back())));
        }
        if (largest == 0) {
            exponent = -bits;
            break;
        }
        for (std::size_t r = 0; r < rest.size(); ++r) {
            scaled(static_cast<Eigen::Index>(r)) = mpfr(rest[r] / largest).convert_to<double>();
        }
        const Eigen::VectorXd step = solver.solve(scaled);
        for (std::size_t c = 0; c < chosen.free.size(); ++c) {
            start[chosen.free[c]] -= largest * step(static_cast<Eigen::Index>(c));
        }
        if (chosen.is_period_free) {
            period -= largest * step(step.size() - 1);
        }
        const long before = exponent;
        exponent = scalar_traits<mpfr>::binary_exponent(largest) + static_cast<long>(std::log2(step.norm() + 1e-300));
        if (k > 0 && exponent > before - least_gain) {
            return;
        }
    }
    if (exponent > -bits) {
        return;
    }
    guess.settled_bits = bits;
    guess.unknowns.clear();
    for (const std::size_t i : chosen.free) {
        guess.unknowns.push_back(exact_ball(start[i]));
    }
    if (chosen.is_period_free) {
        guess.unknowns.push_back(exact_ball(period));
    }
}

}  // namespace libration::ode
