#include "libration/convergence/list.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "libration/scalar/convert.hpp"
#include "libration/scalar/mpfr_traits.hpp"

namespace libration::convergence {

namespace {

struct measured_size {
    double k, log;
};

std::vector<measured_size> sizes_from(std::span<const mpfr> b, std::size_t first) {
    std::vector<measured_size> found;
    for (std::size_t k = first; k < b.size(); ++k) {
        if (b[k] != 0) {
            found.push_back({static_cast<double>(k), log_size(b[k])});
        }
    }
    return found;
}

}  // namespace

coefficient_pattern pattern_of(const series_list& list) {
    constexpr double largest_rounding = 1e-12;
    const auto scaled = in_unit(list.values, level_unit(list.values), bits_for(list.order()));
    return pattern_of(series::power_series<mpfr>(scaled), mpfr(std::min(list.zero, largest_rounding)));
}

std::vector<mpfr> class_of(const series_list& list, const coefficient_pattern& pattern) {
    std::vector<mpfr> b;
    for (int n = pattern.first % pattern.stride; n <= list.order(); n += pattern.stride) {
        b.push_back(list.values[static_cast<std::size_t>(n)]);
    }
    return b;
}

long bits_for(int order, double noise) {
    const long all = bits_for(order);
    return noise > 0 ? std::min(all, 384 + std::max(256L, std::lround(-8 * std::log2(noise)))) : all;
}

double log_size(const mpfr& x) {
    if (x == 0) {
        return -std::numeric_limits<double>::infinity();
    }
    long exponent = 0;
    const double mantissa = mpfr_get_d_2exp(&exponent, handle(x), MPFR_RNDN);
    return std::log(std::abs(mantissa)) + static_cast<double>(exponent) * std::log(2.0);
}

std::optional<std::vector<double>> least_squares(const std::vector<std::vector<double>>& rows,
                                                 const std::vector<double>& y) {
    if (rows.empty() || rows.size() < rows.front().size()) {
        return std::nullopt;
    }
    const auto count = static_cast<Eigen::Index>(rows.size());
    const auto unknowns = static_cast<Eigen::Index>(rows.front().size());
    Eigen::MatrixXd a(count, unknowns);
    Eigen::VectorXd b(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        b(i) = y[static_cast<std::size_t>(i)];
        for (Eigen::Index j = 0; j < unknowns; ++j) {
            a(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
        }
    }
    const Eigen::VectorXd c = a.colPivHouseholderQr().solve(b);
    return c.allFinite() ? std::optional(std::vector<double>(c.data(), c.data() + c.size())) : std::nullopt;
}

std::optional<size_growth> size_growth_of(std::span<const mpfr> b) {
    constexpr std::size_t fewest = 8;
    const double last = static_cast<double>(b.size()) - 1;
    auto points = sizes_from(b, std::max<std::size_t>(1, (b.size() - 1) / 4));
    if (points.size() < fewest) {
        return std::nullopt;
    }
    const auto row = [&](double k) { return std::vector<double>{1, k / last, k / last * std::log(k / last)}; };
    const auto fitted = [&] {
        std::vector<std::vector<double>> rows;
        std::vector<double> y;
        for (const auto& p : points) {
            rows.push_back(row(p.k));
            y.push_back(p.log);
        }
        return least_squares(rows, y);
    };
    auto c = fitted();
    if (!c) {
        return std::nullopt;
    }
    std::vector<measured_size> upper;
    std::ranges::copy_if(points, std::back_inserter(upper), [&](const auto& p) {
        const auto r = row(p.k);
        return p.log >= (*c)[0] + (*c)[1] * r[1] + (*c)[2] * r[2] - 1e-9;
    });
    if (upper.size() >= fewest) {
        points = std::move(upper);
        c = fitted().value_or(*c);
    }
    const double gamma = (*c)[2] / last;
    return size_growth{(*c)[0], (*c)[1] / last - gamma * std::log(last), gamma};
}

mpfr level_unit(std::span<const mpfr> b) {
    // In logarithms; a class of coefficients that falls much faster, as the even ones of tan(x) + exp(x^2), does not count.
    constexpr double far_below = 12;
    auto points = sizes_from(b, std::max<std::size_t>(1, (b.size() - 1) / 2));
    double slope = 0;
    bool settled = false;
    while (points.size() >= 2 && !settled) {
        std::vector<std::vector<double>> rows;
        std::vector<double> y;
        for (const auto& p : points) {
            rows.push_back({1, p.k});
            y.push_back(p.log);
        }
        const auto c = least_squares(rows, y);
        if (!c) {
            break;
        }
        slope = (*c)[1];
        const auto below = [&](const measured_size& p) { return p.log < (*c)[0] + slope * p.k - far_below; };
        settled = std::erase_if(points, below) == 0;
    }
    const precision_scope scope(20);
    mpfr unit = exp(mpfr(-slope));
    mpfr_prec_round(handle(unit), 20, MPFR_RNDN);
    return unit;
}

std::vector<mpfr> in_unit(std::span<const mpfr> b, const mpfr& unit, long bits) {
    const precision_scope scope(decimal_digits(bits + 32));
    const mpfr exact_unit = widen(unit);
    std::vector<mpfr> scaled;
    scaled.reserve(b.size());
    mpfr power(1);
    for (const mpfr& value : b) {
        scaled.push_back(value * power);
        power *= exact_unit;
    }
    return scaled;
}

}  // namespace libration::convergence
