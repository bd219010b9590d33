// How many digits do solvers of initial value problems deliver, and for how many evaluations of the right-hand side?
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../shared/named_choice.hpp"
#include "libration/ode/proved/condition_numbers.hpp"
#include "libration/problem/problem_family.hpp"
#include "solution_facts.hpp"
#include "solver_peers.hpp"
#include "sweep/study.hpp"
#include "test_problems.hpp"
#include "text/members.hpp"

namespace libration::studies {

namespace solvers_study {

using proved::solver_answer;
using proved::solver_peer;
using proved::solver_peers;
using proved::solver_run;
using proved::test_problem;

namespace {

constexpr long truth_digits = 20;

// The result of a solver for a problem.
struct solver_row {
    std::string problem;
    std::string solver, version;
    std::string method, tolerance;
    std::string outcome;
    long evaluations = 0;
    std::optional<mpfr> error;
    std::string unknown, time;  ///< where that error occurs
    mpfr by_rounding;
};

cell error_cell(const std::optional<mpfr>& error) { return error ? decimal_cell(*error, 3) : cell(); }

cell digits_cell(const std::optional<mpfr>& error) {
    return error && *error > 0 ? decimal_cell(mpfr(-log10(*error)), 3) : cell();
}

const column_list<solver_row>& columns() {
    using row = solver_row;
    static const column_list<row> all{
        {"problem", "name in the set of test problems", [](const row& r) { return r.problem; }},
        {"solver", "library", [](const row& r) { return r.solver; }},
        {"version", "of it; empty where it is not installed", [](const row& r) { return r.version; }},
        {"method", "of the library, by its own name", [](const row& r) { return r.method; }},
        {"tolerance", "asked of it, relative and absolute", [](const row& r) { return number_cell(r.tolerance); }},
        {"outcome",
         "ended; stopped: at 200000 evaluations, of mpmath at 20000; failed: it gave up or left the range of double; "
         "not installed",
         [](const row& r) { return r.outcome; }},
        {"evaluations", "of the right sides, those for its Jacobian among them",
         [](const row& r) { return r.version.empty() ? cell() : cell(r.evaluations); }},
        {"error",
         "largest |value - proved value| over the times and unknowns, each relative to the largest |value| of the "
         "unknown at the times",
         [](const row& r) { return error_cell(r.error); }},
        {"digits", "-log10 of error", [](const row& r) { return digits_cell(r.error); }},
        {"unknown", "where the error is largest", [](const row& r) { return r.unknown; }},
        {"time", "where it is", [](const row& r) { return number_cell(r.time); }},
        {"rounding",
         "the error, to first order, of starts and parameters that are doubles, measured as error is; constants in the "
         "equations are not counted",
         [](const row& r) { return decimal_cell(r.by_rounding, 3); }},
        {"rigour", "of the values that errors are measured from", [](const row&) { return "proved"; }},
    };
    return all;
}

// Stiff and nonstiff problems whose reference values take two minutes at most.
const named_choice& problems_to_choose() {
    static const named_choice result{.axis = "problem",
                                     .option = "--problems",
                                     .help = "problems of the set",
                                     .forms = "LIST, or all",
                                     .remedy = "write names such as lorenz,kepler, or all",
                                     .what = "not a problem of this study",
                                     .names = {"arenstorf",
                                               "brusselator",
                                               "detest_a3",
                                               "detest_d5",
                                               "double_pendulum",
                                               "duffing",
                                               "fitzhugh_nagumo",
                                               "henon_heiles",
                                               "hires",
                                               "kepler",
                                               "logistic",
                                               "lorenz",
                                               "lotka_volterra",
                                               "oregonator",
                                               "pendulum_179deg",
                                               "robertson",
                                               "seir",
                                               "three_body_figure_8",
                                               "van_der_pol",
                                               "van_der_pol_100"}};
    return result;
}

const named_choice& solvers_to_choose() {
    static const named_choice result{.axis = "solver",
                                     .option = "--solvers",
                                     .help = "libraries",
                                     .forms = "LIST of odeint, gsl, sundials, scipy and mpmath, or all",
                                     .remedy = "write names such as odeint,gsl, or all",
                                     .what = "not a solver of this study",
                                     .names = members_of(solver_peers(), &solver_peer::name)};
    return result;
}

const test_problem& problem_named(const std::string& name) { return named(proved::test_problems(), name); }

// The proved values of a problem at its times, and the scales of errors.
class judge {
public:
    explicit judge(const test_problem& of)
        : of_(of),
          system_(of.equations()),
          names_(ode::first_order_form(system_).names),
          times_(of.times()),
          states_(ode::proved_conditions(of.equations(), times_, truth_digits)) {
        scale_.assign(names_.size(), mpfr(0));
        for (const auto& state : states_) {
            auto& values = values_.emplace_back();
            for (std::size_t k = 0; k < names_.size(); ++k) {
                values.push_back(proved::number_in(state.values[k].text));
                scale_[k] = std::max(scale_[k], mpfr(abs(values[k])));
            }
        }
        for (const auto& state : states_) {
            for (std::size_t k = 0; k < names_.size(); ++k) {
                by_rounding_ = std::max(by_rounding_, relative(state.moved[k].by_rounding, k));
            }
        }
    }

    proved::solver_input input() const { return {system_, times_}; }
    std::size_t times() const { return times_.size(); }

    solver_row row_of(const solver_peer& peer, const std::string& version, const solver_run& run,
                      const solver_answer& answer) const {
        solver_row row{of_.name,           peer.name, version, run.method, run.tolerance, answer.outcome,
                       answer.evaluations, {},        "",      "",         by_rounding_};
        for (std::size_t i = 0; i < answer.values.size(); ++i) {
            if (!std::isfinite(answer.values[i])) {
                row.outcome = "failed";
                row.error.reset();
                return row;
            }
            const std::size_t k = i % names_.size();
            const std::size_t time = i / names_.size();
            const mpfr error = relative(mpfr(abs(mpfr(answer.values[i]) - values_[time][k])), k);
            if (!row.error || error > *row.error) {
                row.error = error;
                row.unknown = names_[k];
                row.time = proved::decimal_in(times_[time]);
            }
        }
        return row;
    }

    solver_row row_without(const solver_peer& peer) const {
        return {of_.name, peer.name, "", "", "", "not installed", 0, {}, "", "", by_rounding_};
    }

private:
    mpfr relative(const mpfr& error, std::size_t k) const { return scale_[k] == 0 ? error : mpfr(error / scale_[k]); }

    test_problem of_;
    ode::explicit_system system_;
    std::vector<std::string> names_;
    std::vector<ode::number> times_;
    std::vector<ode::conditioned_state> states_;
    std::vector<std::vector<mpfr>> values_;
    std::vector<mpfr> scale_;
    mpfr by_rounding_{0};
};

// A requested peer, and the version it reports.
struct asked_peer {
    solver_peer peer;
    std::optional<std::string> version;
};

std::vector<asked_peer> asked_peers(const study_request& request) {
    std::vector<asked_peer> all;
    for (const std::string& name : chosen_names(solvers_to_choose(), request.values)) {
        const solver_peer& peer = named(solver_peers(), name);
        all.push_back({peer, proved::version_of(peer)});
    }
    return all;
}

std::string versions_of(const std::vector<asked_peer>& peers) {
    std::string all;
    for (const asked_peer& each : peers) {
        all += (all.empty() ? "" : "; ") + (each.version ? *each.version : each.peer.name + " not installed");
    }
    return all;
}

std::vector<table> tables_of(const std::string& problem, const std::vector<asked_peer>& peers,
                             const std::vector<exact>& tolerances) {
    const precision_scope scope(truth_digits + 10);
    const judge by(problem_named(problem));
    std::vector<solver_row> rows;
    for (const auto& [peer, version] : peers) {
        if (!version) {
            rows.push_back(by.row_without(peer));
            continue;
        }
        std::vector<solver_run> runs;
        for (const std::string& method : peer.methods) {
            for (const exact& tolerance : tolerances) {
                runs.push_back({method, decimal_of(tolerance, 17)});
            }
        }
        const auto answers = proved::answers_of(peer, by.input(), by.times(), runs);
        for (std::size_t i = 0; i < runs.size(); ++i) {
            rows.push_back(by.row_of(peer, *version, runs[i], answers[i]));
        }
    }
    return {make_table(columns(), rows)};
}

study_plan plan(const study_request& request) {
    const auto problems = chosen_names(problems_to_choose(), request.values);
    const auto peers = asked_peers(request);
    study_plan result = plan_of_cells(
        {head_of("", {scalar_kind::proved, truth_digits}, columns())}, {"problem", "versions"}, problems.size(),
        [problems, versions = versions_of(peers)](std::size_t i) {
            return cell_inputs{{"problem", problems[i]}, {"versions", versions}};
        },
        [problems, peers, tolerances = request.values.of("tolerance")](std::size_t i) {
            return tables_of(problems[i], peers, tolerances);
        });
    result.cost = [problems](std::size_t i) { return 10.0 + problem_named(problems[i]).seconds; };
    return result;
}

void check_tolerance(const exact& each) {
    require_plain_number(each);
    const double value = std::strtod(decimal_of(each, 17).c_str(), nullptr);
    if (!(value >= 1e-15 && value <= 0.1)) {
        throw error(error_kind::argument, "list", "", "has '" + each.text + "', which is not between 1e-15 and 0.1");
    }
}

const problem_family& problems_of_study() {
    static const problem_family result{.name = "test problems",
                                       .axes = {axis_of(problems_to_choose()),
                                                axis_of(solvers_to_choose()),
                                                {.name = "tolerance",
                                                 .option = "--tolerances",
                                                 .help = "requested tolerances of the solvers, relative and absolute",
                                                 .form = axis_form::numbers,
                                                 .remedy = "write a list such as 1e-4,1e-8,1e-12",
                                                 .check = check_tolerance,
                                                 .coordinate = "tolerance"}}};
    return result;
}

}  // namespace
}  // namespace solvers_study

const study& solvers() {
    using namespace solvers_study;
    static const study result{
        .name = "solvers",
        .title = "Solvers of initial value problems, judged",
        .question =
            "How many digits do solvers of initial value problems deliver, and for how many evaluations of the right "
            "sides?",
        .reading =
            "Digits against the number of evaluations, one panel a problem, one curve a method: a point for each "
            "tolerance that was asked. The error is the largest over eight times and all unknowns, measured from "
            "proved values, each unknown by its largest value. Solvers work in double and are handed starts and "
            "parameters that are rounded to it; dotted is the error, to first order, that this alone makes. A run ends "
            "at 200000 evaluations, of mpmath at 20000, for each takes it long. Boost.odeint, "
            "GSL, SUNDIALS, SciPy and mpmath answer where they are installed.",
        .of = &problems_of_study(),
        .parameters = {{"--problems", "all", "twenty problems of the reference set"},
                       {"--solvers", "all", "libraries"},
                       {"--tolerances", "1e-3,1e-5,1e-7,1e-9,1e-11,1e-13", "relative and absolute"}},
        .quick = {{"--problems", "logistic", ""}, {"--solvers", "odeint", ""}, {"--tolerances", "1e-4,1e-8", ""}},
        .seconds = 300,
        .plan = plan,
        .offers = arithmetics::proved_too};
    return result;
}

}  // namespace libration::studies
