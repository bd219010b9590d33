#include "libration/plane/uniformizing_chart.hpp"

#include "coefficients_in.hpp"

namespace libration::ode {

namespace {

constexpr int largest_degree = 12;

struct quotient_form {
    expression numerator, denominator;
};

// e = numerator/denominator, with divisions only inside functions.
quotient_form as_quotient(const expression& e) {
    switch (e.kind()) {
        case node_kind::sum: {
            const quotient_form a = as_quotient(e.left());
            const quotient_form b = as_quotient(e.right());
            if (same_form(a.denominator, b.denominator)) {
                return {a.numerator + b.numerator, a.denominator};
            }
            return {a.numerator * b.denominator + b.numerator * a.denominator, a.denominator * b.denominator};
        }
        case node_kind::product: {
            const quotient_form a = as_quotient(e.left());
            const quotient_form b = as_quotient(e.right());
            return {a.numerator * b.numerator, a.denominator * b.denominator};
        }
        case node_kind::quotient: {
            const quotient_form a = as_quotient(e.left());
            const quotient_form b = as_quotient(e.right());
            return {a.numerator * b.denominator, a.denominator * b.numerator};
        }
        case node_kind::power: {
            const auto exponent = e.right().fraction();
            if (exponent && denominator(*exponent) == 1 && *exponent < 0) {
                const quotient_form base = as_quotient(pow(e.left(), -e.right()));
                return {base.denominator, base.numerator};
            }
            return {e, expression(1)};
        }
        case node_kind::constant:
        case node_kind::variable:
        case node_kind::unknown:
        case node_kind::parameter:
        case node_kind::function: break;
    }
    return {e, expression(1)};
}

// The index of the last coefficient that is not the constant 0.
int degree_of(const std::vector<expression>& coefficients) {
    int degree = static_cast<int>(coefficients.size()) - 1;
    while (degree > 0 && coefficients[static_cast<std::size_t>(degree)].is(0)) {
        --degree;
    }
    return degree;
}

// sum over k <= degree of a_k v^(degree - k)
expression reversed_polynomial(const std::vector<expression>& a, int degree, const expression& v) {
    expression sum(0);
    for (int k = 0; k <= degree && k < static_cast<int>(a.size()); ++k) {
        sum = sum + a[static_cast<std::size_t>(k)] * pow(v, expression(degree - k));
    }
    return sum;
}

struct repeated_factor {
    expression base;
    int power;
};

// D as a constant times base^power.
repeated_factor repeated_factor_of(const expression& d) {
    const auto is_constant = [](const expression& e) { return !e.has_unknowns() && !e.has_variable(); };
    if (d.kind() == node_kind::product && is_constant(d.left())) {
        return repeated_factor_of(d.right());
    }
    if (d.kind() == node_kind::product && is_constant(d.right())) {
        return repeated_factor_of(d.left());
    }
    if (d.kind() == node_kind::power) {
        const auto exponent = d.right().fraction();
        if (exponent && denominator(*exponent) == 1 && *exponent > 1 && *exponent < largest_degree) {
            return {d.left(), numerator(*exponent).convert_to<int>()};
        }
    }
    return {d, 1};
}

// Names that no typed unknown has.
const char* const time_name = "t(s)";
const char* const inverse_name = "v(s)";
const char* const rest_name = "z(s)";

expression with_time(const expression& e) {
    return replaced(e, [](const expression& leaf) {
        return leaf.kind() == node_kind::variable ? std::optional(unknown(time_name)) : std::nullopt;
    });
}

}  // namespace

uniformizing_chart::uniformizing_chart(int sheets, int pole, std::vector<expression> leaves,
                                       std::vector<expression> right, expression zero)
    : sheets_(sheets),
      pole_(pole),
      leaves_(std::move(leaves)),
      system_(explicit_system::first_order(leaves_, right, number(rational(0)))),
      zero_(std::move(zero)),
      slope_(derivative_along(zero_, leaves_, right)) {}

std::optional<uniformizing_chart> uniformizing_chart::of(const explicit_system& system) {
    if (system.unknowns().size() != 1 || system.singular()) {
        return std::nullopt;
    }
    const int order = system.unknowns().front().order;
    return order == 1 ? of_first_order(system) : order == 2 ? of_second_order(system) : std::nullopt;
}

std::optional<uniformizing_chart> uniformizing_chart::of_first_order(const explicit_system& system) {
    const expression t = unknown(time_name);
    const expression y = unknown(system.unknowns().front().name);
    const expression& f = system.right().front();
    if (const auto a = coefficients_in(f, y, largest_degree)) {
        const int d = degree_of(*a);
        if (d < 3) {
            return std::nullopt;
        }
        const expression v = unknown(inverse_name);
        return uniformizing_chart(d - 1, 1, {t, v},
                                  {pow(v, expression(d - 2)), with_time(-reversed_polynomial(*a, d, v))}, v);
    }
    const quotient_form parts = as_quotient(f);
    if (partial(parts.denominator, y).is(0)) {
        return std::nullopt;
    }
    const repeated_factor factor = repeated_factor_of(parts.denominator);
    return uniformizing_chart(factor.power + 1, 0, {t, y}, {with_time(parts.denominator), with_time(parts.numerator)},
                              with_time(factor.base));
}

std::optional<uniformizing_chart> uniformizing_chart::of_second_order(const explicit_system& system) {
    const std::string& name = system.unknowns().front().name;
    const expression x = unknown(name);
    const auto linear = coefficients_in(system.right().front(), unknown(name, 1), 1);
    const auto damping = linear ? coefficients_in((*linear)[1], x, largest_degree) : std::nullopt;
    const auto force = linear ? coefficients_in((*linear)[0], x, largest_degree) : std::nullopt;
    if (!damping || !force || (*linear)[1].has_variable()) {
        return std::nullopt;
    }
    const int d = degree_of(*damping) + 1;
    if (d < 3 || degree_of(*force) > d - 2) {
        return std::nullopt;
    }
    std::vector<expression> primitive{expression(0)};
    expression lienard(0);
    for (int k = 0; k < d; ++k) {
        primitive.push_back((*damping)[static_cast<std::size_t>(k)] / (k + 1));
        lienard = lienard + primitive.back() * pow(x, expression(k + 1));
    }
    const expression t = unknown(time_name);
    const expression v = unknown(inverse_name);
    const expression z = unknown(rest_name);
    uniformizing_chart made(
        d - 1, 1, {t, v, z},
        {pow(v, expression(d - 2)), -(z * pow(v, expression(d)) + reversed_polynomial(primitive, d, v)),
         with_time(reversed_polynomial(*force, d - 2, v))},
        v);
    made.lienard_ = lienard;
    made.lienard_of_ = x;
    return made;
}

}  // namespace libration::ode
