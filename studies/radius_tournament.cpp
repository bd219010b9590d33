// Which radius test is reliable, on series whose radius is known?
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "libration/equation/first_order_form.hpp"
#include "libration/plane/proved_singularity.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "tournament_scores.hpp"
#include "tournament_values.hpp"

namespace libration::studies {

namespace radius_tournament_study {

namespace of_pendulum {

using namespace convergence;
using namespace tournament_results;

namespace {

// The problems in the precision of each scalar, computed once.
std::vector<problem_list> problems_in(const std::vector<scalar_spec>& scalars, const study_request& request) {
    const pendulum_sweep sweep(request.values);
    const int lists = request.values.counts("lists").front();
    const int seed = request.values.counts("seed").front();
    std::vector<problem_list> all;
    for (const scalar_spec& scalar : scalars) {
        const precision_scope scope(scalar.digits + score_guard_digits);
        all.push_back(problems_of(sweep, lists, seed));
    }
    return all;
}

// Ranking and coverage from the scores of all answers.
void derive_rankings(std::vector<study_table>& tables) {
    const precision_scope scope(digits_of_scores);
    std::vector<scored_answer> answers;
    answers.reserve(tables[1].data.rows().size());
    for (const table_row_cells& row : tables[1].data.rows()) {
        answers.push_back(score_in(row));
    }
    tables[3].data = ranking(answers);
    tables[4].data = coverage(answers);
    tables[5].data = value_scores(tables[2].data);
}

// The groups of a plan: every problem in every scalar, then the lists with known values.
struct tournament {
    std::vector<scalar_spec> scalars;
    std::vector<problem_list> problems;  // by scalar
    int lists = 0, seed = 0;             // with known values

    struct contest {
        const known_series<mpfr>& problem;
        std::string half;
        const scalar_spec& scalar;
    };

    std::size_t contests() const { return problems.front().size() * scalars.size(); }
    std::size_t size() const { return contests() + static_cast<std::size_t>(lists); }
    bool is_value(std::size_t i) const { return i >= contests(); }
    int list_at(std::size_t i) const { return static_cast<int>(i - contests()); }
    contest at(std::size_t i) const {
        const std::size_t in = i % scalars.size();
        const std::size_t which = i / scalars.size();
        return {problems[in][which], which % 2 == 0 ? "calibration" : "judged", scalars[in]};
    }
};

study_plan plan(const study_request& request) {
    const auto all = std::make_shared<tournament>();
    all->scalars =
        request.scalar ? std::vector{*request.scalar} : std::vector{read_scalar("double"), read_scalar("mpfr:60")};
    all->problems = problems_in(all->scalars, request);
    all->lists = request.values.counts("lists").front();
    all->seed = request.values.counts("seed").front();
    const scalar_spec& last = all->scalars.back();
    const scalar_spec exact_lists{scalar_kind::arbitrary, digits_of_lists_to_sum};
    study_plan plan = plan_of_values(
        {head_of("", last, columns()), head_of("scores", last, score_columns()),
         head_of("values", exact_lists, value_columns()), head_of("ranking", last, ranking_columns()),
         head_of("coverage", last, coverage_columns()), head_of("value_coverage", exact_lists, value_score_columns())},
        {"energy", "gap", "point", "lists", "seed", "order"}, all->size(),
        [all](std::size_t i) {
            if (all->is_value(i)) {
                return cell_inputs{{"value of list", std::to_string(all->list_at(i))},
                                   {"seed", std::to_string(all->seed)}};
            }
            const auto& [problem, half, scalar] = all->at(i);
            return cell_inputs{{"problem", problem.name}, {"half", half}, {"scalar", scalar.name()}};
        },
        orders_from(request, 0, ""),
        [all](std::size_t i, const std::vector<int>& orders) {
            if (all->is_value(i)) {
                const std::vector<judged_answer> none;
                return std::vector<table>{
                    make_table(columns(), none), make_table(score_columns(), none),
                    make_table(value_columns(), values_of_drawn(all->list_at(i), all->seed, orders))};
            }
            const auto& [problem, half, scalar] = all->at(i);
            const precision_scope scope(scalar.digits + score_guard_digits);
            const auto answers = answers_of(problem, half, orders, scalar);
            return std::vector<table>{make_table(columns(), answers), make_table(score_columns(), answers),
                                      make_table(value_columns(), std::vector<judged_value>())};
        });
    plan.tables[1].written = false;
    // The cost of a list is that of its arithmetic, some tens of times more without hardware support.
    plan.cost = [all](std::size_t i) {
        if (all->is_value(i)) {
            return static_cast<double>(digits_of_lists_to_sum);
        }
        const scalar_spec& scalar = all->at(i).scalar;
        return scalar.kind == scalar_kind::arbitrary ? static_cast<double>(scalar.digits) : 1.0;
    };
    plan.derive = derive_rankings;
    return plan;
}

}  // namespace
}  // namespace of_pendulum

namespace of_equation {

namespace {

constexpr int most_proved_digits = 60;

struct judged_row {
    answered_list of;
    std::optional<mpfr> difference;
    std::string truth;
};

const column_list<judged_row>& columns() {
    using row = judged_row;
    const column_list<row> own{
        {"difference", "|radius/R - 1|, R as `truth` says, to 10^-D where it is proved; empty without one",
         [](const row& r) { return decimal_cell(r.difference, 6); }},
        {"log10_difference", "log10 of difference", [](const row& r) { return log10_cell(r.difference); }},
        {"truth",
         "R: proved | proved from below: the radius that another unknown is proved to have, which the verdict on the "
         "reference list agrees with | verdict: that verdict, so that difference measures agreement and not truth",
         [](const row& r) { return r.truth; }},
    };
    static const auto all =
        columns_named("order,method,radius,uncertainty,difference,log10_difference,note,truth,unknown",
                      joined(own, columns_within(answer_columns(), &row::of)));
    return all;
}

// A list half as long again as the longest one under test, with correspondingly more digits.
struct reference_list {
    int order;
    scalar_spec scalar;
};

reference_list reference_for(const std::vector<int>& orders, const scalar_spec& scalar) {
    return {orders.back() * 3 / 2, {scalar_kind::arbitrary, scalar.digits + 20}};
}

// The reference radius of the tests.
struct true_radius {
    std::optional<mpfr> radius;
    std::string by;
};

// A radius that a covering and a loop prove for one unknown, and a lower bound for all.
struct proved_for_unknown {
    mpfr radius;
    std::string unknown;
};

// Returns std::nullopt if there is no proof.
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
    } catch (const error&) {  // a missing proof throws undecided, a singular initial point another error
        return std::nullopt;
    }
}

// Whether the singularity is the same, to the accuracy of a verdict.
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
    for (answered_list& each : answers_to(lists, sweep, orders, scalar, is_any_test)) {
        const auto& truth = reference[each.unknown];
        each.true_radius = truth.radius;
        const auto difference = relative_error(each);
        rows.push_back({std::move(each), difference, truth.by});
    }
    return {make_table(columns(), rows)};
}

study_plan plan(const study_request& request) {
    const auto sweep = equation_sweep_of(request);
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
}  // namespace of_equation
}  // namespace radius_tournament_study

const study& radius_tournament() {
    using namespace radius_tournament_study;
    static const study result{
        .name = "radius_tournament",
        .title = "A tournament of radius tests",
        .question = "Which radius test can be trusted, on series whose radius is known?",
        .reading =
            "Every test sees a list of coefficients and nothing else: theta of the pendulum about several points, and "
            "functions with poles, logarithms, branch points, several singularities on or near the circle, none at "
            "all, or a natural boundary; and random lists of known radius, drawn from families of these and of "
            "confluent "
            "singularities, logarithms upon powers and noise. Left: correct digits of the radius, mean over all series "
            "that have one, no "
            "answer counted as none; each further mark is twice the coefficients. The textbook tests of ratios and "
            "roots gain a digit for ten times the coefficients; fitted recurrences (poles, differential approximants) "
            "take what the arithmetic holds. Right: how often the error was within the uncertainty that came with it, "
            "on the half of the series by which nothing was calibrated, and how much larger than the error the "
            "uncertainty was at the median. The table values has sums of other random lists at a point, inside the "
            "circle of convergence, beyond it and of divergent series, against closed forms. No test gave a radius to "
            "an entire or a divergent series. All of it is "
            "heuristic: coefficients prove no radius.",
        .of = &pendulum_problem(),
        .parameters = {{"--energies", "0.01,0.5,1,1.5,1.71,1.9998,2.02,2.5,4,10",
                        "energies E of the pendulum, in m g l"},
                       {"--gaps", "1e-10,-1e-10", "energies as 2 - E"},
                       {"--points", "0,2/5,1", "expansion points, fractions of T*: 0 the top, 1 the bottom"},
                       {"--orders", "20,40,80", "N, last powers of the lists"},
                       {"--lists", "46", "random lists, of the families in turn"},
                       {"--seed", "1", "from which they are drawn"},
                       {"--scalar", "double and mpfr:60", "arithmetic of coefficients and tests"}},
        .quick = {{"--energies", "1", ""},
                  {"--orders", "20", ""},
                  {"--lists", "3", ""},
                  {"--points", "0", ""},
                  {"--scalar", "double", ""}},
        .seconds = 240,
        .excluded = no_answer_at_limits("theta is constant and every radius infinite", "T* is infinite"),
        .plan = of_pendulum::plan,
        .version = 5,
        .any_equation = equation_form{
            .plan = of_equation::plan,
            .title = "The radius tests",
            .question = "Which radius test settles with the fewest coefficients?",
            .reading =
                "What every test says of the first N coefficients, as its relative difference from the radius, which a "
                "covering of the disc and a loop round the nearest singularity prove. Where they do not (the column "
                "truth says so) it is measured from the verdict on a list half as long again with more digits, and "
                "shows which tests agree with what all of them say later.",
            .parameters = {{"--orders", "10:100:10", "N, last powers of the lists under test"},
                           {"--scalar", "mpfr:30", "arithmetic of the lists under test"},
                           {"--digits", "20", "D, digits to which the radius is proved; 0: no proof"}},
            .example = {"rayleigh", {}},
            .quick = {{"--orders", "12,20"}, {"--digits", "5"}},
            .seconds = 3}};
    return result;
}

}  // namespace libration::studies
