#include "stiff_guide.hpp"

#include <algorithm>
#include <cmath>

#include "../../algebra/dense_matrix.hpp"

namespace libration::ode {

namespace {

using reals = std::vector<long double>;
const long double part_of_step = 1 / (2 + std::sqrt(2.0L));
const long double weight_of_error = 6 + std::sqrt(2.0L);
// The part of the largest value of an unknown so far below which its relative error is ignored.
constexpr long double part_of_largest = 1e-3L;
// The solution is smooth over a number of steps if it is integrated to the tolerance in at most so many, and no unknown
// decays below this part of itself.
constexpr long double steps_of_smoothness = 32;
constexpr int guide_steps_of_smoothness = 20;
constexpr long double tolerance_of_smoothness = 1e-3L;
constexpr long double decay_of_smoothness = 1e-6L;

}  // namespace

struct stiff_guide::run {
    run(const stiff_guide& of, const request& what)
        : guide(of), asked(what), y(what.start), largest(what.start.size()) {
        slope = slopes(y, 0);
        note_largest();
    }

    // f times the sign of the direction, at a time measured in that direction.
    reals slopes(const reals& state, long double passed) const {
        reals f = guide.of_.values(at(passed), state, false).slopes;
        for (long double& each : f) {
            each *= direction();
        }
        return f;
    }
    long double at(long double passed) const { return asked.time + direction() * passed; }
    long double direction() const { return asked.length < 0 ? -1 : 1; }

    void note_largest() {
        for (std::size_t i = 0; i < y.size(); ++i) {
            largest[i] = std::max(largest[i], std::fabs(y[i]));
        }
    }

    // The matrix 1 - s d J, and s d times the derivative of f with respect to time.
    bool factor(long double s) {
        const std::size_t n = y.size();
        const auto all = guide.of_.values(at(gone), y, true);
        reals w(n * n, 0);
        for (std::size_t i = 0; i < n; ++i) {
            w[i * n + i] = 1;
        }
        for (std::size_t k = 0; k < all.entries.size(); ++k) {
            const auto [i, j] = guide.of_.places[k];
            w[i * n + j] -= s * part_of_step * direction() * all.entries[k];
        }
        const long double little = s * 1e-7L;
        const reals later = slopes(y, gone + little);
        by_time.resize(n);
        for (std::size_t i = 0; i < n; ++i) {
            by_time[i] = s * part_of_step * (later[i] - slope[i]) / little;
        }
        return lu.factor(w, n);
    }

    // Computes the stages k1, k2 and the next state with its slope; returns the error relative to the tolerance.
    long double tried(long double s) {
        const std::size_t n = y.size();
        reals right(n);
        const auto combined = [&](const auto& of) {
            for (std::size_t i = 0; i < n; ++i) {
                right[i] = of(i);
            }
        };
        combined([&](std::size_t i) { return slope[i] + by_time[i]; });
        k1 = lu.solved(right);
        combined([&](std::size_t i) { return y[i] + s * k1[i] / 2; });
        const reals middle = slopes(right, gone + s / 2);
        combined([&](std::size_t i) { return middle[i] - k1[i]; });
        k2 = lu.solved(right);
        next = y;
        for (std::size_t i = 0; i < n; ++i) {
            k2[i] += k1[i];
            next[i] += s * k2[i];
        }
        next_slope = slopes(next, gone + s);
        combined([&](std::size_t i) {
            return next_slope[i] - weight_of_error * (k2[i] - middle[i]) - 2 * (k1[i] - slope[i]) + by_time[i];
        });
        const reals k3 = lu.solved(right);
        long double worst = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const long double scale =
                std::max({std::fabs(y[i]), std::fabs(next[i]), asked.floors[i], part_of_largest * largest[i]});
            const long double error = std::fabs(s / 6 * (k1[i] - 2 * k2[i] + k3[i]));
            if (error > 0) {
                worst = std::max(worst, scale > 0 ? error / scale / asked.tolerance : 1e9L);
            }
            if (!std::isfinite(error)) {
                return error;
            }
        }
        return worst;
    }

    reals between(long double part, long double s) const {
        reals state = y;
        const long double of_1 = part * (1 - part) / (1 - 2 * part_of_step);
        const long double of_2 = part * (part - 2 * part_of_step) / (1 - 2 * part_of_step);
        for (std::size_t i = 0; i < y.size(); ++i) {
            state[i] += s * (of_1 * k1[i] + of_2 * k2[i]);
        }
        return state;
    }

    const stiff_guide& guide;
    const request& asked;
    reals y, largest, slope, by_time, k1, k2, next, next_slope;
    long double gone = 0;
    real_lu<long double> lu;
};

stiff_guide::stiff_guide(const polynomial_map& map, std::vector<long double> constants)
    : stiff_guide({map.places(), [&map, constants = std::move(constants)](
                                     long double time, const std::vector<long double>& state, bool with_entries) {
                       return map.in(number_ring<long double>{constants, time}, state, with_entries);
                   }}) {}

std::optional<std::vector<std::vector<long double>>> stiff_guide::states(const request& asked,
                                                                         const std::vector<long double>& parts) const {
    run now(*this, asked);
    const long double whole = std::fabs(asked.length);
    long double s = whole * 1e-6L;
    std::vector<reals> found;
    for (int k = 0; k < asked.most_steps && found.size() < parts.size(); ++k) {
        s = now.gone + s * 1.0001L > whole ? whole - now.gone : s;
        const long double error = now.factor(s) ? now.tried(s) : HUGE_VALL;
        if (std::isfinite(error) && error <= 1) {
            while (found.size() < parts.size() && parts[found.size()] * whole <= now.gone + s * (1 + 1e-12L)) {
                found.push_back(now.between((parts[found.size()] * whole - now.gone) / s, s));
            }
            now.gone += s;
            now.y = now.next;
            now.slope = now.next_slope;
            now.note_largest();
            if (now.gone >= whole * (1 - 1e-15L)) {
                found.resize(parts.size(), now.y);
            }
        }
        s *=
            !std::isfinite(error) ? 0.25L : std::clamp(0.8L * std::pow(std::max(error, 1e-6L), -1 / 3.0L), 0.15L, 4.0L);
        if (s < whole * 1e-14L) {
            break;
        }
    }
    return found.size() == parts.size() ? std::optional(std::move(found)) : std::nullopt;
}

bool stiff_guide::is_smooth_over_steps(long double time, const std::vector<long double>& start, long double step,
                                       std::size_t resolved) const {
    request asked;
    asked.start = start;
    asked.floors.assign(start.size(), 0);
    asked.time = time;
    asked.length = step * steps_of_smoothness;
    asked.tolerance = tolerance_of_smoothness;
    asked.most_steps = guide_steps_of_smoothness;
    if (!std::isfinite(asked.length) || asked.length == 0) {
        return false;
    }
    const auto found = states(asked, {1.0L});
    // A decaying unknown is resolved by steps that do not reduce it much.
    const auto keeps_size = [&](std::size_t i) {
        return std::fabs(found->front()[i]) >= decay_of_smoothness * std::fabs(start[i]);
    };
    for (std::size_t i = 0; found && i < start.size(); ++i) {
        if (!std::isfinite(start[i]) || (i < resolved && start[i] != 0 && !keeps_size(i))) {
            return false;
        }
    }
    return found.has_value();
}

}  // namespace libration::ode
