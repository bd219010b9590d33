#include "rounded_flow.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "../../equation/bound_text.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr double relative_difference = 1e-6;
constexpr double close_return = 0.02;
constexpr double far_return = 0.3;  // relative to the size of the orbit
constexpr double settled_return = 1e-6;
constexpr double period_range = 1.5;
constexpr long most_rounded_steps = 5000;
constexpr int most_minima = 24;
constexpr int samples_of_step = 12;

double product_of(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += a[i] * b[i];
    }
    return sum;
}

std::vector<double> difference_of(std::vector<double> a, const std::vector<double>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] -= b[i];
    }
    return a;
}

template <class T>
std::optional<std::vector<T>> state_after(const explicit_system& system, taylor_march<T>& march,
                                          const std::vector<T>& start, const T& origin, const T& time) {
    solution_state<T> state;
    std::size_t k = 0;
    for (const unknown_function& each : system.unknowns()) {
        auto& values = state.emplace_back();
        for (int j = 0; j < each.order; ++j) {
            values.push_back(start[k++]);
        }
    }
    try {
        march.begin_at(origin, state);
        std::vector<T> result;
        for (const auto& values : march.advance_to(T(origin + time))) {
            result.insert(result.end(), values.begin(), values.end());
        }
        using std::isfinite;
        if (std::ranges::all_of(result, [](const T& each) { return isfinite(each); })) {
            return result;
        }
    } catch (const error&) {  // a singularity
    }
    return std::nullopt;
}

}  // namespace

rounded_flow::rounded_flow(const explicit_system& system)
    : system_(system), form_(system), origin_(constant_value<double>::of(system.point())), march_(system) {
    for (const number& each : form_.starts) {
        start_.push_back(constant_value<double>::of(each));
    }
}

std::optional<std::vector<double>> rounded_flow::at(const std::vector<double>& start, double time) {
    return state_after(system_, march_, start, origin_, time);
}

std::optional<std::vector<mpfr>> rounded_flow::at(const std::vector<mpfr>& start, const mpfr& time) const {
    taylor_march<mpfr> march(system_);
    return state_after(system_, march, start, constant_value<mpfr>::of(system_.point()), time);
}

std::vector<std::vector<double>> rounded_flow::derivative(const std::vector<double>& start, double time) {
    const std::size_t n = start.size();
    std::vector<std::vector<double>> rows(n, std::vector<double>(n));
    for (std::size_t j = 0; j < n; ++j) {
        const double by = relative_difference * std::max(1.0, std::abs(start[j]));
        auto changed = start;
        changed[j] = start[j] + by;
        const auto after = at(changed, time);
        changed[j] = start[j] - by;
        const auto before = at(changed, time);
        if (!after || !before) {
            return {};
        }
        for (std::size_t i = 0; i < n; ++i) {
            rows[i][j] = ((*after)[i] - (*before)[i]) / (2 * by);
        }
    }
    return rows;
}

std::vector<double> rounded_flow::slopes(const std::vector<double>& state) const {
    return form_.slopes_at(state, origin_);
}

std::vector<double> rounded_flow::in_series(double time) const {
    const double distance = time - march_.centre();
    std::vector<double> result;
    for (std::size_t i = 0; i < system_.unknowns().size(); ++i) {
        for (int j = 0; j < system_.unknowns()[i].order; ++j) {
            const double* const a = march_.coefficients(static_cast<int>(i), j);
            double sum = 0;
            for (int n = march_.order() + 1; n-- > 0;) {
                sum = sum * distance + a[n];
            }
            result.push_back(sum);
        }
    }
    return result;
}

// The least of the minima of the distance, where its derivative changes from negative (`slope`, at `from`) to positive.
std::optional<near_return> rounded_flow::return_in_step(double from, double to, double& slope, double& farthest) {
    const auto slope_at = [&](double time) {
        const auto state = in_series(time);
        const auto moved = difference_of(state, start_);
        farthest = std::max(farthest, std::sqrt(product_of(moved, moved)));
        return product_of(moved, slopes(state));
    };
    double low = from;
    std::optional<near_return> found;
    for (int k = 1; k <= samples_of_step; ++k) {
        double high = from + (to - from) * k / samples_of_step;
        const double next = slope_at(high);
        if (slope < 0 && next >= 0) {
            double left = low;
            double right = high;
            for (int i = 0; i < 50; ++i) {
                const double middle = (left + right) / 2;
                (slope_at(middle) < 0 ? left : right) = middle;
            }
            const auto moved = difference_of(in_series(right), start_);
            const double distance = std::sqrt(product_of(moved, moved));
            if (!found || distance < found->distance) {
                found = {right - origin_, distance};
            }
        }
        slope = next;
        low = high;
    }
    return found;
}

std::optional<near_return> rounded_flow::closest_return(const std::optional<double>& about) {
    at(start_, 0);
    std::optional<near_return> best;
    double slope = 0;
    double farthest = 0;
    int minima = 0;
    for (long k = 0; k < most_rounded_steps && (about || minima < most_minima); ++k) {
        const double from = march_.centre();
        const double to = march_.length() > 0 ? from + march_.length() : from + 1;
        auto found = return_in_step(from, to, slope, farthest);
        const double passed = to - origin_;
        if (found && !(found->time > 0)) {
            found.reset();
        }
        if (found) {
            ++minima;
            found->distance /= farthest;
            const bool near = !about || (found->time * period_range > *about && found->time < *about * period_range);
            if (near && (!best || found->distance < best->distance)) {
                best = found;
            }
            if (!about && best && best->distance < close_return) {
                return best;
            }
        }
        if (about && passed > *about * period_range) {
            break;
        }
        try {
            march_.step_towards(to + (to - from) * 1e-3);
        } catch (const error&) {
            break;
        }
        if (march_.centre() == from) {
            break;
        }
    }
    return best;
}

std::string described_return(const near_return& at) {
    std::ostringstream text;
    text.precision(6);
    text << "at time " << at.time;
    text.precision(2);
    text << ", at " << at.distance * 100 << " % of the size of the orbit";
    return text.str();
}

near_return guessed_return(rounded_flow& flow, const std::optional<number>& period) {
    const auto about = period ? std::optional(constant_value<double>::of(*period)) : std::nullopt;
    const auto nearest = flow.closest_return(about);
    const auto first = about && nearest ? flow.closest_return(std::nullopt) : std::nullopt;
    if (first && first->time * period_range < nearest->time &&
        first->distance <= std::max(2 * nearest->distance, settled_return)) {
        throw error(error_kind::undecided, error_subject::solution, "",
                    "already returns " + described_return(*first) + ", long before the given period " +
                        text_of_time(*period) + ": give that time as the period");
    }
    if (nearest && nearest->distance <= far_return) {
        return *nearest;
    }
    const auto other = about && !nearest ? flow.closest_return(std::nullopt) : nearest;
    throw error(error_kind::undecided, error_subject::solution, "",
                "does not return near its initial point" +
                    (about ? " at about the given period " + text_of_time(*period) : "") +
                    (other ? ": it comes nearest " + described_return(*other) : "") +
                    ": choose initial values nearer to a periodic orbit" + (about ? ", or another period" : ""));
}

}  // namespace libration::ode
