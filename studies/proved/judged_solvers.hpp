// Solvers of initial value problems judged by proved values, for the studies `solvers` and `stiff_solvers`.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../shared/named_choice.hpp"
#include "libration/problem/problem_family.hpp"
#include "libration/query/condition_numbers.hpp"
#include "libration/query/states.hpp"
#include "solution_facts.hpp"
#include "solver_peers.hpp"
#include "sweep/study.hpp"
#include "test_problems.hpp"

namespace libration::studies::proved {

inline constexpr long truth_digits = 20;

// The result of a solver for a problem.
struct solver_row {
    std::string problem;
    std::string solver, version;
    std::string method, tolerance;
    std::string outcome;
    long evaluations = 0;
    std::optional<mpfr> error;
    std::string unknown, time;  ///< where that error occurs
    std::optional<mpfr> by_rounding;
};

inline cell error_cell(const std::optional<mpfr>& error) { return error ? decimal_cell(*error, 3) : cell(); }

inline cell digits_cell(const std::optional<mpfr>& error) {
    return error && *error > 0 ? decimal_cell(mpfr(-log10(*error)), 3) : cell();
}

inline const column_list<solver_row>& solver_columns() {
    using row = solver_row;
    static const column_list<row> all{
        {"problem", "name in the set of test problems", [](const row& r) { return r.problem; }},
        {"solver", "library", [](const row& r) { return r.solver; }},
        {"version", "of it; empty where it is not installed", [](const row& r) { return r.version; }},
        {"method", "of the library, by its own name", [](const row& r) { return r.method; }},
        {"tolerance",
         "asked of it, relative and absolute; of stiff problems relative to the largest |value| of each unknown",
         [](const row& r) { return number_cell(r.tolerance); }},
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
         "equations are not counted, and stiff problems have none",
         [](const row& r) { return error_cell(r.by_rounding); }},
        {"rigour", "of the values that errors are measured from", [](const row&) { return "proved"; }},
    };
    return all;
}

inline const test_problem& problem_named(const std::string& name) { return named(test_problems(), name); }

// The proved values of a problem at its times, and the scales of errors.
class solver_judge {
public:
    explicit solver_judge(const test_problem& of)
        : of_(of),
          system_(of.equations()),
          names_(ode::first_order_form(system_).names),
          times_(of.times()),
          scale_(names_.size(), mpfr(0)) {
        if (of.is_stiff()) {
            for (const auto& state : ode::proved_trajectory(system_, times_, truth_digits)) {
                add(state);
            }
            return;
        }
        const auto states = ode::proved_conditions(of.equations(), times_, truth_digits);
        for (const auto& state : states) {
            add(state.values);
        }
        by_rounding_ = mpfr(0);
        for (const auto& state : states) {
            for (std::size_t k = 0; k < names_.size(); ++k) {
                by_rounding_ = std::max(*by_rounding_, relative(state.moved[k].by_rounding, k));
            }
        }
    }

    // Stiff problems often have unknowns of very different sizes.
    solver_input input() const {
        std::vector<double> scales(names_.size(), 1);
        for (std::size_t k = 0; of_.is_stiff() && k < scales.size(); ++k) {
            scales[k] = scale_[k] > 0 ? scale_[k].convert_to<double>() : 1;
        }
        return {system_, times_, scales};
    }
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
                row.time = decimal_in(times_[time]);
            }
        }
        return row;
    }

    solver_row row_without(const solver_peer& peer) const {
        return {of_.name, peer.name, "", "", "", "not installed", 0, {}, "", "", by_rounding_};
    }

private:
    void add(const std::vector<proved_decimal>& state) {
        auto& values = values_.emplace_back();
        for (std::size_t k = 0; k < names_.size(); ++k) {
            values.push_back(number_in(state[k].text));
            scale_[k] = std::max(scale_[k], mpfr(abs(values[k])));
        }
    }

    mpfr relative(const mpfr& error, std::size_t k) const { return scale_[k] == 0 ? error : mpfr(error / scale_[k]); }

    test_problem of_;
    ode::explicit_system system_;
    std::vector<std::string> names_;
    std::vector<ode::number> times_;
    std::vector<std::vector<mpfr>> values_;
    std::vector<mpfr> scale_;
    std::optional<mpfr> by_rounding_;
};

// A requested peer, and the version it reports.
struct asked_peer {
    solver_peer peer;
    std::optional<std::string> version;
};

inline std::vector<asked_peer> asked_peers(const named_choice& solvers, const study_request& request) {
    std::vector<asked_peer> all;
    for (const std::string& name : chosen_names(solvers, request.values)) {
        const solver_peer& peer = named(solver_peers(), name);
        all.push_back({peer, version_of(peer)});
    }
    return all;
}

inline std::string versions_of(const std::vector<asked_peer>& peers) {
    std::string all;
    for (const asked_peer& each : peers) {
        all += (all.empty() ? "" : "; ") + (each.version ? *each.version : each.peer.name + " not installed");
    }
    return all;
}

inline std::vector<table> tables_of_solvers(const std::string& problem, const std::vector<asked_peer>& peers,
                                            const std::vector<exact>& tolerances) {
    const precision_scope scope(truth_digits + 10);
    const test_problem& of = problem_named(problem);
    const solver_judge by(of);
    std::vector<solver_row> rows;
    for (const auto& [peer, version] : peers) {
        if (!version) {
            rows.push_back(by.row_without(peer));
            continue;
        }
        std::vector<solver_run> runs;
        for (const std::string& method : of.is_stiff() ? peer.implicit_methods : peer.methods) {
            for (const exact& tolerance : tolerances) {
                runs.push_back({method, decimal_of(tolerance, 17)});
            }
        }
        const auto answers = answers_of(peer, by.input(), by.times(), runs);
        for (std::size_t i = 0; i < runs.size(); ++i) {
            rows.push_back(by.row_of(peer, *version, runs[i], answers[i]));
        }
    }
    return {make_table(solver_columns(), rows)};
}

inline void check_tolerance(const exact& each) {
    require_plain_number(each);
    const double value = std::strtod(decimal_of(each, 17).c_str(), nullptr);
    if (!(value >= 1e-15 && value <= 0.1)) {
        throw error(error_kind::argument, "list", "", "has '" + each.text + "', which is not between 1e-15 and 0.1");
    }
}

inline named_choice choice_of_solvers(const std::string& forms, const std::string& remedy,
                                      std::vector<std::string> names) {
    return {.axis = "solver",
            .option = "--solvers",
            .help = "libraries",
            .forms = forms,
            .remedy = remedy,
            .what = "not a solver of this study",
            .names = std::move(names)};
}

inline named_choice choice_of_problems(const std::string& remedy, std::vector<std::string> names) {
    return {.axis = "problem",
            .option = "--problems",
            .help = "problems of the set",
            .forms = "LIST, or all",
            .remedy = remedy,
            .what = "not a problem of this study",
            .names = std::move(names)};
}

/// The axes of a study of solvers, and its plan.
class solver_choices {
public:
    solver_choices(named_choice problems, named_choice solvers)
        : problems_(std::move(problems)),
          solvers_(std::move(solvers)),
          family_{.name = "test problems",
                  .axes = {axis_of(problems_),
                           axis_of(solvers_),
                           {.name = "tolerance",
                            .option = "--tolerances",
                            .help = "requested tolerances of the solvers, relative and absolute",
                            .form = axis_form::numbers,
                            .remedy = "write a list such as 1e-4,1e-8,1e-12",
                            .check = check_tolerance,
                            .coordinate = "tolerance"}}} {}

    const problem_family& family() const { return family_; }

    study_plan plan(const study_request& request) const {
        const auto problems = chosen_names(problems_, request.values);
        const auto peers = asked_peers(solvers_, request);
        study_plan result = plan_of_cells(
            {head_of("", {scalar_kind::proved, truth_digits}, solver_columns())}, {"problem", "versions"},
            problems.size(),
            [problems, versions = versions_of(peers)](std::size_t i) {
                return cell_inputs{{"problem", problems[i]}, {"versions", versions}};
            },
            [problems, peers, tolerances = request.values.of("tolerance")](std::size_t i) {
                return tables_of_solvers(problems[i], peers, tolerances);
            });
        result.cost = [problems](std::size_t i) { return 10.0 + problem_named(problems[i]).seconds; };
        return result;
    }

private:
    named_choice problems_, solvers_;
    problem_family family_;
};

}  // namespace libration::studies::proved
