// Invariants of a solution, used to check it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "libration/expansion/taylor_expansion.hpp"
#include "libration/scalar/complex_number.hpp"

namespace libration::ode {

/// The invariants declared by a system, at states of its solution, compared with those at its initial point or at
/// another state. Errors: rounding in R.
template <field R>
class invariants {
public:
    /// Throws error if the system declares no invariant, or if its right-hand sides or invariants have no values at the
    /// initial point.
    explicit invariants(const explicit_system& system)
        : points_(tape::about_points(system, system.invariants())), there_(points_, highest(points_)) {
        if (system.invariants().empty()) {
            throw error(error_kind::argument, error_subject::problem, "", "states no invariant");
        }
        solution_state<R> start;
        for (const auto& of_unknown : points_.starts()) {
            auto& values = start.emplace_back();
            for (const number& each : of_unknown) {
                values.push_back(constant_value<R>::of(each));
            }
        }
        begin_at(constant_value<R>::of(system.point()), start);
    }

    /// Compares with the values at this state from now on.
    void begin_at(const R& time, const solution_state<R>& state) { at_start_ = at(time, state); }

    /// The values of the invariants.
    std::vector<R> at(const R& time, const solution_state<R>& state) {
        there_.about(time, state);
        std::vector<R> values;
        values.reserve(points_.watched().size());
        for (int i = 0; i < static_cast<int>(points_.watched().size()); ++i) {
            values.push_back(there_.watched(i)[0]);
        }
        return values;
    }

    /// The largest change of any invariant since the initial point, or since the state of begin_at.
    auto drift(const R& time, const solution_state<R>& state) {
        const auto now = at(time, state);
        auto largest = size_of(R(now[0] - at_start_[0]));
        for (std::size_t i = 1; i < now.size(); ++i) {
            largest = std::max(largest, size_of(R(now[i] - at_start_[i])));
        }
        return largest;
    }

private:
    template <class T>
    static T size_of(const T& x) {
        using std::abs;
        return abs(x);
    }
    template <class T>
    static T size_of(const complex_number<T>& z) {
        return modulus_of(z);
    }
    static int highest(const tape& of) { return *std::max_element(of.orders().begin(), of.orders().end()); }

    tape points_;
    taylor_expansion<R> there_;
    std::vector<R> at_start_;
};

}  // namespace libration::ode
