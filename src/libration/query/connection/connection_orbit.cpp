#include "connection_orbit.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "../../algebra/dense_matrix.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "marched_states.hpp"

namespace libration::ode {

namespace {

constexpr long digits_of_phase = 15;

}  // namespace

connection_orbit::connection_orbit(connection_map map, std::vector<std::string> unknowns,
                                   std::vector<limit_condition> limits, std::vector<ball> x)
    : map_(std::move(map)), unknowns_(std::move(unknowns)), limits_(std::move(limits)), x_(std::move(x)) {
    for (const std::size_t k : map_.right().moving()) {
        if (!map_.has_two_ends() || std::ranges::find(map_.left().moving(), k) != map_.left().moving().end()) {
            places_.push_back(k);
            names_.push_back(map_.form().names[k]);
        }
    }
    if (!map_.has_two_ends()) {
        phase_ = constant_value<ball>::of(map_.open().system.point());
        return;
    }
    const auto numbers = map_.numbers_of_left(x_);
    const auto by = slowest_of(map_.left(), numbers);
    if (!by) {
        return;
    }
    for (const limit_condition& each : limits_) {
        if (each.direction > 0) {
            continue;
        }
        const std::string name = primed(each.of.name(), each.of.derivative());
        const ball amplitude = amplitude_at(map_.left(), *by, name, map_.theta_at_start(x_)[by->direction]);
        if (!contains_zero(amplitude)) {  // else it has no part of this rate, or is not decided
            phase_ = -log(abs(amplitude)) / by->rate;
            of_phase_ = name;
            sign_of_phase_ = arb_is_positive(amplitude.handle()) != 0 ? 1 : -1;
            rate_of_phase_ = by->rate;
            return;
        }
    }
}

std::optional<connection_orbit::slowest> connection_orbit::slowest_of(const manifold_end& end,
                                                                      const std::vector<ball>& numbers) const {
    auto decay = end.decay_at(numbers);
    if (!decay || decay->rates.empty()) {
        return std::nullopt;
    }
    std::size_t slow = 0;
    for (std::size_t j = 0; j < decay->rates.size(); ++j) {
        slow = as_double(decay->rates[j].re) > as_double(decay->rates[slow].re) ? j : slow;
    }
    for (std::size_t j = 0; j < decay->rates.size(); ++j) {
        if (j != slow && !certainly_less(decay->rates[j].re, decay->rates[slow].re)) {
            return std::nullopt;
        }
    }
    return decay->alone[slow] ? std::optional<slowest>({slow, -decay->rates[slow].re, std::move(decay->columns)})
                              : std::nullopt;
}

// Of an unknown that moves there, in y - y* = A exp(-rate |t|): the linear part of the series.
ball connection_orbit::amplitude_at(const manifold_end& end, const slowest& by, const std::string& name,
                                    const ball& theta) const {
    for (std::size_t row = 0; row < end.moving().size(); ++row) {
        if (map_.form().names[end.moving()[row]] == name) {
            return theta * by.columns[row][by.direction].re;
        }
    }
    return ball(0);
}

std::vector<ball> connection_orbit::theta_at_end() const {
    return {x_.end() - static_cast<std::ptrdiff_t>(map_.right().variables()), x_.end()};
}

// The time of the map, from the start towards the end.
ball connection_orbit::along_solution(const ball& time) const {
    return map_.has_two_ends() ? time + phase_ : (time - phase_) * map_.direction();
}

ball connection_orbit::joining_time() const {
    return map_.has_two_ends() ? exactly(map_.time) - phase_ : phase_ + exactly(map_.time) * map_.direction();
}

void connection_orbit::reflect(const orbit_symmetry& by) {
    for (const std::string& name : names_) {
        for (const expression& each : by.of) {
            if (primed(each.name(), each.derivative()) == name) {
                const auto centre = by.centre_of(each);
                twice_centre_.push_back(centre ? std::optional((2 * *centre).constant()) : std::nullopt);
            }
        }
    }
}

ball connection_orbit::image(std::size_t quantity, const ball& value) const {
    const auto& twice = twice_centre_[quantity];
    return twice ? constant_value<ball>::of(*twice) - value : value;
}

std::optional<std::vector<std::vector<ball>>> connection_orbit::states(const std::vector<ball>& times,
                                                                       long bits) const {
    if (twice_centre_.empty()) {
        return states_of_half(times, bits);
    }
    const precision_scope scope(decimal_digits(bits));
    std::vector<ball> later;
    std::vector<bool> is_image;
    for (const ball& each : times) {
        is_image.push_back(certainly_less(along_solution(each), ball(0)));
        later.push_back(is_image.back() ? phase_ * 2 - each : each);
    }
    auto states = states_of_half(later, bits);
    for (std::size_t i = 0; states && i < times.size(); ++i) {
        for (std::size_t k = 0; is_image[i] && k < names_.size(); ++k) {
            (*states)[i][k] = image(k, (*states)[i][k]);
        }
    }
    return states;
}

std::optional<std::vector<std::vector<ball>>> connection_orbit::states_of_half(const std::vector<ball>& times,
                                                                               long bits) const {
    const precision_scope scope(decimal_digits(bits));
    std::vector<ball> flow, end, start;
    std::vector<std::size_t> group(times.size());
    const ball latest = exactly(map_.time);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const ball at = along_solution(times[i]);
        if (certainly_less(latest, at)) {
            end.push_back(at - latest);
            group[i] = 1;
        } else if (map_.has_two_ends() && certainly_less(at, ball(0))) {
            start.push_back(-at);
            group[i] = 2;
        } else {
            flow.push_back(at);
        }
    }
    auto at_end = on_manifold(map_.right(), map_.numbers_of_right(x_), theta_at_end(), end, bits);
    auto at_start = map_.has_two_ends()
                        ? on_manifold(map_.left(), map_.numbers_of_left(x_), map_.theta_at_start(x_), start, bits)
                        : std::vector<std::vector<ball>>();
    if (!at_end) {  // where the motion on the manifold is not linear
        for (ball& each : end) {
            each += latest;
        }
        at_end = marched(end, bits);
    }
    if (!at_start) {
        for (ball& each : start) {
            each = -each;
        }
        at_start = marched(start, bits);
    }
    auto between = marched(flow, bits);
    if (!at_end || !at_start || !between) {
        return std::nullopt;
    }
    std::vector<std::vector<ball>> result;
    std::array<std::size_t, 3> next{};
    const std::array<std::vector<std::vector<ball>>*, 3> from{&*between, &*at_end, &*at_start};
    for (const std::size_t each : group) {
        result.push_back(std::move((*from[each])[next[each]++]));
    }
    return result;
}

std::optional<std::vector<std::vector<ball>>> connection_orbit::on_manifold(const manifold_end& end,
                                                                            const std::vector<ball>& numbers,
                                                                            const std::vector<ball>& theta,
                                                                            const std::vector<ball>& times,
                                                                            long bits) const {
    if (times.empty()) {
        return std::vector<std::vector<ball>>();
    }
    const auto found = end.along(numbers, theta, times, map_.degree_for(bits));
    if (!found) {
        return std::nullopt;
    }
    std::vector<std::vector<ball>> result;
    for (const auto& state : *found) {
        auto& row = result.emplace_back();
        for (const std::size_t k : places_) {
            row.push_back(state[static_cast<std::size_t>(std::ranges::find(end.moving(), k) - end.moving().begin())]);
        }
    }
    return result;
}

// At times of the map, by the flow from the start.
std::optional<std::vector<std::vector<ball>>> connection_orbit::marched(const std::vector<ball>& times,
                                                                        long bits) const {
    if (times.empty()) {
        return std::vector<std::vector<ball>>();
    }
    const auto from = map_.start_at(x_, bits, run_bits::usual_error_bits);
    std::vector<ball> at;
    for (const ball& each : times) {
        at.push_back(constant_value<ball>::of(map_.open().system.point()) + each * map_.direction());
    }
    const auto states = from ? marched_states(map_.open().system, from->values, at, bits, map_.route()) : std::nullopt;
    if (!states) {
        return std::nullopt;
    }
    std::vector<std::vector<ball>> result;
    for (const auto& state : *states) {
        auto& row = result.emplace_back();
        for (const std::size_t k : places_) {
            row.push_back(state[k]);
        }
    }
    return result;
}

std::vector<ball> connection_orbit::limits(int direction) const {
    const bool at_start = map_.has_two_ends() && direction < 0;
    const manifold_end& end = at_start ? map_.left() : map_.right();
    const auto values = end.rest_at(at_start ? map_.numbers_of_left(x_) : map_.numbers_of_right(x_));
    std::vector<ball> result;
    for (const std::size_t k : places_) {
        const ball& at = values[static_cast<std::size_t>(std::ranges::find(end.moving(), k) - end.moving().begin())];
        result.push_back(direction < 0 && !twice_centre_.empty() ? image(result.size(), at) : at);
    }
    return result;
}

std::string connection_orbit::phase() const {
    if (!map_.has_two_ends()) {
        return "";
    }
    if (of_phase_.empty()) {
        return "t = 0 is where the series of the unstable manifold is left, since no unknown with a limit at -inf has "
               "a proved part of one slowest real rate there";
    }
    const auto rate =
        to_proved_decimal(rate_of_phase_, std::min(digits_of_phase, proved_digits(rate_of_phase_, digits_of_phase)));
    return of_phase_ + " = " + of_phase_ + "(-inf) " + (sign_of_phase_ > 0 ? "+" : "-") + " exp(" +
           (rate ? rate->text : "r") + " t) + smaller terms as t -> -inf, which fixes t = 0";
}

std::vector<std::pair<std::string, ball>> connection_orbit::amplitudes() const {
    std::vector<std::pair<std::string, ball>> result;
    const auto by = slowest_of(map_.right(), map_.numbers_of_right(x_));
    if (!by || (map_.has_two_ends() && of_phase_.empty())) {
        return result;
    }
    const ball theta = theta_at_end()[by->direction] * exp(by->rate * joining_time() * map_.direction());
    for (const limit_condition& each : limits_) {
        if (each.direction == map_.direction()) {
            const std::string name = primed(each.of.name(), each.of.derivative());
            result.emplace_back("amplitude of " + name, amplitude_at(map_.right(), *by, name, theta));
        }
    }
    return result;
}

std::vector<std::pair<std::string, ball>> connection_orbit::rates_at_start() const {
    std::vector<std::pair<std::string, ball>> result;
    const auto decay = map_.has_two_ends() ? map_.left().decay_at(map_.numbers_of_left(x_)) : std::nullopt;
    std::vector<ball> rates;
    for (std::size_t j = 0; decay && j < decay->rates.size(); ++j) {
        rates.push_back(-decay->rates[j].re);
    }
    std::ranges::stable_sort(rates, {}, [](const ball& each) { return as_double(each); });
    for (const ball& each : rates) {
        result.emplace_back("rate " + std::to_string(result.size() + 1) + " at -inf", each);
    }
    return result;
}

}  // namespace libration::ode
