#include "certificate.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "certificate_limits.hpp"
#include "certificate_problem.hpp"
#include "certificate_zeros.hpp"
#include "certified_run.hpp"
#include "libration/digits/precision_loop.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/decimal.hpp"
#include "negative_powers.hpp"
#include "varied_form.hpp"

namespace libration::ode {

namespace {

constexpr int most_certificate_runs = 12;
constexpr long most_certificate_bits = 4096;
constexpr long guard_of_first_run = 8;
// After a run that does not reach the last time.
constexpr long least_increase = 24;
// The initial values have so many bits more than the bounds of the program that checks.
constexpr long more_bits_of_start = 64;
constexpr double large_slowest_fast = 8;
constexpr long worthwhile_bits = 10;

// The number of bits that an enclosure lacks to be inside an interval, 0 if it is.
long lacking_bits(const ball& value, const decimal_interval& in) {
    const ball low = from_rational<ball>(in.low);
    const ball high = from_rational<ball>(in.high);
    if (certainly_less(low, value) && certainly_less(value, high)) {
        return 0;
    }
    const ball centre = midpoint_alone(value);
    const magnitude room = std::min(magnitude::below(centre - low), magnitude::below(high - centre));
    const double lacking = room.is_zero() ? 4 : log_of(magnitude::radius_of(value)) - log_of(room);
    return std::max(2L, static_cast<long>(std::ceil(std::min(lacking, 1e4))) + 1);
}

// The statement in the order in which an integration reaches its parts.
class claimed_statement {
public:
    claimed_statement(const explicit_system& system, std::vector<std::string> names, const certified_statement& of)
        : names_(std::move(names)), zeros_(of.zeros), form_(lifted_with(system, conditions_of(of))) {
        if (of.varied) {
            form_.form = with_derivatives(form_.form);
        }
        const rational origin = *system.point().fraction();
        bool before = false;
        bool after = false;
        for (const claimed_value& each : of.values) {
            const rational time = time_of(each);
            before = before || time < origin;
            after = after || time > origin;
            ordered_.push_back(&each);
        }
        if (before && after) {
            throw error(error_kind::argument, error_subject::certificate, "",
                        "is for times in one direction, and these are on both sides of the initial point: write two");
        }
        std::ranges::stable_sort(ordered_, {}, [&](const claimed_value* each) { return abs(time_of(*each) - origin); });
        vanishes_ = zeros_ && holds_at_start(system, zeros_->condition);
    }

    const polynomial_form& form() const { return form_.form; }
    rational last_time() const { return zeros_ ? zeros_->times.back().high : time_of(*ordered_.back()); }
    bool has_zeros() const { return zeros_.has_value(); }

    // The largest number of bits that the statement lacks after a run; std::nullopt if the run ends before.
    std::optional<long> lacking_bits_of(certified_run& by, const certificate_watch& watch) {
        const precision_scope scope(decimal_digits(by.bits_of_bounds()));
        if (!by.begin(last_time())) {
            return std::nullopt;
        }
        if (zeros_) {
            return lacking_bits_of_zeros(by, watch);
        }
        long lacking = 0;
        for (const claimed_value* each : ordered_) {
            const ball first = from_rational<ball>(each->time);
            const auto state = by.at(each->until ? hull(first, from_rational<ball>(*each->until)) : first, watch);
            if (!state) {
                return std::nullopt;
            }
            lacking = std::max(lacking, lacking_bits((*state)[each->place], each->in));
        }
        return lacking;
    }

    // The zeros are those of the last run.
    std::string text() const {
        std::string lines = zero_lines_;
        for (const claimed_value* each : ordered_) {
            lines += "claim " + text_of_time(*each) + " " + names_[each->place] + " " + each->in.lower + " " +
                     each->in.upper + "\n";
        }
        return lines;
    }

private:
    static std::vector<expression> conditions_of(const certified_statement& of) {
        return of.zeros ? std::vector{of.zeros->condition} : std::vector<expression>();
    }
    rational time_of(const claimed_value& value) const {
        return value.zero ? (zeros_->times[*value.zero].low + zeros_->times[*value.zero].high) / 2
                          : value.until.value_or(value.time);
    }
    static std::string time_text(const rational& time) { return to_finite_decimal(time).value_or(time.str()); }
    static std::string text_of_time(const claimed_value& value) {
        return value.zero    ? "#" + std::to_string(*value.zero + 1)
               : value.until ? time_text(value.time) + ":" + time_text(*value.until)
                             : value.time.str();
    }

    // Ends where the zeros are not isolated, since another run is needed then.
    std::optional<long> lacking_bits_of_zeros(certified_run& by, const certificate_watch& watch) {
        zeros_on_steps zeros(*zeros_, form_, vanishes_, by.bits_of_bounds());
        long lacking = 0;
        for (;;) {
            if (const long missing = zeros.lacking_bits_in(by.tube(), by.begin_of_step()); missing > 0) {
                return std::max(lacking, missing);
            }
            for (const claimed_value* each : ordered_) {
                if (const auto state = zeros.values_at(*each->zero, by.tube())) {
                    lacking = std::max(lacking, lacking_bits((*state)[each->place], each->in));
                }
            }
            if (zeros.complete()) {
                zero_lines_ = zeros.text();
                return lacking;
            }
            if (!by.advance(watch)) {
                return std::nullopt;
            }
        }
    }

    std::vector<std::string> names_;
    std::vector<const claimed_value*> ordered_;
    const std::optional<certified_zeros>& zeros_;
    lifted_functions form_;
    bool vanishes_ = false;
    std::string zero_lines_;
};

// The limit between slow and fast modes with which fewer bits are lost.
double better_limit(const explicit_system& system, claimed_statement& statement, run_choice choice,
                    const certificate_watch& watch) {
    const auto lacking_with = [&](double limit) {
        choice.slowest_fast = limit;
        certified_run by(system, statement.form(), choice);
        return statement.lacking_bits_of(by, watch);
    };
    const auto usual = lacking_with(collocation_integrator::usual_slowest_fast);
    if (usual && *usual < worthwhile_bits) {
        return collocation_integrator::usual_slowest_fast;
    }
    const auto large = lacking_with(large_slowest_fast);
    return large && (!usual || *large < *usual) ? large_slowest_fast : collocation_integrator::usual_slowest_fast;
}

}  // namespace

std::string certificate_of(const explicit_system& typed, const certified_statement& statement, long digits,
                           const std::function<void(const ball& reached, long bits)>& watch) {
    const explicit_system system = with_negative_powers(typed);
    claimed_statement claimed(system, certified_names(system, statement), statement);
    const std::string head = problem_of_certificate(system, claimed.form(), statement);
    run_choice choice{.bits = std::lround(static_cast<double>(digits) * std::log2(10.)) + guard_of_first_run,
                      .keeps_tubes = claimed.has_zeros(),
                      .starts = statement.starts,
                      .varied = statement.varied};
    choice.slowest_fast = better_limit(system, claimed, choice, watch);
    int runs = 0;
    auto text = with_more_precision(choice.bits, most_certificate_bits, [&](long& bits) -> std::optional<std::string> {
        certified_run by(system, claimed.form(), choice);
        const auto lacking = claimed.lacking_bits_of(by, watch);
        const long bits_of_start = by.bits_of_bounds() + more_bits_of_start;
        const bool is_within = bits_of_start <= most_certified_bits;
        if (is_within && choice.rounds && lacking == 0) {
            return "libration-certificate 1\n" + head + "bits " + std::to_string(by.bits_of_bounds()) + " " +
                   std::to_string(bits_of_start) + "\n" + claimed.text() + "steps " + std::to_string(by.steps()) +
                   "\n" + by.text() + "end\n";
        }
        choice.rounds = lacking == 0;
        choice.bits += lacking.value_or(std::max(choice.bits / 4, least_increase));
        bits = is_within && ++runs < most_certificate_runs ? choice.bits : most_certificate_bits + 1;
        return std::nullopt;
    });
    if (!text) {
        throw error(error_kind::undecided, error_subject::certificate, claimed.last_time().str(),
                    "has values that are not proved by collocation within the limits of the precision, or steps that "
                    "are not: ask for fewer digits or an earlier time");
    }
    return *std::move(text);
}

}  // namespace libration::ode
