#include "libration/digits/precision_loop.hpp"

#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration {

namespace {

constexpr long most_bits_of_proof = 1'000'000;

// The maximum number of runs, each with twice the bits, that do not distinguish a value from 0.
constexpr int usual_runs_at_zero = 3;
constexpr int most_runs_at_zero = 6;
// The steps of a short run times the square of its bits; about a second.
constexpr double most_work_at_zero = 1L << 23;
// Of so many values that contain 0 of which a run shows some, the bits for all are predicted; not for a run of more work.
constexpr long least_open_values = 4;
constexpr double most_work_of_prediction = 1L << 27;
constexpr int most_predictions = 3;

}  // namespace

void improve(known_value& kept, const ball& now, long digits) {
    if (!kept.decimal) {
        kept.decimal = to_proved_decimal(now, digits);
        kept.bound = kept.decimal || !is_finite(now) ? "" : bound_text(now);
    }
}

void run_demand::improve(known_value& kept, const ball& now, const std::string& of, const std::string& name) {
    libration::improve(kept, now, digits_);
    if (kept.decimal) {
        return;
    }
    if (!is_finite(now) || !contains_zero(now)) {
        const long lacking = bits_of_digits(digits_ - proved_digits(now, digits_));
        more_bits(now_.bits + lacking + now_.bits / 32 + 8, of);
        return;
    }
    if (!at_zero_) {
        const std::string undecided = std::to_string(now_.bits) + " bits do not distinguish from 0";
        at_zero_ = {of, name.empty()
                            ? "has a value that " + undecided
                            : "has a value of " + name + " that " + undecided + ": |" + name + "| < " + kept.bound};
        now_open_ = {of, 0, now_.bits};
    }
    now_open_.count += now_open_.of == of ? 1 : 0;
}

void run_demand::improve(std::vector<known_value>& kept, const std::vector<ball>& now, const std::string& of,
                         const std::vector<std::string>& names) {
    kept.resize(now.size());
    for (std::size_t k = 0; k < now.size(); ++k) {
        improve(kept[k], now[k], of, names[k]);
    }
}

void run_demand::more_bits(long bits, const std::string& of) {
    repeats_ = true;
    if (bits > next_.bits) {
        next_.bits = bits;
        of_ = of;
    }
}

void run_demand::more_error_bits(const std::string& of) {
    next_.error_bits = 2 * now_.error_bits;
    more_bits(now_.bits + next_.error_bits / 4, of);
}

void run_demand::ended_part_way(double part, const std::string& of) {
    constexpr double largest_growth = 6;
    const double growth = part > 0 ? std::min(1.05 / part, largest_growth) : largest_growth;
    const auto extrapolated = static_cast<long>(growth * static_cast<double>(now_.bits));
    more_bits(std::max(now_.bits + now_.bits / 4, extrapolated + bits_of_first_run(digits_)), of);
}

void run_demand::ended_by_steady_loss(double part, const std::string& of) {
    constexpr double largest_growth = 8;
    constexpr double margin = 1.05;
    constexpr long bits_left = 24;  // where the errors became too wide
    const double times = part > 0 ? std::min(margin / part, largest_growth) : largest_growth;
    const auto lost = static_cast<long>(times * static_cast<double>(now_.bits - bits_left));
    more_bits(std::max(now_.bits + now_.bits / 4, lost + bits_left + bits_of_digits(digits_)), of);
}

void run_demand::undecided(const std::string& of, const std::string& reason, long most) {
    2 * now_.bits <= most ? twice_the_bits(of) : ended(of, reason);
}

void run_demand::ended(const std::string& of, const std::string& reason) {
    if (!missing_) {
        missing_ = error(error_kind::undecided, subject_, of, reason);
    }
}

void run_demand::begin(const run_bits& with) {
    now_ = next_ = with;
    repeats_ = false;
    at_zero_.reset();
    open_before_ = std::exchange(now_open_, {});
    steps_ = 0;
}

// Of values that become smaller one after the other, as far from the ends of a chain, each further bit shows as many as
// those since the run before: a tenth more of what that predicts, and the digits. A prediction that left more than a
// quarter of them was not of this kind.
std::optional<long> run_demand::bits_for_open_values() const {
    const long shown = open_before_.count - now_open_.count;
    if (predictions_ == most_predictions || (predictions_ > 0 && 4 * now_open_.count > open_before_.count) ||
        open_before_.of != now_open_.of || open_before_.count < least_open_values || shown <= 0 ||
        now_open_.bits <= open_before_.bits) {
        return std::nullopt;
    }
    const double predicted = 1.1 * static_cast<double>(now_open_.bits - open_before_.bits) *
                             static_cast<double>(now_open_.count) / static_cast<double>(shown);
    const double all = static_cast<double>(now_open_.bits + bits_of_digits(digits_)) + predicted;
    return static_cast<double>(steps_) * all * all <= most_work_of_prediction ? std::optional(static_cast<long>(all))
                                                                              : std::nullopt;
}

// Whether values that contain 0 need another run, if nothing else does. Where several runs had both, values that contain 0
// and others that lack bits, each run shows further ones that lack bits: then twice as many bits, in few more runs.
void run_demand::finish() {
    if (!at_zero_) {
        return;
    }
    if (const auto predicted = bits_for_open_values()) {
        ++predictions_;
        more_bits(*predicted, at_zero_->of);
        return;
    }
    const double next = 2 * static_cast<double>(now_.bits);
    const bool is_short = static_cast<double>(steps_) * next * next <= most_work_at_zero;
    const int most_runs = predictions_ > 0 ? 1 : is_short ? most_runs_at_zero : usual_runs_at_zero;
    if (repeats_) {
        constexpr int runs_by_demand = 3;
        if (++runs_with_both_ >= runs_by_demand + most_runs) {
            repeats_ = false;
            ended(at_zero_->of, at_zero_->reason);
        } else if (runs_with_both_ > runs_by_demand) {
            twice_the_bits(at_zero_->of);
        }
        return;
    }
    if (++runs_at_zero_ < most_runs) {
        twice_the_bits(at_zero_->of);
    } else {
        ended(at_zero_->of, at_zero_->reason);
    }
}

std::optional<error> prove_digits(long digits, const subject_name& subject,
                                  const std::function<void(const run_bits&, run_demand&)>& run, run_bits first) {
    first.bits = first.bits == 0 ? bits_of_first_run(digits) : first.bits;
    run_demand demand(digits, subject);
    demand.next_ = first;
    const auto thrown = undecided_in([&] {
        const long last = std::max(first.bits, most_bits_of_proof);
        const auto done = with_more_precision(first.bits, last, [&](long& bits) {
            demand.begin(demand.next_);
            run(demand.now_, demand);
            demand.finish();
            bits = demand.next_.bits;
            return demand.repeats_ ? std::nullopt : std::optional(true);
        });
        if (!done) {
            demand.ended(demand.of_, "is not proved by a million bits");
        }
    });
    return demand.missing_ ? demand.missing_ : thrown;
}

}  // namespace libration
