// The heuristic verdict on the coefficients, compared with a proved radius of convergence.
#pragma once

#include <optional>
#include <string>

#include "libration/problem/solution.hpp"

namespace libration {

/// The verdict of `libration radius` without --prove, and what proved bounds say of it: `holds` if its interval contains
/// them, `contradicted` if it has no common point with them, `consistent` if they leave it open, `none` without a radius.
struct judged_verdict {
    std::string radius, uncertainty, judgement;

    /// `heuristic  1.5 +- 1e-20 from the coefficients up to t^100: holds`.
    std::string text() const;
};

/// The judgement of the verdict on the coefficients up to the usual order by lower <= R and, if there is one, R <= upper,
/// proved to `digits` digits: those of the verdict, at most 30.
judged_verdict judge_verdict(const solution& of, long digits, const std::string& lower,
                             const std::optional<std::string>& upper, const task_runner& run = run_in_order);

}  // namespace libration
