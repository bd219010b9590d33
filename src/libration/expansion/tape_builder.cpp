#include "tape_builder.hpp"

#include <algorithm>
#include <limits>

#include "libration/function/list.hpp"

namespace libration::ode {

namespace {

// Of about 2 log2 n products; a^r by its equation would divide by a, which may be 0.
constexpr int largest_whole_power = 1'000'000;

bool fits_int(const rational& q) {
    const auto fits = [](const integer& n) { return abs(n) <= std::numeric_limits<int>::max(); };
    return fits(numerator(q)) && fits(denominator(q));
}

bool is_constant_node(const expression& e) { return e.kind() == node_kind::constant; }

bool is_minus(const expression& e) { return e.kind() == node_kind::product && e.left().is(-1); }

// A sum as the step that adds a constant, a + b, a - b, or -a + b as b - a with operands a, b.
struct sum_step {
    operation kind;
    operand_pair operands;
    bool reversed = false;
};

sum_step step_of_sum(const expression& e) {
    if (is_constant_node(e.right())) {
        return {operation::raised, {&e.left()}};
    }
    if (is_minus(e.right())) {
        return {operation::difference, {&e.left(), &e.right().right()}};
    }
    if (is_minus(e.left())) {
        return {operation::difference, {&e.left().right(), &e.right()}, true};
    }
    return {operation::sum, {&e.left(), &e.right()}};
}

}  // namespace

tape_builder::tape_builder(const explicit_system& of, start_values* at_start)
    : system_(of), places_(places_of(of.unknowns())), at_start_(at_start) {
    result_.point_ = of.point();
    result_.starts_ = of.starts();
    for (const unknown_function& each : of.unknowns()) {
        result_.orders_.push_back(each.order);
    }
    result_.residues_.resize(of.unknowns().size());
    if (at_start != nullptr && of.singular()) {
        result_.singular_ = true;
        result_.root_ = of.singular()->root;
    }
}

tape tape_builder::build(const std::vector<expression>& watched) {
    for (const unknown_function& each : system_.unknowns()) {
        for (int j = 0; j < (result_.singular_ ? 1 : each.order); ++j) {
            step_of(unknown(each.name, j));
        }
    }
    for (std::size_t i = 0; i < system_.unknowns().size(); ++i) {
        if (result_.singular_) {
            const scaled_right_side& right = system_.singular()->right[i];
            result_.outputs_.push_back(step_of(right.scaled));
            result_.weights_.push_back(right.weights);
        } else {
            result_.outputs_.push_back(step_of(system_.right()[i]));
        }
    }
    for (const expression& each : watched) {
        result_.watched_.push_back(step_of(each));
    }
    return std::move(result_);
}

int tape_builder::step_of(const expression& e) {
    return done_.of(
        e, [this](const expression& each) { return made(each); },
        [this](const expression& each) { return operands(each); });
}

// The operands that become steps: a constant is part of the step that reads it, a - b needs no step for -b.
operand_pair tape_builder::operands(const expression& e) const {
    switch (e.kind()) {
        case node_kind::sum: return step_of_sum(e).operands;
        case node_kind::product:
            return is_constant_node(e.left()) || is_delay(e.left()) ? operand_pair{&e.right()} : operands_of(e);
        case node_kind::power: return is_delay(e) ? operand_pair{} : operand_pair{&e.left()};
        case node_kind::constant:
        case node_kind::variable:
        case node_kind::unknown:
        case node_kind::parameter:
        case node_kind::quotient:
        case node_kind::function: break;
    }
    return operands_of(e);
}

// Whether it is a power of the distance from a singular initial point.
bool tape_builder::is_delay(const expression& e) const {
    return result_.singular_ && e.kind() == node_kind::power && e.left().kind() == node_kind::parameter;
}

int tape_builder::made(const expression& e) {
    switch (e.kind()) {
        case node_kind::constant: return constant(e.constant());
        case node_kind::variable:
        case node_kind::parameter: return shared({.kind = operation::variable});
        case node_kind::unknown: return state(e);
        case node_kind::sum: return sum_of(e);
        case node_kind::product: return product_of(e);
        case node_kind::quotient: return quotient(done_.at(e.left()), done_.at(e.right()));
        case node_kind::power: return power_of(e);
        case node_kind::function: break;
    }
    return function_of(e);
}

int tape_builder::shared(tape_step step) {
    const bool commutes = step.kind == operation::sum || step.kind == operation::product;
    if (commutes && step.left > step.right) {
        std::swap(step.left, step.right);
    }
    const std::tuple key(static_cast<int>(step.kind), step.left, step.right, step.constant, step.numerator,
                         step.denominator, step.shift, static_cast<int>(step.function));
    const auto found = known_.find(key);
    if (found != known_.end()) {
        return found->second;
    }
    set_lag(step);
    result_.steps_.push_back(std::move(step));
    const int index = static_cast<int>(result_.steps_.size()) - 1;
    known_.emplace(key, index);
    return index;
}

// The lag of a step is that of its operands; a delay by p reduces it by p.
void tape_builder::set_lag(tape_step& step) const {
    if (step.kind == operation::state) {
        return;  // set by state()
    }
    for (const int operand : {step.left, step.right}) {
        if (operand >= 0) {
            step.lag = std::max(step.lag, result_.steps_[static_cast<std::size_t>(operand)].lag);
        }
    }
    for (const int operand : {step.left, step.right}) {
        if (operand >= 0) {
            const tape_step& of = result_.steps_[static_cast<std::size_t>(operand)];
            step.newest = step.newest || (of.newest && of.lag == step.lag);
        }
    }
    if (step.kind == operation::delayed) {
        step.newest = step.newest && step.lag >= step.shift;
        step.lag = std::max(0, step.lag - step.shift);
    }
}

int tape_builder::state(const expression& e) {
    const int which = static_cast<int>(places_.at(e.name()));
    tape_step step{.kind = operation::state, .left = which, .right = e.derivative()};
    step.lag = result_.singular_ ? e.derivative() * result_.root_ : 0;
    step.newest = result_.singular_;
    const auto before = result_.steps_.size();
    const int index = shared(step);
    if (result_.steps_.size() > before) {
        result_.states_.push_back({which, e.derivative(), index});
    }
    return index;
}

int tape_builder::constant_index(const number& value) {
    auto& all = result_.constants_;
    const auto found = std::ranges::find_if(all, [&](const number& each) { return same_form(each, value); });
    if (found == all.end()) {
        all.push_back(value);
        return static_cast<int>(all.size()) - 1;
    }
    return static_cast<int>(found - all.begin());
}

int tape_builder::constant(const number& value) {
    return shared({.kind = operation::constant, .constant = constant_index(value)});
}

int tape_builder::sum_of(const expression& e) {
    const sum_step sum = step_of_sum(e);
    int a = done_.at(*sum.operands[0]);
    if (sum.kind == operation::raised) {
        return shared({.kind = sum.kind, .left = a, .constant = constant_index(e.right().constant())});
    }
    int b = done_.at(*sum.operands[1]);
    if (sum.reversed) {
        std::swap(a, b);
    }
    return shared({.kind = sum.kind, .left = a, .right = b});
}

int tape_builder::scaled_by(int of, const number& factor) {
    const auto q = factor.fraction();
    if (q && fits_int(*q)) {
        return shared({.kind = operation::scaled,
                       .left = of,
                       .numerator = numerator(*q).convert_to<int>(),
                       .denominator = denominator(*q).convert_to<int>()});
    }
    return shared({.kind = operation::scaled, .left = of, .constant = constant_index(factor)});
}

int tape_builder::product(int a, int b) {
    const auto is_variable = [&](int step) {
        return result_.steps_[static_cast<std::size_t>(step)].kind == operation::variable;
    };
    if (is_variable(a) || is_variable(b)) {
        const int other = is_variable(a) ? b : a;
        return result_.singular_ ? delayed_by(other, 1) : shared({.kind = operation::by_variable, .left = other});
    }
    return a == b ? shared({.kind = operation::square, .left = a})
                  : shared({.kind = operation::product, .left = a, .right = b});
}

int tape_builder::quotient(int a, int b) { return shared({.kind = operation::quotient, .left = a, .right = b}); }

int tape_builder::delayed_by(int of, const rational& exponent) {
    const rational shift = exponent * result_.root_;
    return shared({.kind = operation::delayed, .left = of, .shift = numerator(shift).convert_to<int>()});
}

int tape_builder::product_of(const expression& e) {
    const expression& factor = e.left();
    const int right = done_.at(e.right());
    if (is_constant_node(factor)) {
        return scaled_by(right, factor.constant());
    }
    return is_delay(factor) ? delayed_by(right, *factor.right().fraction()) : product(done_.at(factor), right);
}

int tape_builder::whole_power(int base, const integer& n) {
    if (n == 1) {
        return base;
    }
    const int half = whole_power(base, n / 2);
    const int even = product(half, half);
    return n % 2 == 0 ? even : product(even, base);
}

int tape_builder::power_of(const expression& e) {
    if (is_delay(e)) {
        return delayed_by(constant(number(rational(1))), *e.right().fraction());
    }
    const int base = done_.at(e.left());
    const auto exponent = e.right().constant().fraction();
    const rational twice = exponent ? rational(abs(*exponent) * 2) : rational(0);
    if (exponent && denominator(twice) == 1 && twice <= 2 * largest_whole_power) {
        const bool half = numerator(twice) % 2 != 0;
        const integer whole = numerator(twice) / 2;
        int power = whole == 0 ? -1 : whole_power(base, whole);
        if (half) {
            const int root = root_of(base, e.left());
            power = power < 0 ? root : product(power, root);
        }
        return *exponent > 0 ? power : quotient(constant(number(rational(1))), power);
    }
    const int slope = slope_of(base);
    tape_step step{.kind = operation::power, .left = base, .right = slope};
    step.constant = constant_index(e.right().constant());
    if (at_start_ != nullptr && at_start_->value_of(e.left()).plain()) {
        step.centre = at_start_->value_of(e);
    }
    const auto before = result_.steps_.size();
    const int index = shared(step);
    if (result_.steps_.size() > before) {
        companions(index, 1);
    }
    return index;
}

std::optional<number> tape_builder::centre_of(function_kind f, const rational& order, const expression& argument) {
    if (at_start_ == nullptr || !at_start_->value_of(argument).plain()) {
        return std::nullopt;
    }
    const number x = at_start_->value_of(argument);
    return has_order(f) ? apply(f, order, x) : apply(f, x);
}

int tape_builder::root_of(int a, const expression& argument) {
    tape_step step{.kind = operation::square_root, .left = a, .function = function_kind::sqrt};
    step.centre = centre_of(function_kind::sqrt, 0, argument);
    const auto before = result_.steps_.size();
    const int index = shared(step);
    if (result_.steps_.size() > before) {
        companions(index, 1);  // twice the square root of the centre
    }
    return index;
}

int tape_builder::slope_of(int a) { return shared({.kind = operation::slope, .left = a}); }

// Arrays after a new step, which are filled together with its own.
int tape_builder::companions(int of, int count) {
    for (int i = 0; i < count; ++i) {
        tape_step step = result_.steps_[static_cast<std::size_t>(of)];
        step.kind = operation::companion;
        step.centre.reset();
        result_.steps_.push_back(step);
    }
    return of;
}

// By the recurrence of the function.
template <class F>
int tape_builder::own_series(const expression& e) {
    const int a = done_.at(e.left());
    tape_step step{.kind = operation::function, .left = a, .right = slope_of(a), .function = F::kind, .odd = F::odd};
    if (e.has_order()) {
        step.constant = constant_index(number(rational(function::relative_order(e.order()))));
    } else {
        step.centre = centre_of(F::kind, 0, e.left());
    }
    const auto before = result_.steps_.size();
    const int index = shared(step);
    if (result_.steps_.size() == before) {
        return index;
    }
    companions(index, F::kept);
    if constexpr (requires { F::values_kept; }) {
        const auto call = [](function_kind f, const number& x) { return apply(f, x); };
        for (int i = 0; step.centre && i < F::values_kept; ++i) {
            result_.steps_[before + 1 + static_cast<std::size_t>(i)].centre =
                F::first_kept(i, at_start_->value_of(e.left()), call);
        }
    }
    return index;
}

// As the primitive of f'(u) u', with f'(u) in later steps, which may read its lower coefficients.
template <class F>
int tape_builder::primitive_of(const expression& e) {
    const int a = done_.at(e.left());
    tape_step step{.kind = operation::primitive, .left = a, .right = slope_of(a), .function = F::kind};
    if (e.has_order()) {
        step.constant = constant_index(number(e.order()));
    }
    step.centre = centre_of(F::kind, e.order(), e.left());
    const auto before = result_.steps_.size();
    const int index = shared(step);
    if (result_.steps_.size() > before) {
        int derivative = 0;
        if constexpr (function::ordered<F>) {
            derivative = step_of(F::derivative(e.order(), e.left(), e));
        } else {
            derivative = step_of(F::derivative(e.left(), e));
        }
        result_.steps_[before].derivative = derivative;
    }
    return index;
}

int tape_builder::function_of(const expression& e) {
    return function::with_function(e.function(), [&](auto of) -> int {
        using each = decltype(of);
        if constexpr (requires { each::in_others(e); }) {
            return step_of(each::in_others(e.left()));
        } else if constexpr (requires { each::companion_of; }) {
            return step_of(apply(each::companion_of, e.left())) + 1;
        } else if constexpr (requires { each::kept; }) {
            return own_series<each>(e);
        } else {
            return primitive_of<each>(e);
        }
    });
}

}  // namespace libration::ode
