#include "attack/question.hpp"

#include <pthread.h>

#include <chrono>
#include <ctime>
#include <map>
#include <mutex>
#include <thread>

namespace libration::attack {

namespace {

// Processor time of a thread, so that the limits do not depend on what else the machine computes.
class thread_clock {
public:
    thread_clock() { pthread_getcpuclockid(pthread_self(), &id_); }

    std::chrono::nanoseconds now() const {
        timespec time{};
        clock_gettime(id_, &time);
        return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
    }

private:
    clockid_t id_{};
};

struct running_question {
    std::string command;
    thread_clock clock;  // of the thread that answers it
    std::chrono::nanoseconds since = clock.now();

    std::chrono::nanoseconds taken() const { return clock.now() - since; }
};

// The question of each thread.
struct running_questions {
    std::mutex mutex;
    std::map<std::thread::id, running_question> all;
};

running_questions& running() {
    static running_questions result;
    return result;
}

}  // namespace

const std::vector<statement_kind>& statement_kinds() {
    static const std::vector<statement_kind> all{
        {"value", "unknowns at a time", 290, ask_value},
        {"stiff", "unknowns of stiff problems, most by collocation", 20, ask_stiff},
        {"comparison", "unknowns at a time by theorem G, few and many, also in chains of dependence", 40,
         ask_comparison},
        {"linear system", "unknowns of linear systems with constant coefficients, defective, forced, of any size", 20,
         ask_linear_system},
        {"special function", "solutions by functions of mpmath, alone and beside others", 30, ask_special_function},
        {"event", "times of events, and the unknowns there", 160, ask_event},
        {"count", "events before a time", 100, ask_count},
        {"unknown", "parameters and starts that meet a condition", 50, ask_unknown},
        {"periodic orbit", "period and start", 2, ask_orbit},
        {"orbit of a family", "period of a system with integrals, and multipliers behind other coordinates", 4,
         ask_family},
        {"radius", "bounds of a radius of convergence", 4, ask_radius},
        {"position", "singularities within a distance", 4, ask_position},
        {"coefficient", "lists of Taylor coefficients, one for each unknown", 129, ask_coefficient},
        {"law", "coefficients by the law of all coefficients", 20, ask_law},
        {"line of a law", "limit, radius and exponent of ratios and roots, and how far they are from their line", 20,
         ask_law_line},
        {"domain", "values of solutions that a factor of 0 ends", 28, ask_domain},
        {"singular start", "with the value that the equation determines, and beside it", 28, ask_singular_start},
        {"removable singularity", "quotients of two functions of one expression, from, across and up to a common zero",
         40, ask_removable},
        {"exact zero", "unknowns that stay 0, and others beside them", 50, ask_zero},
        {"refusal", "times behind a singularity", 25, ask_refusal},
        {"algebraic", "unknowns of algebraic equations", 10, ask_algebraic},
        {"jump", "events that change the solution", 10, ask_jump},
        {"branch", "piecewise right-hand sides", 10, ask_branch},
        {"mode", "counters that events alone change, in conditions", 20, ask_mode},
        {"root of time", "values across, from and up to a time with a root", 10, ask_root_time},
        {"limit", "limits at equilibria", 10, ask_limit},
        {"connection", "unknowns for which a solution has limits at infinity", 20, ask_connection},
        {"connected state", "states of such solutions at times, at the ends, and amplitudes", 20, ask_connected_state},
        {"eigenvalue", "eigenvalues of wells, with their indices", 20, ask_eigenvalue},
        {"delay", "solutions with a constant delay, and an event; neutral equations", 10, ask_delay},
        {"set", "bounds of all solutions of a set, at times and at an event, and numbers of events", 10, ask_set},
        {"degenerate set", "bounds of sets that are points, hold equilibria or singularities, of 1e+-300, or end", 30,
         ask_degenerate_set},
        {"derivative", "with respect to initial values and parameters, also across events", 10, ask_derivative},
        {"step of time", "right-hand sides of nested steps of the time", 40, ask_time_steps},
        {"step of state", "the same of the time and of unknowns", 40, ask_state_steps},
        {"equality", "conditions whose sides are equal for some time", 40, ask_equality},
        {"start on surface", "solutions from one and from two switching surfaces", 40, ask_surface_start},
        {"emptied store", "levels h with h' = -k h^a until h is 0, and what flows out, near that time and refilled", 20,
         ask_emptied_store},
        {"several stores", "levels of stores that are empty and refilled one after the other, and at once", 20,
         ask_several_stores},
        {"oscillation near 0",
         "values of oscillations at their zeros, next to them and with frequencies next to theirs", 20,
         ask_oscillation_zero},
        {"changed field", "events that change the field at a surface, and bounces", 40, ask_changed_field},
        {"near time", "times within 1e-40 of those of events, and after events that are not proved", 40,
         ask_near_times},
    };
    return all;
}

std::string announce(std::string command) {
    running_questions& of = running();
    const std::lock_guard lock(of.mutex);
    of.all[std::this_thread::get_id()] = {command, {}};
    return command;
}

std::string announced_command() {
    running_questions& of = running();
    const std::lock_guard lock(of.mutex);
    return of.all[std::this_thread::get_id()].command;
}

void require_time_left() {
    running_questions& of = running();
    const std::lock_guard lock(of.mutex);
    if (of.all[std::this_thread::get_id()].taken() > seconds_of_a_question) {
        throw no_answer();
    }
}

std::optional<std::string> command_older_than(std::chrono::seconds limit) {
    running_questions& of = running();
    const std::lock_guard lock(of.mutex);
    for (const auto& [thread, question] : of.all) {
        if (!question.command.empty() && question.taken() > limit) {
            return question.command;
        }
    }
    return std::nullopt;
}

}  // namespace libration::attack
