// The verdict on a list of coefficients compared with a plain sweep of Pade approximants: of every [m/m] and [m-1/m] that the
// list holds, with the roots of all denominators. The lists are exp((1 - 4 x)^(1/3)) + (1 + 3 x)^(-1/2), to 100
// digits: branch points, which a denominator imitates by poles that gather there, in a function that no short linear
// equation describes. The errors are those of the radius, 1/4: of the verdict, and of the nearest root of the last
// denominator.
//
//   ./run bench series
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "libration/algebra/polynomial_roots.hpp"
#include "libration/approximant/pade.hpp"
#include "libration/convergence/elementary_series.hpp"
#include "libration/convergence/radius_answers.hpp"
#include "libration/series/exponential.hpp"
#include "rounds.hpp"

namespace {

using namespace libration;
using namespace libration::bench;

constexpr long digits_of_lists = 100;

series::power_series<mpfr> list_of(int order) {
    return series::exponential(series::rescale(convergence::binomial_series(mpfr(mpfr(1) / 3), order), mpfr(4))) +
           series::rescale(convergence::binomial_series(mpfr(mpfr(-1) / 2), order), mpfr(-3));
}

// The least modulus of a root of the last denominator.
mpfr pade_sweep(const series::power_series<mpfr>& a) {
    mpfr nearest(0);
    for (int m = 1; 2 * m <= a.order(); ++m) {
        for (const int numerator : {m - 1, m}) {
            const auto found = pade(a, numerator, m);
            if (!found) {
                continue;
            }
            nearest = mpfr(0);
            for (const auto& root : roots_of(found->denominator).all) {
                const mpfr modulus = modulus_of(root.at);
                nearest = nearest == 0 ? modulus : std::min(nearest, modulus);
            }
        }
    }
    return nearest;
}

std::string error_of(const mpfr& radius) {
    return fmt::format("{:.1e}", abs(mpfr(radius * 4 - 1)).convert_to<double>());
}

}  // namespace

int main() {
    const precision_scope scope(digits_of_lists);
    for (const int order : {25, 40, 80}) {
        const auto a = list_of(order);
        const auto verdict = convergence::verdict_in(a);
        std::vector<contender> all{
            {"libration, the verdict", timed(1, [&a] { convergence::verdict_in(a); }),
             error_of(verdict.radius.value_or(mpfr(0)))},
            {"a sweep of Pade approximants", timed(1, [&a] { pade_sweep(a); }), error_of(pade_sweep(a))}};
        run_rounds(all, 5);
        print_ratios(fmt::format("N = {}", order), "error of the radius", all);
    }
}
