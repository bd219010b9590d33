// Which radius test finds the radius of convergence of any equation with the fewest coefficients?
#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "libration/ode/first_order_form.hpp"
#include "libration/ode/proved/proved_singularity.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "list_answers.hpp"

namespace libration::studies::of_equation {

namespace radius_tournament_of_equation {

namespace {

constexpr int most_proved_digits = 60;

struct judged_row {
    answered_list of;
    std::optional<mpfr> difference;
    std::string truth;
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
        {"difference", "|radius/R - 1|, R as `truth` says, to 10^-D where it is proved; empty without one",
         [](const row& r) { return decimal_cell(r.difference, 6); }},
        {"log10_difference", "log10 of difference", [](const row& r) { return log10_cell(r.difference); }},
        {"note", "which test decided, or why there is no radius",
         [](const row& r) { return without_commas(r.of.found.of.note); }},
        {"truth",
         "R: proved | proved from below: the radius that another unknown is proved to have, which the verdict on the "
         "reference list agrees with | verdict: that verdict, so that difference measures agreement and not truth",
         [](const row& r) { return r.truth; }},
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

// What the tests are measured by.
struct true_radius {
    std::optional<mpfr> radius;
    std::string by;
};

// A radius that a covering and a loop prove for one unknown, and from below for all.
struct proved_for_unknown {
    mpfr radius;
    std::string unknown;
};

// Nothing where there is no proof.
std::optional<proved_for_unknown> proved_radius_of(const ode::explicit_system& system, long digits) {
    if (digits == 0) {
        return std::nullopt;
    }
    try {
        const auto proved = ode::prove_radius(system, digits);
        if (proved.infinite) {
            return std::nullopt;
        }
        std::size_t place = proved.evidence->evidence.unknown;
        std::string name = ode::first_order_form(system).names[place];
        name.resize(name.find_last_not_of('\'') + 1);  // x' is singular where x is
        return proved_for_unknown{midpoint_of(proved.lower), name};
    } catch (const error&) {  // no proof is undecided, a singular start refused
        return std::nullopt;
    }
}

// The same singularity, as far as a verdict tells.
bool agrees(const mpfr& verdict, const mpfr& proved) { return abs(mpfr(verdict / proved - 1)) * 1000 < 1; }

true_radius truth_of(const std::string& unknown, const std::optional<mpfr>& verdict,
                     const std::optional<proved_for_unknown>& proved) {
    if (proved && proved->unknown == unknown) {
        return {proved->radius, "proved"};
    }
    if (proved && verdict && agrees(*verdict, proved->radius)) {
        return {proved->radius, "proved from below"};
    }
    return {verdict, verdict ? "verdict" : ""};
}

std::vector<table> tables_at(const equation_sweep& sweep, std::size_t i, const std::vector<int>& orders,
                             const scalar_spec& scalar, long proved_digits) {
    const reference_list longer = reference_for(orders, scalar);
    const precision_scope scope(longer.scalar.digits + guard_of_lists);
    const auto lists = lists_about_start(sweep.system(i), longer.order, longer.scalar.digits + guard_of_lists);
    const auto proved = proved_radius_of(sweep.system(i), proved_digits);
    std::map<std::string, true_radius> reference;
    for (const auto& each : answers_to(lists, sweep, {longer.order}, longer.scalar, is_verdict)) {
        reference[each.unknown] = truth_of(each.unknown, each.found.radius, proved);
    }
    std::vector<judged_row> rows;
    for (auto& each : answers_to(lists, sweep, orders, scalar, [](const std::string&) { return true; })) {
        const auto& truth = reference[each.unknown];
        const auto difference = each.found.radius && truth.radius
                                    ? std::optional(mpfr(abs(*each.found.radius / *truth.radius - 1)))
                                    : std::optional<mpfr>();
        const std::string unknown = each.unknown;
        rows.push_back({std::move(each), difference, truth.by, unknown});
    }
    return {make_table(columns(), rows)};
}

study_plan plan(const shared_problem& problem, const study_request& request) {
    const auto sweep = sweep_of(problem, request);
    const auto orders = orders_from(request, least_order_of_lists, "is too short a list for a radius test");
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:30"));
    const auto digits = request.digits();
    if (digits.size() != 1 || digits.front() > most_proved_digits) {
        throw input_error("--digits", digits.empty() ? "" : std::to_string(digits.back()),
                          "is not one number from 0 to 60", "write --digits 20, or 0 for no proof");
    }
    return plan_by_parameters({head_of(*sweep, "", scalar, columns())}, sweep,
                              [sweep, orders, scalar, proved_digits = digits.front()](std::size_t i) {
                                  return tables_at(*sweep, i, orders, scalar, proved_digits);
                              });
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
            "What every test says of the first N coefficients, as its relative difference from the radius, which a "
            "covering of the disc and a loop round the nearest singularity prove. Where they do not (the column truth "
            "says so) it is measured from the verdict on a list half as long again with more digits, and shows which "
            "tests agree with what all of them say later.",
        .parameters = {{"--orders", "10:100:10", "N, last powers of the lists judged"},
                       {"--scalar", "mpfr:30", "arithmetic of the lists that are judged"},
                       {"--digits", "20", "D, to which the radius is proved; 0: it is not"}},
        .example = {"rayleigh", {}},
        .example_words = {},
        .quick = {{"--orders", "12,20"}, {"--digits", "5"}},
        .seconds = 3,
        .plan = plan};
    return result;
}

}  // namespace libration::studies::of_equation
