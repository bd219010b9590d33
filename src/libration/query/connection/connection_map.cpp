#include "connection_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "../../algebra/dense_matrix.hpp"
#include "libration/equation/polynomial_form.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr long bits_beyond = 10;
constexpr int least_degree = 6;

parametric_system opened_for(const equation_system& system, const std::vector<std::string>& unknowns,
                             const std::vector<limit_condition>& limits) {
    std::vector<expression> values;
    std::vector<std::string> of;
    for (const limit_condition& each : limits) {
        values.push_back(each.value);
        of.push_back(each.of.name());
    }
    return closed_part(opened(system, unknowns, values), of);
}

// The free numbers of the constant unknowns of the system, as leaves.
std::vector<std::pair<std::size_t, expression>> constants_of(const parametric_system& open,
                                                             const first_order_form& form) {
    std::vector<std::pair<std::size_t, expression>> result;
    for (std::size_t k = 0; k < form.leaves.size(); ++k) {
        for (const expression& leaf : open.leaves) {
            if (form.slopes[k].is(0) && same_form(open.starts[k], leaf)) {
                result.emplace_back(k, leaf);
            }
        }
    }
    return result;
}

// The end in a direction.
std::optional<manifold_end> end_in(const parametric_system& open, const first_order_form& form,
                                   const polynomial_form& lifted, const std::vector<limit_condition>& limits,
                                   int direction) {
    auto known = constants_of(open, form);
    bool any = false;
    std::string texts;
    for (std::size_t i = 0; i < limits.size(); ++i) {
        if (limits[i].direction != direction) {
            continue;
        }
        any = true;
        const std::string name = primed(limits[i].of.name(), limits[i].of.derivative());
        const auto place = std::ranges::find(form.names, name);
        if (place == form.names.end()) {
            throw error(error_kind::argument, error_subject::condition, limits[i].text,
                        "is not about an unknown or a lower derivative: choose one of those that are integrated");
        }
        known.emplace_back(static_cast<std::size_t>(place - form.names.begin()), open.others[i]);
        texts += (texts.empty() ? "" : "; ") + limits[i].text;
    }
    const auto rest = [&] {
        try {
            return far_state_of(form, known, direction);
        } catch (const error& problem) {
            throw error(problem.kind(), error_subject::condition, texts, problem.reason());
        }
    };
    return any ? std::optional<manifold_end>(std::in_place, form, lifted, rest(), open.leaves, direction)
               : std::nullopt;
}

void require_autonomous(const first_order_form& form, const explicit_system& system) {
    for (const expression& each : form.slopes) {
        if (each.has_variable()) {
            throw error(error_kind::undecided, error_subject::problem, system.variable(),
                        "occurs in the equation: conditions at infinity require an autonomous system with an "
                        "equilibrium, a sum of powers c t^p y^q y'^r, a polynomial in u, u' and 1/t with one unknown "
                        "initial value, or one linear equation y'' + p(t) y' = q(t) y with y(inf) = 0");
        }
    }
}

std::vector<ball> part_of(const std::vector<ball>& x, std::size_t first, std::size_t count) {
    return {x.begin() + static_cast<std::ptrdiff_t>(first), x.begin() + static_cast<std::ptrdiff_t>(first + count)};
}

}  // namespace

connection_map::connection_map(const equation_system& system, const std::vector<std::string>& unknowns,
                               const std::vector<limit_condition>& limits, proof_route route, march_watch watch)
    : open_(opened_for(system, unknowns, limits)),
      form_(open_.system),
      route_(std::move(route)),
      watch_(std::move(watch)) {
    require_autonomous(form_, open_.system);
    const polynomial_form lifted = lifted_about_points(open_.system);
    right_ = end_in(open_, form_, lifted, limits, 1);
    auto other = end_in(open_, form_, lifted, limits, -1);
    if (!right_) {
        right_ = std::move(other);
        direction_ = -1;
    } else {
        left_ = std::move(other);
    }
    fast_ = std::ranges::any_of(limits, &limit_condition::fast);
    for (const expression& each : open_.starts) {
        auto& row = by_start_.emplace_back();
        for (const expression& leaf : open_.leaves) {
            row.push_back(partial(each, leaf));
        }
    }
}

bool connection_map::depends_on_numbers() const {
    return !constants_of(open_, form_).empty() ||
           std::ranges::any_of(open_.others, [](const expression& each) { return !each.is_constant(); });
}

std::size_t connection_map::coordinates() const { return left_coordinates() + right_coordinates(); }

std::size_t connection_map::size() const {
    return numbers() + coordinates() + (has_angle() ? 1 : 0) + right_->variables();
}

std::vector<std::string> connection_map::names(const std::vector<std::string>& unknowns) const {
    auto result = unknowns;
    if (left_) {
        result.insert(result.end(), left_->rest().names.begin(), left_->rest().names.end());
    }
    result.insert(result.end(), right_->rest().names.begin(), right_->rest().names.end());
    if (has_angle()) {
        result.emplace_back("angle");
    }
    for (std::size_t j = 0; j < right_->variables(); ++j) {
        result.push_back("theta_" + std::to_string(j + 1));
    }
    return result;
}

bool connection_map::choose(const std::vector<double>& at, int side, bool proved) {
    side_ = side;
    const auto split = static_cast<std::ptrdiff_t>(numbers() + left_coordinates());
    const auto all = static_cast<std::size_t>(-1);
    if (left_ && !left_->choose({at.begin(), at.begin() + split}, all, proved)) {
        return false;
    }
    const std::size_t others =
        numbers() + coordinates() + (left_ && left_->variables() > 0 ? left_->variables() - 1 : 0);
    const bool limited = fast_ && dimension() > others;
    return right_->choose(right_numbers(at), limited ? dimension() - others : all, proved);
}

std::vector<double> connection_map::right_numbers(const std::vector<double>& x) const {
    std::vector<double> result(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(numbers()));
    const auto from = x.begin() + static_cast<std::ptrdiff_t>(numbers() + left_coordinates());
    result.insert(result.end(), from, from + static_cast<std::ptrdiff_t>(right_coordinates()));
    return result;
}

std::vector<ball> connection_map::numbers_of_left(const std::vector<ball>& x) const {
    return part_of(x, 0, numbers() + left_coordinates());
}

std::vector<ball> connection_map::numbers_of_right(const std::vector<ball>& x) const {
    auto result = part_of(x, 0, numbers());
    const auto more = part_of(x, numbers() + left_coordinates(), right_coordinates());
    result.insert(result.end(), more.begin(), more.end());
    return result;
}

int connection_map::degree_for(long bits) const {
    return degree > 0 ? degree
                      : std::max(least_degree, static_cast<int>(std::ceil(static_cast<double>(bits + bits_beyond) /
                                                                          -std::log2(std::min(radius, 0.7)))));
}

std::optional<connection_map::start> connection_map::start_at(const std::vector<ball>& x, long bits,
                                                              long error_bits) const {
    if (left_) {
        return start_on_manifold(x, bits);
    }
    expression_values<ball> values(open_.leaves, ball(0));
    for (std::size_t i = 0; i < numbers(); ++i) {
        values.push_back(x[i]);
    }
    start result;
    for (std::size_t i = 0; i < open_.starts.size(); ++i) {
        result.values.push_back(values.of(open_.starts[i]));
        auto& row = result.by_unknowns.emplace_back(x.size(), ball(0));
        for (std::size_t j = 0; j < numbers(); ++j) {
            row[j] = values.of(by_start_[i][j]);
        }
    }
    if (begins) {
        const auto first = begins(part_of(x, 0, numbers()), bits, error_bits);
        if (!first) {
            return std::nullopt;
        }
        for (std::size_t i = 0; i < first->values.size(); ++i) {
            result.values[i] = first->values[i];
            std::ranges::copy(first->by_numbers[i], result.by_unknowns[i].begin());
        }
    }
    return result;
}

std::vector<ball> connection_map::theta_at_start(const std::vector<ball>& x) const {
    const ball size = exactly(side_ * left_->good_radius());
    if (!has_angle()) {
        return {size};
    }
    const ball& angle = x[numbers() + coordinates()];
    return {size * cos(angle), size * sin(angle)};
}

std::optional<connection_map::start> connection_map::start_on_manifold(const std::vector<ball>& x, long bits) const {
    if (left_->variables() == 0) {
        return std::nullopt;  // for these numbers no solution leaves the equilibrium
    }
    const std::size_t first = numbers() + left_coordinates();
    const std::size_t angle = numbers() + coordinates();
    const auto theta = theta_at_start(x);
    const auto by_angle = has_angle() ? std::vector<ball>{-theta[1], theta[0]} : std::vector<ball>{ball(0)};
    const auto at = left_->at(numbers_of_left(x), theta, degree_for(bits), degree == 0);
    if (!at) {
        return std::nullopt;
    }
    start result;
    for (std::size_t k = 0; k < open_.starts.size(); ++k) {
        auto& row = result.by_unknowns.emplace_back(x.size(), ball(0));
        const auto place = std::ranges::find(left_->moving(), k);
        if (place == left_->moving().end()) {
            const auto leaf =
                std::ranges::find_if(open_.leaves, [&](const expression& e) { return same_form(e, open_.starts[k]); });
            const auto i = static_cast<std::size_t>(leaf - open_.leaves.begin());
            result.values.push_back(x[i]);
            row[i] = ball(1);
            continue;
        }
        const auto i = static_cast<std::size_t>(place - left_->moving().begin());
        result.values.push_back(at->value[i]);
        for (std::size_t j = 0; j < first; ++j) {
            row[j] = at->by_numbers[i][j];
        }
        if (has_angle()) {
            row[angle] = at->by_theta[i][0] * by_angle[0] + at->by_theta[i][1] * by_angle[1];
        }
    }
    return result;
}

std::vector<double> connection_map::start_near(const std::vector<double>& x) const {
    const precision_scope scope(decimal_digits(128));
    std::vector<ball> at;
    at.reserve(x.size());
    for (const double each : x) {
        at.push_back(exactly(each));
    }
    const auto there = start_at(at, 128, run_bits::usual_error_bits);
    std::vector<double> result;
    for (std::size_t k = 0; there && k < there->values.size(); ++k) {
        result.push_back(as_double(there->values[k]));
    }
    return result;
}

std::optional<enclosed_map> connection_map::operator()(const std::vector<ball>& x, long bits, long error_bits) const {
    const precision_scope scope(decimal_digits(bits));
    const auto from = start_at(x, bits, error_bits);
    if (!from) {
        return std::nullopt;
    }
    const std::size_t first = size() - right_->variables();
    const auto end =
        right_->at(numbers_of_right(x), part_of(x, first, right_->variables()), degree_for(bits), degree == 0);
    if (!end) {
        return std::nullopt;
    }
    proved_march march(open_.system, from->values, bits, error_bits, watch_, route_);
    march.keep_derivative();
    const ball target = constant_value<ball>::of(open_.system.point()) + exactly(direction_ * time);
    const auto state = march.at(target);
    if (!state) {
        return std::nullopt;
    }
    const ball_matrix flow = product(march.derivative_at(target), from->by_unknowns);
    enclosed_map result;
    for (std::size_t i = 0; i < right_->moving().size(); ++i) {
        const std::size_t k = right_->moving()[i];
        result.value.push_back((*state)[k] - end->value[i]);
        auto& row = result.derivative.emplace_back(flow[k]);
        for (std::size_t j = 0; j < numbers(); ++j) {
            row[j] -= end->by_numbers[i][j];
        }
        for (std::size_t j = 0; j < right_coordinates(); ++j) {
            row[numbers() + left_coordinates() + j] -= end->by_numbers[i][numbers() + j];
        }
        for (std::size_t j = 0; j < right_->variables(); ++j) {
            row[first + j] -= end->by_theta[i][j];
        }
    }
    return result;
}

}  // namespace libration::ode
