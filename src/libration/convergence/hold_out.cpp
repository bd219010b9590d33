#include "hold_out.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace libration::convergence {

namespace {

constexpr std::array<differential_track, 9> predicting_tracks{
    {{1, 0, 0}, {1, 1, 0}, {1, 3, 0}, {2, 0, 0}, {2, 1, 0}, {2, 3, 0}, {2, 0, 1}, {3, 0, 0}, {3, 2, 0}}};

}  // namespace

std::vector<predicted_coefficient> predictions(std::span<const mpfr> b, int count, const task_runner& run) {
    const long bits = bits_for(static_cast<int>(b.size()) - 1);
    const precision_scope scope(decimal_digits(bits));
    const mpfr unit = level_unit(b);
    const auto scaled = in_unit(b, unit, bits);
    const int length = static_cast<int>(b.size()) - 1;
    std::array<std::vector<mpfr>, predicting_tracks.size()> by_track;
    run(predicting_tracks.size(), [&](std::size_t i) {
        const precision_scope inner(decimal_digits(bits));
        if (const auto relation = relation_of(scaled, predicting_tracks[i], length, bits)) {
            by_track[i] = continued_by(*relation, scaled, length, count);
        }
    });
    std::vector<predicted_coefficient> found;
    for (int m = length + 1; m <= length + count; ++m) {
        std::vector<mpfr> values;
        for (const auto& each : by_track) {
            if (!each.empty() && isfinite(each[static_cast<std::size_t>(m)])) {
                values.push_back(each[static_cast<std::size_t>(m)]);
            }
        }
        if (values.size() < 3) {
            break;
        }
        std::ranges::sort(values);
        const mpfr middle = values[values.size() / 2];
        std::vector<mpfr> away;
        for (const mpfr& each : values) {
            away.push_back(abs(mpfr(each - middle)));
        }
        std::ranges::sort(away);
        const mpfr power = pow(widen(unit), m);
        found.push_back({m, mpfr(middle / power), mpfr(away[away.size() / 2] * 10 / power)});
    }
    return found;
}

std::map<int, double> prediction_errors(std::span<const mpfr> b, int first, double noise, const task_runner& run) {
    const int last = static_cast<int>(b.size()) - 1;
    const long bits = bits_for(last, noise);
    const auto scaled = in_unit(b, level_unit(b), bits);
    std::vector<int> lengths;
    for (int n = first - 1; n < last; ++n) {
        lengths.push_back(n);
    }
    std::map<int, std::vector<double>> by_index;
    for (const auto& fit : differential_fits(scaled, predicting_tracks, lengths, {0, 0}, bits, run)) {
        if (fit.next_error) {
            by_index[fit.length + 1].push_back(*fit.next_error);
        }
    }
    std::map<int, double> errors;
    const double exact = -0.28 * static_cast<double>(bits);
    const int first_known = by_index.empty() ? last + 1 : by_index.begin()->first;
    for (int n = first; n <= last; ++n) {
        if (const auto at = by_index.find(n); at != by_index.end()) {
            std::ranges::sort(at->second);
            errors[n] = at->second[at->second.size() / 4];
        } else if (n < first_known) {
            errors[n] = exact;  // no regular system so far: an exact equation
        }
    }
    return errors;
}

namespace {

struct jump {
    int index;
    double height;
    double before;  // the largest error of the five before
};

// Among those above the rounding errors of predictions by an exact equation.
std::optional<jump> largest_jump(const std::map<int, double>& errors, double rounding) {
    std::optional<jump> best;
    std::vector<double> previous;
    for (const auto& [index, error] : errors) {
        std::vector<double> five(
            previous.end() - std::min<std::ptrdiff_t>(5, static_cast<std::ptrdiff_t>(previous.size())), previous.end());
        previous.push_back(error);
        std::ranges::sort(five);
        if (five.size() < (five.empty() || five.back() > rounding ? 4U : 3U)) {  // three are enough that are exact
            continue;
        }
        const double height = error - five.back();
        if (error > rounding && height > 2 && error - five[five.size() / 2] > 2.5 && (!best || height > best->height)) {
            best = jump{index, height, five.back()};
        }
    }
    return best;
}

// The largest and the smallest error at the three coefficients after one.
std::pair<double, double> after(const std::map<int, double>& errors, int index) {
    std::pair<double, double> range{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (const auto& [n, error] : errors) {
        if (n > index && n <= index + 3) {
            range = {std::max(range.first, error), std::min(range.second, error)};
        }
    }
    return range;
}

}  // namespace

std::optional<suspect_coefficient> find_suspect(std::span<const mpfr> b, const std::map<int, double>& errors,
                                                double noise, const task_runner& run) {
    const int last = static_cast<int>(b.size()) - 1;
    const double rounding = -0.14 * static_cast<double>(bits_for(last, noise));
    const auto found = largest_jump(errors, rounding);
    if (!found) {
        return std::nullopt;
    }
    const auto at = static_cast<std::size_t>(found->index);
    const auto predicted = predictions(b.first(at), 1, run);
    if (predicted.empty() || predicted.front().value == 0) {
        return std::nullopt;
    }
    const mpfr& value = predicted.front().value;
    suspect_coefficient suspect{found->index, value, predicted.front().uncertainty,
                                mpfr(abs(mpfr(b[at] / value - 1))).convert_to<double>(), false};
    if (found->index > last - 2) {
        return found->height > 4 ? std::optional(suspect) : std::nullopt;
    }
    std::vector<mpfr> repaired(b.begin(), b.end());
    repaired[at] = value;
    const auto again = after(prediction_errors(repaired, std::max(12, found->index - 2), noise, run), found->index);
    const auto given = after(errors, found->index);
    // An equation of higher order, (D - n) L f = 0, may hold for the wrong coefficient, too, a few coefficients later.
    const double reached = std::max(given.second - 1, std::min(given.first - 1, rounding));
    suspect.confirmed = again.first < std::max(found->before, -60.0) + 1.7 && again.first < reached;
    return suspect.confirmed ? std::optional(suspect) : std::nullopt;
}

std::vector<predicted_coefficient> predictions_for(const series_list& list, int count, const task_runner& run) {
    const precision_scope scope(decimal_digits(bits_for(list.order()) + 64));
    const coefficient_pattern pattern = pattern_of(list);
    const int first = pattern.first % pattern.stride;
    const auto b = class_of(list, pattern);
    std::vector<predicted_coefficient> found;
    const auto in_class = predictions(b, count / pattern.stride + 1, run);
    for (int n = list.order() + 1; n <= list.order() + count; ++n) {
        if (n % pattern.stride != first) {
            found.push_back({n, mpfr(0), mpfr(0)});
            continue;
        }
        const int k = (n - first) / pattern.stride;
        const auto at = std::ranges::find(in_class, k, &predicted_coefficient::index);
        if (at == in_class.end()) {
            break;
        }
        found.push_back({n, at->value, at->uncertainty});
    }
    return found;
}

std::optional<exponent_estimate> biased_exponent(const list_verdict& verdict, const mpfr& x) {
    if (!verdict.exponent || !verdict.position || verdict.position->im != 0) {
        return std::nullopt;
    }
    constexpr int widening = 8;
    const mpfr moved = x / verdict.position->re - 1;
    return exponent_estimate{mpfr(*verdict.exponent + moved * verdict.slope), mpfr(widening * verdict.residual)};
}

}  // namespace libration::convergence
