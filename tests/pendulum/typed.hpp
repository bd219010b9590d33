// Motions and times for the tests, from texts as accepted by the command.
#pragma once

#include <string>
#include <vector>

#include "libration/pendulum/exact_solution.hpp"
#include "reference_table.hpp"

namespace libration::tests {

using namespace pendulum;

inline rational fraction(const std::string& text) { return read_exact(text).coefficient; }

inline motion with_energy(const std::string& energy, int direction = 1) {
    return motion::of_energy(fraction(energy), direction);
}

/// E = 2 - gap.
inline motion with_gap(const std::string& gap, int direction = 1) {
    const bool negative = gap.front() == '-';
    const rational size = fraction(negative ? gap.substr(1) : gap);
    return motion::of_energy(negative ? rational(2 + size) : rational(2 - size), direction);
}

inline motion with_state(const std::string& theta0, const std::string& omega0) {
    return motion::of_state(read_exact(theta0), read_exact(omega0));
}

/// The motion of a row of motions.csv or coefficients.csv.
inline motion motion_of(const table_row& row) {
    const auto cell = [&row](const std::string& name) { return row.contains(name) ? row.at(name) : std::string(); };
    if (!cell("omega0").empty()) {
        return with_state(cell("theta0"), cell("omega0"));
    }
    const rational energy = cell("energy").empty() ? rational(2 - fraction(cell("gap"))) : fraction(cell("energy"));
    const int direction = cell("direction") == "-" ? -1 : 1;
    return cell("theta0").empty() ? motion::of_energy(energy, direction)
                                  : motion::of_energy_from(energy, read_exact(cell("theta0")), direction);
}

template <class T>
pendulum_state<T> state_of(const motion& m, const std::string& time) {
    return exact_solution<T>(m)(read_exact(time));
}

/// A motion and its name, for lists of them.
struct named_motion {
    std::string name;
    motion m;
};

/// Motions of every regime that has a period, near E = 2 and far from it, through top, bottom and points between.
inline std::vector<named_motion> periodic_motions() {
    return {{"E = 1e-3", with_energy("1e-3")},
            {"E = 1.71", with_energy("1.71")},
            {"gap 1e-10", with_gap("1e-10")},
            {"gap 1e-40", with_gap("1e-40")},
            {"gap -1e-40", with_gap("-1e-40")},
            {"gap -1e-10, clockwise", with_gap("-1e-10", -1)},
            {"E = 2.02, clockwise", with_energy("2.02", -1)},
            {"E = 4", with_energy("4")},
            {"E = 1e6", with_energy("1e6")},
            {"from (2.5, -0.3)", with_state("2.5", "-0.3")},
            {"from (-1, 0.5)", with_state("-1", "0.5")},
            {"from (9.0, 0.1)", with_state("9.0", "0.1")},
            {"from (-50, -3)", with_state("-50", "-3")}};
}

/// Motions from the top, of energies of both regimes, near rest, near E = 2 and fast.
inline std::vector<named_motion> canonical_motions() {
    std::vector<named_motion> all;
    for (const std::string energy : {"1e-20", "1e-3", "0.1", "1", "1.71", "2.02", "4", "1e6"}) {
        all.push_back({"E = " + energy, with_energy(energy)});
    }
    for (const std::string gap : {"1e-3", "-1e-3", "1e-15", "-1e-15", "1e-100", "-1e-100"}) {
        all.push_back({"gap " + gap, with_gap(gap)});
    }
    return all;
}

/// The separatrix, in both directions.
inline std::vector<named_motion> critical_motions() {
    return {{"E = 2", with_energy("2")}, {"E = 2, clockwise", with_energy("2", -1)}};
}

}  // namespace libration::tests
