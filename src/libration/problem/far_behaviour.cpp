#include "libration/problem/far_behaviour.hpp"

#include <algorithm>
#include <utility>

#include "libration/approximant/asymptotic.hpp"
#include "libration/series/exponential.hpp"

namespace libration {

using series::power_series;

int far_behaviour::index() const {
    const auto& all = system.unknowns();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.name == unknown; });
    return static_cast<int>(found - all.begin());
}

std::optional<std::function<mpfr(const mpfr&)>> asymptotic_approximant(const far_behaviour& far,
                                                                       const power_series<mpfr>& f) {
    const mpfr& limit = far.line[0];
    const int half = f.order() / 2;
    const auto from_pade = [](std::optional<damped_pade<mpfr>> found, bool logarithm) {
        std::optional<std::function<mpfr(const mpfr&)>> result;
        if (found) {
            result = [of = *std::move(found), logarithm](const mpfr& t) {
                return logarithm ? mpfr(exp(of.value(t))) : of.value(t);
            };
        }
        return result;
    };
    switch (far.form) {
        case far_form::power:
            return [of = power_approximant<mpfr>(f, far.line, mpfr(-1))](const mpfr& t) { return of.value(t); };
        case far_form::algebraic: {
            const mpfr power = -far.rate * far.root / f.order();
            return [of = power_approximant<mpfr>(f, far.line, power), root = far.root](const mpfr& t) {
                return of.value(root == 1 ? t : mpfr(pow(t, mpfr(mpfr(1) / root))));
            };
        }
        case far_form::exponential:
            return [of = exponential_approximant<mpfr>(f, limit, far.rate)](const mpfr& t) { return of.value(t); };
        case far_form::reciprocal_exponential: {
            auto numerator = power_series<mpfr>::zero(f.order());
            numerator[0] = limit;
            return [of = exponential_approximant<mpfr>(numerator / f, mpfr(1), far.rate), limit](const mpfr& t) {
                return mpfr(limit / of.value(t));
            };
        }
        case far_form::damped:
            return from_pade(damped_pade<mpfr>::of(f, half, {limit, far.rate, mpfr(mpfr(1) / 2)}), false);
        case far_form::damped_logarithm:
            return from_pade(damped_pade<mpfr>::of(series::logarithm(f), half, {log(limit), far.rate, mpfr(0)}), true);
        case far_form::branch: break;
    }
    return [of = branch_approximant<mpfr>(f, far.end, mpfr(mpfr(2) / 5), 2)](const mpfr& t) { return of.value(t); };
}

}  // namespace libration
