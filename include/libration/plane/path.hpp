// The solution at points of the complex t-plane, continued along polygonal paths from the initial point.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "libration/integration/taylor/taylor_march.hpp"

namespace libration::ode {

/// The continuation of the solution from the initial point along straight lines from corner to corner, and from the
/// last corner to any point. The branch is determined by the singularities between such paths. Steps of R/e^2
/// (taylor_step), so that none reaches a singularity. Errors as those of taylor_march; nothing is proved.
template <rounding_scalar T>
class complex_path {
public:
    using complex = complex_number<T>;
    static constexpr long most_steps = 1'000'000;

    /// Continues to the last of the corners. Throws error like state_at.
    explicit complex_path(const explicit_system& system, const std::vector<complex>& corners = {})
        : start_(tape::about_start(system)),
          points_(tape::about_points(system)),
          first_(start_, taylor_order(digits<T>())),
          corner_(points_, first_.order()),
          other_(points_, first_.order()),
          centre_(constant_value<complex>::of(start_.point())) {
        first_.about_start();
        for (const complex& next : corners) {
            corner_.about(next, state_at(next));
            centre_ = next;
            at_start_ = false;
        }
    }

    complex_path(const complex_path&) = delete;
    complex_path& operator=(const complex_path&) = delete;

    /// The unknowns and their lower derivatives at the end of the straight line from the last corner. Throws error if
    /// the steps become too small before it: the path must not meet a singularity.
    solution_state<complex> state_at(const complex& target) {
        const taylor_expansion<complex>* current = at_start_ ? &first_ : &corner_;
        complex centre = centre_;
        for (long steps = 0;; ++steps) {
            const complex rest = target - centre;
            const T distance = modulus_of(rest);
            const bool at_start = current == &first_;
            const T length = length_of(*current, at_start ? start_ : points_);
            if (length == 0 || distance <= length) {
                return distance == 0 && at_start ? start_state() : current->at(rest);
            }
            if (steps >= most_steps || !(T(distance + length / 64) > distance)) {
                throw error(error_kind::argument, error_subject::point, "(" + decimals(target) + ")",
                            "is not reached by the straight line there: the steps become too small near (" +
                                decimals(centre) + "), where a singularity is close");
            }
            const complex next = centre + rest * T(length / distance);
            auto there = current->at(next - centre);
            other_.about(next, std::move(there));
            current = &other_;
            centre = next;
        }
    }

private:
    static std::string decimals(const complex& z) { return to_decimal(z.re, 10) + ", " + to_decimal(z.im, 10); }

    solution_state<complex> start_state() const {
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
    taylor_expansion<complex> first_, corner_, other_;
    complex centre_;
    bool at_start_ = true;
};

/// The states at the ends of paths with these corners in common. Throws error like complex_path.
template <rounding_scalar T>
std::vector<solution_state<complex_number<T>>> states_along(const explicit_system& system,
                                                            const std::vector<complex_constant>& corners,
                                                            const std::vector<complex_constant>& times) {
    const auto value_of = [](const complex_constant& z) { return constant_value<complex_number<T>>::of(z); };
    std::vector<complex_number<T>> at;
    at.reserve(corners.size());
    for (const complex_constant& each : corners) {
        at.push_back(value_of(each));
    }
    complex_path<T> path(system, at);
    std::vector<solution_state<complex_number<T>>> states;
    states.reserve(times.size());
    for (const complex_constant& each : times) {
        states.push_back(path.state_at(value_of(each)));
    }
    return states;
}

}  // namespace libration::ode
