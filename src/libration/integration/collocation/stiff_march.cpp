#include "libration/integration/collocation/stiff_march.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "collocation_steps.hpp"

namespace libration::ode {

namespace {

// The scalar of residuals and states of collocation.
template <class T>
using collocation_scalar = std::conditional_t<std::is_same_v<T, double>, long double, T>;

// The size of the matrix of Newton's method up to which collocation is used.
constexpr std::size_t most_equations = 3500;
// The number of steps of Taylor series that follow at least for a check to pay off: all checks then take less
// than a hundredth of the time.
constexpr double steps_worth_check = 65536;
constexpr double steps_worth_check_in_mpfr = 1024;
constexpr long first_check = 8;
// The number of steps in which their length may grow until they pay off.
constexpr long steps_until_worth = 6;

// The number of steps of Taylor series that take as long as one of collocation.
template <class T>
double cost_of_step(std::size_t unknowns) {
    constexpr double of_three_unknowns = 32;
    const double bits = std::max(1., digits<T>() / 200.);
    const double size = std::max(1., static_cast<double>(unknowns) / 3);
    return of_three_unknowns * bits * size * size;
}

template <class T>
double log2_of(const T& x) {
    return static_cast<double>(binary_exponent(x));
}

}  // namespace

template <ordered_scalar T>
struct stiff_march<T>::parts {
    using wide = collocation_scalar<T>;

    parts(const explicit_system& of, integrator_choice how, const series::block_product<T>* product)
        : system(of), choice(how), fast(product), origin(constant_value<T>::of(of.point())) {
        for (const unknown_function& each : of.unknowns()) {
            count += static_cast<std::size_t>(each.order);
        }
        if (choice == integrator_choice::comparison) {
            throw error(error_kind::argument, error_subject::integrator, "comparison",
                        "is a method of proofs: use automatic, taylor or collocation, or the scalar ball:D");
        }
        tolerance = step_tolerance::of<T>();
        possible = count * (static_cast<std::size_t>(tolerance.degree) + 1) <= most_equations;
        if (choice == integrator_choice::collocation && !possible) {
            throw error(error_kind::argument, error_subject::integrator, "collocation",
                        "is limited to " +
                            std::to_string(most_equations / (static_cast<std::size_t>(tolerance.degree) + 1)) +
                            " unknowns in this precision, and these equations have " + std::to_string(count) +
                            ": use automatic or taylor");
        }
        farthest = {origin, origin};
        restart();
    }

    void head_for(const T& t) {
        if (t < farthest.first) {
            farthest.first = t;
        } else if (t > farthest.second) {
            farthest.second = t;
        }
    }

    void restart() {
        taylor.emplace(system, fast);
        active = false;
        way = 0;
        taken = 0;
        between_checks = first_check;
        next_check = choice == integrator_choice::collocation ? 0 : between_checks;
        if (use.steps > 0) {
            finished.push_back(use);
        }
        use = {};
    }

    solution_state<T> nested(const std::vector<wide>& values) const {
        solution_state<T> result;
        std::size_t k = 0;
        for (const unknown_function& each : system.unknowns()) {
            auto& row = result.emplace_back();
            for (int j = 0; j < each.order; ++j) {
                row.push_back(convert<T>(values[k++]));
            }
        }
        return result;
    }

    // Whether collocation should be tried after the steps taken so far.
    bool may_begin() const {
        if (!possible || choice == integrator_choice::taylor || taken < next_check || taylor->length() == 0 ||
            (system.singular() && taylor->steps() == 1)) {
            return false;
        }
        const double size = std::max(1., static_cast<double>(count) / 8);
        const double worth = (fixed_scalar<T> ? steps_worth_check : steps_worth_check_in_mpfr) * size;
        const T rest = T((way < 0 ? farthest.first : farthest.second) - taylor->centre());
        return choice == integrator_choice::collocation ||
               log2_of(rest) - log2_of(taylor->length()) >= std::log2(worth);
    }

    // False if the derivatives of the right-hand sides are not available in the scalars of collocation.
    bool make_steps() {
        try {
            steps.emplace(first_order_form(system), system.point(), tolerance);
        } catch (const error&) {
            if (choice == integrator_choice::collocation) {
                throw;
            }
            possible = false;
        }
        return possible;
    }

    // Begins collocation at the centre of the current series if the solution is smooth there and a step is found.
    bool begin() {
        next_check = taken + between_checks;
        between_checks *= 2;
        if (!steps && !make_steps()) {
            return false;
        }
        std::vector<wide> begin_state;
        for (const auto& of_unknown : taylor->advance_to(taylor->centre())) {
            for (const T& each : of_unknown) {
                begin_state.push_back(convert<wide>(each));
            }
        }
        const wide time = convert<wide>(taylor->centre());
        const wide length = convert<wide>(T(taylor->length() * way));
        if (choice == integrator_choice::automatic && !steps->is_smooth_over(time, begin_state, length)) {
            return false;
        }
        steps->begin(time, std::move(begin_state), length);
        if (!steps->prepare()) {
            return false;
        }
        active = true;
        used = false;
        of_phase = 0;
        length_to_pay = log2_of(taylor->length()) + std::log2(cost_of_step<T>(count));
        return true;
    }

    // Notes that the prepared step is used up to a time.
    void note_use(const wide& until) {
        if (use.steps == 0) {
            use.first = convert<double>(steps->reached());
        }
        use.periods += of_phase == 0 && !used ? 1 : 0;
        use.steps += used ? 0 : 1;
        use.proved = false;
        use.last = convert<double>(until);
        used = true;
    }

    bool covers(const T& t) const {
        using std::abs;
        return wide(abs(wide(convert<wide>(t) - steps->reached()))) <= wide(abs(steps->length()));
    }

    // Takes the prepared step of collocation; returns to Taylor series where it does not pay or no other step is found.
    void advance() {
        note_use(wide(steps->reached() + steps->length()));
        const bool pays = log2_of(steps->length()) >= length_to_pay;
        steps->step();
        used = false;
        ++of_phase;
        if (pays) {
            between_checks = first_check;
        }
        if ((choice == integrator_choice::automatic && of_phase > steps_until_worth && !pays) || !steps->prepare()) {
            active = false;
            taylor->begin_at(convert<T>(steps->reached()), nested(steps->state()));
            taken = 0;
            next_check = between_checks;
        }
    }

    // Whether t is before the present step, so that the integration begins again.
    bool is_behind(const T& t, int forward) const {
        const wide rest = wide(convert<wide>(t) - (active ? steps->reached() : convert<wide>(taylor->centre())));
        return (active || use.steps > 0) && (forward != way || wide(rest * forward) < 0);
    }

    const solution_state<T>& advance_to(const T& t) {
        head_for(t);
        const int forward = t < origin ? -1 : 1;
        if (is_behind(t, forward)) {
            restart();
        }
        way = forward;
        for (;;) {
            if (active && covers(t)) {
                const wide at = convert<wide>(t);
                note_use(at);
                state = nested(steps->values_at(wide(at - steps->reached())));
                return state;
            }
            if (active) {
                advance();
            } else if (!may_begin() || !begin()) {
                if (!taylor->step_towards(t)) {
                    return taylor->advance_to(t);
                }
                if (++taken >= taylor_march<T>::most_steps) {
                    taylor->throw_not_reached(t);
                }
            }
        }
    }

    const explicit_system& system;
    integrator_choice choice;
    const series::block_product<T>* fast;
    step_tolerance tolerance;
    T origin;
    std::pair<T, T> farthest;  // backwards and forwards
    std::size_t count = 0;
    bool possible = true;
    std::optional<taylor_march<T>> taylor;
    std::optional<collocation_steps<wide>> steps;
    bool active = false;
    bool used = false;  // the prepared step
    int way = 0;
    long taken = 0, between_checks = first_check, next_check = first_check;  // in steps of Taylor series
    long of_phase = 0;
    double length_to_pay = 0;  // log2 of the length of a step that pays off
    collocation_use use;
    std::vector<collocation_use> finished;
    solution_state<T> state;
};

template <ordered_scalar T>
stiff_march<T>::stiff_march(const explicit_system& system, integrator_choice choice,
                            const series::block_product<T>* fast)
    : parts_(std::make_unique<parts>(system, choice, fast)) {}
template <ordered_scalar T>
stiff_march<T>::~stiff_march() = default;

template <ordered_scalar T>
void stiff_march<T>::head_for(const T& farthest) {
    parts_->head_for(farthest);
}

template <ordered_scalar T>
const solution_state<T>& stiff_march<T>::advance_to(const T& t) {
    return parts_->advance_to(t);
}

template <ordered_scalar T>
std::vector<collocation_use> stiff_march<T>::collocation() const {
    std::vector<collocation_use> all = parts_->finished;
    if (parts_->use.steps > 0) {
        all.push_back(parts_->use);
    }
    return all;
}

template class stiff_march<double>;
template class stiff_march<long double>;
template class stiff_march<quad>;
template class stiff_march<mpfr>;

}  // namespace libration::ode
