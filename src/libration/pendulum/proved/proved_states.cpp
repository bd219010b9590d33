#include "libration/pendulum/proved/proved_states.hpp"

#include <algorithm>
#include <optional>

#include "libration/digits/proved/proved_decimals.hpp"
#include "libration/pendulum/solution/critical_formula.hpp"
#include "libration/pendulum/solution/separatrix_sum.hpp"

namespace libration::pendulum {

namespace {

// From this many digits on, a trial with few of them measures the loss of a motion: repeating would cost more.
constexpr long worth_a_trial = 500;
constexpr long trial_digits = 20;
constexpr long first_guard = 20;

std::vector<std::string> texts_of(const std::vector<proved_decimal>& values) {
    std::vector<std::string> texts;
    texts.reserve(values.size());
    for (const proved_decimal& value : values) {
        texts.push_back(value.text);
    }
    return texts;
}

// Whether a ball is narrower than one unit in the last of its digits; around 0, of those of 1.
bool shows_digits(const ball& x, const ball& size, long digits) {
    const ball unit = is_exact(size) && contains_zero(size) ? pow(ball(10), -digits)
                                                            : parts_of(midpoint_of(size), digits, MPFR_RNDN).unit();
    return certainly_less(radius_of(x), unit);
}

}  // namespace

long digits_before_point(const motion& m, const exact& time) {
    if (time.only_periods()) {
        return 0;
    }
    const precision_scope rough(20);
    const mpfr dimensionless = from_exact<mpfr>(time.without_periods()) / time_unit<mpfr>(m);
    return decimal_digits(std::max(0L, binary_exponent(dimensionless)));
}

const proved_motion& proved_states::motion_here() { return made_.try_emplace(working_digits(), motion_).first->second; }

long proved_states::more_digits(const exact& time) {
    const long before = digits_before_point(motion_, time);
    if (digits_ < worth_a_trial) {
        return before;
    }
    long needed = 0;
    proved_decimals(trial_digits, [&] {
        needed = working_digits() - trial_digits - first_guard;
        const precision_scope wider(working_digits() + before);
        const enclosed_state state = motion_here().at(time);
        return std::vector<ball>{state.theta, state.omega};
    });
    return before + needed;
}

std::vector<proved_decimal> proved_states::state_at(const exact& time) {
    const long more = more_digits(time);
    return proved_decimals(digits_, [&] {
        const precision_scope wider(working_digits() + more);
        enclosed_state state = motion_here().at(time);
        return std::vector<ball>{std::move(state.theta), std::move(state.omega)};
    });
}

proved_states::state_text proved_states::at(const exact& time) {
    const auto values = state_at(time);
    return {values[0].text, values[1].text};
}

proved_states::constant_texts proved_states::constants() {
    const bool critical = at_critical_energy(motion_.regime());
    const bool at_rest = motion_.regime() == regime::stable_equilibrium || (critical && motion_.omega0_sign() == 0);
    const auto values = texts_of(proved_decimals(digits_, [&] {
        const proved_motion& here = motion_here();
        std::vector<ball> list;
        if (!critical) {
            list.push_back(here.effective_period());
            list.push_back(list[0] * quarters_per_period(motion_.regime()));
        }
        if (!at_rest) {
            list.push_back(here.radius());
        }
        return list;
    }));
    const std::string radius = at_rest ? "inf" : values.back();
    return critical ? constant_texts{"inf", "inf", radius} : constant_texts{values[1], values[0], radius};
}

std::vector<std::string> proved_states::energies() {
    return texts_of(proved_decimals(digits_, [&] {
        auto pair = pendulum::energies<ball>(motion_);
        return std::vector<ball>{std::move(pair.energy), std::move(pair.gap)};
    }));
}

std::string proved_states::time_text(const exact& time, long digits) {
    const auto value = [&] {
        if (!time.has_periods()) {
            return from_exact<ball>(time);
        }
        const ball whole = motion_here().effective_period() *
                           from_rational<ball>(rational(time.periods() * quarters_per_period(motion_.regime())));
        return time.only_periods() ? whole : whole + from_exact<ball>(time.without_periods());
    };
    return proved_value(digits, value).text;
}

std::vector<ball> proved_states::second_route(const exact& time) const {
    const ball seconds = time_unit<ball>(motion_);
    if (motion_.regime() == regime::separatrix) {
        const ball elapsed = from_exact<ball>(time) / seconds;
        return {critical_formula(motion_, elapsed), critical_speed(motion_, elapsed) / seconds};
    }
    const auto state = separatrix_sum<ball>(motion_)(time);
    return {state.value, state.slope / seconds};
}

bool proved_states::confirms(const exact& time) {
    const long before = digits_before_point(motion_, time);
    const auto attempt = [&](const precision_run& /*run*/) -> std::optional<bool> {
        const proved_motion& here = motion_here();
        if (here.at_rest()) {
            return true;
        }
        const enclosed_state first = here.at(time);
        const std::vector<ball> second = second_route(time);
        if (!overlaps(first.theta, second[0]) || !overlaps(first.omega, second[1])) {
            return false;
        }
        const bool narrow =
            shows_digits(second[0], first.theta, digits_) && shows_digits(second[1], first.omega, digits_);
        return narrow ? std::optional(true) : std::nullopt;
    };
    return with_growing_precision(proving(digits_ + before), "the check at time " + time.text + " by a second route",
                                  attempt);
}

}  // namespace libration::pendulum
