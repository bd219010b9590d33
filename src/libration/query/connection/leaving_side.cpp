#include "leaving_side.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "libration/integration/taylor/taylor_march.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr int most_bisections_of_side = 40;
constexpr int most_samples_of_side = 600;
constexpr double first_sample_of_side = 0.02;
constexpr double growth_of_samples_of_side = 0.01;
constexpr double part_of_leaving = 1.3;
constexpr double part_of_approach = 0.5;
constexpr double far_from_equilibrium = 30;
constexpr double near_to_equilibrium = 0.25;
constexpr double least_unstable_rate = 1e-6;

class leaving_orbits {
public:
    leaving_orbits(connection_map& map, int side) : map_(map), side_(side) {}

    struct exit {
        int side = 0;  ///< none: the solution is not followed from its start
        double nearest = INFINITY;
    };

    // The left eigenvector of the only unstable direction; false if there is not one.
    bool choose(double x) {
        const std::vector<double> numbers{x};
        map_.degree = 12;
        if (!map_.choose(numbers, side_, false)) {  // the sign of a side requires no proof
            return false;
        }
        rest_ = map_.right().rest_values(numbers);
        const auto n = static_cast<Eigen::Index>(rest_.size());
        const first_order_form& form = map_.form();
        const auto& moving = map_.right().moving();
        expression_values<double> values(form.leaves, 0);
        for (std::size_t k = 0; k < form.leaves.size(); ++k) {
            const auto place = std::ranges::find(moving, k);
            values.push_back(place == moving.end() ? x : rest_[static_cast<std::size_t>(place - moving.begin())]);
        }
        Eigen::MatrixXd linear(n, n);
        for (Eigen::Index i = 0; i < n; ++i) {
            for (Eigen::Index j = 0; j < n; ++j) {
                linear(j, i) = map_.direction() * values.of(partial(form.slopes[moving[static_cast<std::size_t>(i)]],
                                                                    form.leaves[moving[static_cast<std::size_t>(j)]]));
            }
        }
        if (!linear.allFinite()) {
            return false;
        }
        neutral_.clear();
        for (Eigen::Index i = 0; i < n; ++i) {
            neutral_.push_back(linear.col(i).isZero());  // as 1/t: its distance is not that of the others
        }
        const Eigen::EigenSolver<Eigen::MatrixXd> solver(linear);
        int count = 0;
        for (Eigen::Index i = 0; i < n; ++i) {
            if (solver.eigenvalues()[i].real() > least_unstable_rate) {
                ++count;
                left_ = solver.eigenvectors().col(i).real();
            }
        }
        return count == 1;
    }

    exit exit_of(double x) {
        if (map_.has_two_ends() && !choose(x)) {
            return {};
        }
        std::vector<double> whole{x};
        whole.resize(map_.size());
        const auto start = map_.start_near(whole);
        if (start.empty()) {
            return {};
        }
        return followed(start);
    }

private:
    exit followed(const std::vector<double>& start) const {
        exit found;
        double nearest = INFINITY;
        try {
            const explicit_system& system = map_.open().system;
            taylor_march<double> march(system);
            solution_state<double> state;
            auto next = start.begin();
            for (const unknown_function& each : system.unknowns()) {
                state.emplace_back(next, next + each.order);
                next += each.order;
            }
            const double point = constant_value<double>::of(system.point());
            march.begin_at(point, state);
            double time = 0;
            double first = 0;
            double largest = 0;
            for (int k = 0; k < most_samples_of_side && march.steps() < most_samples_of_side;
                 ++k, time += first_sample_of_side + growth_of_samples_of_side * time) {
                std::vector<double> all;
                for (const auto& each : march.advance_to(point + map_.direction() * time)) {
                    all.insert(all.end(), each.begin(), each.end());
                }
                double distance = 0;
                double along = 0;
                for (std::size_t i = 0; i < rest_.size(); ++i) {
                    const double away = all[map_.right().moving()[i]] - rest_[i];
                    if (!neutral_[i]) {
                        distance = std::max(distance, std::fabs(away) / (1 + std::fabs(rest_[i])));
                    }
                    along += away * left_[static_cast<Eigen::Index>(i)];
                }
                if (!std::isfinite(along)) {
                    break;
                }
                first = k == 0 ? distance : first;
                nearest = distance > largest ? distance : std::min(nearest, distance);  // after the largest distance
                largest = std::max(largest, distance);
                found = exit{along > 0 ? 1 : -1, std::min(found.nearest, distance)};
                if (distance > far_from_equilibrium * (1 + first) ||
                    (nearest < part_of_approach * largest && distance > part_of_leaving * nearest)) {
                    break;
                }
            }
        } catch (const error&) {
            // the solution ends: on the side where it was last
        }
        return found;
    }

    connection_map& map_;
    int side_;
    std::vector<double> rest_;
    std::vector<bool> neutral_;
    Eigen::VectorXd left_;
};

}  // namespace

std::vector<double> changes_of_side(connection_map& map, std::vector<double> values, int side) {
    leaving_orbits here(map, side);
    std::vector<double> result;
    if (map.numbers() != 1 || map.coordinates() != 0 || values.empty() || !here.choose(values.front())) {
        return result;
    }
    std::ranges::sort(values);
    leaving_orbits::exit last;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto now = here.exit_of(values[i]);
        if (i > 0 && last.side != now.side) {
            double a = values[i - 1];
            double b = values[i];
            int side_of_a = last.side;
            if (side_of_a == 0) {  // the boundary of a side, not of those without one
                std::swap(a, b);
                side_of_a = now.side;
            }
            double nearest = INFINITY;
            for (int k = 0; k < most_bisections_of_side; ++k) {
                const double middle = (a + b) / 2;
                const auto found = here.exit_of(middle);
                nearest = std::min(nearest, found.nearest);
                (found.side == side_of_a ? a : b) = middle;
            }
            if (nearest < near_to_equilibrium) {
                result.push_back((a + b) / 2);
            }
        }
        last = now;
    }
    return result;
}

}  // namespace libration::ode
