// Section VI: the three scenarios of the conclusions, and asymptotic approximants where the radius lies within the domain.
#include <algorithm>
#include <initializer_list>
#include <string>

#include <mpfr.h>

#include "claim.hpp"
#include "judging.hpp"
#include "libration/convergence/radius_answers.hpp"
#include "studies/approximant_norms.hpp"
#include "studies/shared/catalogue_system.hpp"

namespace libration {

using namespace judging;

namespace {

mpfr gamma_at(const mpfr& x) {
    mpfr value(x);
    mpfr_gamma(value.backend().data(), x.backend().data(), MPFR_RNDN);
    return value;
}

claim rayleigh_scenario() {
    return {.name = "rayleigh_scenario",
            .label = "sec:conclusions",
            .statement =
                "The radius of convergence of the series of Rayleigh's equation is precisely the length of its "
                "physical domain.",
            .number =
                "|R/T - 1| of the radius from 120 coefficients and the time of collapse T = sqrt(pi/6) "
                "Gamma(5/6)/Gamma(4/3)",
            .correction = "",
            .command = "./run radius --problem rayleigh --order 120 --digits 30",
            .measure = [] {
                const ode::explicit_system system(studies::catalogue_system("rayleigh"));
                const ode::tape tape = ode::tape::about_start(system);
                ode::taylor_expansion<mpfr> expansion(tape, 120);
                expansion.about_start();
                const mpfr found = *convergence::verdict_in(expansion.series_of(0)).radius;
                const mpfr collapse = sqrt(pi<mpfr>() / 6) * gamma_at(mpfr(5) / 6) / gamma_at(mpfr(4) / 3);
                const mpfr error = abs(found / collapse - 1);
                return by_test(error < pow(mpfr(10), -6), error);
            }};
}

// The norms of the asymptotic approximants of a problem on its whole domain, by their order.
mpfr least_norm(const studies::approximant_norms::solved_problem& of, std::initializer_list<int> orders) {
    mpfr least(1000);
    for (const int order : orders) {
        const auto approximant = asymptotic_approximant(of.far, of.f.truncated(order));
        if (approximant) {
            least = std::min(least, studies::approximant_norms::norm_of(of, *approximant).norm);
        }
    }
    return least;
}

claim approximants_continue() {
    return {
        .name = "approximants_continue",
        .label = "sec:conclusions",
        .statement =
            "Where the radius of convergence lies within the domain, asymptotic approximants continue the series "
            "over the whole domain to a useful convergent solution.",
        .number = "norm of the error on the half line at N = 160 over the least one at N = 30, 40, 50, 60, Blasius",
        .correction =
            "To a useful one, at a moderate order: for Blasius the norm is below 1e-8 at N = 50, but it does not "
            "converge: beyond, the norms grow and tend to the distance of the solution from its line at the radius "
            "of the bracket, about 1e-3. They converge where the bracket is analytic on the whole domain, as for sir.",
        .command = "./run study approximants --problems blasius,sir,sir_japan",
        .measure = [] {
            constexpr long digits = 16;
            const precision_scope scope(2 * digits + 20);
            const auto blasius =
                studies::approximant_norms::solve("blasius", studies::catalogue_system("blasius"), 160, digits);
            const mpfr best = least_norm(blasius, {30, 40, 50, 60});
            const mpfr late = least_norm(blasius, {160});
            return by_tests(late <= best, best < pow(mpfr(10), -6), mpfr(late / best));
        }};
}

}  // namespace

std::vector<claim> claims_of_scenarios() { return {rayleigh_scenario(), approximants_continue()}; }

}  // namespace libration
