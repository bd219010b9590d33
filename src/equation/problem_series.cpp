#include "equation/problem_series.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "equation/complex_times.hpp"
#include "libration/ode/ball/fast_product.hpp"
#include "libration/ode/ball/taylor_expansion.hpp"
#include "libration/ode/parse.hpp"
#include "libration/ode/path.hpp"
#include "libration/ode/proved/proved_march.hpp"
#include "libration/ode/step.hpp"
#include "libration/scalar/error.hpp"
#include "run/digits.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr long longest_exact_series = 400;

bool is_plain_zero(const ode::number& x) {
    const auto plain = x.plain();
    return plain && plain->coefficient == 0;
}

// The coefficients of all unknowns, one degree after the other.
template <class R, class Add>
void each_coefficient(const problem_series_request& request, const ode::taylor_expansion<R>& of, const Add& add) {
    for (long n = request.first; n <= request.order; ++n) {
        for (int i = 0; i < static_cast<int>(request.system.unknowns().size()); ++i) {
            add(of.coefficients(i)[n], i, n);
        }
    }
}

template <class T>
void require_in_range(const T& value, const ode::explicit_system& system, int unknown, long n) {
    if constexpr (rounding_scalar<T>) {
        if (mpfr_number_p(handle(mpfr(widen(value)))) == 0) {
            throw error(
                error_kind::range,
                fmt::format("coefficient {} of {}", n, system.unknowns()[static_cast<std::size_t>(unknown)].name), "",
                "is beyond the range of this scalar");
        }
    }
}

template <class T>
std::vector<wide_t<T>> flat_values(const problem_series_request& request, const ode::taylor_expansion<T>& of) {
    std::vector<wide_t<T>> values;
    each_coefficient(request, of, [&](const T& value, int unknown, long n) {
        require_in_range(value, request.system, unknown, n);
        values.push_back(widen(value));
    });
    return values;
}

template <class T>
std::vector<complex_number<mpfr>> flat_values(const problem_series_request& request,
                                              const ode::taylor_expansion<complex_number<T>>& of) {
    std::vector<complex_number<mpfr>> values;
    each_coefficient(request, of, [&](const complex_number<T>& value, int unknown, long n) {
        require_in_range(value.re, request.system, unknown, n);
        require_in_range(value.im, request.system, unknown, n);
        values.push_back({widen(value.re), widen(value.im)});
    });
    return values;
}

template <class T>
std::vector<wide_t<T>> about_start(const problem_series_request& request, const ode::tape& made) {
    ode::taylor_expansion<T> expansion(made, static_cast<int>(request.order), ode::fast_product<T>());
    expansion.about_start();
    return flat_values(request, expansion);
}

template <class T>
std::vector<wide_t<T>> about_time(const problem_series_request& request, const ode::number& time) {
    const T t = ode::constant_value<T>::of(time);
    ode::taylor_march<T> march(request.system, ode::fast_product<T>());
    const auto state = march.advance_to(t);
    const ode::tape made = ode::tape::about_points(request.system);
    ode::taylor_expansion<T> expansion(made, static_cast<int>(request.order), ode::fast_product<T>());
    expansion.about(t, state);
    return flat_values(request, expansion);
}

// In balls the way there is proved.
std::vector<wide_t<ball>> proved_about_time(const problem_series_request& request, const ode::number& time) {
    ode::proved_march march(request.system, static_cast<long>(ball::working_bits()) + 64);
    const auto values = march.at(time);
    if (!values && march.end() == ode::march_end::precision) {
        throw precision_exhausted("the way to the point");
    }
    if (!values) {
        throw error(error_kind::undecided, "--at", *request.at,
                    "is not reached: the steps become too small before it, as they do near a singularity");
    }
    ode::solution_state<ball> state;
    auto next = values->begin();
    for (const auto& each : request.system.unknowns()) {
        state.emplace_back(next, next + each.order);
        next += each.order;
    }
    const ode::tape made = ode::tape::about_points(request.system);
    ode::taylor_expansion<ball> expansion(made, static_cast<int>(request.order), ode::fast_product<ball>());
    expansion.about(ode::constant_value<ball>::of(time), state);
    return flat_values(request, expansion);
}

// By the corners of the way.
template <class T>
std::vector<complex_number<mpfr>> about_point(const problem_series_request& request,
                                              const std::vector<ode::complex_constant>& corners,
                                              const ode::complex_constant& point) {
    const auto state = ode::states_along<T>(request.system, corners, {point}).front();
    const ode::tape made = ode::tape::about_points(request.system);
    ode::taylor_expansion<complex_number<T>> expansion(made, static_cast<int>(request.order));
    expansion.about(ode::constant_value<complex_number<T>>::of(point), state);
    return flat_values(request, expansion);
}

// Which coefficients about the start are exactly 0: by fractions where they serve, else by the symmetry alone.
std::vector<bool> zeros_about_start(const problem_series_request& request, const ode::tape& made) {
    std::vector<bool> zeros;
    try {
        if (request.order <= longest_exact_series) {
            ode::taylor_expansion<rational> exact(made, static_cast<int>(request.order));
            exact.about_start();
            each_coefficient(request, exact, [&](const rational& c, int, long) { zeros.push_back(c == 0); });
            return zeros;
        }
    } catch (const error&) {
        zeros.clear();  // it has other numbers than fractions
    }
    for (long n = request.first; n <= request.order; ++n) {
        for (int i = 0; i < static_cast<int>(request.system.unknowns().size()); ++i) {
            const int residue = made.residue_of(i);
            zeros.push_back(residue < 0 || n % made.stride() != residue);
        }
    }
    return zeros;
}

// The names of the columns: unknowns, their parts about a complex point.
std::vector<std::string> names_of_columns(const ode::explicit_system& system, bool parts) {
    std::vector<std::string> names;
    for (const auto& each : system.unknowns()) {
        if (parts) {
            names.push_back(each.name + "_re");
            names.push_back(each.name + "_im");
        } else {
            names.push_back(each.name);
        }
    }
    return names;
}

// The exponent of coefficient n of powers of s^(1/root).
std::string exponent_text(long n, int root) {
    const rational power(n, root);
    return power.str();
}

table series_table(const problem_series_request& request, const std::vector<std::string>& names,
                   const std::vector<printed_number>& values, bool proved, int root) {
    std::vector<column> columns{{"n", ""}};
    for (const std::string& each : names) {
        columns.push_back({each, ""});
    }
    for (const std::string& each : names) {
        if (proved) {
            columns.push_back({each + "_uncertainty", ""});
        }
    }
    if (root > 1) {
        columns.push_back({"power", ""});
    }
    table data(std::move(columns));
    for (std::size_t at = 0; at < values.size(); at += names.size()) {
        const long n = request.first + static_cast<long>(at / names.size());
        table_row_cells row{n};
        for (std::size_t i = 0; i < names.size(); ++i) {
            row.push_back(number_cell(values[at + i].text));
        }
        for (std::size_t i = 0; proved && i < names.size(); ++i) {
            row.push_back(number_cell(values[at + i].uncertainty));
        }
        if (root > 1) {
            row.emplace_back(exponent_text(n, root));
        }
        data.add_row(std::move(row));
    }
    return data;
}

ode::complex_constant point_of_series(const std::string& at) {
    try {
        return ode::parse_complex_constant(at);
    } catch (const error& problem) {
        throw input_error("--at", at, problem.reason(), "write a time as 1/2, or a complex one as 1+2i");
    }
}

// Where the way there ends before it, the option says so.
template <class Print>
auto on_the_way_to(const problem_series_request& request, const Print& print) {
    try {
        return print();
    } catch (const error& problem) {
        if (problem.subject() != "time" && problem.subject() != "point") {
            throw;
        }
        throw input_error(request.via ? "--at with --via" : "--at", *request.at, problem.reason(),
                          "choose a point nearer to the start, or a way around it, --via \"1+i,2+i\"");
    }
}

}  // namespace

namespace {

// The coefficients of all unknowns, one degree after the other; about a complex point two parts each.
struct rounded_coefficients {
    std::vector<mpfr> values;
    bool complex = false;
    int root = 1;
};

bool is_at_start(const problem_series_request& request, const std::optional<ode::complex_constant>& point) {
    if (request.via && !point) {
        throw input_error("--via", *request.via, "is a way to a point and there is none", "give --at too");
    }
    return !point || (!request.via && is_plain_zero(point->im) && is_plain_zero(point->re - request.system.point()));
}

rounded_coefficients coefficients_in(const scalar_spec& scalar, const problem_series_request& request) {
    const auto point = request.at ? std::optional(point_of_series(*request.at)) : std::nullopt;
    if (is_at_start(request, point)) {
        const ode::tape made = ode::tape::about_start(request.system);
        return {rounded_values(
                    scalar, [&]<class T>() { return about_start<T>(request, made); },
                    [&] { return zeros_about_start(request, made); }),
                false, made.root()};
    }
    if (is_plain_zero(point->im) && !request.via) {
        auto values = on_the_way_to(request, [&] {
            return rounded_values(scalar, [&]<class T>() { return about_time<T>(request, point->re); });
        });
        return {std::move(values), false, 1};
    }
    const auto corners = corners_of(request.via);
    const auto complex_values = on_the_way_to(request, [&] {
        return rounded_complex_values(scalar, [&]<class T>() { return about_point<T>(request, corners, *point); });
    });
    rounded_coefficients found{{}, true, 1};
    for (const auto& each : complex_values) {
        found.values.push_back(each.re);
        found.values.push_back(each.im);
    }
    return found;
}

}  // namespace

table problem_coefficients(const problem_series_request& request, const arithmetic& numbers) {
    if (numbers.scalar.kind != scalar_kind::proved) {
        const auto found = coefficients_in(numbers.scalar, request);
        return series_table(request, names_of_columns(request.system, found.complex),
                            printed(found.values, numbers.digits), false, found.root);
    }
    const auto point = request.at ? std::optional(point_of_series(*request.at)) : std::nullopt;
    if (!is_at_start(request, point)) {
        if (request.via || !is_plain_zero(point->im)) {
            throw input_error("--scalar", numbers.scalar.name(),
                              "proves no way through the complex plane to --at '" + *request.at + "'",
                              "use mpfr:" + std::to_string(numbers.scalar.digits));
        }
        const auto values = proved_decimals(numbers.digits, [&] { return proved_about_time(request, point->re); });
        return series_table(request, names_of_columns(request.system, false), values, true, 1);
    }
    const ode::tape made = ode::tape::about_start(request.system);
    const auto values = printed(
        numbers.scalar, numbers.digits, [&]<class T>() { return about_start<T>(request, made); },
        [&] { return zeros_about_start(request, made); });
    return series_table(request, names_of_columns(request.system, false), values, true, made.root());
}

problem_lists lists_of_problem(const problem_series_request& request, long digits) {
    const auto found = coefficients_in({scalar_kind::arbitrary, digits}, request);
    const std::size_t unknowns = request.system.unknowns().size();
    const std::size_t parts = found.complex ? 2 : 1;
    problem_lists result{{}, found.root};
    for (std::size_t i = 0; i < unknowns; ++i) {
        problem_list list{request.system.unknowns()[i].name, {}};
        for (std::size_t part = 0; part < parts; ++part) {
            std::vector<mpfr> values;
            for (std::size_t at = i * parts + part; at < found.values.size(); at += unknowns * parts) {
                values.push_back(found.values[at]);
            }
            list.parts.emplace_back(std::move(values));
        }
        result.unknowns.push_back(std::move(list));
    }
    return result;
}

table problem_fractions(const problem_series_request& request) {
    if (request.at) {
        throw input_error("--at", *request.at, "is no point for fractions, which a solution has at its start alone",
                          "leave it out");
    }
    const ode::tape made = ode::tape::about_start(request.system);
    ode::taylor_expansion<rational> exact(made, static_cast<int>(request.order));
    exact.about_start();
    const auto names = names_of_columns(request.system, false);
    std::vector<printed_number> values;
    each_coefficient(request, exact, [&](const rational& c, int, long) { values.push_back({c.str(), ""}); });
    return series_table(request, names, values, false, made.root());
}

}  // namespace libration
