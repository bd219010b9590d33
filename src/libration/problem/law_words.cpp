#include "law_words.hpp"

#include <algorithm>
#include <vector>

#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/magnitude.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration {

namespace {

constexpr long usual_first = 60;

using ode::complex_ball;

// Leading behaviour of the shown function: coefficient (t - t*)^exponent, times a logarithm, or in powers of 1 - (t - t0)/(t* - t0).
struct leading_term {
    std::string kind;
    std::string exponent;
    complex_ball coefficient;
    bool known = true;
};

bool is_exact_zero(const complex_ball& z) {
    return is_exact(z.re) && contains_zero(z.re) && is_exact(z.im) && contains_zero(z.im);
}
bool excludes_zero_of(const complex_ball& z) { return !contains_zero(z.re) || !contains_zero(z.im); }

std::string pole_words(int order) { return order == 1 ? "simple pole" : "pole of order " + std::to_string(order); }

leading_term leading_of_pole(const ode::pole_terms& of, int shift) {
    int order = static_cast<int>(of.principal.size());
    complex_ball c = of.principal.back();
    if (shift == -1) {
        if (order == 1) {
            return {"logarithm", "0", c, excludes_zero_of(c)};
        }
        if (!is_exact_zero(of.principal.front())) {
            return {"pole of order " + std::to_string(order - 1) + ", with a logarithm or without",
                    std::to_string(1 - order), c / (1 - order), excludes_zero_of(c)};
        }
        return {pole_words(order - 1), std::to_string(1 - order), c / (1 - order), excludes_zero_of(c)};
    }
    for (int k = 0; k < shift; ++k, ++order) {
        c = c * -order;
    }
    return {pole_words(order), std::to_string(-order), c, excludes_zero_of(c)};
}

leading_term leading_of_algebraic_point(const ode::algebraic_point& of, int shift) {
    const int q = of.sheets;
    for (int j = -of.pole; j <= of.last(); ++j) {
        if (j % q == 0 || is_exact_zero(of.coefficient(j))) {
            continue;
        }
        complex_ball c = of.coefficient(j);
        for (int k = 0; k < shift; ++k) {  // (x^j)' by t
            c = c * ball(j - k * q) / ball(q) / (-of.place);
        }
        const std::string exponent = rational(j - shift * q, q).str();
        if (!excludes_zero_of(c)) {
            return {"at most a branch point of " + std::to_string(q) + " sheets", exponent, c, false};
        }
        return {"branch point of " + std::to_string(q) + " sheets", exponent, c};
    }
    return {"at most a branch point of " + std::to_string(q) + " sheets", "", complex_ball(0), false};
}

// As many digits as are proved, else the bound alone.
answer_value decimal_of(const ball& x, long digits) {
    const long proved = is_finite(x) ? proved_digits(x, digits) : 0;
    if (const auto decimal = proved > 0 ? to_proved_decimal(x, proved) : std::nullopt) {
        return {decimal->text, decimal->uncertainty};
    }
    return {"", is_finite(x) ? upper_bound_text(x) : ""};
}

std::string words_of_exponent(const ode::fixed_point_terms::singular_term& of, int shift, int sign, long digits) {
    if (of.exact) {
        return rational(*of.exact - shift).str();
    }
    const std::string re = decimal_of(ball(of.exponent.re - shift), digits).text;
    return contains_zero(of.exponent.im) ? re
                                         : re + " + (" + decimal_of(ball(of.exponent.im * sign), digits).text + ")i";
}

// The leading term, differentiated `shift` times; of two conjugate exponents that with Im > 0. `alone`: whether the point is a pole at
// most.
leading_term leading_of_terms(const std::vector<ode::fixed_point_terms::singular_term>& all, const complex_ball& place,
                              bool real, bool alone, int shift, int sign, long digits) {
    const auto& next = all[std::min<std::size_t>(1, all.size() - 1)];
    ode::fixed_point_terms::singular_term term = real && certainly_less(all[0].exponent.im, ball(0)) ? next : all[0];
    for (int i = 0; i < shift; ++i) {
        const bool is_natural = term.exact && *term.exact == i && term.power > 0;
        if (is_natural) {
            --term.power;
        } else {
            term.coefficient = term.coefficient * complex_ball{term.exponent.re - i, term.exponent.im};
        }
        term.coefficient = term.coefficient / (-place);
    }
    const std::string exponent = words_of_exponent(term, shift, sign, digits);
    for (int k = 2; k <= term.power; ++k) {
        term.coefficient = term.coefficient / k;
    }
    std::string kind;
    if (term.power > 0) {
        kind = term.power == 1 ? "logarithm" : "logarithm to the power " + std::to_string(term.power);
    } else if (term.exact && denominator(*term.exact) == 1) {
        const int order = static_cast<int>(numerator(rational(shift - *term.exact)));
        kind = pole_words(order) + (alone ? "" : ", with other singular terms or without");
        for (int k = 0; k < order; ++k) {  // of (t - t*)^-order
            term.coefficient = term.coefficient * (-place);
        }
    } else {
        kind = contains_zero(term.exponent.im) ? "branch point" : "branch point of a complex exponent";
    }
    const bool known = excludes_zero_of(term.coefficient);
    return {(known ? "" : "at most a ") + kind, exponent, term.coefficient, known};
}

// At a regular singular point of a linear equation.
leading_term leading_of_fixed_point(const ode::fixed_point_terms& of, int shift, int sign, long digits) {
    const auto all = of.leading();
    if (all.empty()) {
        return {"at most a singular point of the equation", "", complex_ball(0), false};
    }
    const bool alone = std::ranges::all_of(of.parts(), &ode::local_part::has_single_values);
    return leading_of_terms(all, of.place(), of.is_real(), alone, shift, sign, digits);
}

// At a movable singularity of a system: the leading term and, after a pole, the first term with more than one value.
leading_term leading_of_movable_point(const ode::movable_terms& of, int shift, int sign, long digits) {
    const auto all = of.leading();
    const ode::movable_point& point = of.of();
    if (all.empty()) {
        return {"at most a singularity of other unknowns", "", complex_ball(0), false};
    }
    leading_term result = leading_of_terms(all, point.place, point.real, point.single_valued, shift, sign, digits);
    const auto whole = [](const ode::fixed_point_terms::singular_term& each) {
        return each.power == 0 && each.exact && denominator(*each.exact) == 1;
    };
    if (point.single_valued || all.empty() || !whole(all.front())) {
        return result;
    }
    const auto next = std::ranges::find_if(all, [&](const auto& each) { return !whole(each); });
    const std::string pole = pole_words(static_cast<int>(numerator(rational(shift - *all.front().exact))));
    if (next == all.end() || !excludes_zero_of(next->coefficient)) {
        return result;
    }
    const auto& upper =
        point.real && next + 1 != all.end() && certainly_less(next->exponent.im, ball(0)) ? next[1] : *next;
    result.kind = pole + (next->power > 0 ? " with logarithms, from x^" : " with branches, from x^") +
                  words_of_exponent(upper, shift, sign, std::min(digits, 12L)) + " on";
    return result;
}

// The number itself if it has few digits, else a decimal that is not above it.
std::string text_of_double(double x) {
    constexpr long digits_of_double = 17;
    std::string text = parts_of(mpfr(x), digits_of_double, MPFR_RNDD).text();
    if (text.find('.') != std::string::npos && text.find('e') == std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        text.erase(text.find_last_not_of('.') + 1);
    }
    return text;
}

int printed_terms(const ode::coefficient_law& law, int terms) {
    int printed = std::min(terms, law.last_term());
    while (printed > 1 && law.first(printed) > usual_first) {
        --printed;
    }
    return printed;
}

std::string words_of_shift(const ode::coefficient_law& law) {
    if (law.shift() == 0) {
        return "a_n = ";
    }
    if (law.shift() == -1) {
        return "a_n = b_(n-1)/n, b_n = ";
    }
    const std::string s = std::to_string(law.shift());
    return "a_n = (n + " + s + ")!/n! b_(n+" + s + "), b_n = ";
}

std::string main_words(const ode::coefficient_law& law, int terms) {
    if (!law.poles().empty()) {
        return law.poles().front().principal.size() == 1
                   ? "- sum over k of c_k t_k^(-n-1) + E_n"
                   : "sum over k, j of (-1)^j c_kj binomial(n + j - 1, j - 1) t_k^(-n-j) + E_n";
    }
    if (!law.branch_points().empty()) {
        const ode::algebraic_point& of = law.branch_points().front().of();
        const std::string q = std::to_string(of.sheets);
        return "sum over k of t_k^-n sum over " + std::to_string(-of.pole) + " <= j <= " + std::to_string(terms) +
               " of c_kj Gamma(n - j/" + q + ")/(Gamma(-j/" + q + ") n!) + E_n";
    }
    if (!law.movable_points().empty()) {
        return "sum over k, a with Re a <= " + std::to_string(terms) +
               ", m of t_k^-n c_kam d^m/da^m [Gamma(n - a)/(Gamma(-a) n!)] + E_n, where c_kam is the coefficient of "
               "x^a "
               "log(x)^m, x = 1 - (t - t0)/(t_k - t0)";
    }
    if (!law.fixed_points().empty()) {
        return "sum over k, e, j <= " + std::to_string(terms) +
               ", m of t_k^-n c_kejm/m! d^m/da^m [Gamma(n - a)/(Gamma(-a) n!)] + E_n, a = e + j, where c_kejm is the "
               "coefficient of x^a log(x)^m/m!, x = 1 - (t - t0)/(t_k - t0)";
    }
    return "E_n";
}

std::string error_words(const ode::coefficient_law& law, int terms, const std::string& rho) {
    ball circle = law.mean().exact();
    std::string slits;
    for (const ode::branch_terms& each : law.branch_points()) {
        const auto bound = each.uniform(terms);
        circle += bound.circle;
        const ball modulus =
            sqrt(ball(each.of().place.re * each.of().place.re + each.of().place.im * each.of().place.im));
        slits += " + " + upper_bound_text(bound.slit) + " * " +
                 parts_of(midpoint_of(lower_bound(modulus)), 12, MPFR_RNDD).text() + "^-n Gamma(n - " +
                 std::to_string(bound.index) + "/" + std::to_string(each.of().sheets) + ")/n!";
    }
    for (const ode::fixed_point_terms& each : law.fixed_points()) {
        const auto bound = each.uniform(terms);
        circle += bound.circle;
        if (!contains_zero(bound.slit)) {
            slits += " + " + upper_bound_text(bound.slit) + " * " +
                     parts_of(midpoint_of(lower_bound(ode::modulus_in_balls(each.place()))), 12, MPFR_RNDD).text() +
                     "^-n Gamma(n - " + bound.index.str() + ")/n!";
        }
    }
    for (const ode::movable_terms& each : law.movable_points()) {
        const auto bound = each.uniform(terms);
        circle += bound.circle;
        if (!contains_zero(bound.slit)) {
            slits += " + " + upper_bound_text(bound.slit) + " * " +
                     parts_of(midpoint_of(lower_bound(ode::modulus_in_balls(each.of().place))), 12, MPFR_RNDD).text() +
                     "^-n Gamma(n - " + bound.index.str() + ")/n!";
        }
    }
    return "|E_n| <= " + upper_bound_text(circle) + " * " + rho + "^-n" + slits;
}

}  // namespace

answer singularities_of_law(const ode::coefficient_law& law, const std::string& name, int terms, long digits) {
    const int printed = printed_terms(law, terms);
    const long first = law.first(printed);
    const std::string rho = text_of_double(law.rho());
    const std::string mean = upper_bound_text(law.mean().exact());
    answer result{.names = {"position_re", "position_im", "modulus", "kind", "exponent", "coefficient_re",
                            "coefficient_im", "rho", "mean", "first"},
                  .rows = {},
                  .rigour = "proved"};
    int doubtful = 0;  // singularities of the equation at which the solution may be regular
    const auto add = [&](const complex_ball& place, bool real, const auto& leading_at) {
        for (const int sign : real ? std::vector{1} : std::vector{1, -1}) {
            const leading_term of = leading_at(sign);
            doubtful += of.known ? 0 : 1;
            const ball modulus = real ? abs(place.re) : ball(sqrt(ball(place.re * place.re + place.im * place.im)));
            const auto im = [&](const complex_ball& z) { return decimal_of(ball(z.im * sign), digits); };
            result.rows.push_back({decimal_of(place.re, digits),
                                   im(place),
                                   decimal_of(modulus, digits),
                                   text_value(of.kind),
                                   text_value(of.exponent),
                                   decimal_of(of.coefficient.re, digits),
                                   im(of.coefficient),
                                   {rho, "0"},
                                   {mean, ""},
                                   whole_value(first)});
        }
    };
    for (const ode::pole_terms& each : law.poles()) {
        add(each.place, each.real, [&](int /*sign*/) { return leading_of_pole(each, law.shift()); });
    }
    for (const ode::branch_terms& each : law.branch_points()) {
        add(each.of().place, each.of().real,
            [&](int /*sign*/) { return leading_of_algebraic_point(each.of(), law.shift()); });
    }
    for (const ode::fixed_point_terms& each : law.fixed_points()) {
        add(each.place(), each.is_real(),
            [&](int sign) { return leading_of_fixed_point(each, law.shift(), sign, digits); });
    }
    for (const ode::movable_terms& each : law.movable_points()) {
        add(each.of().place, each.of().real,
            [&](int sign) { return leading_of_movable_point(each, law.shift(), sign, digits); });
    }
    const std::size_t count = result.rows.size();
    if (result.rows.empty()) {
        result.rows.push_back({{"", ""},
                               {"", ""},
                               {"", ""},
                               text_value("none"),
                               text_value(""),
                               {"", ""},
                               {"", ""},
                               {rho, "0"},
                               {mean, ""},
                               whole_value(first)});
    }
    const std::string reduced =
        law.shift() == 0 ? error_words(law, printed, rho) : error_words(law, printed, rho) + " for the error of b_n";
    const std::string stride = law.stride() > 1 ? "; a_n = 0 unless n = " + std::to_string(law.residue()) + " mod " +
                                                      std::to_string(law.stride())
                                                : "";
    const std::string all = doubtful == 0
                                ? "these are all singularities in |t - t0| <= " + rho + ": " + std::to_string(count)
                                : "all singularities in |t - t0| <= " + rho + " are among these " +
                                      std::to_string(count) + " places, at " + std::to_string(doubtful) +
                                      " of which it is not decided whether the solution is singular";
    result.notes = {
        {"law", "for all n >= " + std::to_string(first) + ": " + words_of_shift(law) + main_words(law, printed)},
        {"error", reduced},
        {"proved", "of " + name + ", continued along rays from the initial point, " + all + ", by " +
                       std::to_string(law.discs()) + " discs in " + std::to_string(law.charts()) +
                       (law.charts() == 1 ? " chart" : " charts") + "; the law holds for every n from " +
                       std::to_string(first) + " on" + stride}};
    return result;
}

}  // namespace libration
