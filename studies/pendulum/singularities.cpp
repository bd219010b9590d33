// Where are the singularities of theta in the complex t-plane, and can they be determined from the coefficients? [paper
// fig:subcrit, fig:supercrit]
#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "../shared/sweep_columns.hpp"
#include "../shared/sweep_plan.hpp"
#include "libration/convergence/test/root_test.hpp"
#include "libration/pendulum/stable_pade_poles.hpp"

namespace libration::studies {

namespace singularities_study {

using namespace convergence;
using namespace pendulum;

namespace {

constexpr long guard_digits = 15;
constexpr long digits_of_logarithms = 12;
constexpr int first_order = 4;  // two coefficients of omega: the first approximant with a pole
constexpr int orders_in_convergence = 40;

// The common data of all rows of an energy.
struct plane {
    const sweep_energy& at;
    motion m;
    long digits;
    singularity_lattice<mpfr> lattice;
    mpfr radius;
};

plane plane_of(const sweep_energy& at, long digits) {
    motion m = motion::of_energy(at.value);
    auto lattice = *singularities<mpfr>(m);
    const mpfr radius = modulus_of(complex_number<mpfr>{lattice.effective_period, lattice.height});
    return {at, std::move(m), digits, std::move(lattice), radius};
}

// A point of the plane.
struct point_row {
    const sweep_energy& at;
    const plane& of;
    std::string_view kind;
    complex_number<mpfr> point;
    std::optional<mpfr> radius;
    std::optional<int> order;
    std::optional<pade_pole<mpfr>> pole;
    int numerator_degree = 0, denominator_degree = 0;

    cell coordinate(const mpfr& x) const { return decimal_cell(x, of.digits); }
};

template <class Of>
std::function<cell(const point_row&)> of_pole(const Of& value) {
    return [value](const point_row& r) { return r.pole ? cell(value(r)) : cell(); };
}

column_list<point_row> pole_columns() {
    using row = point_row;
    return {
        {"nearest_re", "Re of the singularity next to a pole",
         of_pole([](const row& r) { return r.coordinate(r.pole->nearest.re); })},
        {"nearest_im", "Im of the singularity next to a pole",
         of_pole([](const row& r) { return r.coordinate(r.pole->nearest.im); })},
        {"log10_distance", "log10 of the distance of a pole from that singularity",
         of_pole([](const row& r) { return log10_cell(r.pole->distance); })},
        {"residue_re", "Re of the residue of omega at a pole; 0 at the singularities",
         of_pole([](const row& r) { return decimal_cell(r.pole->residue.re, digits_of_logarithms); })},
        {"residue_im", "Im of the residue of omega at a pole; +2 or -2 at the singularities",
         of_pole([](const row& r) { return decimal_cell(r.pole->residue.im, digits_of_logarithms); })},
        {"numerator_degree", "L of [L/M], in t^2", of_pole([](const row& r) { return r.numerator_degree; })},
        {"denominator_degree", "M of [L/M], in t^2", of_pole([](const row& r) { return r.denominator_degree; })},
    };
}

const column_list<point_row>& columns() {
    using row = point_row;
    static const auto all = with_typed_energy<row>(joined(
        joined<row>({energy_column<row>(),
                     {"kind", "singularity | expansion_top | expansion_bottom | pade_pole",
                      [](const row& r) { return r.kind; }},
                     {"order", "N, last power of the series of theta whose Pade approximant has the pole",
                      [](const row& r) { return r.order ? cell(*r.order) : cell(); }},
                     {"re", "Re t, dimensionless time since the top; of a pade_pole the mirror image with re, im >= 0",
                      [](const row& r) { return r.coordinate(r.point.re); }},
                     {"im", "Im t, dimensionless", [](const row& r) { return r.coordinate(r.point.im); }},
                     {"radius", "of convergence of the Taylor series about an expansion point, dimensionless time",
                      [](const row& r) { return decimal_cell(r.radius, r.of.digits); }}},
                    pole_columns()),
        {{"tstar", "T*, dimensionless", [](const row& r) { return r.coordinate(r.of.lattice.effective_period); }},
         {"height", "K~', dimensionless", [](const row& r) { return r.coordinate(r.of.lattice.height); }},
         gap_column<row>()}));
    return all;
}

// The lattice as far as the figure shows it: three columns and rows on each side, or the circle of convergence about
// the top if that is larger.
std::vector<point_row> lattice_rows(const plane& p) {
    const mpfr beyond = p.radius * 3 / 2;
    const mpfr width = std::max(mpfr(p.lattice.effective_period * 4), beyond);
    const mpfr height = std::max(mpfr(p.lattice.height * 4), beyond);
    std::vector<point_row> all;
    for (const auto& point : lattice_points(p.lattice, width, height)) {
        all.push_back({p.at, p, "singularity", point, {}, {}, {}});
    }
    all.push_back({p.at, p, "expansion_top", {mpfr(0), mpfr(0)}, p.radius, {}, {}});
    for (const int side : {-1, 1}) {
        const mpfr bottom = p.lattice.effective_period * side;
        all.push_back({p.at, p, "expansion_bottom", {bottom, mpfr(0)}, p.lattice.height, {}, {}});
    }
    return all;
}

std::vector<point_row> pole_rows(const plane& p, int order) {
    const auto found = stable_pade_poles(p.m, order, p.digits);
    std::vector<point_row> all;
    for (const auto& pole : found.poles) {
        all.push_back(
            {p.at, p, "pade_pole", pole.time, {}, order, pole, found.numerator_degree, found.denominator_degree});
    }
    return all;
}

// The distance of the poles of one order from the lattice, and the error of the root test of the same series.
struct convergence_row {
    const sweep_energy& at;
    int order;
    std::optional<mpfr> distance;
    mpfr root_error;
    int numerator_degree, denominator_degree;
};

const column_list<convergence_row>& convergence_columns() {
    using row = convergence_row;
    static const auto all = with_typed_energy<row>({
        energy_column<row>(),
        {"order", "N, last power of the series of theta", [](const row& r) { return r.order; }},
        {"log10_distance", "log10 of the distance of the nearest pole of omega's Pade approximant from T* + i K~'",
         [](const row& r) { return log10_cell(r.distance); }},
        {"log10_root_error", "log10 of the error of the radius of convergence by the root test of the same series",
         [](const row& r) { return log10_cell(r.root_error); }},
        {"numerator_degree", "L of [L/M], in t^2", [](const row& r) { return r.numerator_degree; }},
        {"denominator_degree", "M of [L/M], in t^2", [](const row& r) { return r.denominator_degree; }},
    });
    return all;
}

convergence_row convergence_of(const plane& p, int order) {
    const auto found = stable_pade_poles(p.m, order, digits_of_logarithms);
    const auto theta = theta_in_radii(arc_of<mpfr>(p.m), p.radius, order);
    return {p.at,
            order,
            distance_from_first(found, p.lattice),
            mpfr(abs(radius_by_root_test(theta) - 1) * p.radius),
            found.numerator_degree,
            found.denominator_degree};
}

// Both tables of one energy.
std::vector<table> tables_at(const sweep_energy& at, const std::vector<int>& orders, long digits) {
    const precision_scope scope(digits + guard_digits);
    const plane p = plane_of(at, digits);
    std::vector<table> points{make_table(columns(), lattice_rows(p))};
    for (const int order : orders) {
        points.push_back(make_table(columns(), pole_rows(p, order)));
    }
    std::vector<convergence_row> convergence;
    const int last = *std::max_element(orders.begin(), orders.end());
    const int step = 2 * std::max(1, last / (2 * orders_in_convergence));
    for (int order = first_order; order <= last; order += step) {
        convergence.push_back(convergence_of(p, order));
    }
    return {stacked(points), make_table(convergence_columns(), convergence)};
}

study_plan plan(const study_request& request) {
    const auto orders = request.orders();
    orders_from(request, first_order, "leaves no Pade approximant with a pole");
    const auto asked = request.digits();
    const long digits = *std::max_element(asked.begin(), asked.end());
    const scalar_spec scalar{scalar_kind::arbitrary, digits};
    return plan_by_energy({head_of("", scalar, columns()), head_of("convergence", scalar, convergence_columns())},
                          sweep_of(request),
                          [orders, digits](const sweep_energy& at) { return tables_at(at, orders, digits); });
}

}  // namespace
}  // namespace singularities_study

const study& singularities() {
    using namespace singularities_study;
    static const study result{
        .name = "singularities",
        .title = "Singularities in the complex time plane",
        .label = "fig:subcrit, fig:supercrit",
        .question =
            "Where are the singularities of theta in the complex time plane, and do the coefficients of its series "
            "know where?",
        .reading =
            "Each panel is the complex time plane of one energy, to scale, with t = 0 at the top of the trajectory "
            "(the paper draws rotation from the bottom: shift by T*). Black dots are the exact singularities, odd "
            "multiples of T* to the sides and of K~' up and down. The solid circle is that of convergence of the "
            "series about the top, the dashed ones those about the bottoms at -T* and T*: the solid circle passes the "
            "bottom at every energy, the dashed ones reach back to the top only where K~' > T*. Open marks are poles "
            "of Pade approximants of omega, made of nothing but the first N coefficients: the nearest settle on the "
            "lattice, far beyond the circle that bounds the series itself. The second figure shows how fast: twice the "
            "order gives more than twice the digits of the first singularity, while a root test of the same "
            "coefficients gains almost nothing.",
        .of = &pendulum_problem(),
        .parameters = {{"--energies", "1.71,2.02", "energies E, in m g l"},
                       {"--gaps", "", "energies as 2 - E"},
                       {"--orders", "20,40,80", "N, last power of the series whose Pade approximants are drawn"},
                       {"--digits", "40", "correct digits of the coordinates; the largest of a list"}},
        .quick = {{"--energies", "1.71,2.02", ""}, {"--orders", "10", ""}},
        .seconds = 0.5,
        .excluded = no_answer_at_limits("theta is constant and has no singularity",
                                        "the motion has no top and one column of singularities is left"),
        .plan = plan};
    return result;
}

}  // namespace libration::studies
