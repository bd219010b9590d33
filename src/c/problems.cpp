#include <algorithm>
#include <iterator>
#include <memory>

#include "guarded.hpp"
#include "libration/digits/proved/printed_values.hpp"
#include "libration/ode/first_order_form.hpp"
#include "libration/ode/parse.hpp"
#include "libration/ode/proved/problem_coefficients.hpp"
#include "libration/ode/proved/proved_singularity.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/problem/solution.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/exponent_range.hpp"
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
                       const watcher& watch) {
    const auto items = items_of(list, "times");
    std::vector<exact> times;
    std::ranges::transform(items, std::back_inserter(times), time_of);
    const request how{.scalar = {proved ? scalar_kind::proved : scalar_kind::arbitrary, given_digits(digits)},
                      .progress = [&](double part) { watch(part); }};
    // A separate solution for each call: one in which memory ran out is not used again.
    auto found = solve(problem(p.equations))->states(times, how);
    libration_table table{{"time"}, {}};
    table.names.insert(table.names.end(), p.names.begin(), p.names.end());
    for (std::size_t i = 0; i < items.size(); ++i) {
        table.add(items[i]);
        found.rows[i].resize(p.names.size());
        for (const answer_value& value : found.rows[i]) {
            add_known(table, value, proved);
        }
    }
    return {std::move(table), std::move(found.missing)};
}

std::vector<std::string> names_of_unknowns(const ode::explicit_system& system, bool parts) {
    std::vector<std::string> names;
    for (const auto& each : system.unknowns()) {
        if (parts) {
            names.insert(names.end(), {each.name + "_re", each.name + "_im"});
        } else {
            names.push_back(each.name);
        }
    }
    return names;
}

// One row per power; `as_number` converts the elements of the list to numbers.
template <class Number, class AsNumber>
libration_table table_of(const ode::coefficient_request& request, const ode::coefficient_list<Number>& list,
                         const AsNumber& as_number) {
    libration_table table{{"n"}, {}};
    const auto names = names_of_unknowns(request.system, list.complex);
    table.names.insert(table.names.end(), names.begin(), names.end());
    if (list.root > 1) {
        table.names.emplace_back("power");
    }
    for (std::size_t at = 0; at < list.values.size(); at += names.size()) {
        const long n = request.first + static_cast<long>(at / names.size());
        table.add(count_number(n));
        for (std::size_t i = 0; i < names.size(); ++i) {
            table.add(as_number(list.values[at + i]));
        }
        if (list.root > 1) {
            table.add(typed_number(rational(n, list.root).str()));
        }
    }
    return table;
}

ode::complex_constant read_point(const std::string& text) {
    try {
        return ode::parse_complex_constant(text);
    } catch (const error& problem) {
        throw error(problem.kind(), "point", text, problem.reason());
    }
}

libration_table coefficients_of(const ode::coefficient_request& request, long digits, bool proved) {
    require_powers(request.first, request.order);
    const whole_exponent_range exponents;
    if (proved) {
        return table_of(request, ode::proved_coefficients(request, given_digits(digits)), proved_number);
    }
    return table_of(request, ode::rounded_coefficients({scalar_kind::arbitrary, given_digits(digits)}, request),
                    [&](const mpfr& value) { return rounded_number(to_decimal(value, digits)); });
}

ode::coefficient_request request_of(const libration_problem& p, const char* point, const char* corners, long first,
                                    long last) {
    ode::coefficient_request request{p.system, first, last};
    if (is_given(point)) {
        request.at = read_point(point);
    } else if (is_given(corners)) {
        throw error(error_kind::argument, "corners", corners, "are a path to a point, and no point is given");
    }
    if (is_given(corners)) {
        for (const std::string& each : items_of(corners, "corners")) {
            request.corners.push_back(read_point(each));
        }
    }
    return request;
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
        auto found = states_of(given(problem, "problem"), text_of(times, "times"), digits, asks_proof(rigour),
                               watcher(watch, context));
        *states = std::make_unique<libration_table>(std::move(found.table)).release();
        if (found.missing) {
            throw error(*found.missing);
        }
    });
}

int libration_problem_coefficients(const libration_problem* problem, const char* point, const char* corners, long first,
                                   long last, long digits, int rigour, libration_table** coefficients) {
    return made(coefficients, [&] {
        return coefficients_of(request_of(given(problem, "problem"), point, corners, first, last), digits,
                               asks_proof(rigour));
    });
}

int libration_problem_fractions(const libration_problem* problem, long first, long last,
                                libration_table** coefficients) {
    return made(coefficients, [&] {
        require_powers(first, last);
        const ode::coefficient_request request{given(problem, "problem").system, first, last};
        return table_of(request, ode::exact_coefficients(request),
                        [](const rational& value) { return typed_number(value.str()); });
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
        const auto proof = ode::prove_radius(given(problem, "problem").system, given_digits(digits));
        const auto [below, above] = ode::outward_decimals(proof, digits);
        auto first = std::make_unique<libration_number>(typed_number(below));
        *upper = std::make_unique<libration_number>(typed_number(above)).release();
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

void libration_problem_free(libration_problem* problem) { delete problem; }

size_t libration_catalogue_size(void) { return catalogue().size(); }

const char* libration_catalogue_name(size_t i) { return i < catalogue().size() ? catalogue()[i].name.data() : ""; }

const char* libration_catalogue_text(size_t i) { return i < catalogue().size() ? catalogue()[i].text.data() : ""; }
