#include "libration/problem/known/pendulum_solution.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>

#include "../../pendulum/given_question.hpp"
#include "../taylor_solution.hpp"
#include "closed_form_states.hpp"
#include "known_problems.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/pendulum/point_coefficients.hpp"
#include "libration/pendulum/proved_states.hpp"
#include "libration/pendulum/proved_times.hpp"
#include "libration/pendulum/sampler.hpp"
#include "libration/plane/proved_singularity.hpp"
#include "libration/problem/axis.hpp"
#include "libration/problem/proved_law.hpp"
#include "libration/scalar/decimal.hpp"
#include "motion_series.hpp"

namespace libration {

namespace {

using pendulum::motion;

class pendulum_sampler : public double_sampler {
public:
    explicit pendulum_sampler(const motion& m) : of_(m) {}

    bool reaches(std::span<const double> times) const override { return of_.reaches(times); }
    void at(std::span<const double> times, std::span<double* const> quantities) const override {
        of_(times, {quantities[0], times.size()}, {quantities[1], times.size()});
    }

private:
    pendulum::sampler<double> of_;
};

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
    answer states_along(const complex_path_request& along, const request& how) const override {
        return general("in the complex plane").states_along(along, how);
    }
    std::optional<answer> constants(const request& how, const constants_request& of) const override;
    // Times and order of the quantities are those of the motion.
    std::unique_ptr<double_sampler> sampler() const override {
        return general_ ? nullptr : std::make_unique<pendulum_sampler>(motion_);
    }
    answer limits(const request& how) const override { return general("at infinite time").limits(how); }
    using solution::events;
    answer events(const ode::event_request& of, const request& how, const ode::event_watch& watch) const override {
        return general("for events").events(of, how, watch);
    }
    ode::expression condition(const std::string& text) const override { return general("for events").condition(text); }
    using solution::series;
    void require_point(const std::string& about) const override;
    std::string form_of_points() const override;
    answer series(const series_request& of, const request& how) const override;
    std::optional<answer> fractions(const series_request& of) const override {
        return general_ ? general_->fractions(of) : std::nullopt;
    }
    std::vector<unknown_series> coefficient_lists(const series_request& of, const scalar_spec& scalar) const override;
    std::optional<mpfr> exact_radius(const std::string& about, long digits) const override;
    answer singularities(const std::optional<double>& within, const request& how) const override {
        return general("for the singularities").singularities(within, how);
    }
    proved_law law(const law_question& asked, const request& how) const override {
        return general("for the law of coefficients").law(asked, how);
    }
    answer proved_radius(const series_request& of, const request& how) const override;

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
    ode::solution_state<mpfr> state_of_drift(const exact& time, long digits) const;
    pendulum::expansion_point point_of(const std::string& about) const;
    bool has_series(const series_request& of, const request& how) const;

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

std::optional<answer> pendulum_solution::constants(const request& how, const constants_request& of) const {
    static const std::vector<std::string> all{"energy", "gap", "period", "tstar", "radius"};
    const auto& names = of.names.empty() ? all : of.names;
    std::vector<pendulum::motion_constant> which;
    for (const std::string& name : names) {
        const auto found = std::ranges::find(all, name);
        if (found == all.end()) {
            throw error(error_kind::argument, "constant", name, "is not energy, gap, period, tstar or radius");
        }
        which.push_back(static_cast<pendulum::motion_constant>(found - all.begin()));
    }
    const auto about = of.about.empty() ? std::nullopt : std::optional(point_of(of.about));
    answer result{.names = names, .rows = {{}}, .rigour = "proved"};
    for (const proved_decimal& each : states_to(how.printed_digits()).constants(which, about)) {
        result.rows[0].push_back({each.text, each.uncertainty});
    }
    return result;
}

std::vector<std::string> pendulum_solution::times_in_decimals(const std::vector<exact>& times, long digits) const {
    const auto needs_period = [](const exact& time) { return time.has_periods() && !time.is_zero(); };
    std::vector<exact> with_period;
    std::ranges::copy_if(times, std::back_inserter(with_period), needs_period);
    const auto proved =
        with_period.empty() ? std::vector<std::string>() : pendulum::proved_times(motion_, with_period, digits);
    auto next = proved.begin();
    std::vector<std::string> decimals;
    decimals.reserve(times.size());
    for (const exact& time : times) {
        decimals.push_back(needs_period(time) ? *next++ : decimal_of(time, digits));
    }
    return decimals;
}

std::vector<answer_value> pendulum_solution::state_at(pendulum::proved_states& states, const exact& time,
                                                      bool check) const {
    pendulum::require_time(motion_, time);
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
    if (!how.derivatives.empty()) {
        return general("for derivatives").states(times, how);
    }
    pendulum::proved_states& states = states_to(how.printed_digits());
    const bool drifting =
        how.scalar.kind == scalar_kind::arbitrary && general_ && !general_->system().invariants().empty();
    const ode::solution_state<mpfr> without_values(1);
    std::vector<ode::solution_state<mpfr>> of_drifts;
    answer result = closed_form_states(closed_form(), quantities(), times, how, [&](const exact& time) {
        auto& drift = of_drifts.emplace_back(without_values);
        try {
            closed_form_row row{state_at(states, time, how.check)};
            if (drifting) {
                drift = state_of_drift(time, how.printed_digits());
            }
            return row;
        } catch (const error& problem) {
            if (problem.kind() == error_kind::range) {
                throw error(error_kind::range, error_subject::time, time.text,
                            "has an angular velocity that is too small to be printed");
            }
            throw;
        }
    });
    if (drifting) {
        of_drifts.resize(times.size(), without_values);
        result.drifts = general_->drifts(times, of_drifts, how.printed_digits());
    }
    return result;
}

// For invariants stated in the problem: with more digits than those of the result.
ode::solution_state<mpfr> pendulum_solution::state_of_drift(const exact& time, long digits) const {
    constexpr long more = 20;
    const precision_scope scope(digits + 2 * more);
    const auto values = state_at(states_to(digits + more), time, false);
    const mpfr first(values[0].text);
    const mpfr second(values[1].text);
    return second_order_ ? ode::solution_state<mpfr>{{first, second}} : ode::solution_state<mpfr>{{first}, {second}};
}

void pendulum_solution::require_point(const std::string& about) const {
    if (general_) {
        general_->require_point(about);
    } else if (!about.empty()) {
        pendulum::point_of_motion(motion_, about);
    }
}

std::string pendulum_solution::form_of_points() const {
    if (general_) {
        return general_->form_of_points();
    }
    return pendulum::at_critical_energy(motion_.regime()) ? "bottom, start or a time without T"
                                                          : "top, bottom, start or a time such as 1.1 or T/8";
}

// The time of the equations in a text; std::nullopt if it is complex.
std::optional<exact> real_time(const std::string& about) {
    const ode::complex_constant point = point_in(about);
    return exactly(point.im, "").is_zero() ? std::optional(exactly(point.re, about)) : std::nullopt;
}

// The names of points of a motion are not times of an equation.
pendulum::expansion_point pendulum_solution::point_of(const std::string& about) const {
    if (about.empty()) {
        return {pendulum::expansion_point::place::start, {}};
    }
    if (!general_) {
        return pendulum::point_of_motion(motion_, about);
    }
    const auto time = real_time(about);
    if (!time) {
        throw error(error_kind::argument, error_subject::point, about,
                    "is not real, and the closed form of the pendulum is for real times: write a real time");
    }
    return {pendulum::expansion_point::place::time, since_start(*time)};
}

// Whether a point is a real time of the equations, or the initial one.
bool is_real(const std::string& about) { return about.empty() || real_time(about); }

// Whether the coefficients of theta alone, at a real time and without a second proof, are the answer.
bool pendulum_solution::has_series(const series_request& of, const request& how) const {
    const bool correct = how.scalar.kind == scalar_kind::proved || how.scalar.kind == scalar_kind::arbitrary;
    return !general_ || (correct && second_order_ && of.corners.empty() && is_real(of.about) && !how.check);
}

answer pendulum_solution::series(const series_request& of, const request& how) const {
    if (!has_series(of, how)) {
        return general_->series(of, how);
    }
    if (!of.corners.empty() || how.check) {
        general(how.check ? "for a second proof" : "along a path");
    }
    const auto values = printed_coefficients(motion_, point_of(of.about), of, how);
    const bool proved = how.scalar.kind == scalar_kind::proved;
    const bool agreed = how.scalar.kind == scalar_kind::arbitrary;
    answer result{.names = {"n", angle_},
                  .rows = {},
                  .rigour = proved   ? "proved"
                            : agreed ? "two-method"
                                     : "heuristic"};
    for (const printed_number& each : values) {
        const long n = of.first + static_cast<long>(result.rows.size());
        result.rows.push_back({whole_value(n), {each.text, proved ? each.uncertainty : ""}});
    }
    return result;
}

std::vector<unknown_series> pendulum_solution::coefficient_lists(const series_request& of,
                                                                 const scalar_spec& scalar) const {
    if (general_) {
        return general_->coefficient_lists(of, scalar);
    }
    auto values = coefficient_values(motion_, point_of(of.about), of, scalar);
    return {{angle_, {{{series::power_series<mpfr>(std::move(values))}}, 1}}};
}

std::optional<mpfr> pendulum_solution::exact_radius(const std::string& about, long digits) const {
    return general_ && !is_real(about) ? std::nullopt
                                       : std::optional(radius_to_digits(motion_, point_of(about), digits));
}

answer pendulum_solution::proved_radius(const series_request& of, const request& how) const {
    const long digits = how.printed_digits();
    if (how.check) {
        return general("for a second proof").radius(of, how);
    }
    const ode::proved_radius bounds = radius_bounds(motion_, point_of(of.about), digits);
    const auto [lower, upper] = ode::outward_decimals(bounds, digits);
    const std::string lattice = "the singularities are a lattice in closed form";
    answer result{.names = {"lower", "upper"}, .rows = {{{lower, ""}, {upper, ""}}}, .rigour = "proved", .notes = {}};
    if (bounds.infinite) {
        result.notes = {{"radius", "the motion is constant"}};
    } else {
        result.notes = {{"lower", lattice}, {"upper", lattice}};
    }
    return result;
}

}  // namespace

std::unique_ptr<solution> solution_of(const motion& m) { return std::make_unique<pendulum_solution>(m); }

std::unique_ptr<solution> solution_of(const pendulum::given_motion& given) { return solution_of(exact_motion(given)); }

known_facts facts_of_pendulum() {
    return {.problem = "pendulum",
            .closed_form = [](const ode::equation_system& equations) -> std::unique_ptr<solution> {
                auto found = recognise_pendulum(equations);
                return found ? std::make_unique<pendulum_solution>(equations, std::move(*found)) : nullptr;
            }};
}

}  // namespace libration
