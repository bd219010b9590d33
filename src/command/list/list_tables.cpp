#include "list/list_tables.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

#include "libration/algebra/polynomial_roots.hpp"
#include "libration/approximant/endpoint_approximant.hpp"
#include "libration/approximant/pade.hpp"
#include "libration/convergence/list/coefficient_unit.hpp"
#include "libration/digits/agreed_values.hpp"
#include "libration/problem/axis.hpp"
#include "libration/scalar/text/decimal.hpp"
#include "option/options.hpp"

namespace libration {

using namespace series;
using namespace convergence;

namespace {

constexpr long first_guard = 30;
constexpr int most_orders = 40;

// a_n u^n in the precision in force.
power_series<mpfr> scaled_list(const list_request& request, int order, const mpfr& unit) {
    std::vector<mpfr> values;
    mpfr power(1);
    for (int n = 0; n <= order; ++n, power *= unit) {
        values.push_back(from_exact<mpfr>(request.coefficients[static_cast<std::size_t>(n)]) * power);
    }
    return power_series<mpfr>(std::move(values));
}

// A length that makes the coefficients about as large as each other: 1 where there is none.
mpfr unit_of_list(const list_request& request) {
    const precision_scope scope(40);
    return unit_of(scaled_list(request, request.order(), mpfr(1))).length;
}

// [L/M] with L + M = N and M = N/2, or the next smaller M whose equations are not singular.
pade_approximant<mpfr> pade_of(const power_series<mpfr>& a) {
    for (int m = a.order() / 2; m > 0; --m) {
        if (auto found = pade(a, a.order() - m, m)) {
            return *std::move(found);
        }
    }
    return {a, power_series<mpfr>(std::vector<mpfr>{mpfr(1)})};
}

// std::nullopt at a pole.
using function_of_time = std::function<std::optional<mpfr>(const mpfr&)>;

// f^(j)(end) end^j/j!.
std::vector<mpfr> scaled_end(const list_request& request, const mpfr& end) {
    std::vector<mpfr> values;
    mpfr factor(1);
    for (std::size_t j = 0; j < request.at_end.size(); ++j) {
        values.push_back(from_exact<mpfr>(request.at_end[j]) * factor);
        factor *= end / static_cast<int>(j + 1);
    }
    return values;
}

// The list up to an order as a function of time, in the precision in force.
function_of_time approximant(const list_request& request, list_method method, int order, const mpfr& unit) {
    if (method == list_method::endpoint) {
        const auto end = from_exact<mpfr>(*request.end);
        const endpoint_approximant<mpfr> found(scaled_list(request, order, end), scaled_end(request, end));
        return [found, end](const mpfr& t) { return std::optional(found.value(mpfr(t / end))); };
    }
    const auto a = scaled_list(request, order, unit);
    if (method == list_method::series) {
        return [a, unit](const mpfr& t) { return std::optional(evaluate_value(a, mpfr(t / unit))); };
    }
    const auto found = pade_of(a);
    return [found, unit](const mpfr& t) {
        const mpfr x = t / unit;
        const mpfr below = evaluate_value(found.denominator, x);
        return below == 0 ? std::nullopt : std::optional<mpfr>(evaluate_value(found.numerator, x) / below);
    };
}

// The values of all methods and orders at all times, to `digits` digits; less the references where asked; nothing at
// poles.
std::vector<std::optional<mpfr>> values_of_list(const list_request& request, const std::vector<int>& orders,
                                                long digits, bool errors) {
    const mpfr unit = unit_of_list(request);
    std::vector<bool> poles;
    const auto compute = [&](long guard) {
        const precision_scope scope(digits + guard);
        std::vector<mpfr> values;
        poles.clear();
        for (const list_method method : request.methods) {
            for (const int order : orders) {
                const auto f = approximant(request, method, order, unit);
                for (std::size_t i = 0; i < request.times.size(); ++i) {
                    const auto value = f(from_exact<mpfr>(request.times[i]));
                    poles.push_back(!value);
                    values.push_back(!value   ? mpfr(0)
                                     : errors ? mpfr(abs(*value - from_exact<mpfr>(request.reference[i])))
                                              : *value);
                }
            }
        }
        return values;
    };
    // At t = 0 every method gives a_0, exactly.
    const auto vanishing = [&] {
        std::vector<bool> zero = poles;
        for (std::size_t k = 0; k < zero.size(); ++k) {
            const bool at_zero = sign_of_exact(request.times[k % request.times.size()]) == 0;
            zero[k] = zero[k] || (at_zero && (errors || sign_of_exact(request.coefficients.front()) == 0));
        }
        return zero;
    };
    const auto values = agreed_values(digits, compute, vanishing);
    std::vector<std::optional<mpfr>> found;
    for (std::size_t k = 0; k < values.size(); ++k) {
        found.push_back(poles[k] ? std::nullopt : std::optional(values[k]));
    }
    return found;
}

// At most so many of 1 .. N, the last among them; 0 alone where N is 0.
std::vector<int> orders_up_to(int last) {
    std::vector<int> orders;
    for (int i = 1; i <= most_orders; ++i) {
        const int order = std::max(std::min(last, 1), i * last / most_orders);
        if (orders.empty() || order > orders.back()) {
            orders.push_back(order);
        }
    }
    return orders;
}

// The power of t that symmetry leaves: the greatest common divisor of the steps between the coefficients behind a_0
// that are not 0; 1 where there are not two of them.
int power_left(const std::vector<mpfr>& a) {
    int first = 0;
    int power = 0;
    for (int n = 1; n < static_cast<int>(a.size()); ++n) {
        if (a[static_cast<std::size_t>(n)] != 0) {
            first = first == 0 ? n : first;
            power = std::gcd(power, n - first);
        }
    }
    return std::max(power, 1);
}

}  // namespace

table list_values(const list_request& request) {
    table data({{"time", ""},
                {"method", ""},
                {"order", ""},
                {"value", ""},
                {"reference", ""},
                {"error", ""},
                {"time_typed", ""}});
    const auto values = values_of_list(request, {request.order()}, request.digits, false);
    const bool compared = !request.reference.empty();
    const auto errors =
        compared ? values_of_list(request, {request.order()}, error_digits, true) : std::vector<std::optional<mpfr>>{};
    std::size_t k = 0;
    for (const list_method method : request.methods) {
        for (std::size_t i = 0; i < request.times.size(); ++i, ++k) {
            data.add_row({number_cell(decimal_of(request.times[i], request.digits)), name_of(method), request.order(),
                          decimal_cell(values[k], request.digits),
                          compared ? number_cell(decimal_of(request.reference[i], request.digits)) : cell(),
                          compared ? decimal_cell(errors[k], error_digits) : cell(), request.times[i].text});
        }
    }
    return data;
}

table list_errors(const list_request& request) {
    table data({{"time", ""}, {"method", ""}, {"order", ""}, {"error", ""}, {"log10_error", ""}});
    if (request.reference.empty()) {
        return data;
    }
    const auto orders = orders_up_to(request.order());
    const auto errors = values_of_list(request, orders, error_digits, true);
    std::size_t k = 0;
    for (const list_method method : request.methods) {
        for (const int order : orders) {
            for (const exact& time : request.times) {
                const auto& error = errors[k++];
                data.add_row({number_cell(decimal_of(time, request.digits)), name_of(method), order,
                              decimal_cell(error, error_digits), log10_cell(error)});
            }
        }
    }
    return data;
}

namespace {

struct pole_or_zero {
    const char* kind;
    complex_number<mpfr> at;
};

// The roots with im >= 0; none of a constant.
std::vector<pole_or_zero> upper_roots(const char* kind, power_series<mpfr> p, const mpfr& unit) {
    int degree = p.order();
    while (degree > 0 && p[degree] == 0) {
        --degree;
    }
    std::vector<pole_or_zero> found;
    if (degree == 0) {
        return found;
    }
    for (const auto& root : roots_of(p.truncated(degree)).all) {
        const bool real = abs(root.at.im) <= root.error_bound;
        if (real || root.at.im > 0) {
            found.push_back({kind, complex_number<mpfr>{root.at.re, real ? mpfr(0) : root.at.im} * unit});
        }
    }
    return found;
}

std::optional<mpfr> distance_to_other_kind(const pole_or_zero& from, const std::vector<pole_or_zero>& all) {
    std::optional<mpfr> least;
    for (const auto& other : all) {
        if (other.kind != from.kind) {
            const mpfr apart = modulus_of(other.at - from.at);
            least = least && *least < apart ? *least : apart;
        }
    }
    return least;
}

}  // namespace

table list_poles(const list_request& request) {
    const mpfr unit = unit_of_list(request);
    // The system loses less than a digit and a half with each degree, and its roots as many again.
    const precision_scope scope(request.digits + first_guard + 3 * request.order());
    const auto found = pade_of(scaled_list(request, request.order(), unit));
    const char* const pole = "pole";
    const char* const zero = "zero";
    auto all = upper_roots(pole, found.denominator, unit);
    const auto zeros = upper_roots(zero, found.numerator, unit);
    all.insert(all.end(), zeros.begin(), zeros.end());
    std::stable_sort(all.begin(), all.end(),
                     [](const auto& a, const auto& b) { return modulus_of(a.at) < modulus_of(b.at); });
    table data({{"kind", ""}, {"position_re", ""}, {"position_im", ""}, {"modulus", ""}, {"distance", ""}});
    for (const auto& each : all) {
        data.add_row({each.kind, decimal_cell(each.at.re, request.digits), decimal_cell(each.at.im, request.digits),
                      decimal_cell(modulus_of(each.at), request.digits),
                      decimal_cell(distance_to_other_kind(each, all), error_digits)});
    }
    return data;
}

table list_ratios(const list_request& request) {
    const precision_scope scope(request.digits + first_guard);
    table data({{"n", ""},
                {"inverse_n", ""},
                {"ratio", ""},
                {"root", ""},
                {"corrected_root", ""},
                {"power", ""},
                {"ratio_in_power", ""}});
    std::vector<mpfr> a;
    a.reserve(request.coefficients.size());
    for (const exact& coefficient : request.coefficients) {
        a.push_back(from_exact<mpfr>(coefficient));
    }
    const int power = power_left(a);
    const auto ratio_to = [&](int n, int back) {
        const bool after_constant = back == 1 || n > back;
        const mpfr before = n >= back && after_constant ? a[static_cast<std::size_t>(n - back)] : mpfr(0);
        return before == 0 ? cell() : decimal_cell(mpfr(a[static_cast<std::size_t>(n)] / before), request.digits);
    };
    for (int n = 0; n <= request.order(); ++n) {
        const mpfr& now = a[static_cast<std::size_t>(n)];
        if (n > 0) {
            const auto root = [&](const mpfr& x) {
                return x == 0 ? std::nullopt : std::optional(mpfr(exp(mpfr(log(x)) / n)));
            };
            const mpfr size = abs(now);
            data.add_row({n, decimal_cell(mpfr(mpfr(1) / n), request.digits), ratio_to(n, 1),
                          decimal_cell(root(size), request.digits), decimal_cell(root(mpfr(size * n)), request.digits),
                          power, ratio_to(n, power)});
        }
    }
    return data;
}

}  // namespace libration
