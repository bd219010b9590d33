// What does the solution of an equation look like in the complex t-plane, and what limits its series there?
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "libration/equation/first_order_form.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/plane/proved_singularity.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "problem/catalogue_axis.hpp"
#include "sweep/study.hpp"

namespace libration::studies {

namespace complex_plane_study {

namespace {

constexpr int points_across = 81;
constexpr long place_digits = 15;
constexpr long proof_digits = 8;
constexpr double times_nearest = 1.8;

struct value_row {
    std::string problem;
    ode::plane_value at;
    std::string unknown;
};

cell small(double x) { return number_cell(fmt::format("{:.5g}", x + 0.0)); }

bool is_known(const value_row& r) { return r.at.known && std::abs(r.at.value) > 0; }

const column_list<value_row>& value_columns() {
    using row = value_row;
    static const column_list<row> all{
        {"problem", "name in the catalogue", [](const row& r) { return r.problem; }},
        {"re", "time from the start, real part", [](const row& r) { return small(r.at.offset.real()); }},
        {"im", "imaginary part", [](const row& r) { return small(r.at.offset.imag()); }},
        {"log10_abs", "log10 |y| of the unknown, in double precision (heuristic)",
         [](const row& r) { return is_known(r) ? small(std::log10(std::abs(r.at.value))) : cell(); }},
        {"argument", "arg y; empty, as the modulus, where the search has no value",
         [](const row& r) { return is_known(r) ? small(std::arg(r.at.value)) : cell(); }},
        {"unknown", "of the problem", [](const row& r) { return r.unknown; }},
    };
    return all;
}

struct place_row {
    std::string problem;
    ode::found_singularity at;
    std::string unknown;
};

const column_list<place_row>& place_columns() {
    using row = place_row;
    static const column_list<row> all{
        {"problem", "name in the catalogue", [](const row& r) { return r.problem; }},
        {"re", "place from the start, real part",
         [](const row& r) { return decimal_cell(r.at.offset.re, place_digits); }},
        {"im", "imaginary part", [](const row& r) { return decimal_cell(r.at.offset.im, place_digits); }},
        {"uncertainty", "of the place", [](const row& r) { return decimal_cell(r.at.uncertainty, 3); }},
        {"kind", "of the singularity (heuristic)",
         [](const row& r) { return ode::words_of(r.at.kind, r.at.exponent.real()); }},
        {"unknown", "of the problem", [](const row& r) { return r.unknown; }},
    };
    return all;
}

// A disc of the covering, a corner of the loop, or the two radii.
struct proof_row {
    std::string problem, part;
    std::string re, im, radius;
};

const column_list<proof_row>& proof_columns() {
    using row = proof_row;
    static const column_list<row> all{
        {"problem", "name in the catalogue", [](const row& r) { return r.problem; }},
        {"part", "disc of the covering, corner of the loop, lower or upper bound of the radius (proved)",
         [](const row& r) { return r.part; }},
        {"re", "centre, real part", [](const row& r) { return number_cell(r.re); }},
        {"im", "imaginary part", [](const row& r) { return number_cell(r.im); }},
        {"radius", "of the disc, or the bound", [](const row& r) { return number_cell(r.radius); }},
    };
    return all;
}

std::string short_text(double x) { return fmt::format("{:.9g}", x + 0.0); }

std::vector<proof_row> proof_of(const std::string& name, const ode::explicit_system& system) {
    std::vector<proof_row> rows;
    ode::proved_radius radius;
    try {
        radius = ode::prove_radius(system, proof_digits);
    } catch (const error& problem) {
        if (problem.kind() != error_kind::undecided) {
            throw;
        }
        rows.push_back({name, "none", "", "", ""});
        return rows;
    }
    const precision_scope scope(proof_digits + 30);
    rows.push_back({name, "lower", "0", "0", parts_of(midpoint_of(radius.lower), proof_digits + 2, MPFR_RNDD).text()});
    rows.push_back({name, "upper", "0", "0", parts_of(midpoint_of(radius.upper), proof_digits + 2, MPFR_RNDU).text()});
    for (const auto& each : radius.cover.discs) {
        rows.push_back(
            {name, "disc", short_text(each.centre.real()), short_text(each.centre.imag()), short_text(each.radius)});
    }
    for (const auto& each : radius.evidence->evidence.polygon) {
        rows.push_back({name, "loop", to_decimal(midpoint_of(each.re), place_digits),
                        to_decimal(midpoint_of(each.im), place_digits), ""});
    }
    return rows;
}

std::vector<table> tables_of(const std::string& name) {
    const ode::explicit_system system(ode::parse(problem_text(name)));
    const std::string unknown = system.unknowns().front().name;
    ode::singularity_request request;
    request.digits = place_digits;
    request.nearest_alone = true;
    const auto first = ode::singularities_of(system, request);
    request.within = times_nearest * first.within;
    request.nearest_alone = false;
    request.portrait = points_across;
    const auto map = ode::singularities_of(system, request);
    std::vector<value_row> values;
    for (const auto& each : map.portrait) {
        values.push_back({name, each, unknown});
    }
    std::vector<place_row> places;
    const auto names = ode::first_order_form(system).names;
    for (const auto& each : map.all) {
        places.push_back({name, each, names[each.unknown]});
    }
    return {make_table(value_columns(), values), make_table(place_columns(), places),
            make_table(proof_columns(), proof_of(name, system))};
}

study_plan plan(const study_request& request) {
    const auto names = problem_names_of(request.values.of("problem"));
    return plan_of_cells(
        {head_of("", read_scalar("double"), value_columns()),
         head_of("singularities", {scalar_kind::arbitrary, place_digits}, place_columns()),
         head_of("proofs", {scalar_kind::proved, proof_digits}, proof_columns())},
        {"problem"}, names.size(),
        [names](std::size_t i) {
            return cell_inputs{{"problem", names[i]}};
        },
        [names](std::size_t i) { return tables_of(names[i]); });
}

}  // namespace
}  // namespace complex_plane_study

const study& complex_plane() {
    using namespace complex_plane_study;
    static const study result{
        .name = "complex_plane",
        .title = "Solutions in the complex plane of time",
        .question = "What stands in the way of a series in the complex plane of time, and what proves it?",
        .reading =
            "The first unknown of each problem, continued from its start in double precision: its argument as a "
            "colour, its modulus as shades, a factor of 10 from dark to light; behind a branch point the plane is cut "
            "along the ray from the start. Crosses are singularities. The circle is the radius of convergence, proved "
            "by the discs that are drawn (each point within lies in one whose centre is no farther from the start) and "
            "by a loop round the nearest singularity, which is smaller than its cross.",
        .of = &catalogue_as_problem(),
        .parameters = {{"--problems", "blasius,sir,rayleigh,painleve_1,weierstrass,lorenz,van_der_pol,pendulum",
                        "names of the catalogue"}},
        .quick = {{"--problems", "riccati", ""}},
        .seconds = 30,
        .plan = plan,
        .offers = arithmetics::proved_too};
    return result;
}

}  // namespace libration::studies
