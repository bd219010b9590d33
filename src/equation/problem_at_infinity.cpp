#include "equation/problem_at_infinity.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <optional>
#include <vector>

#include "equation/problem_options.hpp"
#include "libration/digits/proved/proved_decimals.hpp"
#include "libration/ode/constant_value.hpp"
#include "libration/ode/explicit_system.hpp"
#include "libration/ode/parse.hpp"
#include "libration/ode/proved/blasius_infinity.hpp"
#include "libration/ode/proved/layers_at_infinity.hpp"
#include "libration/ode/proved/neutral_atom.hpp"
#include "libration/ode/proved/tritronquee.hpp"
#include "libration/problem/catalogue.hpp"
#include "text/cell.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

std::string without_blanks(const std::string& text) {
    std::string plain;
    std::ranges::copy_if(text, std::back_inserter(plain), [](char c) { return c != ' '; });
    return plain;
}

// f'(inf) = 1 in its parts, or nothing.
std::optional<std::string> value_at_infinity(const std::string& condition, const std::string& left) {
    const std::string plain = without_blanks(condition);
    return plain.starts_with(left + "=") ? std::optional(plain.substr(left.size() + 1)) : std::nullopt;
}

// Whether the problem is one of the catalogue, but for its parameters.
bool is_of_catalogue(const ode::equation_system& system, const char* name) {
    const auto known = ode::parse(problem_text(name));
    const auto same = [](const ode::equation& a, const ode::equation& b) {
        return same_form(a.left, b.left) && same_form(a.right, b.right);
    };
    const auto same_start = [](const ode::start& a, const ode::start& b) {
        return same_form(a.of, b.of) && same_form(a.point, b.point) && same_form(a.value, b.value);
    };
    return std::ranges::equal(system.equations, known.equations, same) &&
           std::ranges::equal(system.starts, known.starts, same_start);
}

ode::number number_at_infinity(const std::string& text) {
    return naming_option("--such-that", [&] { return ode::parse_constant(text).constant(); });
}

// Values of parameters, or of starts, for which this has a limit.
struct lemma_at_infinity {
    const char* problem;
    std::vector<std::string> unknowns;
    const char* of;
    /// The limits that it holds for, in words, and whether this is one.
    const char* limits;
    std::function<bool(const std::string&)> holds;
    std::function<std::vector<ball>(const ode::equation_system&, const std::string&)> values;
};

bool is_zero_at_infinity(const std::string& limit) { return number_at_infinity(limit).sign() == 0; }

// Without oscillations.
constexpr const char* tritronquee_limit = "-sqrt(-z/6)";

bool is_tritronquee_limit(const std::string& limit) { return limit == tritronquee_limit; }

const std::vector<lemma_at_infinity>& lemmas() {
    static const std::vector<lemma_at_infinity> all{
        {"blasius",
         {"k"},
         "f'(inf)",
         "above 0",
         [](const std::string& limit) { return number_at_infinity(limit).sign() > 0; },
         [](const ode::equation_system&, const std::string& limit) {
             return std::vector{ode::blasius_shear(ode::constant_value<ball>::of(number_at_infinity(limit)))};
         }},
        {"falkner_skan",
         {"s"},
         "f'(inf)",
         "1",
         [](const std::string& limit) { return (number_at_infinity(limit) - ode::number(1)).sign() == 0; },
         [](const ode::equation_system& system, const std::string&) {
             return std::vector{ode::falkner_skan_shear(system)};
         }},
        {"sakiadis",
         {"G"},
         "f'(inf)",
         "0",
         is_zero_at_infinity,
         [](const ode::equation_system& system, const std::string&) {
             return std::vector{ode::sakiadis_shear(system)};
         }},
        {"thomas_fermi",
         {"slope"},
         "y(inf)",
         "0",
         is_zero_at_infinity,
         [](const ode::equation_system&, const std::string&) { return std::vector{ode::thomas_fermi_slope()}; }},
        {"painleve_1",
         {"u(0)", "u'(0)"},
         "u(-inf)",
         tritronquee_limit,
         is_tritronquee_limit,
         [](const ode::equation_system&, const std::string&) {
             const auto start = ode::tritronquee_start();
             return std::vector{start.value, start.slope};
         }}};
    return all;
}

// Falkner and Skan's lemma is for accelerated flow.
void require_accelerated(const ode::equation_system& system) {
    const auto* const b = system.parameter_of("b");
    if (b != nullptr && ode::with_values(b->value, system).constant().sign() <= 0) {
        throw error(error_kind::undecided, "--problem", "falkner_skan",
                    "has a lemma for its condition at infinity for b > 0 alone");
    }
}

}  // namespace

bool is_at_infinity(const std::string& condition) {
    const std::string plain = without_blanks(condition);
    return plain.find("(inf)") != std::string::npos || plain.find("(-inf)") != std::string::npos;
}

std::vector<proved_decimal> proved_for_infinity(const ode::equation_system& system,
                                                const std::vector<std::string>& unknowns, const std::string& condition,
                                                long digits) {
    const auto lemma = std::ranges::find_if(lemmas(), [&](const lemma_at_infinity& each) {
        const bool about_all = std::ranges::all_of(unknowns, [&](const std::string& name) {
            return std::ranges::find(each.unknowns, name) != each.unknowns.end();
        });
        return about_all && is_of_catalogue(system, each.problem);
    });
    const auto value = lemma == lemmas().end() ? std::nullopt : value_at_infinity(condition, lemma->of);
    if (!value) {
        throw error(error_kind::undecided, "--such-that", condition,
                    "is a condition at infinity, and this problem brings no lemma for that; those of the catalogue "
                    "that do are blasius for k, falkner_skan for s and sakiadis for G, with f'(inf), thomas_fermi "
                    "for slope, with y(inf), and painleve_1 for u(0) and u'(0), with u(-inf)");
    }
    if (!lemma->holds(*value)) {
        throw input_error("--such-that", condition,
                          std::string("is no condition that ") + lemma->problem + " has a lemma for",
                          std::string("give the value ") + lemma->limits);
    }
    if (lemma->problem == std::string("falkner_skan")) {
        require_accelerated(system);
    }
    const auto all = proved_decimals(digits, [&] { return lemma->values(system, *value); });
    std::vector<proved_decimal> asked;
    for (const std::string& name : unknowns) {
        asked.push_back(
            all[static_cast<std::size_t>(std::ranges::find(lemma->unknowns, name) - lemma->unknowns.begin())]);
    }
    return asked;
}

table state_at_infinity(const ode::equation_system& system, long digits) {
    if (!is_of_catalogue(system, "sir")) {
        throw error(error_kind::undecided, "--time", "inf",
                    "is not reached by steps, and this problem brings no lemma for it; sir of the catalogue does");
    }
    const ode::explicit_system solved(system);
    const auto value_of = [&](const char* name) {
        return ode::with_values(system.parameter_of(name)->value, system).constant();
    };
    const auto left = proved_value(digits, [&] {
        return ode::epidemic_remainder(ode::constant_value<ball>::of(solved.starts()[0][0]),
                                       ode::constant_value<ball>::of(solved.starts()[1][0]),
                                       ode::constant_value<ball>::of(value_of("a") / value_of("r")));
    });
    table data({{"time", ""}, {"S", ""}, {"I", ""}, {"digits", ""}, {"rigour", ""}, {"time_typed", ""}});
    data.add_row({cell::number("inf", digits), cell::number(left.text, digits), cell::number("0", digits), digits,
                  "proved", "inf"});
    return data;
}

}  // namespace libration
