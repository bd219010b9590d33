// The one loop over precision: a computation is repeated with more bits, or digits, until nothing is missing. There is
// always a last precision; what it leaves open is an error of the kind undecided, never a longer wait.
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "libration/digits/known_value.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/precision.hpp"
#include "libration/scalar/proved.hpp"

namespace libration {

/// The bits of so many decimal digits, and a few more.
constexpr long bits_of_digits(long digits) { return digits * 3322 / 1000 + 4; }
/// Of the first run of a proof of so many digits.
constexpr long bits_of_first_run(long digits) { return bits_of_digits(digits) + 64; }

/// The first result of attempt(precision), a std::optional. An attempt without one stores in `precision` that
/// of the next attempt; beyond `last` there is none, and no result.
template <class Attempt>
std::invoke_result_t<Attempt&, long&> with_more_precision(long first, long last, Attempt&& attempt) {
    for (long precision = first; precision <= last;) {
        if (auto result = attempt(precision)) {
            return result;
        }
    }
    return std::nullopt;
}

/// The same for attempt(bits), each time with twice the bits.
template <class Attempt>
auto with_doubled_bits(long first, long last, Attempt&& attempt) {
    return with_more_precision(first, last, [&](long& bits) { return attempt(std::exchange(bits, 2 * bits)); });
}

/// The same, each time with half as many bits again, at most so many times.
template <class Attempt>
auto with_half_more_bits(long first, int attempts, Attempt&& attempt) {
    constexpr long beyond = std::numeric_limits<long>::max();
    return with_more_precision(first, beyond - 1, [&](long& bits) {
        return attempt(std::exchange(bits, --attempts > 0 ? bits + bits / 2 : beyond));
    });
}

/// attempt in a precision_scope of so many digits, each time of one more at least, also after precision_exhausted.
/// `subject` names the quantity that is undecided after all runs. Throws error of the kind undecided after the last
/// one, and whatever else attempt throws.
template <class Attempt>
auto with_asked_precision(long first, long last, const subject_name& subject, Attempt&& attempt) {
    long used = first;
    auto result = with_more_precision(first, last, [&](long& digits) -> std::invoke_result_t<Attempt&, long&> {
        used = digits;
        const precision_scope scope(used);
        try {
            if (auto answer = attempt(digits)) {
                return answer;
            }
        } catch (const precision_exhausted&) {
            // the next attempt has more digits
        }
        digits = std::max(digits, used + 1);
        return std::nullopt;
    });
    if (!result) {
        throw error(error_kind::undecided, subject, "", "is not decided by " + std::to_string(used) + " digits");
    }
    return *std::move(result);
}

/// How the number of digits grows from run to run.
enum class digit_growth {
    twofold,   ///< 1, 2, 4, 8 ... times the first
    by_half,   ///< half as many again, rounded down
    by_first,  ///< 1, 2, 3, 4 ... times the first
};

/// The working precisions of the runs, in decimal digits: `wanted` ones, which are fixed, plus `first` .. `last` ones,
/// which grow.
struct growing_digits {
    long wanted = 0;
    long first = 20;
    long last = 10'240;
    digit_growth by = digit_growth::twofold;

    /// The growing digits of the run after one with `now`, at least one more; beyond `last` there is no next run.
    long after(long now) const {
        const long more = by == digit_growth::twofold ? now : by == digit_growth::by_half ? now / 2 : first;
        return now + std::max(more, 1L);
    }
};

/// The data of a run: its growing digits, and whether another run follows.
struct precision_run {
    long more;
    bool last;
};

/// The first result of attempt(precision_run), a std::optional; otherwise as with_asked_precision. Cost: with
/// digit_growth::twofold at most a small multiple of the last run.
template <class Attempt>
auto with_growing_precision(const growing_digits& digits, const subject_name& subject, Attempt&& attempt) {
    return with_asked_precision(digits.wanted + digits.first, digits.wanted + digits.last, subject, [&](long& used) {
        const long more = used - digits.wanted;
        used = digits.wanted + digits.after(more);
        return attempt(precision_run{more, digits.after(more) > digits.last});
    });
}

/// The error of the kind undecided that ends a work, such as a second proof, after what is finished.
template <class Work>
std::optional<error> undecided_in(const Work& work) {
    try {
        work();
        return std::nullopt;
    } catch (const error& reason) {
        if (reason.kind() != error_kind::undecided) {
            throw;
        }
        return reason;
    }
}

/// The bits of a run of a proof, and those of its error maps.
struct run_bits {
    static constexpr long usual_error_bits = 64;

    long bits = 0;
    long error_bits = usual_error_bits;
};

/// What a run of a proof lacked. The largest demand sets the bits of the next run; without one the run was the
/// last. In all functions `of` is the value of the error that ends the proof (which time, which event).
class run_demand {
public:
    run_demand(long digits, subject_name subject) : digits_(digits), subject_(std::move(subject)) {}

    const run_bits& now() const { return now_; }
    /// Whether another run already follows, so that the rest of this one is not needed.
    bool repeats() const { return repeats_; }

    /// Keeps the digits that `now` proves, else a bound. A value that excludes 0 needs the bits that it lacks; one that
    /// contains 0 twice as many bits, in three runs, or in six if they are short: most of these are 0. `name` is that
    /// of the value in messages.
    void improve(known_value& kept, const ball& now, const std::string& of, const std::string& name);
    /// The same for all values of a state, each with its name.
    void improve(std::vector<known_value>& kept, const std::vector<ball>& now, const std::string& of,
                 const std::vector<std::string>& names);
    /// Further steps of this run, all of which decide whether the next one is short.
    void cost(long steps) { steps_ += steps; }
    /// No further run for the values of this one that contain 0.
    void leave_zeros() { at_zero_.reset(); }

    /// Another run with the same bits.
    void again() { repeats_ = true; }
    /// At least so many bits.
    void more_bits(long bits, const std::string& of);
    void twice_the_bits(const std::string& of) { more_bits(2 * now_.bits, of); }
    /// Twice the bits of the error maps.
    void more_error_bits(const std::string& of);
    /// The precision was exhausted at this fraction of the interval: the loss, extrapolated to the end, and a margin.
    void ended_part_way(double part, const std::string& of);
    /// The same where bits are lost in proportion to the interval: what has been lost, extrapolated, and the digits.
    void ended_by_steady_loss(double part, const std::string& of);
    /// Twice the bits for a question that more bits may decide; beyond `most` of them the reason why it is not decided.
    void undecided(const std::string& of, const std::string& reason, long most);
    /// No run helps, for this reason. The first reason of all is kept.
    void ended(const std::string& of, const std::string& reason);

private:
    friend std::optional<error> prove_digits(long digits, const subject_name& subject,
                                             const std::function<void(const run_bits&, run_demand&)>& run,
                                             run_bits first);
    void begin(const run_bits& with);
    void finish();

    struct open_value {
        std::string of, reason;
    };
    // The values that contain 0 in a run: of which time or event, how many, and the bits.
    struct open_values {
        std::string of;
        long count = 0, bits = 0;
    };
    std::optional<long> bits_for_open_values() const;

    long digits_;
    subject_name subject_;
    run_bits now_, next_;
    bool repeats_ = false;
    std::string of_;                     // of the largest demand
    std::optional<open_value> at_zero_;  // the first one of this run
    int runs_at_zero_ = 0;
    int runs_with_both_ = 0;  // values that contain 0, and others that lack bits
    long steps_ = 0;
    std::optional<error> missing_;
    open_values now_open_, open_before_;
    int predictions_ = 0;
};

/// The proof of so many digits: calls run(bits, demand) until nothing is missing or no run within the limits proves
/// more.
/// Returns the reason why digits are missing, an error of the kind undecided about `subject`: that of the demand, or
/// what run throws. The first run has the bits of `first`, or bits_of_first_run(digits). Throws every other error of
/// run.
std::optional<error> prove_digits(long digits, const subject_name& subject,
                                  const std::function<void(const run_bits& bits, run_demand& demand)>& run,
                                  run_bits first = {});

/// Replaces a value without digits by what an enclosure of it proves: `digits` digits, else a bound.
void improve(known_value& kept, const ball& now, long digits);

}  // namespace libration
