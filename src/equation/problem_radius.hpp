// Proved bounds of the radius of convergence of any differential equation as a table and in words.
#pragma once

#include <string>

#include "libration/ode/proved/proved_singularity.hpp"
#include "text/table.hpp"

namespace libration {

/// lower,upper,digits,rigour, and how it was proved for people.
struct proved_radius_answer {
    table data;
    std::string text;
};

/// The bounds agree to so many digits (ode::prove_radius), and are printed outwards; inf, inf for a linear equation
/// with entire coefficients. Throws error of the kind undecided with what is proved, where that is less.
/// With `check` the bounds are compared with those of a second proof: throws std::runtime_error where they exclude each
/// other.
proved_radius_answer proved_radius_of(const ode::explicit_system& system, long digits, bool check = false);

/// What shows that a singularity is there, and that it is a pole where that is proved, in words.
std::string words_of_evidence(const ode::explicit_system& system, const ode::proved_singularity& proved);

}  // namespace libration
