#include "shooting.hpp"

#include <algorithm>

#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

// The conditions, then the times of their values.
std::vector<expression> expressions_in(const conditions_at_times& conditions) {
    std::vector<expression> all = conditions.differences();
    for (const value_at_time& each : conditions.values()) {
        all.push_back(each.time);
    }
    return all;
}

std::vector<std::string> unknowns_of_values(const conditions_at_times& conditions) {
    if (conditions.values().empty()) {
        throw error(error_kind::argument, error_subject::conditions, "",
                    "contain no value of an unknown: add one, as y(1) = 0");
    }
    std::vector<std::string> names;
    for (const value_at_time& each : conditions.values()) {
        names.push_back(each.of.name());
    }
    return names;
}

std::vector<expression> partials_of(const expression& e, const std::vector<expression>& leaves) {
    std::vector<expression> result;
    result.reserve(leaves.size());
    for (const expression& leaf : leaves) {
        result.push_back(partial(e, leaf));
    }
    return result;
}

}  // namespace

bool shooting::moment::is_fixed() const {
    return std::ranges::all_of(slopes, [](const expression& each) { return each.is(0); });
}

shooting::shooting(const equation_system& given, const std::vector<std::string>& names,
                   const conditions_at_times& conditions, const proof_route& route, march_watch watch)
    : shooting(opened(given, names, expressions_in(conditions)), conditions, route, std::move(watch)) {}

shooting::shooting(const parametric_system& open, conditions_at_times conditions, const proof_route& route,
                   march_watch watch)
    : open_(closed_part(open, unknowns_of_values(conditions))),
      conditions_(std::move(conditions)),
      leaves_(open_.leaves),
      route_(route),
      watch_(std::move(watch)) {
    leaves_.insert(leaves_.end(), conditions_.leaves().begin(), conditions_.leaves().end());
    for (const expression& each : open_.starts) {
        by_start_.push_back(partials_of(each, open_.leaves));
    }
    read_moments();
    for (std::size_t i = 0; i < conditions_.differences().size(); ++i) {
        gradients_.push_back(partials_of(open_.others[i], leaves_));
    }
}

void shooting::read_moments() {
    const std::size_t first_time = conditions_.differences().size();
    for (std::size_t k = 0; k < conditions_.values().size(); ++k) {
        const expression& time = open_.others[first_time + k];
        auto found = std::ranges::find_if(moments_, [&](const moment& each) { return same_form(each.time, time); });
        if (found == moments_.end()) {
            moments_.push_back({time, partials_of(time, open_.leaves), {}});
            found = moments_.end() - 1;
        }
        found->values.emplace_back(index_in_state(conditions_.values()[k].of), k);
    }
    if (!std::ranges::all_of(moments_, &moment::is_fixed)) {
        form_.emplace(open_.system);
    }
}

std::size_t shooting::index_in_state(const expression& of) const {
    const auto names = names_of_state(open_.system);
    const std::string name = primed(of.name(), of.derivative());
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) {
        refuse(name, {}, "is not part of the state in a condition: choose an unknown or a lower derivative");
    }
    return static_cast<std::size_t>(found - names.begin());
}

shooting::start shooting::start_at(number_values& numbers) const {
    start result;
    for (std::size_t i = 0; i < open_.starts.size(); ++i) {
        result.values.push_back(numbers.of(open_.starts[i]));
        auto& row = result.by_numbers.emplace_back();
        for (const expression& each : by_start_[i]) {
            row.push_back(numbers.of(each));
        }
    }
    return result;
}

std::vector<shooting::timed_moment> shooting::in_order(number_values& numbers) const {
    std::vector<timed_moment> order;
    for (const moment& each : moments_) {
        order.push_back({&each, numbers.of(each.time)});
    }
    std::ranges::stable_sort(
        order, [](const timed_moment& a, const timed_moment& b) { return midpoint_of(a.time) < midpoint_of(b.time); });
    return order;
}

std::vector<ball> first_iterate(const std::vector<number>& guess) {
    const precision_scope scope(decimal_digits(bits_of_first_iterate));
    std::vector<ball> midpoints;
    for (const number& each : guess) {
        midpoints.push_back(exact_midpoint(constant_value<ball>::of(each)));
    }
    return midpoints;
}

std::optional<enclosed_map> shooting::operator()(const std::vector<ball>& x, long bits, long error_bits) const {
    const precision_scope scope(decimal_digits(bits));
    number_values numbers(leaves_, ball(0));
    for (const ball& each : x) {
        numbers.push_back(each);
    }
    const start from = start_at(numbers);
    const std::size_t count = conditions_.values().size();
    enclosed_map values{std::vector<ball>(count), ball_matrix(count)};
    const auto order = in_order(numbers);
    const mpfr point = midpoint_of(constant_value<ball>::of(open_.system.point()));
    const auto first_after =
        std::ranges::find_if(order, [&](const timed_moment& each) { return midpoint_of(each.time) >= point; });
    std::vector<timed_moment> backwards(order.begin(), first_after);
    std::ranges::reverse(backwards);
    const std::vector<timed_moment> forwards(first_after, order.end());
    for (const auto& direction : {backwards, forwards}) {
        if (!direction.empty() && !integrate(from, direction, bits, error_bits, numbers, values)) {
            return std::nullopt;
        }
    }
    return conditions_at(numbers, values);
}

bool shooting::integrate(const start& from, const std::vector<timed_moment>& order, long bits, long error_bits,
                         number_values& numbers, enclosed_map& values) const {
    proved_march march(open_.system, from.values, bits, error_bits, watch_, route_);
    march.keep_derivative();
    for (const auto& [what, time] : order) {
        const auto state = march.at(time);
        if (!state) {
            return false;
        }
        const ball_matrix by_numbers = product(march.derivative_at(time), from.by_numbers);
        const auto speed = what->is_fixed() ? std::vector<ball>() : form_->slopes_at(*state, time);
        for (const auto& [place, value] : what->values) {
            values.value[value] = (*state)[place];
            auto& row = values.derivative[value] = by_numbers[place];
            for (std::size_t j = 0; j < row.size() && !speed.empty(); ++j) {
                row[j] += speed[place] * numbers.of(what->slopes[j]);
            }
        }
    }
    return true;
}

enclosed_map shooting::conditions_at(number_values& numbers, const enclosed_map& values) const {
    for (const ball& each : values.value) {
        numbers.push_back(each);
    }
    const std::size_t count = open_.leaves.size();
    enclosed_map result;
    for (std::size_t i = 0; i < gradients_.size(); ++i) {
        result.value.push_back(numbers.of(open_.others[i]));
        auto& row = result.derivative.emplace_back();
        for (std::size_t j = 0; j < count; ++j) {
            row.push_back(numbers.of(gradients_[i][j]));
        }
        for (std::size_t k = 0; k < values.value.size(); ++k) {
            const expression& by_value = gradients_[i][count + k];
            for (std::size_t j = 0; j < count && !by_value.is(0); ++j) {
                row[j] += numbers.of(by_value) * values.derivative[k][j];
            }
        }
    }
    return result;
}

}  // namespace libration::ode
