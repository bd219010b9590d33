#include "libration/pendulum/proved_states.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include "given_question.hpp"
#include "libration/digits/proved_decimals.hpp"
#include "libration/pendulum/critical_formula.hpp"
#include "libration/pendulum/expansion.hpp"
#include "libration/pendulum/separatrix_sum.hpp"

namespace libration::pendulum {

namespace {

// From this many digits on, a trial with few of them measures the loss of a motion: repeating would cost more.
constexpr long worth_a_trial = 500;
constexpr long trial_digits = 20;
constexpr long first_guard = 20;

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

// Infinite ones, and E and 2 - E if their decimals terminate within the digits.
std::optional<proved_decimal> proved_states::exact_constant(motion_constant which) const {
    const auto if_short = [&](const std::optional<rational>& value) {
        const auto text = short_decimal(value, digits_);
        return text ? std::optional(proved_decimal{*text, "0"}) : std::nullopt;
    };
    const auto if_infinite = [](bool infinite) {
        return infinite ? std::optional(proved_decimal{"inf", "0"}) : std::nullopt;
    };
    const auto& energy = motion_.energy();
    switch (which) {
        case motion_constant::energy: return if_short(energy);
        case motion_constant::gap: return if_short(energy ? std::optional(rational(2 - *energy)) : std::nullopt);
        case motion_constant::radius: return if_infinite(at_rest(motion_.regime()));
        case motion_constant::period:
        case motion_constant::effective_period: break;
    }
    return if_infinite(at_critical_energy(motion_.regime()));
}

std::vector<ball> proved_states::enclosed(const std::vector<motion_constant>& which,
                                          const std::optional<expansion_point>& about) {
    std::optional<ball> tstar;
    const auto effective_period = [&] {
        tstar = tstar ? tstar : motion_here().effective_period();
        return *tstar;
    };
    const auto value = [&](motion_constant each) {
        switch (each) {
            case motion_constant::energy: return energies<ball>(motion_).energy;
            case motion_constant::gap: return energies<ball>(motion_).gap;
            case motion_constant::period: return ball(effective_period() * quarters_per_period(motion_.regime()));
            case motion_constant::effective_period: return effective_period();
            case motion_constant::radius: break;
        }
        return about ? ball(*radius_about(exact_solution<ball>(motion_), *about) * time_unit<ball>(motion_))
                     : motion_here().radius();
    };
    std::vector<ball> values;
    std::ranges::transform(which, std::back_inserter(values), value);
    return values;
}

std::vector<proved_decimal> proved_states::constants(const std::vector<motion_constant>& which,
                                                     const std::optional<expansion_point>& about) {
    std::vector<std::optional<proved_decimal>> known;
    std::vector<motion_constant> open;
    for (const motion_constant each : which) {
        known.push_back(exact_constant(each));
        if (!known.back()) {
            open.push_back(each);
        }
    }
    const auto proved = proved_decimals(digits_, [&] { return enclosed(open, about); });
    std::vector<proved_decimal> all;
    all.reserve(known.size());
    auto next = proved.begin();
    for (const auto& each : known) {
        all.push_back(each ? *each : *next++);
    }
    return all;
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
