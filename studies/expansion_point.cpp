// About which point between the top and the bottom should the series be expanded? [paper sec:sing]
#include <algorithm>
#include <optional>
#include <string_view>

#include "libration/equation/text/parse.hpp"
#include "libration/pendulum/expansion_coverage.hpp"
#include "shared/list_answers.hpp"
#include "shared/sweep_columns.hpp"
#include "shared/sweep_plan.hpp"

namespace libration::studies {

namespace expansion_point_study {

namespace of_pendulum {

using namespace elliptic;
using namespace pendulum;

namespace {

constexpr long guard_digits = 15;
constexpr long digits_of_norms = 12;

std::string_view covers_text(int sign) { return sign > 0 ? "yes" : sign == 0 ? "boundary" : "no"; }

// The cover from one point; its lengths are computed in the scalar.
struct cover_row {
    const sweep_energy& at;
    const exact& point;
    const scalar_spec& scalar;
    mpfr radius, effective_period, rate, height;
    int covers;
    std::optional<mpfr> measured_rate;
};

const column_list<cover_row>& columns() {
    using row = cover_row;
    const auto length = [](mpfr row::*which) {
        return [which](const row& r) { return decimal_cell(r.*which, r.scalar.digits); };
    };
    static const auto all = with_typed_energy<row>({
        energy_column<row>(),
        point_column<row>(),
        {"radius", "radius of convergence R about it, dimensionless time", length(&row::radius)},
        {"tstar", "T*, dimensionless", length(&row::effective_period)},
        {"covers", "whether the circle of convergence holds both ends of [0, T*]: yes | boundary | no",
         [](const row& r) { return covers_text(r.covers); }},
        {"rate", "max(x, 1-x) T*/R: factor of the error on [0, T*] a power, by theory", length(&row::rate)},
        {"measured_rate", "the same from the norms of the first and the last order; empty with one order",
         [](const row& r) { return decimal_cell(r.measured_rate, digits_of_norms); }},
        {"height", "K~', imaginary part of the nearest singularity, dimensionless time", length(&row::height)},
        {"scalar", "arithmetic of radius, rate and series", [](const row& r) { return r.scalar.name(); }},
        gap_column<row>(),
    });
    return all;
}

struct norm_row {
    const sweep_energy& at;
    const exact& point;
    int order;
    mpfr norm;
};

const column_list<norm_row>& norm_columns() {
    using row = norm_row;
    static const auto all = with_typed_energy<row>({
        energy_column<row>(),
        point_column<row>(),
        {"order", "N, last power of the series about the point", [](const row& r) { return r.order; }},
        {"norm", "max of |series - theta| over [0, T*], radians",
         [](const row& r) { return decimal_cell(r.norm, digits_of_norms); }},
        {"log10_norm", "log10 of norm", [](const row& r) { return log10_cell(r.norm); }},
    });
    return all;
}

// (norm_b/norm_a)^(1/(b-a)) of the first and the last order.
std::optional<mpfr> measured_rate(const std::vector<int>& orders, const std::vector<mpfr>& norms) {
    const int apart = orders.back() - orders.front();
    if (apart == 0 || norms.front() == 0 || norms.back() == 0) {
        return std::nullopt;
    }
    return mpfr(pow(mpfr(norms.back() / norms.front()), mpfr(1) / apart));
}

// Digits by which the smallest norm of one energy is below theta.
long digits_below(const motion& m, const std::vector<exact>& points, int order) {
    long below = 0;
    for (const exact& point : points) {
        below = std::max(below, coverage_digits_below(m, point.coefficient, order));
    }
    return below;
}

// Both tables of one energy.
std::vector<table> rows_at(const sweep_energy& at, const std::vector<exact>& points, const std::vector<int>& orders,
                           const scalar_spec& scalar) {
    const motion m = motion::of_energy(at.value);
    const long below = digits_below(m, points, orders.back());
    const precision_scope scope(std::max(scalar.digits, digits_of_norms) + below + guard_digits);
    coverage_errors errors(m);
    std::vector<cover_row> covers;
    std::vector<norm_row> norm_rows;
    for (const exact& point : points) {
        const rational& x = point.coefficient;
        with_scalar(scalar, below + guard_digits, [&]<class T>() {
            const auto cover = coverage_from<T>(m, x);
            std::vector<mpfr> norms;
            norms.reserve(orders.size());
            for (const int order : orders) {
                if constexpr (fixed_scalar<T>) {
                    norms.push_back(errors.norm_in<T>(x, order));
                } else {
                    norms.push_back(errors.norm(x, order).norm);
                }
                norm_rows.push_back({at, point, order, norms.back()});
            }
            covers.push_back({at, point, scalar, widen(cover.radius), widen(cover.effective_period),
                              widen(cover.convergence_rate), widen(cover.height), cover.covers,
                              measured_rate(orders, norms)});
        });
    }
    return {make_table(columns(), covers), make_table(norm_columns(), norm_rows)};
}

study_plan plan(const study_request& request) {
    const std::vector<int> orders = orders_from(request, 0, "");
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:40"));
    const auto sweep = sweep_of(request);
    return plan_by_values({head_of("", scalar, columns()), head_of("norms", scalar, norm_columns())}, sweep, "point",
                          sweep->points, [orders, scalar](const sweep_energy& at, const std::vector<exact>& points) {
                              return rows_at(at, points, orders, scalar);
                          });
}

}  // namespace
}  // namespace of_pendulum

namespace of_equation {

namespace {

struct point_row {
    const exact& time;
    mpfr reach;
    answered_list of;
};

const column_list<point_row>& columns() {
    using row = point_row;
    const column_list<row> own{
        {"time", "expansion point, in the unit of the variable",
         [](const row& r) { return number_cell(decimal_of(r.time, 50)); }},
        {"position_re", "Re of a nearest singularity, as a time",
         [](const row& r) {
             const auto& position = r.of.found.position;
             return position ? decimal_cell(mpfr(from_exact<mpfr>(r.time) + position->re), r.of.digits) : cell();
         }},
        {"reach", "distance of the farther end of the times", [](const row& r) { return decimal_cell(r.reach, 12); }},
        {"rate", "reach/radius: factor of the error on all times a power; above 1 it diverges",
         [](const row& r) {
             return r.of.found.radius ? decimal_cell(mpfr(r.reach / *r.of.found.radius), 12) : cell();
         }},
    };
    static const auto all =
        columns_named("time,order,radius,uncertainty,position_re,position_im,reach,rate,note,unknown",
                      joined(own, columns_within(answer_columns(), &row::of)));
    return all;
}

table rows_about(const equation_sweep& sweep, std::size_t i, const std::vector<exact>& times, std::size_t point,
                 const std::vector<int>& orders, const scalar_spec& scalar) {
    const precision_scope scope(scalar.digits + guard_of_lists);
    const exact& time = times[point];
    const auto lists = unknown_lists(sweep.system(i), orders.back(), scalar.digits + guard_of_lists,
                                     ode::parse_complex_constant(time.text));
    const auto distance = [&](const exact& end) {
        return mpfr(abs(mpfr(from_exact<mpfr>(end) - from_exact<mpfr>(time))));
    };
    const mpfr reach = std::max(distance(times.front()), distance(times.back()));
    std::vector<point_row> rows;
    for (const answered_list& each : answers_to(lists, sweep, orders, scalar, is_verdict)) {
        rows.push_back({time, reach, each});
    }
    return make_table(columns(), rows);
}

study_plan plan(const study_request& request) {
    const auto sweep = equation_sweep_of(request);
    times_of(request, 2);
    const auto times = request.values.of("time");
    const auto orders = orders_from(request, least_order_of_lists, "is too short a list for a radius test");
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:30"));
    const std::size_t points = times.size();
    return plan_of_cells(
        {head_of(*sweep, "", scalar, columns())}, sweep->axes({"time"}), sweep->size() * points,
        [sweep, times, points](std::size_t i) {
            cell_inputs inputs = with_input(sweep->inputs(i / points), "time", times[i % points].text);
            // The reach of a point follows from the end points of the interval.
            inputs = with_input(std::move(inputs), "first", times.front().text);
            return with_input(std::move(inputs), "last", times.back().text);
        },
        [sweep, times, points, orders, scalar](std::size_t i) {
            return std::vector<table>{
                sweep->framed(i / points, rows_about(*sweep, i / points, times, i % points, orders, scalar))};
        });
}

}  // namespace
}  // namespace of_equation
}  // namespace expansion_point_study

const study& expansion_point() {
    using namespace expansion_point_study;
    static const study result{
        .name = "expansion_point",
        .title = "Where to expand",
        .question = "About which point of the way from the top to the bottom should the series be expanded?",
        .reading =
            "Left: the radius of convergence in units of T*. It is largest about the top, as the paper says, at every "
            "energy, and from there alone is it always above 1. Right: the factor by which one more power reduces the "
            "error on the whole way [0, T*]; lines are theory, max(x, 1-x) T*/R, and marks are measured from norms of "
            "two orders (the 1/N in the coefficients lowers them by two hundredths). A rate above 1 diverges: about "
            "the bottom for 1 < E < 4, and not for every E < 2. The second figure shows the same rate over the "
            "expansion point: the best is half way at every energy, so the top is optimal in its radius and not in "
            "what it costs to cover the way; what speaks for the top is that half of its coefficients vanish.",
        .of = &pendulum_problem(),
        .parameters = {{"--energies", "0.05:1.95:39,2.02,2.1:3:10,3.25:8:20", "energies E, in m g l"},
                       {"--gaps", "", "energies as 2 - E"},
                       {"--points", "0,1/4,1/2,3/4,1", "expansion points, fractions of T*: 0 the top, 1 the bottom"},
                       {"--orders", "40,160", "N, last powers between which the rate is measured"},
                       {"--scalar", "mpfr:40", "arithmetic of radius, rate and series"}},
        .quick = {{"--energies", "1.71,2.02", ""}, {"--orders", "6,12", ""}, {"--points", "0,1", ""}},
        .seconds = 3,
        .excluded = no_answer_at_limits("theta is constant and every radius infinite", "T* is infinite"),
        .plan = of_pendulum::plan,
        .version = 2,
        .any_equation = equation_form{
            .plan = of_equation::plan,
            .question = "About which time of an interval should the solution be expanded?",
            .reading = "Left: the radius of convergence about each time, from coefficients there; the solution is "
                       "marched to it. Middle: how far from the real times the singularity is that limits it, as the "
                       "tests see it. Right: the factor by which one more power reduces the error on the whole "
                       "interval. Below 1, the line, a single series covers it; the best point is where the factor is "
                       "least.",
            .parameters = {required_times("expansion points; the first and the last are the ends of the interval"),
                           {"--orders", "80", "N, last powers of the lists under test"},
                           {"--scalar", "mpfr:30", "arithmetic of the lists under test"}},
            .example = {"blasius", {}},
            .example_words = {{"--times", "0:6:25"}},
            .quick = {{"--times", "0:2:3"}, {"--orders", "20"}},
            .seconds = 2}};
    return result;
}

}  // namespace libration::studies
