// One solution for several questions.
#include <mutex>

#include "answers.hpp"
#include "guarded.hpp"
#include "solution_answers.hpp"

namespace libration::c {

namespace {

// The code of a question to the solution, of one thread at a time. After a failure the solution may be in any state, and
// the thread of the proof in the middle of a step: it is left to the process, and the next question begins anew.
template <class Question>
int asked(libration_solution* of, const Question& question) noexcept {
    if (of == nullptr) {
        return guarded([&] { given(of, "solution"); });
    }
    const std::scoped_lock lock(*of->guard);
    const int code = question([&]() -> const solution& {
        if (!of->kept) {
            of->kept = solve(problem(of->of.equations));
        }
        return *of->kept;
    });
    if (code == LIBRATION_NO_MEMORY || code == LIBRATION_FAULT) {
        static_cast<void>(of->kept.release());
    }
    return code;
}

}  // namespace

}  // namespace libration::c

using namespace libration;
using namespace libration::c;

int libration_solution_new(const libration_problem* problem, libration_solution** solution) {
    return made(solution, [&] { return libration_solution{given(problem, "problem")}; });
}

int libration_solution_states(libration_solution* solution, const char* times, long digits, int rigour,
                              libration_watch watch, void* context, libration_table** states) {
    return asked(solution, [&](const auto& of) {
        return partly_made(states, [&] {
            return states_of(of(), text_of(times, "times"), digits_by(digits, rigour), watcher(watch, context));
        });
    });
}

int libration_solution_events(libration_solution* solution, const char* condition, const char* settings, long count,
                              long digits, libration_watch watch, void* context, libration_table** events) {
    return asked(solution, [&](const auto& of) {
        return partly_made(events, [&] {
            return events_of(solution->of, of(), condition, settings, count, digits, watcher(watch, context));
        });
    });
}

int libration_solution_coefficients(libration_solution* solution, const char* point, const char* corners, long first,
                                    long last, long digits, int rigour, libration_table** coefficients) {
    return asked(solution, [&](const auto& of) {
        return made(coefficients, [&] {
            return table_of_numbers(of().series(request_of(point, corners, first, last), digits_by(digits, rigour)));
        });
    });
}

int libration_solution_certificate(libration_solution* solution, const char* times, long digits, const char* path,
                                   libration_watch watch, void* context, libration_table** states) {
    return asked(solution, [&](const auto& of) {
        return made(states,
                    [&] { return certified_states(solution->of, of(), times, digits, path, watcher(watch, context)); });
    });
}

int libration_solution_event_certificate(libration_solution* solution, const char* condition, long count, long digits,
                                         const char* path, libration_watch watch, void* context,
                                         libration_table** events) {
    return asked(solution, [&](const auto& of) {
        return made(events, [&] {
            return certified_events(solution->of, of(), condition, count, digits, path, watcher(watch, context));
        });
    });
}

size_t libration_solution_steps(const libration_solution* solution) {
    if (solution == nullptr) {
        return 0;
    }
    const std::scoped_lock lock(*solution->guard);
    return solution->kept ? solution->kept->steps_made() : 0;
}

// In the thread of proofs, as its numbers were made there.
void libration_solution_free(libration_solution* solution) {
    static_cast<void>(guarded([&] { delete solution; }));
}
