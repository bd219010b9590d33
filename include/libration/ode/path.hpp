// The solution at a point of the complex plane of time, by the straight line from the start.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "libration/ode/step.hpp"

namespace libration::ode {

/// Steps of R/e^2 along the line from the start to a point (taylor_step): no singularity may stand on it, and the value
/// is that of the continuation along it. Errors as those of taylor_march; nothing is proved. Throws error where the
/// steps become too small before.
template <rounding_scalar T>
class complex_path {
public:
    using complex = complex_number<T>;
    static constexpr long most_steps = 1'000'000;

    explicit complex_path(const explicit_system& system)
        : start_(tape::about_start(system)), points_(tape::about_points(system)) {}

    solution_state<complex> state_at(const complex& target) const {
        const int order = taylor_order(digits<T>());
        taylor_expansion<complex> first(start_, order);
        taylor_expansion<complex> other(points_, order);
        first.about_start();
        const taylor_expansion<complex>* current = &first;
        complex centre = constant_value<complex>::of(start_.point());
        for (long steps = 0;; ++steps) {
            const complex rest = target - centre;
            const T distance = modulus_of(rest);
            const bool at_start = current == &first;
            const T length = length_of(*current, at_start ? start_ : points_);
            if (length == 0 || distance <= length) {
                return distance == 0 ? start_state(*current, at_start) : current->at(rest);
            }
            if (steps >= most_steps || T(distance + length / 64) == distance) {
                throw error(error_kind::argument, "point", "",
                            "is not reached from the start: a singularity is close to the straight line there");
            }
            const complex next = centre + rest * T(length / distance);
            auto there = current->at(next - centre);
            other.about(next, std::move(there));
            current = &other;
            centre = next;
        }
    }

private:
    solution_state<complex> start_state(const taylor_expansion<complex>& here, bool at_start) const {
        if (!at_start) {
            return here.at(complex(0));
        }
        solution_state<complex> result;
        for (const auto& of_unknown : start_.starts()) {
            auto& values = result.emplace_back();
            for (const number& each : of_unknown) {
                values.push_back(constant_value<complex>::of(each));
            }
        }
        return result;
    }

    static T length_of(const taylor_expansion<complex>& here, const tape& of) {
        using std::ldexp;
        const int window = std::max(2, of.stride());
        std::vector<coefficient_size> last;
        for (int n = here.order() - window + 1; n <= here.order(); ++n) {
            last.push_back({n, size_of(here, of, n)});
        }
        const step_length h = taylor_step(std::max(1L, size_of(here, of, 0)), last);
        const T once = T(ldexp(T(h.mantissa), static_cast<int>(h.exponent)));
        T length = once;
        for (int i = 1; i < of.root(); ++i) {
            length *= once;
        }
        return length;
    }

    static long size_of(const taylor_expansion<complex>& here, const tape& of, int n) {
        long largest = exponent_of_zero;
        for (int i = 0; i < static_cast<int>(of.orders().size()); ++i) {
            const complex& c = here.coefficients(i)[n];
            largest = std::max({largest, binary_exponent(c.re), binary_exponent(c.im)});
        }
        return largest;
    }

    tape start_, points_;
};

}  // namespace libration::ode
