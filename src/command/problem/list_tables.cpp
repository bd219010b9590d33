#include "list_tables.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <span>
#include <utility>

#include "coefficient_tables.hpp"
#include "libration/approximant/endpoint_approximant.hpp"
#include "libration/convergence/coefficient_unit.hpp"
#include "libration/convergence/radius_answers.hpp"
#include "libration/convergence/sum.hpp"
#include "libration/convergence/written_list.hpp"
#include "libration/digits/agreed_values.hpp"
#include "libration/problem/axis.hpp"
#include "libration/problem/radius_answer.hpp"
#include "libration/scalar/decimal.hpp"
#include "option/options.hpp"

namespace libration {

using namespace series;
using namespace convergence;

namespace {

constexpr int most_orders = 40;
constexpr long uncertainty_digits = 3;
constexpr int directions = 8;  // in which rounded coefficients are moved

// a_n u^n in the precision in force; (a_n + m_n) u^n if there are moves m_n.
power_series<mpfr> scaled_list(const list_request& request, int order, const mpfr& unit,
                               std::span<const mpfr> moves = {}) {
    std::vector<mpfr> values;
    mpfr power(1);
    for (int n = 0; n <= order; ++n, power *= unit) {
        const auto k = static_cast<std::size_t>(n);
        const mpfr a = from_exact<mpfr>(request.coefficients[k]);
        values.push_back((moves.empty() ? a : mpfr(a + moves[k])) * power);
    }
    return power_series<mpfr>(std::move(values));
}

// A length that makes the coefficients about as large as each other: 1 where there is none.
mpfr unit_of_list(const list_request& request) {
    const precision_scope scope(40);
    return unit_of(scaled_list(request, request.order(), mpfr(1))).length;
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
function_of_time approximant(const list_request& request, list_method method, int order, const mpfr& unit,
                             std::span<const mpfr> moves = {}) {
    if (method == list_method::endpoint) {
        const auto end = from_exact<mpfr>(*request.end);
        const endpoint_approximant<mpfr> found(scaled_list(request, order, end, moves), scaled_end(request, end));
        return [found, end](const mpfr& t) { return std::optional(found.value(mpfr(t / end))); };
    }
    const auto a = scaled_list(request, order, unit, moves);
    if (method == list_method::series) {
        return [a, unit](const mpfr& t) { return std::optional(evaluate_value(a, mpfr(t / unit))); };
    }
    const auto found = pade_of_list(a);
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

// The largest changes of the values of a method at all times if the coefficients of a rounded list move by their rounding
// errors, in directions from a linear congruence; no change at a pole, 0 for exact lists.
std::vector<std::optional<mpfr>> changes_by_rounding(const list_request& request, list_method method) {
    const written_list written = written_list_of(request.coefficients, request.rounded);
    std::vector<std::optional<mpfr>> changes(request.times.size(), mpfr(0));
    if (std::ranges::all_of(written.rounding, [](const mpfr& each) { return each == 0; })) {
        return changes;
    }
    const mpfr unit = unit_of_list(request);
    const auto whole = approximant(request, method, request.order(), unit);
    unsigned seed = 1;
    for (int i = 0; i < directions; ++i) {
        std::vector<mpfr> moves;
        for (const mpfr& each : written.rounding) {
            seed = seed * 1664525U + 1013904223U;
            moves.push_back((seed >> 16U) % 2 == 0 ? each : mpfr(-each));
        }
        const auto moved = approximant(request, method, request.order(), unit, moves);
        for (std::size_t k = 0; k < changes.size(); ++k) {
            const auto t = from_exact<mpfr>(request.times[k]);
            const auto before = whole(t);
            const auto after = moved(t);
            changes[k] = changes[k] && before && after
                             ? std::optional(std::max(*changes[k], mpfr(abs(mpfr(*after - *before)))))
                             : std::nullopt;
        }
    }
    return changes;
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

// N, and the orders without the last one and the last two coefficients that are not 0.
std::vector<int> orders_compared(const list_request& request) {
    std::vector<int> orders{request.order()};
    for (int n = request.order(); n > 0 && orders.size() < 3; --n) {
        if (!request.coefficients[static_cast<std::size_t>(n)].is_zero()) {
            orders.push_back(n - 1);
        }
    }
    return orders;
}

// floor(log10 |x|), x != 0.
long exponent_of_ten(const mpfr& x) { return mpfr_get_si(handle(mpfr(log10(mpfr(abs(x))))), MPFR_RNDD); }

mpfr unit_of_place(long exponent) { return pow(mpfr(10), static_cast<int>(exponent)); }

// The largest distance of the first value from the others, at least a unit of its last digit.
std::optional<mpfr> largest_change(const std::vector<std::optional<mpfr>>& values, long digits) {
    if (values.size() < 2 || !values.front()) {
        return std::nullopt;
    }
    const precision_scope scope(digits + 20);
    const mpfr& value = *values.front();
    mpfr largest = value == 0 ? mpfr(0) : unit_of_place(exponent_of_ten(value) - digits + 1);
    for (const auto& other : values) {
        if (!other) {
            return std::nullopt;
        }
        largest = std::max(largest, mpfr(abs(mpfr(*other - value))));
    }
    return largest;
}

// The row of the verdict at one time. The last digit of the value is the last one above its uncertainty, to which the
// rounding is added.
table_row_cells verdict_row(const list_request& request, std::size_t i, const series_value& found) {
    const exact& time = request.times[i];
    table_row_cells row{number_cell(decimal_of(time, request.digits)),
                        "verdict",
                        request.order(),
                        cell(),
                        cell(),
                        cell(),
                        time.text,
                        cell(),
                        cell(),
                        "heuristic: " + found.note};
    if (!request.reference.empty()) {
        row[4] = number_cell(decimal_of(request.reference[i], request.digits));
    }
    if (!found.value) {
        row[9] = "no value: " + found.note;
        return row;
    }
    const mpfr& value = *found.value;
    long count = request.digits;
    if (found.uncertainty > 0 && value != 0) {
        count = std::min(count, exponent_of_ten(value) - exponent_of_ten(found.uncertainty));
    }
    count = std::max(count, 1L);
    const std::string text = to_decimal(value, count);
    row[3] = cell::number(text, count);
    const mpfr rounding = abs(mpfr(mpfr(text) - value));
    const mpfr uncertainty = (found.uncertainty + rounding) * 101 / 100;  // more than the rounding to three digits
    row[7] = decimal_cell(uncertainty, uncertainty_digits);
    if (!request.reference.empty()) {
        row[5] = decimal_cell(mpfr(abs(mpfr(mpfr(text) - from_exact<mpfr>(request.reference[i])))), error_digits);
    }
    std::string methods;
    for (const std::string& name : found.methods) {
        methods += (methods.empty() ? "" : " ") + name;
    }
    row[8] = methods;
    const bool known = sign_of_exact(time) == 0;  // the first coefficient
    row[9] = known ? found.note : found.note.empty() ? "heuristic" : "heuristic: " + found.note;
    return row;
}

void add_verdicts(const list_request& request, table& data) {
    const precision_scope scope(std::max(digits_of_list(request.order()), request.digits + 20));
    const written_list written = written_list_of(request.coefficients, request.rounded);
    std::vector<mpfr> points;
    for (const exact& time : request.times) {
        points.push_back(from_exact<mpfr>(time));
    }
    const auto found = sums_of_list(written.list, written.rounding, points);
    for (std::size_t i = 0; i < found.size(); ++i) {
        data.add_row(verdict_row(request, i, found[i]));
    }
}

}  // namespace

table list_values(const list_request& request) {
    table data({{"time", ""},
                {"method", ""},
                {"order", ""},
                {"value", ""},
                {"reference", ""},
                {"error", ""},
                {"time_typed", ""},
                {"uncertainty", ""},
                {"methods", ""},
                {"note", ""}});
    if (request.verdict) {
        add_verdicts(request, data);
    }
    const auto orders = orders_compared(request);
    const auto values = values_of_list(request, orders, request.digits, false);
    const bool compared = !request.reference.empty();
    const auto errors =
        compared ? values_of_list(request, {request.order()}, error_digits, true) : std::vector<std::optional<mpfr>>{};
    const std::size_t times = request.times.size();
    const precision_scope scope(request.digits + 40);
    for (std::size_t m = 0; m < request.methods.size(); ++m) {
        const auto changes = changes_by_rounding(request, request.methods[m]);
        for (std::size_t i = 0; i < times; ++i) {
            std::vector<std::optional<mpfr>> by_order;
            for (std::size_t o = 0; o < orders.size(); ++o) {
                by_order.push_back(values[(m * orders.size() + o) * times + i]);
            }
            const auto change = largest_change(by_order, request.digits);
            const auto uncertainty =
                change && changes[i] ? std::optional(std::max(*change, *changes[i])) : std::nullopt;
            data.add_row({number_cell(decimal_of(request.times[i], request.digits)), name_of(request.methods[m]),
                          request.order(), decimal_cell(by_order.front(), request.digits),
                          compared ? number_cell(decimal_of(request.reference[i], request.digits)) : cell(),
                          compared ? decimal_cell(errors[m * times + i], error_digits) : cell(), request.times[i].text,
                          decimal_cell(uncertainty, uncertainty_digits), cell(), cell()});
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

table list_poles(const list_request& request) {
    const precision_scope scope(digits_for_poles(request.digits, request.order()));
    return poles_of(scaled_list(request, request.order(), mpfr(1)), request.digits);
}

table list_ratios(const list_request& request) {
    const precision_scope scope(digits_for_ratios(request.digits));
    return ratios_of(scaled_list(request, request.order(), mpfr(1)), request.digits);
}

table list_radius(const list_request& request) {
    const precision_scope scope(request.digits + radius_guard_digits);
    const listed_series list{scaled_list(request, request.order(), mpfr(1)), request.coefficients, request.rounded};
    return tests_of(radius_answer({{"", {{list}, 1}}}, std::nullopt,
                                  {.scalar = {scalar_kind::arbitrary, request.digits}, .digits = request.digits}));
}

}  // namespace libration
