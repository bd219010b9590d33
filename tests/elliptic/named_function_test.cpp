// The named functions against the theta functions of Arb, by another route: the nome of a complex lattice.
#include "libration/elliptic/named_function.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#if __has_include(<flint/acb_modular.h>)
#include <flint/acb.h>
#include <flint/acb_elliptic.h>
#include <flint/acb_modular.h>
#else
#include <acb.h>
#include <acb_elliptic.h>
#include <acb_modular.h>
#endif

namespace elliptic_named_function_test {

using namespace libration;
using namespace libration::elliptic;

namespace {

struct complex_ball {
    acb_t value;
    complex_ball() { acb_init(value); }
    complex_ball(const complex_ball&) = delete;
    complex_ball& operator=(const complex_ball&) = delete;
    ~complex_ball() { acb_clear(value); }
};

// theta_1 .. theta_4 at zeta, tau [DLMF 20.2(i), z = pi zeta].
struct thetas {
    complex_ball at[4];
    thetas(const complex_ball& zeta, const complex_ball& tau, slong bits) {
        acb_modular_theta(at[0].value, at[1].value, at[2].value, at[3].value, zeta.value, tau.value, bits);
    }
};

// sn, cn, dn by [DLMF 22.2.4-6]: tau = i K(1-m)/K(m), zeta = u/(2K).
std::vector<ball> by_thetas(const ball& u, const ball& m, slong bits) {
    complex_ball parameter;
    complex_ball k;
    complex_ball tau;
    complex_ball zeta;
    complex_ball zero;
    acb_set_arb(parameter.value, m.handle());
    acb_elliptic_k(k.value, parameter.value, bits);
    acb_sub_ui(parameter.value, parameter.value, 1, bits);
    acb_neg(parameter.value, parameter.value);
    acb_elliptic_k(tau.value, parameter.value, bits);
    acb_div(tau.value, tau.value, k.value, bits);
    acb_mul_onei(tau.value, tau.value);
    acb_set_arb(zeta.value, u.handle());
    acb_div(zeta.value, zeta.value, k.value, bits);
    acb_mul_2exp_si(zeta.value, zeta.value, -1);
    const thetas at_zero(zero, tau, bits);
    const thetas here(zeta, tau, bits);
    const auto quotient = [&](int above, int below, int above_at_zero, int below_at_zero) {
        complex_ball result;
        acb_div(result.value, here.at[above].value, here.at[below].value, bits);
        acb_mul(result.value, result.value, at_zero.at[above_at_zero].value, bits);
        acb_div(result.value, result.value, at_zero.at[below_at_zero].value, bits);
        ball real;
        arb_set(real.handle(), acb_realref(result.value));
        return real;
    };
    return {quotient(0, 3, 2, 1), quotient(1, 3, 3, 1), quotient(2, 3, 3, 2)};
}

}  // namespace

TEST_CASE("the twelve functions overlap with quotients of Arb's theta functions", "[elliptic][proved]") {
    const precision_scope scope(60);
    const slong bits = ball::working_bits();
    const ball narrow = ldexp(ball(1), -150);  // of 200 bits, 50 for the argument 12.7 and for poles nearby
    for (const std::string m : {"-1e6", "-3", "-1/1000", "1e-20", "0.3", "0.999999", "1.001", "1.5", "1e4"}) {
        for (const std::string u : {"1e-10", "0.7", "-2.3", "12.7"}) {
            const exact argument = read_exact(u);
            const real_parameter p = real_parameter::from_parameter(read_exact(m));
            const auto triple = by_thetas(from_exact<ball>(argument), from_exact<ball>(p.m()), bits);
            const auto letter = [&](char c) { return c == 'n' ? ball(1) : triple[c == 's' ? 0U : c == 'c' ? 1U : 2U]; };
            for (const std::string f : {"sn", "cn", "dn", "cd", "sd", "nd", "dc", "nc", "sc", "ns", "ds", "cs"}) {
                INFO(f << "(" << u << "|" << m << ")");
                const ball value = (*find_function(f))({argument, p}).value();
                CHECK(overlaps(value, ball(letter(f[0]) / letter(f[1]))));
                CHECK(certainly_less(radius_of(value), ball(narrow * (abs(value) + 1) * (abs(value) + 1))));
            }
        }
    }
}

TEST_CASE("complex arguments obey the addition theorem", "[elliptic][proved]") {
    // sn^2 + cn^2 = 1, dn^2 + m sn^2 = 1, and symmetry; the digits themselves are in tests/command.
    const precision_scope scope(60);
    for (const std::string m : {"-3", "0", "0.3", "1", "1.5"}) {
        INFO("m = " << m);
        const real_parameter p = real_parameter::from_parameter(read_exact(m));
        const auto at = [&](const char* name) {
            return *complex_quotient(name, read_exact("0.7"), read_exact("-1.2"), p);
        };
        const auto square = [](const complex_parts& z) {
            return complex_parts{z.real * z.real - z.imaginary * z.imaginary, z.real * z.imaginary * 2};
        };
        const complex_parts sn = square(at("sn"));
        const complex_parts cn = square(at("cn"));
        const complex_parts dn = square(at("dn"));
        const ball parameter = from_exact<ball>(p.m());
        CHECK(overlaps(ball(sn.real + cn.real), ball(1)));
        CHECK(contains_zero(ball(sn.imaginary + cn.imaginary)));
        CHECK(overlaps(ball(dn.real + parameter * sn.real), ball(1)));
        CHECK(contains_zero(ball(dn.imaginary + parameter * sn.imaginary)));
        CHECK(certainly_less(radius_of(sn.real), pow(ball(10), -50)));
        // The conjugate argument has the conjugate value.
        const complex_parts mirrored = *complex_quotient("sd", read_exact("0.7"), read_exact("1.2"), p);
        CHECK(overlaps(mirrored.real, at("sd").real));
        CHECK(overlaps(mirrored.imaginary, -at("sd").imaginary));
    }
}

TEST_CASE("the amplitude is continuous across 0 and 1 and has sn for its sine", "[elliptic][proved]") {
    const precision_scope scope(60);
    for (const std::string m : {"-3", "-1e-30", "0", "1e-30", "0.3", "1", "1.5"}) {
        for (const std::string u : {"0.7", "-2.3", "12.7"}) {
            INFO("am(" << u << "|" << m << ")");
            const function_arguments at{read_exact(u), real_parameter::from_parameter(read_exact(m))};
            const ball am = (*find_function("am"))(at).value();
            CHECK(overlaps(sin(am), (*find_function("sn"))(at).value()));
            CHECK(overlaps(cos(am), (*find_function("cn"))(at).value()));
            if (m.ends_with("e-30")) {  // am(u|m) - u = -m (2u - sin 2u)/8 + ... [DLMF 22.16.9 with 22.10]
                CHECK(certainly_less(abs(ball(am - from_exact<ball>(*at.argument))), pow(ball(10), -28)));
            }
        }
    }
}

TEST_CASE("names are those of the catalogue", "[elliptic][proved]") {
    CHECK(named_functions().size() == 36);
    CHECK(find_function("sm") == nullptr);
    CHECK(find_function("E")->may_be_complete);
    CHECK(find_function("Pi")->has_characteristic);
}

}  // namespace elliptic_named_function_test
