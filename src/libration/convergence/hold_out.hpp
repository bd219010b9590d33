// How well the coefficients of a list are predicted by those before them, and the one that the others contradict.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "libration/convergence/verdict.hpp"

namespace libration::convergence {

/// b_(N+1) .. b_(N+count), as far as three tracks predict them.
std::vector<predicted_coefficient> predictions(std::span<const mpfr> b, int count, const task_runner& run);

/// log10 of the relative error with which b_n is predicted from b_0 .. b_(n-1), by the best quarter of nine tracks, for
/// n = N/3 .. N; that of the working precision where they satisfy an exact equation. The list is known to `noise` of its
/// size.
std::map<int, double> prediction_errors(std::span<const mpfr> b, int first, double noise, const task_runner& run);

/// The coefficient whose replacement by its prediction makes the following ones predictable again.
std::optional<suspect_coefficient> find_suspect(std::span<const mpfr> b, const std::map<int, double>& errors,
                                                double noise, const task_runner& run);

}  // namespace libration::convergence
