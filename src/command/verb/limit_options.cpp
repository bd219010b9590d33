#include "limit_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "first_values.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/problem/limit_text.hpp"
#include "run/progress.hpp"
#include "text/input_error.hpp"

namespace libration {

void limit_options::add_to(CLI::App& command) {
    command
        .add_option(
            "--unknown", unknowns_,
            "with conditions at infinity in --problem, such as f'(inf)=1: the parameters or initial values that "
            "they determine (default: those without a value)")
        ->delimiter(',')
        ->type_name("NAMES");
    command.add_option("--guess", guesses_, "a first guess of one of them: \"f''(0)=0.5\"")->type_name("NAME=VALUE");
}

void say_missing(const std::vector<std::string>& shown, const std::vector<answer_note>& notes) {
    for (const std::string& kind : shown) {
        if (std::ranges::none_of(notes, [&](const answer_note& each) { return each.kind == kind; })) {
            say_line("--show " + kind + ": no such number of this solution is proved with these digits");
        }
    }
}

std::vector<std::string> numbers_left_open(const problem_options& problem_of) {
    return open_numbers(problem_of.naming([&] {
        auto typed = problem(problem_named(*problem_of.problem()).text).equations();
        for (const std::string& each : problem_of.changes()) {
            typed = ode::changed(typed, each);
        }
        return typed;
    }));
}

std::optional<taken_limits> limit_options::take(problem_options& problem_of) const {
    const auto conditions = problem_of.take_limits(unknowns_);
    if (conditions.empty()) {
        if (!unknowns_.empty() || !guesses_.empty()) {
            throw input_error(unknowns_.empty() ? "--guess" : "--unknown",
                              unknowns_.empty() ? guesses_.front() : unknowns_.front(),
                              "is for conditions at infinity, and the problem has none",
                              "write one in --problem, as y(inf) = 0, or leave it out");
        }
        return std::nullopt;
    }
    auto shown = problem_of.take_shown(numbers_at_infinity());
    const auto unknowns = unknowns_.empty() ? numbers_left_open(problem_of) : unknowns_;
    const auto ends_at = [&](const char* end) {
        return std::ranges::any_of(
            conditions, [&](const std::string& each) { return without_blanks(each).find(end) != std::string::npos; });
    };
    if (unknowns.empty() && !(ends_at("(-inf)") && ends_at("(inf)"))) {
        throw input_error(
            "--problem with conditions at infinity leaves nothing open: leave out the value that they determine, or "
            "add --unknown NAME");
    }
    auto guesses = first_guesses(guesses_, unknowns);
    if (guesses.size() > 1) {
        throw input_error("--guess", guesses_.front(), "has several values, which may lead to several solutions",
                          "write one, or use `libration find`");
    }
    first_guess& guess = guesses.front();
    const auto without_guess = add_first_values(problem_of, unknowns, guess);
    problem of(problem_of.equations(first_values(guess, std::nullopt)));
    for (const std::string& each : guess) {
        naming_option("--guess", [&] { of.set(each); });
    }
    return taken_limits{{of, unknowns, conditions, without_guess}, std::move(shown)};
}

}  // namespace libration
