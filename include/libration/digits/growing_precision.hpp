// The single loop over the working precision: a computation is repeated with more digits until it reports that they
// suffice. There is always a last precision; a case that it leaves open is an error of the kind undecided, never a
// longer wait.
#pragma once

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>

#include "libration/scalar/precision.hpp"
#include "libration/scalar/proved.hpp"

namespace libration {

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

/// Throws the error of the kind undecided: "SUBJECT is not decided by DIGITS digits".
[[noreturn]] void refuse_undecided(const std::string& subject, long digits);

/// The first result of attempt(precision_run), a std::optional, in a precision_scope of the run's digits; std::nullopt
/// and precision_exhausted request another run. `subject` names the quantity that is undecided after all runs. Cost:
/// with digit_growth::twofold at most a small multiple of the last run.
/// Throws error of the kind undecided after the last run, and whatever else attempt throws.
template <class Attempt>
auto with_growing_precision(const growing_digits& digits, const std::string& subject, Attempt&& attempt) ->
    typename std::invoke_result_t<Attempt&, const precision_run&>::value_type {
    long used = digits.wanted + digits.first;
    for (long more = digits.first; more <= digits.last; more = digits.after(more)) {
        used = digits.wanted + more;
        const precision_scope scope(used);
        try {
            if (auto answer = attempt(precision_run{more, digits.after(more) > digits.last})) {
                return *std::move(answer);
            }
        } catch (const precision_exhausted&) {
            continue;
        }
    }
    refuse_undecided(subject, used);
}

/// For a computation that determines how many digits it needs: an attempt(digits) without a result stores in
/// `digits` the number for the next run, which has at least one more. The first run has `first`, none has more than
/// `last`.
template <class Attempt>
auto with_asked_precision(long first, long last, const std::string& subject, Attempt&& attempt) ->
    typename std::invoke_result_t<Attempt&, long&>::value_type {
    long used = first;
    for (long next = first; next <= last; next = std::max(next, used + 1)) {
        used = next;
        const precision_scope scope(used);
        if (auto answer = attempt(next)) {
            return *std::move(answer);
        }
    }
    refuse_undecided(subject, used);
}

}  // namespace libration
