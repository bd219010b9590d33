#include "law_radius.hpp"

#include <algorithm>
#include <vector>

#include "libration/asymptotics/coefficient_law.hpp"
#include "libration/digits/precision_loop.hpp"
#include "libration/problem/law_answer.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/outward_decimals.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/exponent_range.hpp"
#include "plane_work.hpp"

namespace libration {

namespace {

constexpr long digits_of_kinds = 12;
constexpr long guard_digits_of_radius = 20;

// Whether a term with more than one value or a pole is proved to be there.
bool is_proved_singularity(const ode::fixed_point_terms& at) {
    const auto all = at.leading();
    return std::ranges::any_of(all, [](const ode::fixed_point_terms::singular_term& each) {
        return !contains_zero(each.coefficient.re) || !contains_zero(each.coefficient.im);
    });
}

// "logarithm at 1.00000000000", and the point symmetric to it; empty for what is only "at most" of a kind.
std::string words_of_row(const std::vector<answer_value>& row) {
    const std::string& kind = row[3].text;
    if (kind.empty() || kind == "none" || kind.starts_with("at most")) {
        return "";
    }
    const std::string exponent = row[4].text == "0" || row[4].text.empty() ? "" : ", exponent " + row[4].text;
    const auto number = [](const answer_value& x) { return x.text.empty() ? "0" : x.text; };
    const std::string im = number(row[1]);
    const std::string place = im == "0" ? number(row[0]) : "(" + number(row[0]) + ") + (" + im + ")i";
    return kind + exponent + " at t - t0 = " + place;
}

}  // namespace

std::string kinds_by_law(const ode::explicit_system& system, const request& how) {
    if (system.unknowns().size() != 1) {
        return "";
    }
    request fewer = how;
    fewer.scalar.digits = digits_of_kinds;
    std::vector<std::vector<answer_value>> rows;
    const auto missing = undecided_in([&] { rows = law_of(system, {}, {}, fewer).singularities.rows; });
    if (missing || rows.empty() || rows.front()[3].text == "none") {
        return "";
    }
    // The moduli are decimals of one length: equal ones are those that are not proved to be different.
    const auto modulus = [](const std::vector<answer_value>& row) { return std::stod(row[2].text); };
    double least = 1e300;
    for (const auto& row : rows) {
        if (row[2].text.empty()) {
            return "";
        }
        least = std::min(least, modulus(row));
    }
    std::string words;
    for (const auto& row : rows) {
        if (modulus(row) <= least * (1 + 1e-10)) {
            const std::string one = words_of_row(row);
            if (one.empty()) {
                return "";
            }
            words += (words.empty() ? "" : "; ") + one;
        }
    }
    return words;
}

std::optional<answer> radius_by_linear_law(const ode::explicit_system& system, const request& how) {
    const auto equation = ode::linear_equation::of(system);
    if (!equation || equation->leading().degree() < 1) {
        return std::nullopt;
    }
    const whole_exponent_range exponents;
    const long digits = how.printed_digits();
    const precision_scope scope(digits + guard_digits_of_radius);
    plane_work work(how);
    ode::law_request asked;
    asked.watch = work.watch();
    std::optional<ball> lower, upper;
    const auto missing = undecided_in([&] {
        ode::coefficient_law law = ode::coefficient_law::of(system, asked);
        law.sharpen();
        for (const ode::fixed_point_terms& each : law.fixed_points()) {
            const ball modulus = ode::modulus_in_balls(each.place());
            const ball below = lower_bound(modulus);
            const ball above = upper_bound(modulus);
            lower = !lower || certainly_less(below, *lower) ? below : lower;
            if (is_proved_singularity(each) && (!upper || certainly_less(above, *upper))) {
                upper = above;
            }
        }
    });
    // All nearest ones have one modulus, of which both are bounds.
    if (missing || !lower || !upper || certainly_less(ball(*lower * (ball(1) + pow(ball(10), -digits))), *upper)) {
        return std::nullopt;
    }
    const auto [below, above] = outward_decimals(*lower, *upper, digits);
    const std::string kinds = kinds_by_law(system, how);
    return answer{
        .names = {"lower", "upper"},
        .rows = {{{below, ""}, {above, ""}}},
        .rigour = "proved",
        .notes = {{"lower", std::string(system.singular() ? "the solution has no singularity"
                                                          : "no solution of the equation has a singularity") +
                                " at a smaller distance, by the zeros of its leading coefficient and their exponents"},
                  {"upper", "the constant of a singular term at that distance is nonzero"},
                  {"nearest", kinds.empty() ? "of undecided kind" : kinds}}};
}

}  // namespace libration
