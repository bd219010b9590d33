// Solutions that conditions at infinity determine: their unknowns, states at any times, and limits.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "libration/number/exact.hpp"
#include "libration/problem/answer.hpp"
#include "libration/problem/problem.hpp"
#include "libration/scalar/printed_number.hpp"

namespace libration {

class limits_of_unknowns;

/// A problem, and the numbers that conditions at infinity determine.
struct limit_problem {
    problem of;                              ///< with values of all numbers, the first guesses
    std::vector<std::string> unknowns;       ///< parameters, or initial values as f''(0)
    std::vector<std::string> conditions;     ///< f'(inf) = 1, u(-inf) = 0; all of them at infinity
    std::vector<std::string> without_guess;  ///< the unknowns without a first guess
};

/// The names of --show and of request lists: numbers that belong to the limits.
inline const std::vector<std::string>& numbers_at_infinity() {
    static const std::vector<std::string> all{"amplitude", "rate", "limit", "angle"};
    return all;
}

/// Whether a note is one of these numbers, of a kind that is shown.
bool is_shown(const answer_note& number, const std::vector<std::string>& shown);

/// The solution of such a problem. It is found anew, with as many digits as the values at the times need.
class limit_solution {
public:
    /// Throws error like find_unknowns().
    explicit limit_solution(limit_problem of);

    /// The unknowns and their lower derivatives; of an orbit with limits at both ends those that have limits.
    const std::vector<std::string>& quantities() const { return quantities_; }

    /// name, value, kind of the unknowns, of the kind "unknown", then of the numbers of numbers_at_infinity(), with as
    /// many digits as are proved. The notes are those of find_unknowns().
    answer unknowns(const request& how) const;

    /// The quantities at times in any order, of which the texts "inf" and "-inf" are the limits, each digit proved;
    /// then the numbers of `shown` (numbers_at_infinity), the same in each row. Orbits with limits at both ends have t
    /// = 0 where the note "phase" states. Beyond the time from which on the solution is on the manifold of an
    /// equilibrium the values are those of its series (theorem W2). The notes are the unknowns, then those of
    /// find_unknowns(). A limit that is not known, and a value that is not proved with as many digits, are missing.
    /// With request.check the values are compared with a second proof.
    answer states(const std::vector<exact>& times, const std::vector<std::string>& shown, const request& how) const;

    /// `count` times with equal distances, between those before and after which every quantity with a limit is nearer
    /// to it than 1/400 of its variation; from the initial point if that is finite. Decimals.
    std::vector<exact> visible_times(long count, const request& how) const;

private:
    answer states_by(const std::vector<exact>& times, const std::vector<std::string>& shown, const request& how,
                     bool second) const;
    std::vector<answer_value> limits_of_flow(limits_of_unknowns& flow, int direction, long digits) const;
    double last_visible(int direction, double from, const request& how) const;
    std::vector<answer_note> notes_of(const std::vector<proved_decimal>& values, long digits) const;

    limit_problem of_;
    std::vector<std::string> quantities_;
    bool two_ends_ = false;
};

}  // namespace libration
