#include "step_norms.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "libration/function/list.hpp"

namespace libration::ode {

namespace {

[[noreturn]] void refuse_operation() {
    throw std::logic_error("theorem T takes products, sums, quotients and some functions");
}

bool is_relative(function_kind f) {
    return function::with_function(f, [](auto of) { return function::in_table<decltype(of)>; });
}

bool has_kernel(function_kind f) {
    using enum function_kind;
    constexpr std::array kinds{exp, log, sin, sinh, exprel, cosrel};
    return std::ranges::find(kinds, f) != kinds.end();
}

}  // namespace

bool norms_of_steps::bounds(const tape_step& step) {
    switch (step.kind) {
        case operation::primitive: return false;
        case operation::function:
        case operation::companion: return has_kernel(step.function) || step.function == function_kind::sqrt;
        case operation::constant:
        case operation::variable:
        case operation::state:
        case operation::sum:
        case operation::difference:
        case operation::scaled:
        case operation::raised:
        case operation::by_variable:
        case operation::delayed:
        case operation::product:
        case operation::square:
        case operation::quotient:
        case operation::slope:
        case operation::square_root:
        case operation::power: break;
    }
    return true;
}

norms_of_steps::norms_of_steps(const tape& of, const series_sizes& sizes, const magnitude& radius)
    : tape_(of), sizes_(sizes), terms_(static_cast<std::size_t>(sizes.degree)), radius_(radius) {
    magnitude power(1U);
    for (std::size_t j = 0; j <= terms_; ++j) {
        powers_.push_back(power);
        power *= radius;
    }
    all_.reserve(of.steps().size());
    for (std::size_t i = 0; i < of.steps().size(); ++i) {
        all_.push_back(norm_of(of.steps()[i], static_cast<int>(i)));
        all_.back().whole = all_.back().low + all_.back().rest;
    }
}

bool norms_of_steps::are_finite() const {
    return std::ranges::all_of(all_,
                               [](const step_norm& each) { return each.rest.is_finite() && each.low.is_finite(); });
}

std::vector<magnitude> norms_of_steps::changes(const std::function<magnitude(const tape_step& state)>& of_state,
                                               std::size_t steps) const {
    std::vector<magnitude> result;
    result.reserve(steps);
    for (std::size_t k = 0; k < steps; ++k) {
        const tape_step& s = tape_.steps()[k];
        const auto left = [&]() -> const magnitude& { return result[static_cast<std::size_t>(s.left)]; };
        const auto right = [&]() -> const magnitude& { return result[static_cast<std::size_t>(s.right)]; };
        const int index = static_cast<int>(result.size());
        switch (s.kind) {
            case operation::state: result.push_back(of_state(s)); break;
            case operation::sum:
            case operation::difference: result.push_back(left() + right()); break;
            case operation::scaled: result.push_back(left() * factor_of(s)); break;
            case operation::raised: result.push_back(magnitude(left())); break;
            case operation::by_variable: result.push_back(left() * (sizes_.point + radius_)); break;
            case operation::delayed: result.push_back(left() * shift_of(s)); break;
            case operation::product:
                result.push_back(norm(s.left) * right() + left() * norm(s.right) + left() * right());
                break;
            case operation::square: result.push_back(left() * (norm(s.left) + norm(s.left) + left())); break;
            case operation::quotient: result.push_back(change_of_quotient(s, index, left(), right())); break;
            case operation::square_root:
            case operation::power:
            case operation::function: result.push_back(change_of_function(s, index, left())); break;
            case operation::companion:  // a cosine, or not read
                result.push_back(magnitude(result.back()));
                break;
            case operation::constant:
            case operation::variable:
            case operation::slope: result.emplace_back(); break;  // a slope is not read
            case operation::primitive: refuse_operation();
        }
    }
    return result;
}

magnitude norms_of_steps::factor_of(const tape_step& s) const {
    if (s.constant >= 0) {
        return sizes_.constants[static_cast<std::size_t>(s.constant)];
    }
    const auto above = static_cast<unsigned long>(s.numerator < 0 ? -static_cast<long>(s.numerator) : s.numerator);
    return magnitude(above) / static_cast<unsigned long>(s.denominator);
}

norms_of_steps::step_norm norms_of_steps::norm_of(const tape_step& s, int index) const {
    step_norm result;
    const std::vector<magnitude>& a = sizes_.of_steps[static_cast<std::size_t>(index)];
    result.terms.reserve(terms_);
    for (std::size_t j = 0; j < terms_; ++j) {
        result.terms.push_back(a[j] * powers_[j]);
        result.low += result.terms.back();
    }
    switch (s.kind) {
        case operation::square_root:
        case operation::power:
        case operation::function: set_function(result, s, index); break;
        case operation::companion: result.rest = all_.back().rest; break;  // a cosine has the kernel of the sine
        case operation::quotient: result.rest = rest_of_quotient(s, result, index); break;
        case operation::slope: break;
        case operation::constant:
        case operation::variable:
        case operation::state:
        case operation::sum:
        case operation::difference:
        case operation::scaled:
        case operation::raised:
        case operation::by_variable:
        case operation::delayed:
        case operation::product:
        case operation::square:
        case operation::primitive: result.rest = rest_of(s, a); break;
    }
    return result;
}

norms_of_steps::step_norm norms_of_steps::parts_of(const ball* coefficients) const {
    step_norm result;
    result.terms.reserve(terms_);
    for (std::size_t j = 0; j < terms_; ++j) {
        result.terms.push_back(size_of(coefficients[j]) * powers_[j]);
        result.low += result.terms.back();
    }
    result.rest = size_of(coefficients[terms_]) * powers_[terms_];
    result.whole = result.low + result.rest;
    return result;
}

magnitude norms_of_steps::rest_of(const tape_step& s, const std::vector<magnitude>& a) const {
    switch (s.kind) {
        case operation::state: return a[terms_] * powers_[terms_];
        case operation::constant:
        case operation::variable: return s.kind == operation::variable && terms_ == 1 ? radius_ : magnitude();
        case operation::sum:
        case operation::difference: return of(s.left).rest + of(s.right).rest;
        case operation::scaled: return of(s.left).rest * factor_of(s);
        case operation::raised: return of(s.left).rest;
        case operation::by_variable:
            return of(s.left).rest * (sizes_.point + radius_) + of(s.left).terms.back() * radius_;
        case operation::delayed: return rest_of_delayed(of(s.left), s);
        case operation::product: return rest_of_product(of(s.left), of(s.right));
        case operation::square: return rest_of_product(of(s.left), of(s.left));
        case operation::quotient:
        case operation::slope:
        case operation::square_root:
        case operation::power:
        case operation::function:
        case operation::primitive:
        case operation::companion: break;
    }
    refuse_operation();
}

// The degrees from N - shift on, moved up.
magnitude norms_of_steps::rest_of_delayed(const step_norm& a, const tape_step& s) const {
    magnitude sum = a.rest;
    const auto shift = static_cast<std::size_t>(s.shift);
    for (std::size_t j = terms_ - std::min(shift, terms_); j < terms_; ++j) {
        sum += a.terms[j];
    }
    return sum * shift_of(s);
}

magnitude norms_of_steps::rest_of_product(const step_norm& a, const step_norm& b) {
    magnitude tail;
    magnitude sum;
    const std::size_t count = a.terms.size();
    for (std::size_t j = 1; j < count; ++j) {
        tail += b.terms[count - j];
        sum.add_product(a.terms[j], tail);
    }
    sum.add_product(a.low, b.rest);
    sum.add_product(a.rest, b.low);
    sum.add_product(a.rest, b.rest);
    return sum;
}

// ||u - u_0||.
magnitude norms_of_steps::reach_of(int step) const {
    magnitude sum = of(step).rest;
    for (std::size_t j = 1; j < terms_; ++j) {
        sum += of(step).terms[j];
    }
    return sum;
}

magnitude norms_of_steps::rest_of_quotient(const tape_step& s, const step_norm& q, int index) const {
    const step_norm& b = of(s.right);
    magnitude tail;
    magnitude sum = of(s.left).rest;
    for (std::size_t j = 1; j < terms_; ++j) {
        tail += q.terms[terms_ - j];
        sum.add_product(b.terms[j], tail);
    }
    sum.add_product(b.rest, q.low);
    return sum / magnitude::difference_below(kernel(index).reach, reach_of(s.right));
}

magnitude norms_of_steps::change_of_quotient(const tape_step& s, int index, const magnitude& above,
                                             const magnitude& below) const {
    return (above + norm(index) * below) / magnitude::difference_below(kernel(index).reach, reach_of(s.right) + below);
}

void norms_of_steps::set_function(step_norm& result, const tape_step& s, int index) const {
    if (!bounds(s)) {
        refuse_operation();
    }
    const step_norm& u = of(s.left);
    const function_kernel& phi = kernel(index);
    const magnitude reach = reach_of(s.left);
    const magnitude tail = phi.rest(u.terms);
    if (s.kind != operation::function || !is_relative(s.function)) {
        result.rest = u.rest.is_zero() ? tail : tail + u.rest * phi.slope(reach);
        return;
    }
    magnitude slope = tail;  // the derivative has the same kernel
    for (std::size_t j = 0; j < terms_; ++j) {
        slope += sizes_.of_steps[static_cast<std::size_t>(index) + 1][j] * powers_[j];
    }
    const magnitude change = u.rest * phi.second(reach);
    result.rest = tail + u.rest * (slope + change.shifted(-1));
    result.slope = slope + change;
}

magnitude norms_of_steps::change_of_function(const tape_step& s, int index, const magnitude& by) const {
    const function_kernel& phi = kernel(index);
    const magnitude reach = reach_of(s.left) + by;
    if (s.kind != operation::function || !is_relative(s.function)) {
        return by.is_zero() ? magnitude() : by * phi.slope(reach);
    }
    return by * (of(index).slope + (by * phi.second(reach)).shifted(-1));
}

}  // namespace libration::ode
