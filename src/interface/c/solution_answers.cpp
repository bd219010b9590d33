#include "solution_answers.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/number/given_number.hpp"
#include "libration/query/proved_events.hpp"
#include "problem_tables.hpp"

namespace libration::c {

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

namespace {

void require_events(long count) {
    if (count < 1) {
        throw error(error_kind::argument, "number of events", std::to_string(count), "is less than 1");
    }
}

}  // namespace

known_states events_of(const solution& of, const char* condition, long count, long digits) {
    require_events(count);
    const answer found = of.events(text_of(condition, "condition"), count, proved_digits(given_digits(digits)));
    return known_states{table_of_numbers(found), found.missing};
}

namespace {

ode::crossing crossing_of(const std::string& word) {
    if (word != "up" && word != "down" && word != "any") {
        throw error(error_kind::argument, "crossing", word, "is not a direction: write up, down or any");
    }
    return word == "any" ? ode::crossing::any : word == "up" ? ode::crossing::up : ode::crossing::down;
}

bool is_yes(const std::string& name, const std::string& word) {
    if (word != "yes" && word != "no") {
        throw error(error_kind::argument, name, word, "is neither yes nor no");
    }
    return word == "yes";
}

long steps_in(const std::string& text) {
    long steps = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), steps);
    if (failure != std::errc() || end != text.data() + text.size() || steps < 1) {
        throw error(error_kind::argument, "horizon", text, "is not a positive number of steps");
    }
    return steps;
}

void set(ode::event_request& request, const std::string& name, const std::string& value) {
    if (name == "crossing") {
        request.way = crossing_of(value);
    } else if (name == "before") {
        const exact time = given_time("before", value);
        if (!time.is_number()) {
            throw error(error_kind::argument, "before", value, "is not a time");
        }
        request.before = as_exact_real(time);
    } else if (name == "from_start") {
        request.from_start = is_yes(name, value);
    } else if (name == "horizon") {
        request.horizon = steps_in(value);
    } else {
        throw error(error_kind::argument, "settings", name, "is none of crossing, before, from_start and horizon");
    }
}

}  // namespace

known_states events_of(const libration_problem& p, const solution& of, const char* condition, const char* settings,
                       long count, long digits, const watcher& watch) {
    require_events(count);
    ode::event_request request{.g = of.condition(text_of(condition, "condition")), .count = count};
    for (const auto& [name, value] : settings_of(settings == nullptr ? "" : settings, "settings")) {
        set(request, name, value);
    }
    if (request.before && p.ordinary) {
        request.direction = (*request.before - p.ordinary->point()).sign() < 0 ? -1 : 1;
    }
    const answer found =
        of.events(request, proved_digits(given_digits(digits)), [&](const ball&, long, const auto&) { watch(0); });
    return known_states{table_of_numbers(found), found.missing};
}

request watched(long digits, const watcher& watch) {
    request how = proved_digits(given_digits(digits));
    how.progress = [watch](double part) { watch(part); };
    return how;
}

printed_rows decimals_of(const libration_table& of, std::size_t first, long digits) {
    printed_rows rows{{}, digits};
    for (std::size_t k = 0; k < of.cells.size(); ++k) {
        if (k % of.names.size() == 0) {
            rows.of.emplace_back();
        }
        if (k % of.names.size() >= first) {
            rows.of.back().push_back(of.cells[k].number.decimal);
        }
    }
    return rows;
}

void write_file(const std::string& path, const std::string& content) {
    const std::string beside = path + ".new";
    std::ofstream file(beside, std::ios::binary);
    file << content;
    file.close();
    std::error_code failure;
    if (file) {
        std::filesystem::rename(beside, path, failure);
    }
    if (!file || failure) {
        std::error_code none_to_remove;
        std::filesystem::remove(beside, none_to_remove);
        throw error(error_kind::argument, "path", path,
                    "cannot be written: choose a file in a folder that exists and that you may write in");
    }
}

libration_table certified_states(const libration_problem& p, const solution& of, const char* times, long digits,
                                 const char* path, const watcher& watch) {
    const std::string file = text_of(path, "path");
    const request how = watched(digits, watch);
    const std::string list = text_of(times, "times");
    auto found = states_of(of, list, how, watch).complete();
    std::vector<exact> at;
    std::ranges::transform(items_of(list, "times"), std::back_inserter(at),
                           [](const std::string& item) { return given_time("time", item); });
    write_file(file, certificate_of_states(p.system(), at, decimals_of(found, 1, digits), how));
    return found;
}

libration_table certified_events(const libration_problem& p, const solution& of, const char* condition, long count,
                                 long digits, const char* path, const watcher& watch) {
    const std::string file = text_of(path, "path");
    const request how = watched(digits, watch);
    const std::string text = text_of(condition, "condition");
    require_events(count);
    const answer found = of.events(text, count, how);
    if (found.missing) {
        throw error(*found.missing);
    }
    auto table = table_of_numbers(found);
    const auto rows = decimals_of(table, 0, digits);
    write_file(file, certificate_of_events(p.system(), ode::parse_condition(p.equations, text), 0, rows, how));
    return table;
}

}  // namespace libration::c
