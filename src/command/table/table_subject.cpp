// The subjects of tables: motions, elliptic functions, and problems.
#include <utility>

#include "problem/problem_trajectory.hpp"
#include "problem/swept_problem.hpp"
#include "table/elliptic_request.hpp"
#include "table/function_table.hpp"
#include "table/problem_table.hpp"
#include "table/table_order.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr const char* motions_word = "pendulum";
class motion_subject : public table_subject {
public:
    std::string words() const override { return std::string(" ") + motions_word; }
    std::string title() const override { return "Reference values of the pendulum theta'' + sin theta = 0."; }
    table rows(const option_words& said, long digits, input_style style, int jobs) const override {
        return motion_table(said, digits, style, jobs);
    }
};

class function_subject : public table_subject {
public:
    explicit function_subject(std::string names) : names_(std::move(names)) {}
    std::string words() const override { return " " + names_; }
    std::string title() const override { return "Reference values of the elliptic functions " + names_ + "."; }
    table rows(const option_words& said, long digits, input_style style, int jobs) const override {
        return function_table(functions_of(names_), said, digits, style, jobs);
    }

private:
    std::string names_;
};

class problem_subject : public table_subject {
public:
    explicit problem_subject(const problem_options& options)
        : of_{options.choose(), options.solution()}, text_(problem_named(*options.problem()).text) {
        words_ = " --problem " + quoted_word(*options.problem());
        for (const std::string& each : options.changes()) {
            words_ += " --set " + quoted_word(each);
        }
    }
    std::string words() const override { return words_; }
    std::string title() const override { return "Reference values of the solution of"; }
    std::string text() const override { return text_; }
    table rows(const option_words& said, long digits, input_style style, int /*jobs*/) const override {
        return problem_table(of_, times_of_problem(*said["--times"]), digits, style);
    }

private:
    table_problem of_;
    std::string text_, words_;
};

}  // namespace

std::shared_ptr<const table_subject> table_subject_named(const std::string& what) {
    if (what.empty()) {
        throw input_error("table is of nothing: name pendulum, functions as in am,sn, or add --problem P");
    }
    if (what == motions_word) {
        return std::make_shared<motion_subject>();
    }
    functions_of(what);
    return std::make_shared<function_subject>(what);
}

std::shared_ptr<const table_subject> table_subject_of(const std::string& what, const problem_options& problem) {
    return problem.is_chosen() ? std::make_shared<problem_subject>(problem) : table_subject_named(what);
}

}  // namespace libration
