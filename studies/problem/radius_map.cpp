// Can an unknown radius, and with it the optimal expansion point, be deduced from coefficients? [paper sec:conclusions]
#include <algorithm>
#include <iterator>
#include <utility>

#include "radius_cells.hpp"
#include "run/parallel.hpp"
#include "sweep/study.hpp"
#include "text/input_error.hpp"

namespace libration::studies {

namespace radius_map_study {
namespace {

using rows = std::vector<std::vector<std::string>>;

constexpr int least_order = 4;

std::vector<column> columns() {
    return joined(
        {{"energy", "E, in units of m g l"},
         {"point", "expansion point as a fraction of T*: 0 the top, 1 the bottom"},
         {"order", "N, last power of t of the list"}},
        joined(radius_columns(),
               {{"position_re", "Re of the estimated nearest singularity, from the point, dimensionless time"},
                {"position_im", "Im of it"},
                {"position_error", "its distance from (1-x) T* + i K~', over R"},
                {"log10_position_error", "log10 of position_error"},
                {"kind", "of the singularity by the verdict: logarithm is right"},
                {"count", "singularities on the circle by the verdict: 4 about the top and 2 elsewhere is right"},
                {"rate", "max(x, 1-x) T*/radius: factor of the error on [0, T*] a power"},
                {"tstar", "T*, dimensionless"},
                {"height", "K~', dimensionless"},
                {"gap", "2 - E"},
                {"log10_gap", "log10 of |2 - E|"},
                {"note", "which test decided, or why there is no radius"}}));
}

const std::vector<column>& optimum_columns() {
    static const std::vector<column> all{
        {"energy", "E, in units of m g l"},
        {"order", "N, last power of t of the lists"},
        {"points", "points whose list gave a radius"},
        {"largest_radius_point", "fraction of T* about which the estimated radius is largest"},
        {"largest_radius", "estimated there, dimensionless time"},
        {"exact_largest_radius_point", "the same by the exact radii of these points; of all points it is 0, the top"},
        {"least_rate_point", "fraction of T* about which the estimated max(x, 1-x) T*/R is least"},
        {"least_rate", "estimated there"},
        {"exact_least_rate_point", "the same by the exact radii of these points; of all points it is 1/2"},
        {"gap", "2 - E"},
    };
    return all;
}

// The verdict on one list against what is exact, all in a precision that holds more digits than the verdict.
struct judged_point {
    const exact& point;
    descent_cover<mpfr> cover;
    radius_estimate<mpfr> found;
};

// The verdicts about one point from each order.
std::vector<judged_point> judged_about(const motion& m, const exact& point, const std::vector<int>& orders,
                                       const scalar_spec& scalar) {
    std::vector<judged_point> all;
    all.reserve(orders.size());
    with_scalar(scalar, 0, [&]<class T>() {
        const auto list = series_on_descent<T>(m, point.coefficient, orders.back(), hidden_unit());
        for (const int order : orders) {
            const auto verdict = in_unit(report_on_radius(cut(list.scaled, order), epsilon<T>()).verdict, list.unit);
            const precision_scope judging(scalar.digits + digits_for_judging);
            all.push_back({point, cover_from<mpfr>(m, point.coefficient), widened(verdict)});
        }
    });
    return all;
}

std::vector<std::string> row_of(const sweep_energy& at, int order, const judged_point& p, long digits) {
    const auto text = [&](const mpfr& x) { return to_decimal(x, digits); };
    std::vector<std::string> place(4);
    if (p.found.position) {
        const mpfr error =
            modulus_of(*p.found.position - nearest_on_descent(p.cover, p.point.coefficient)) / p.cover.radius;
        place = {text(p.found.position->re), text(p.found.position->im), to_decimal(error, digits_of_errors),
                 log10_text(error)};
    }
    const bool answered = p.found.radius.has_value();
    return joined(
        joined(joined({at.energy, p.point.text, std::to_string(order)}, radius_cells(p.found, p.cover.radius, digits)),
               place),
        {answered ? name_of(p.found.kind) : "", answered ? std::to_string(p.found.count) : "",
         answered ? text(mpfr(p.cover.reach / *p.found.radius)) : "", text(p.cover.effective_period),
         text(p.cover.height), at.gap, log10_text(abs(from_rational<mpfr>(rational(2 - at.value)))), p.found.note});
}

// The points of largest radius and of least rate, estimated and exact, for one order.
std::vector<std::string> optimum_of(const sweep_energy& at, int order, const std::vector<judged_point>& points,
                                    long digits) {
    const auto by_radius = [](const auto& a, const auto& b) { return a.cover.radius < b.cover.radius; };
    const auto by_rate = [](const auto& a, const auto& b) { return a.cover.rate < b.cover.rate; };
    const std::string exactly_widest = std::max_element(points.begin(), points.end(), by_radius)->point.text;
    const std::string exactly_fastest = std::min_element(points.begin(), points.end(), by_rate)->point.text;
    std::vector<const judged_point*> seen;
    seen.reserve(points.size());
    for (const judged_point& p : points) {
        if (p.found.radius) {
            seen.push_back(&p);
        }
    }
    if (seen.empty()) {
        return {at.energy, std::to_string(order), "0", "", "", exactly_widest, "", "", exactly_fastest, at.gap};
    }
    const auto best = [&](const auto& better) { return *std::min_element(seen.begin(), seen.end(), better); };
    const auto* widest = best([](auto* a, auto* b) { return *a->found.radius > *b->found.radius; });
    const auto* fastest =
        best([](auto* a, auto* b) { return a->cover.reach * *b->found.radius < b->cover.reach * *a->found.radius; });
    return {at.energy,
            std::to_string(order),
            std::to_string(seen.size()),
            widest->point.text,
            to_decimal(*widest->found.radius, digits),
            exactly_widest,
            fastest->point.text,
            to_decimal(mpfr(fastest->cover.reach / *fastest->found.radius), digits),
            exactly_fastest,
            at.gap};
}

// Both tables of one energy.
std::pair<rows, rows> rows_at(const sweep_energy& at, const std::vector<exact>& points, const std::vector<int>& orders,
                              const scalar_spec& scalar) {
    const precision_scope scope(scalar.digits + digits_for_judging);
    const motion m = motion::of_energy(at.value);
    std::vector<std::vector<judged_point>> by_order(orders.size());
    std::pair<rows, rows> all;
    for (const exact& point : points) {
        const auto judged = judged_about(m, point, orders, scalar);
        for (std::size_t i = 0; i < orders.size(); ++i) {
            all.first.push_back(row_of(at, orders[i], judged[i], scalar.digits));
            by_order[i].push_back(judged[i]);
        }
    }
    for (std::size_t i = 0; i < orders.size(); ++i) {
        all.second.push_back(optimum_of(at, orders[i], by_order[i], scalar.digits));
    }
    return all;
}

std::vector<study_table> run(const study_request& request) {
    refuse_limits(request.energies, "theta is constant and every radius infinite", "T* is infinite");
    std::vector<int> orders = request.orders;
    std::sort(orders.begin(), orders.end());
    if (orders.front() < least_order) {
        throw input_error("--orders", std::to_string(orders.front()), "is too short a list for a radius test",
                          "write orders from " + std::to_string(least_order) + " on");
    }
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:30"));
    progress shown("radius_map, energies", request.energies.size(), request.shown);
    const auto found = parallel_map(request.energies.size(), request.jobs, shown, [&](std::size_t i) {
        return rows_at(request.energies[i], request.points, orders, scalar);
    });
    study_table map{"", scalar, {columns(), {}}};
    study_table optimum{"optimum", scalar, {optimum_columns(), {}}};
    for (const auto& [map_rows, optimum_rows] : found) {
        map.data.rows.insert(map.data.rows.end(), map_rows.begin(), map_rows.end());
        optimum.data.rows.insert(optimum.data.rows.end(), optimum_rows.begin(), optimum_rows.end());
    }
    return {std::move(map), std::move(optimum)};
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
            "estimated rate half way at every energy from N = 60 (second table; from N = 20 the top is missed at E = "
            "1, where that list gives no verdict).",
        .parameters = {{"--energies", "0.5,1,1.71,1.9998,2.02,3", "energies E, in m g l"},
                       {"--gaps", "", "energies as 2 - E"},
                       {"--points", "0:1:21", "expansion points, fractions of T*: 0 the top, 1 the bottom"},
                       {"--orders", "20,60", "N, last powers of the lists judged"},
                       {"--scalar", "mpfr:30", "arithmetic of the lists that are judged"}},
        .quick = {{"--energies", "1,2.02", ""}, {"--orders", "12", ""}, {"--points", "0,1/2,1", ""}},
        .seconds = 7,
        .run = run};
    return result;
}

}  // namespace libration::studies
