#include "attack/question.hpp"

#include <chrono>
#include <map>
#include <mutex>
#include <thread>

namespace libration::attack {

namespace {

using clock = std::chrono::steady_clock;

struct running_question {
    std::string command;
    clock::time_point since;
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
        {"value", "unknowns at a time", 390, ask_value},
        {"special function", "solutions by functions of mpmath, alone and beside others", 30, ask_special_function},
        {"event", "times of events, and the unknowns there", 160, ask_event},
        {"count", "events before a time", 100, ask_count},
        {"unknown", "parameters and starts that meet a condition", 50, ask_unknown},
        {"periodic orbit", "period and start", 2, ask_orbit},
        {"radius", "bounds of a radius of convergence", 4, ask_radius},
        {"position", "singularities within a distance", 4, ask_position},
        {"coefficient", "lists of Taylor coefficients, one for each unknown", 185, ask_coefficient},
        {"exact zero", "unknowns that stay 0, and others beside them", 50, ask_zero},
        {"refusal", "times behind a singularity", 25, ask_refusal},
    };
    return all;
}

std::string announce(std::string command) {
    running_questions& of = running();
    const std::lock_guard lock(of.mutex);
    of.all[std::this_thread::get_id()] = {command, clock::now()};
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
    if (clock::now() - of.all[std::this_thread::get_id()].since > seconds_of_a_question) {
        throw no_answer();
    }
}

std::optional<std::string> command_older_than(std::chrono::seconds limit) {
    running_questions& of = running();
    const std::lock_guard lock(of.mutex);
    for (const auto& [thread, question] : of.all) {
        if (!question.command.empty() && clock::now() - question.since > limit) {
            return question.command;
        }
    }
    return std::nullopt;
}

}  // namespace libration::attack
