// A few times at once through the tables of the sampler: loops of a fixed length over plain numbers, which
// compilers turn into vector instructions.
#pragma once

#include <array>
#include <cstddef>

#include "libration/pendulum/sampler/half_cycle_panels.hpp"
#include "libration/pendulum/sampler/half_cycle_turns.hpp"
#include "libration/pendulum/sampler/sample_vectors.hpp"

namespace libration::pendulum {

/// What the sampler keeps of a motion.
template <fixed_scalar T>
struct sampling_tables {
    half_cycle_panels<T> panels;
    half_cycle_clock<T> clock;
    half_cycle_turns<T> turns;

    /// In a precision_scope of at least 2 digits + 64 bits.
    explicit sampling_tables(const motion& m) : sampling_tables(m, passage_interval(m)) {}

    vector_tables vectors() const requires std::same_as<T, double> {
        static_assert(sizeof(panel<T>) == 2 * double_panel_terms * sizeof(double));
        return {clock.constants(), turns.constants(), panels.data()->head.data(), panels.end()};
    }

private:
    sampling_tables(const motion& m, const mpfr& interval)
        : sampling_tables(m, interval, passage_at_start<finer_t<T>>(m, interval)) {}
    sampling_tables(const motion& m, const mpfr& interval, const after_passage& start)
        : panels(m), clock(interval, start.time, panels.unit()), turns(m, start.passage) {}
};

/// theta and omega at `count` times that the clock reaches; the arrays may be the same.
///
/// Error of theta, in units of the last place of max(1, |theta|): its constant coefficient is rounded in twice that
/// unit at worst (the centre of the panel may lie above 2 and theta below it), so are the sum of the even powers, and
/// once more the sum with the odd ones, in its own unit; rotation adds half a unit for the turns: 3 units, and some
/// tenths for what the panels leave out, the products and the time. The same for omega in units of max(1, its maximum).
template <std::size_t count, fixed_scalar T>
[[gnu::always_inline]] inline void sample_block(const sampling_tables<T>& tables, const T* times, T* theta, T* omega) {
    std::array<T, count> passage;
    std::array<T, count> step;
    std::array<T, count> rest;
    std::array<T, count> mirror;
    std::array<T, count> sign;
    std::array<std::size_t, count> index;
    std::array<T, count> value;
    std::array<T, count> slope;
    const T end = tables.panels.end();
    const T per_unit = 1 / tables.panels.unit();
    for (std::size_t i = 0; i < count; ++i) {
        const auto at = tables.clock.locate(times[i]);
        passage[i] = at.passage;
        sign[i] = tables.turns.sign(at.passage, tables.clock);
        mirror[i] = sign[i] * at.side;
        const bool inside = at.x < end;
        step[i] = inside ? at.x : end;
        rest[i] = inside ? at.rest : T(0);
    }
    for (std::size_t i = 0; i < count; ++i) {
        const panel_place place = place_of(static_cast<double>(step[i]));
        index[i] = place.index;
        step[i] = (step[i] - place.centre) + rest[i];
    }
    for (std::size_t i = 0; i < count; ++i) {
        const series::jet<T> swing = tables.panels[index[i]].at(step[i]);
        value[i] = swing.value;
        slope[i] = swing.slope;
    }
    for (std::size_t i = 0; i < count; ++i) {
        theta[i] = tables.turns.theta(passage[i], T(value[i] * mirror[i]));
    }
    for (std::size_t i = 0; i < count; ++i) {
        omega[i] = slope[i] * (sign[i] * per_unit);
    }
}

}  // namespace libration::pendulum
