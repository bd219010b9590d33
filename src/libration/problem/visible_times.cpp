// The span of time in which a solution with limits at infinity moves visibly.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "found_values.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/problem/limit_solution.hpp"

namespace libration {

namespace {

constexpr int digits_of_sight = 12;
constexpr int samples_of_sight = 32;
constexpr int most_spans = 12;
constexpr double first_span = 4;
constexpr double still_visible = 0.0025;
constexpr int digits_of_drawn_times = 7;

double number_of(const answer_value& value) {
    return value.text.empty() || value.text == "inf" ? std::numeric_limits<double>::quiet_NaN() : std::stod(value.text);
}

exact time_near(double time, int digits) {
    std::array<char, 40> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), time, std::chars_format::general, digits).ptr;
    return read_exact({text.data(), static_cast<std::size_t>(end - text.data())});
}

// The number of the first sample from which on every quantity stays near to its limit, in the last row.
int first_at_rest(const answer& samples) {
    const std::size_t count = samples.rows.size() - 1;
    std::size_t first = 0;
    for (std::size_t k = 0; k < samples.names.size(); ++k) {
        const double limit = number_of(samples.rows.back()[k]);
        double variation = 0;
        for (std::size_t i = 0; i < count && std::isfinite(limit); ++i) {
            variation = std::max(variation, std::fabs(number_of(samples.rows[i][k]) - limit));
        }
        for (std::size_t i = 0; i < count && std::isfinite(limit); ++i) {
            if (std::fabs(number_of(samples.rows[i][k]) - limit) > still_visible * variation) {
                first = std::max(first, i + 1);
            }
        }
    }
    return static_cast<int>(first);
}

}  // namespace

// In spans twice as long each time, until the last quarter of one is at rest.
double limit_solution::last_visible(int direction, double from, const request& how) const {
    const exact end{0, unit::one, direction > 0 ? "inf" : "-inf"};
    for (int k = 0;; ++k) {
        const double span = std::ldexp(first_span, k);
        std::vector<exact> times;
        for (int i = 0; i <= samples_of_sight; ++i) {
            times.push_back(time_near(from + direction * span * i / samples_of_sight, digits_of_sight));
        }
        times.push_back(end);
        const answer samples = states(times, {}, how);
        if (std::ranges::any_of(samples.rows, [](const auto& row) { return row.empty(); })) {
            throw error(*samples.missing);
        }
        const int last = first_at_rest(samples);
        if (last <= 3 * samples_of_sight / 4 || k == most_spans) {
            return from + direction * span * std::max(last, 1) / samples_of_sight;
        }
    }
}

std::vector<exact> limit_solution::visible_times(long count, const request& how) const {
    request rough = how;
    rough.scalar = {scalar_kind::proved, digits_of_sight};
    rough.digits = 0;
    rough.check = false;
    const bool to_end = std::ranges::any_of(
        of_.conditions, [](const std::string& each) { return each.find("(-inf)") == std::string::npos; });
    const double point =
        two_ends_ ? 0 : ode::constant_value<double>::of(ode::explicit_system(of_.of.equations()).point());
    const double last = to_end ? last_visible(1, point, rough) : point;
    const double first = two_ends_ || !to_end ? last_visible(-1, point, rough) : point;
    std::vector<exact> times;
    for (long i = 0; i < count; ++i) {
        times.push_back(time_near(first + (last - first) * static_cast<double>(i) / static_cast<double>(count - 1),
                                  digits_of_drawn_times));
    }
    return times;
}

}  // namespace libration
