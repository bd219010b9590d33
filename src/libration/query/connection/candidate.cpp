#include "candidate.hpp"

#include <algorithm>
#include <cmath>

#include "../../algebra/dense_matrix.hpp"
#include "libration/integration/taylor/taylor_march.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr long bits_of_candidate = 160;
constexpr int most_newton_steps = 30;
constexpr int most_times = 60;
constexpr int most_samples = 3000;
constexpr double most_decay = 40;
constexpr double first_sample = 0.01;
constexpr double growth_of_samples = 0.004;
constexpr double far_away = 50;
constexpr double small_enough = 1e-20;
constexpr double converged = 1e-12;
constexpr double trivial = 1e-9;
constexpr double radius_at_rest = 1. / 64;
constexpr double largest_series_theta = 4;
constexpr double scale_of_unknowns = 0.2;
constexpr double nearly_nearest = 1.5;
constexpr double near_distance = 0.1;

solution_state<double> grouped(const explicit_system& system, const std::vector<double>& state) {
    solution_state<double> result;
    auto next = state.begin();
    for (const unknown_function& each : system.unknowns()) {
        result.emplace_back(next, next + each.order);
        next += each.order;
    }
    return result;
}

std::vector<double> flat(const solution_state<double>& state) {
    std::vector<double> result;
    for (const auto& each : state) {
        result.insert(result.end(), each.begin(), each.end());
    }
    return result;
}

bool all_finite(const std::vector<double>& x) {
    return std::ranges::all_of(x, [](double each) { return std::isfinite(each); });
}

double largest(const std::vector<double>& x) {
    double result = 0;
    for (const double each : x) {
        result = std::max(result, std::fabs(each));
    }
    return result;
}

class orbit_search {
public:
    explicit orbit_search(connection_map& map) : map_(map), first_theta_(map.size() - map.right().variables()) {}

    // Newton's method for all unknowns at the time of the map; false if it does not converge.
    bool newton(std::vector<double>& x) const {
        const precision_scope scope(decimal_digits(bits_of_candidate));
        std::vector<ball> at;
        for (const double each : x) {
            at.push_back(exactly(each));
        }
        double last = INFINITY;
        for (int k = 0; k < most_newton_steps; ++k) {
            const auto step = step_from(at);
            if (step.empty() || !all_finite(step)) {
                return false;
            }
            double size = 0;
            for (std::size_t i = 0; i < step.size(); ++i) {
                size = std::max(size, std::fabs(step[i]) / (scale_of_unknowns + std::fabs(as_double(at[i]))));
            }
            const double damping = size > 1 ? 1 / size : 1;
            for (std::size_t i = 0; i < step.size(); ++i) {
                at[i] = exact_midpoint(at[i] - exactly(step[i] * damping));
            }
            if (size < converged || (k > 5 && size < 1e-7 && size > last / 2)) {
                for (std::size_t i = 0; i < x.size(); ++i) {
                    x[i] = as_double(at[i]);
                }
                return map_.degree == 1 || largest_theta(x) < largest_series_theta;
            }
            last = size;
        }
        return false;
    }

    double largest_theta(const std::vector<double>& x) const { return largest({x.begin() + first(), x.end()}); }

    // Later times, until theta is small: the candidate of each is the first guess of the next.
    bool settle(std::vector<double>& x) {
        const auto& rates = map_.right().plan().rates;
        double slowest = INFINITY;
        for (const auto& each : rates) {
            slowest = std::min(slowest, -each.real());
        }
        const double target = map_.right().good_radius();
        double step = std::max(0.3, std::log(largest_theta(x) / target)) / slowest;
        for (int k = 0; k < most_times; ++k) {
            const double theta = largest_theta(x);
            if (theta < trivial) {
                map_.radius = radius_at_rest;
                map_.degree = 12;
                return map_.may_rest;
            }
            if (map_.degree > 1 && theta <= target * 1.1 && (theta > target / 8 || k > most_times / 2)) {
                map_.radius = theta * 1.05;
                return true;
            }
            auto next = x;
            const double before = map_.time;
            const double wanted = std::log(theta / (0.9 * target)) / slowest;
            step = std::fabs(wanted) < 0.02 / slowest
                       ? 0.02 / slowest
                       : std::copysign(std::min(std::fabs(step), std::fabs(wanted)), wanted);
            map_.time = std::max(0., map_.time + step);
            advance(next, map_.time - before);
            const int degree = map_.degree;
            map_.degree = largest_theta(next) < 0.6 ? 12 : 1;
            if (newton(next) && (step < 0 || largest_theta(next) < theta * 1.05)) {
                x = next;
                step *= 1.6;
            } else {
                map_.degree = degree;
                map_.time = before;
                step /= 2;
                if (std::fabs(step) * slowest < 1e-4) {
                    return false;
                }
            }
        }
        return false;
    }

private:
    std::ptrdiff_t first() const { return static_cast<std::ptrdiff_t>(first_theta_); }

    std::vector<double> step_from(const std::vector<ball>& at) const {
        std::optional<enclosed_map> f;
        try {
            f = map_(at, bits_of_candidate, run_bits::usual_error_bits);
        } catch (const error&) {
            return {};  // the solution ends before
        }
        const auto by = f ? inverse_near(f->derivative) : std::nullopt;
        std::vector<double> step;
        for (std::size_t i = 0; by && i < at.size(); ++i) {
            ball sum(0);
            for (std::size_t j = 0; j < at.size(); ++j) {
                sum += (*by)[i][j] * f->value[j];
            }
            step.push_back(as_double(sum));
        }
        return step;
    }

    // theta at a later time, by its linear motion.
    void advance(std::vector<double>& x, double time) const {
        const frame_plan& plan = map_.right().plan();
        for (std::size_t j = 0; j < plan.size(); ++j) {
            double& theta = x[first_theta_ + j];
            const double factor = std::exp(plan.rates[j].real() * time);
            if (plan.begins_pair(j)) {
                const std::complex<double> turned = std::complex<double>(theta, x[first_theta_ + j + 1]) *
                                                    std::polar(factor, plan.rates[j].imag() * time);
                theta = turned.real();
                x[first_theta_ + j + 1] = turned.imag();
            } else if (!plan.ends_pair(j)) {
                theta *= factor;
            }
        }
    }

    connection_map& map_;
    std::size_t first_theta_;
};

// The state of the moving unknowns at a time.
std::optional<std::vector<double>> moving_state(const connection_map& map, const std::vector<double>& x, double time) {
    try {
        taylor_march<double> march(map.open().system);
        const double point = constant_value<double>::of(map.open().system.point());
        march.begin_at(point, grouped(map.open().system, map.start_near(x)));
        const auto all = flat(march.advance_to(point + map.direction() * time));
        std::vector<double> result;
        for (const std::size_t k : map.right().moving()) {
            result.push_back(all[k]);
        }
        return all_finite(result) ? std::optional(result) : std::nullopt;
    } catch (const error&) {
        return std::nullopt;
    }
}

// The coordinates for the numbers that were found, and theta in them.
bool choose_again(connection_map& map, std::vector<double>& x, int side) {
    const long scale = map.right().plan().log2_scale;
    const std::vector<double> numbers(x.begin(),
                                      x.begin() + static_cast<std::ptrdiff_t>(map.numbers() + map.coordinates()));
    const std::size_t size = map.size();
    if (!map.choose(numbers, side) || map.size() != size) {
        return false;
    }
    for (std::size_t j = x.size() - map.right().variables(); j < x.size(); ++j) {
        x[j] = std::ldexp(x[j], static_cast<int>(scale - map.right().plan().log2_scale));
    }
    return orbit_search(map).newton(x);
}

// The first time at which the distance is small, or the first local minimum that is nearly the least.
nearest_approach first_near(const std::vector<nearest_approach>& all) {
    const auto least = std::ranges::min_element(all, {}, &nearest_approach::distance);
    auto minimum = least;
    for (auto each = least; each > all.begin() + 1; --each) {
        const auto before = each - 1;
        if (before->distance <= nearly_nearest * least->distance && before->distance <= each->distance &&
            before->distance <= (before - 1)->distance) {
            minimum = before;
        }
    }
    const double small_distance = near_distance * std::max(1., all.front().distance);
    const auto small = std::find_if(all.begin(), minimum,
                                    [&](const nearest_approach& each) { return each.distance <= small_distance; });
    nearest_approach result = *small;
    result.nearest_time = minimum->time;
    result.distance = least->distance;
    return result;
}

}  // namespace

std::optional<nearest_approach> approach_from(const connection_map& map, const std::vector<double>& x) {
    const auto start = map.start_near(x);
    const auto rest = map.right().rest_values(map.right_numbers(x));
    const auto& moving = map.right().moving();
    const auto is_free = [&](std::size_t i) {
        return std::ranges::any_of(map.right().rest().coordinates, [&](const expression& each) {
            return same_form(each, map.right().rest().values[moving[i]]);
        });
    };
    if (start.empty() || !all_finite(start)) {
        return std::nullopt;
    }
    std::vector<nearest_approach> all;
    try {
        taylor_march<double> march(map.open().system);
        const double point = constant_value<double>::of(map.open().system.point());
        march.begin_at(point, grouped(map.open().system, start));
        double time = 0;
        double slowest = 1;
        for (const auto& each : map.right().plan().rates) {
            slowest = std::min(slowest, -each.real());
        }
        const double latest = most_decay / slowest;
        for (int k = 0; k < most_samples; ++k, time += first_sample + growth_of_samples * time) {
            const auto state = flat(march.advance_to(point + map.direction() * time));
            if (!all_finite(state)) {
                break;
            }
            double distance = 0;
            std::vector<double> now;
            for (std::size_t i = 0; i < moving.size(); ++i) {
                now.push_back(state[moving[i]]);
                if (!is_free(i)) {
                    distance = std::max(distance, std::fabs(now[i] - rest[i]) / (1 + std::fabs(rest[i])));
                }
            }
            all.push_back({time, time, distance, now});
            if (time > latest || distance > far_away * (1 + all.front().distance) || distance < small_enough ||
                march.steps() > most_samples) {
                break;
            }
        }
    } catch (const error&) {
        // the solution ends: the best of the times before
    }
    return all.empty() ? std::nullopt : std::optional(first_near(all));
}

std::optional<std::vector<double>> candidate_from(connection_map& map, const std::vector<double>& numbers, int side) {
    auto at = numbers;
    map.degree = 12;
    map.radius = 0.25;
    if (!map.choose(at, side)) {
        return std::nullopt;
    }
    auto whole = at;
    whole.resize(std::max(map.size(), whole.size()));
    const auto nearest = approach_from(map, whole);
    if (!nearest) {
        return std::nullopt;
    }
    // Free coordinates at the end from the state there.
    const auto& rest = map.right().rest();
    for (std::size_t j = 0; j < rest.coordinates.size(); ++j) {
        for (std::size_t i = 0; i < map.right().moving().size(); ++i) {
            if (same_form(rest.values[map.right().moving()[i]], rest.coordinates[j])) {
                at[at.size() - rest.coordinates.size() + j] = nearest->state[i];
            }
        }
    }
    if (!map.choose(at, side) || map.size() != map.dimension()) {
        return std::nullopt;
    }
    const double first = nearest->time;
    const double last = nearest->nearest_time;
    for (const double time : {first, last, 0.8 * last, 0.6 * last, 0.8 * first, 0.4 * last, 1.15 * last}) {
        map.time = time;
        auto x = at;
        x.resize(map.size());
        const auto state = moving_state(map, x, map.time);
        if (!state) {
            continue;
        }
        const auto theta = map.right().theta_near(map.right_numbers(x), *state);
        std::ranges::copy(theta, x.end() - static_cast<std::ptrdiff_t>(theta.size()));
        for (const int degree : {1, 12}) {
            auto tried = x;
            map.degree = degree;
            orbit_search search(map);
            if (search.newton(tried) && choose_again(map, tried, side) && search.settle(tried)) {
                return tried;
            }
        }
    }
    return std::nullopt;
}

}  // namespace libration::ode
