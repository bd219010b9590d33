// Proved bounds of the radius of convergence of any differential equation as a table and in words.
#pragma once

#include <string>

#include "libration/ode/proved/proved_singularity.hpp"
#include "text/table.hpp"

namespace libration {

/// lower,upper,digits,rigour, and a description of the proof in words.
struct proved_radius_answer {
    table data;
    std::string text;
};

/// The bounds agree to this number of digits (ode::prove_radius), and are rounded outwards when printed; inf, inf for a
/// linear equation with entire coefficients. Throws error of the kind undecided with the proved bounds if they agree
/// less. With `check` the bounds are compared with those of a second proof: throws std::runtime_error if they exclude
/// each other.
proved_radius_answer proved_radius_of(const ode::explicit_system& system, long digits, bool check = false);

/// The evidence for the singularity, and for its being a pole if that is proved, in words.
std::string words_of_evidence(const ode::explicit_system& system, const ode::proved_singularity& proved);

}  // namespace libration
