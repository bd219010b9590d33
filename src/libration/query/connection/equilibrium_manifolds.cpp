#include "libration/query/connection/equilibrium_manifolds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "../../algebra/dense_matrix.hpp"
#include "far_state.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/integration/taylor/taylor_march.hpp"
#include "libration/scalar/error.hpp"
#include "manifold_end.hpp"

namespace libration::ode {

namespace {

constexpr long bits_of_portrait = 160;
constexpr int degree_of_portrait = 20;
constexpr double first_part_of_radius = 1e-3;
constexpr int states_by_series = 40;
constexpr int most_drawn_states = 20'000;
constexpr double longest_time_of_branch = 400;  // in units of the slowest rate
constexpr double longest_arc_of_branch = 40;    // in units of the largest distance
constexpr double speed_at_rest = 1e-3;          // in units of the largest speed
constexpr double farthest_of_branch = 200;      // in units of 1 + the size of the equilibrium
constexpr double most_turn_of_chords = 0.1;
constexpr double longest_chord = 0.02;
constexpr double shortest_chord = 0.008;
constexpr int curves_of_surface = 16;
constexpr int curves_of_neighbourhood = 6;
constexpr double longest_arc_of_many = 10;
constexpr double growth_of_branch = 1.5;
constexpr double region_beside_branches = 0.5;
constexpr double region_without_branches = 3;

double distance_between(const std::vector<double>& a, const std::vector<double>& b) {
    double result = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        result = std::max(result, std::fabs(a[i] - b[i]));
    }
    return result;
}

// The angle between two chords.
double turn_between(const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& c) {
    double dot = 0, first = 0, second = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        dot += (b[i] - a[i]) * (c[i] - b[i]);
        first += (b[i] - a[i]) * (b[i] - a[i]);
        second += (c[i] - b[i]) * (c[i] - b[i]);
    }
    const double size = std::sqrt(first * second);
    return size > 0 ? std::acos(std::clamp(dot / size, -1., 1.)) : 0;
}

std::vector<double> flat_state(const solution_state<double>& state) {
    std::vector<double> result;
    for (const auto& each : state) {
        result.insert(result.end(), each.begin(), each.end());
    }
    return result;
}

std::vector<double> doubles_of(const std::vector<ball>& state) {
    std::vector<double> result;
    result.reserve(state.size());
    for (const ball& each : state) {
        result.push_back(as_double(each));
    }
    return result;
}

class portrait_of_equilibrium {
public:
    portrait_of_equilibrium(const equation_system& typed,
                            const std::vector<std::pair<std::string, expression>>& equilibrium)
        : system_(with_rest_as_start(typed)), form_(system_), lifted_(lifted_about_points(system_)) {
        for (const expression& each : form_.slopes) {
            if (each.has_variable()) {
                throw error(error_kind::argument, error_subject::problem, system_.variable(),
                            "occurs in the equation, and only autonomous systems have equilibria");
            }
        }
        for (const auto& [name, value] : equilibrium) {
            const auto place = std::ranges::find(form_.names, name);
            if (place == form_.names.end()) {
                throw error(error_kind::argument, error_subject::conditions, name,
                            "is not an unknown or a lower derivative");
            }
            given_.emplace_back(static_cast<std::size_t>(place - form_.names.begin()), value);
        }
        result_.names = form_.names;
    }

    equilibrium_manifolds result(bool stable, bool unstable) {
        const precision_scope scope(decimal_digits(bits_of_portrait));
        for (const bool is_stable : {true, false}) {
            if (is_stable ? stable : unstable) {
                add(is_stable);
            }
        }
        if (result_.branches.empty()) {
            throw error(
                error_kind::argument, error_subject::conditions, "",
                "is an equilibrium without a direction of exponential " + std::string(!unstable ? "decay"
                                                                                      : !stable ? "growth"
                                                                                                : "decay or growth"));
        }
        cut_leaving();
        return result_;
    }

private:
    // Initial values, which have no effect.
    static equation_system with_rest_as_start(equation_system system) {
        system.starts.clear();
        const auto highest = system.highest_derivatives();
        for (const std::string& name : system.unknowns()) {
            for (int order = 0; order < highest.at(name); ++order) {
                system.begin(unknown(name, order), 0, 0);
            }
        }
        return system;
    }

    void add(bool stable) {
        far_state rest = far_state_of(form_, given_, stable ? 1 : -1);
        if (!rest.coordinates.empty()) {
            throw error(error_kind::argument, error_subject::conditions, rest.names.front(),
                        "is not determined: give its value too");
        }
        if (std::ranges::any_of(rest.ignored, [](bool each) { return each; })) {
            throw error(error_kind::argument, error_subject::conditions, "",
                        "does not give the value of every unknown that it needs: add the others");
        }
        manifold_end end(form_, lifted_, std::move(rest), {}, stable ? 1 : -1);
        if (!end.choose({}, static_cast<std::size_t>(-1))) {
            throw error(error_kind::undecided, error_subject::conditions, "",
                        "is an equilibrium without a manifold that is proved");
        }
        result_.equilibrium = end.rest_values({});
        (stable ? result_.stable_dimension : result_.unstable_dimension) = end.variables();
        rate_ = INFINITY;
        for (const auto& each : end.plan().rates) {
            rate_ = std::min(rate_, -each.real());
        }
        std::vector<ball> times;
        for (int k = 0; k <= states_by_series; ++k) {
            times.push_back(exactly(-std::log(first_part_of_radius) / rate_ * k / states_by_series));
        }
        int number = 0;
        for (const auto& direction : directions(end.variables(), result_.names.size())) {
            const auto theta_at = [&](double part) {
                std::vector<ball> theta;
                theta.reserve(direction.size());
                for (const double each : direction) {
                    theta.push_back(exactly(each * end.good_radius() * part));
                }
                return theta;
            };
            const auto inner = end.along({}, theta_at(1), times, degree_of_portrait);
            const auto start = end.at({}, theta_at(inner ? 1 : first_part_of_radius), degree_of_portrait, true);
            if (!start) {
                continue;
            }
            manifold_branch branch{stable, ++number, {}, {}, false};
            follow(branch, doubles_of(start->value), end.variables() > 1 ? longest_arc_of_many : longest_arc_of_branch);
            for (std::size_t k = 1; inner && k < times.size(); ++k) {
                const double time = as_double(times[k]);
                const auto here = stable ? branch.times.size() : 0;
                branch.times.insert(branch.times.begin() + static_cast<std::ptrdiff_t>(here), stable ? time : -time);
                branch.states.insert(branch.states.begin() + static_cast<std::ptrdiff_t>(here),
                                     doubles_of((*inner)[k]));
            }
            result_.branches.push_back(std::move(branch));
        }
    }

    // Unit vectors in the coordinates of the manifold.
    static std::vector<std::vector<double>> directions(std::size_t dimension, std::size_t whole) {
        if (dimension == 1) {
            return {{1}, {-1}};
        }
        const int curves = dimension == whole ? curves_of_neighbourhood : curves_of_surface;
        std::vector<std::vector<double>> all;
        for (std::size_t i = 0; i + 1 < dimension; ++i) {  // in the planes of neighbouring coordinates
            for (int k = 0; k < curves; ++k) {
                const double angle = 2 * std::numbers::pi * k / curves;
                auto& direction = all.emplace_back(dimension, 0.0);
                direction[i] = std::cos(angle);
                direction[i + 1] = std::sin(angle);
            }
        }
        return all;
    }

    // Away from the equilibrium, as long as something happens.
    void follow(manifold_branch& branch, const std::vector<double>& start, double most_arc) const {
        const double sign = branch.stable ? -1 : 1;
        const double limit =
            farthest_of_branch * (1 + distance_between(result_.equilibrium, std::vector<double>(start.size())));
        branch.times = {0};
        branch.states = {start};
        try {
            taylor_march<double> march(system_);
            march.begin_at(0, grouped_state(start));
            double step = 0.1 / rate_, time = 0, arc = 0, extent = 0, fastest = 0;
            for (int k = 0; k < most_drawn_states; ++k) {
                time += step;
                const auto state = flat_state(march.advance_to(sign * time));
                if (!std::ranges::all_of(state, [](double x) { return std::isfinite(x); })) {
                    branch.leaves = true;
                    break;
                }
                const double chord = distance_between(state, branch.states.back());
                const double turn =
                    k > 0 ? turn_between(branch.states[branch.states.size() - 2], branch.states.back(), state) : 0;
                branch.times.push_back(sign * time);
                branch.states.push_back(state);
                const double distance = distance_between(state, result_.equilibrium);
                arc += chord;
                extent = std::max(extent, distance);
                fastest = std::max(fastest, chord / step);
                branch.leaves = distance > limit;
                if (branch.leaves || chord / step < speed_at_rest * fastest) {
                    break;
                }
                if (time > longest_time_of_branch / rate_ || arc > most_arc * extent) {
                    branch.leaves = is_growing(branch.states);
                    break;
                }
                step *= turn > most_turn_of_chords || chord > longest_chord * extent        ? 0.6
                        : turn < most_turn_of_chords / 3 && chord < shortest_chord * extent ? 1.3
                                                                                            : 1;
                step = std::min(step, 0.5 / rate_);
            }
        } catch (const error&) {  // a singularity
            branch.leaves = true;
        }
        if (branch.stable) {
            std::ranges::reverse(branch.times);
            std::ranges::reverse(branch.states);
        }
    }

    // Whether the second half goes much farther than the first.
    bool is_growing(const std::vector<std::vector<double>>& states) const {
        double first = 0, whole = 0;
        for (std::size_t k = 0; k < states.size(); ++k) {
            whole = std::max(whole, distance_between(states[k], result_.equilibrium));
            first = 2 * k < states.size() ? whole : first;
        }
        return whole > growth_of_branch * first;
    }

    solution_state<double> grouped_state(const std::vector<double>& state) const {
        solution_state<double> result;
        auto next = state.begin();
        for (const unknown_function& each : system_.unknowns()) {
            result.emplace_back(next, next + each.order);
            next += each.order;
        }
        return result;
    }

    // Branches that leave are cut at the border of a box around the others, half as wide again.
    void cut_leaving() {
        const std::size_t n = result_.equilibrium.size();
        std::vector<double> low = result_.equilibrium, high = low;
        bool bounded = false;
        for (const auto& branch : result_.branches) {
            bounded = bounded || !branch.leaves;
            for (const auto& state : branch.leaves ? std::vector<std::vector<double>>() : branch.states) {
                for (std::size_t i = 0; i < n; ++i) {
                    low[i] = std::min(low[i], state[i]);
                    high[i] = std::max(high[i], state[i]);
                }
            }
        }
        double largest = 0;
        for (std::size_t i = 0; i < n; ++i) {
            largest = std::max(largest, high[i] - low[i]);
        }
        for (std::size_t i = 0; i < n; ++i) {
            const double beside = bounded ? region_beside_branches * std::max(high[i] - low[i], largest / 4)
                                          : region_without_branches * (1 + std::fabs(result_.equilibrium[i]));
            low[i] -= beside;
            high[i] += beside;
        }
        const auto outside = [&](const std::vector<double>& state) {
            for (std::size_t i = 0; i < n; ++i) {
                if (!(state[i] >= low[i] && state[i] <= high[i])) {
                    return true;
                }
            }
            return false;
        };
        for (auto& branch : result_.branches) {
            if (!branch.leaves) {
                continue;
            }
            if (branch.stable) {  // the end is at the equilibrium
                const auto first = std::find_if(branch.states.rbegin(), branch.states.rend(), outside).base();
                branch.times.erase(branch.times.begin(), branch.times.begin() + (first - branch.states.begin()));
                branch.states.erase(branch.states.begin(), first);
            } else {
                const auto last = std::ranges::find_if(branch.states, outside);
                branch.times.resize(static_cast<std::size_t>(last - branch.states.begin()));
                branch.states.erase(last, branch.states.end());
            }
        }
    }

    explicit_system system_;
    first_order_form form_;
    polynomial_form lifted_;
    std::vector<std::pair<std::size_t, expression>> given_;
    equilibrium_manifolds result_;
    double rate_ = 1;
};

}  // namespace

equilibrium_manifolds manifolds_of(const equation_system& system,
                                   const std::vector<std::pair<std::string, expression>>& equilibrium, bool stable,
                                   bool unstable) {
    return portrait_of_equilibrium(system, equilibrium).result(stable, unstable);
}

}  // namespace libration::ode
