// am, the twelve functions of Jacobi and their inverses at any real parameter.
#include <stdexcept>

#include "libration/elliptic/on_real_line.hpp"
#include "libration/elliptic/proved_functions.hpp"
#include "named_values.hpp"

namespace libration::elliptic {

namespace {

using range = real_parameter::range;

ball of_letter(char letter, const jacobi_values<ball>& at) {
    switch (letter) {
        case 's': return at.sn;
        case 'c': return at.cn;
        case 'd': return at.dn;
        default: return ball(1);
    }
}

// sqrt of a nonnegative number, R_F of three such numbers. Everything derived from x and m is exact up to here.
struct symmetric_form {
    exact factor_squared;
    exact a, b, c;
};

ball symmetric_integral(const symmetric_form& form) {
    on_real_line a(from_exact<ball>(form.a));
    on_real_line b(from_exact<ball>(form.b));
    on_real_line c(from_exact<ball>(form.c));
    acb_elliptic_rf(a.handle(), a.handle(), b.handle(), c.handle(), 0, ball::working_bits());
    return a.real() * sqrt(from_exact<ball>(form.factor_squared));
}

// arcpq as factor R_F(a, b, c), for x >= 0 [DLMF 22.15, 19.25.31]: with s = sn, the factor is s times the root of a
// common multiple of cn^2, dn^2 and 1.
symmetric_form form_of(std::string_view function, const exact& x, const real_parameter& p) {
    const exact one = exactly(1);
    const exact& m = p.m();
    const exact& m1 = p.complement();
    const exact square = x * x;
    if (function == "sn") {
        return {square, one - square, one - m * square, one};
    }
    if (function == "sc") {
        return {square, one, one + m1 * square, one + square};
    }
    if (function == "sd") {
        return {square, one - m1 * square, one, one + m * square};
    }
    if (function == "cn") {
        return {one - square, square, m1 + m * square, one};
    }
    if (function == "dn") {
        return {(one - square) / m, (square - m1) / m, square, one};
    }
    if (function == "cd") {  // for m > 1 the value is above 1, and all of these change sign
        const exact sign = exactly(p.where() == range::above ? -1 : 1);
        return {sign * (one - square), sign * m1 * square, sign * m1, sign * (one - m * square)};
    }
    throw std::logic_error("no form of an inverse function");
}

// The value for x >= 0; infinite if R_F has two zeros.
true_value inverse_of_positive(std::string_view function, const exact& x, const real_parameter& p) {
    if ((function == "dn" && p.where() == range::zero) || (function == "cd" && p.where() == range::one)) {
        throw error(error_kind::argument, error_subject::parameter, p.m().text,
                    "makes " + std::string(function) + " constant");
    }
    const symmetric_form form = form_of(function, x, p);
    int zeros = 0;
    for (const exact* each : {&form.factor_squared, &form.a, &form.b, &form.c}) {
        const int sign = sign_of_exact(*each);
        if (sign < 0) {
            throw error(error_kind::argument, {error_subject::argument, "x"}, x.text,
                        "is not a value of " + std::string(function) + " between 0 and K");
        }
        zeros += sign == 0 && each != &form.factor_squared ? 1 : 0;
    }
    if (sign_of_exact(form.factor_squared) == 0) {
        return exact_value(0);
    }
    return zeros > 1 ? infinite_value(1) : true_value{symmetric_integral(form)};
}

}  // namespace

jacobi_values<ball> triple_at(const exact& u, const real_parameter& p) {
    const range where = p.where();
    if (u.is_zero() || where == range::zero || where == range::one) {
        const auto value = [&](jacobi_function f) {
            return u.is_zero() ? ball(f == jacobi_function::sn ? 0 : 1) : jacobi_value(f, u, p.within());
        };
        return {value(jacobi_function::sn), value(jacobi_function::cn), value(jacobi_function::dn)};
    }
    const ball stretch = p.stretch();
    auto at = jacobi(ball(from_exact<ball>(u) * stretch), p.reduced());
    switch (where) {
        case range::negative: return {at.sn / at.dn / stretch, at.cn / at.dn, 1 / at.dn};
        case range::above: return {at.sn / stretch, at.dn, at.cn};
        case range::zero:
        case range::within:
        case range::one: break;
    }
    return at;
}

char letter_at(char letter, range where) {
    return letter != 'd' ? letter : where == range::zero ? 'n' : where == range::one ? 'c' : 'd';
}

true_value amplitude_value(std::string_view /*name*/, const function_arguments& at) {
    const exact& u = *at.argument;
    const real_parameter& p = at.parameter;
    if (u.is_zero() || (p.where() == range::zero && u.is_fraction())) {
        return exact_value(u.coefficient);
    }
    if (p.where() != range::negative && p.where() != range::above) {
        return {jacobi_value(jacobi_function::am, u, p.within()), std::nullopt, pi<ball>() / 2};
    }
    const modulus<ball> reduced = p.reduced();
    const ball v = from_exact<ball>(u) * p.stretch();
    if (p.where() == range::above) {  // |am| is at most asin(1/sqrt m)
        return {asin(ball(jacobi(v, reduced).sn / p.stretch())), std::nullopt, pi<ball>() / 2};
    }
    return {pi<ball>() / 2 - amplitude(ball(complete_integral(reduced) - v), reduced), std::nullopt, pi<ball>() / 2};
}

true_value quotient_value(std::string_view name, const function_arguments& at) {
    const range where = at.parameter.where();
    const char above = letter_at(name[0], where);
    const char below = letter_at(name[1], where);
    if (above == below) {
        return exact_value(1);
    }
    const auto triple = triple_at(*at.argument, at.parameter);
    const ball numerator = of_letter(above, triple);
    const ball denominator = of_letter(below, triple);
    if (is_exact_zero(denominator)) {
        return infinite_value(1);
    }
    if (is_exact_zero(numerator)) {
        return exact_value(0);
    }
    return {below == 'n' ? numerator : numerator / denominator};
}

true_value inverse_value(std::string_view name, const function_arguments& at) {
    std::string function(name.substr(3));
    exact x = *at.argument;
    const int sign = sign_of_exact(x);
    const bool reciprocal = function[0] == 'n' || function == "dc" || function == "ds" || function == "cs";
    if (reciprocal) {
        if (sign == 0) {
            throw error(error_kind::argument, {error_subject::argument, "x"}, x.text, "is not a value of " + function);
        }
        x = exactly(1) / x;
        std::swap(function[0], function[1]);
    }
    const bool odd = function[0] == 's';
    if (sign >= 0) {
        return inverse_of_positive(function, x, at.parameter);
    }
    if (function == "dn") {
        throw error(error_kind::argument, {error_subject::argument, "x"}, at.argument->text,
                    "is not a value of " + function);
    }
    const true_value mirrored = inverse_of_positive(function, exactly(0) - x, at.parameter);
    if (mirrored.infinite != 0) {
        return infinite_value(odd ? -1 : 1);
    }
    if (odd) {
        return {-mirrored.value()};
    }
    if (at.parameter.where() == range::one || at.parameter.where() == range::above) {
        throw error(error_kind::argument, {error_subject::argument, "x"}, at.argument->text,
                    "is not a value of " + function);
    }
    return {complete_value(at.parameter) * 2 - mirrored.value()};
}

}  // namespace libration::elliptic
