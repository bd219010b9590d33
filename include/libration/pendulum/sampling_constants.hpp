// The sampler's data of a motion, as plain numbers: computed in half_cycle_clock.hpp and half_cycle_turns.hpp, which
// document their use; read by the loops over vectors.
#pragma once

#include <cstddef>

namespace libration::pendulum {

/// Panels are the 2^-panel_octave_bits parts of octaves.
inline constexpr int panel_octave_bits = 4;

/// The number of powers kept per panel in double.
inline constexpr std::size_t double_panel_terms = 12;

/// The sum of two numbers, the second below half a unit of the first's last place.
template <class T>
struct split_number {
    T high;
    T low;
};

/// Times in the unit of the panels are t per_unit, the start's passage was `start` before 0, and 2 T* is first + second
/// + third.
template <class T>
struct clock_constants {
    T per_unit;
    split_number<T> start;
    /// The largest admissible |j|.
    T largest;
    /// Adding and subtracting it rounds to integers.
    T rounder;
    T per_passage = T(0);
    T first = T(0);
    T second = T(0);
    T third = T(0);
};

/// theta = base + turn (turns + winding j) + sign (1 - alternation (j mod 2)) g(y).
template <class T>
struct turn_constants {
    split_number<T> turn;
    split_number<T> base;
    T sign;
    T turns = T(0);
    T winding = T(0);
    T alternation = T(0);
};

}  // namespace libration::pendulum
