#include "change_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string_view>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/near_word.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

// The text before =, without blanks.
std::string left_side_of(const std::string& change) {
    std::string left = change.substr(0, change.find('='));
    std::erase_if(left, [](unsigned char c) { return std::isspace(c) != 0; });
    return left;
}

bool is_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// f, f', f'', ... of f''(0); empty for another form.
std::string started_in(const std::string& left) {
    const std::size_t bracket = left.find('(');
    if (bracket == std::string::npos || !left.ends_with(')')) {
        return "";
    }
    const std::string name = left.substr(0, bracket);
    return std::ranges::all_of(name, [](char c) { return is_of_name(c) || c == '\''; }) ? name : "";
}

// The name that the system has for the unknown of an initial value: n_ for n.
std::string name_in_system(const ode::equation_system& system, const std::string& left, const std::string& started) {
    try {
        const ode::expression of = started.empty() ? ode::expression() : ode::parse_value_at_time(system, left).of;
        return of.kind() == ode::node_kind::unknown ? ode::primed(of.name(), of.derivative()) : started;
    } catch (const error&) {
        return started;
    }
}

// Whether ode::changed() names the meaning of a name that is not a parameter.
bool has_other_meaning(const ode::equation_system& system, const std::string& name) {
    const auto unknowns = system.unknowns();
    return name == "e" || name == system.variable || std::ranges::find(unknowns, name) != unknowns.end();
}

[[noreturn]] void refuse(const std::string& change, const std::string& left, const char* what,
                         const std::vector<std::string>& own) {
    const std::string article = std::string_view("aeiou").find(what[0]) == std::string_view::npos ? "a" : "an";
    throw input_error("--set", change,
                      fmt::format("does not name {} {} of this problem{}", article, what, suggestion(left, own)),
                      own.empty() ? fmt::format("leave it out, as there is no {}", what)
                                  : fmt::format("choose one of its own, {}", fmt::join(own, ", ")));
}

}  // namespace

void require_changeable(const ode::equation_system& system, const std::string& change) {
    const std::string left = left_side_of(change);
    const bool whole = change.find('=') != std::string::npos && change.find_first_of(";,") == std::string::npos;
    if (!whole || left.empty()) {
        return;
    }
    if (std::ranges::all_of(left, is_of_name) && !system.has_parameter(left) && !has_other_meaning(system, left)) {
        std::vector<std::string> own;
        std::ranges::transform(system.parameters, std::back_inserter(own), &ode::definition::name);
        std::ranges::transform(system.open, std::back_inserter(own), &ode::open_parameter::name);
        refuse(change, left, "parameter", own);
    }
    const std::string started = name_in_system(system, left, started_in(left));
    std::vector<std::string> names;
    std::vector<std::string> own;
    for (const std::string& unknown : started.empty() ? std::vector<std::string>() : system.unknowns()) {
        for (int order = 0; order < system.order_of(unknown); ++order) {
            names.push_back(ode::primed(unknown, order));
            own.push_back(names.back() + left.substr(std::min(left.find('('), left.size())));
        }
    }
    if (!started.empty() && std::ranges::find(names, started) == names.end()) {
        refuse(change, left, "initial value", own);
    }
}

}  // namespace libration
