// How large is the error of the series and of its resummation on [0, T*] at each energy and order? [paper fig:error]
#include <algorithm>
#include <utility>

#include "error_norm_at_infinity.hpp"
#include "libration/digits/proved_decimals.hpp"
#include "libration/pendulum/error_norm.hpp"
#include "libration/pendulum/proved_norm.hpp"
#include "printed_norm.hpp"
#include "separatrix_baseline.hpp"
#include "shared/proved_norms.hpp"
#include "shared/radius_on_interval.hpp"
#include "shared/sweep_plan.hpp"

namespace libration::studies {

namespace error_norm_study {

namespace {

// Those of --scalar, the most precise first; without --scalar `usual`.
std::vector<scalar_spec> scalars_of(const study_request& request, std::vector<scalar_spec> usual) {
    if (!request.scalar) {
        return usual;
    }
    std::vector<scalar_spec> scalars{*request.scalar};
    scalars.insert(scalars.end(), request.further_scalars.begin(), request.further_scalars.end());
    return scalars;
}

}  // namespace

namespace of_pendulum {

using namespace elliptic;
using namespace pendulum;

namespace {

constexpr long guard_digits = 15;

// One requested norm.
struct asked_norm {
    int order;
    arc_method method;
};

std::vector<asked_norm> norms_for(const std::vector<int>& orders) {
    std::vector<asked_norm> norms;
    for (const int order : orders) {
        norms.insert(norms.end(), {{order, arc_method::series}, {order, arc_method::resummed}});
    }
    return norms;
}

// The bounds hold if the first omitted power is at least 4, and from N = 1.
std::optional<mpfr> bound_of(const top_bounds<mpfr>& bounds, const asked_norm& of) {
    if (of.method == arc_method::series) {
        return bounds.first_omitted(of.order) >= 4 ? std::optional(bounds.series_norm(of.order)) : std::nullopt;
    }
    return of.order >= 1 ? std::optional(bounds.resummation_norm(of.order)) : std::nullopt;
}

norm_row row_of(const sweep_energy& at, const asked_norm& of, const top_bounds<mpfr>& bounds, const scalar_spec& scalar,
                cell norm, cell time, const char* rigour) {
    const cell log10_norm = log10_cell(from_exact<mpfr>(read_exact(norm.text())));
    return {.order = of.order,
            .method = std::string(name_of(of.method)),
            .scalar = scalar,
            .norm = std::move(norm),
            .time = std::move(time),
            .log10_norm = log10_norm,
            .rigour = rigour,
            .bound = bound_of(bounds, of),
            .at = &at};
}

// Whether the second route gives the same norm to the printed digits.
bool confirmed(const arc_errors& errors, const asked_norm& of, const norm_at<mpfr>& found, long digits) {
    const mpfr other = errors.second_opinion(of.method, of.order, found.place);
    return abs(found.norm - other) <= found.norm * pow(mpfr(10), static_cast<int>(-digits));
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
    const std::vector<asked_norm> asked = norms_for(orders);
    std::vector<cell> times;
    const auto norms = proved_decimals(scalar.digits, [&] {
        const precision_scope wider(working_digits() + below);
        const proved_arc_errors errors(at.value);
        times.clear();
        std::vector<ball> values;
        values.reserve(asked.size());
        for (const asked_norm& each : asked) {
            proved_maximum found = errors.norm(each.method, each.order);
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
    rows.reserve(asked.size());
    for (std::size_t i = 0; i < asked.size(); ++i) {
        rows.push_back(
            row_of(at, asked[i], bounds, scalar, cell::number(norms[i].text, scalar.digits), times[i], "proved"));
    }
    return make_table(columns_of_pendulum(), rows);
}

// All rows of one energy in arithmetics that round, in one table for each scalar.
std::vector<table> rounded_rows_at(const sweep_energy& at, const std::vector<int>& orders,
                                   const std::vector<scalar_spec>& scalars) {
    const motion m = motion::of_energy(at.value);
    const long digits = std::ranges::max(scalars, {}, &scalar_spec::digits).digits;
    const long all_digits = digits + most_digits_below(m, orders) + guard_digits;
    const precision_scope scope(all_digits);
    arc_errors errors(m);
    std::vector<std::vector<norm_row>> rows(scalars.size());
    for (const asked_norm& here : norms_for(orders)) {
        norm_at<mpfr> found = errors.norm(here.method, here.order);
        const bool agreed = confirmed(errors, here, found, digits);
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
            rows[i].push_back(row_of(at, here, errors.bounds(), scalar, decimal_cell(norm.norm, scalar.digits),
                                     decimal_cell(mpfr(norm.place * errors.bounds().effective_period), scalar.digits),
                                     exact && agreed ? "two-method" : "heuristic"));
        }
    }
    std::vector<table> tables;
    for (const auto& in_scalar : rows) {
        tables.push_back(make_table(columns_of_pendulum(), in_scalar));
    }
    return tables;
}

// All rows of one energy, in one table for each scalar; balls come first.
std::vector<table> rows_at(const sweep_energy& at, const std::vector<int>& orders,
                           const std::vector<scalar_spec>& scalars) {
    std::vector<table> tables;
    std::vector<scalar_spec> rounding;
    for (const scalar_spec& scalar : scalars) {
        if (scalar.kind == scalar_kind::proved) {
            tables.push_back(proved_rows_at(at, orders, scalar));
        } else {
            rounding.push_back(scalar);
        }
    }
    if (!rounding.empty()) {
        const auto rounded = rounded_rows_at(at, orders, rounding);
        tables.insert(tables.end(), rounded.begin(), rounded.end());
    }
    return tables;
}

// The integration belongs to the paper's whole figure: a run in one scalar is one table.
std::vector<march> marches_for(const study_request& request) {
    const bool asked = !request.scalar && request.step().coefficient > 0;
    return asked ? marches_of(request.step().coefficient) : std::vector<march>();
}

// The energies first, each with its orders as cells, and then the integrations.
study_plan plan(const study_request& request) {
    const auto scalars = scalars_of(request, {read_scalar("ball:50", arithmetics::proved_too), read_scalar("double"),
                                              read_scalar("long-double"), read_scalar("quad")});
    const auto marches = marches_for(request);
    std::vector<study_table> tables;
    for (const scalar_spec& scalar : scalars) {
        const bool alone =
            request.scalar ? scalar.name() == request.scalar->name() : scalar.kind == scalar_kind::proved;
        tables.push_back(head_of(alone ? "" : scalar.name(), scalar, columns_of_pendulum()));
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

norm_row row_of(const question& asked, const found_norm& found) {
    const precision_scope scope(asked.scalar.digits + 20);
    norm_row row = asked.row(found.order, found.method, found.unknown);
    if (found.there) {
        row.norm = decimal_cell(found.norm, asked.scalar.digits);
        row.time = found.norm == 0 ? cell() : asked.time(found.place);
        row.log10_norm = log10_cell(found.norm);
        row.rigour = found.agreed ? "two-method" : "heuristic";
    }
    return row;
}

norm_row row_of(const question& asked, const proved_norm& found) {
    const precision_scope scope(asked.scalar.digits + 20);
    norm_row row = asked.row(found.order, found.method, found.unknown);
    if (found.there && found.norm) {
        row.norm = cell::number(found.norm->text, asked.scalar.digits);
        row.time = found.place ? asked.time(*found.place) : cell();
        row.log10_norm = log10_cell(mpfr(found.norm->text));
    }
    row.rigour = !found.there ? "" : found.norm ? "proved" : "not decided";
    return row;
}

table rows_at(const question& asked, std::size_t i, const std::vector<int>& orders) {
    const auto system = asked.sweep->system(i);
    const bool proved = asked.scalar.kind == scalar_kind::proved;
    asked_norms norms{system,
                      asked.times,
                      asked.sweep->unknowns(),
                      {approximation::series, approximation::pade, approximation::endpoint}};
    if (!proved) {  // their scale is the radius of a heuristic verdict
        norms.methods.insert(norms.methods.end(), {approximation::euler, approximation::gauge});
    }
    std::vector<norm_row> rows;
    const auto add = [&](const auto& all) {
        std::ranges::transform(all, std::back_inserter(rows), [&](const auto& each) { return row_of(asked, each); });
    };
    if (proved) {
        add(proved_norms(norms, orders, asked.scalar.digits));
    } else {
        add(norms_of(norms, orders, asked.scalar));
    }
    return make_table(columns_of_equation(), rows);
}

study_plan plan(const study_request& request) {
    if (!request.equation->limits.empty()) {
        return at_infinity::plan(request);
    }
    const auto sweep = equation_sweep_of(request);
    const auto times = times_of(request, 2);
    std::vector<study_table> tables;
    std::vector<question> asked;
    for (const scalar_spec& scalar : scalars_of(request, {read_scalar("mpfr:20")})) {
        asked.push_back({sweep, times, request.values.of("time"), scalar});
        tables.push_back(head_of(*sweep, tables.empty() ? "" : scalar.name(), scalar, columns_of_equation()));
    }
    const auto rows = [asked](std::size_t i, const std::vector<int>& orders) {
        std::vector<table> all;
        for (const question& each : asked) {
            all.push_back(rows_at(each, i, orders));
        }
        return all;
    };
    return with_radii(plan_by_numbers(std::move(tables), sweep, "order", orders_from(request, 0, ""), rows), sweep,
                      times);
}

}  // namespace
}  // namespace of_equation
}  // namespace error_norm_study

const study& error_norm() {
    using namespace error_norm_study;
    static const study result{
        .name = "error_norm",
        .title = "Error of the series and of its resummation",
        .label = "fig:error",
        .question = "How large is the error of the series and of its resummation on [0, T*], at each energy and order?",
        .reading =
            "Dashed: the series cut after the power N; solid: its resummation with the last index N, with a mark at "
            "each "
            "computed energy. The second figure has the bounds A and A2, which are proved for them, thin dotted; the "
            "third the same errors towards the separatrix. Where a curve has a dip, a coefficient that is left out "
            "passes through 0. The resummation gains a factor that grows like N^2, and both lose their rate as E goes "
            "to 2. The horizontal "
            "line is the paper's baseline, the Runge-Kutta march in double with its step against the closed solution "
            "at E = 2 on [0, 10]. It is {{the norm of error_norm_baseline where step=1e-5 scalar=double to 1}} for the "
            "step 1e-5, {{the norm_in_epsilon of error_norm_baseline where step=1e-5 scalar=double to 1}} units in the "
            "last place: neither the precision of the machine nor the truncation of the method, but the rounding of a "
            "million steps, which the separatrix multiplies by up to e^10 (the baseline table: "
            "{{the norm_without_growth of error_norm_baseline where step=1e-5 scalar=double to 1}} without that "
            "growth; in long double {{the norm of error_norm_baseline where step=1e-5 scalar=long-double to 1}} with "
            "it; {{the norm of error_norm_baseline where step=1e-4 scalar=double to 1}} with the step 1e-4). The "
            "fourth figure repeats the same norms in double, long double "
            "and quad: each falls to the rounding of its arithmetic and stays there.",
        .of = &pendulum_problem(),
        .parameters = {{"--energies", "1e-3,1e-2,0.02:1.98:99,2.02:2.98:49,3:8:51", "energies E, in m g l"},
                       {"--gaps", "1e-2:1e-10:25log,-1e-2:-1e-10:25log", "energies as 2 - E"},
                       {"--orders", "5,10,20,40,80", "N, last power of the series; last index of the resummed series"},
                       {"--step", "1e-5", "dt of the Runge-Kutta integration at E = 2, dimensionless time"},
                       {"--scalar", "ball:50, and double, long-double, quad for their floors", "arithmetic"}},
        .quick = {{"--energies", "1.71,2.02", ""}, {"--orders", "6", ""}, {"--step", "1e-3", ""}},
        .seconds = 18,
        .excluded =
            no_answer_at_limits("the series is the constant 0", "the series is not defined: the period is infinite"),
        .plan = of_pendulum::plan,
        .offers = arithmetics::proved_too,
        .several_scalars = true,
        .any_equation = equation_form{
            .plan = of_equation::plan,
            .title = "Error of the series and of its approximants",
            .question =
                "How large is the error of the series about the start, and of what is made of it, on an interval?",
            .reading =
                "The largest error at the times over the order N of the list: of the partial sum, of the Pade "
                "approximant of the same coefficients, of the endpoint approximant, which also has the value and the "
                "slope "
                "of the solution at the far end, and of the series in Euler's variable s/(s + R) and in the gauge "
                "function 1 - exp(-s/R), s the distance from the start and R the radius that the coefficients show. "
                "Behind the marks the line of the rate reach/R with the "
                "radius that the coefficients show. The solution is marched by Taylor series in two precisions; with "
                "--scalar ball:D it is enclosed, and the norms of series and approximants are proved. Of several "
                "arithmetics, separated by commas, the most precise has the lines, and the others have marks.",
            .parameters = {required_times(
                               "the interval, as times at which the error is taken; with conditions at "
                               "infinity in the text not required: up to where the solution has come to them"),
                           {"--orders", "5:60:12", "N, last power of the list"},
                           {"--scalar", "mpfr:20", "arithmetic of the approximation"}},
            .example = {"blasius", {}},
            .example_words = {{"--times", "0:3:61"}, {"--orders", "5:60:12"}},
            .quick = {{"--times", "0:3:7"}, {"--orders", "6,12"}},
            .seconds = 1,
            .at_infinity = true,
            .remarks = at_infinity::remarks}};
    return result;
}

}  // namespace libration::studies
