#include "libration/ode/rigorous/certificate/certificate.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "../lifted_set.hpp"
#include "../polynomial_map.hpp"
#include "certificate_problem.hpp"
#include "certificate_step.hpp"
#include "libration/ode/ball/step_pieces.hpp"
#include "libration/ode/rigorous/collocation_integrator.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

constexpr int most_certificate_runs = 12;
constexpr long most_certificate_bits = 4096;
constexpr long guard_of_first_run = 8;
constexpr double bits_of_digit = 3.3219281;
// The bounds of the program that checks are integers times 2^-S; S has so many bits more than the polynomials, and the
// initial values as many again.
constexpr long more_bits_of_bounds = 64;
constexpr double large_slowest_fast = 8;
constexpr double digits_below_width = 4;
constexpr long worthwhile_bits = 10;

using progress_callback = std::function<void(const ball& reached, long bits)>;

struct run_choice {
    long bits = 0;
    double slowest_fast = collocation_integrator::usual_slowest_fast;
    bool rounds = false;
};

std::string hexadecimal(const ball& whole) {
    fmpz_t n;
    fmpz_init(n);
    arf_get_fmpz(n, arb_midref(whole.handle()), ARF_RND_DOWN);
    char* raw = fmpz_get_str(nullptr, 16, n);
    std::string text = raw;
    flint_free(raw);
    fmpz_clear(n);
    return text;
}

// An exact number as integer times 2^-exponent.
std::pair<ball, long> mantissa_of(const ball& exact) {
    fmpz_t m;
    fmpz_t e;
    fmpz_init(m);
    fmpz_init(e);
    arf_get_fmpz_2exp(m, e, arb_midref(exact.handle()));
    std::pair<ball, long> result{ball(0), -fmpz_get_si(e)};
    arb_set_fmpz(result.first.handle(), m);
    fmpz_clear(m);
    fmpz_clear(e);
    return result;
}

template <class List, class Text>
std::string joined(const List& of, const Text& text) {
    std::string result;
    for (const auto& each : of) {
        result += (result.empty() ? "" : " ") + text(each);
    }
    return result;
}

std::string lists_text(const std::vector<integer_list>& lists) {
    std::string text;
    for (const integer_list& each : lists) {
        text += joined(each, hexadecimal) + "\n";
    }
    return text;
}

std::string radii_text(const certificate_step& step) {
    std::vector<long> exponents;
    std::vector<ball> first;
    std::vector<ball> last;
    for (std::size_t b = 0; b < step.first.size(); ++b) {
        auto [m, k] = mantissa_of(step.first[b].exact());
        auto [n, l] = mantissa_of(step.last[b].exact());
        exponents.push_back(std::max(k, l));
        first.push_back(shifted(m, exponents.back() - k));
        last.push_back(shifted(n, exponents.back() - l));
    }
    const auto number = [](long k) { return std::to_string(k); };
    return "radii " + joined(exponents, number) + "\n" + lists_text({first, last});
}

std::string text_of(const certificate_step& step) {
    const auto number = [](auto k) { return std::to_string(k); };
    const auto [length, exponent] = mantissa_of(step.length);
    return "step " + number(exponent) + "\n" + hexadecimal(length) + "\nscale " + joined(step.scales, number) +
           "\nblocks " + joined(step.blocks, number) + "\np " + number(step.curve_bits) + "\n" +
           lists_text(step.curve) + "V " + joined(step.frame_bits, number) + "\n" + lists_text(step.frame) + "U " +
           joined(step.inverse_bits, number) + "\n" + lists_text(step.inverse) + radii_text(step);
}

// One integration through all times, in order of their distance from the initial point.
class certified_run {
public:
    certified_run(const explicit_system& system, const lifted_system& form, const run_choice& choice)
        : form_(form),
          integrator_(form, choice.bits, 0, {choice.slowest_fast, digits_below_width}),
          map_(form),
          rounding_(choice.bits - guard_of_first_run, integrator_.bits() + more_bits_of_bounds) {
        bits_ = integrator_.bits() + 2L * integrator_.degree() + more_bits_of_bounds;
        if (choice.rounds) {
            integrator_.prove_by([this](tube_proof& by, const tube_candidate& found, const tube_set& start) {
                return rounding_.tube(by, found, start);
            });
        }
        const precision_scope scope(decimal_digits(bits_));
        time_ = constant_value<ball>::of(system.point());
        std::vector<magnitude> radii;
        for (const auto& values : system.starts()) {
            for (const number& each : values) {
                const ball value = constant_value<ball>::of(each);
                given_.centre.push_back(midpoint_alone(value));
                radii.push_back(magnitude::radius_of(value));
            }
        }
        given_.errors = error_set(std::move(radii));
        given_.slow = given_.centre.size();
    }

    long bits_of_bounds() const { return bits_ + more_bits_of_bounds; }
    long steps() const { return steps_; }
    const std::string& text() const { return text_; }
    long bits() const { return integrator_.bits(); }

    // False if no step is proved from the initial point on.
    bool begin(const rational& farthest) {
        const precision_scope scope(decimal_digits(bits_));
        auto set = lifted_set(form_, time_, given_);
        if (!set) {
            return false;
        }
        // The checker encloses the initial values in a box of about this size.
        std::vector<magnitude> added = set->errors.added();
        for (magnitude& each : added) {
            each += magnitude::of(1, 3 - bits_of_bounds());
        }
        set->errors = error_set(set->errors.columns(), set->errors.blocks(), set->errors.radii(), std::move(added));
        const ball rest = from_rational<ball>(farthest) - time_;
        integrator_.begin(time_, *set, first_length(set->centre, rest));
        return prepare();
    }

    // The state at a time; std::nullopt if the proof ends before.
    std::optional<std::vector<ball>> at(const rational& time, const progress_callback& watch) {
        const precision_scope scope(decimal_digits(bits_));
        for (;;) {
            const ball rest = from_rational<ball>(time) - integrator_.reached();
            if (certainly_less(abs(rest), abs(integrator_.length())) || arb_is_zero(rest.handle()) != 0) {
                return integrator_.values_at(rest);
            }
            integrator_.step();
            if (watch) {
                watch(integrator_.reached(), bits());
            }
            if (!prepare()) {
                return std::nullopt;
            }
        }
    }

    const ball& reached() const { return integrator_.reached(); }

private:
    bool prepare() {
        if (!integrator_.prepare()) {
            return false;
        }
        if (rounding_.step()) {
            text_ += text_of(*rounding_.step());
            ++steps_;
        }
        return true;
    }

    // The reciprocal of the largest derivative of f, at most the whole way; no proof depends on it.
    ball first_length(const std::vector<ball>& state, const ball& rest) const {
        std::vector<ball> constants;
        for (const number& each : map_.constants()) {
            constants.push_back(constant_value<ball>::of(each));
        }
        magnitude rate;
        for (const ball& each : map_.in(number_ring<ball>{constants, time_}, state, true).entries) {
            rate = std::max(rate, magnitude(each));
        }
        const bool backwards = arb_is_negative(rest.handle()) != 0;
        const ball whole = midpoint_alone(rest);
        if (rate.is_zero() || !rate.is_finite() || magnitude(whole) <= magnitude(1U) / rate) {
            return arb_is_zero(whole.handle()) != 0 ? ball(1) : whole;
        }
        const ball length = (magnitude(1U) / rate).exact();
        return backwards ? -length : length;
    }

    const lifted_system& form_;
    collocation_integrator integrator_;
    polynomial_map map_;
    step_rounding rounding_;
    long bits_ = 0;
    ball time_;
    tube_set given_;
    std::string text_;
    long steps_ = 0;
};

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

// The values in the order in which an integration reaches them.
class claimed_values {
public:
    claimed_values(const explicit_system& system, const std::vector<claimed_value>& values)
        : names_(names_of_state(system)) {
        const rational origin = *system.point().fraction();
        bool before = false;
        bool after = false;
        for (const claimed_value& each : values) {
            before = before || each.time < origin;
            after = after || each.time > origin;
            ordered_.push_back(&each);
        }
        if (before && after) {
            throw error(error_kind::argument, "certificate", "",
                        "is for times in one direction, and these are on both sides of the initial point: write two");
        }
        std::ranges::stable_sort(ordered_, {}, [&](const claimed_value* each) { return abs(each->time - origin); });
    }

    const rational& last_time() const { return ordered_.back()->time; }

    // The largest number of bits that a value lacks after a run; std::nullopt if the run ends before.
    std::optional<long> lacking_bits_of(certified_run& by, const progress_callback& watch) const {
        const precision_scope scope(decimal_digits(by.bits_of_bounds()));
        if (!by.begin(last_time())) {
            return std::nullopt;
        }
        long lacking = 0;
        for (const claimed_value* each : ordered_) {
            const auto state = by.at(each->time, watch);
            if (!state) {
                return std::nullopt;
            }
            lacking = std::max(lacking, lacking_bits((*state)[each->place], each->in));
        }
        return lacking;
    }

    std::string text() const {
        std::string lines;
        for (const claimed_value* each : ordered_) {
            lines += "claim " + each->time.str() + " " + names_[each->place] + " " + each->in.lower + " " +
                     each->in.upper + "\n";
        }
        return lines;
    }

private:
    std::vector<std::string> names_;
    std::vector<const claimed_value*> ordered_;
};

// The limit between slow and fast modes with which fewer bits are lost.
double better_limit(const explicit_system& system, const lifted_system& form, const claimed_values& claims,
                    run_choice choice, const progress_callback& watch) {
    const auto lacking_with = [&](double limit) {
        choice.slowest_fast = limit;
        certified_run by(system, form, choice);
        return claims.lacking_bits_of(by, watch);
    };
    const auto usual = lacking_with(collocation_integrator::usual_slowest_fast);
    if (usual && *usual < worthwhile_bits) {
        return collocation_integrator::usual_slowest_fast;
    }
    const auto large = lacking_with(large_slowest_fast);
    return large && (!usual || *large < *usual) ? large_slowest_fast : collocation_integrator::usual_slowest_fast;
}

}  // namespace

std::string certificate_of(const explicit_system& system, const std::vector<claimed_value>& values, long digits,
                           const std::function<void(const ball& reached, long bits)>& watch) {
    const lifted_system form = lifted(system);
    const std::string head = problem_of_certificate(system, form);
    const claimed_values claims(system, values);
    run_choice choice{std::lround(static_cast<double>(digits) * bits_of_digit) + guard_of_first_run};
    choice.slowest_fast = better_limit(system, form, claims, choice, watch);
    for (int run = 0; run < most_certificate_runs && choice.bits <= most_certificate_bits; ++run) {
        certified_run by(system, form, choice);
        const auto lacking = claims.lacking_bits_of(by, watch);
        if (choice.rounds && lacking == 0) {
            return "libration-certificate 1\n" + head + "bits " + std::to_string(by.bits_of_bounds()) + " " +
                   std::to_string(by.bits_of_bounds() + more_bits_of_bounds) + "\n" + claims.text() + "steps " +
                   std::to_string(by.steps()) + "\n" + by.text() + "end\n";
        }
        choice.rounds = lacking == 0;
        choice.bits += lacking.value_or(choice.bits / 4);
    }
    throw error(error_kind::undecided, "certificate", claims.last_time().str(),
                "has values that are not proved by collocation within the limits of the precision, or steps that are "
                "not: ask for fewer digits or an earlier time");
}

}  // namespace libration::ode
