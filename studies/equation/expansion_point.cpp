// About which time of an interval should the solution of any equation be expanded?
#include <algorithm>

#include "list_answers.hpp"

namespace libration::studies::of_equation {

namespace expansion_point_of_equation {

namespace {

struct point_row {
    const exact& time;
    mpfr reach;
    answered_list of;
    std::string unknown;
};

const column_list<point_row>& columns() {
    using row = point_row;
    static const column_list<row> all{
        {"time", "expansion point, in the unit of the variable",
         [](const row& r) { return number_cell(decimal_of(r.time, 50)); }},
        {"order", "N, last power of the list about it", [](const row& r) { return r.of.order; }},
        {"radius", "estimated radius of convergence about it; empty where there is none",
         [](const row& r) { return decimal_cell(r.of.found.radius, r.of.found.digits); }},
        {"uncertainty", "that the tests give: an estimate, not a bound",
         [](const row& r) { return r.of.found.radius ? decimal_cell(r.of.found.of.uncertainty, 3) : cell(); }},
        {"position_re", "Re of a nearest singularity, as a time",
         [](const row& r) {
             const auto& position = r.of.found.of.position;
             return position ? decimal_cell(mpfr(from_exact<mpfr>(r.time) + position->re), r.of.found.digits) : cell();
         }},
        {"position_im", "Im of it",
         [](const row& r) {
             const auto& position = r.of.found.of.position;
             return position ? decimal_cell(position->im, r.of.found.digits) : cell();
         }},
        {"reach", "distance of the farther end of the times", [](const row& r) { return decimal_cell(r.reach, 12); }},
        {"rate", "reach/radius: factor of the error on all times a power; above 1 it diverges",
         [](const row& r) {
             return r.of.found.radius ? decimal_cell(mpfr(r.reach / *r.of.found.radius), 12) : cell();
         }},
        {"note", "which test decided, or why there is no radius",
         [](const row& r) { return without_commas(r.of.found.of.note); }},
        unknown_column<row>(),
    };
    return all;
}

table rows_about(const equation_sweep& sweep, std::size_t i, const std::vector<exact>& times, std::size_t point,
                 const std::vector<int>& orders, const scalar_spec& scalar) {
    const precision_scope scope(scalar.digits + guard_of_lists);
    const exact& time = times[point];
    const auto lists = lists_of_problem({sweep.system(i), 0, orders.back(), time.text}, scalar.digits + guard_of_lists);
    const auto distance = [&](const exact& end) {
        return mpfr(abs(mpfr(from_exact<mpfr>(end) - from_exact<mpfr>(time))));
    };
    const mpfr reach = std::max(distance(times.front()), distance(times.back()));
    std::vector<point_row> rows;
    for (auto& each : answers_to(lists, sweep, orders, scalar, is_verdict)) {
        const std::string unknown = each.unknown;
        rows.push_back({time, reach, std::move(each), unknown});
    }
    return make_table(columns(), rows);
}

study_plan plan(const shared_problem& problem, const study_request& request) {
    const auto sweep = sweep_of(problem, request);
    times_of(request, 2);
    const auto times = request.values.of("time");
    const auto orders = orders_from(request, least_order_of_lists, "is too short a list for a radius test");
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:30"));
    const std::size_t points = times.size();
    return plan_of_cells(
        {head_of(*sweep, "", scalar, columns())}, sweep->axes({"time"}), sweep->size() * points,
        [sweep, times, points](std::size_t i) {
            cell_inputs inputs = with_input(sweep->inputs(i / points), "time", times[i % points].text);
            // The reach of a point follows from the ends.
            inputs = with_input(std::move(inputs), "first", times.front().text);
            return with_input(std::move(inputs), "last", times.back().text);
        },
        [sweep, times, points, orders, scalar](std::size_t i) {
            return std::vector<table>{
                sweep->framed(i / points, rows_about(*sweep, i / points, times, i % points, orders, scalar))};
        });
}

}  // namespace
}  // namespace expansion_point_of_equation

const equation_study& expansion_point() {
    using namespace expansion_point_of_equation;
    static const equation_study result{
        .name = "expansion_point",
        .title = "Where to expand",
        .question = "About which time of an interval should the solution be expanded?",
        .reading =
            "Left: the radius of convergence about each time, from coefficients there; the solution is marched to it. "
            "Middle: how far from the real times the singularity is that limits it, as the tests see it. "
            "Right: the factor by which one more power reduces the error on the whole interval. Below 1, the line, a "
            "single series covers it; the best point is where the factor is least.",
        .parameters = {{"--times", "", "expansion points; the first and the last are the ends of the interval"},
                       {"--orders", "80", "N, last powers of the lists judged"},
                       {"--scalar", "mpfr:30", "arithmetic of the lists that are judged"}},
        .example = {"blasius", {}},
        .example_words = {{"--times", "0:6:25"}},
        .quick = {{"--times", "0:2:3"}, {"--orders", "20"}},
        .seconds = 2,
        .plan = plan};
    return result;
}

}  // namespace libration::studies::of_equation
