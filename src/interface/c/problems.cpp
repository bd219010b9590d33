#include <memory>
#include <optional>
#include <stdexcept>

#include "find_arguments.hpp"
#include "guarded.hpp"
#include "libration/number/given_number.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/problem/find.hpp"
#include "libration/problem/solution.hpp"
#include "libration/query/sets/solution_sets.hpp"
#include "problem_tables.hpp"
#include "solution_answers.hpp"

namespace libration::c {

namespace {

constexpr long most_powers_of_radius = 100'000;
constexpr long most_digits_of_places = 1000;

libration_problem make_problem(const std::string& text, const std::string& settings) {
    problem read(trimmed(text));
    for (const auto& [name, value] : settings_of(settings, "settings")) {
        std::string change = name;
        change += " = ";
        change += value;
        read.set(change);
    }
    libration_problem made{read.equations(), {}};
    if (!made.equations.sets.empty()) {
        made.names = ode::enclosed_solutions(made.equations, {.spans = {}}).names;
    } else if (made.equations.is_ordinary()) {
        made.ordinary.emplace(made.equations);
        made.names = ode::names_of_state(*made.ordinary);
    } else {
        made.names = solve(read)->quantities();
    }
    return made;
}

problem problem_of(const libration_problem* p) { return problem(given(p, "problem").equations); }

// A separate solution for each call: one in which memory ran out is not used again.
std::unique_ptr<solution> solution_of(const libration_problem* p, const settings& by = {}) {
    return solve(problem_of(p), by);
}

// The distance within which singularities are searched, if one is given.
std::optional<double> distance_of(const char* within) {
    if (!is_given(within)) {
        return std::nullopt;
    }
    const exact distance = given_number("within", within);
    if (!distance.is_number() || sign_of_exact(distance) <= 0) {
        throw error(error_kind::argument, "within", within, "is not a positive number");
    }
    return from_exact<double>(distance);
}

}  // namespace

}  // namespace libration::c

using namespace libration;
using namespace libration::c;

const ode::explicit_system& libration_problem::system() const {
    if (!ordinary) {
        static_cast<void>(ode::explicit_system(equations));  // throws the reason
        throw std::logic_error("equations without a system");
    }
    return *ordinary;
}

int libration_problem_new(const char* text, const char* settings, libration_problem** problem) {
    return made(problem, [&] { return make_problem(text_of(text, "problem"), settings == nullptr ? "" : settings); });
}

size_t libration_problem_size(const libration_problem* problem) {
    return problem == nullptr ? 0 : problem->names.size();
}

const char* libration_problem_name(const libration_problem* problem, size_t i) {
    return i < libration_problem_size(problem) ? problem->names[i].c_str() : "";
}

int libration_problem_states(const libration_problem* problem, const char* times, long digits, int rigour,
                             libration_watch watch, void* context, libration_table** states) {
    return made(states, [&] {
        return states_of(*solution_of(problem), text_of(times, "times"), digits_by(digits, rigour),
                         watcher(watch, context))
            .complete();
    });
}

int libration_problem_known_states(const libration_problem* problem, const char* times, long digits, int rigour,
                                   libration_watch watch, void* context, libration_table** states) {
    return partly_made(states, [&] {
        return states_of(*solution_of(problem), text_of(times, "times"), digits_by(digits, rigour),
                         watcher(watch, context));
    });
}

int libration_problem_derivatives(const libration_problem* problem, const char* times, const char* numbers, long digits,
                                  libration_watch watch, void* context, libration_table** derivatives) {
    return partly_made(derivatives, [&] {
        return states_of(*solution_of(problem), text_of(times, "times"), proved_digits(given_digits(digits)),
                         watcher(watch, context), items_of(text_of(numbers, "numbers"), "numbers"));
    });
}

int libration_problem_coefficients(const libration_problem* problem, const char* point, const char* corners, long first,
                                   long last, long digits, int rigour, libration_table** coefficients) {
    return made(coefficients, [&] {
        const series_request request = request_of(point, corners, first, last);
        return table_of_numbers(solution_of(problem)->series(request, digits_by(digits, rigour)));
    });
}

int libration_problem_fractions(const libration_problem* problem, long first, long last,
                                libration_table** coefficients) {
    return made(coefficients, [&] {
        const series_request request = request_of(nullptr, nullptr, first, last);
        return table_of_numbers(*solution_of(problem, {.general = true})->fractions(request));
    });
}

int libration_problem_radius(const libration_problem* problem, long last, long digits, libration_table** tests) {
    return made(tests, [&] {
        if (last < 0 || last > most_powers_of_radius) {
            throw error(error_kind::argument, "power", std::to_string(last), "is not between 0 and 100000");
        }
        const auto of = solution_of(problem, {.general = true});
        return table_of_radii(of->radius({.order = last}, rounded_digits(given_digits(digits))),
                              of->quantities().front());
    });
}

int libration_problem_radius_bounds(const libration_problem* problem, long digits, libration_number** lower,
                                    libration_number** upper) {
    return guarded([&] {
        given(lower, "the pointer to the lower bound");
        given(upper, "the pointer to the upper bound");
        const answer found = solution_of(problem)->radius("", proved_digits(given_digits(digits)));
        auto first = std::make_unique<libration_number>(typed_number(found.at(0, "lower")));
        *upper = std::make_unique<libration_number>(typed_number(found.at(0, "upper"))).release();
        *lower = first.release();
    });
}

int libration_problem_singularities(const libration_problem* problem, const char* within, long digits, int rigour,
                                    libration_table** singularities, int* complete) {
    return made(singularities, [&] {
        if (rigour != LIBRATION_HEURISTIC && rigour != LIBRATION_PROVED) {
            throw error(error_kind::argument, "rigour", std::to_string(rigour),
                        "is neither LIBRATION_HEURISTIC nor LIBRATION_PROVED");
        }
        if (given_digits(digits) > most_digits_of_places) {
            throw error(error_kind::argument, "number of digits", std::to_string(digits), "is more than 1000");
        }
        const bool proved = rigour == LIBRATION_PROVED;
        const answer found =
            solution_of(problem, {.general = true})
                ->singularities(distance_of(within), proved ? proved_digits(digits) : rounded_digits(digits));
        if (complete != nullptr) {
            *complete = found.complete ? 1 : 0;
        }
        return table_of_singularities(found, rigour);
    });
}

int libration_problem_limits(const libration_problem* problem, long digits, libration_table** limits) {
    return partly_made(limits, [&] {
        const answer found = solution_of(problem)->limits(proved_digits(given_digits(digits)));
        return known_states{table_of_numbers(found), found.missing};
    });
}

int libration_problem_events(const libration_problem* problem, const char* condition, long count, long digits,
                             libration_table** events) {
    return partly_made(events, [&] { return events_of(*solution_of(problem), condition, count, digits); });
}

int libration_problem_find(const libration_problem* problem, const char* unknowns, const char* conditions, long digits,
                           libration_watch watch, void* context, libration_table** values) {
    return made(values, [&] {
        return table_of_values(find_unknowns(problem_of(problem), items_of(text_of(unknowns, "unknowns"), "unknowns"),
                                             conditions_of(text_of(conditions, "conditions")),
                                             watched_digits(digits, watcher(watch, context))));
    });
}

int libration_problem_orbit(const libration_problem* problem, long digits, libration_watch watch, void* context,
                            libration_table** orbit) {
    return made(orbit, [&] {
        return table_of_values(
            find_periodic_orbit(problem_of(problem), watched_digits(digits, watcher(watch, context))));
    });
}

void libration_problem_free(libration_problem* problem) { delete problem; }

size_t libration_catalogue_size(void) { return catalogue().size(); }

const char* libration_catalogue_name(size_t i) { return i < catalogue().size() ? catalogue()[i].name.data() : ""; }

const char* libration_catalogue_text(size_t i) { return i < catalogue().size() ? catalogue()[i].text.data() : ""; }
