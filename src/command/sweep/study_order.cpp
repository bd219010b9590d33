#include "sweep/study_order.hpp"
#include "libration/scalar/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string_view>
#include <thread>

#include "libration/number/grid.hpp"
#include "option/options.hpp"
#include "run/whole_grid.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr const char* scalar_option = "--scalar";
constexpr std::string_view typed_ending = "_typed";

// An axis whose option has no argument, with the single value "yes".
constexpr const char* prove_option = "--prove";

bool takes_no_argument(const axis& along) { return along.option == prove_option; }

// The items of an axis; for an axis of words, the words between commas.
std::vector<grid_item> items_of(const axis& along, const std::string& words) {
    if (along.form == axis_form::one_number) {
        return {{{read_exact(words)}, false}};
    }
    if (along.form != axis_form::words) {
        return along.form == axis_form::whole ? read_whole_items(words, along.largest) : read_grid_items(words);
    }
    std::vector<grid_item> items;
    for (std::size_t begin = 0; begin <= words.size();) {
        const std::size_t end = std::min(words.find(',', begin), words.size());
        items.push_back({{exact{0, unit::one, words.substr(begin, end - begin)}}, false});
        begin = end + 1;
    }
    return items;
}

// The values of one axis.
struct axis_reading {
    std::vector<exact> kept;
    std::map<std::string, std::string> left_out;  // the values by reason
};

// A value without a result is left out of a range; as a single item it is an error.
axis_reading without_excluded(const study& what, const axis& along, const std::vector<grid_item>& items) {
    axis_reading result;
    for (const grid_item& item : items) {
        for (const exact& value : item.values) {
            const bool numeric = along.form != axis_form::words;
            const std::string reason =
                numeric ? reason_against(what.excluded, along.coordinate, along.coordinate_of(value)) : "";
            if (reason.empty()) {
                result.kept.push_back(value);
            } else if (item.is_range) {
                std::string& values = result.left_out[reason];
                values += (values.empty() ? "" : ", ") + value.text;
            } else {
                const std::string text = along.to_coordinate ? decimal_of(along.coordinate_of(value), 50) : value.text;
                throw error(error_kind::argument, {error_subject::option, along.option}, "",
                            fmt::format("has the {} {}, where {}", along.coordinate, text, reason));
            }
        }
    }
    return result;
}

// Smaller by value. Formulas that cannot be distinguished at any precision remain in the order in which they were
// typed.
bool comes_before(const exact& a, const exact& b) {
    try {
        return a.text != b.text && sign_of_exact(a - b) < 0;
    } catch (const error&) {
        return false;
    }
}

// Every value once, by size, so that the tables do not depend on the order in which they were typed. Times of which
// some are multiples of T and some are not have no order before a motion is chosen, and words have none at all.
void put_in_order(const axis& along, std::vector<exact>& values) {
    const auto in_periods = [](const exact& value) { return value.has_periods(); };
    const auto periods = std::count_if(values.begin(), values.end(), in_periods);
    const auto zeros = std::count_if(values.begin(), values.end(), [](const exact& value) { return value.is_zero(); });
    const bool have_order = periods == 0 || periods + zeros == static_cast<std::ptrdiff_t>(values.size());
    if (along.form == axis_form::words || !have_order) {
        return;
    }
    std::stable_sort(values.begin(), values.end(), comes_before);
    const auto same = [](const exact& a, const exact& b) { return a.text == b.text; };
    values.erase(std::unique(values.begin(), values.end(), same), values.end());
}

axis_reading read_axis(const study& what, const axis& along, const std::string& words) {
    const auto items = reading(along.option, words, along.remedy, [&] {
        auto read = items_of(along, words);
        for (const grid_item& item : read) {
            if (along.check) {
                std::for_each(item.values.begin(), item.values.end(), along.check);
            }
        }
        return read;
    });
    axis_reading result = without_excluded(what, along, items);
    if (result.kept.empty()) {
        throw input_error(along.option, words, "has no value for which " + what.name + " is defined", along.remedy);
    }
    put_in_order(along, result.kept);
    return result;
}

const axis* axis_with(const study& what, const std::string& option) {
    const auto in = [&](const std::vector<axis>& axes) {
        const auto found = std::ranges::find(axes, option, &axis::option);
        return found == axes.end() ? nullptr : &*found;
    };
    const axis* const of_problem = what.of != nullptr ? in(what.of->axes) : nullptr;
    return of_problem != nullptr ? of_problem : in(study_axes());
}

const axis& axis_of(const study& what, const std::string& option) {
    const axis* const found = axis_with(what, option);
    if (found == nullptr) {
        throw std::logic_error("the study " + what.name + " has no axis for " + option);
    }
    return *found;
}

void require_own(const study& what, const study_words& words) {
    for (const auto& [option, value] : words) {
        if (std::ranges::find(what.parameters, option, &study_parameter::option) == what.parameters.end()) {
            if (option == prove_option) {
                throw input_error(option + " is not a parameter of the study " + what.name +
                                  ": leave it out; domb_sykes and root_test have it with --problem");
            }
            throw input_error(option, value, "is not a parameter of the study " + what.name, "leave it out");
        }
    }
}

std::string scalars_offered(arithmetics offered) {
    return offered == arithmetics::rounding ? "double, long-double, quad or mpfr:DIGITS"
                                            : "double, long-double, quad, mpfr:DIGITS or ball:DIGITS (proved)";
}

// What may be written for an axis.
std::string forms_of_axis(const axis& along) {
    if (!along.forms.empty()) {
        return along.forms;
    }
    switch (along.form) {
        case axis_form::numbers: return "LIST, a:b:count or a:b:COUNTlog";
        case axis_form::whole: return "LIST or a:b:count, integers";
        case axis_form::words: return "LIST";
        case axis_form::one_number: return "a number";
    }
    throw std::logic_error("an axis of an unknown form");
}

// Whether an argument was given for the coordinate of this axis.
bool coordinate_chosen(const study& what, const axis& along, const study_words& words) {
    return std::any_of(words.begin(), words.end(), [&](const auto& said) {
        return said.first != scalar_option && axis_of(what, said.first).coordinate == along.coordinate;
    });
}

void add_left_out(study_order& order, const axis& along, const axis_reading& read) {
    for (const auto& [reason, values] : read.left_out) {
        order.left_out += fmt::format("{}the {} {} of {}, where {}", order.left_out.empty() ? "" : "; ", along.name,
                                      values, along.option, reason);
    }
}

// Proved numbers before those of many digits before those of few.
bool is_more_precise(const scalar_spec& a, const scalar_spec& b) {
    const auto rank = [](const scalar_spec& each) {
        return each.kind == scalar_kind::proved ? 2 : each.kind == scalar_kind::arbitrary ? 1 : 0;
    };
    return rank(a) != rank(b) ? rank(a) > rank(b) : a.digits > b.digits;
}

void read_scalars(study_order& order, const std::string& words) {
    const study& what = *order.what;
    if (words.find(',') != std::string::npos && !what.several_scalars) {
        throw input_error(scalar_option, words, "is a list, and this study takes one arithmetic at a time",
                          "run it for each of them with --out DIR of its own");
    }
    std::vector<scalar_spec> all;
    std::istringstream list(words);
    for (std::string name; std::getline(list, name, ',');) {
        all.push_back(reading(scalar_option, words, "write " + scalars_offered(what.offers),
                              [&] { return read_scalar(name, what.offers); }));
    }
    std::ranges::stable_sort(all, is_more_precise);
    const auto repeated = std::ranges::unique(all, {}, &scalar_spec::name);
    all.erase(repeated.begin(), repeated.end());
    if (all.empty()) {
        throw input_error(scalar_option, words, "has no arithmetic", "write " + scalars_offered(what.offers));
    }
    order.request.scalar = all.front();
    order.request.further_scalars.assign(all.begin() + 1, all.end());
}

void fill(study_order& order, const study_parameter& own, const study_words& words) {
    const study& what = *order.what;
    const auto said = words.find(own.option);
    if (own.option == scalar_option) {
        // Without a scalar, the study chooses.
        if (said != words.end()) {
            read_scalars(order, said->second);
        }
        return;
    }
    const axis& along = axis_of(what, own.option);
    if (said != words.end()) {
        axis_reading read = read_axis(what, along, said->second);
        add_left_out(order, along, read);
        order.request.values.set(along.name, std::move(read.kept));
    } else if (!own.usual.empty() && !coordinate_chosen(what, along, words)) {
        order.request.values.set(along.name, read_axis(what, along, own.usual).kept);
    }
}

}  // namespace

std::string forms_of(const study& what, const std::string& option) {
    if (option == scalar_option) {
        return scalars_offered(what.offers) + (what.several_scalars ? "; several, separated by commas" : "");
    }
    return forms_of_axis(axis_of(what, option));
}

std::vector<study_option> options_of(const std::vector<const study*>& studies) {
    std::vector<study_option> all;
    const auto add = [&](const std::vector<axis>& axes) {
        for (const axis& each : axes) {
            if (std::ranges::find(all, each.option, &study_option::option) == all.end()) {
                const bool flag = takes_no_argument(each);
                all.push_back({each.option,
                               flag                                 ? ""
                               : each.form == axis_form::one_number ? "X"
                                                                    : "LIST",
                               flag ? each.help : each.help + ": " + forms_of_axis(each)});
            }
        }
    };
    std::vector<std::string> provers;
    for (const study* each : studies) {
        if (each->of != nullptr) {
            add(each->of->axes);
        }
        if (each->offers == arithmetics::proved_too) {
            provers.push_back(each->name);
        }
    }
    add(study_axes());
    const std::string proofs =
        provers.empty() ? "" : fmt::format("; ball:DIGITS (proved) in {}", fmt::join(provers, ", "));
    all.push_back({scalar_option, "S", scalars_offered(arithmetics::rounding) + proofs});
    return all;
}

int jobs_of(const std::optional<std::string>& words) {
    constexpr int most_jobs = 1024;
    if (!words) {
        return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    }
    const char* const remedy = "write the number of threads, 1 or more";
    const int jobs = reading("--jobs", *words, remedy, [&] { return read_count(*words, most_jobs); });
    if (jobs == 0) {
        throw input_error("--jobs", *words, "is less than one thread", remedy);
    }
    return jobs;
}

study_order order_of(const study& what, const study_words& words, int jobs) {
    require_own(what, words);
    study_order order{&what, {}, "libration study " + (what.command.empty() ? what.name : what.command), ""};
    order.request.jobs = jobs;
    for (const study_parameter& own : what.parameters) {
        if (const auto said = words.find(own.option); said != words.end()) {
            const bool flag = own.option != scalar_option && takes_no_argument(axis_of(what, own.option));
            order.command +=
                " " + own.option + (flag ? "" : (said->second.starts_with("-") ? "=" : " ") + said->second);
        }
        fill(order, own, words);
    }
    return order;
}

table with_columns_of(const table& data, const std::optional<std::string>& names) {
    std::string own;
    std::istringstream list(names.value_or(""));
    for (std::string name; std::getline(list, name, ',');) {
        const bool has = std::any_of(data.columns().begin(), data.columns().end(),
                                     [&](const column& each) { return each.name == name; });
        own += has ? (own.empty() ? "" : ",") + name : "";
    }
    return own.empty() ? data : with_named_columns(data, own);
}

own_columns::own_columns(const std::vector<column>& columns) : columns_(columns.size()) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (!columns[i].name.ends_with(typed_ending)) {
            continue;
        }
        const std::string plain = columns[i].name.substr(0, columns[i].name.size() - typed_ending.size());
        const auto found = std::ranges::find(columns, plain, &column::name);
        typed_.push_back({i, found == columns.end() ? std::nullopt : std::optional(found - columns.begin())});
    }
}

// A cell repeats others if it is empty, if it equals that of the other column, or, if there is none, if it is a
// decimal, which was kept exactly.
void own_columns::see(const table_row_cells& row) {
    for (typed_column& each : typed_) {
        const cell& said = row[each.place];
        each.repeats = each.repeats && (said.is_empty() ||
                                        (each.plain ? said == row[*each.plain] : read_cell(said.text()).is_number()));
    }
}

std::vector<std::size_t> own_columns::places() const {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < columns_; ++i) {
        const bool repeats = std::any_of(typed_.begin(), typed_.end(),
                                         [&](const typed_column& each) { return each.place == i && each.repeats; });
        if (!repeats) {
            kept.push_back(i);
        }
    }
    return kept;
}

void without_repetitions(std::vector<study_table>& tables) {
    std::erase_if(tables, [](const study_table& part) { return !part.written; });
    for (study_table& part : tables) {
        own_columns own(part.data.columns());
        for (const table_row_cells& row : part.data.rows()) {
            own.see(row);
        }
        part.data = part.data.with_columns(own.places());
    }
}

}  // namespace libration
