// How large is the error of the series and of its resummation on [0, T*] at each energy and order? [paper fig:error]
#include "libration/pendulum/error/error_norm.hpp"

#include <algorithm>

#include "libration/digits/proved/proved_decimals.hpp"
#include "libration/pendulum/error/march_error.hpp"
#include "libration/pendulum/error/proved/proved_norm.hpp"
#include "libration/scalar/text/decimal.hpp"
#include "run/parallel.hpp"
#include "sweep/study.hpp"
#include "text/input_error.hpp"

namespace libration::studies {

namespace error_norm_study {
namespace {

constexpr long guard_digits = 15;

const std::vector<column>& columns() {
    static const std::vector<column> all{
        {"energy", "E, in units of m g l"},
        {"order", "N, last power of the series; last index of the resummed series"},
        {"method", "series | resummed"},
        {"norm", "max of |approximation - theta| over [0, T*], radians"},
        {"time_of_maximum", "dimensionless time since the top; with ball the digits that are proved"},
        {"scalar", "arithmetic of the approximation"},
        {"rigour", "proved | two-method: confirmed by the sum over separatrix solutions | heuristic"},
        {"gap", "2 - E"},
        {"bound", "theorem A (series) or A2 (resummed), radians; empty below the orders where they hold"},
        {"log10_norm", "log10 of norm"},
        {"log10_bound", "log10 of bound"},
        {"log10_gap", "log10 of |2 - E|"},
    };
    return all;
}

std::string_view name_of(descent_method method) { return method == descent_method::series ? "series" : "resummed"; }

// The bounds hold from the first omitted power 4, and from N = 1, on.
std::optional<mpfr> bound_of(const top_bounds<mpfr>& bounds, descent_method method, int order) {
    if (method == descent_method::series) {
        return bounds.first_omitted(order) >= 4 ? std::optional(bounds.series_norm(order)) : std::nullopt;
    }
    return order >= 1 ? std::optional(bounds.resummation_norm(order)) : std::nullopt;
}

// Whether the second route finds the same norm to the digits printed.
bool confirmed(const descent_errors& errors, descent_method method, int order, const norm_at<mpfr>& found,
               long digits) {
    const mpfr other = errors.second_opinion(method, order, found.place);
    return abs(found.norm - other) <= found.norm * pow(mpfr(10), static_cast<int>(-digits));
}

struct cell {
    const sweep_energy& at;
    int order;
    descent_method method;
};

// A norm and its time as they are printed.
struct norm_text {
    std::string norm;
    std::string time;
    std::string rigour;
};

std::vector<std::string> row_of(const cell& c, const norm_text& text, const top_bounds<mpfr>& bounds,
                                const scalar_spec& scalar) {
    const auto bound = bound_of(bounds, c.method, c.order);
    return {c.at.energy,
            std::to_string(c.order),
            std::string(name_of(c.method)),
            text.norm,
            text.time,
            scalar.name(),
            text.rigour,
            c.at.gap,
            bound ? to_decimal(*bound, 12) : "",
            log10_text(from_exact<mpfr>(read_exact(text.norm))),
            bound ? log10_text(*bound) : "",
            log10_text(abs(from_rational<mpfr>(rational(2 - c.at.value))))};
}

std::vector<std::string> row_of(const cell& c, const norm_at<mpfr>& found, const top_bounds<mpfr>& bounds,
                                const scalar_spec& scalar, bool two_method) {
    const mpfr time = found.place * bounds.effective_period;
    return row_of(c,
                  {to_decimal(found.norm, scalar.digits), to_decimal(time, scalar.digits),
                   two_method ? "two-method" : "heuristic"},
                  bounds, scalar);
}

std::vector<cell> cells_at(const sweep_energy& at, const std::vector<int>& orders) {
    std::vector<cell> cells;
    cells.reserve(2 * orders.size());
    for (const int order : orders) {
        for (const auto method : {descent_method::series, descent_method::resummed}) {
            cells.push_back({at, order, method});
        }
    }
    return cells;
}

// Decimal digits by which the norms of these orders are below theta.
long most_digits_below(const motion& m, const std::vector<int>& orders) {
    long below = 0;
    for (const int order : orders) {
        below = std::max(below, digits_below(m, order));
    }
    return below;
}

using table_rows = std::vector<std::vector<std::string>>;

// The proved rows of one energy.
table_rows proved_rows_at(const sweep_energy& at, const std::vector<int>& orders, const scalar_spec& scalar) {
    const motion m = motion::of_energy(at.value);
    const long below = most_digits_below(m, orders);
    const std::vector<cell> cells = cells_at(at, orders);
    std::vector<std::string> times;
    const auto norms = proved_decimals(scalar.digits, [&] {
        const precision_scope wider(working_digits() + below);
        const proved_descent_errors errors(at.value);
        times.clear();
        std::vector<ball> values;
        values.reserve(cells.size());
        for (const cell& c : cells) {
            proved_maximum found = errors.norm(c.method, c.order);
            const ball time = found.place * errors.effective_period();
            const long digits = proved_digits(time, scalar.digits);
            times.push_back(digits == 0 ? "" : to_proved_decimal(time, digits)->text);
            values.push_back(std::move(found.value));
        }
        return values;
    });
    const precision_scope scope(scalar.digits + guard_digits);
    const auto bounds = top_bounds<mpfr>::of(orbit_of<mpfr>(m));
    table_rows rows;
    rows.reserve(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        rows.push_back(row_of(cells[i], {norms[i].text, times[i], "proved"}, bounds, scalar));
    }
    return rows;
}

// All rows of one energy in arithmetics that round, in one table for each scalar.
std::vector<table_rows> rounded_rows_at(const sweep_energy& at, const std::vector<int>& orders,
                                        const std::vector<scalar_spec>& scalars) {
    const motion m = motion::of_energy(at.value);
    long digits = 0;
    for (const scalar_spec& scalar : scalars) {
        digits = std::max(digits, scalar.digits);
    }
    const long all_digits = digits + most_digits_below(m, orders) + guard_digits;
    const precision_scope scope(all_digits);
    descent_errors errors(m);
    std::vector<table_rows> tables(scalars.size());
    for (const cell& here : cells_at(at, orders)) {
        norm_at<mpfr> found = errors.norm(here.method, here.order);
        const bool agreed = confirmed(errors, here.method, here.order, found, digits);
        for (std::size_t i = 0; i < scalars.size(); ++i) {
            const scalar_spec& scalar = scalars[i];
            const auto norm = with_scalar(scalar, all_digits - scalar.digits, [&]<class T>() {
                if constexpr (fixed_scalar<T>) {
                    return errors.norm_in<T>(here.method, here.order, m, found.place);
                } else {
                    return found;
                }
            });
            const bool exact = scalar.kind == scalar_kind::arbitrary;
            tables[i].push_back(row_of(here, norm, errors.bounds(), scalar, exact && agreed));
        }
    }
    return tables;
}

// All rows of one energy, in one table for each scalar; balls come first.
std::vector<table_rows> rows_at(const sweep_energy& at, const std::vector<int>& orders,
                                const std::vector<scalar_spec>& scalars) {
    const auto is_proved = [](const scalar_spec& scalar) { return scalar.kind == scalar_kind::proved; };
    const auto first_rounding = std::find_if_not(scalars.begin(), scalars.end(), is_proved);
    std::vector<table_rows> tables;
    for (auto scalar = scalars.begin(); scalar != first_rounding; ++scalar) {
        tables.push_back(proved_rows_at(at, orders, *scalar));
    }
    if (first_rounding != scalars.end()) {
        const auto rounded = rounded_rows_at(at, orders, {first_rounding, scalars.end()});
        tables.insert(tables.end(), rounded.begin(), rounded.end());
    }
    return tables;
}

std::vector<scalar_spec> scalars_of(const study_request& request) {
    if (request.scalar) {
        return {*request.scalar};
    }
    return {read_scalar("ball:50", arithmetics::proved_too), read_scalar("double"), read_scalar("long-double"),
            read_scalar("quad")};
}

std::string suffix_of(const scalar_spec& scalar) { return scalar.kind == scalar_kind::proved ? "" : scalar.name(); }

const std::vector<column>& baseline_columns() {
    static const std::vector<column> all{
        {"energy", "E, in units of m g l: 2, where the solution is closed"},
        {"step", "dt of the classical Runge-Kutta method, dimensionless time"},
        {"scalar", "arithmetic of the march"},
        {"steps", "number of steps from (theta, omega) = (0, 2) to about t = 10"},
        {"norm", "max of |theta by the march - theta| at 2000 of the steps, radians"},
        {"time_of_maximum", "dimensionless time"},
        {"norm_in_epsilon", "norm over the unit in the last place of 1"},
        {"norm_without_growth", "max of |theta by the march - theta| e^-t, radians"},
        {"log10_norm", "log10 of norm"},
    };
    return all;
}

struct march {
    rational step;
    long steps;
    scalar_spec scalar;
};

// The march of the paper, and those of 10 and 100 times its step, to t = 10.
std::vector<march> marches_of(const rational& step) {
    const rational end = 10;
    std::vector<march> marches;
    for (const int factor : {100, 10, 1}) {
        const rational longer = step * factor;
        if (factor == 1 || longer <= end) {
            const long steps = reading("--step", to_finite_decimal(longer).value_or(longer.str()),
                                       "write a step such as 1e-5", [&] { return march_steps(longer, end); });
            marches.insert(marches.end(),
                           {{longer, steps, read_scalar("double")}, {longer, steps, read_scalar("long-double")}});
        }
    }
    return marches;
}

template <fixed_scalar T>
std::vector<std::string> row_of(const march& m) {
    constexpr int samples = 2000;
    const march_error found = separatrix_march_error<T>(m.step, m.steps, samples);
    return {"2",
            to_finite_decimal(m.step).value_or(m.step.str()),
            m.scalar.name(),
            std::to_string(m.steps),
            to_decimal(found.norm, m.scalar.digits),
            to_decimal(found.time, m.scalar.digits),
            to_decimal(mpfr(found.norm / widen(epsilon<T>())), 6),
            to_decimal(found.undone, m.scalar.digits),
            log10_text(found.norm)};
}

study_table baseline_of(const std::vector<march>& marches, const study_request& request) {
    progress shown("error_norm, marches", marches.size(), request.shown);
    study_table result{"baseline", marches.front().scalar, {baseline_columns(), {}}};
    result.data.rows = parallel_map(marches.size(), request.jobs, shown, [&](std::size_t i) {
        const precision_scope scope(60);
        return marches[i].scalar.kind == scalar_kind::binary64 ? row_of<double>(marches[i])
                                                               : row_of<long double>(marches[i]);
    });
    return result;
}

// The march is of the paper's whole figure: a run in one scalar is one table.
std::vector<march> marches_for(const study_request& request) {
    const bool asked = !request.scalar && request.step.coefficient > 0;
    return asked ? marches_of(request.step.coefficient) : std::vector<march>();
}

std::vector<study_table> run(const study_request& request) {
    refuse_limits(request.energies, "the series is the constant 0",
                  "the series is not defined: the period is infinite");
    const auto scalars = scalars_of(request);
    const auto marches = marches_for(request);
    progress shown("error_norm, energies", request.energies.size(), request.shown);
    const auto rows = parallel_map(request.energies.size(), request.jobs, shown, [&](std::size_t i) {
        return rows_at(request.energies[i], request.orders, scalars);
    });
    std::vector<study_table> tables;
    for (std::size_t i = 0; i < scalars.size(); ++i) {
        study_table result{request.scalar ? "" : suffix_of(scalars[i]), scalars[i], {columns(), {}}};
        for (const auto& at_energy : rows) {
            result.data.rows.insert(result.data.rows.end(), at_energy[i].begin(), at_energy[i].end());
        }
        tables.push_back(std::move(result));
    }
    if (!marches.empty()) {
        tables.push_back(baseline_of(marches, request));
    }
    return tables;
}

}  // namespace
}  // namespace error_norm_study

const study& error_norm() {
    using namespace error_norm_study;
    static const study result{
        .name = "error_norm",
        .title = "Error of the series and of its resummation",
        .label = "fig:error",
        .question = "How large is the error of the series and of its resummation on [0, T*], at each energy and order?",
        .reading =
            "Dashed: the series cut after the power N; solid: its resummation with the last index N; thin dotted: the "
            "bounds A and A2, which are proved for them. Left over the energy, right towards the separatrix. The "
            "resummation gains a factor that grows like N^2, and both lose their rate as E goes to 2. The horizontal "
            "line is the paper's baseline, the Runge-Kutta march in double with its step against the closed solution "
            "at E = 2 on [0, 10]. It is 2e-10 for the step 1e-5, about a million units in the last place: neither the "
            "precision of the machine nor the truncation of the method, but the rounding of a million steps, which the "
            "separatrix multiplies by up to e^10 (the baseline table: 1e-14 without that growth; in long double 1e-14 "
            "with it; less with 1e-4 than with 1e-5). The second figure repeats the same norms in double, long double "
            "and quad: each falls to the rounding of its arithmetic and stays there.",
        .parameters = {{"--energies", "1e-3,1e-2,0.05:1.95:39,2.02,2.05:2.95:19,3:8:26", "energies E, in m g l"},
                       {"--gaps", "1e-2:1e-10:17log,-1e-2:-1e-10:17log", "energies as 2 - E"},
                       {"--orders", "5,10,20,40,80", "N, last power of the series; last index of the resummed series"},
                       {"--step", "1e-5", "dt of the Runge-Kutta march at E = 2, dimensionless time"},
                       {"--scalar", "ball:50, and double, long-double, quad for their floors", "arithmetic"}},
        .quick = {{"--energies", "1.71,2.02", ""}, {"--orders", "6", ""}, {"--step", "1e-3", ""}},
        .seconds = 13,
        .run = run,
        .offers = arithmetics::proved_too};
    return result;
}

}  // namespace libration::studies
