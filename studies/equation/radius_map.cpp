// How does the radius of convergence of the series of any equation depend on its parameters and starts?
#include <algorithm>

#include "list_answers.hpp"

namespace libration::studies::of_equation {

namespace radius_map_of_equation {

namespace {

const column_list<answered_list>& columns() {
    using row = answered_list;
    static const column_list<row> all =
        joined(joined<row>({{"order", "N, last power of the list", [](const row& r) { return r.order; }}},
                           columns_within(answer_columns(), &row::found)),
               {unknown_column<row>()});
    return all;
}

study_plan plan(const shared_problem& problem, const study_request& request) {
    const auto sweep = sweep_of(problem, request);
    const auto orders = orders_from(request, least_order_of_lists, "is too short a list for a radius test");
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:30"));
    return plan_by_numbers(
        {head_of(*sweep, "", scalar, columns())}, sweep, "order", orders,
        [sweep, scalar](std::size_t i, const std::vector<int>& chosen) {
            const precision_scope scope(scalar.digits + guard_of_lists);
            return std::vector<table>{make_table(columns(), verdicts_of(sweep->system(i), *sweep, chosen, scalar))};
        });
}

}  // namespace
}  // namespace radius_map_of_equation

const equation_study& radius_map() {
    using namespace radius_map_of_equation;
    static const equation_study result{
        .name = "radius_map",
        .title = "The radius of convergence over the parameters",
        .question = "How does the radius of convergence depend on the parameters and the start of an equation?",
        .reading =
            "The radius that radius tests read from N coefficients about the start, and how certain they are of it, "
            "over one parameter, or over the plane of two. Where the nearest singularities change places the radius "
            "has a corner, and near it the tests are least certain.",
        .parameters = {{"--orders", "100", "N, last powers of the lists judged"},
                       {"--scalar", "mpfr:30", "arithmetic of the lists that are judged"}},
        .example = {"sir", {"r=0.01:0.05:9"}},
        .example_words = {},
        .quick = {{"--orders", "20,30"}},
        .seconds = 2,
        .plan = plan};
    return result;
}

}  // namespace libration::studies::of_equation
