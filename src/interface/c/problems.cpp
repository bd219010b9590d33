#include <algorithm>
#include <iterator>
#include <memory>

#include "guarded.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/problem/find.hpp"
#include "libration/problem/solution.hpp"
#include "libration/scalar/text/given_number.hpp"
#include "problem_tables.hpp"

namespace libration::c {

namespace {

libration_problem make_problem(const std::string& text, const std::string& settings) {
    problem read(trimmed(text));
    for (const auto& [name, value] : settings_of(settings, "settings")) {
        std::string change = name;
        change += " = ";
        change += value;
        read.set(change);
    }
    const ode::explicit_system system(read.equations());
    return {read.equations(), system, ode::names_of_state(system)};
}

problem problem_of(const libration_problem& p) { return problem(p.equations); }

exact time_of(const std::string& text) {
    const exact time = given_time("time", text);
    if (time.has_periods()) {
        throw error(error_kind::argument, "time", text, "is a multiple of a period, which a problem does not have");
    }
    return time;
}

// A row for each time, with what is known of it, and the reason if something is missing.
struct known_states {
    libration_table table;
    std::optional<error> missing;
};

// A value without proved digits is 0 to within its bound; there is none at a time that its equations do not reach.
void add_known(libration_table& table, const answer_value& value, bool proved) {
    if (value.text.empty() && value.bound.empty()) {
        table.add(std::string());
    } else if (value.text.empty()) {
        table.add(libration_number{"0", value.bound, LIBRATION_PROVED});
    } else if (proved) {
        table.add(proved_number({value.text, value.bound}));
    } else {
        table.add(rounded_number(value.text));
    }
}

known_states states_of(const libration_problem& p, const std::string& list, long digits, bool proved,
                       const watcher& watch, std::vector<std::string> numbers = {}) {
    const auto items = items_of(list, "times");
    std::vector<exact> times;
    std::ranges::transform(items, std::back_inserter(times), time_of);
    const request how{.scalar = {proved ? scalar_kind::proved : scalar_kind::arbitrary, given_digits(digits)},
                      .derivatives = std::move(numbers),
                      .progress = [&](double part) { watch(part); }};
    // A separate solution for each call: one in which memory ran out is not used again.
    auto found = solve(problem_of(p))->states(times, how);
    libration_table table{{"time"}, {}};
    table.names.insert(table.names.end(), found.names.begin(), found.names.end());
    for (std::size_t i = 0; i < items.size(); ++i) {
        table.add(items[i]);
        found.rows[i].resize(found.names.size());
        for (const answer_value& value : found.rows[i]) {
            add_known(table, value, proved);
        }
    }
    return {std::move(table), std::move(found.missing)};
}

// The table in a handle of the caller, and then the reason of what is missing.
void write_known(known_states found, libration_table** to) {
    *to = std::make_unique<libration_table>(std::move(found.table)).release();
    if (found.missing) {
        throw error(*found.missing);
    }
}

libration_number number_of(const answer_value& value, const std::string& rigour) {
    switch (value.kind) {
        case value_kind::whole_number: return {value.text, "0", LIBRATION_PROVED};
        case value_kind::text: return typed_number(value.text);
        case value_kind::number: break;
    }
    return rigour == "exact"    ? typed_number(value.text)
           : rigour == "proved" ? proved_number({value.text, value.bound})
                                : rounded_number(value.text);
}

// An answer of which every value is a number.
libration_table table_of_numbers(const answer& found) {
    libration_table table{found.names, {}};
    for (const auto& row : found.rows) {
        for (const answer_value& value : row) {
            table.add(number_of(value, found.rigour));
        }
    }
    return table;
}

// A name and a value in each row.
libration_table table_of_values(const answer& found) {
    libration_table table{found.names, {}};
    for (const auto& row : found.rows) {
        table.add(row[0].text);
        table.add(number_of(row[1], found.rigour));
    }
    return table;
}

series_request request_of(const char* point, const char* corners, long first, long last) {
    require_powers(first, last);
    if (is_given(corners) && !is_given(point)) {
        throw error(error_kind::argument, "corners", corners, "are a path to a point, and no point is given");
    }
    series_request request{.first = first, .order = last, .about = is_given(point) ? point : ""};
    if (is_given(corners)) {
        for (const std::string& each : items_of(corners, "corners")) {
            request.corners.push_back(point_in(each));
        }
    }
    return request;
}

request digits_by(long digits, int rigour) {
    return {.scalar = {asks_proof(rigour) ? scalar_kind::proved : scalar_kind::arbitrary, given_digits(digits)}};
}

// Proved digits by integrations whose number is not known: the part that is done is always 0.
request watched_digits(long digits, const watcher& watch) {
    request how = proved_digits(given_digits(digits));
    how.reached = [watch](double /*time*/, long /*bits*/) { watch(0.0); };
    return how;
}

// "f'(5) = 1; y(1) = 2".
std::vector<std::string> conditions_of(const std::string& text) {
    std::vector<std::string> conditions;
    for (const auto& [left, right] : settings_of(text, "conditions")) {
        conditions.push_back(left + " = " + right);
    }
    return conditions;
}

}  // namespace

}  // namespace libration::c

using namespace libration;
using namespace libration::c;

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
        auto found = states_of(given(problem, "problem"), text_of(times, "times"), digits, asks_proof(rigour),
                               watcher(watch, context));
        if (found.missing) {
            throw error(*found.missing);
        }
        return std::move(found.table);
    });
}

int libration_problem_known_states(const libration_problem* problem, const char* times, long digits, int rigour,
                                   libration_watch watch, void* context, libration_table** states) {
    return guarded([&] {
        given(states, "the pointer to the result");
        *states = nullptr;
        write_known(states_of(given(problem, "problem"), text_of(times, "times"), digits, asks_proof(rigour),
                              watcher(watch, context)),
                    states);
    });
}

int libration_problem_derivatives(const libration_problem* problem, const char* times, const char* numbers, long digits,
                                  libration_watch watch, void* context, libration_table** derivatives) {
    return guarded([&] {
        given(derivatives, "the pointer to the result");
        *derivatives = nullptr;
        write_known(states_of(given(problem, "problem"), text_of(times, "times"), digits, true, watcher(watch, context),
                              items_of(text_of(numbers, "numbers"), "numbers")),
                    derivatives);
    });
}

int libration_problem_coefficients(const libration_problem* problem, const char* point, const char* corners, long first,
                                   long last, long digits, int rigour, libration_table** coefficients) {
    return made(coefficients, [&] {
        const series_request request = request_of(point, corners, first, last);
        return table_of_numbers(
            solve(problem_of(given(problem, "problem")))->series(request, digits_by(digits, rigour)));
    });
}

int libration_problem_fractions(const libration_problem* problem, long first, long last,
                                libration_table** coefficients) {
    return made(coefficients, [&] {
        const series_request request = request_of(nullptr, nullptr, first, last);
        return table_of_numbers(*solve(problem_of(given(problem, "problem")), {.general = true})->fractions(request));
    });
}

int libration_problem_radius(const libration_problem* problem, long last, long digits, libration_table** tests) {
    return made(tests, [&] { return radius_table(given(problem, "problem").system, last, given_digits(digits)); });
}

int libration_problem_radius_bounds(const libration_problem* problem, long digits, libration_number** lower,
                                    libration_number** upper) {
    return guarded([&] {
        given(lower, "the pointer to the lower bound");
        given(upper, "the pointer to the upper bound");
        const answer found =
            solve(problem_of(given(problem, "problem")))->radius("", proved_digits(given_digits(digits)));
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
        auto found = singularity_table(given(problem, "problem").system, within == nullptr ? "" : within, digits,
                                       rigour == LIBRATION_PROVED);
        if (complete != nullptr) {
            *complete = found.complete ? 1 : 0;
        }
        return std::move(found.table);
    });
}

int libration_problem_limits(const libration_problem* problem, long digits, libration_table** limits) {
    return made(limits, [&] {
        return table_of_numbers(
            solve(problem_of(given(problem, "problem")))->limits(proved_digits(given_digits(digits))));
    });
}

int libration_problem_events(const libration_problem* problem, const char* condition, long count, long digits,
                             libration_table** events) {
    return guarded([&] {
        given(events, "the pointer to the result");
        *events = nullptr;
        if (count < 1) {
            throw error(error_kind::argument, "number of events", std::to_string(count), "is less than 1");
        }
        const answer found = solve(problem_of(given(problem, "problem")))
                                 ->events(text_of(condition, "condition"), count, proved_digits(given_digits(digits)));
        write_known({table_of_numbers(found), found.missing}, events);
    });
}

int libration_problem_find(const libration_problem* problem, const char* unknowns, const char* conditions, long digits,
                           libration_watch watch, void* context, libration_table** values) {
    return made(values, [&] {
        return table_of_values(find_unknowns(
            problem_of(given(problem, "problem")), items_of(text_of(unknowns, "unknowns"), "unknowns"),
            conditions_of(text_of(conditions, "conditions")), watched_digits(digits, watcher(watch, context))));
    });
}

int libration_problem_orbit(const libration_problem* problem, long digits, libration_watch watch, void* context,
                            libration_table** orbit) {
    return made(orbit, [&] {
        return table_of_values(find_periodic_orbit(problem_of(given(problem, "problem")),
                                                   watched_digits(digits, watcher(watch, context))));
    });
}

void libration_problem_free(libration_problem* problem) { delete problem; }

size_t libration_catalogue_size(void) { return catalogue().size(); }

const char* libration_catalogue_name(size_t i) { return i < catalogue().size() ? catalogue()[i].name.data() : ""; }

const char* libration_catalogue_text(size_t i) { return i < catalogue().size() ? catalogue()[i].text.data() : ""; }
