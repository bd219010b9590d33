#include "singular_form.hpp"

#include <algorithm>

#include "libration/ode/taylor_expansion.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

bool vanishes(const rational& x, const rational& /*scale*/) { return x == 0; }

bool vanishes(const mpfr& x, const mpfr& scale) { return abs(x) <= scale * ldexp(mpfr(1), -100); }

// Whether every number of the problem is a fraction.
bool has_fractions_alone(const tape& made) {
    const auto is_fraction = [](const number& x) { return x.fraction().has_value(); };
    const auto are_fractions = [&](const std::vector<number>& all) { return std::ranges::all_of(all, is_fraction); };
    return is_fraction(made.point()) && are_fractions(made.constants()) &&
           std::ranges::all_of(made.starts(), are_fractions) &&
           std::ranges::all_of(made.steps(), [&](const tape_step& step) {
               return !is_function(step.kind) || (step.centre && is_fraction(*step.centre));
           });
}

template <field R>
void require_consistent(const tape& made, const explicit_system& of) {
    const int root = made.root();
    const int highest = *std::ranges::max_element(made.orders());
    taylor_expansion<R> series(made, root * highest);
    series.about_start();
    for (std::size_t i = 0; i < of.unknowns().size(); ++i) {
        const unknown_function& unknown = of.unknowns()[i];
        const R* const y = series.coefficients(static_cast<int>(i));
        const R* const right = series.right_side(static_cast<int>(i));
        for (int n = 0; n <= root * (unknown.order - 1); ++n) {
            R left = y[n];
            for (int l = 0; l < unknown.order; ++l) {
                left = R(left * (n - l * root) / root);
            }
            if (!vanishes(R(left - right[n]), R(abs(left) + abs(right[n]) + R(1)))) {
                refuse(unknown.name, {},
                       "has no power series with these initial values, since the equation contradicts " +
                           primed(unknown.name, n / root) +
                           "(t0), or the solution has a logarithm: choose another initial point");
            }
        }
        for (const tape_state& state : made.states()) {
            for (int n = 1; state.unknown == static_cast<int>(i) && n < root * state.derivative; ++n) {
                if (n % root != 0 && !vanishes(y[n], R(1))) {
                    refuse(
                        primed(unknown.name, state.derivative), {},
                        "is infinite at the initial point and occurs in the equations: choose another initial point");
                }
            }
        }
    }
}

}  // namespace

void require_consistent_start(const tape& made, const explicit_system& of) {
    if (has_fractions_alone(made)) {
        require_consistent<rational>(made, of);
        return;
    }
    const precision_scope scope(60);
    require_consistent<mpfr>(made, of);
}

}  // namespace libration::ode
