#include "libration/problem/known/pendulum_solution.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>

#include "../solution/taylor_solution.hpp"
#include "known_problems.hpp"
#include "libration/digits/proved/printed_values.hpp"
#include "libration/ode/explicit_system.hpp"
#include "libration/ode/proved/proved_singularity.hpp"
#include "libration/pendulum/proved/proved_states.hpp"
#include "libration/pendulum/proved/proved_times.hpp"
#include "libration/pendulum/solution/exact_solution.hpp"
#include "libration/pendulum/taylor/point_coefficients.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/exponent_range.hpp"
#include "libration/scalar/text/decimal.hpp"

namespace libration {

namespace {

using ode::explicit_system;
using ode::node_kind;
using pendulum::motion;

// c of c sin(x), x the unknown of this name itself.
std::optional<ode::number> factor_of_sine(const ode::expression& e, const std::string& name) {
    if (e.kind() == node_kind::product && e.left().kind() == node_kind::constant) {
        const auto rest = factor_of_sine(e.right(), name);
        return rest ? std::optional(e.left().constant() * *rest) : std::nullopt;
    }
    const bool sine = e.kind() == node_kind::function && e.function() == function_kind::sin;
    const bool of_it =
        sine && e.left().kind() == node_kind::unknown && e.left().name() == name && e.left().derivative() == 0;
    return of_it ? std::optional(ode::number(1)) : std::nullopt;
}

bool is_unknown(const ode::expression& e, const std::string& name) {
    return e.kind() == node_kind::unknown && e.name() == name && e.derivative() == 0;
}

// The index of the angle among the unknowns and c of its second derivative c sin.
struct pendulum_form {
    std::size_t angle;
    ode::number factor;
};

std::optional<pendulum_form> form_of(const explicit_system& system) {
    const auto& unknowns = system.unknowns();
    const auto& right = system.right();
    if (system.singular()) {
        return std::nullopt;
    }
    if (unknowns.size() == 1 && unknowns[0].order == 2) {
        const auto factor = factor_of_sine(right[0], unknowns[0].name);
        return factor ? std::optional(pendulum_form{0, *factor}) : std::nullopt;
    }
    if (unknowns.size() != 2 || unknowns[0].order != 1 || unknowns[1].order != 1) {
        return std::nullopt;
    }
    for (const std::size_t angle : {0U, 1U}) {
        const auto factor = factor_of_sine(right[1 - angle], unknowns[angle].name);
        if (factor && is_unknown(right[angle], unknowns[1 - angle].name)) {
            return pendulum_form{angle, *factor};
        }
    }
    return std::nullopt;
}

exact exact_number(const ode::number& value, const std::string& name) {
    const auto fraction = value.fraction();
    return fraction ? exactly(*fraction) : exactly(value, name);
}

class pendulum_solution : public solution {
public:
    explicit pendulum_solution(motion m)
        : solution({"theta", "omega"}), motion_(std::move(m)), start_(exactly(0)), angle_("theta") {}
    pendulum_solution(const ode::equation_system& equations, recognised_pendulum found)
        : solution(taylor_solution(equations).quantities()),
          general_(std::make_unique<taylor_in_general>(equations)),
          motion_(std::move(found.of)),
          start_(std::move(found.start)),
          angle_(std::move(found.angle)),
          swapped_(found.swapped),
          second_order_(found.second_order) {}

    std::string closed_form() const override { return "the pendulum"; }
    std::vector<std::string> times_in_decimals(const std::vector<exact>& times, long digits) const override;
    answer states(const std::vector<exact>& times, const request& how) const override;
    std::optional<answer> constants(const request& how) const override;
    answer limits(const request& how) const override { return general("at infinite time").limits(how); }
    answer events(const std::string& condition, long count, const request& how) const override {
        return general("for events").events(condition, count, how);
    }
    answer series(long order, const std::string& about, const request& how) const override;
    answer radius(const std::string& about, const request& how) const override;

private:
    class taylor_in_general : public taylor_solution {
    public:
        using taylor_solution::drifts;
        using taylor_solution::taylor_solution;
    };

    const taylor_in_general& general(const char* what) const {
        if (!general_) {
            throw error(error_kind::argument, "motion", "",
                        std::string("has no closed form ") + what + ": give its equations as a problem");
        }
        return *general_;
    }
    // The time of the motion.
    exact since_start(const exact& time) const { return start_.is_zero() ? time : time - start_; }
    // Cached, since the part that depends on the energy alone is computed once.
    pendulum::proved_states& states_to(long digits) const;
    std::vector<answer_value> state_at(pendulum::proved_states& states, const exact& time, bool check) const;
    std::vector<std::string> drifts(const std::vector<exact>& times, long digits) const;
    pendulum::expansion_point point_of(const std::string& about) const;

    std::unique_ptr<taylor_in_general> general_;
    motion motion_;
    exact start_;
    std::string angle_;
    bool swapped_ = false;
    bool second_order_ = true;
    mutable std::map<long, pendulum::proved_states> states_;
};

pendulum::proved_states& pendulum_solution::states_to(long digits) const {
    return states_.try_emplace(digits, motion_, digits).first->second;
}

// The decimal of E or 2 - E if it terminates.
std::optional<std::string> ending(const std::optional<exact>& number) {
    return number && number->is_fraction() ? to_finite_decimal(number->coefficient) : std::nullopt;
}

std::optional<answer> pendulum_solution::constants(const request& how) const {
    pendulum::proved_states& states = states_to(how.printed_digits());
    auto energy = ending(motion_.exact_energy());
    auto gap = ending(motion_.exact_gap());
    if (!energy || !gap) {
        const auto proved = states.energies();
        energy = energy.value_or(proved[0]);
        gap = gap.value_or(proved[1]);
    }
    const auto [period, tstar, radius] = states.constants();
    return answer{.names = {"energy", "gap", "period", "tstar", "radius"},
                  .rows = {{{*energy, ""}, {*gap, ""}, {period, ""}, {tstar, ""}, {radius, ""}}},
                  .rigour = "proved"};
}

std::vector<std::string> pendulum_solution::times_in_decimals(const std::vector<exact>& times, long digits) const {
    const auto needs_period = [](const exact& time) { return time.has_periods() && !time.is_zero(); };
    std::vector<exact> with_period;
    std::ranges::copy_if(times, std::back_inserter(with_period), needs_period);
    const auto proved =
        with_period.empty() ? std::vector<std::string>() : pendulum::proved_times(motion_, with_period, digits);
    auto next = proved.begin();
    std::vector<std::string> decimals;
    for (const exact& time : times) {
        decimals.push_back(needs_period(time) ? *next++ : decimal_of(time, digits));
    }
    return decimals;
}

std::vector<answer_value> pendulum_solution::state_at(pendulum::proved_states& states, const exact& time,
                                                      bool check) const {
    const auto of_motion = states.both_at(since_start(time));
    std::vector<answer_value> values{{of_motion[0].text, of_motion[0].uncertainty},
                                     {of_motion[1].text, of_motion[1].uncertainty}};
    if (check && !states.confirms(since_start(time))) {
        throw std::runtime_error("the two proved routes disagree at time " + time.text + ": theta = " + values[0].text +
                                 ", omega = " + values[1].text +
                                 " is not enclosed by the sum over separatrix solutions");
    }
    if (swapped_) {
        std::swap(values[0], values[1]);
    }
    return values;
}

answer pendulum_solution::states(const std::vector<exact>& times, const request& how) const {
    const bool correct = how.scalar.kind == scalar_kind::proved || how.scalar.kind == scalar_kind::arbitrary;
    if (!correct) {
        return general("in a fixed scalar").states(times, how);
    }
    if (how.integrator != ode::integrator_choice::automatic) {
        throw error(error_kind::argument, "integrator",
                    how.integrator == ode::integrator_choice::taylor ? "taylor" : "collocation",
                    "is not used by the closed form of the pendulum: use automatic, or solve with general = true");
    }
    pendulum::proved_states& states = states_to(how.printed_digits());
    answer result{.names = quantities(), .rows = {}, .rigour = "proved"};
    for (std::size_t i = 0; i < times.size(); ++i) {
        auto& row = result.rows.emplace_back();
        try {
            row = state_at(states, times[i], how.check);
        } catch (const error& problem) {
            if (problem.kind() == error_kind::range) {
                throw error(error_kind::range, "time", times[i].text,
                            "has an angular velocity that is too small to be printed");
            }
            if (problem.kind() != error_kind::undecided) {
                throw;
            }
            result.missing = problem;
        }
        if (how.progress) {
            how.progress(static_cast<double>(i + 1) / static_cast<double>(times.size()));
        }
    }
    if (how.scalar.kind == scalar_kind::arbitrary && general_) {
        result.drifts = drifts(times, how.printed_digits());
    }
    return result;
}

// Of an invariant stated in the problem, by more digits than those of the result.
std::vector<std::string> pendulum_solution::drifts(const std::vector<exact>& times, long digits) const {
    if (general_->system().invariants().empty()) {
        return {};
    }
    constexpr long more = 20;
    pendulum::proved_states& states = states_to(digits + more);
    const precision_scope scope(digits + 2 * more);
    std::vector<ode::solution_state<mpfr>> all;
    for (const exact& time : times) {
        const auto values = state_at(states, time, false);
        const mpfr first(values[0].text);
        const mpfr second(values[1].text);
        all.push_back(second_order_ ? ode::solution_state<mpfr>{{first, second}}
                                    : ode::solution_state<mpfr>{{first}, {second}});
    }
    return general_->drifts(times, all, digits);
}

// An empty text is the initial point; the names of points of a motion are not times of an equation.
pendulum::expansion_point pendulum_solution::point_of(const std::string& about) const {
    if (!general_) {
        return pendulum::point_of_motion(motion_, about.empty() ? "start" : about);
    }
    const exact time = about.empty() ? start_ : read_exact(about);
    return {pendulum::expansion_point::place::time, since_start(time)};
}

answer pendulum_solution::series(long order, const std::string& about, const request& how) const {
    const bool correct = how.scalar.kind == scalar_kind::proved || how.scalar.kind == scalar_kind::arbitrary;
    if (general_ && (!correct || !second_order_ || about.find('i') != std::string::npos)) {
        return general_->series(order, about, how);
    }
    const pendulum::expansion_point point = point_of(about);
    const long digits = how.printed_digits();
    const whole_exponent_range exponents;  // of a_n ~ R^-n
    const auto values = printed(
        how.scalar, digits,
        [&]<class T>() {
            const precision_scope wider(working_digits() + (rounding_scalar<T> ? 20 : 0));
            return pendulum::point_coefficients<T>(motion_, point, 0, order);
        },
        [&] { return pendulum::vanishing_at(motion_, point, 0, order); });
    const bool proved = how.scalar.kind == scalar_kind::proved;
    answer result{.names = {"n", angle_}, .rows = {}, .rigour = proved ? "proved" : "two-method"};
    for (const printed_number& each : values) {
        result.rows.push_back({{std::to_string(result.rows.size()), "0"}, {each.text, proved ? each.uncertainty : ""}});
    }
    return result;
}

answer pendulum_solution::radius(const std::string& about, const request& how) const {
    const long digits = how.printed_digits();
    const pendulum::expansion_point point = point_of(about);
    ode::proved_radius bounds;
    bounds.infinite = true;
    proved_decimals(digits + 1, [&] {
        const auto found = pendulum::radius_about(pendulum::exact_solution<ball>(motion_), point);
        bounds.infinite = !found;
        if (found) {
            const ball radius = *found * pendulum::time_unit<ball>(motion_);
            bounds.lower = lower_bound(radius);
            bounds.upper = upper_bound(radius);
        }
        return bounds.infinite ? std::vector<ball>{} : std::vector{bounds.lower, bounds.upper};
    });
    const auto [lower, upper] = ode::outward_decimals(bounds, digits);
    return {.names = {"lower", "upper"}, .rows = {{{lower, ""}, {upper, ""}}}, .rigour = "proved"};
}

}  // namespace

std::unique_ptr<solution> solution_of(const motion& m) { return std::make_unique<pendulum_solution>(m); }

std::optional<recognised_pendulum> recognise_pendulum(const ode::equation_system& equations) {
    const explicit_system system(equations);
    const auto form = form_of(system);
    if (!form) {
        return std::nullopt;
    }
    const bool second_order = system.unknowns().size() == 1;
    const auto& starts = system.starts();
    const std::string& angle = system.unknowns()[form->angle].name;
    const ode::number& omega0 = second_order ? starts[0][1] : starts[1 - form->angle][0];
    try {
        if (form->factor.sign() >= 0) {
            return std::nullopt;
        }
        motion of = motion::of_state(exact_number(starts[form->angle][0], angle + "(0)"),
                                     exact_number(omega0, angle + "'(0)"), exact_number(-form->factor, "k"));
        return recognised_pendulum{std::move(of), exact_number(system.point(), "t0"), form->angle == 1, second_order,
                                   angle};
    } catch (const error&) {
        return std::nullopt;
    }
}

known_facts facts_of_pendulum() {
    return {.problem = "pendulum",
            .closed_form = [](const ode::equation_system& equations) -> std::unique_ptr<solution> {
                auto found = recognise_pendulum(equations);
                return found ? std::make_unique<pendulum_solution>(equations, std::move(*found)) : nullptr;
            }};
}

}  // namespace libration
