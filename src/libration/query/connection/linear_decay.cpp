#include "linear_decay.hpp"

#include <optional>
#include <utility>

#include "../../equation/bound_text.hpp"
#include "../well/polynomial_range.hpp"
#include "../well/well_side.hpp"
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

[[noreturn]] void refuse_linear(const std::string& reason) {
    throw error(error_kind::undecided, error_subject::problem, "", reason);
}

// The sign of f for all large s.
int sign_at_infinity(const rational_function& f) {
    return f.above().is_zero() ? 0 : f.above().coefficients().back() > 0 ? 1 : -1;
}

bool tends_to_zero(const rational_function& f) { return f.above().degree() < f.below().degree(); }

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
        std::optional<ball> last;
        const growing_digits runs{question_.digits, first_digits_of_linear, most_digits_of_linear};
        const std::string& name = question_.unknowns.front();
        connection result;
        try {
            result.values.push_back(with_growing_precision(
                runs, "the proof of " + std::to_string(question_.digits) + " digits", [&](const precision_run&) {
                    if (watch_) {
                        watch_(ball(0), ball::working_bits());
                    }
                    const auto value = unknown_value();
                    last = value ? value : last;
                    return value && !contains_zero(*value) ? to_proved_decimal(*value, question_.digits) : std::nullopt;
                }));
        } catch (const error& problem) {
            if (problem.kind() == error_kind::undecided && last && contains_zero(*last)) {
                const std::string bound = bound_text(upper_bound(abs(*last)), MPFR_RNDU);
                throw error(
                    error_kind::undecided, error_subject::solution, "",
                    "has " + name + " between -" + bound + " and " + bound + ", which is not distinguished from 0");
            }
            throw;
        }
        const std::string limit = question_.limits.front().text;
        result.proved = "exactly one " + name + " for which " + limit + ": no other solution with this " +
                        (start_.is_slope_unknown ? "value" : "slope") + " at the initial point tends to 0";
        return result;
    }

private:
    bool is_left() const { return question_.limits.front().direction < 0; }

    void require_unique_decay() const {
        const std::string form = "is y'' + p y' = q y, and ";
        const rational_function potential = of_.without_damping().potential;
        if (sign_at_infinity(potential) <= 0 || tends_to_zero(potential)) {
            refuse_linear(form +
                          "q + p^2/4 + p'/2 has no limit > 0 at infinity, where exponential decay is not proved");
        }
        if (start_.known.is(0)) {
            refuse_linear(
                "has only the solution 0 with this limit, because the given initial value is 0: give another one");
        }
        if (sign_at_infinity(of_.damping) < 0 && !tends_to_zero(of_.damping)) {
            refuse_linear(form + "p < 0 at infinity, where y -> 0 is not proved");
        }
        if (sign_at_infinity(of_.restoring) < 0) {
            refuse_linear(form + "q < 0 at infinity, where it is not proved that the limit 0 determines a solution");
        }
        const ball from(of_.exponential ? 1 : 0);
        const ball_polynomial below = balls_of(of_.damping.below());
        if (!is_positive_from(below, from) && !is_positive_from(added({}, -1, below), from)) {
            refuse_linear(form + "it is not seen that p has no pole between the initial point and infinity");
        }
    }

    // At the working precision; std::nullopt if it is too low.
    std::optional<ball> unknown_value() const {
        const ball from(of_.exponential ? 1 : 0);
        const auto state = well_side(of_.without_damping(), well_end{}, from).at(ball(0), false);
        if (!state) {
            return std::nullopt;
        }
        const ball damping =
            value_at(balls_of(of_.damping.above()), from) / value_at(balls_of(of_.damping.below()), from);
        const ball slope = state->slope - state->value * damping / 2;
        const ball given = expression_values<ball>({}, ball(0)).of(start_.known) * (is_left() ? -1 : 1);
        return start_.is_slope_unknown ? given * slope / state->value : given * state->value / slope;
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
           unknowns.front().find('(') != std::string::npos && is_linear_of_second_order(question.system) &&
           std::ranges::any_of(question.system.equations, [](const equation& each) {
               return each.left.has_variable() || each.right.has_variable();
           });
}

connection proved_linear_decay(const connection_question& question, const march_watch& watch) {
    return linear_decay_search(question, watch).result();
}

}  // namespace libration::ode
