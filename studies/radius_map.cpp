// Can an unknown radius, and with it the optimal expansion point, be deduced from coefficients? [paper sec:conclusions]
#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "shared/list_answers.hpp"
#include "shared/sweep_plan.hpp"

namespace libration::studies {

namespace radius_map_study {

namespace of_pendulum {

using namespace convergence;
using namespace pendulum;

namespace {

// A verdict with its position compared with the exact one.
struct map_row {
    answered_list of;
    expansion_coverage<mpfr> cover;
    std::optional<mpfr> position_error;
};

map_row row_of(const answered_list& verdict) {
    const auto cover = coverage_from<mpfr>(motion::of_energy(verdict.at->value), verdict.point->coefficient);
    const auto& position = verdict.found.position;
    if (!position) {
        return {verdict, cover, std::nullopt};
    }
    return {verdict, cover,
            mpfr(modulus_of(*position - nearest_on_arc(cover, verdict.point->coefficient)) / cover.radius)};
}

const column_list<map_row>& columns() {
    using row = map_row;
    const column_list<row> own{
        {"position_error", "its distance from (1-x) T* + i K~', over R",
         [](const row& r) { return decimal_cell(r.position_error, digits_of_errors); }},
        {"log10_position_error", "log10 of position_error", [](const row& r) { return log10_cell(r.position_error); }},
        {"rate", "max(x, 1-x) T*/radius: factor of the error on [0, T*] a power",
         [](const row& r) {
             const auto& radius = r.of.found.radius;
             return radius ? decimal_cell(mpfr(r.cover.reach / *radius), r.of.digits) : cell();
         }},
        {"tstar", "T*, dimensionless",
         [](const row& r) { return decimal_cell(r.cover.effective_period, r.of.digits); }},
        {"height", "K~', dimensionless", [](const row& r) { return decimal_cell(r.cover.height, r.of.digits); }},
    };
    static const auto all = columns_named(
        "energy,point,order,radius,uncertainty,exact,relative_error,log10_relative_error,log10_relative_uncertainty,"
        "position_re,position_im,position_error,log10_position_error,kind,count,rate,tstar,height,gap,log10_gap,note,"
        "energy_typed,gap_typed",
        joined(own, columns_within(answer_columns_of_pendulum(), &row::of)));
    return all;
}

// A row of the first table as needed for the second: the printed numbers, which are all the digits of the verdicts.
struct seen_point {
    const table_row_cells* cells;
    mpfr exact_radius, exact_rate;
    std::optional<mpfr> radius, rate;
};

std::size_t place_of(const std::string& name) {
    const auto& all = columns();
    return static_cast<std::size_t>(
        std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.name == name; }) - all.begin());
}

std::optional<mpfr> number_in(const table_row_cells& cells, const std::string& name) {
    const cell& found = cells[place_of(name)];
    return found.is_empty() ? std::nullopt : std::optional(from_exact<mpfr>(read_exact(found.text())));
}

seen_point seen_in(const table_row_cells& cells) {
    const mpfr x = *number_in(cells, "point");
    const mpfr reach = (x > 1 - x ? x : mpfr(1 - x)) * *number_in(cells, "tstar");
    const mpfr radius = *number_in(cells, "exact");
    return {&cells, radius, mpfr(reach / radius), number_in(cells, "radius"), number_in(cells, "rate")};
}

// The best points by the estimates, if there are any, and by the exact radii.
struct optimum_row {
    const table_row_cells* any;
    std::size_t seen;
    const table_row_cells* widest;
    const table_row_cells* fastest;
    const table_row_cells* exactly_widest;
    const table_row_cells* exactly_fastest;
};

// The cell of a column of the first table, in one of the rows referenced by an optimum.
column_of<optimum_row> taken(std::string name, std::string meaning, const table_row_cells* optimum_row::*from,
                             const std::string& column) {
    return {std::move(name), std::move(meaning), [from, place = place_of(column)](const optimum_row& r) {
                return r.*from != nullptr ? (*(r.*from))[place] : cell();
            }};
}

const column_list<optimum_row>& optimum_columns() {
    using row = optimum_row;
    static const column_list<row> all{
        taken("energy", "E, in units of m g l", &row::any, "energy"),
        taken("order", "N, last power of t of the lists", &row::any, "order"),
        {"points", "points whose list gave a radius", [](const row& r) { return r.seen; }},
        taken("largest_radius_point", "fraction of T* about which the estimated radius is largest", &row::widest,
              "point"),
        taken("largest_radius", "estimated there, dimensionless time", &row::widest, "radius"),
        taken("exact_largest_radius_point",
              "the same by the exact radii of these points; of all points it is 0, the top", &row::exactly_widest,
              "point"),
        taken("least_rate_point", "fraction of T* about which the estimated max(x, 1-x) T*/R is least", &row::fastest,
              "point"),
        taken("least_rate", "estimated there", &row::fastest, "rate"),
        taken("exact_least_rate_point", "the same by the exact radii of these points; of all points it is 1/2",
              &row::exactly_fastest, "point"),
        taken("gap", "2 - E", &row::any, "gap"),
        taken("energy_typed", "E as typed", &row::any, "energy_typed"),
        taken("gap_typed", "2 - E as typed", &row::any, "gap_typed"),
    };
    return all;
}

// The points of largest radius and of least rate, estimated and exact, of one energy and order.
optimum_row optimum_of(const std::vector<seen_point>& points) {
    const auto best = [&](const auto& usable, const auto& better) {
        const seen_point* found = nullptr;
        for (const seen_point& each : points) {
            if (usable(each) && (found == nullptr || better(each, *found))) {
                found = &each;
            }
        }
        return found != nullptr ? found->cells : nullptr;
    };
    const auto any = [](const seen_point&) { return true; };
    const auto answered = [](const seen_point& each) { return each.radius.has_value(); };
    return {points.front().cells,
            static_cast<std::size_t>(std::count_if(points.begin(), points.end(), answered)),
            best(answered, [](const auto& a, const auto& b) { return *a.radius > *b.radius; }),
            best(answered, [](const auto& a, const auto& b) { return *a.rate < *b.rate; }),
            best(any, [](const auto& a, const auto& b) { return a.exact_radius > b.exact_radius; }),
            best(any, [](const auto& a, const auto& b) { return a.exact_rate < b.exact_rate; })};
}

// Computes the second table from the first.
void derive_optimum(std::vector<study_table>& tables) {
    const precision_scope scope(tables[0].scalar.digits + guard_of_lists);
    const auto& rows = tables[0].data.rows();
    const std::array<std::size_t, 4> of_energy{place_of("energy"), place_of("gap"), place_of("energy_typed"),
                                               place_of("gap_typed")};
    const std::size_t order = place_of("order");
    std::vector<optimum_row> optimum;
    for (std::size_t first = 0, last = 0; first < rows.size(); first = last) {
        const auto same_energy = [&](const table_row_cells& row) {
            return std::all_of(of_energy.begin(), of_energy.end(),
                               [&](std::size_t place) { return row[place] == rows[first][place]; });
        };
        std::map<long, std::vector<seen_point>> by_order;
        for (last = first; last < rows.size() && same_energy(rows[last]); ++last) {
            by_order[std::stol(rows[last][order].text())].push_back(seen_in(rows[last]));
        }
        for (const auto& [number, points] : by_order) {
            optimum.push_back(optimum_of(points));
        }
    }
    tables[1].data = make_table(optimum_columns(), optimum);
}

// The rows of one point at one energy.
table rows_about(const sweep_energy& at, const exact& point, const std::vector<int>& orders,
                 const scalar_spec& scalar) {
    const precision_scope scope(scalar.digits + guard_of_lists);
    std::vector<map_row> map;
    for (const answered_list& each : judged_answers(at, point, orders, scalar, is_verdict)) {
        map.push_back(row_of(each));
    }
    return make_table(columns(), map);
}

study_plan plan(const study_request& request) {
    const auto sweep = sweep_of(request);
    const std::vector<int> orders = orders_from(request, least_order_of_lists, "is too short a list for a radius test");
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:30"));
    const std::size_t points = sweep->points.size();
    // A cell per order; those about one point share one list.
    study_plan plan = plan_of_values(
        {head_of("", scalar, columns()), head_of("optimum", scalar, optimum_columns())},
        {"energy", "gap", "point", "order"}, sweep->energies.size() * points,
        [sweep, points](std::size_t i) {
            return with_input(inputs_of(sweep->energies[i / points]), "point", sweep->points[i % points].text);
        },
        orders,
        [sweep, points, scalar](std::size_t i, const std::vector<int>& chosen) {
            return std::vector<table>{
                rows_about(sweep->energies[i / points], sweep->points[i % points], chosen, scalar)};
        });
    plan.derive = derive_optimum;
    return plan;
}

}  // namespace
}  // namespace of_pendulum

namespace of_equation {

namespace {

const column_list<answered_list>& columns() {
    static const auto all = joined(joined(columns_named("order", answer_columns()), result_columns()),
                                   columns_named("unknown", answer_columns()));
    return all;
}

study_plan plan(const study_request& request) {
    const auto sweep = equation_sweep_of(request);
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
}  // namespace of_equation
}  // namespace radius_map_study

const study& radius_map() {
    using namespace radius_map_study;
    static const study result{
        .name = "radius_map",
        .title = "The optimal expansion point from coefficients",
        .question = "Can the radius of convergence, and the optimal expansion point, be deduced from N coefficients?",
        .reading =
            "Left: the radius of convergence over the expansion point, in units of T*; middle: the factor by which a "
            "power reduces the error on the whole way [0, T*]; lines are exact, marks are the verdicts of the radius "
            "tests, which see N coefficients and not the pendulum. Right: the relative error of these verdicts. From "
            "N = 20 the marks lie on their lines to the eye, but next to the top some lists are too short for a "
            "verdict, and for E near 2, where the second column of singularities is hardly further than the first, a "
            "verdict is wrong by a tenth. From N = 60 all have 19 digits and most have all 30. So the optimal "
            "expansion point can be deduced numerically: the largest estimated radius is at the top and the least "
            "estimated rate half way at every energy from N = 60 (second table; from N = 20 the top is missed, where "
            "every second coefficient is 0 and the ten that are left give no verdict).",
        .of = &pendulum_problem(),
        .parameters = {{"--energies", "0.5,1,1.71,1.9998,2.02,3", "energies E, in m g l"},
                       {"--gaps", "", "energies as 2 - E"},
                       {"--points", "0:1:21", "expansion points, fractions of T*: 0 the top, 1 the bottom"},
                       {"--orders", "20,60", "N, last powers of the lists under test"},
                       {"--scalar", "mpfr:30", "arithmetic of the lists under test"}},
        .quick = {{"--energies", "1,2.02", ""}, {"--orders", "12", ""}, {"--points", "0,1/2,1", ""}},
        .seconds = 4,
        .excluded = no_answer_at_limits("theta is constant and every radius infinite", "T* is infinite"),
        .plan = of_pendulum::plan,
        .version = 3,
        .any_equation = equation_form{
            .plan = of_equation::plan,
            .title = "The radius of convergence over the parameters",
            .question = "How does the radius of convergence depend on the parameters and the start of an equation?",
            .reading = "The radius that radius tests read from N coefficients about the start, and how certain they "
                       "are of it, over one parameter, or over the plane of two. Where the nearest singularities "
                       "change places the radius has a corner, and near it the tests are least certain.",
            .parameters = {{"--orders", "100", "N, last powers of the lists under test"},
                           {"--scalar", "mpfr:30", "arithmetic of the lists under test"}},
            .example = {"sir", {"r=0.01:0.05:9"}},
            .quick = {{"--orders", "20,30"}},
            .seconds = 2}};
    return result;
}

}  // namespace libration::studies
