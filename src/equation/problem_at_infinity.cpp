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
#include "libration/problem/catalogue.hpp"
#include "text/cell.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

// f'(inf) = 1 in its parts, or nothing.
std::optional<std::string> value_at_infinity(const std::string& condition, const std::string& left) {
    std::string plain;
    std::ranges::copy_if(condition, std::back_inserter(plain), [](char c) { return c != ' '; });
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

// A value of a parameter for which this has a limit.
struct lemma_at_infinity {
    const char* problem;
    const char* unknown;
    const char* of;
    /// The limits that it holds for, in words, and whether this is one.
    const char* limits;
    std::function<bool(const ode::number&)> holds;
    std::function<ball(const ode::equation_system&, const ode::number&)> value;
};

const std::vector<lemma_at_infinity>& lemmas() {
    static const std::vector<lemma_at_infinity> all{
        {"blasius", "k", "f'(inf)", "above 0", [](const ode::number& limit) { return limit.sign() > 0; },
         [](const ode::equation_system&, const ode::number& limit) {
             return ode::blasius_shear(ode::constant_value<ball>::of(limit));
         }},
        {"falkner_skan", "s", "f'(inf)", "1",
         [](const ode::number& limit) { return (limit - ode::number(1)).sign() == 0; },
         [](const ode::equation_system& system, const ode::number&) { return ode::falkner_skan_shear(system); }},
        {"sakiadis", "G", "f'(inf)", "0", [](const ode::number& limit) { return limit.sign() == 0; },
         [](const ode::equation_system& system, const ode::number&) { return ode::sakiadis_shear(system); }},
        {"thomas_fermi", "slope", "y(inf)", "0", [](const ode::number& limit) { return limit.sign() == 0; },
         [](const ode::equation_system&, const ode::number&) { return ode::thomas_fermi_slope(); }}};
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
    std::string plain;
    std::ranges::copy_if(condition, std::back_inserter(plain), [](char c) { return c != ' '; });
    return plain.find("(inf)") != std::string::npos;
}

proved_decimal proved_for_infinity(const ode::equation_system& system, const std::string& unknown,
                                   const std::string& condition, long digits) {
    const auto lemma = std::ranges::find_if(
        lemmas(), [&](const lemma_at_infinity& each) { return is_of_catalogue(system, each.problem); });
    const auto value = lemma == lemmas().end() ? std::nullopt : value_at_infinity(condition, lemma->of);
    if (lemma == lemmas().end() || unknown != lemma->unknown || !value) {
        throw error(error_kind::undecided, "--such-that", condition,
                    "is a condition at infinity, and this problem brings no lemma for that; those of the catalogue "
                    "that do are blasius for k, falkner_skan for s and sakiadis for G, with f'(inf), and thomas_fermi "
                    "for slope, with y(inf)");
    }
    const auto wanted = naming_option("--such-that", [&] { return ode::parse_constant(*value).constant(); });
    if (!lemma->holds(wanted)) {
        throw input_error("--such-that", condition,
                          std::string("is no condition that ") + lemma->problem + " has a lemma for",
                          std::string("give the value ") + lemma->limits);
    }
    if (lemma->problem == std::string("falkner_skan")) {
        require_accelerated(system);
    }
    return proved_value(digits, [&] { return lemma->value(system, wanted); });
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
