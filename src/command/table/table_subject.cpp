// The subjects of tables: motions, elliptic functions, and problems.
#include <array>
#include <utility>

#include "equation/problem_trajectory.hpp"
#include "equation/swept_problem.hpp"
#include "table/elliptic_request.hpp"
#include "table/function_table.hpp"
#include "table/problem_table.hpp"
#include "table/table_order.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr const char* motions = "pendulum";
constexpr std::array<const char*, 7> motion_names{"--energies",  "--gaps",   "--theta0", "--omega0",
                                                  "--direction", "--length", "--gravity"};
constexpr std::array<const char*, 10> argument_names{"--u", "--phi", "--x",  "--z",     "--n",
                                                     "--k", "--m",   "--m1", "--alpha", "--q"};

class motion_subject : public table_subject {
public:
    std::string words() const override { return std::string(" ") + motions; }
    std::string name() const override { return motions; }
    std::string title() const override { return "Reference values of the pendulum theta'' + sin theta = 0."; }
    std::vector<const char*> other_options() const override { return {argument_names.begin(), argument_names.end()}; }
    table rows(const option_words& said, long digits, input_style style, int jobs) const override {
        return motion_table(said, digits, style, jobs);
    }
};

class function_subject : public table_subject {
public:
    explicit function_subject(std::string names) : names_(std::move(names)) {}
    std::string words() const override { return " " + names_; }
    std::string name() const override { return names_; }
    std::string title() const override { return "Reference values of the elliptic functions " + names_ + "."; }
    std::vector<const char*> other_options() const override {
        std::vector<const char*> options(motion_names.begin(), motion_names.end());
        options.push_back("--times");
        return options;
    }
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
    std::string name() const override { return "of a problem"; }
    std::string title() const override { return "Reference values of the solution of"; }
    std::string text() const override { return text_; }
    std::vector<const char*> other_options() const override {
        std::vector<const char*> options(argument_names.begin(), argument_names.end());
        options.insert(options.end(), motion_names.begin(), motion_names.end());
        options.insert(options.end(), {"--points", "--columns"});
        return options;
    }
    table rows(const option_words& said, long digits, input_style style, int /*jobs*/) const override {
        if (!said["--times"]) {
            throw input_error("no --times are given: add --times such as 0,1.5,sqrt(2) or 0:20:201");
        }
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
    if (what == motions) {
        return std::make_shared<motion_subject>();
    }
    functions_of(what);
    return std::make_shared<function_subject>(what);
}

std::shared_ptr<const table_subject> table_subject_of(const std::string& what, const problem_options& problem) {
    if (!problem.is_chosen()) {
        return table_subject_named(what);
    }
    if (!what.empty()) {
        throw input_error("--problem", *problem.problem(), "comes together with the table " + what, "give one of them");
    }
    return std::make_shared<problem_subject>(problem);
}

}  // namespace libration
