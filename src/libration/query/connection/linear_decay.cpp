#include "linear_decay.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "../../equation/bound_text.hpp"
#include "../well/polynomial_range.hpp"
#include "../well/well_side.hpp"
#include "libration/algebra/rational_polynomial.hpp"
#include "libration/digits/precision_loop.hpp"
#include "libration/equation/parametric_system.hpp"
#include "libration/equation/polynomial_form.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/scalar.hpp"

namespace libration::ode {

namespace {

constexpr long first_digits_of_linear = 20;
constexpr long most_digits_of_linear = 640;
constexpr long digits_of_roots = 40;

[[noreturn]] void refuse_linear(const std::string& reason) {
    throw error(error_kind::undecided, error_subject::problem, "", reason);
}

// Whether a real root of p at or above `from` is not excluded.
bool may_have_root_beyond(const rational_polynomial& p, const ball& from) {
    const precision_scope scope(digits_of_roots);
    return std::ranges::any_of(irreducible_factors(p), [&](const auto& factor) {
        return std::ranges::any_of(enclosed_roots(factor.first), [&](const complex_number<ball>& root) {
            return contains_zero(root.im) && !certainly_less(root.re, from);
        });
    });
}

// The two initial values, of which one is the unknown.
struct start_with_limit {
    expression known;
    bool is_slope_unknown;
    rational point;
};

start_with_limit start_with_limit_of(const connection_question& question) {
    const parametric_system open = opened(question.system, question.unknowns);
    const expression& leaf = open.leaves.front();
    const bool is_slope = same_form(open.starts[1], leaf);
    const expression& known = open.starts[is_slope ? 0 : 1];
    const auto point = expression(open.system.point()).fraction();
    if ((!is_slope && !same_form(open.starts[0], leaf)) || known.has_unknowns()) {
        refuse_linear("has initial values that both depend on " + question.unknowns.front() +
                      ", which is not supported for a linear equation with a limit: give one of them as a number");
    }
    if (!point) {
        refuse_linear(
            "begins at a time that is not a fraction, which is not supported for a linear equation with a limit");
    }
    return {known, is_slope, *point};
}

class linear_decay_search {
public:
    linear_decay_search(const connection_question& question, const march_watch& watch)
        : question_(question), watch_(watch), start_(start_with_limit_of(question)), of_(read_damped(question.system)) {
        if (of_.exponential && start_.point != 0) {
            refuse_linear("begins at another time than 0, which is supported only for rational coefficients");
        }
        if (!of_.exponential) {
            of_ = of_.shifted(start_.point);
        }
        if (is_left()) {
            of_ = of_.reflected();
        }
        require_unique_decay();
    }

    connection result() const {
        std::string zero;  // what is not distinguished from 0
        const growing_digits runs{question_.digits, first_digits_of_linear, most_digits_of_linear};
        const std::string& name = question_.unknowns.front();
        const auto attempt = [&](const precision_run&) -> std::optional<proved_decimal> {
            if (watch_) {
                watch_(ball(0), ball::working_bits());
            }
            const auto state = well_side(of_.without_damping(), well_end{}, from()).at(ball(0), false);
            if (!state) {
                return std::nullopt;
            }
            const ball slope = state->slope - state->value * value_of(of_.damping) / 2;
            const ball& by = start_.is_slope_unknown ? state->value : slope;
            if (contains_zero(by)) {
                zero = "has a solution that tends to 0 whose " + given_part() + " at the initial point";
                return std::nullopt;
            }
            const ball given = expression_values<ball>({}, ball(0)).of(start_.known) * (is_left() ? -1 : 1);
            const ball value = given * (start_.is_slope_unknown ? slope : state->value) / by;
            if (contains_zero(value)) {
                const std::string bound = bound_text(upper_bound(abs(value)), MPFR_RNDU);
                zero = "has " + name + " between -" + bound + " and " + bound + ", which";
                return std::nullopt;
            }
            return to_proved_decimal(value, question_.digits);
        };
        connection result;
        try {
            result.values.push_back(
                with_growing_precision(runs, "the proof of " + std::to_string(question_.digits) + " digits", attempt));
        } catch (const error& problem) {
            if (problem.kind() != error_kind::undecided || zero.empty()) {
                throw;
            }
            refuse_linear(zero + " is not distinguished from 0");
        }
        const std::string limit = question_.limits.front().text;
        result.proved = "exactly one " + name + " for which " + limit + ": no other solution with this " +
                        given_part() + " at the initial point tends to 0";
        return result;
    }

private:
    std::string given_part() const { return start_.is_slope_unknown ? "value" : "slope"; }
    bool is_left() const { return question_.limits.front().direction < 0; }

    void require_unique_decay() const {
        const std::string form = "is y'' + p y' = q y, and ";
        const rational_function potential = of_.without_damping().potential;
        if (potential.sign_at_infinity() <= 0 || potential.degree() < 0) {
            refuse_linear(form +
                          "q + p^2/4 + p'/2 has no limit > 0 at infinity, where exponential decay is not proved");
        }
        if (start_.known.is(0)) {
            refuse_linear(
                "has only the solution 0 with this limit, because the given initial value is 0: give another one");
        }
        if (of_.damping.sign_at_infinity() < 0 && of_.damping.degree() >= 0) {
            refuse_linear(form + "p < 0 at infinity, where y -> 0 is not proved");
        }
        if (of_.restoring.sign_at_infinity() < 0) {
            refuse_linear(form + "q < 0 at infinity, where it is not proved that the limit 0 determines a solution");
        }
        if (may_have_root_beyond(of_.damping.below(), from())) {
            refuse_linear(form + "it is not seen that p has no pole between the initial point and infinity");
        }
    }

    // The initial point as s, and a function there.
    ball from() const { return of_.exponential ? ball(1) : ball(0); }
    ball value_of(const rational_function& f) const {
        return value_at(balls_of(f.above()), from()) / value_at(balls_of(f.below()), from());
    }

    const connection_question& question_;
    const march_watch& watch_;
    start_with_limit start_;
    damped_equation of_;
};

}  // namespace

bool is_linear_decay(const connection_question& question) {
    const auto& unknowns = question.unknowns;
    return question.limits.size() == 1 && question.limits.front().of.derivative() == 0 &&
           question.limits.front().value.fraction() == rational(0) && unknowns.size() == 1 &&
           unknowns.front().find('(') != std::string::npos && is_linear_in_time(question.system);
}

connection proved_linear_decay(const connection_question& question, const march_watch& watch) {
    return linear_decay_search(question, watch).result();
}

}  // namespace libration::ode
