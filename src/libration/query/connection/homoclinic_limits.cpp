#include "homoclinic_limits.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <optional>

#include "libration/equation/constant_value.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr int most_steps_to_rest = 100;
constexpr double at_rest_within = 1e-12;
constexpr double fraction_within = 1e-9;
constexpr long largest_denominator = 1000;

// A fraction with a small denominator near a number.
std::optional<std::string> small_fraction(double x) {
    for (long q = 1; q <= largest_denominator; ++q) {
        const double p = std::round(x * static_cast<double>(q));
        if (std::fabs(p) < 1e15 && std::fabs(p / static_cast<double>(q) - x) <= fraction_within * (1 + std::fabs(x))) {
            const std::string numerator = std::to_string(static_cast<long>(p));
            return q == 1 ? numerator : numerator + "/" + std::to_string(q);
        }
    }
    return std::nullopt;
}

// By Newton's method with the least steps, as the derivative may be singular.
std::optional<Eigen::VectorXd> rest_near(const first_order_form& form, Eigen::VectorXd x) {
    const Eigen::Index size = x.size();
    for (int k = 0; k < most_steps_to_rest; ++k) {
        expression_values<double> values(form.leaves, 0);
        for (const double each : x) {
            values.push_back(each);
        }
        Eigen::VectorXd f(size);
        Eigen::MatrixXd by(size, size);
        for (Eigen::Index i = 0; i < size; ++i) {
            const expression& slope = form.slopes[static_cast<std::size_t>(i)];
            f(i) = values.of(slope);
            for (Eigen::Index j = 0; j < size; ++j) {
                by(i, j) = values.of(partial(slope, form.leaves[static_cast<std::size_t>(j)]));
            }
        }
        if (!f.allFinite() || !by.allFinite()) {
            return std::nullopt;
        }
        const Eigen::VectorXd step = by.completeOrthogonalDecomposition().solve(f);
        x -= step;
        if (step.norm() <= at_rest_within * (1 + x.norm())) {
            return f.norm() <= fraction_within * (1 + by.norm() * x.norm()) ? std::optional(x) : std::nullopt;
        }
    }
    return std::nullopt;
}

}  // namespace

std::vector<std::string> homoclinic_limits(const explicit_system& system) {
    const first_order_form form(system);
    Eigen::VectorXd start(static_cast<Eigen::Index>(form.leaves.size()));
    Eigen::Index next = 0;
    for (const auto& each : system.starts()) {
        for (const number& value : each) {
            start(next++) = constant_value<double>::of(value);
        }
    }
    const auto rest = rest_near(form, start);
    if (!rest) {
        throw error(error_kind::undecided, error_subject::problem, "",
                    "has no equilibrium that Newton's method finds from its initial values: begin nearer to one");
    }
    std::vector<std::string> result;
    for (std::size_t k = 0; k < form.names.size(); ++k) {
        const double at = (*rest)(static_cast<Eigen::Index>(k));
        const auto value = small_fraction(at);
        if (!value) {
            throw error(error_kind::argument, error_subject::problem, "",
                        "has an equilibrium near its initial values with " + form.names[k] + " = " +
                            to_decimal(mpfr(at), 6) + ", which is not seen to be a fraction: write the limits, " +
                            form.names[k] + "(-inf) = VALUE; " + form.names[k] + "(inf) = VALUE");
        }
        for (const char* const end : {"(-inf) = ", "(inf) = "}) {
            result.push_back(form.names[k] + end + *value);
        }
    }
    return result;
}

}  // namespace libration::ode
