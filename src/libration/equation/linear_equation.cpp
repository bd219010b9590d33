#include "libration/equation/linear_equation.hpp"

#include <utility>

#include "libration/equation/constant_value.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/convert.hpp"

namespace libration::ode {

namespace {

constexpr int highest_degree_of_coefficients = 60;
constexpr std::size_t highest_order_of_linear = 12;

struct rational_function {
    rational_polynomial above, below = rational_polynomial(rational(1));

    bool is_zero() const { return above.is_zero(); }
};

rational_function in_lowest_terms(const rational_polynomial& above, const rational_polynomial& below) {
    const rational_polynomial common = common_divisor(above, below);
    return {divided(above, common).quotient, divided(below, common).quotient};
}

rational_function operator+(const rational_function& a, const rational_function& b) {
    return in_lowest_terms(a.above * b.below + b.above * a.below, a.below * b.below);
}

rational_function operator*(const rational_function& a, const rational_function& b) {
    return in_lowest_terms(a.above * b.above, a.below * b.below);
}

rational_function inverse_of(const rational_function& a) { return {a.below, a.above}; }

// The coefficients of y, y', .., and the part without y last.
using rational_linear_form = std::vector<rational_function>;

class linear_reader {
public:
    linear_reader(std::string name, std::size_t order, rational origin)
        : name_(std::move(name)), order_(order), origin_(std::move(origin)) {}

    std::optional<rational_linear_form> of(const expression& e) const {
        switch (e.kind()) {
            case node_kind::constant: {
                const auto q = e.fraction();
                return q ? std::optional(free_of_unknown({rational_polynomial(*q)})) : std::nullopt;
            }
            case node_kind::variable: return free_of_unknown({std::vector<rational>{origin_, rational(1)}});
            case node_kind::unknown: return of_unknown(e);
            case node_kind::sum: return sum_of(of(e.left()), of(e.right()));
            case node_kind::product: return product_of(of(e.left()), of(e.right()));
            case node_kind::quotient: {
                const auto divisor = of(e.right());
                return divisor && is_free(*divisor) && !divisor->back().is_zero()
                           ? product_of(of(e.left()), free_of_unknown(inverse_of(divisor->back())))
                           : std::nullopt;
            }
            case node_kind::power: return power_of(e);
            case node_kind::parameter:
            case node_kind::function: return std::nullopt;
        }
        return std::nullopt;
    }

private:
    rational_linear_form free_of_unknown(rational_function f) const {
        rational_linear_form result(order_ + 1);
        result.back() = std::move(f);
        return result;
    }

    static bool is_free(const rational_linear_form& f) {
        for (std::size_t i = 0; i + 1 < f.size(); ++i) {
            if (!f[i].is_zero()) {
                return false;
            }
        }
        return true;
    }

    static bool is_small(const rational_linear_form& f) {
        for (const rational_function& each : f) {
            if (each.above.degree() > highest_degree_of_coefficients ||
                each.below.degree() > highest_degree_of_coefficients) {
                return false;
            }
        }
        return true;
    }

    std::optional<rational_linear_form> of_unknown(const expression& e) const {
        if (e.name() != name_ || static_cast<std::size_t>(e.derivative()) >= order_) {
            return std::nullopt;
        }
        rational_linear_form result(order_ + 1);
        result[static_cast<std::size_t>(e.derivative())].above = rational_polynomial(rational(1));
        return result;
    }

    static std::optional<rational_linear_form> sum_of(const std::optional<rational_linear_form>& a,
                                                      const std::optional<rational_linear_form>& b) {
        if (!a || !b) {
            return std::nullopt;
        }
        rational_linear_form result;
        for (std::size_t i = 0; i < a->size(); ++i) {
            result.push_back((*a)[i] + (*b)[i]);
        }
        return is_small(result) ? std::optional(result) : std::nullopt;
    }

    static std::optional<rational_linear_form> product_of(const std::optional<rational_linear_form>& a,
                                                          const std::optional<rational_linear_form>& b) {
        if (!a || !b || (!is_free(*a) && !is_free(*b))) {
            return std::nullopt;
        }
        const rational_function& factor = is_free(*a) ? a->back() : b->back();
        rational_linear_form result;
        for (const rational_function& each : is_free(*a) ? *b : *a) {
            result.push_back(each * factor);
        }
        return is_small(result) ? std::optional(result) : std::nullopt;
    }

    std::optional<rational_linear_form> power_of(const expression& e) const {
        const auto exponent = e.right().kind() == node_kind::constant ? e.right().fraction() : std::nullopt;
        const auto base = of(e.left());
        if (!exponent || !base || denominator(*exponent) != 1 || abs(*exponent) > highest_degree_of_coefficients) {
            return std::nullopt;
        }
        const bool inverse = *exponent < 0;
        if (inverse && (!is_free(*base) || base->back().is_zero())) {
            return std::nullopt;
        }
        const rational_linear_form factor = inverse ? free_of_unknown(inverse_of(base->back())) : *base;
        std::optional<rational_linear_form> result = free_of_unknown({rational_polynomial(rational(1))});
        for (rational k(0); k < abs(*exponent) && result; k += 1) {
            result = product_of(result, factor);
        }
        return result;
    }

    std::string name_;
    std::size_t order_;
    rational origin_;
};

// D of sum p_i D^i.
std::vector<rational_polynomial> differentiated(const std::vector<rational_polynomial>& p) {
    std::vector<rational_polynomial> result(p.size() + 1);
    for (std::size_t i = 0; i < p.size(); ++i) {
        result[i] = result[i] + p[i].derivative();
        result[i + 1] = result[i + 1] + p[i];
    }
    return result;
}

}  // namespace

std::optional<linear_equation> linear_equation::of(const explicit_system& system) {
    if (system.unknowns().size() != 1 || !system.algebraic().empty() || system.starts().size() != 1 ||
        (system.singular() && system.singular()->root != 1)) {
        return std::nullopt;
    }
    const auto origin = expression(system.point()).fraction();
    const auto order = static_cast<std::size_t>(system.unknowns().front().order);
    if (!origin || order == 0 || order > highest_order_of_linear) {
        return std::nullopt;
    }
    const auto right = linear_reader(system.unknowns().front().name, order, *origin).of(system.right().front());
    if (!right) {
        return std::nullopt;
    }
    rational_polynomial below(rational(1));
    for (const rational_function& each : *right) {
        below = divided(below * each.below, common_divisor(below, each.below)).quotient;
    }
    linear_equation result;
    for (std::size_t i = 0; i < order; ++i) {
        result.given_.push_back(divided(below, (*right)[i].below).quotient * (*right)[i].above * rational(-1));
    }
    result.given_.push_back(below);
    result.right_ = divided(below, right->back().below).quotient * right->back().above;
    result.starts_ = system.starts().front();
    result.coefficients_ = result.given_;
    for (int k = 0; k <= result.right_.degree(); ++k) {
        result.coefficients_ = differentiated(result.coefficients_);
    }
    if ((below[0] == 0 && !system.singular()) || result.order() > highest_order_of_linear) {
        return std::nullopt;
    }
    return result;
}

std::vector<ball> linear_equation::start() const {
    std::vector<ball> a;
    ball factorial(1);
    for (std::size_t k = 0; k < starts_.size(); ++k) {
        factorial = k > 1 ? ball(factorial * static_cast<long>(k)) : factorial;
        a.push_back(constant_value<ball>::of(starts_[k]) / factorial);
    }
    const auto falling = [](long n, std::size_t i) {
        ball product(1);
        for (long k = 0; k < static_cast<long>(i); ++k) {
            product *= n - k;
        }
        return product;
    };
    const auto given_order = given_.size() - 1;
    for (long n = 0; a.size() < order(); ++n) {
        ball sum = from_rational<ball>(right_[static_cast<int>(n)]);
        for (std::size_t i = 0; i < given_.size(); ++i) {
            for (int j = i == given_order ? 1 : 0; j <= given_[i].degree() && j <= n; ++j) {
                const long m = n - j + static_cast<long>(i);
                sum -= from_rational<ball>(given_[i][j]) * falling(m, i) * a[static_cast<std::size_t>(m)];
            }
        }
        const ball leading = from_rational<ball>(given_.back()[0]);
        a.push_back(sum / (leading * falling(n + static_cast<long>(given_order), given_order)));
    }
    return a;
}

}  // namespace libration::ode
