// How large is the error of the series of any equation, and of what is made of it, on an interval?
#include <utility>

#include "proved_norms.hpp"
#include "radius_on_interval.hpp"

namespace libration::studies::of_equation {

namespace error_norm_of_equation {

namespace {

// A norm as it is printed; empty where there is no such approximant.
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
         "not "
         "decided: no precision tells it from 0, as where the approximation is the solution",
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

study_plan plan(const shared_problem& problem, const study_request& request) {
    const question asked{sweep_of(problem, request), times_of(request, 2), request.values.of("time"),
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
}  // namespace error_norm_of_equation

const equation_study& error_norm() {
    using namespace error_norm_of_equation;
    static const equation_study result{
        .name = "error_norm",
        .title = "Error of the series and of its approximants",
        .question = "How large is the error of the series about the start, and of what is made of it, on an interval?",
        .reading =
            "The largest error at the times over the order N of the list: of the partial sum, of the Pade approximant "
            "of the same coefficients, and of the endpoint approximant, which also has the value and the slope of the "
            "solution at the far end. Behind the marks the line of the rate reach/R with the radius that the "
            "coefficients show. The solution is marched by Taylor series in two precisions; with --scalar ball:D it is "
            "enclosed, and the norms of series and approximants are proved.",
        .parameters = {{"--times", "", "the interval, as times at which the error is taken"},
                       {"--orders", "5:60:12", "N, last power of the list"},
                       {"--scalar", "mpfr:20", "arithmetic of the approximation"}},
        .example = {"blasius", {}},
        .example_words = {{"--times", "0:3:61"}, {"--orders", "5:60:12"}},
        .quick = {{"--times", "0:3:7"}, {"--orders", "6,12"}},
        .seconds = 1,
        .plan = plan,
        .offers = arithmetics::proved_too};
    return result;
}

}  // namespace libration::studies::of_equation
