// Can an unknown radius, and with it the optimal expansion point, be deduced from coefficients? [paper sec:conclusions]
#include <algorithm>
#include <optional>

#include "radius_cells.hpp"
#include "run/parallel.hpp"

namespace libration::studies {

namespace radius_map_study {

using namespace convergence;
using namespace pendulum;

namespace {

constexpr int least_order = 4;

// The verdict on one list against what is exact, all in a precision that holds more digits than the verdict.
struct judged_point {
    const exact& point;
    expansion_coverage<mpfr> cover;
    radius_estimate<mpfr> found;
};

// The verdicts about one point from each order.
std::vector<judged_point> judged_about(const motion& m, const exact& point, const std::vector<int>& orders,
                                       const scalar_spec& scalar) {
    std::vector<judged_point> all;
    all.reserve(orders.size());
    with_scalar(scalar, 0, [&]<class T>() {
        const auto list = series_on_arc<T>(m, point.coefficient, orders.back(), hidden_unit());
        for (const int order : orders) {
            const auto verdict = in_unit(report_on_radius(cut(list.scaled, order), epsilon<T>()).verdict, list.unit);
            const precision_scope judging(scalar.digits + digits_for_judging);
            all.push_back({point, coverage_from<mpfr>(m, point.coefficient), widened(verdict)});
        }
    });
    return all;
}

// A verdict with its place against the truth.
struct map_row {
    const sweep_energy& at;
    const exact& point;
    long digits;
    int order;
    judged_radius judged;
    radius_estimate<mpfr> found;
    expansion_coverage<mpfr> cover;
    std::optional<mpfr> position_error;
};

map_row row_of(const sweep_energy& at, int order, const judged_point& p, long digits) {
    std::optional<mpfr> error;
    if (p.found.position) {
        error = modulus_of(*p.found.position - nearest_on_arc(p.cover, p.point.coefficient)) / p.cover.radius;
    }
    return {at, p.point, digits, order, against_exact(p.found, p.cover.radius, digits), p.found, p.cover, error};
}

column_list<map_row> place_columns() {
    using row = map_row;
    return {
        {"position_re", "Re of the estimated nearest singularity, from the point, dimensionless time",
         [](const row& r) { return r.found.position ? decimal_cell(r.found.position->re, r.digits) : cell(); }},
        {"position_im", "Im of it",
         [](const row& r) { return r.found.position ? decimal_cell(r.found.position->im, r.digits) : cell(); }},
        {"position_error", "its distance from (1-x) T* + i K~', over R",
         [](const row& r) { return decimal_cell(r.position_error, digits_of_errors); }},
        {"log10_position_error", "log10 of position_error", [](const row& r) { return log10_cell(r.position_error); }},
        {"kind", "of the singularity by the verdict: logarithm is right",
         [](const row& r) { return r.found.radius ? cell(name_of(r.found.kind)) : cell(); }},
        {"count", "singularities on the circle by the verdict: 4 about the top and 2 elsewhere is right",
         [](const row& r) { return r.found.radius ? cell(r.found.count) : cell(); }},
        {"rate", "max(x, 1-x) T*/radius: factor of the error on [0, T*] a power",
         [](const row& r) {
             return r.found.radius ? decimal_cell(mpfr(r.cover.reach / *r.found.radius), r.digits) : cell();
         }},
        {"tstar", "T*, dimensionless", [](const row& r) { return decimal_cell(r.cover.effective_period, r.digits); }},
        {"height", "K~', dimensionless", [](const row& r) { return decimal_cell(r.cover.height, r.digits); }},
        gap_column<row>(),
        log10_gap_column<row>(),
        {"note", "which test decided, or why there is no radius", [](const row& r) { return r.found.note; }}};
}

const column_list<map_row>& columns() {
    using row = map_row;
    static const auto all = with_typed_energy<row>(
        joined(joined<row>({energy_column<row>(),
                            point_column<row>(),
                            {"order", "N, last power of t of the list", [](const row& r) { return r.order; }}},
                           columns_within(radius_columns(), &row::judged)),
               place_columns()));
    return all;
}

// The best points by the estimates, where there are any, and by the exact radii.
struct optimum_row {
    const sweep_energy& at;
    long digits;
    int order;
    std::size_t seen;
    const judged_point* widest;
    const judged_point* fastest;
    const exact& exactly_widest;
    const exact& exactly_fastest;
};

const column_list<optimum_row>& optimum_columns() {
    using row = optimum_row;
    static const auto all = with_typed_energy<row>({
        energy_column<row>(),
        {"order", "N, last power of t of the lists", [](const row& r) { return r.order; }},
        {"points", "points whose list gave a radius", [](const row& r) { return r.seen; }},
        {"largest_radius_point", "fraction of T* about which the estimated radius is largest",
         [](const row& r) { return r.widest != nullptr ? read_cell(r.widest->point.text) : cell(); }},
        {"largest_radius", "estimated there, dimensionless time",
         [](const row& r) { return r.widest != nullptr ? decimal_cell(r.widest->found.radius, r.digits) : cell(); }},
        {"exact_largest_radius_point", "the same by the exact radii of these points; of all points it is 0, the top",
         [](const row& r) { return read_cell(r.exactly_widest.text); }},
        {"least_rate_point", "fraction of T* about which the estimated max(x, 1-x) T*/R is least",
         [](const row& r) { return r.fastest != nullptr ? read_cell(r.fastest->point.text) : cell(); }},
        {"least_rate", "estimated there",
         [](const row& r) {
             return r.fastest != nullptr
                        ? decimal_cell(mpfr(r.fastest->cover.reach / *r.fastest->found.radius), r.digits)
                        : cell();
         }},
        {"exact_least_rate_point", "the same by the exact radii of these points; of all points it is 1/2",
         [](const row& r) { return read_cell(r.exactly_fastest.text); }},
        gap_column<row>(),
    });
    return all;
}

// The points of largest radius and of least rate, estimated and exact, for one order.
optimum_row optimum_of(const sweep_energy& at, int order, const std::vector<judged_point>& points, long digits) {
    const auto by_radius = [](const auto& a, const auto& b) { return a.cover.radius < b.cover.radius; };
    const auto by_rate = [](const auto& a, const auto& b) {
        return a.cover.convergence_rate < b.cover.convergence_rate;
    };
    const exact& exactly_widest = std::max_element(points.begin(), points.end(), by_radius)->point;
    const exact& exactly_fastest = std::min_element(points.begin(), points.end(), by_rate)->point;
    std::vector<const judged_point*> seen;
    seen.reserve(points.size());
    for (const judged_point& p : points) {
        if (p.found.radius) {
            seen.push_back(&p);
        }
    }
    if (seen.empty()) {
        return {at, digits, order, 0, nullptr, nullptr, exactly_widest, exactly_fastest};
    }
    const auto best = [&](const auto& better) { return *std::min_element(seen.begin(), seen.end(), better); };
    const auto* widest = best([](auto* a, auto* b) { return *a->found.radius > *b->found.radius; });
    const auto* fastest =
        best([](auto* a, auto* b) { return a->cover.reach * *b->found.radius < b->cover.reach * *a->found.radius; });
    return {at, digits, order, seen.size(), widest, fastest, exactly_widest, exactly_fastest};
}

// Both tables of one energy.
std::vector<table> rows_at(const sweep_energy& at, const std::vector<exact>& points, const std::vector<int>& orders,
                           const scalar_spec& scalar) {
    const precision_scope scope(scalar.digits + digits_for_judging);
    const motion m = motion::of_energy(at.value);
    std::vector<std::vector<judged_point>> by_order(orders.size());
    std::vector<map_row> map;
    std::vector<optimum_row> optimum;
    for (const exact& point : points) {
        const auto judged = judged_about(m, point, orders, scalar);
        for (std::size_t i = 0; i < orders.size(); ++i) {
            map.push_back(row_of(at, orders[i], judged[i], scalar.digits));
            by_order[i].push_back(judged[i]);
        }
    }
    for (std::size_t i = 0; i < orders.size(); ++i) {
        optimum.push_back(optimum_of(at, orders[i], by_order[i], scalar.digits));
    }
    return {make_table(columns(), map), make_table(optimum_columns(), optimum)};
}

std::vector<study_table> run(const study_request& request) {
    const pendulum_sweep sweep(request.values);
    const std::vector<int> orders = sorted_orders(request, least_order, "is too short a list for a radius test");
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:30"));
    progress shown("radius_map, energies", sweep.energies.size(), request.shown);
    const auto tables = stacked(parallel_map(sweep.energies.size(), request.jobs, shown, [&](std::size_t i) {
        return rows_at(sweep.energies[i], sweep.points, orders, scalar);
    }));
    return {{"", scalar, tables[0]}, {"optimum", scalar, tables[1]}};
}

}  // namespace
}  // namespace radius_map_study

const study& radius_map() {
    using namespace radius_map_study;
    static const study result{
        .name = "radius_map",
        .title = "The optimal expansion point from coefficients",
        .label = "",
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
                       {"--orders", "20,60", "N, last powers of the lists judged"},
                       {"--scalar", "mpfr:30", "arithmetic of the lists that are judged"}},
        .quick = {{"--energies", "1,2.02", ""}, {"--orders", "12", ""}, {"--points", "0,1/2,1", ""}},
        .seconds = 7,
        .excluded = no_answer_at_limits("theta is constant and every radius infinite", "T* is infinite"),
        .run = run};
    return result;
}

}  // namespace libration::studies
