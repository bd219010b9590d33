// Which radius test finds the radius of convergence of any equation with the fewest coefficients?
#include <algorithm>
#include <map>
#include <optional>

#include "list_answers.hpp"

namespace libration::studies::of_equation {

namespace radius_tournament_of_equation {

namespace {

struct judged_row {
    answered_list of;
    std::optional<mpfr> difference;
    std::string unknown;
};

const column_list<judged_row>& columns() {
    using row = judged_row;
    static const column_list<row> all{
        {"order", "N, last power of the list", [](const row& r) { return r.of.order; }},
        {"method", "verdict, or the radius test", [](const row& r) { return r.of.method; }},
        {"radius", "its answer; empty where it has none",
         [](const row& r) { return decimal_cell(r.of.found.radius, r.of.found.digits); }},
        {"uncertainty", "that it gives: an estimate, not a bound",
         [](const row& r) { return r.of.found.radius ? decimal_cell(r.of.found.of.uncertainty, 3) : cell(); }},
        {"difference",
         "|radius/R - 1|, R the verdict on the reference list; empty without one: where nobody knows the radius, this "
         "measures agreement and not truth",
         [](const row& r) { return decimal_cell(r.difference, 6); }},
        {"log10_difference", "log10 of difference", [](const row& r) { return log10_cell(r.difference); }},
        {"note", "which test decided, or why there is no radius",
         [](const row& r) { return without_commas(r.of.found.of.note); }},
        unknown_column<row>(),
    };
    return all;
}

// A list half as long again as the longest that is judged, with as many digits more.
struct reference_list {
    int order;
    scalar_spec scalar;
};

reference_list reference_for(const std::vector<int>& orders, const scalar_spec& scalar) {
    return {orders.back() * 3 / 2, {scalar_kind::arbitrary, scalar.digits + 20}};
}

std::vector<table> tables_at(const equation_sweep& sweep, std::size_t i, const std::vector<int>& orders,
                             const scalar_spec& scalar) {
    const reference_list longer = reference_for(orders, scalar);
    const precision_scope scope(longer.scalar.digits + guard_of_lists);
    const auto lists = lists_about_start(sweep.system(i), longer.order, longer.scalar.digits + guard_of_lists);
    std::map<std::string, std::optional<mpfr>> reference;
    for (const auto& each : answers_to(lists, sweep, {longer.order}, longer.scalar, is_verdict)) {
        reference[each.unknown] = each.found.radius;
    }
    std::vector<judged_row> rows;
    for (auto& each : answers_to(lists, sweep, orders, scalar, [](const std::string&) { return true; })) {
        const auto& truth = reference[each.unknown];
        const auto difference = each.found.radius && truth ? std::optional(mpfr(abs(*each.found.radius / *truth - 1)))
                                                           : std::optional<mpfr>();
        const std::string unknown = each.unknown;
        rows.push_back({std::move(each), difference, unknown});
    }
    return {make_table(columns(), rows)};
}

study_plan plan(const shared_problem& problem, const study_request& request) {
    const auto sweep = sweep_of(problem, request);
    const auto orders = orders_from(request, least_order_of_lists, "is too short a list for a radius test");
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:30"));
    return plan_by_parameters({head_of(*sweep, "", scalar, columns())}, sweep,
                              [sweep, orders, scalar](std::size_t i) { return tables_at(*sweep, i, orders, scalar); });
}

}  // namespace
}  // namespace radius_tournament_of_equation

const equation_study& radius_tournament() {
    using namespace radius_tournament_of_equation;
    static const equation_study result{
        .name = "radius_tournament",
        .title = "The radius tests",
        .question = "Which radius test settles with the fewest coefficients?",
        .reading =
            "What every test says of the first N coefficients, as its relative difference from the verdict on a list "
            "half as long again with more digits. Nobody has proved that radius: the plot shows which tests agree with "
            "what all of them say later, and how soon.",
        .parameters = {{"--orders", "10:100:10", "N, last powers of the lists judged"},
                       {"--scalar", "mpfr:30", "arithmetic of the lists that are judged"}},
        .example = {"rayleigh", {}},
        .example_words = {},
        .quick = {{"--orders", "12,20"}},
        .seconds = 1,
        .plan = plan};
    return result;
}

}  // namespace libration::studies::of_equation
