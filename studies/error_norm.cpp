// How large is the error of the series and of its resummation on [0, T*] at each energy and order? [paper fig:error]
#include <algorithm>
#include <utility>

#include "libration/digits/proved/proved_decimals.hpp"
#include "libration/pendulum/error/error_norm.hpp"
#include "libration/pendulum/error/march_error.hpp"
#include "libration/pendulum/error/proved/proved_norm.hpp"
#include "shared/proved_norms.hpp"
#include "shared/radius_on_interval.hpp"
#include "shared/sweep_columns.hpp"
#include "shared/sweep_plan.hpp"

namespace libration::studies {

namespace error_norm_study {

namespace of_pendulum {

using namespace elliptic;
using namespace pendulum;

namespace {

constexpr long guard_digits = 15;

// The bounds hold if the first omitted power is at least 4, and from N = 1.
std::optional<mpfr> bound_of(const top_bounds<mpfr>& bounds, arc_method method, int order) {
    if (method == arc_method::series) {
        return bounds.first_omitted(order) >= 4 ? std::optional(bounds.series_norm(order)) : std::nullopt;
    }
    return order >= 1 ? std::optional(bounds.resummation_norm(order)) : std::nullopt;
}

// Whether the second route gives the same norm to the printed digits.
bool confirmed(const arc_errors& errors, arc_method method, int order, const norm_at<mpfr>& found, long digits) {
    const mpfr other = errors.second_opinion(method, order, found.place);
    return abs(found.norm - other) <= found.norm * pow(mpfr(10), static_cast<int>(-digits));
}

// One requested norm.
struct asked_norm {
    const sweep_energy& at;
    int order;
    arc_method method;
};

// A norm and its time as they are printed.
struct norm_row {
    const sweep_energy& at;
    int order;
    arc_method method;
    cell norm;
    cell time;
    std::string rigour;
    std::optional<mpfr> bound;
    const scalar_spec& scalar;
};

const column_list<norm_row>& columns() {
    using row = norm_row;
    static const auto all = with_typed_energy<row>({
        energy_column<row>(),
        {"order", "N, last power of the series; last index of the resummed series",
         [](const row& r) { return r.order; }},
        {"method", "series | resummed", [](const row& r) { return name_of(r.method); }},
        {"norm", "max of |approximation - theta| over [0, T*], radians", [](const row& r) { return r.norm; }},
        {"time_of_maximum", "dimensionless time since the top; with ball the digits that are proved",
         [](const row& r) { return r.time; }},
        {"scalar", "arithmetic of the approximation", [](const row& r) { return r.scalar.name(); }},
        {"rigour", "proved | two-method: confirmed by the sum over separatrix solutions | heuristic",
         [](const row& r) { return r.rigour; }},
        gap_column<row>(),
        {"bound", "theorem A (series) or A2 (resummed), radians; empty below the orders where they hold",
         [](const row& r) { return decimal_cell(r.bound, 12); }},
        {"log10_norm", "log10 of norm",
         [](const row& r) { return log10_cell(from_exact<mpfr>(read_exact(r.norm.text()))); }},
        {"log10_bound", "log10 of bound", [](const row& r) { return log10_cell(r.bound); }},
        log10_gap_column<row>(),
    });
    return all;
}

norm_row row_of(const asked_norm& c, const norm_at<mpfr>& found, const top_bounds<mpfr>& bounds,
                const scalar_spec& scalar, bool two_method) {
    return {c.at,
            c.order,
            c.method,
            decimal_cell(found.norm, scalar.digits),
            decimal_cell(mpfr(found.place * bounds.effective_period), scalar.digits),
            two_method ? "two-method" : "heuristic",
            bound_of(bounds, c.method, c.order),
            scalar};
}

std::vector<asked_norm> norms_at(const sweep_energy& at, const std::vector<int>& orders) {
    std::vector<asked_norm> cells;
    cells.reserve(2 * orders.size());
    for (const int order : orders) {
        for (const auto method : {arc_method::series, arc_method::resummed}) {
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

// The proved rows of one energy.
table proved_rows_at(const sweep_energy& at, const std::vector<int>& orders, const scalar_spec& scalar) {
    const motion m = motion::of_energy(at.value);
    const long below = most_digits_below(m, orders);
    const std::vector<asked_norm> cells = norms_at(at, orders);
    std::vector<cell> times;
    const auto norms = proved_decimals(scalar.digits, [&] {
        const precision_scope wider(working_digits() + below);
        const proved_arc_errors errors(at.value);
        times.clear();
        std::vector<ball> values;
        values.reserve(cells.size());
        for (const asked_norm& c : cells) {
            proved_maximum found = errors.norm(c.method, c.order);
            const ball time = found.place * errors.effective_period();
            const long digits = proved_digits(time, scalar.digits);
            times.push_back(digits == 0 ? cell() : cell::number(to_proved_decimal(time, digits)->text, digits));
            values.push_back(std::move(found.value));
        }
        return values;
    });
    const precision_scope scope(scalar.digits + guard_digits);
    const auto bounds = top_bounds<mpfr>::of(energy_level_of<mpfr>(m));
    std::vector<norm_row> rows;
    rows.reserve(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto& [energy, order, method] = cells[i];
        rows.push_back({energy, order, method, cell::number(norms[i].text, scalar.digits), times[i], "proved",
                        bound_of(bounds, method, order), scalar});
    }
    return make_table(columns(), rows);
}

// All rows of one energy in arithmetics that round, in one table for each scalar.
std::vector<table> rounded_rows_at(const sweep_energy& at, const std::vector<int>& orders,
                                   const std::vector<scalar_spec>& scalars) {
    const motion m = motion::of_energy(at.value);
    long digits = 0;
    for (const scalar_spec& scalar : scalars) {
        digits = std::max(digits, scalar.digits);
    }
    const long all_digits = digits + most_digits_below(m, orders) + guard_digits;
    const precision_scope scope(all_digits);
    arc_errors errors(m);
    std::vector<std::vector<norm_row>> rows(scalars.size());
    for (const asked_norm& here : norms_at(at, orders)) {
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
            rows[i].push_back(row_of(here, norm, errors.bounds(), scalar, exact && agreed));
        }
    }
    std::vector<table> tables;
    tables.reserve(rows.size());
    for (const auto& in_scalar : rows) {
        tables.push_back(make_table(columns(), in_scalar));
    }
    return tables;
}

// All rows of one energy, in one table for each scalar; balls come first.
std::vector<table> rows_at(const sweep_energy& at, const std::vector<int>& orders,
                           const std::vector<scalar_spec>& scalars) {
    const auto is_proved = [](const scalar_spec& scalar) { return scalar.kind == scalar_kind::proved; };
    const auto first_rounding = std::find_if_not(scalars.begin(), scalars.end(), is_proved);
    std::vector<table> tables;
    for (auto scalar = scalars.begin(); scalar != first_rounding; ++scalar) {
        tables.push_back(proved_rows_at(at, orders, *scalar));
    }
    if (first_rounding != scalars.end()) {
        const std::vector<scalar_spec> rounding(first_rounding, scalars.end());
        const auto rounded = rounded_rows_at(at, orders, rounding);
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

struct march {
    rational step;
    long steps;
    scalar_spec scalar;
};

// The paper's Runge-Kutta integration, and those with 10 and 100 times its step, to t = 10.
std::vector<march> marches_of(const rational& step) {
    const rational end = 10;
    std::vector<march> marches;
    for (const int factor : {100, 10, 1}) {
        const rational longer = step * factor;
        if (factor == 1 || longer <= end) {
            const long steps = reading("--step", decimal_of(longer, 50), "write a step such as 1e-5",
                                       [&] { return march_steps(longer, end); });
            marches.insert(marches.end(),
                           {{longer, steps, read_scalar("double")}, {longer, steps, read_scalar("long-double")}});
        }
    }
    return marches;
}

// A Runge-Kutta solution compared with the closed-form solution.
struct march_row {
    march of;
    march_error found;
    mpfr norm_in_epsilon;
};

const column_list<march_row>& baseline_columns() {
    using row = march_row;
    static const column_list<row> all{
        {"energy", "E, in units of m g l: 2, where the solution is closed",
         [](const row&) { return number_cell("2"); }},
        {"step", "dt of the classical Runge-Kutta method, dimensionless time",
         [](const row& r) { return number_cell(decimal_of(r.of.step, 50)); }},
        {"scalar", "arithmetic of the march", [](const row& r) { return r.of.scalar.name(); }},
        {"steps", "number of steps from (theta, omega) = (0, 2) to about t = 10",
         [](const row& r) { return r.of.steps; }},
        {"norm", "max of |theta by the march - theta| at 2000 of the steps, radians",
         [](const row& r) { return decimal_cell(r.found.norm, r.of.scalar.digits); }},
        {"time_of_maximum", "dimensionless time",
         [](const row& r) { return decimal_cell(r.found.time, r.of.scalar.digits); }},
        {"norm_in_epsilon", "norm over the unit in the last place of 1",
         [](const row& r) { return decimal_cell(r.norm_in_epsilon, 6); }},
        {"norm_without_growth", "max of |theta by the march - theta| e^-t, radians",
         [](const row& r) { return decimal_cell(r.found.undone, r.of.scalar.digits); }},
        {"log10_norm", "log10 of norm", [](const row& r) { return log10_cell(r.found.norm); }},
    };
    return all;
}

template <fixed_scalar T>
march_row row_in(const march& m) {
    constexpr int samples = 2000;
    const march_error found = separatrix_march_error<T>(m.step, m.steps, samples);
    return {m, found, mpfr(found.norm / widen(epsilon<T>()))};
}

march_row row_of(const march& m) {
    const precision_scope scope(60);
    return m.scalar.kind == scalar_kind::binary64 ? row_in<double>(m) : row_in<long double>(m);
}

// The integration belongs to the paper's whole figure: a run in one scalar is one table.
std::vector<march> marches_for(const study_request& request) {
    const bool asked = !request.scalar && request.step().coefficient > 0;
    return asked ? marches_of(request.step().coefficient) : std::vector<march>();
}

// The energies first, each with its orders as cells, and then the integrations.
cell_group group_of_march(const march& m, std::size_t table_of_marches) {
    return {{{{"step", decimal_of(m.step, 50)}, {"scalar", m.scalar.name()}}},
            [m, table_of_marches](const std::vector<std::size_t>& /*the only one*/) {
                cell_rows rows(table_of_marches + 1);
                rows.back() = make_table(baseline_columns(), std::vector<march_row>{row_of(m)}).rows();
                return std::vector<cell_rows>{std::move(rows)};
            }};
}

study_plan plan(const study_request& request) {
    const auto scalars = scalars_of(request);
    const auto marches = marches_for(request);
    std::vector<study_table> tables;
    tables.reserve(scalars.size() + 1);
    for (const scalar_spec& scalar : scalars) {
        tables.push_back(head_of(request.scalar ? "" : suffix_of(scalar), scalar, columns()));
    }
    if (!marches.empty()) {
        tables.push_back(head_of("baseline", marches.front().scalar, baseline_columns()));
    }
    study_plan plan = plan_by_order(
        std::move(tables), sweep_of(request), request.orders(),
        [scalars](const sweep_energy& at, const std::vector<int>& orders) { return rows_at(at, orders, scalars); });
    plan.axes.emplace_back("step");
    plan.group = [of_energies = plan.group, energies = plan.groups, marches, place = scalars.size()](std::size_t i) {
        return i < energies ? of_energies(i) : group_of_march(marches[i - energies], place);
    };
    // Approximate seconds: the integration with a million steps takes longest.
    plan.cost = [energies = plan.groups, orders = request.orders().size(), marches](std::size_t i) {
        return i < energies ? 0.01 * static_cast<double>(orders)
                            : 2e-7 * static_cast<double>(marches[i - energies].steps);
    };
    plan.groups += marches.size();
    return plan;
}

}  // namespace
}  // namespace of_pendulum

namespace of_equation {

namespace {

// A norm as it is printed; empty if there is no such approximant.
struct norm_row {
    int order;
    approximation method;
    cell norm;
    cell time;
    cell log10_norm;
    std::string rigour;
    const scalar_spec& scalar;
    std::string unknown;
};

const column_list<norm_row>& columns() {
    using row = norm_row;
    static const column_list<row> all{
        {"order", "N, last power of the series about the start", [](const row& r) { return r.order; }},
        {"method",
         "series | pade: [m/m] with 2 m <= N, without the powers that a symmetry leaves out | endpoint: with value and "
         "slope of the far end of the times",
         [](const row& r) { return name_of(r.method); }},
        {"norm",
         "max of |approximation - solution| over the times, in the unit of the unknown; empty where that is not "
         "decided",
         [](const row& r) { return r.norm; }},
        {"time_of_maximum", "which of the times, in the unit of the variable; empty where the norm is 0",
         [](const row& r) { return r.time; }},
        {"scalar", "arithmetic of the approximation", [](const row& r) { return r.scalar.name(); }},
        {"rigour",
         "two-method: two marches and series of other precisions agree | heuristic | proved: with --scalar ball:D | "
         "not decided: no precision tells it from 0, as where the approximation is the solution",
         [](const row& r) { return r.rigour; }},
        {"log10_norm", "log10 of norm", [](const row& r) { return r.log10_norm; }},
        unknown_column<row>(),
    };
    return all;
}

struct question {
    shared_equation_sweep sweep;
    std::vector<ode::number> times;
    std::vector<exact> typed_times;
    scalar_spec scalar;
};

norm_row row_of(const question& asked, const found_norm& found) {
    const precision_scope scope(asked.scalar.digits + 20);
    const std::string& unknown = asked.sweep->name_of(found.unknown);
    if (!found.there) {
        return {found.order, found.method, {}, {}, {}, "", asked.scalar, unknown};
    }
    return {found.order,
            found.method,
            decimal_cell(found.norm, asked.scalar.digits),
            found.norm == 0 ? cell() : number_cell(decimal_of(asked.typed_times[found.place], 50)),
            log10_cell(found.norm),
            found.agreed ? "two-method" : "heuristic",
            asked.scalar,
            unknown};
}

norm_row row_of(const question& asked, const proved_norm& found) {
    const precision_scope scope(asked.scalar.digits + 20);
    norm_row row{found.order, found.method, {}, {}, {}, "", asked.scalar, asked.sweep->name_of(found.unknown)};
    if (!found.there) {
        return row;
    }
    row.rigour = found.norm ? "proved" : "not decided";
    if (found.norm) {
        row.norm = cell::number(found.norm->text, asked.scalar.digits);
        row.log10_norm = log10_cell(mpfr(found.norm->text));
        row.time = found.place ? number_cell(decimal_of(asked.typed_times[*found.place], 50)) : cell();
    }
    return row;
}

table rows_at(const question& asked, std::size_t i, const std::vector<int>& orders) {
    const auto system = asked.sweep->system(i);
    const std::vector<approximation> methods{approximation::series, approximation::pade, approximation::endpoint};
    std::vector<norm_row> rows;
    if (asked.scalar.kind == scalar_kind::proved) {
        for (const auto& each :
             proved_norms({system, asked.times, asked.sweep->unknowns(), methods}, orders, asked.scalar.digits)) {
            rows.push_back(row_of(asked, each));
        }
        return make_table(columns(), rows);
    }
    for (const auto& each : norms_of({system, asked.times, asked.sweep->unknowns(), methods}, orders, asked.scalar)) {
        rows.push_back(row_of(asked, each));
    }
    return make_table(columns(), rows);
}

study_plan plan(const study_request& request) {
    const question asked{equation_sweep_of(request), times_of(request, 2), request.values.of("time"),
                         request.scalar.value_or(read_scalar("mpfr:20"))};
    const auto orders = orders_from(request, 0, "");
    return with_radii(
        plan_by_numbers({head_of(*asked.sweep, "", asked.scalar, columns())}, asked.sweep, "order", orders,
                        [asked](std::size_t i, const std::vector<int>& chosen) {
                            return std::vector<table>{rows_at(asked, i, chosen)};
                        }),
        asked.sweep, asked.times);
}

}  // namespace
}  // namespace of_equation

namespace {

study_plan plan(const study_request& request) {
    return request.equation ? of_equation::plan(request) : of_pendulum::plan(request);
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
            "at E = 2 on [0, 10]. It is {{the norm of error_norm_baseline where step=1e-5 scalar=double to 1}} for the "
            "step 1e-5, {{the norm_in_epsilon of error_norm_baseline where step=1e-5 scalar=double to 1}} units in the "
            "last place: neither the precision of the machine nor the truncation of the method, but the rounding of a "
            "million steps, which the separatrix multiplies by up to e^10 (the baseline table: "
            "{{the norm_without_growth of error_norm_baseline where step=1e-5 scalar=double to 1}} without that "
            "growth; in long double {{the norm of error_norm_baseline where step=1e-5 scalar=long-double to 1}} with "
            "it; {{the norm of error_norm_baseline where step=1e-4 scalar=double to 1}} with the step 1e-4). The "
            "second figure repeats the same norms in double, long double "
            "and quad: each falls to the rounding of its arithmetic and stays there.",
        .of = &pendulum_problem(),
        .parameters = {{"--energies", "1e-3,1e-2,0.05:1.95:39,2.02,2.05:2.95:19,3:8:26", "energies E, in m g l"},
                       {"--gaps", "1e-2:1e-10:17log,-1e-2:-1e-10:17log", "energies as 2 - E"},
                       {"--orders", "5,10,20,40,80", "N, last power of the series; last index of the resummed series"},
                       {"--step", "1e-5", "dt of the Runge-Kutta integration at E = 2, dimensionless time"},
                       {"--scalar", "ball:50, and double, long-double, quad for their floors", "arithmetic"}},
        .quick = {{"--energies", "1.71,2.02", ""}, {"--orders", "6", ""}, {"--step", "1e-3", ""}},
        .seconds = 9,
        .excluded =
            no_answer_at_limits("the series is the constant 0", "the series is not defined: the period is infinite"),
        .plan = plan,
        .offers = arithmetics::proved_too,
        .any_equation = equation_form{
            .title = "Error of the series and of its approximants",
            .question =
                "How large is the error of the series about the start, and of what is made of it, on an interval?",
            .reading =
                "The largest error at the times over the order N of the list: of the partial sum, of the Pade "
                "approximant of the same coefficients, and of the endpoint approximant, which also has the value and "
                "the slope of the solution at the far end. Behind the marks the line of the rate reach/R with the "
                "radius that the coefficients show. The solution is marched by Taylor series in two precisions; with "
                "--scalar ball:D it is enclosed, and the norms of series and approximants are proved.",
            .parameters = {{"--times", "", "the interval, as times at which the error is taken"},
                           {"--orders", "5:60:12", "N, last power of the list"},
                           {"--scalar", "mpfr:20", "arithmetic of the approximation"}},
            .example = {"blasius", {}},
            .example_words = {{"--times", "0:3:61"}, {"--orders", "5:60:12"}},
            .quick = {{"--times", "0:3:7"}, {"--orders", "6,12"}},
            .seconds = 1}};
    return result;
}

}  // namespace libration::studies
