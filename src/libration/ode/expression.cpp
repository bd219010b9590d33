#include "libration/ode/expression.hpp"

#include <unordered_map>
#include <utility>

#include "libration/scalar/error.hpp"

namespace libration::ode {

struct expression::node {
    node_kind kind = node_kind::constant;
    elementary f = elementary::exp;
    int derivative = 0;
    std::string name;
    number value;
    std::shared_ptr<const expression> left, right;
    bool variable = false, unknowns = false, parameters = false;
    std::size_t hash = 0;
};

namespace {

std::size_t mixed_hash(std::size_t seed, std::size_t more) {
    return seed ^ (more + 0x9e3779b97f4a7c15ULL + (seed << 6U) + (seed >> 2U));
}

// Numbers that are no fractions share a hash: they are few.
std::size_t hash_of(const number& value) {
    const auto q = value.plain();
    return q ? mixed_hash(std::hash<rational>()(q->coefficient), static_cast<std::size_t>(q->measure)) : 1;
}

bool is_number(const expression& e) { return e.kind() == node_kind::constant; }

bool is_leaf(const expression& e) {
    return e.kind() == node_kind::variable || e.kind() == node_kind::unknown || e.kind() == node_kind::parameter;
}

}  // namespace

expression::expression(node&& made) {
    made.hash = mixed_hash(static_cast<std::size_t>(made.kind), static_cast<std::size_t>(made.f));
    made.hash = mixed_hash(made.hash, std::hash<std::string>()(made.name) + static_cast<std::size_t>(made.derivative));
    made.hash = mixed_hash(made.hash, hash_of(made.value));
    made.variable = made.kind == node_kind::variable;
    made.unknowns = made.kind == node_kind::unknown;
    made.parameters = made.kind == node_kind::parameter;
    for (const auto& side : {made.left, made.right}) {
        if (side != nullptr) {
            made.hash = mixed_hash(made.hash, side->hash());
            made.variable = made.variable || side->has_variable();
            made.unknowns = made.unknowns || side->has_unknowns();
            made.parameters = made.parameters || side->has_parameters();
        }
    }
    node_ = std::make_shared<const node>(std::move(made));
}

expression::expression(const number& value) {
    node made;
    made.value = value;
    *this = expression(std::move(made));
}

expression expression::binary(node_kind kind, const expression& a, const expression& b) {
    node made;
    made.kind = kind;
    made.left = std::make_shared<const expression>(a);
    made.right = std::make_shared<const expression>(b);
    return expression(std::move(made));
}

node_kind expression::kind() const { return node_->kind; }
const number& expression::constant() const { return node_->value; }
const std::string& expression::name() const { return node_->name; }
int expression::derivative() const { return node_->derivative; }
elementary expression::function() const { return node_->f; }
const expression& expression::left() const { return *node_->left; }
const expression& expression::right() const { return *node_->right; }
bool expression::has_variable() const { return node_->variable; }
bool expression::has_unknowns() const { return node_->unknowns; }
bool expression::has_parameters() const { return node_->parameters; }
std::size_t expression::hash() const { return node_->hash; }

std::optional<rational> expression::fraction() const {
    return kind() == node_kind::constant ? node_->value.fraction() : std::nullopt;
}

bool expression::is(int n) const {
    const auto q = fraction();
    return q && *q == n;
}

bool same_form(const expression& a, const expression& b) {
    if (a.node_ == b.node_) {
        return true;
    }
    const auto& x = *a.node_;
    const auto& y = *b.node_;
    if (x.hash != y.hash || x.kind != y.kind || x.f != y.f || x.derivative != y.derivative || x.name != y.name) {
        return false;
    }
    if (x.kind == node_kind::constant) {
        return same_form(x.value, y.value);
    }
    const bool left = x.left == nullptr || same_form(*x.left, *y.left);
    return left && (x.right == nullptr || same_form(*x.right, *y.right));
}

expression variable() {
    expression::node made;
    made.kind = node_kind::variable;
    return expression(std::move(made));
}

expression unknown(const std::string& name, int derivative) {
    expression::node made;
    made.kind = node_kind::unknown;
    made.name = name;
    made.derivative = derivative;
    return expression(std::move(made));
}

expression parameter(const std::string& name) {
    expression::node made;
    made.kind = node_kind::parameter;
    made.name = name;
    return expression(std::move(made));
}

expression derivative(const expression& of, int order) {
    if (of.kind() != node_kind::unknown || order < 0) {
        throw error(error_kind::argument, "expression", "",
                    "has no derivative here: derivatives are written of unknowns, at least of order 0");
    }
    return unknown(of.name(), of.derivative() + order);
}

expression expression::operator-() const { return expression(-1) * *this; }

expression operator+(const expression& a, const expression& b) {
    if (is_number(a) && is_number(b)) {
        return a.constant() + b.constant();
    }
    if (a.is(0)) {
        return b;
    }
    if (b.is(0)) {
        return a;
    }
    if (is_number(a)) {
        return b + a;
    }
    if (is_number(b) && a.kind() == node_kind::sum && is_number(a.right())) {
        return a.left() + expression(a.right().constant() + b.constant());
    }
    return same_form(a, -b) ? expression() : expression::binary(node_kind::sum, a, b);
}

expression operator*(const expression& a, const expression& b) {
    if (is_number(a) && is_number(b)) {
        return a.constant() * b.constant();
    }
    if (is_number(b)) {
        return b * a;
    }
    if (a.is(0) || b.is(0)) {
        return {};
    }
    if (a.is(1)) {
        return b;
    }
    if (is_number(a) && b.kind() == node_kind::product && is_number(b.left())) {
        return expression(a.constant() * b.left().constant()) * b.right();
    }
    return expression::binary(node_kind::product, a, b);
}

expression operator/(const expression& a, const expression& b) {
    if (is_number(b)) {
        return is_number(a) ? expression(a.constant() / b.constant())
                            : expression(number(rational(1)) / b.constant()) * a;
    }
    if (a.is(0)) {
        return {};
    }
    return same_form(a, b) ? expression(1) : expression::binary(node_kind::quotient, a, b);
}

expression pow(const expression& base, const expression& exponent) {
    if (!exponent.is_constant()) {
        throw error(error_kind::argument, "exponent", "", "is not constant: write exp(y*log(x)) for x^y");
    }
    if (exponent.is(1)) {
        return base;
    }
    if (is_number(base) && is_number(exponent)) {
        return power(base.constant(), exponent.constant());
    }
    return exponent.is(0) ? expression(1) : expression::binary(node_kind::power, base, exponent);
}

expression apply(elementary f, const expression& x) {
    if (is_number(x)) {
        return apply(f, x.constant());
    }
    expression::node made;
    made.kind = node_kind::function;
    made.f = f;
    made.left = std::make_shared<const expression>(x);
    return expression(std::move(made));
}

namespace {

// One way through an expression in which what is shared is visited once.
class rewriting {
public:
    explicit rewriting(const replacement& by) : by_(by) {}

    expression of(const expression& e) {
        if (is_number(e)) {
            return e;
        }
        const auto found = done_.find(e.identity());
        if (found != done_.end()) {
            return found->second;
        }
        expression result = made(e);
        done_.emplace(e.identity(), result);
        return result;
    }

private:
    expression made(const expression& e) {
        if (is_leaf(e)) {
            return by_(e).value_or(e);
        }
        if (e.kind() == node_kind::function) {
            return apply(e.function(), of(e.left()));
        }
        const expression left = of(e.left());
        const expression right = of(e.right());
        switch (e.kind()) {
            case node_kind::sum: return left + right;
            case node_kind::product: return left * right;
            case node_kind::quotient: return left / right;
            default: return pow(left, right);
        }
    }

    const replacement& by_;
    std::unordered_map<const void*, expression> done_;
};

class differentiation {
public:
    explicit differentiation(const expression& leaf) : leaf_(leaf) {}

    expression of(const expression& e) {
        if (is_number(e) || is_leaf(e)) {
            return same_form(e, leaf_) ? 1 : 0;
        }
        const auto found = done_.find(e.identity());
        if (found != done_.end()) {
            return found->second;
        }
        expression result = made(e);
        done_.emplace(e.identity(), result);
        return result;
    }

private:
    expression made(const expression& e) {
        const expression& a = e.left();
        const expression inner = of(a);
        switch (e.kind()) {
            case node_kind::sum: return inner + of(e.right());
            case node_kind::product: return inner * e.right() + a * of(e.right());
            case node_kind::quotient: return (inner - e * of(e.right())) / e.right();
            case node_kind::power: return e.right() * pow(a, e.right() - 1) * inner;
            default: return inner.is(0) ? expression() : outer(e.function(), a, e) * inner;
        }
    }

    // f'(x), f(x) being at hand.
    static expression outer(elementary f, const expression& x, const expression& value) {
        switch (f) {
            case elementary::exp: return value;
            case elementary::log: return 1 / x;
            case elementary::sqrt: return 1 / (2 * value);
            case elementary::sin: return cos(x);
            case elementary::cos: return -sin(x);
            case elementary::tan: return 1 + value * value;
            case elementary::asin: return 1 / sqrt(1 - x * x);
            case elementary::acos: return -(1 / sqrt(1 - x * x));
            case elementary::atan: return 1 / (1 + x * x);
            case elementary::sinh: return cosh(x);
            case elementary::cosh: return sinh(x);
            default: return 1 - value * value;
        }
    }

    const expression& leaf_;
    std::unordered_map<const void*, expression> done_;
};

}  // namespace

expression replaced(const expression& in, const replacement& by) { return rewriting(by).of(in); }

expression partial(const expression& e, const expression& leaf) { return differentiation(leaf).of(e); }

std::string primed(const std::string& name, int derivative) {
    return name + std::string(static_cast<std::size_t>(derivative), '\'');
}

}  // namespace libration::ode
