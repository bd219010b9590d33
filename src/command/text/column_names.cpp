#include "text/column_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "text/csv_records.hpp"
#include "text/input_error.hpp"
#include "text/quotation.hpp"

namespace libration {

namespace {

constexpr const char* columns_option = "--columns";
constexpr std::size_t most_listed = 20;

std::vector<std::string> items_of(const std::string& list) {
    std::vector<std::string> items;
    std::istringstream in(list);
    for (std::string item; std::getline(in, item, ',');) {
        items.push_back(trimmed(item));
    }
    return items;
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

// Without a unit in which our quantities are: "t [s]", "theta (rad)". Another one, as deg, stays.
std::string without_unit(const std::string& name) {
    static constexpr auto units = std::to_array<std::string_view>(
        {"", "-", "1", "s", "sec", "seconds", "rad", "radians", "rad/s", "1/s", "m", "m/s^2", "m/s2"});
    const std::size_t open = name.find_last_of("[(");
    if (open == std::string::npos || (name.back() != ']' && name.back() != ')')) {
        return name;
    }
    const std::string unit = trimmed(lower(name.substr(open + 1, name.size() - open - 2)));
    return std::find(units.begin(), units.end(), unit) != units.end() ? name.substr(0, open) : name;
}

std::string plain(const std::string& name) {
    std::string spelled = lower(without_unit(name));
    std::erase_if(spelled, [](char c) { return c == ' ' || c == '_'; });
    return spelled;
}

}  // namespace

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), most_listed); ++i) {
        text += (i == 0 ? "" : ", ") + quotation(names[i]);
    }
    return names.size() > most_listed ? text + fmt::format(" and {} more", names.size() - most_listed) : text;
}

std::string column_names::listed() const { return libration::listed(own_); }

column_names::column_names(std::string file, std::vector<std::string> own, std::size_t count,
                           const std::optional<std::string>& mapping, std::vector<known_column> known)
    : file_(std::move(file)), own_(std::move(own)), mapped_(own_.size()), known_(std::move(known)) {
    if (!mapping && own_.empty()) {
        throw input_error(count == 0 ? file_ + " has no header: name the columns in its first line"
                                     : fmt::format("{} has no header: name its {} columns in the first line or by "
                                                   "--columns time,theta,...",
                                                   file_, count));
    }
    if (!mapping) {
        return;
    }
    const auto items = items_of(*mapping);
    if (own_.empty()) {
        name_by_place(*mapping, items, count);
        return;
    }
    for (const std::string& item : items) {
        map(*mapping, item);
    }
}

void column_names::name_by_place(const std::string& mapping, const std::vector<std::string>& items, std::size_t count) {
    if (items.size() != count) {
        throw input_error(columns_option, mapping,
                          fmt::format("has {} names, and {} has {} columns and no header", items.size(), file_, count),
                          "name each column in its order, - for one that is not needed");
    }
    for (const std::string& item : items) {
        const std::string name = item.substr(item.find('=') == std::string::npos ? 0 : item.find('=') + 1);
        require_known(mapping, name);
        own_.push_back(name == "-" ? fmt::format("column_{}", own_.size() + 1) : name);
        mapped_.push_back(name);
    }
}

void column_names::map(const std::string& mapping, const std::string& item) {
    const std::size_t equal = item.rfind('=');
    if (equal == std::string::npos) {
        throw input_error(columns_option, mapping, "has " + quotation(item) + ", which is not THEIRS=OURS",
                          "write names such as t=time,E=energy");
    }
    const std::string theirs = trimmed(item.substr(0, equal));
    const std::string ours = trimmed(item.substr(equal + 1));
    const auto at = std::find(own_.begin(), own_.end(), theirs);
    if (at == own_.end()) {
        throw input_error(columns_option, mapping,
                          "has " + quotation(theirs) + ", which is not a column of " + quotation(file_),
                          "choose among " + listed());
    }
    require_known(mapping, ours);
    mapped_[static_cast<std::size_t>(at - own_.begin())] = ours;
}

void column_names::require_known(const std::string& mapping, const std::string& name) const {
    const auto is_it = [&](const known_column& each) { return each.name == name; };
    if (name == "-" || std::any_of(known_.begin(), known_.end(), is_it)) {
        return;
    }
    std::string names;
    for (const known_column& each : known_) {
        names += std::string(each.name) + ", ";
    }
    throw input_error(columns_option, mapping, "has " + quotation(name) + ", which is not a quantity",
                      "write " + names + "or -");
}

std::optional<std::size_t> column_names::find(std::string_view name) const {
    const auto known =
        std::find_if(known_.begin(), known_.end(), [&](const known_column& each) { return each.name == name; });
    if (known == known_.end()) {
        throw std::logic_error("no known column: " + std::string(name));
    }
    const auto is_mapped = [&](std::size_t i) { return mapped_[i] == name; };
    const auto is_ours = [&](std::size_t i) { return mapped_[i].empty() && own_[i] == name; };
    const auto is_spelled = [&](std::size_t i) {
        const std::string spelling = plain(own_[i]);
        return mapped_[i].empty() &&
               std::find(known->spellings.begin(), known->spellings.end(), spelling) != known->spellings.end();
    };
    const auto among = [&](const auto& fits) {
        std::vector<std::size_t> places;
        for (std::size_t i = 0; i < own_.size(); ++i) {
            if (fits(i)) {
                places.push_back(i);
            }
        }
        return places;
    };
    auto places = among([&](std::size_t i) { return is_mapped(i) || is_ours(i); });
    places = places.empty() ? among(is_spelled) : places;
    if (places.size() > 1) {
        throw input_error(fmt::format("{} has two columns '{}': {} and {}: name one of them {}=- in --columns", file_,
                                      name, quotation(own_[places[0]]), quotation(own_[places[1]]), own_[places[1]]));
    }
    return places.empty() ? std::nullopt : std::optional(places.front());
}

}  // namespace libration
