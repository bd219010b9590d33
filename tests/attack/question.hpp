// The questions of an attack: kinds of statements, each with a question from random choices.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "attack/judge.hpp"
#include "attack/solved_problem.hpp"
#include "libration/digits/known_value.hpp"
#include "libration/equation/explicit_system.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/integration/integrator.hpp"

namespace libration::attack {

struct statement_kind {
    const char* name;
    const char* about;  ///< one line of the published table
    int share;          ///< of the sum of all shares
    /// Runs one question; errors of the library are caught and checked.
    outcome (*ask)(choices& next);
};

/// All kinds, in the order of the table.
const std::vector<statement_kind>& statement_kinds();

outcome ask_value(choices& next);
outcome ask_stiff(choices& next);
outcome ask_comparison(choices& next);
outcome ask_linear_system(choices& next);
outcome ask_special_function(choices& next);
outcome ask_event(choices& next);
outcome ask_count(choices& next);
outcome ask_unknown(choices& next);
outcome ask_orbit(choices& next);
outcome ask_family(choices& next);
outcome ask_radius(choices& next);
outcome ask_position(choices& next);
outcome ask_coefficient(choices& next);
outcome ask_law(choices& next);
outcome ask_law_line(choices& next);
outcome ask_zero(choices& next);
outcome ask_refusal(choices& next);
outcome ask_domain(choices& next);
outcome ask_singular_start(choices& next);
outcome ask_removable(choices& next);
outcome ask_algebraic(choices& next);
outcome ask_jump(choices& next);
outcome ask_branch(choices& next);
outcome ask_mode(choices& next);
outcome ask_root_time(choices& next);
outcome ask_limit(choices& next);
outcome ask_connection(choices& next);
outcome ask_connected_state(choices& next);
outcome ask_eigenvalue(choices& next);
outcome ask_delay(choices& next);
outcome ask_set(choices& next);
outcome ask_degenerate_set(choices& next);
outcome ask_derivative(choices& next);
outcome ask_time_steps(choices& next);
outcome ask_state_steps(choices& next);
outcome ask_equality(choices& next);
outcome ask_surface_start(choices& next);
outcome ask_emptied_store(choices& next);
outcome ask_several_stores(choices& next);
outcome ask_oscillation_zero(choices& next);
outcome ask_changed_field(choices& next);
outcome ask_near_times(choices& next);

/// Stores the command of this thread's current question, and returns it; an empty one ends the question.
std::string announce(std::string command);
std::string announced_command();
/// The command of a thread whose question has taken more processor time.
std::optional<std::string> command_older_than(std::chrono::seconds limit);

/// Ends a question from within, through a progress callback.
class no_answer : public std::runtime_error {
public:
    no_answer() : std::runtime_error("no answer in the time that a question has") {}
};
/// Throws no_answer if this thread's question has taken more than `seconds_of_a_question` of processor time.
void require_time_left();
inline constexpr std::chrono::seconds seconds_of_a_question{5};

/// Announces a command and judges its answer, which `answer` adds; an error is a refusal.
template <class Answer>
outcome answered(const std::string& command, const Answer& answer) {
    outcome result;
    result.command = announce(command);
    try {
        answer(result);
    } catch (const error& refusal) {
        result.add(verdict::refused, refusal.what());
    } catch (const no_answer& late) {
        result.add(verdict::undecided, late.what());
    }
    return result;
}

/// Adds the verdict on the digits of a number, or on its bound.
void add_number(outcome& to, const known_value& number, long digits, const truth& exact, const std::string& name);

/// The same for the first unknown at the first time, or the reason why it is missing.
template <class Part>
void add_first_value(outcome& to, const Part& found, long digits, const truth& exact, const std::string& name) {
    if (!found.states.front().empty()) {
        add_number(to, found.states.front().front(), digits, exact, name);
    }
    if (found.missing) {
        to.add(verdict::refused, found.missing->what());
    }
}

/// Requested digits: mostly few, some hundred where products of series are long.
long any_digits(choices& next);

/// A constant time, as parsed by the command.
ode::number time_number(const std::string& typed);

inline ode::explicit_system system_of(const std::string& text) { return ode::explicit_system(ode::parse(text)); }

/// Checks the values of the first columns at a time since the initial time; the message of an error by `refused`.
outcome asked_values(const solved_problem& problem, const rational& since, long digits,
                     const std::function<verdict(const std::string& message)>& refused,
                     ode::integrator_choice integrator = ode::integrator_choice::automatic);

/// Checks the enclosures of all columns at a time, by one integration with so many bits, before they become digits: digits
/// of a value that is accurate enough do not show that its bound is too small.
outcome asked_enclosures(const solved_problem& problem, const rational& since, long bits,
                         ode::integrator_choice integrator);

/// The facts in the error of a trajectory: the solution exists up to the time in the message, which is before a
/// singularity at `singular` (absolute; in the direction of the requested time).
verdict judged_existence(const std::string& message, double from, double singular);

}  // namespace libration::attack
