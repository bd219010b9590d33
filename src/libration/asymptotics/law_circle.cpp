#include "law_circle.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

// The least logarithmic gap around a circle that is wide enough, and how far inside a given circle the search goes beyond.
constexpr double wide_gap = 0.15;
constexpr double beyond_circle = 1.02;
constexpr double rounding_of_axis = 1e-11;

double modulus_in_double(const found_singularity& of) { return static_cast<double>(modulus_of(of.offset)); }

// |y| at a distance R from y ~ c (t - t*)^e for y or its derivative of order k.
double size_at(const found_singularity& of, std::size_t shown, double distance) {
    std::complex<double> exponent = of.exponent;
    std::complex<double> c = of.coefficient;
    for (std::size_t k = shown; k < of.unknown; ++k) {
        exponent += 1.0;
        c /= exponent;
    }
    const double size = std::abs(c) * std::pow(distance, exponent.real());
    return std::isfinite(size) && size > 0 ? size : 0;
}

}  // namespace

double few_bits_between(double a, double b) {
    const double middle = std::sqrt(a * b);
    for (int bits = 7;; ++bits) {
        const double unit = std::exp2(std::floor(std::log2(middle)) - bits);
        const double rounded = std::round(middle / unit) * unit;
        if (std::abs(rounded - middle) < (b - a) / 16 || bits > 40) {
            return rounded;
        }
    }
}

law_circle circle_for(const explicit_system& system, std::size_t shown, const std::optional<double>& within,
                      const plane_watch& watch) {
    singularity_request request;
    request.watch = watch;
    if (within) {
        request.within = *within * beyond_circle;
    }
    const singularity_map map = singularities_of(system, request);
    if (map.ended) {
        throw error(*map.ended);
    }
    law_circle result;
    std::vector<double> moduli;
    for (const found_singularity& each : map.all) {
        moduli.push_back(modulus_in_double(each));
    }
    std::ranges::sort(moduli);
    if (!moduli.empty()) {
        result.nearest = moduli.front();
        result.size = size_at(map.all.front(), shown, result.nearest);
    }
    if (within) {
        result.rho = *within;
    } else if (moduli.empty()) {
        throw error(error_kind::undecided, error_subject::problem, "",
                    "has no singularity within " + std::to_string(map.within) +
                        " of its initial point that the search finds; --within RHO proves a bound C RHO^-n of its "
                        "coefficients");
    } else {
        // The farthest wide gap, else the widest; a number of few bits.
        moduli.push_back(map.within);
        double widest = 0;
        for (std::size_t i = 0; i + 1 < moduli.size(); ++i) {
            const double gap = std::log(moduli[i + 1] / moduli[i]);
            if (gap >= std::min(wide_gap, widest) && gap > 1e-9) {
                widest = std::max(widest, gap);
                result.rho = few_bits_between(moduli[i], moduli[i + 1]);
            }
        }
    }
    for (const found_singularity& each : map.all) {
        found_singularity at = each;
        if (abs(at.offset.im) < modulus_of(at.offset) * mpfr(rounding_of_axis)) {
            at.offset.im = 0;  // of a real system: else its mirror image would be as close
        }
        if (modulus_in_double(at) < result.rho && at.offset.im >= 0) {
            result.inside.push_back(std::move(at));
        }
    }
    return result;
}

}  // namespace libration::ode
