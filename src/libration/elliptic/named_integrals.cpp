// The elliptic integrals of the three kinds, Jacobi's zeta function and the nome at any real parameter, by Arb.
#include <stdexcept>

#include "libration/elliptic/on_real_line.hpp"
#include "libration/elliptic/proved_functions.hpp"
#include "named_values.hpp"

namespace libration::elliptic {

namespace {

using range = real_parameter::range;

// An amplitude: phi, or phi/pi if that is exact.
struct amplitude_input {
    on_real_line value;
    int times_pi;

    explicit amplitude_input(const exact& phi)
        : value(phi.is_angle() ? from_rational<ball>(phi.in_pi()) : from_exact<ball>(phi)),
          times_pi(phi.is_angle() ? 1 : 0) {}
};

// Whether |phi| is pi/2 or more.
bool reaches_quarter(const exact& phi) {
    if (phi.is_angle()) {
        return abs(phi.in_pi()) * 2 >= 1;
    }
    return decided_sign(ball(abs(from_exact<ball>(phi)) - pi<ball>() / 2)) >= 0;
}

// The sign of the minimum of 1 - c sin^2 on [0, phi], c being m or n.
int sign_of_least(const exact& c, const exact& phi) {
    const int of_whole = sign_of_exact(exactly(1) - c);
    if (of_whole > 0 || reaches_quarter(phi)) {
        return of_whole;
    }
    if (of_whole == 0) {
        return 1;
    }
    const ball sine = sin(from_exact<ball>(phi));
    return decided_sign(ball(1 - from_exact<ball>(c) * sine * sine));
}

// F, E or Pi from 0 to phi.
ball incomplete_by_arb(std::string_view name, const exact& phi, const function_arguments& at) {
    amplitude_input amplitude(phi);
    on_real_line m(from_exact<ball>(at.parameter.m()));
    on_real_line result;
    if (name == "F") {
        acb_elliptic_f(result.handle(), amplitude.value.handle(), m.handle(), amplitude.times_pi, ball::working_bits());
    } else if (name == "E") {
        acb_elliptic_e_inc(result.handle(), amplitude.value.handle(), m.handle(), amplitude.times_pi,
                           ball::working_bits());
    } else {
        on_real_line n(from_exact<ball>(*at.characteristic));
        acb_elliptic_pi_inc(result.handle(), n.handle(), amplitude.value.handle(), m.handle(), amplitude.times_pi,
                            ball::working_bits());
    }
    return result.real();
}

// R_D(x, y, 1).
ball carlson_d(const ball& x, const ball& y) {
    on_real_line first(x);
    on_real_line second(y);
    on_real_line one(ball(1));
    acb_elliptic_rj(first.handle(), first.handle(), second.handle(), one.handle(), one.handle(), 0,
                    ball::working_bits());
    return first.real();
}

// D for a parameter below 1: R_D(0, 1-m, 1)/3 [DLMF 19.25.1].
ball complete_d(const real_parameter& p) { return carlson_d(ball(0), from_exact<ball>(p.complement())) / 3; }

// phi = turns pi + rest, |rest| < pi/2 or rest = +-pi/2 exactly.
struct reduced_amplitude {
    integer halves;
    ball rest;
    bool is_quarter = false;
};

reduced_amplitude reduce_amplitude(const exact& phi) {
    if (phi.is_angle()) {
        const rational doubled = phi.in_pi() * 2 + 1;
        integer halves = numerator(doubled) / (denominator(doubled) * 2);
        if (rational(halves * 2) > doubled) {
            --halves;
        }
        const rational rest = phi.in_pi() - halves;
        return {halves, from_rational<ball>(rest) * pi<ball>(), abs(rest) * 2 == 1};
    }
    const ball x = from_exact<ball>(phi);
    const integer halves = nearest_integer(ball(x / pi<ball>()));
    const ball rest = x - from_rational<ball>(rational(halves)) * pi<ball>();
    require_below(rest, ball(pi<ball>() / 2), "an amplitude near a quarter turn");
    return {halves, rest};
}

// D(phi|m) = 2 halves D(m) + s^3/3 R_D(c^2, 1 - m s^2, 1) [DLMF 19.2.10, 19.25.13].
ball incomplete_d(const exact& phi, const real_parameter& p) {
    const auto reduced = reduce_amplitude(phi);
    ball sum(0);
    if (reduced.halves != 0 || reduced.is_quarter) {
        const integer quarters = reduced.halves * 2 + (reduced.is_quarter ? decided_sign(reduced.rest) : 0);
        sum = complete_d(p) * from_rational<ball>(rational(quarters));
    }
    if (reduced.is_quarter) {
        return sum;
    }
    const ball s = sin(reduced.rest);
    const ball c = cos(reduced.rest);
    return sum + s * s * s * carlson_d(ball(c * c), ball(1 - from_exact<ball>(p.m()) * s * s)) / 3;
}

true_value incomplete_integral_value(std::string_view name, const exact& phi, const function_arguments& at) {
    const real_parameter& p = at.parameter;
    if (phi.is_zero()) {
        return exact_value(0);
    }
    if ((name == "F" || name == "E") && p.where() == range::zero && phi.is_fraction()) {
        return exact_value(phi.coefficient);
    }
    const int of_m = sign_of_least(p.m(), phi);
    const int of_n = name == "Pi" ? sign_of_least(*at.characteristic, phi) : 1;
    if (of_m < 0) {
        refuse_not_real(name, p.m());
    }
    if (of_n < 0) {
        throw error(error_kind::argument, error_subject::characteristic, at.characteristic->text,
                    "makes the integral pass a pole");
    }
    if ((of_m == 0 && name != "E") || of_n == 0) {
        return infinite_value(decided_sign(from_exact<ball>(phi)));
    }
    const bool own = name == "F" && p.where() != range::negative && p.where() != range::above;
    return {own           ? incomplete_value(phi, p.within())
            : name == "D" ? incomplete_d(phi, p)
                          : incomplete_by_arb(name, phi, at)};
}

ball complete_second(const real_parameter& p) {
    on_real_line m(from_exact<ball>(p.m()));
    acb_elliptic_e(m.handle(), m.handle(), ball::working_bits());
    return m.real();
}

// Pi(n|m), n < 1 and m < 1.
ball complete_third(const exact& n, const real_parameter& p) {
    on_real_line characteristic(from_exact<ball>(n));
    on_real_line m(from_exact<ball>(p.m()));
    acb_elliptic_pi(m.handle(), characteristic.handle(), m.handle(), ball::working_bits());
    return m.real();
}

true_value complete_integral_value(std::string_view name, const function_arguments& at) {
    const real_parameter& p = at.parameter;
    if (p.where() == range::above) {
        refuse_not_real(name, p.m());
    }
    if (name == "Pi" && sign_of_exact(exactly(1) - *at.characteristic) < 0) {
        throw error(error_kind::argument, error_subject::characteristic, at.characteristic->text,
                    "makes the integral pass a pole");
    }
    if (p.where() == range::one) {
        return name == "E" ? exact_value(1) : infinite_value(1);
    }
    if (name == "Pi" && sign_of_exact(exactly(1) - *at.characteristic) == 0) {
        return infinite_value(1);
    }
    return {name == "K"   ? complete_value(p)
            : name == "E" ? complete_second(p)
            : name == "D" ? complete_d(p)
                          : complete_third(*at.characteristic, p)};
}

}  // namespace

ball complete_value(const real_parameter& p) {
    if (p.where() == range::zero || p.where() == range::within) {
        return complete_integral(p.within().shape<ball>());
    }
    ball mean;
    arb_agm(mean.handle(), ball(1).handle(), sqrt(from_exact<ball>(p.complement())).handle(), ball::working_bits());
    return pi<ball>() / (mean * 2);
}

true_value integral_value(std::string_view name, const function_arguments& at) {
    return at.argument ? incomplete_integral_value(name, *at.argument, at) : complete_integral_value(name, at);
}

true_value zeta_value(std::string_view name, const function_arguments& at) {
    const exact& phi = *at.argument;
    const real_parameter& p = at.parameter;
    if (p.where() == range::above) {
        refuse_not_real(name, p.m());
    }
    if (p.where() == range::one) {
        if (reaches_quarter(phi)) {
            throw error(error_kind::argument, {error_subject::argument, "phi"}, phi.text,
                        "is not below pi/2, as m = 1 requires");
        }
        return phi.is_zero() ? exact_value(0) : true_value{sin(from_exact<ball>(phi))};
    }
    if (p.where() == range::zero || phi.is_zero() || (phi.is_angle() && denominator(rational(phi.in_pi() * 2)) == 1)) {
        return exact_value(0);
    }
    const ball first = incomplete_by_arb("F", phi, at);
    return {incomplete_by_arb("E", phi, at) - complete_second(p) / complete_value(p) * first};
}

true_value nome_value(std::string_view name, const function_arguments& at) {
    const real_parameter& p = at.parameter;
    switch (p.where()) {
        case range::zero: return exact_value(0);
        case range::one: return exact_value(1);
        case range::above: refuse_not_real(name, p.m());
        case range::negative:
        case range::within: break;
    }
    const modulus<ball> reduced = p.reduced();
    const ball nome = exp(ball(-pi<ball>() * complete_integral(reduced.swapped()) / complete_integral(reduced)));
    return {p.where() == range::negative ? -nome : nome};
}

}  // namespace libration::elliptic
