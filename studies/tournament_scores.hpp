// What the results of a tournament of radius tests say of each test: its rank, and the reliability of its
// uncertainties.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tournament_answers.hpp"

namespace libration::studies::tournament_results {

// The contribution of a result to the tables that are derived from all results.
struct scored_answer {
    std::string half, scalar, method;
    int order;
    bool has_radius, answered, covered;
    mpfr reached;
    std::optional<mpfr> ratio;
};

// A scored_answer as a row of a separate table, with more digits than are printed.
inline const column_list<judged_answer>& score_columns() {
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

inline scored_answer score_in(const table_row_cells& row) {
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

inline const column_list<ranking_row>& ranking_columns() {
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

inline table ranking(const std::vector<scored_answer>& answers) {
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

inline const column_list<coverage_row>& coverage_columns() {
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

inline table coverage(const std::vector<scored_answer>& answers) {
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

}  // namespace libration::studies::tournament_results
