#include "plot/plot_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string_view>

#include "libration/equation/renamed_unknowns.hpp"
#include "libration/scalar/near_word.hpp"
#include "text/input_error.hpp"
#include "text/members.hpp"

namespace libration {

namespace {

constexpr const char* file_help =
    "to --out FILE.svg, .pdf or .png, all three without an ending; the table then goes to stdout";

std::optional<figure_file> file_if(bool given, const output_options& output) {
    return given ? std::optional<figure_file>(output.file()) : std::nullopt;
}

// Columns with numbers: those that can be drawn.
std::vector<std::string> drawable_names(const table& data) {
    std::vector<std::string> names = members_of(data.columns(), &column::name);
    std::erase_if(names, [](const std::string& name) {
        return name == "rigour" || name == "digits" || name == "undecided" || name.ends_with("_typed");
    });
    return names;
}

[[noreturn]] void refuse_name(const std::string& name, const std::vector<std::string>& offered) {
    throw input_error("--plot", name, "is not a quantity of the table" + suggestion(name, offered),
                      fmt::format("write names from {}", fmt::join(offered, ", ")));
}

}  // namespace

void plot_flag::add_to(CLI::App& command, const std::string& drawn) {
    command.add_flag("--plot", given_, fmt::format("draws {} {}", drawn, file_help));
}

std::optional<figure_file> plot_flag::file(const output_options& output) const { return file_if(given_, output); }

void plot_axes::add_to(CLI::App& command) {
    command
        .add_option("--plot", words_,
                    fmt::format("plot Y against X, t,x for a time series, x,y for a phase plane, t,x,y for several, {}",
                                file_help))
        ->type_name("X,Y,...")
        ->expected(0, 1);
}

void plot_axes::use_if_empty(const std::string& names) {
    if (words_ && words_->empty()) {
        words_ = names;
    }
}

std::optional<figure_file> plot_axes::file(const output_options& output) const {
    if (!given()) {
        return std::nullopt;
    }
    names();
    return file_if(true, output);
}

std::vector<std::string> plot_axes::names() const {
    std::vector<std::string> names;
    std::istringstream list(*words_);
    for (std::string name; std::getline(list, name, ',');) {
        name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
        names.push_back(name);
    }
    if (names.size() < 2 || std::ranges::find(names, "") != names.end()) {
        throw input_error("--plot", *words_, "does not name two axes", "write t,x or x,y, or t,x,y for several curves");
    }
    return names;
}

void plot_axes::require_known(const std::vector<column>& columns) const {
    const auto offered = drawable_names(table(columns));
    for (const std::string& name : names()) {
        std::string stem = name;
        for (const std::string_view end : {"_error", "_re", "_im"}) {
            if (name.ends_with(end)) {
                stem = name.substr(0, name.size() - end.size());
            }
        }
        if (name != "t" && name != "invariant_drift" && std::ranges::find(offered, stem) == offered.end() &&
            std::ranges::find(offered, stem, ode::name_before_renaming) == offered.end()) {
            refuse_name(name, offered);
        }
    }
}

std::vector<std::size_t> plot_axes::places_in(const table& data) const {
    const auto all = members_of(data.columns(), &column::name);
    const auto offered = drawable_names(data);
    std::vector<std::size_t> places;
    for (const std::string& name : names()) {
        auto found = std::ranges::find(all, name);
        if (found == all.end() && name == "t") {
            found = std::ranges::find(all, "time");
        }
        if (found == all.end()) {
            found = std::ranges::find(all, name, ode::name_before_renaming);
        }
        if (found == all.end() || std::ranges::find(offered, *found) == offered.end()) {
            refuse_name(name, offered);
        }
        places.push_back(static_cast<std::size_t>(found - all.begin()));
    }
    return places;
}

output_options table_output(const output_options& output, const std::optional<figure_file>& figure) {
    return figure ? output.on_stdout() : output;
}

}  // namespace libration
