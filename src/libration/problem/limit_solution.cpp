#include "libration/problem/limit_solution.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "../query/connection/carried_connection.hpp"
#include "../query/connection/connection_orbit.hpp"
#include "../query/connection/layer_connection.hpp"
#include "../query/connection/linear_decay.hpp"
#include "connection_notes.hpp"
#include "found_values.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/equation/text/limit_condition.hpp"
#include "libration/query/connection/connection.hpp"
#include "libration/query/well/eigenvalues.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "limits_of_unknowns.hpp"

namespace libration {

namespace {

constexpr long digits_of_first_attempt = 12;
constexpr long digits_beyond_shortage = 5;
constexpr int most_attempts = 6;
constexpr int attempts_for_zero = 3;
constexpr long digits_beyond_enclosure = 30;

bool is_limit(const exact& time) { return time.text == "inf" || time.text == "-inf"; }
int direction_of(const exact& time) { return time.text == "inf" ? 1 : -1; }

std::vector<ode::limit_condition> limits_of(const limit_problem& of) {
    std::vector<ode::limit_condition> limits;
    for (const std::string& each : of.conditions) {
        limits.push_back(about(error_subject::conditions, [&] { return ode::parse_limit(of.of.equations(), each); }));
    }
    return limits;
}

// The unknowns of a problem with so many digits, and what else is known.
struct found_limits {
    ode::connection connection;
    std::vector<answer_note> notes;
};

found_limits find_limits(const limit_problem& of, long digits, const ode::proof_route& route, const request& how) {
    found_limits result;
    const auto& equations = of.of.equations();
    if (!ode::is_well(equations, of.unknowns)) {
        ode::connection_question question{equations, of.unknowns, limits_of(of), of.without_guess, digits};
        try {
            result.connection =
                about(error_subject::unknowns, [&] { return ode::proved_connection(question, route, watch_of(how)); });
            result.notes = notes_of(result.connection);
            return result;
        } catch (const error&) {
            if (of.conditions.size() > 1 || !is_decided_by_lemma(equations, of.unknowns, of.conditions.front())) {
                throw;
            }
        }
    }
    const answer found =
        find_unknowns(of.of, of.unknowns, of.conditions,
                      {.scalar = {scalar_kind::proved, digits}, .reached = how.reached}, of.without_guess);
    for (const auto& row : found.rows) {
        result.connection.values.push_back({row[1].text, row[1].bound});
    }
    result.notes = found.notes;
    return result;
}

// The most digits that a state lacks; with `zeros` also a state that is not distinguished from 0.
long shortage_of(const std::vector<std::vector<ball>>& states, long digits, bool zeros) {
    long shortage = 0;
    for (const auto& state : states) {
        for (const ball& each : state) {
            if (zeros || !contains_zero(each)) {
                shortage = std::max(shortage, digits - proved_digits(each, digits));
            }
        }
    }
    return shortage;
}

std::vector<answer_value> limits_of_orbit(const ode::connection_orbit& orbit, int direction, long digits) {
    std::vector<answer_value> row;
    for (const ball& each : orbit.limits(direction)) {
        row.push_back(value_in_answer(known_of(each, digits)));
    }
    return row;
}

// A row for each time, and why one is not complete.
template <class Limits>
void add_rows(answer& to, const std::vector<exact>& times, const std::optional<std::vector<std::vector<ball>>>& states,
              const Limits& limits, long digits) {
    std::size_t next = 0;
    for (const exact& time : times) {
        auto& row = to.rows.emplace_back();
        if (is_limit(time)) {
            row = limits(direction_of(time));
        } else if (!states) {
            to.missing = error(error_kind::undecided, error_subject::time, time.text,
                               "is not reached by a proof: choose an earlier one, or fewer digits");
            continue;
        } else {
            for (const ball& each : (*states)[next]) {
                row.push_back(value_in_answer(known_of(each, digits)));
            }
            ++next;
        }
        const auto open = std::ranges::find_if(row, [](const answer_value& each) { return each.text.empty(); });
        if (open != row.end() && !to.missing) {
            to.missing =
                error(error_kind::undecided, error_subject::solution, "",
                      "has " + to.names[static_cast<std::size_t>(open - row.begin())] + " at time " + time.text +
                          (open->bound.empty() ? ", which is not known" : ", which is not distinguished from 0"));
        }
    }
}

}  // namespace

bool is_shown(const answer_note& number, const std::vector<std::string>& shown) {
    return std::ranges::find(shown, number.kind) != shown.end();
}

limit_solution::limit_solution(limit_problem of) : of_(std::move(of)) {
    bool begins = false, ends = false;
    std::vector<std::string> moving;
    for (const auto& each : limits_of(of_)) {
        (each.direction > 0 ? ends : begins) = true;
    }
    two_ends_ = begins && ends;
    quantities_ = ode::names_of_state(ode::explicit_system(of_.of.equations()));
}

answer limit_solution::unknowns(const request& how) const {
    const long digits = how.printed_digits();
    const found_limits found = find_limits(of_, digits + digits_of_first_attempt, {}, how);
    const precision_scope scope(digits + digits_of_first_attempt + digits_beyond_enclosure);
    answer result{.names = {"name", "value", "kind"}, .rows = {}, .rigour = "proved", .notes = found.notes};
    const auto add = [&](const std::string& name, const proved_decimal& value, const std::string& kind) {
        const ball enclosed = enclosure_of(value);
        const auto shorter =
            to_proved_decimal(enclosed, std::max(1L, std::min(digits, proved_digits(enclosed, digits))));
        result.rows.push_back({text_value(name), value_in_answer({shorter.value_or(value), ""}), text_value(kind)});
    };
    for (std::size_t i = 0; i < of_.unknowns.size(); ++i) {
        add(of_.unknowns[i], found.connection.values[i], "unknown");
    }
    for (const ode::connection_number& each : found.connection.more) {
        add(each.name, each.value, each.kind);
    }
    return result;
}

answer limit_solution::states(const std::vector<exact>& times, const std::vector<std::string>& shown,
                              const request& how) const {
    const auto checked = checked_products(how.check);
    answer found = states_by(times, shown, how, false);
    if (how.check) {
        request finer = how;
        finer.digits = how.printed_digits() + ode::more_digits_of_second_proof;
        const answer second = states_by(times, shown, finer, true);
        for (std::size_t i = 0; i < found.rows.size(); ++i) {
            for (std::size_t j = 0; j < found.rows[i].size(); ++j) {
                const answer_value& a = found.rows[i][j];
                const answer_value& b = second.rows[i][j];
                if (!a.text.empty() && !b.text.empty() && a.text != "inf") {
                    require_agreement({a.text, a.bound}, {b.text, b.bound},
                                      found.names[j] + " at time " + times[i].text);
                }
            }
        }
    }
    return found;
}

answer limit_solution::states_by(const std::vector<exact>& times, const std::vector<std::string>& shown,
                                 const request& how, bool second) const {
    const long digits = how.printed_digits();
    const auto route = second ? ode::proof_route::second() : ode::proof_route{};
    std::vector<exact> finite;
    std::ranges::copy_if(times, std::back_inserter(finite), [](const exact& each) { return !is_limit(each); });
    long of_unknowns = digits + digits_of_first_attempt;
    for (int attempt = 1;; ++attempt) {
        const found_limits found = find_limits(of_, of_unknowns, route, how);
        const precision_scope scope(of_unknowns + digits_beyond_enclosure);
        const auto& orbit = found.connection.orbit;
        const bool by_orbit = orbit && (two_ends_ || orbit->quantities() == quantities_);
        answer result{.names = by_orbit ? orbit->quantities() : quantities_, .rows = {}, .rigour = "proved"};
        limits_of_unknowns flow(of_.of.equations(), of_.unknowns, limits_of(of_), found.connection.values,
                                result.names);
        std::vector<ball> at;
        for (const exact& each : finite) {
            at.push_back(ode::constant_value<ball>::of(as_exact_real(each)));
        }
        const long bits = bits_of_first_run(of_unknowns);
        const auto states = by_orbit ? orbit->states(at, bits) : flow.states(at, bits, route, watch_of(how));
        const long shortage = states ? shortage_of(*states, digits, attempt < attempts_for_zero) : of_unknowns / 2;
        if (shortage > 0 && attempt < most_attempts) {
            of_unknowns += shortage + digits_beyond_shortage;
            continue;
        }
        add_rows(
            result, times, states,
            [&](int direction) {
                return by_orbit && (two_ends_ || direction == orbit->direction())
                           ? limits_of_orbit(*orbit, direction, digits)
                           : limits_of_flow(flow, direction, digits);
            },
            digits);
        result.notes = notes_of(found.connection.values, digits);
        for (const answer_note& each : found.notes) {
            result.notes.push_back(each);
        }
        for (const ode::connection_number& each : found.connection.more) {
            const ball value = enclosure_of(each.value);
            const answer_value number =
                value_in_answer(known_of(value, std::min(digits, proved_digits(value, digits))));
            result.notes.push_back({each.name, number.text, each.kind});
            if (is_shown(result.notes.back(), shown)) {
                result.names.push_back(each.name);
                for (auto& row : result.rows) {
                    row.push_back(number);
                }
            }
        }
        return result;
    }
}

// The limits of all quantities that conditions give.
std::vector<answer_value> limit_solution::limits_of_flow(limits_of_unknowns& flow, int direction, long digits) const {
    const ode::connection_question question{of_.of.equations(), of_.unknowns, limits_of(of_), {}, digits};
    const bool of_layer = ode::is_layer(question) || ode::is_carried(question);
    const bool rests = of_layer || ode::is_linear_decay(question) || ode::is_well(question.system, question.unknowns);
    std::vector<answer_value> row;
    for (const std::string& name : quantities_) {
        row.push_back(flow.limit(name, direction, digits, rests, of_layer).value_or(answer_value{}));
    }
    if (std::ranges::all_of(row, [](const answer_value& each) { return each.text.empty(); })) {
        throw error(error_kind::argument, error_subject::time, direction > 0 ? "inf" : "-inf",
                    std::string("is an end without conditions: write ") + (direction > 0 ? "-inf" : "inf") +
                        ", or finite times");
    }
    return row;
}

std::vector<answer_note> limit_solution::notes_of(const std::vector<proved_decimal>& values, long digits) const {
    std::vector<answer_note> notes;
    for (std::size_t i = 0; i < of_.unknowns.size(); ++i) {
        const auto value = to_proved_decimal(enclosure_of(values[i]), digits);
        notes.push_back({of_.unknowns[i], value ? value->text : values[i].text});
    }
    return notes;
}

}  // namespace libration
