#include "list_growth.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "libration/convergence/list.hpp"
#include "libration/scalar/convert.hpp"
#include "libration/scalar/mpfr_traits.hpp"

namespace libration::convergence {

namespace {

struct upper_point {
    double n, log;
};

using size_form = std::function<std::vector<double>(double)>;

double value_of(const std::vector<double>& c, const std::vector<double>& row) {
    double sum = 0;
    for (std::size_t i = 0; i < c.size(); ++i) {
        sum += c[i] * row[i];
    }
    return sum;
}

// The coefficient of n, fitted three times, each time to the points on or above the fit before.
std::optional<double> upper_slope(std::vector<upper_point> points, const size_form& form) {
    std::optional<std::vector<double>> c;
    for (int round = 0; round < 3; ++round) {
        std::vector<std::vector<double>> rows;
        std::vector<double> y;
        for (const auto& p : points) {
            rows.push_back(form(p.n));
            y.push_back(p.log);
        }
        c = least_squares(rows, y);
        if (!c) {
            return std::nullopt;
        }
        std::vector<upper_point> upper;
        std::ranges::copy_if(points, std::back_inserter(upper),
                             [&](const auto& p) { return p.log >= value_of(*c, form(p.n)) - 1e-9; });
        if (upper.size() < std::max<std::size_t>(6, form(2).size() + 3)) {
            break;
        }
        points = std::move(upper);
    }
    return (*c)[1];
}

std::vector<upper_point> sizes_beyond(std::span<const mpfr> a, double part) {
    std::vector<upper_point> points;
    const auto last = static_cast<double>(a.size() - 1);
    for (std::size_t n = std::max<std::size_t>(2, static_cast<std::size_t>(part * last)); n < a.size(); ++n) {
        if (a[n] != 0) {
            points.push_back({static_cast<double>(n), log_size(a[n])});
        }
    }
    return points;
}

}  // namespace

std::vector<rational> gevrey_orders_near(double gamma) {
    constexpr std::size_t most = 4;
    const double size = std::abs(gamma);
    const auto away = [&](const rational& s) { return std::abs(s.convert_to<double>() - size); };
    std::vector<rational> orders;
    for (const int sixths : {1, 2, 3, 4, 6, 8, 9, 12, 18, 24}) {
        orders.emplace_back(sixths, 6);
    }
    std::ranges::stable_sort(orders, {}, away);
    orders.resize(most);
    std::erase_if(orders, [&](const rational& s) { return away(s) > 0.25 + 0.3 * size; });
    return orders;
}

std::vector<mpfr> without_factorials(std::span<const mpfr> b, const rational& s, long bits) {
    const precision_scope scope(decimal_digits(bits + 64));
    const mpfr order = from_rational<mpfr>(s);
    std::vector<mpfr> found;
    found.reserve(b.size());
    for (std::size_t k = 0; k < b.size(); ++k) {
        const mpfr argument = 1 + abs(order) * static_cast<int>(k);
        mpfr factor;
        mpfr_gamma(handle(factor), handle(argument), MPFR_RNDN);
        found.push_back(order > 0 ? mpfr(b[k] / factor) : mpfr(b[k] * factor));
    }
    return found;
}

bool is_steady_growth(std::span<const mpfr> b, double gamma) {
    const auto part = static_cast<std::size_t>(0.6 * static_cast<double>(b.size() - 1)) + 1;
    const auto shorter = size_growth_of(b.first(part));
    return shorter && shorter->gamma / gamma > 0.6 && shorter->gamma / gamma < 1.6;
}

std::optional<size_envelope> envelope_of(std::span<const mpfr> a) {
    constexpr std::size_t fewest = 6;
    const auto last = static_cast<double>(a.size() - 1);
    const std::vector<size_form> forms{[](double n) {
                                           return std::vector<double>{1, n};
                                       },
                                       [](double n) {
                                           return std::vector<double>{1, n, std::log(n)};
                                       },
                                       [](double n) {
                                           return std::vector<double>{1, n, std::sqrt(n)};
                                       },
                                       [](double n) {
                                           return std::vector<double>{1, n, std::sqrt(n), std::log(n)};
                                       }};
    std::vector<double> found;
    for (const double part : {0.2, 0.35, 0.5}) {
        const auto points = sizes_beyond(a, part);
        for (const auto& form : forms) {
            if (points.size() >= fewest) {
                if (const auto slope = upper_slope(points, form)) {
                    found.push_back(-*slope);
                }
            }
        }
    }
    if (!found.empty()) {
        std::ranges::sort(found);
        const double middle = found[found.size() / 2];
        double spread = 2 * std::log(last + 2) / last;
        for (std::size_t i = found.size() / 6; i < found.size() - found.size() / 6; ++i) {
            spread = std::max(spread, std::abs(found[i] - middle));
        }
        return size_envelope{middle, std::min(5.0, std::expm1(1.5 * spread))};
    }
    std::optional<double> least;
    for (const auto& p : sizes_beyond(a, 1.0 / 3)) {
        least = std::min(least.value_or(-p.log / p.n), -p.log / p.n);
    }
    return least ? std::optional(size_envelope{*least, std::expm1(3 * std::log(last + 2) / last)}) : std::nullopt;
}

}  // namespace libration::convergence
