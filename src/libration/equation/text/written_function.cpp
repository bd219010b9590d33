#include "written_function.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "libration/equation/defined_zero.hpp"
#include "libration/function/function_kind.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

using arguments = std::vector<expression>;

constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

expression half() { return expression(rational(1, 2)); }
expression quarter() { return expression(rational(1, 4)); }
expression pi_times(const rational& factor) { return expression(number(factor, unit::pi)); }
expression reciprocal(const expression& x) { return written_quotient(1, x); }
expression less(const expression& a, const expression& b) { return written_sum(a, -b); }

// f(x), 1/f(x) and f(1/x).
template <function_kind f>
expression reciprocal_of(const arguments& x, step_collector*) {
    return reciprocal(apply(f, x[0]));
}
template <function_kind f>
expression of_reciprocal(const arguments& x, step_collector*) {
    return apply(f, reciprocal(x[0]));
}
template <function_kind above, function_kind below>
expression quotient_of(const arguments& x, step_collector*) {
    return written_quotient(apply(above, x[0]), apply(below, x[0]));
}

expression absolute(const expression& x, step_collector& steps) { return steps.if_positive(x, x, -x); }

expression larger(const expression& a, const expression& b, step_collector& steps) {
    return steps.if_positive(less(a, b), a, b);
}
expression smaller(const expression& a, const expression& b, step_collector& steps) {
    return steps.if_positive(less(a, b), b, a);
}

template <expression (*chosen)(const expression&, const expression&, step_collector&)>
expression of_all(const arguments& x, step_collector* steps) {
    expression found = x[0];
    for (std::size_t i = 1; i < x.size(); ++i) {
        found = chosen(found, x[i], *steps);
    }
    return found;
}

// [x > 0] + h [x = 0] with h = 1/2 unless it is given.
expression step_at_zero(const arguments& x, step_collector* steps) {
    return x.size() == 1 ? half() * (1 + steps->sign(x[0]))
                         : steps->if_positive(x[0], 1, steps->if_not_negative(x[0], x[1], 0));
}

expression ceiling(const expression& x, step_collector& steps) { return -steps.floor(-x); }
expression truncated(const expression& x, step_collector& steps) {
    return steps.if_positive(x, steps.floor(x), ceiling(x, steps));
}

// To the nearest integer, halves away from 0.
expression rounded(const expression& x, step_collector& steps) {
    return steps.if_positive(x, steps.floor(written_sum(x, half())), ceiling(less(x, half()), steps));
}

// To the nearest integer n, halves to the even one: floor(x/2 + 1/4) + ceil(x/2 - 1/4), in which both are n/2 for even n,
// and (n - 1)/2 and (n + 1)/2 for odd n.
expression rounded_to_even(const expression& x, step_collector& steps) {
    return written_sum(steps.floor(written_sum(half() * x, quarter())), ceiling(less(half() * x, quarter()), steps));
}

// x - y n with the integer n of x/y.
template <expression (*integer_of)(const expression&, step_collector&)>
expression remainder_by(const arguments& x, step_collector* steps) {
    return less(x[0], written_product(x[1], integer_of(written_quotient(x[0], x[1]), *steps)));
}

// x - y floor(x/y). Its times are exact for y a multiple of pi.
expression modulo(const arguments& x, step_collector* steps) {
    const bool positive = x[1].kind() == node_kind::constant && x[1].constant().sign() > 0;
    const expression n = positive ? steps->floor(x[0], x[1].constant()) : steps->floor(written_quotient(x[0], x[1]));
    return less(x[0], written_product(x[1], n));
}

// floor(x/(k pi)).
expression half_turns(const expression& x, int k, step_collector& steps) {
    return steps.floor(x, number(rational(k), unit::pi));
}

expression square_wave(const arguments& x, step_collector* steps) {
    return 1 - 2 * (half_turns(x[0], 1, *steps) - 2 * half_turns(x[0], 2, *steps));
}

expression sawtooth_wave(const arguments& x, step_collector* steps) {
    return x[0] / pi_times(1) - 1 - 2 * half_turns(x[0], 2, *steps);
}

expression norm(const expression& a, const expression& b) {
    return apply(function_kind::sqrt, written_sum(written_power(a, 2), written_power(b, 2)));
}

// The angle of the point (x, y), with r its distance from 0: 2 atan(y/(r + x)) for x > 0, pi or -pi less 2 atan(y/(r - x))
// for x <= 0; by the arctangent of one quotient if an argument is a nonzero number.
expression angle(const arguments& of, step_collector* steps) {
    const expression &y = of[0], x = of[1];
    const auto is_number = [](const expression& e) { return e.kind() == node_kind::constant; };
    if (is_number(x) && x.constant().sign() > 0) {
        return apply(function_kind::atan, written_quotient(y, x));
    }
    if (is_number(y) && y.constant().sign() != 0) {
        return less(pi_times(rational(y.constant().sign(), 2)), apply(function_kind::atan, written_quotient(x, y)));
    }
    if (is_number(x) && is_number(y) && x.constant().sign() == 0) {
        throw error(error_kind::argument, error_subject::number, "", "takes atan2 of 0 and 0, which has no value");
    }
    const expression half_turn = steps->if_not_negative(y, pi_times(1), pi_times(-1));
    if (is_number(x) && x.constant().sign() < 0) {
        return written_sum(half_turn, apply(function_kind::atan, written_quotient(y, x)));
    }
    const expression r = norm(x, y);
    const auto twice_atan = [&](const expression& denominator) {
        return 2 * apply(function_kind::atan, written_quotient(y, denominator));
    };
    const expression left = less(half_turn, twice_atan(less(r, x)));
    return is_number(x) ? left : steps->if_positive(x, twice_atan(written_sum(r, x)), left);
}

// The factor that is a number, 1 if there is none, and the other one.
std::pair<expression, expression> factored(const expression& e) {
    const bool product = e.kind() == node_kind::product && e.left().kind() == node_kind::constant;
    return product ? std::pair(e.left(), e.right()) : std::pair(expression(1), e);
}

// sqrt(x^2 + y^2 + ...), and sqrt(a^2 + b^2 + ...)*abs(u) for multiples a*u, b*u of one expression, which may become 0.
expression hypotenuse(const arguments& all, step_collector* steps) {
    arguments x = all;
    std::erase_if(x, [](const expression& each) { return same_form(each, expression(0)); });
    if (x.empty()) {
        return 0;
    }
    const expression common = factored(x[0]).second;
    const bool multiples =
        std::ranges::all_of(x, [&](const expression& each) { return same_form(factored(each).second, common); });
    expression sum;
    for (const expression& each : x) {
        sum = written_sum(sum, written_power(multiples ? factored(each).first : each, 2));
    }
    const expression root = apply(function_kind::sqrt, sum);
    return !multiples         ? root
           : steps != nullptr ? written_product(root, absolute(common, *steps))
                              : written_product(root, apply(function_kind::sqrt, written_power(common, 2)));
}

expression logistic(const arguments& x, step_collector*) {
    return reciprocal(written_sum(apply(function_kind::exp, -x[0]), 1));
}

template <expression (*f)(const expression&, step_collector&)>
expression stepped(const arguments& x, step_collector* steps) {
    return f(x[0], *steps);
}

constexpr std::array functions{
    written_function{"cot", 1, 1, "cot(x)", false, quotient_of<function_kind::cos, function_kind::sin>},
    written_function{"sec", 1, 1, "sec(x)", false, reciprocal_of<function_kind::cos>},
    written_function{"csc", 1, 1, "csc(x)", false, reciprocal_of<function_kind::sin>},
    written_function{"acot", 1, 1, "acot(x)", false, of_reciprocal<function_kind::atan>},
    written_function{"asec", 1, 1, "asec(x)", false, of_reciprocal<function_kind::acos>},
    written_function{"acsc", 1, 1, "acsc(x)", false, of_reciprocal<function_kind::asin>},
    written_function{"coth", 1, 1, "coth(x)", false, quotient_of<function_kind::cosh, function_kind::sinh>},
    written_function{"sech", 1, 1, "sech(x)", false, reciprocal_of<function_kind::cosh>},
    written_function{"csch", 1, 1, "csch(x)", false, reciprocal_of<function_kind::sinh>},
    written_function{"acoth", 1, 1, "acoth(x)", false, of_reciprocal<function_kind::atanh>},
    written_function{"asech", 1, 1, "asech(x)", false, of_reciprocal<function_kind::acosh>},
    written_function{"acsch", 1, 1, "acsch(x)", false, of_reciprocal<function_kind::asinh>},
    written_function{"atan2", 2, 2, "atan2(y, x)", true, angle},
    written_function{"hypot", 1, any_number, "hypot(x, y)", false, hypotenuse},
    written_function{"pow", 2, 2, "pow(x, y)", false,
                     [](const arguments& x, step_collector*) { return written_power(x[0], x[1]); }},
    written_function{"logistic", 1, 1, "logistic(x)", false, logistic},
    written_function{"softplus", 1, 1, "softplus(x)", false,
                     [](const arguments& x, step_collector*) {
                         return apply(function_kind::log1p, apply(function_kind::exp, x[0]));
                     }},
    written_function{"relu", 1, 1, "relu(x)", true,
                     [](const arguments& x, step_collector* steps) { return larger(x[0], 0, *steps); }},
    written_function{"abs", 1, 1, "abs(x)", true, stepped<absolute>},
    written_function{"sign", 1, 1, "sign(x)", true,
                     [](const arguments& x, step_collector* steps) { return steps->sign(x[0]); }},
    written_function{"max", 2, any_number, "max(a, b)", true, of_all<larger>},
    written_function{"min", 2, any_number, "min(a, b)", true, of_all<smaller>},
    written_function{
        "clip", 3, 3, "clip(x, a, b)", true,
        [](const arguments& x, step_collector* steps) { return smaller(larger(x[0], x[1], *steps), x[2], *steps); }},
    written_function{"heaviside", 1, 2, "heaviside(x)", true, step_at_zero},
    written_function{"floor", 1, 1, "floor(t)", true,
                     [](const arguments& x, step_collector* steps) { return steps->floor(x[0]); }},
    written_function{"ceil", 1, 1, "ceil(t)", true, stepped<ceiling>},
    written_function{"trunc", 1, 1, "trunc(t)", true, stepped<truncated>},
    written_function{"round", 1, 1, "round(t)", true, stepped<rounded>},
    written_function{"rint", 1, 1, "rint(t)", true, stepped<rounded_to_even>},
    written_function{"mod", 2, 2, "mod(x, y)", true, modulo},
    written_function{"fmod", 2, 2, "fmod(x, y)", true, remainder_by<truncated>},
    written_function{"remainder", 2, 2, "remainder(x, y)", true, remainder_by<rounded_to_even>},
    written_function{"square", 1, 1, "square(t)", true, square_wave},
    written_function{"sawtooth", 1, 1, "sawtooth(t)", true, sawtooth_wave}};

constexpr std::array<std::pair<std::string_view, std::string_view>, 52> synonyms{{{"ln", "log"},
                                                                                  {"tg", "tan"},
                                                                                  {"ctg", "cot"},
                                                                                  {"cotan", "cot"},
                                                                                  {"cosec", "csc"},
                                                                                  {"sh", "sinh"},
                                                                                  {"ch", "cosh"},
                                                                                  {"th", "tanh"},
                                                                                  {"arcsin", "asin"},
                                                                                  {"arccos", "acos"},
                                                                                  {"arctan", "atan"},
                                                                                  {"arctg", "atan"},
                                                                                  {"arccot", "acot"},
                                                                                  {"arcsec", "asec"},
                                                                                  {"arccsc", "acsc"},
                                                                                  {"arcsinh", "asinh"},
                                                                                  {"arccosh", "acosh"},
                                                                                  {"arctanh", "atanh"},
                                                                                  {"arccoth", "acoth"},
                                                                                  {"arcsech", "asech"},
                                                                                  {"arccsch", "acsch"},
                                                                                  {"arsinh", "asinh"},
                                                                                  {"arcosh", "acosh"},
                                                                                  {"artanh", "atanh"},
                                                                                  {"arcoth", "acoth"},
                                                                                  {"arsech", "asech"},
                                                                                  {"arcsch", "acsch"},
                                                                                  {"arctan2", "atan2"},
                                                                                  {"fabs", "abs"},
                                                                                  {"Abs", "abs"},
                                                                                  {"sgn", "sign"},
                                                                                  {"signum", "sign"},
                                                                                  {"Max", "max"},
                                                                                  {"fmax", "max"},
                                                                                  {"Min", "min"},
                                                                                  {"fmin", "min"},
                                                                                  {"clamp", "clip"},
                                                                                  {"step", "heaviside"},
                                                                                  {"Heaviside", "heaviside"},
                                                                                  {"ceiling", "ceil"},
                                                                                  {"fix", "trunc"},
                                                                                  {"nint", "round"},
                                                                                  {"Mod", "mod"},
                                                                                  {"rem", "fmod"},
                                                                                  {"expit", "logistic"},
                                                                                  {"sigmoid", "logistic"},
                                                                                  {"power", "pow"},
                                                                                  {"ifelse", "if"},
                                                                                  {"where", "if"},
                                                                                  {"Piecewise", "piecewise"},
                                                                                  {"nearbyint", "rint"},
                                                                                  {"lambertW", "lambertw"}}};

}  // namespace

const written_function* written_function_named(std::string_view name) {
    const auto* const found = std::ranges::find(functions, name_without_synonym(name), &written_function::name);
    return found == functions.end() ? nullptr : found;
}

std::string written_function_names() {
    std::string all;
    for (const written_function& each : functions) {
        all += (all.empty() ? "" : " ") + std::string(each.name);
    }
    return all;
}

std::string_view name_without_synonym(std::string_view name) {
    const auto* const found = std::ranges::find(synonyms, name, &std::pair<std::string_view, std::string_view>::first);
    return found == synonyms.end() ? name : found->second;
}

bool is_called_function(std::string_view name) {
    const std::string_view known = name_without_synonym(name);
    return function_named(known) || written_function_named(known) != nullptr || known == "if" || known == "piecewise";
}

}  // namespace libration::ode
