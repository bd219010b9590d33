// Is the radius of convergence larger than the physical domain, equal to it, or within it?
#include <algorithm>
#include <cmath>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/plane/proved_singularity.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "problem/catalogue_axis.hpp"
#include "sweep/study.hpp"

namespace libration::studies {

namespace scenarios_study {

namespace {

constexpr long proof_digits = 10;
constexpr long existence_digits = 5;
// Proofs for systems of more unknowns take minutes: their radius is taken from the search, as it is if the proof fails.
constexpr std::size_t most_proved_unknowns = 4;

struct scenario_row {
    std::string problem, domain, scenario;
    std::string lower, upper;
    std::string place_re, place_im, kind, rigour, reason;
};

const column_list<scenario_row>& columns() {
    using row = scenario_row;
    static const column_list<row> all{
        {"problem", "name in the catalogue", [](const row& r) { return r.problem; }},
        {"lower", "bound of the radius of convergence", [](const row& r) { return number_cell(r.lower); }},
        {"upper", "bound of the radius", [](const row& r) { return number_cell(r.upper); }},
        {"domain", "the physical one, from the start: all times, or until the solution ends",
         [](const row& r) { return r.domain; }},
        {"scenario", "of the radius against the domain: larger, equal or within",
         [](const row& r) { return r.scenario; }},
        {"position_re", "nearest singularity from the start, real part",
         [](const row& r) { return number_cell(r.place_re); }},
        {"position_im", "imaginary part", [](const row& r) { return number_cell(r.place_im); }},
        {"kind", "of it (heuristic)", [](const row& r) { return r.kind; }},
        {"rigour", "of the bounds and, where the solution goes on, of that", [](const row& r) { return r.rigour; }},
        {"reason", "why there is no verdict, or what it rests on", [](const row& r) { return r.reason; }},
    };
    return all;
}

std::size_t size_of_state(const ode::explicit_system& system) {
    std::size_t count = 0;
    for (const auto& each : system.unknowns()) {
        count += static_cast<std::size_t>(each.order);
    }
    return count;
}

// Whether the solution is proved to exist until a time beyond the radius.
bool goes_on_beyond(const ode::explicit_system& system, const mpfr& radius) {
    const rational beyond = nearest_integer(mpfr(radius * 1100)) / rational(1000);
    try {
        const auto time = system.point() + ode::number(beyond);
        static_cast<void>(ode::proved_trajectory(system, {time}, existence_digits));
        return true;
    } catch (const error&) {
        return false;
    }
}

bool is_ahead(const ode::found_singularity& each) { return each.offset.im == 0 && each.offset.re > 0; }

void judge(scenario_row& row, const ode::explicit_system& system, const ode::found_singularity& nearest,
           const mpfr& upper, bool ahead) {
    row.place_re = to_decimal(nearest.offset.re, proof_digits);
    row.place_im = to_decimal(nearest.offset.im, proof_digits);
    row.kind = ode::words_of(nearest.kind, nearest.exponent.real());
    if (ahead) {
        row.scenario = "equal";
        row.domain = "until the singularity";
        return;
    }
    const bool on = goes_on_beyond(system, upper);
    row.scenario = on ? "within" : "";
    row.domain = on ? "beyond the radius" : "";
    if (!on) {
        row.reason += row.reason.empty() ? "" : "; ";
        row.reason += "the solution is not proved to go on beyond the radius";
    }
}

// The proved bounds, or the reason why there are none.
std::string take_proved_bounds(scenario_row& row, const ode::explicit_system& system, mpfr& upper) {
    if (size_of_state(system) > most_proved_unknowns) {
        return "a proof for so many unknowns takes minutes";
    }
    try {
        const auto radius = ode::prove_radius(system, proof_digits);
        upper = midpoint_of(radius.upper);
        row.lower = parts_of(midpoint_of(radius.lower), proof_digits + 2, MPFR_RNDD).text();
        row.upper = parts_of(upper, proof_digits + 2, MPFR_RNDU).text();
        return "";
    } catch (const error& problem) {
        return "no proof: the problem " + problem.reason();
    }
}

scenario_row row_of(const std::string& name) {
    scenario_row row{name, "", "", "", "", "", "", "", "proved", ""};
    try {
        const ode::explicit_system system(ode::parse(problem_text(name)));
        if (ode::has_entire_solutions(system)) {
            row.lower = row.upper = "inf";
            row.scenario = "larger";
            row.domain = "all times";
            row.reason = "linear with entire coefficients";
            return row;
        }
        ode::singularity_request request;
        request.digits = proof_digits + 4;
        request.nearest_alone = true;
        request.most_points = 2'000;
        const auto map = ode::singularities_of(system, request);
        if (map.all.empty()) {
            row.rigour = "heuristic";
            row.reason = "no singularity was found near the start";
            return row;
        }
        const precision_scope scope(proof_digits + 30);
        const bool ahead = std::ranges::any_of(map.all, is_ahead);
        mpfr upper = modulus_of(map.all.front().offset);
        row.reason = take_proved_bounds(row, system, upper);
        if (!row.reason.empty()) {
            row.lower = row.upper = to_decimal(upper, proof_digits);
            row.rigour = "heuristic";
        }
        judge(row, system, ahead ? *std::ranges::find_if(map.all, is_ahead) : map.all.front(), upper, ahead);
    } catch (const error& problem) {
        row.rigour = "heuristic";
        row.reason = problem.reason();
    }
    return row;
}

study_plan plan(const study_request& request) {
    const auto names = problem_names_of(request.values.of("problem"));
    return plan_of_cells(
        {head_of("", {scalar_kind::proved, proof_digits}, columns())}, {"problem"}, names.size(),
        [names](std::size_t i) {
            return cell_inputs{{"problem", names[i]}};
        },
        [names](std::size_t i) {
            return std::vector<table>{make_table(columns(), std::vector<scenario_row>{row_of(names[i])})};
        });
}

}  // namespace
}  // namespace scenarios_study

const study& scenarios() {
    using namespace scenarios_study;
    static const study result{
        .name = "scenarios",
        .title = "The three scenarios",
        .question = "Is the radius of convergence larger than the physical domain, equal to it, or within it?",
        .reading =
            "The paper closes with three scenarios for the series of a nonlinear equation: its radius of convergence "
            "is larger than the physical domain, is the length of the domain, or lies within it. For every problem of "
            "the catalogue, about its start: the nearest singularity in units of the proved radius, whether the "
            "solution ends there (equal), or is proved to go on beyond the radius (within), or has no singularity at "
            "all (larger). A pendulum that is expanded at its top falls into the first case by its symmetry, which "
            "shortens the domain to a quarter of the period; about any other point it does not.",
        .of = &catalogue_as_problem(),
        .parameters = {{"--problems", "all", "names of the catalogue"}},
        .quick = {{"--problems", "harmonic,riccati", ""}},
        .seconds = 240,
        .plan = plan,
        .offers = arithmetics::proved_too};
    return result;
}

}  // namespace libration::studies
