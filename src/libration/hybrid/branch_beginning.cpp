#include "branch_beginning.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "libration/equation/constant_value.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/equation/identities.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/scalar/ball/magnitude.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

// A ball that contains a neighbourhood of each of its points, by half of the working precision.
ball neighbourhood(const ball& x) {
    const magnitude size = magnitude(x) + magnitude(1U);
    return widened(x, size.shifted(-static_cast<long>(mpfr_get_prec(handle(mpfr()))) / 2));
}

bool is_short_fraction(const number& x) {
    constexpr std::size_t most_bits = 4096;
    const auto bits = [](const integer& n) { return mpz_sizeinbase(n.backend().data(), 2); };
    const auto fraction = x.fraction();
    return fraction && bits(numerator(*fraction)) <= most_bits && bits(denominator(*fraction)) <= most_bits;
}

}  // namespace

std::vector<expression> slopes_in_given(const explicit_system& system) {
    const first_order_form form(system);
    std::vector<expression> slopes;
    for (const expression& each : form.slopes) {
        slopes.push_back(with_leaves(each, form.leaves, form.given));
    }
    return slopes;
}

void put_kept(const kept_values& kept, std::vector<ball>& state) {
    for (std::size_t k = 0; k < kept.size(); ++k) {
        state[k] = kept[k] ? enclosed_number(*kept[k]) : state[k];
    }
}

number number_of(const ball& exact) {
    rational value;
    mpfr_get_q(value.backend().data(), handle(midpoint_of(exact)));
    return number(value);
}

ball enclosed_number(const number& x) { return constant_value<ball>::of(x); }

std::vector<number> midpoints_of(const std::vector<ball>& state) {
    std::vector<number> all;
    std::ranges::transform(state, std::back_inserter(all), [](const ball& x) { return number_of(midpoint_alone(x)); });
    return all;
}

branch_beginning::branch_beginning(const hybrid_system& system)
    : branch_beginning(system, enclosed_number(system.point()), system.point(), {}, {}, {}) {
    state_.clear();
    near_state_.clear();
    for (const number& each : system.starts()) {
        reset_.emplace_back(each);
        state_.push_back(enclosed_number(each));
        near_state_.push_back(neighbourhood(state_.back()));
    }
    midpoints_ = system.starts();
}

branch_beginning::branch_beginning(const hybrid_system& system, ball time, std::optional<number> exactly,
                                   std::vector<expression> reset, std::vector<expression> zero, std::vector<ball> state,
                                   kept_values kept)
    : system_(system),
      time_(std::move(time)),
      exactly_(std::move(exactly)),
      reset_(std::move(reset)),
      zero_(std::move(zero)),
      kept_(std::move(kept)),
      state_(std::move(state)),
      near_time_(neighbourhood(time_)),
      point_(exactly_ ? *exactly_ : number_of(lower_bound(time_))),
      midpoints_(midpoints_of(state_)) {
    std::ranges::transform(state_, std::back_inserter(near_state_), neighbourhood);
    for (std::size_t k = 0; k < system.leaves().size(); ++k) {
        plain_leaves_.push_back(unknown("y" + std::to_string(k)));
    }
}

ball branch_beginning::value_at(const expression& e, const std::vector<ball>& state, const ball& time) const {
    expression_values<ball> values(plain_leaves_, time);
    for (const ball& each : state) {
        values.push_back(each);
    }
    return values.of(with_leaves(e, system_.leaves(), plain_leaves_));
}

ball branch_beginning::value(const expression& e) const { return value_at(e, state_, time_); }

bool branch_beginning::is_finite_near(const expression& e) const {
    return is_finite(value_at(e, near_state_, near_time_));
}

std::optional<std::vector<expression>> branch_beginning::slopes_on(const step_values& values) const {
    try {
        const explicit_system branch = system_.branch(values, point_, midpoints_);
        if (branch.singular()) {
            return std::nullopt;
        }
        auto slopes = slopes_in_given(branch);
        const bool finite = std::ranges::all_of(slopes, [&](const expression& e) { return is_finite_near(e); });
        return finite ? std::optional(std::move(slopes)) : std::nullopt;
    } catch (const error&) {  // a function outside its domain, or equations that cannot be solved
        return std::nullopt;
    }
}

// With t* and the values before the event where they are known exactly.
expression branch_beginning::with_known_values(const expression& e) const {
    if (!exactly_ && std::ranges::none_of(kept_, [](const auto& each) { return each.has_value(); })) {
        return e;
    }
    return replaced(e, [&](const expression& leaf) -> std::optional<expression> {
        if (leaf.kind() == node_kind::variable) {
            return exactly_ ? std::optional(expression(*exactly_)) : std::nullopt;
        }
        for (std::size_t k = 0; k < kept_.size(); ++k) {
            if (kept_[k] && same_form(leaf, system_.leaves()[k])) {
                return expression(*kept_[k]);
            }
        }
        return std::nullopt;
    });
}

// In terms of the values before the event.
expression branch_beginning::before(const expression& e) const {
    return with_known_values(with_leaves(e, system_.leaves(), reset_));
}

std::optional<number> branch_beginning::exact_value(const expression& e) const {
    try {
        const expression value = before(e);
        return value.kind() == node_kind::constant ? std::optional(value.constant()) : std::nullopt;
    } catch (const error&) {  // a function outside its domain, or a number that may be 0
        return std::nullopt;
    }
}

kept_values branch_beginning::kept() const {
    kept_values all;
    for (const expression& leaf : system_.leaves()) {
        all.push_back(system_.is_kept(leaf) ? exact_value(leaf) : std::nullopt);
        if (all.back() && !kept_.empty() && is_reset(leaf) && !is_short_fraction(*all.back())) {
            all.back().reset();  // many resets would make it long
        }
    }
    return all;
}

bool branch_beginning::is_zero(const expression& in_values_before) const {
    return is_identically_zero(in_values_before) || std::ranges::any_of(zero_, [&](const expression& each) {
               const expression zero = with_known_values(each);
               return zero.kind() != node_kind::constant && vanishes_with(in_values_before, zero);
           });
}

std::optional<std::string> branch_beginning::reason_without_value(const expression& e) const {
    try {
        before(e);
        return std::nullopt;
    } catch (const error& none) {
        return none.reason();
    }
}

std::optional<int> branch_beginning::sign(const expression& e) const {
    if (const int known = known_sign(value(e)); known != 0) {
        return known;
    }
    if (const auto exact = exact_value(e)) {
        return exact->sign();
    }
    try {
        return is_zero(before(e)) ? std::optional(0) : std::nullopt;
    } catch (const error&) {  // a function outside its domain, or a number that may be 0
        return std::nullopt;
    }
}

std::optional<int> branch_beginning::sign_after(const expression& e) const {
    expression derivative = e;
    for (int order = 0; order <= most_orders; ++order) {
        const auto here = sign(derivative);
        if (!here || *here != 0 || e.has_unknowns()) {
            return here;
        }
        derivative = partial(derivative, variable());
    }
    return is_identically_zero(e) ? std::optional(0) : std::nullopt;
}

expression branch_beginning::derivative(const expression& g, const std::vector<expression>& slopes) const {
    return partial(g, variable()) + derivative_along(g, system_.leaves(), slopes);
}

std::optional<leading_derivative> branch_beginning::leading(const expression& g,
                                                            const std::vector<expression>& slopes) const {
    expression now = g;
    for (int order = 0; order <= most_orders; ++order) {
        const auto here = sign(now);
        if (!here || *here != 0) {
            return here ? std::optional(leading_derivative{order, *here}) : std::nullopt;
        }
        now = derivative(now, slopes);
        if (vanishes_with(now, g)) {
            return leading_derivative{order, 0};
        }
    }
    return std::nullopt;
}

std::optional<branch_beginning::integers> branch_beginning::integers_of(const expression& u,
                                                                        const number& divisor) const {
    if (const auto exact = exact_value(u)) {
        const number below = floor_of(*exact, divisor);
        return integers{below, (*exact - below * divisor).sign() == 0};
    }
    const ball quotient = value(u) / enclosed_number(divisor);
    if (!is_finite(quotient)) {
        return std::nullopt;
    }
    const auto floor_of = [](const ball& exact) {
        rational at;
        mpfr_get_q(at.backend().data(), handle(midpoint_of(exact)));
        integer n;
        mpz_fdiv_q(n.backend().data(), mpq_numref(at.backend().data()), mpq_denref(at.backend().data()));
        return std::pair(n, n == at);
    };
    const auto [least, is_integer] = floor_of(lower_bound(quotient));
    const auto [most, ends_at_integer] = floor_of(upper_bound(quotient));
    if (least == most) {
        return integers{number(rational(most)), is_integer};
    }
    return most - least == 1 && !is_integer ? std::optional(integers{number(rational(most)), true}) : std::nullopt;
}

}  // namespace libration::ode
