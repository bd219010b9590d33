#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "guarded.hpp"
#include "libration/number/given_number.hpp"
#include "libration/number/written_number.hpp"
#include "libration/verification/double_decimals.hpp"
#include "libration/verification/motion_truths.hpp"
#include "libration/verification/problem_truths.hpp"

namespace libration::c {

namespace {

// What is compared: the names of the columns, and for each row a time and one value per name, as texts.
struct asked_values {
    std::vector<std::string> names, times, values;
};

asked_values read_lists(const char* names, const char* times, const char* values) {
    asked_values asked{items_of(text_of(names, "names"), "names"), items_of(text_of(times, "times"), "times"),
                       items_of(text_of(values, "values"), "values")};
    if (asked.values.size() != asked.times.size() * asked.names.size()) {
        throw error(error_kind::argument, "number of values", std::to_string(asked.values.size()),
                    "is not the product of the number of times, " + std::to_string(asked.times.size()) +
                        ", and that of names, " + std::to_string(asked.names.size()));
    }
    return asked;
}

// A double exactly, as C's %a, nan or inf.
std::string text_of_double(double x) {
    constexpr std::size_t enough = 40;
    char text[enough];  // NOLINT(modernize-avoid-c-arrays)
    std::snprintf(text, enough, "%a", x);
    return text;
}

asked_values read_doubles(const char* names, std::size_t rows, const double* times, const double* values) {
    asked_values asked{items_of(text_of(names, "names"), "names"), {}, {}};
    if (rows == 0) {
        throw error(error_kind::argument, "rows", "0", "is less than 1");
    }
    given(times, "times");
    given(values, "values");
    std::transform(times, times + rows, std::back_inserter(asked.times), text_of_double);
    std::transform(values, values + rows * asked.names.size(), std::back_inserter(asked.values), text_of_double);
    return asked;
}

rational tolerance_of(const std::string& name, const std::string& text) {
    rational tolerance = given_fraction(name, text);
    if (tolerance <= 0) {
        throw error(error_kind::argument, name, text, "is not positive");
    }
    return tolerance;
}

compare_rules rules_of(const char* text) {
    compare_rules rules;
    for (const auto& [name, value] : settings_of(text == nullptr ? "" : text, "rules")) {
        if (name == "modulo") {
            if (value != "2pi") {
                throw error(error_kind::argument, name, value, "is not 2pi");
            }
            rules.modulo_turn = true;
        } else if (name == "rounding") {
            if (value != "half") {
                throw error(error_kind::argument, name, value, "is not half");
            }
            rules.rounded = true;
        } else if (name == "tolerance" || name == "relative" || name == "ulp") {
            (name == "tolerance"  ? rules.tolerance
             : name == "relative" ? rules.relative
                                  : rules.ulps) = tolerance_of(name, value);
        } else {
            throw error(error_kind::argument, "rules", name,
                        "is not one of tolerance, relative, ulp, rounding and modulo");
        }
    }
    if (rules.ulps && (rules.tolerance || rules.relative)) {
        throw error(error_kind::argument, "ulp", "", "is given together with another tolerance");
    }
    if (rules.rounded && !rules.by_last_digit()) {
        throw error(error_kind::argument, "rounding", "half", "is given together with another tolerance");
    }
    return rules;
}

libration_table table_for(const std::vector<std::string>& names) {
    libration_table table{{"time", "verdict", "condition"}, {}};
    for (const std::string& name : names) {
        for (const char* const what : {"_reference", "_error", "_correct_digits"}) {
            table.names.push_back(name + what);
        }
    }
    return table;
}

void add_row(libration_table& table, const std::string& time, const compared_values& row) {
    table.add(time);
    table.add(std::string(row.within() ? "ok" : "miss"));
    table.add(libration_number{row.condition, "", LIBRATION_HEURISTIC});
    for (const comparison& each : row.values) {
        libration_number reference = rounded_number(each.reference);
        reference.rigour = row.proved ? LIBRATION_PROVED : LIBRATION_HEURISTIC;
        table.add(std::move(reference));
        table.add(libration_number{each.error, "", LIBRATION_HEURISTIC});
        table.add(libration_number{correct_digits_text(each.tenths_of_digits), "", LIBRATION_HEURISTIC});
    }
}

// Whether the times are doubles in decimal.
bool times_are_doubles(const asked_values& asked) {
    double_decimals column;
    for (const std::string& time : asked.times) {
        try {
            column.add(time);
        } catch (const error&) {  // 2T/3, for instance
            return false;
        }
    }
    return column.recognised();
}

// For each name, whether its values are doubles in decimal.
std::vector<bool> names_of_doubles(const asked_values& asked, const compare_rules& rules) {
    std::vector<bool> found(asked.names.size());
    for (std::size_t i = 0; i < found.size() && rules.by_last_digit() && !rules.rounded; ++i) {
        double_decimals column;
        try {
            for (std::size_t at = i; at < asked.values.size(); at += found.size()) {
                column.add(asked.values[at]);
            }
            found[i] = column.recognised();
        } catch (const error&) {  // not a number, about which the comparison complains
            continue;
        }
    }
    return found;
}

libration_table compared(const asked_values& asked, const compare_rules& rules, const watcher& watch,
                         const std::function<row_question(const exact& time)>& ask) {
    libration_table table = table_for(asked.names);
    const auto of_doubles = names_of_doubles(asked, rules);
    const bool at_doubles = times_are_doubles(asked);
    for (std::size_t row = 0; row < asked.times.size(); ++row) {
        watch(row, asked.times.size());
        std::vector<written_value> values;
        for (std::size_t i = 0; i < asked.names.size(); ++i) {
            values.push_back({asked.values[row * asked.names.size() + i], asked.names[i], of_doubles[i]});
        }
        const std::string& text = asked.times[row];
        const exact time = is_hexadecimal(text) ? read_typed(text) : given_time("time", text);
        add_row(table, text, compare_row(values, ask(at_doubles ? nearest_double(time) : time), rules));
    }
    return table;
}

libration_table compared_with_motion(const libration_motion& m, const asked_values& asked, const char* rules,
                                     const watcher& watch) {
    const bool both = asked.names == std::vector<std::string>{"theta", "omega"};
    if (!both && asked.names != std::vector<std::string>{"theta"}) {
        throw error(error_kind::argument, "names", "", "are neither theta nor theta,omega");
    }
    pendulum::motion_truths truths(exact_numbers(m.given), m.of);
    return compared(asked, rules_of(rules), watch,
                    [&](const exact& time) { return truths.at(time, asked.names.size()); });
}

libration_table compared_with_problem(const libration_problem& p, const asked_values& asked, const char* text,
                                      const watcher& watch) {
    const compare_rules rules = rules_of(text);
    if (rules.modulo_turn) {
        throw error(error_kind::argument, "modulo", "2pi", "has no meaning for a problem");
    }
    const auto all = ode::components_of(p.system());
    std::vector<ode::solution_component> components;
    for (const std::string& name : asked.names) {
        const auto found = std::find(p.names.begin(), p.names.end(), name);
        if (found == p.names.end()) {
            throw error(error_kind::argument, "names", name,
                        "is neither an unknown of the problem nor a lower derivative");
        }
        components.push_back(all[static_cast<std::size_t>(found - p.names.begin())]);
    }
    ode::problem_truths truths(p.system(), p.equations, components);
    return compared(asked, rules, watch, [&](const exact& time) {
        if (time.has_periods()) {
            throw error(error_kind::argument, error_subject::time, time.text,
                        "is a multiple of a period, which a problem does not have");
        }
        return truths.at(time);
    });
}

}  // namespace

}  // namespace libration::c

using namespace libration;
using namespace libration::c;

int libration_motion_verify(const libration_motion* motion, const char* names, const char* times, const char* values,
                            const char* rules, libration_watch watch, void* context, libration_table** compared) {
    return made(compared, [&] {
        return compared_with_motion(given(motion, "motion"), read_lists(names, times, values), rules,
                                    watcher(watch, context));
    });
}

int libration_problem_verify(const libration_problem* problem, const char* names, const char* times, const char* values,
                             const char* rules, libration_watch watch, void* context, libration_table** compared) {
    return made(compared, [&] {
        return compared_with_problem(given(problem, "problem"), read_lists(names, times, values), rules,
                                     watcher(watch, context));
    });
}

int libration_motion_verify_doubles(const libration_motion* motion, const char* names, size_t rows, const double* times,
                                    const double* values, const char* rules, libration_watch watch, void* context,
                                    libration_table** compared) {
    return made(compared, [&] {
        return compared_with_motion(given(motion, "motion"), read_doubles(names, rows, times, values), rules,
                                    watcher(watch, context));
    });
}

int libration_problem_verify_doubles(const libration_problem* problem, const char* names, size_t rows,
                                     const double* times, const double* values, const char* rules,
                                     libration_watch watch, void* context, libration_table** compared) {
    return made(compared, [&] {
        return compared_with_problem(given(problem, "problem"), read_doubles(names, rows, times, values), rules,
                                     watcher(watch, context));
    });
}
