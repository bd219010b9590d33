// Where are the singularities of theta in the complex time plane, and do the coefficients know? [paper fig:subcrit,
// fig:supercrit]
#include "sweep/study.hpp"
#include "text/input_error.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "libration/convergence/test/root_test.hpp"
#include "libration/pendulum/arc/stable_pade_poles.hpp"
#include "libration/scalar/text/decimal.hpp"
#include "run/parallel.hpp"

namespace libration::studies {

namespace singularities_study {
namespace {

using rows = std::vector<std::vector<std::string>>;

constexpr long guard_digits = 15;
constexpr long digits_of_logarithms = 12;
constexpr int first_order = 4;  // two coefficients of omega: the first approximant with a pole
constexpr int orders_in_convergence = 40;

const std::vector<column>& columns() {
    static const std::vector<column> all{
        {"energy", "E, in units of m g l"},
        {"kind", "singularity | expansion_top | expansion_bottom | pade_pole"},
        {"order", "N, last power of the series of theta whose Pade approximant has the pole"},
        {"re", "Re t, dimensionless time since the top; of a pade_pole the mirror image with re, im >= 0"},
        {"im", "Im t, dimensionless"},
        {"radius", "of convergence of the Taylor series about an expansion point, dimensionless time"},
        {"nearest_re", "Re of the singularity next to a pole"},
        {"nearest_im", "Im of the singularity next to a pole"},
        {"log10_distance", "log10 of the distance of a pole from that singularity"},
        {"residue_re", "Re of the residue of omega at a pole; 0 at the singularities"},
        {"residue_im", "Im of the residue of omega at a pole; +2 or -2 at the singularities"},
        {"numerator_degree", "L of [L/M], in t^2"},
        {"denominator_degree", "M of [L/M], in t^2"},
        {"tstar", "T*, dimensionless"},
        {"height", "K~', dimensionless"},
        {"gap", "2 - E"},
    };
    return all;
}

const std::vector<column>& convergence_columns() {
    static const std::vector<column> all{
        {"energy", "E, in units of m g l"},
        {"order", "N, last power of the series of theta"},
        {"log10_distance", "log10 of the distance of the nearest pole of omega's Pade approximant from T* + i K~'"},
        {"log10_root_error", "log10 of the error of the radius of convergence by the root test of the same series"},
        {"numerator_degree", "L of [L/M], in t^2"},
        {"denominator_degree", "M of [L/M], in t^2"},
    };
    return all;
}

// What is the same in all rows of an energy.
struct plane {
    const sweep_energy& at;
    motion m;
    long digits;
    singularity_lattice<mpfr> lattice;
    mpfr radius;

    std::string text(const mpfr& x) const { return to_decimal(x, digits); }
    std::vector<std::string> row(const std::string& kind, std::vector<std::string> own) const {
        std::vector<std::string> cells{at.energy, kind};
        cells.insert(cells.end(), own.begin(), own.end());
        cells.resize(columns().size() - 3);
        cells.insert(cells.end(), {text(lattice.effective_period), text(lattice.height), at.gap});
        return cells;
    }
};

plane plane_of(const sweep_energy& at, long digits) {
    motion m = motion::of_energy(at.value);
    auto lattice = *singularities<mpfr>(m);
    const mpfr radius = modulus_of(complex_number<mpfr>{lattice.effective_period, lattice.height});
    return {at, std::move(m), digits, std::move(lattice), radius};
}

// The lattice as far as the figure shows it: three columns and rows on each side, or the circle of the top if that is
// larger.
rows lattice_rows(const plane& p) {
    const mpfr beyond = p.radius * 3 / 2;
    const mpfr width = std::max(mpfr(p.lattice.effective_period * 4), beyond);
    const mpfr height = std::max(mpfr(p.lattice.height * 4), beyond);
    rows all;
    for (const auto& point : lattice_points(p.lattice, width, height)) {
        all.push_back(p.row("singularity", {"", p.text(point.re), p.text(point.im)}));
    }
    all.push_back(p.row("expansion_top", {"", "0", "0", p.text(p.radius)}));
    for (const int side : {-1, 1}) {
        const mpfr bottom = p.lattice.effective_period * side;
        all.push_back(p.row("expansion_bottom", {"", p.text(bottom), "0", p.text(p.lattice.height)}));
    }
    return all;
}

rows pole_rows(const plane& p, int order) {
    const auto found = stable_pade_poles(p.m, order, p.digits);
    rows all;
    for (const auto& pole : found.poles) {
        all.push_back(
            p.row("pade_pole",
                  {std::to_string(order), p.text(pole.time.re), p.text(pole.time.im), "", p.text(pole.nearest.re),
                   p.text(pole.nearest.im), log10_text(pole.distance),
                   to_decimal(pole.residue.re, digits_of_logarithms), to_decimal(pole.residue.im, digits_of_logarithms),
                   std::to_string(found.numerator_degree), std::to_string(found.denominator_degree)}));
    }
    return all;
}

std::vector<std::string> convergence_row(const plane& p, int order) {
    const auto found = stable_pade_poles(p.m, order, digits_of_logarithms);
    const auto distance = distance_from_first(found, p.lattice);
    const auto theta = theta_in_radii(descent_of<mpfr>(p.m), p.radius, order);
    return {p.at.energy,
            std::to_string(order),
            distance ? log10_text(*distance) : "",
            log10_text(abs(radius_by_root_test(theta) - 1) * p.radius),
            std::to_string(found.numerator_degree),
            std::to_string(found.denominator_degree)};
}

// Both tables of one energy.
std::pair<rows, rows> rows_at(const sweep_energy& at, const std::vector<int>& orders, long digits) {
    const precision_scope scope(digits + guard_digits);
    const plane p = plane_of(at, digits);
    rows all = lattice_rows(p);
    for (const int order : orders) {
        rows poles = pole_rows(p, order);
        std::move(poles.begin(), poles.end(), std::back_inserter(all));
    }
    rows convergence;
    const int last = *std::max_element(orders.begin(), orders.end());
    const int step = 2 * std::max(1, last / (2 * orders_in_convergence));
    for (int order = first_order; order <= last; order += step) {
        convergence.push_back(convergence_row(p, order));
    }
    return {std::move(all), std::move(convergence)};
}

std::vector<study_table> run(const study_request& request) {
    refuse_limits(request.energies, "theta is constant and has no singularity",
                  "the motion has no top and one column of singularities is left");
    const int least = *std::min_element(request.orders.begin(), request.orders.end());
    if (least < first_order) {
        throw input_error("--orders", std::to_string(least), "leaves no Pade approximant with a pole",
                          "write orders from " + std::to_string(first_order) + " on");
    }
    const long digits = *std::max_element(request.digits.begin(), request.digits.end());
    progress shown("singularities, energies", request.energies.size(), request.shown);
    const auto found = parallel_map(request.energies.size(), request.jobs, shown, [&](std::size_t i) {
        return rows_at(request.energies[i], request.orders, digits);
    });
    const scalar_spec scalar{scalar_kind::arbitrary, digits};
    study_table lattice{"", scalar, {columns(), {}}};
    study_table convergence{"convergence", scalar, {convergence_columns(), {}}};
    for (const auto& [plane_rows, order_rows] : found) {
        lattice.data.rows.insert(lattice.data.rows.end(), plane_rows.begin(), plane_rows.end());
        convergence.data.rows.insert(convergence.data.rows.end(), order_rows.begin(), order_rows.end());
    }
    return {std::move(lattice), std::move(convergence)};
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
        .parameters = {{"--energies", "1.71,2.02", "energies E, in m g l"},
                       {"--gaps", "", "energies as 2 - E"},
                       {"--orders", "20,40,80", "N, last power of the series whose Pade approximants are drawn"},
                       {"--digits", "40", "correct digits of the coordinates; of several numbers the largest"}},
        .quick = {{"--energies", "1.71,2.02", ""}, {"--orders", "10", ""}},
        .seconds = 0.5,
        .run = run};
    return result;
}

}  // namespace libration::studies
