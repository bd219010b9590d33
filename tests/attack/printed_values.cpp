#include "attack/printed_values.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "attack/facts.hpp"
#include "attack/program.hpp"

namespace libration::attack {

namespace {

using cells = std::vector<std::string>;

cells cells_of(const std::string& line) {
    cells result;
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, ',');) {
        result.push_back(cell);
    }
    return result;
}

std::size_t place_of(const cells& all, const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(all, name) - all.begin());
}

void judge_cell(outcome& to, const std::string& cell, const printed_question& question,
                const printed_question::unknown& unknown, std::size_t time) {
    const std::string statement = fmt::format("{}({}) = {}", unknown.name, question.times[time], cell);
    const std::optional<truth>& exact = unknown.values[time];
    if (!exact) {
        to.add(verdict::wrong, statement + ", but there is more than one solution");
    } else if (cell.starts_with("<")) {
        to.add(judged_bounds("-" + cell.substr(1), cell.substr(1), *exact), statement);
    } else {
        const verdict given = judged({cell, ""}, question.digits, *exact);
        to.add(given, given == verdict::wrong ? fmt::format("{}, but it is {}", statement, rough(*exact)) : statement);
    }
}

// Returns how many values were printed.
long judge_row(outcome& to, const cells& header, const cells& row, const printed_question& question) {
    const std::size_t typed = place_of(header, "time_typed");
    const std::string& time = typed < row.size() ? row[typed] : row.front();
    const std::size_t which = place_of(question.times, time);
    if (which == question.times.size()) {
        to.add(verdict::wrong, "prints the time " + time + ", which is not one of the question");
        return 0;
    }
    long printed = 0;
    for (const auto& unknown : question.unknowns) {
        const std::size_t column = place_of(header, unknown.name);
        if (column < row.size() && !row[column].empty()) {
            judge_cell(to, row[column], question, unknown, which);
            ++printed;
        }
    }
    return printed;
}

}  // namespace

outcome asked_program(const printed_question& question) {
    outcome result;
    result.command = announce(fmt::format("libration reference --problem \"{}\" --times=\"{}\" --digits {}",
                                          question.problem, fmt::join(question.times, ","), question.digits));
    const auto answer =
        answer_of(fmt::format("{} --format csv --timeout {}", result.command, seconds_of_a_question.count()));
    long printed = 0;
    for (std::size_t i = 1; i < answer.lines.size(); ++i) {
        printed += judge_row(result, cells_of(answer.lines.front()), cells_of(answer.lines[i]), question);
    }
    const auto facts = facts_of(answer.message);
    if (facts.slides && !question.slides) {
        result.add(verdict::wrong, "the solution does not slide: " + answer.message);
    } else if (printed < static_cast<long>(question.times.size() * question.unknowns.size())) {
        result.add(verdict::refused, answer.message);
    }
    return result;
}

}  // namespace libration::attack
