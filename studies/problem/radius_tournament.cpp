// Which radius test can be trusted, on series whose radius is known?
#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "libration/convergence/known/known_series.hpp"
#include "libration/convergence/list/coefficient_unit.hpp"
#include "libration/convergence/radius_report.hpp"
#include "libration/pendulum/error/known_descent_series.hpp"
#include "libration/scalar/text/decimal.hpp"
#include "run/parallel.hpp"
#include "sweep/study.hpp"

namespace libration::studies {

namespace radius_tournament_study {
namespace {

using row = std::vector<std::string>;
using rows = std::vector<row>;

constexpr long guard_digits = 30;
constexpr long digits_of_errors = 6;

const std::vector<column>& columns() {
    static const std::vector<column> all{
        {"problem", "the function, or theta of the pendulum: its energy and expansion point"},
        {"half", "calibration: safety factors were chosen on it; judged: not used for that"},
        {"order", "N, last power of the list"},
        {"scalar", "arithmetic of the coefficients and of the tests"},
        {"method", "radius test, or the verdict of all"},
        {"radius", "estimated; empty where the test gives none"},
        {"uncertainty", "of the radius, by the test itself"},
        {"exact", "radius of convergence; inf for an entire function, 0 for a divergent series"},
        {"relative_error", "|radius/exact - 1|"},
        {"log10_relative_error", "log10 of relative_error; empty where it is 0"},
        {"digits", "correct digits of the radius, at most those of the scalar"},
        {"uncertainty_over_error", "empty where the error is 0"},
        {"covered", "yes: the error is within the uncertainty, or no radius is given where there is none | no"},
        {"kind", "of the nearest singularities by the verdict"},
        {"exact_kind", "of the one of least argument, truly; empty where there is none"},
        {"count", "nearest singularities as the test sees them"},
        {"exact_count", "truly; 0 for none and for a boundary"},
        {"note", "why there is no radius, or what a reader should know"},
    };
    return all;
}

const std::vector<column>& ranking_columns() {
    static const std::vector<column> all{
        {"order", "N, last power of the lists"},
        {"scalar", "arithmetic of the coefficients and of the tests"},
        {"rank", "1 for the most digits"},
        {"method", "radius test, or the verdict of all"},
        {"problems", "series with a radius between 0 and infinity"},
        {"answers", "radii given for them"},
        {"mean_digits", "correct digits, no answer counted as 0, mean over the problems"},
        {"median_digits", "the same, median"},
        {"covered", "share of the answers whose error is within the uncertainty"},
        {"median_uncertainty_over_error", "of the answers"},
        {"false_answers", "radii given for series that have none"},
    };
    return all;
}

const std::vector<column>& coverage_columns() {
    static const std::vector<column> all{
        {"half", "calibration: safety factors were chosen on it; judged: not used for that"},
        {"scalar", "arithmetic of the coefficients and of the tests"},
        {"method", "radius test, verdict, or all: every test and no verdict"},
        {"answers", "radii given, of series with a radius between 0 and infinity"},
        {"covered", "share of them whose error is within the uncertainty"},
        {"median_uncertainty_over_error", "of them"},
    };
    return all;
}

// One answer, as far as the summaries need it.
struct judged_answer {
    std::string half, scalar, method;
    int order;
    bool has_radius;  // the problem has one
    bool answered;
    bool covered;
    mpfr digits;
    std::optional<mpfr> ratio;  // uncertainty/error
};

struct judged_rows {
    rows all;
    std::vector<judged_answer> answers;
};

// All problems, in the working precision in force.
std::vector<known_series<mpfr>> problems_of(const study_request& request) {
    auto all = all_known_series<mpfr>();
    for (const sweep_energy& at : request.energies) {
        for (const exact& point : request.points) {
            const bool by_gap = at.energy.size() > at.gap.size() + 4;
            const std::string energy = by_gap ? "2-E=" + at.gap : "E=" + at.energy;
            all.push_back(known_descent_series("pendulum " + energy + " x=" + point.text, motion::of_energy(at.value),
                                               point.coefficient));
        }
    }
    return all;
}

std::string exact_text(const known_series<mpfr>& problem, long digits) {
    return problem.radius ? to_decimal(*problem.radius, digits) : "inf";
}

std::string kind_text(singularity_kind kind) { return kind == singularity_kind::unknown ? "" : name_of(kind); }

// Digits of agreement, between 0 and the most that the scalar has.
mpfr correct_digits(const mpfr& relative_error, long most) {
    const mpfr reached = relative_error == 0 ? mpfr(most) : mpfr(-log10(relative_error));
    return std::clamp(reached, mpfr(0), mpfr(most));
}

void judge(const known_series<mpfr>& problem, const std::string& half, int order, const scalar_spec& scalar,
           const radius_estimate<mpfr>& found, judged_rows& into) {
    const bool has_radius = problem.radius && *problem.radius > 0;
    const long digits = scalar.digits;
    judged_answer answer{
        half,    scalar.name(), found.method, order, has_radius, found.radius.has_value(), !has_radius && !found.radius,
        mpfr(0), std::nullopt};
    std::string error;
    std::string log_error;
    std::string ratio;
    if (found.radius && has_radius) {
        const mpfr away = abs(*found.radius - *problem.radius);
        const mpfr relative = away / *problem.radius;
        answer.covered = away <= found.uncertainty;
        answer.digits = correct_digits(relative, digits);
        error = to_decimal(relative, digits_of_errors);
        if (away != 0) {
            log_error = log10_text(relative);
            answer.ratio = found.uncertainty / away;
            ratio = to_decimal(*answer.ratio, digits_of_errors);
        }
    }
    into.all.push_back({problem.name, half, std::to_string(order), scalar.name(), found.method,
                        found.radius ? to_decimal(*found.radius, digits) : "",
                        found.radius ? to_decimal(found.uncertainty, digits_of_errors) : "",
                        exact_text(problem, digits), error, log_error,
                        found.radius && has_radius ? to_decimal(answer.digits, digits_of_errors) : "", ratio,
                        has_radius && !found.radius ? ""
                        : answer.covered            ? "yes"
                                                    : "no",
                        kind_text(found.kind), kind_text(problem.kind),
                        found.count > 0 ? std::to_string(found.count) : "", std::to_string(problem.count), found.note});
    into.answers.push_back(std::move(answer));
}

// All tests on one problem in one scalar, at all orders.
judged_rows rows_of(const known_series<mpfr>& problem, const std::string& half, const std::vector<int>& orders,
                    const scalar_spec& scalar) {
    judged_rows judged;
    const power_series<mpfr> wide = problem.expand(orders.back());
    for (const int order : orders) {
        const power_series<mpfr> list = wide.truncated(order);
        const coefficient_unit unit = unit_of(list);
        with_scalar(scalar, 0, [&]<class T>() {
            const auto report = report_on_radius(in_unit_of<T>(list, unit), epsilon<T>());
            const precision_scope judging(scalar.digits + guard_digits);
            const mpfr length = narrow<mpfr>(unit.length);
            judge(problem, half, order, scalar, in_unit(widened(report.verdict), length), judged);
            for (const auto& test : report.tests) {
                judge(problem, half, order, scalar, in_unit(widened(test), length), judged);
            }
        });
    }
    return judged;
}

// What a group of answers comes to.
class score {
public:
    void add(const judged_answer& answer) {
        if (!answer.has_radius) {
            false_answers_ += answer.answered ? 1 : 0;
            return;
        }
        ++problems_;
        digits_.push_back(answer.digits);
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
    std::string coverage() const { return answers_ == 0 ? "" : to_decimal(mpfr(mpfr(covered_) / answers_), 4); }
    std::string median_ratio() const { return text(middle_of(ratios_)); }
    std::string median_digits() const { return text(middle_of(digits_)); }
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
    static std::string text(const std::optional<mpfr>& x) { return x ? to_decimal(*x, digits_of_errors) : ""; }

    int problems_ = 0, answers_ = 0, covered_ = 0, false_answers_ = 0;
    std::vector<mpfr> digits_, ratios_;
};

rows ranking(const std::vector<judged_answer>& answers) {
    std::map<std::pair<std::string, int>, std::map<std::string, score>> groups;
    for (const auto& each : answers) {
        groups[{each.scalar, each.order}][each.method].add(each);
    }
    rows all;
    for (const auto& [group, methods] : groups) {
        std::vector<std::pair<std::string, const score*>> ranked;
        ranked.reserve(methods.size());
        for (const auto& [method, s] : methods) {
            ranked.emplace_back(method, &s);
        }
        std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) {
            return a.second->mean_digits() > b.second->mean_digits();
        });
        int rank = 0;
        for (const auto& [method, s] : ranked) {
            all.push_back({std::to_string(group.second), group.first, std::to_string(++rank), method,
                           std::to_string(s->problems()), std::to_string(s->answers()),
                           to_decimal(s->mean_digits(), digits_of_errors), s->median_digits(), s->coverage(),
                           s->median_ratio(), std::to_string(s->false_answers())});
        }
    }
    return all;
}

rows coverage(const std::vector<judged_answer>& answers) {
    std::map<std::tuple<std::string, std::string, std::string>, score> groups;
    for (const auto& each : answers) {
        groups[{each.half, each.scalar, each.method}].add(each);
        if (each.method != "verdict") {
            groups[{each.half, each.scalar, "all"}].add(each);
        }
    }
    rows all;
    for (const auto& [group, s] : groups) {
        const auto& [half, scalar, method] = group;
        all.push_back({half, scalar, method, std::to_string(s.answers()), s.coverage(), s.median_ratio()});
    }
    return all;
}

std::vector<study_table> run(const study_request& request) {
    refuse_limits(request.energies, "theta is constant and every radius infinite", "T* is infinite");
    std::vector<int> orders = request.orders;
    std::sort(orders.begin(), orders.end());
    const std::vector<scalar_spec> scalars =
        request.scalar ? std::vector{*request.scalar} : std::vector{read_scalar("double"), read_scalar("mpfr:60")};
    std::size_t problems = 0;
    {
        const precision_scope scope(guard_digits);
        problems = problems_of(request).size();
    }
    progress shown("radius_tournament, problems", problems * scalars.size(), request.shown);
    const auto found = parallel_map(problems * scalars.size(), request.jobs, shown, [&](std::size_t i) {
        const scalar_spec& scalar = scalars[i % scalars.size()];
        const std::size_t problem = i / scalars.size();
        const precision_scope scope(scalar.digits + guard_digits);
        return rows_of(problems_of(request)[problem], problem % 2 == 0 ? "calibration" : "judged", orders, scalar);
    });
    const precision_scope scope(digits_of_errors + guard_digits);
    std::vector<judged_answer> answers;
    study_table all{"", scalars.back(), {columns(), {}}};
    for (const auto& each : found) {
        all.data.rows.insert(all.data.rows.end(), each.all.begin(), each.all.end());
        answers.insert(answers.end(), each.answers.begin(), each.answers.end());
    }
    return {std::move(all),
            {"ranking", scalars.back(), {ranking_columns(), ranking(answers)}},
            {"coverage", scalars.back(), {coverage_columns(), coverage(answers)}}};
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
        .seconds = 16,
        .run = run};
    return result;
}

}  // namespace libration::studies
