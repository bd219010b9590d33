// Which radius test is reliable, on series whose radius is known?
#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "libration/convergence/known/known_series.hpp"
#include "libration/convergence/list/coefficient_unit.hpp"
#include "libration/convergence/radius_report.hpp"
#include "libration/ode/first_order_form.hpp"
#include "libration/ode/proved/proved_singularity.hpp"
#include "libration/pendulum/error/known_arc_series.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "shared/list_answers.hpp"
#include "shared/sweep_columns.hpp"
#include "shared/sweep_plan.hpp"

namespace libration::studies {

namespace radius_tournament_study {

namespace of_pendulum {

using namespace series;
using namespace convergence;
using namespace pendulum;

namespace {

constexpr long guard_digits = 30;
constexpr long digits_of_errors = 6;
constexpr long digits_of_scores = digits_of_errors + guard_digits;

// The problems in one precision.
using problem_list = std::vector<known_series<mpfr>>;

// A motion of the pendulum as a problem: named by its energy, or by its gap if that was given.
std::string label_of(const sweep_energy& at, const exact& point) {
    const std::string energy = at.energy_typed.empty() ? "2-E=" + at.gap_typed : "E=" + at.energy_typed;
    return "pendulum " + energy + " x=" + point.text;
}

// All problems, in the working precision in force.
problem_list problems_of(const pendulum_sweep& sweep) {
    auto all = all_known_series<mpfr>();
    for (const sweep_energy& at : sweep.energies) {
        for (const exact& point : sweep.points) {
            all.push_back(known_arc_series(label_of(at, point), motion::of_energy(at.value), point.coefficient));
        }
    }
    return all;
}

// One result and its error.
struct judged_answer {
    std::string problem, half, method, scalar;
    int order;
    long digits;
    radius_estimate<mpfr> found;
    std::optional<mpfr> radius;  // the exact one; none for an entire function
    singularity_kind kind;
    int count;
    bool covered = false;
    mpfr reached = 0;           // correct digits
    std::optional<mpfr> error;  // relative
    std::optional<mpfr> ratio;  // uncertainty/error

    bool has_radius() const { return radius && *radius > 0; }
    bool answered() const { return found.radius.has_value(); }
};

std::string kind_text(singularity_kind kind) { return kind == singularity_kind::unknown ? "" : name_of(kind); }

cell covered_cell(const judged_answer& r) {
    return r.has_radius() && !r.answered() ? cell() : cell(r.covered ? "yes" : "no");
}

column_list<judged_answer> columns_of_truth() {
    using row = judged_answer;
    return {
        {"kind", "of the nearest singularities by the verdict", [](const row& r) { return kind_text(r.found.kind); }},
        {"exact_kind", "of the one of least argument, truly; empty where there is none",
         [](const row& r) { return kind_text(r.kind); }},
        {"count", "nearest singularities as the test sees them",
         [](const row& r) { return r.found.count > 0 ? cell(r.found.count) : cell(); }},
        {"exact_count", "truly; 0 for none and for a boundary", [](const row& r) { return r.count; }},
        {"note", "why there is no radius, or what a reader should know", [](const row& r) { return r.found.note; }}};
}

column_list<judged_answer> columns_of_error() {
    using row = judged_answer;
    return {
        {"relative_error", "|radius/exact - 1|", [](const row& r) { return decimal_cell(r.error, digits_of_errors); }},
        {"log10_relative_error", "log10 of relative_error; empty where it is 0",
         [](const row& r) { return r.ratio ? log10_cell(r.error) : cell(); }},
        {"digits", "correct digits of the radius, at most those of the scalar",
         [](const row& r) { return r.error ? decimal_cell(r.reached, digits_of_errors) : cell(); }},
        {"uncertainty_over_error", "empty where the error is 0",
         [](const row& r) { return decimal_cell(r.ratio, digits_of_errors); }},
        {"covered", "yes: the error is within the uncertainty, or no radius is given where there is none | no",
         covered_cell}};
}

const column_list<judged_answer>& columns() {
    using row = judged_answer;
    static const auto all = joined(
        joined<row>(
            {{"problem", "the function, or theta of the pendulum: its energy and expansion point",
              [](const row& r) { return r.problem; }},
             {"half", "calibration: safety factors were chosen on it; judged: not used for that",
              [](const row& r) { return r.half; }},
             {"order", "N, last power of the list", [](const row& r) { return r.order; }},
             {"scalar", "arithmetic of the coefficients and of the tests", [](const row& r) { return r.scalar; }},
             {"method", "radius test, or the verdict of all", [](const row& r) { return r.method; }},
             {"radius", "estimated; empty where the test gives none",
              [](const row& r) { return decimal_cell(r.found.radius, r.digits); }},
             {"uncertainty", "of the radius, by the test itself",
              [](const row& r) { return r.answered() ? decimal_cell(r.found.uncertainty, digits_of_errors) : cell(); }},
             {"exact", "radius of convergence; inf for an entire function, 0 for a divergent series",
              [](const row& r) { return r.radius ? decimal_cell(*r.radius, r.digits) : number_cell("inf"); }}},
            columns_of_error()),
        columns_of_truth());
    return all;
}

// Digits of agreement, between 0 and the maximum of the scalar.
mpfr correct_digits(const mpfr& relative_error, long most) {
    const mpfr reached = relative_error == 0 ? mpfr(most) : mpfr(-log10(relative_error));
    return std::clamp(reached, mpfr(0), mpfr(most));
}

judged_answer judge(const known_series<mpfr>& problem, const std::string& half, int order, const scalar_spec& scalar,
                    const radius_estimate<mpfr>& found) {
    judged_answer answer{problem.name,  half,    found.method,   scalar.name(), order,
                         scalar.digits, found,   problem.radius, problem.kind,  problem.count,
                         false,         mpfr(0), std::nullopt,   std::nullopt};
    if (!answer.has_radius()) {
        answer.covered = !answer.answered();
    } else if (answer.answered()) {
        const mpfr away = abs(*found.radius - *problem.radius);
        answer.error = away / *problem.radius;
        answer.covered = away <= found.uncertainty;
        answer.reached = correct_digits(*answer.error, scalar.digits);
        if (away != 0) {
            answer.ratio = found.uncertainty / away;
        }
    }
    return answer;
}

// All tests on one problem in one scalar, at all orders.
std::vector<judged_answer> answers_of(const known_series<mpfr>& problem, const std::string& half,
                                      const std::vector<int>& orders, const scalar_spec& scalar) {
    std::vector<judged_answer> answers;
    const power_series<mpfr> wide = problem.expand(orders.back());
    for (const int order : orders) {
        const power_series<mpfr> list = wide.truncated(order);
        const coefficient_unit unit = unit_of(list);
        with_scalar(scalar, 0, [&]<class T>() {
            const auto report = report_on_radius(in_unit_of<T>(list, unit), epsilon<T>());
            const precision_scope judging(scalar.digits + guard_digits);
            const mpfr length = narrow<mpfr>(unit.length);
            answers.push_back(judge(problem, half, order, scalar, in_unit(widened(report.verdict), length)));
            for (const auto& test : report.tests) {
                answers.push_back(judge(problem, half, order, scalar, in_unit(widened(test), length)));
            }
        });
    }
    return answers;
}

// The contribution of a result to the tables that are derived from all results.
struct scored_answer {
    std::string half, scalar, method;
    int order;
    bool has_radius, answered, covered;
    mpfr reached;
    std::optional<mpfr> ratio;
};

// The same as a row of a separate table, with more digits than are printed.
const column_list<judged_answer>& score_columns() {
    using row = judged_answer;
    static const column_list<row> all{
        {"half", "", [](const row& r) { return r.half; }},
        {"scalar", "", [](const row& r) { return r.scalar; }},
        {"method", "", [](const row& r) { return r.method; }},
        {"order", "", [](const row& r) { return r.order; }},
        {"has_radius", "", [](const row& r) { return static_cast<int>(r.has_radius()); }},
        {"answered", "", [](const row& r) { return static_cast<int>(r.answered()); }},
        {"covered", "", [](const row& r) { return static_cast<int>(r.covered); }},
        {"reached", "", [](const row& r) { return decimal_cell(r.reached, digits_of_scores); }},
        {"ratio", "", [](const row& r) { return decimal_cell(r.ratio, digits_of_scores); }}};
    return all;
}

scored_answer score_in(const table_row_cells& row) {
    const auto number = [&](std::size_t place) { return from_exact<mpfr>(read_exact(row[place].text())); };
    return {row[0].text(),
            row[1].text(),
            row[2].text(),
            std::stoi(row[3].text()),
            row[4].text() == "1",
            row[5].text() == "1",
            row[6].text() == "1",
            number(7),
            row[8].is_empty() ? std::nullopt : std::optional(number(8))};
}

// Statistics of a group of results.
class score {
public:
    void add(const scored_answer& answer) {
        if (!answer.has_radius) {
            false_answers_ += answer.answered ? 1 : 0;
            return;
        }
        ++problems_;
        digits_.push_back(answer.reached);
        if (answer.answered) {
            ++answers_;
            covered_ += answer.covered ? 1 : 0;
        }
        if (answer.ratio) {
            ratios_.push_back(*answer.ratio);
        }
    }
    int problems() const { return problems_; }
    int answers() const { return answers_; }
    int false_answers() const { return false_answers_; }
    cell coverage() const { return answers_ == 0 ? cell() : decimal_cell(mpfr(mpfr(covered_) / answers_), 4); }
    cell median_ratio() const { return decimal_cell(middle_of(ratios_), digits_of_errors); }
    cell median_digits() const { return decimal_cell(middle_of(digits_), digits_of_errors); }
    mpfr mean_digits() const {
        mpfr sum(0);
        for (const mpfr& d : digits_) {
            sum += d;
        }
        return problems_ == 0 ? sum : mpfr(sum / problems_);
    }

private:
    static std::optional<mpfr> middle_of(std::vector<mpfr> values) {
        if (values.empty()) {
            return std::nullopt;
        }
        std::sort(values.begin(), values.end());
        return values[values.size() / 2];
    }

    int problems_ = 0, answers_ = 0, covered_ = 0, false_answers_ = 0;
    std::vector<mpfr> digits_, ratios_;
};

// A method among all at one order in one scalar.
struct ranking_row {
    int order;
    std::string scalar;
    int rank;
    std::string method;
    score reached;
};

const column_list<ranking_row>& ranking_columns() {
    using row = ranking_row;
    static const column_list<row> all{
        {"order", "N, last power of the lists", [](const row& r) { return r.order; }},
        {"scalar", "arithmetic of the coefficients and of the tests", [](const row& r) { return r.scalar; }},
        {"rank", "1 for the most digits", [](const row& r) { return r.rank; }},
        {"method", "radius test, or the verdict of all", [](const row& r) { return r.method; }},
        {"problems", "series with a radius between 0 and infinity", [](const row& r) { return r.reached.problems(); }},
        {"answers", "radii given for them", [](const row& r) { return r.reached.answers(); }},
        {"mean_digits", "correct digits, no answer counted as 0, mean over the problems",
         [](const row& r) { return decimal_cell(r.reached.mean_digits(), digits_of_errors); }},
        {"median_digits", "the same, median", [](const row& r) { return r.reached.median_digits(); }},
        {"covered", "share of the answers whose error is within the uncertainty",
         [](const row& r) { return r.reached.coverage(); }},
        {"median_uncertainty_over_error", "of the answers", [](const row& r) { return r.reached.median_ratio(); }},
        {"false_answers", "radii given for series that have none",
         [](const row& r) { return r.reached.false_answers(); }},
    };
    return all;
}

table ranking(const std::vector<scored_answer>& answers) {
    std::map<std::pair<std::string, int>, std::map<std::string, score>> groups;
    for (const auto& each : answers) {
        groups[{each.scalar, each.order}][each.method].add(each);
    }
    std::vector<ranking_row> all;
    for (const auto& [group, methods] : groups) {
        std::vector<ranking_row> ranked;
        ranked.reserve(methods.size());
        for (const auto& [method, reached] : methods) {
            ranked.push_back({group.second, group.first, 0, method, reached});
        }
        std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) {
            return a.reached.mean_digits() > b.reached.mean_digits();
        });
        int rank = 0;
        for (ranking_row& each : ranked) {
            each.rank = ++rank;
            all.push_back(std::move(each));
        }
    }
    return make_table(ranking_columns(), all);
}

// A method on one half of the problems.
struct coverage_row {
    std::string half, scalar, method;
    score reached;
};

const column_list<coverage_row>& coverage_columns() {
    using row = coverage_row;
    static const column_list<row> all{
        {"half", "calibration: safety factors were chosen on it; judged: not used for that",
         [](const row& r) { return r.half; }},
        {"scalar", "arithmetic of the coefficients and of the tests", [](const row& r) { return r.scalar; }},
        {"method", "radius test, verdict, or all: every test and no verdict", [](const row& r) { return r.method; }},
        {"answers", "radii given, of series with a radius between 0 and infinity",
         [](const row& r) { return r.reached.answers(); }},
        {"covered", "share of them whose error is within the uncertainty",
         [](const row& r) { return r.reached.coverage(); }},
        {"median_uncertainty_over_error", "of them", [](const row& r) { return r.reached.median_ratio(); }},
    };
    return all;
}

table coverage(const std::vector<scored_answer>& answers) {
    std::map<std::tuple<std::string, std::string, std::string>, score> groups;
    for (const auto& each : answers) {
        groups[{each.half, each.scalar, each.method}].add(each);
        if (each.method != "verdict") {
            groups[{each.half, each.scalar, "all"}].add(each);
        }
    }
    std::vector<coverage_row> all;
    for (const auto& [group, reached] : groups) {
        const auto& [half, scalar, method] = group;
        all.push_back({half, scalar, method, reached});
    }
    return make_table(coverage_columns(), all);
}

// The problems in the precision of each scalar, computed once.
std::vector<problem_list> problems_in(const std::vector<scalar_spec>& scalars, const pendulum_sweep& sweep) {
    std::vector<problem_list> all;
    for (const scalar_spec& scalar : scalars) {
        const precision_scope scope(scalar.digits + guard_digits);
        all.push_back(problems_of(sweep));
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
    tables[2].data = ranking(answers);
    tables[3].data = coverage(answers);
}

// The shared data of a plan's groups.
struct tournament {
    std::vector<scalar_spec> scalars;
    std::vector<problem_list> problems;  // by scalar
    std::vector<int> orders;

    std::size_t groups() const { return problems.front().size() * scalars.size(); }
    cell_group group(std::size_t i) const {
        const std::size_t in = i % scalars.size();
        const std::size_t which = i / scalars.size();
        const auto& problem = problems[in][which];
        const scalar_spec& scalar = scalars[in];
        const std::string half = which % 2 == 0 ? "calibration" : "judged";
        cell_group group;
        for (const int order : orders) {
            group.cells.push_back({{"problem", problem.name},
                                   {"half", half},
                                   {"scalar", scalar.name()},
                                   {"order", std::to_string(order)}});
        }
        group.compute = [this, &problem, &scalar, half](const std::vector<std::size_t>& chosen) {
            const precision_scope scope(scalar.digits + guard_digits);
            std::vector<int> own;
            own.reserve(chosen.size());
            for (const std::size_t each : chosen) {
                own.push_back(orders[each]);
            }
            const auto answers = answers_of(problem, half, own, scalar);
            return equal_parts({make_table(columns(), answers), make_table(score_columns(), answers)}, own.size());
        };
        return group;
    }
};

study_plan plan(const study_request& request) {
    const pendulum_sweep sweep(request.values);
    const auto all = std::make_shared<tournament>();
    all->orders = orders_from(request, 0, "");
    all->scalars =
        request.scalar ? std::vector{*request.scalar} : std::vector{read_scalar("double"), read_scalar("mpfr:60")};
    all->problems = problems_in(all->scalars, sweep);
    const scalar_spec& last = all->scalars.back();
    study_plan plan;
    plan.tables = {head_of("", last, columns()), head_of("scores", last, score_columns()),
                   head_of("ranking", last, ranking_columns()), head_of("coverage", last, coverage_columns())};
    plan.tables[1].written = false;
    plan.axes = {"energy", "gap", "point", "order"};
    plan.groups = all->groups();
    plan.group = [all](std::size_t i) { return all->group(i); };
    // The cost of a list is that of its arithmetic, some tens of times more without hardware support.
    plan.cost = [all](std::size_t i) {
        const scalar_spec& scalar = all->scalars[i % all->scalars.size()];
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

namespace {

study_plan plan(const study_request& request) {
    return request.equation ? of_equation::plan(request) : of_pendulum::plan(request);
}

}  // namespace
}  // namespace radius_tournament_study

const study& radius_tournament() {
    using namespace radius_tournament_study;
    static const study result{
        .name = "radius_tournament",
        .title = "A tournament of radius tests",
        .label = "",
        .question = "Which radius test can be trusted, on series whose radius is known?",
        .reading =
            "Every test sees a list of coefficients and nothing else: theta of the pendulum about several points, and "
            "functions with poles, logarithms, branch points, several singularities on or near the circle, none at "
            "all, or a natural boundary. Left: correct digits of the radius, mean over all series that have one, no "
            "answer counted as none; each further mark is twice the coefficients. The textbook tests of ratios and "
            "roots gain a digit for ten times the coefficients; fitted recurrences (poles, differential approximants) "
            "take what the arithmetic holds. Right: how often the error was within the uncertainty that came with it, "
            "on the half of the series by which nothing was calibrated, and how much larger than the error the "
            "uncertainty was at the median. No test gave a radius to an entire or a divergent series. All of it is "
            "heuristic: coefficients prove no radius.",
        .of = &pendulum_problem(),
        .parameters = {{"--energies", "0.01,0.5,1,1.5,1.71,1.9998,2.02,2.5,4,10",
                        "energies E of the pendulum, in m g l"},
                       {"--gaps", "1e-10,-1e-10", "energies as 2 - E"},
                       {"--points", "0,2/5,1", "expansion points, fractions of T*: 0 the top, 1 the bottom"},
                       {"--orders", "25,50,100,200", "N, last powers of the lists"},
                       {"--scalar", "", "arithmetic of coefficients and tests; without it double and mpfr:60"}},
        .quick = {{"--energies", "1.71", ""},
                  {"--orders", "20", ""},
                  {"--points", "0", ""},
                  {"--scalar", "double", ""}},
        .seconds = 8.5,
        .excluded = no_answer_at_limits("theta is constant and every radius infinite", "T* is infinite"),
        .plan = plan,
        .any_equation = equation_form{
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
