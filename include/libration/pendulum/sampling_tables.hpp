// The sampler's data of a motion, and its evaluation at one time.
#pragma once

#include <concepts>

#include "libration/pendulum/half_cycle_panels.hpp"
#include "libration/pendulum/half_cycle_turns.hpp"
#include "libration/pendulum/sample_vectors.hpp"

namespace libration::pendulum {

/// The sampler's data of a motion.
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

/// theta and omega at a time within the range of the clock.
///
/// Error of theta, in units of the last place of max(1, |theta|): its constant coefficient is rounded in twice that
/// unit at worst (the centre of the panel may be above 2 and theta below it), so are the sum of the even powers, and
/// once more the sum with the odd ones, in its own unit; rotation adds half a unit for the turns: 3 units, and some
/// tenths for truncation of the panels, the products and the time. The same for omega, in units of max(1, its maximum).
template <fixed_scalar T>
series::jet<T> sampled_at(const sampling_tables<T>& tables, const T& time) {
    const auto at = tables.clock.locate(time);
    const T sign = tables.turns.sign(at.passage, tables.clock);
    const bool inside = at.x < tables.panels.end();
    const T& x = inside ? at.x : tables.panels.end();
    const panel_place place = place_of(static_cast<double>(x));
    const series::jet<T> swing = tables.panels[place.index].at(T((x - place.centre) + (inside ? at.rest : T(0))));
    return {tables.turns.theta(at.passage, T(swing.value * (sign * at.side))),
            T(swing.slope * (sign * (1 / tables.panels.unit())))};
}

}  // namespace libration::pendulum
