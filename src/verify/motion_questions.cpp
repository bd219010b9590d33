#include "verify/motion_questions.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "libration/pendulum/energy/energy.hpp"
#include "libration/pendulum/time/dimensionless_time.hpp"
#include "libration/scalar/text/decimal.hpp"
#include "text/input_error.hpp"

namespace libration {

using namespace pendulum;

namespace {

constexpr std::size_t most_known_motions = 4;

// The e of |t| < 2^e.
long exponent_of(const exact& time) {
    const precision_scope scope(20);
    if (time.is_zero()) {
        return 0;
    }
    if (time.measure == unit::expression) {
        return std::max(binary_exponent(from_exact<mpfr>(time.without_periods())),
                        binary_exponent(from_rational<mpfr>(time.periods())) + 3);
    }
    return binary_exponent(from_rational<mpfr>(time.coefficient)) + (time.measure == unit::one ? 0 : 3);
}

// The root of a fraction where it is one.
std::optional<rational> rational_root(const rational& square) {
    if (square < 0) {
        return std::nullopt;
    }
    const rational root(sqrt(numerator(square)), sqrt(denominator(square)));
    return root * root == square ? std::optional(root) : std::nullopt;
}

// omega0 in the units of the motion, where it is a fraction.
std::optional<rational> exact_speed(const typed_motion& typed, const motion& m) {
    if (typed.omega0) {
        return typed.omega0->is_fraction() ? std::optional(typed.omega0->coefficient) : std::nullopt;
    }
    const auto squared = m.omega0_squared();
    if (!squared || !typed.squared_frequency.is_fraction()) {
        return std::nullopt;
    }
    const auto root = rational_root(*squared * typed.squared_frequency.coefficient);
    return root ? std::optional(rational(*root * m.omega0_sign())) : std::nullopt;
}

// theta and omega where the start, or its image half a period later in libration, makes them fractions.
std::pair<std::optional<rational>, std::optional<rational>> exact_state(const typed_motion& typed, const motion& m,
                                                                        const exact& time) {
    if (!time.only_periods() || (!time.is_zero() && at_critical_energy(m.regime()))) {
        return {};
    }
    std::optional<rational> theta;
    if (m.theta0() && m.theta0()->is_fraction()) {
        theta = m.theta0()->coefficient;
    }
    auto omega = exact_speed(typed, m);
    if (time.is_zero()) {
        return {theta, omega};
    }
    const bool swings = m.regime() == regime::libration;
    const rational halves = time.coefficient * 2;
    if (denominator(halves) != 1 || (!swings && numerator(halves) % 2 != 0)) {
        return {};
    }
    if (numerator(halves) % 2 != 0) {
        theta = theta && m.turns() == 0 ? std::optional(rational(-*theta)) : std::nullopt;
        omega = omega ? std::optional(rational(-*omega)) : std::nullopt;
    }
    return {swings ? theta : std::nullopt, omega};
}

// The largest |theta| of libration, pi beyond; the largest |omega|. At rest 1 and 1 in their units.
std::pair<mpfr, mpfr> scales_of(const motion& m) {
    const precision_scope scope(20);
    const mpfr unit = 1 / time_unit<mpfr>(m);
    if (m.regime() == regime::stable_equilibrium || m.regime() == regime::unstable_equilibrium) {
        return {mpfr(1), unit};
    }
    const mpfr energy = energies<mpfr>(m).energy;
    return {m.regime() == regime::libration ? mpfr(asin(sqrt(mpfr(energy / 2))) * 2) : pi<mpfr>(),
            mpfr(sqrt(mpfr(energy * 2)) * unit)};
}

}  // namespace

std::vector<known_column> motion_layout::known() {
    auto columns = time_columns::known();
    const auto of_motion = motion_columns::known();
    columns.insert(columns.end(), of_motion.begin(), of_motion.end());
    columns.push_back({"theta", {"theta", "θ", "angle"}});
    columns.push_back(
        {"omega",
         {"omega", "ω", "thetadot", "dtheta", "dthetadt", "dtheta/dt", "theta'", "angularvelocity", "velocity"}});
    return columns;
}

bool motion_layout::fits(const column_names& names) {
    return names.find("time").has_value() || names.find("theta").has_value();
}

motion_layout::motion_layout(const column_names& names, motion_cells usual)
    : time_(names), motion_(names), usual_(std::move(usual)) {
    std::vector<std::string> missing;
    if (!time_.there()) {
        missing.emplace_back("time");
    }
    const auto theta = names.find("theta");
    const auto omega = names.find("omega");
    if (!theta) {
        missing.emplace_back("theta");
    }
    if (!missing.empty()) {
        throw input_error(fmt::format("{} has no column {}: its columns are {}: {}", names.file(), listed(missing),
                                      names.listed(), mapping_remedy));
    }
    compared_.push_back({"theta", *theta});
    if (omega) {
        compared_.push_back({"omega", *omega});
    }
    if (!motion_.names_a_motion() && !usual_.names_a_motion() &&
        !(motion_.has_angle() && !usual_.omega0.text.empty()) &&
        !(motion_.has_speed() && !usual_.theta0.text.empty())) {
        throw input_error(
            fmt::format("{} has no motion: its columns are {}: {}, as 'theta0' and 'omega0', 'gap' or "
                        "'energy', or add --theta0 and --omega0, --gap or --energy",
                        names.file(), names.listed(), mapping_remedy));
    }
}

exact motion_layout::time(const std::vector<std::string>& cells, bool as_double) const {
    return reading_cell(time_.in(cells), [&](const std::string& text) {
        const exact time = time_in(text);
        return as_double && !time.has_periods() ? nearest_double(time) : time;
    });
}

motion_cells motion_layout::motion(const std::vector<std::string>& cells) const {
    motion_cells of = motion_.in(cells);
    of.complete_from(usual_);
    return of;
}

const conditioned_motion& motion_questions::known_motion::in_precision(long digits) {
    for (const auto& [made_with, made] : by_digits) {
        if (made_with == digits) {
            return *made;
        }
    }
    by_digits.emplace_back(digits, std::make_unique<conditioned_motion>(typed, exactly));
    return *by_digits.back().second;
}

std::vector<true_value> motion_questions::known_motion::at(const exact& time, long digits) {
    const enclosed_state state = in_precision(digits).of().at(time);
    const auto [theta, omega] = exact_state(typed, exactly, time);
    return {{state.theta, theta, ball(theta_scale)}, {state.omega, omega, ball(omega_scale)}};
}

motion_questions::known_motion& motion_questions::motion_for(const motion_cells& cells) {
    const std::string key = cells.key();
    const auto found = std::find_if(known_.begin(), known_.end(), [&](const auto& known) { return known->key == key; });
    if (found != known_.end()) {
        std::rotate(known_.begin(), found, found + 1);
        return *known_.front();
    }
    const typed_motion typed = cells.read(rules_.inputs_are_doubles);
    const pendulum::motion exactly = cells.motion_of(typed);
    const auto [theta_scale, omega_scale] = scales_of(exactly);
    known_.insert(known_.begin(),
                  std::make_unique<known_motion>(known_motion{key, typed, exactly, theta_scale, omega_scale}));
    known_.resize(std::min(known_.size(), most_known_motions));
    return *known_.front();
}

row_question motion_questions::read(const std::vector<std::string>& cells) {
    const exact time = layout_.time(cells, rules_.inputs_are_doubles);
    known_motion& known = motion_for(layout_.motion(cells));
    const std::size_t count = layout_.compared().size();
    row_question question;
    question.first_digits = [time, &known](long places) {
        const long time_exponent = exponent_of(time);
        const long for_truth = places + 20 + decimal_digits(std::max(0L, time_exponent));
        const long for_condition = decimal_digits(conditioned_motion::bits_for(known.exactly, time_exponent));
        return (std::max(for_truth, for_condition) + 9) / 10 * 10;
    };
    question.truths = [time, count, &known](long digits) {
        auto truths = known.at(time, digits);
        truths.resize(count);
        return truths;
    };
    question.condition = [time, &known](long digits) {
        const conditioned_motion& motion = known.in_precision(digits);
        const auto condition = motion.at(time, motion.of().at(time));
        return condition ? to_decimal(*condition, 3) : std::string("inf");
    };
    return question;
}

}  // namespace libration
