#include "libration/equation/expression.hpp"

#include <set>
#include <utility>
#include <vector>

#include "libration/scalar/error.hpp"

namespace libration::ode {

struct expression::node {
    node() = default;
    node(node&&) = default;
    node(const node&) = delete;
    node& operator=(const node&) = delete;
    node& operator=(node&&) = delete;
    ~node();

    node_kind kind = node_kind::constant;
    function_kind f = function_kind::exp;
    int derivative = 0;
    std::string name;
    number value;
    expression left = expression(no_node()), right = expression(no_node());
    bool variable = false, unknowns = false, parameters = false;
    std::size_t hash = 0;
};

// Operands whose last owner is destroyed are released one by one by the outermost destructor of the thread, so that
// deep expressions need no stack. If there is no memory for the list they are released recursively.
expression::node::~node() {
    thread_local std::vector<std::shared_ptr<const node>>* open = nullptr;
    if (left.node_ == nullptr) {
        return;
    }
    std::vector<std::shared_ptr<const node>> mine;
    auto& list = open != nullptr ? *open : mine;
    try {
        list.reserve(list.size() + 2 > list.capacity() ? 2 * list.size() + 2 : 0);
    } catch (const std::bad_alloc&) {
        return;
    }
    list.push_back(std::move(left.node_));
    list.push_back(std::move(right.node_));
    if (open != nullptr) {
        return;
    }
    open = &mine;
    while (!mine.empty()) {
        const std::shared_ptr<const node> last = std::move(mine.back());
        mine.pop_back();
    }
    open = nullptr;
}

namespace {

std::size_t mixed_hash(std::size_t seed, std::size_t more) {
    return seed ^ (more + 0x9e3779b97f4a7c15ULL + (seed << 6U) + (seed >> 2U));
}

bool is_number(const expression& e) { return e.kind() == node_kind::constant; }

// Whether it is a number times another expression, as one of two opposite expressions is.
bool has_number(const expression& e) { return e.kind() == node_kind::product && is_number(e.left()); }

}  // namespace

expression::expression(node&& made) {
    made.hash = mixed_hash(static_cast<std::size_t>(made.kind), static_cast<std::size_t>(made.f));
    made.hash = mixed_hash(made.hash, std::hash<std::string>()(made.name) + static_cast<std::size_t>(made.derivative));
    made.hash = mixed_hash(made.hash, made.value.hash());
    made.variable = made.kind == node_kind::variable;
    made.unknowns = made.kind == node_kind::unknown;
    made.parameters = made.kind == node_kind::parameter;
    for (const expression* side : {&made.left, &made.right}) {
        if (side->node_ != nullptr) {
            made.hash = mixed_hash(made.hash, side->hash());
            made.variable = made.variable || side->has_variable();
            made.unknowns = made.unknowns || side->has_unknowns();
            made.parameters = made.parameters || side->has_parameters();
        }
    }
    node_ = std::make_shared<const node>(std::move(made));
}

expression::expression() {
    // Thread-local: with a shared object, other threads would wait indefinitely for a thread that a failure of GMP
    // keeps in here.
    thread_local const expression zero{number()};
    node_ = zero.node_;
}

expression::expression(const number& value) {
    node made;
    made.value = value;
    *this = expression(std::move(made));
}

expression expression::binary(node_kind kind, const expression& a, const expression& b) {
    node made;
    made.kind = kind;
    made.left = a;
    made.right = b;
    return expression(std::move(made));
}

node_kind expression::kind() const { return node_->kind; }
const number& expression::constant() const { return node_->value; }
const std::string& expression::name() const { return node_->name; }
int expression::derivative() const { return node_->derivative; }
function_kind expression::function() const { return node_->f; }
const expression& expression::left() const { return node_->left; }
const expression& expression::right() const { return node_->right; }
bool expression::has_order() const { return kind() == node_kind::function && node_->right.node_ != nullptr; }
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

// Pairs already compared are not compared again: otherwise expressions with shared parts would take exponential time.
bool same_form(const expression& a, const expression& b) {
    using node_pair = std::pair<const expression::node*, const expression::node*>;
    if (a.node_ == b.node_ || a.hash() != b.hash()) {
        return a.node_ == b.node_;
    }
    constexpr int few = 32;  // pairs are compared before any is remembered, since most expressions are small
    int compared = 0;
    std::set<node_pair> seen;
    std::vector<node_pair> open{{a.node_.get(), b.node_.get()}};
    while (!open.empty()) {
        const auto [x, y] = open.back();
        open.pop_back();
        if (x == y) {
            continue;
        }
        if (x == nullptr || y == nullptr || x->hash != y->hash || x->kind != y->kind || x->f != y->f ||
            x->derivative != y->derivative || x->name != y->name || !same_form(x->value, y->value)) {
            return false;
        }
        if (x->left.node_ != nullptr && (++compared <= few || seen.emplace(x, y).second)) {
            open.emplace_back(x->left.node_.get(), y->left.node_.get());
            open.emplace_back(x->right.node_.get(), y->right.node_.get());
        }
    }
    return true;
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
                    "has no derivative here: write derivatives of unknowns, of order at least 0");
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
    if (a.is_unfolded_zero() && same_form(a, b)) {
        return a;
    }
    const bool opposite = (has_number(a) || has_number(b)) && same_form(a, -b);
    return opposite ? expression() : expression::binary(node_kind::sum, a, b);
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
    if (a.is(1) || (is_number(a) && b.is_unfolded_zero())) {
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
    return same_form(a, b) && !a.is_unfolded_zero() ? expression(1) : expression::binary(node_kind::quotient, a, b);
}

expression unfolded_zero(const expression& e) {
    return is_number(e) ? expression() : expression::binary(node_kind::product, expression(), e);
}

expression pow(const expression& base, const expression& exponent) {
    if (!exponent.is_constant()) {
        if (is_number(base) && base.constant().sign() <= 0) {
            throw error(error_kind::argument, "exponent", "",
                        "is not constant over a base that is not positive: x^y is exp(y*log(x)), for x > 0");
        }
        return apply(function_kind::exp, exponent * apply(function_kind::log, base));
    }
    if (exponent.is(1)) {
        return base;
    }
    if (is_number(base) && is_number(exponent)) {
        return power(base.constant(), exponent.constant());
    }
    return exponent.is(0) ? expression(1) : expression::binary(node_kind::power, base, exponent);
}

expression apply(function_kind f, const expression& x) {
    if (libration::has_order(f)) {
        throw error(error_kind::argument, "function", std::string(name_of(f)),
                    "has a constant order: write " + std::string(name_of(f)) + "(0, y)");
    }
    if (is_number(x)) {
        return apply(f, x.constant());
    }
    expression::node made;
    made.kind = node_kind::function;
    made.f = f;
    made.left = x;
    return expression(std::move(made));
}

expression apply(function_kind f, const expression& order, const expression& x) {
    if (!libration::has_order(f)) {
        throw error(error_kind::argument, "function", std::string(name_of(f)),
                    "has one argument: write " + std::string(name_of(f)) + "(y)");
    }
    if (!order.is_constant() || (is_number(order) && !order.fraction())) {
        throw error(error_kind::argument, "order", "",
                    std::string(order.is_constant() ? "is not a fraction" : "is not constant") +
                        ": write a number first, as in " + std::string(name_of(f)) + "(0, y)");
    }
    if (is_number(x) && is_number(order)) {
        return apply(f, *order.fraction(), x.constant());
    }
    expression::node made;
    made.kind = node_kind::function;
    made.f = f;
    made.left = x;
    made.right = order;
    return expression(std::move(made));
}

rational expression::order() const {
    if (!has_order()) {
        return 0;
    }
    const auto q = right().fraction();
    if (!q) {
        throw error(error_kind::argument, "order", "", "is not a number: give its parameters values");
    }
    return *q;
}

expression with_argument(const expression& function, const expression& x) {
    return function.has_order() ? apply(function.function(), function.right(), x) : apply(function.function(), x);
}

std::string primed(const std::string& name, int derivative) {
    return name + std::string(static_cast<std::size_t>(derivative), '\'');
}

}  // namespace libration::ode
