#include "scaled_problem.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>

#include "libration/equation/constant_value.hpp"
#include "libration/plane/local_series.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration::ode {

namespace {

// The order of the series from which the units are determined.
constexpr int scale_order = 44;
constexpr int scale_digits = 20;
// log2 of radii and sizes whose powers up to that order, and their squares, remain in the range of double.
constexpr double usual_time = 6;
constexpr double usual_size = 32;

number power_of_two(long exponent) {
    const integer power = integer(1) << static_cast<unsigned>(std::abs(exponent));
    return number(exponent < 0 ? rational(integer(1), power) : rational(power));
}

/// 2^exponent rest.
struct scaled_form {
    long exponent = 0;
    expression rest;

    expression value() const { return exponent == 0 ? rest : expression(power_of_two(exponent)) * rest; }
};

// Rewrites expressions in scaled leaves, with the power of two factored out.
class scaling {
public:
    scaling(const explicit_system& of, long time, const std::vector<long>& sizes) : time_(time) {
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            sizes_.emplace(of.unknowns()[i].name, sizes[i]);
        }
    }

    const scaled_form& form(const expression& e) {
        const auto known = done_.find(e.identity());
        if (known != done_.end()) {
            return known->second.second;
        }
        scaled_form made = computed(e);
        return done_.emplace(e.identity(), std::pair(e, std::move(made))).first->second.second;
    }

private:
    scaled_form computed(const expression& e) {
        switch (e.kind()) {
            case node_kind::constant: return constant(e);
            case node_kind::variable: return {time_, e};
            case node_kind::unknown: return {sizes_.at(e.name()) - e.derivative() * time_, e};
            case node_kind::parameter: return {0, e};
            case node_kind::sum: return sum(form(e.left()), form(e.right()));
            case node_kind::product: {
                const scaled_form a = form(e.left());
                const scaled_form& b = form(e.right());
                return {a.exponent + b.exponent, a.rest * b.rest};
            }
            case node_kind::quotient: {
                const scaled_form a = form(e.left());
                const scaled_form& b = form(e.right());
                return {a.exponent - b.exponent, a.rest / b.rest};
            }
            case node_kind::power: return power(e);
            case node_kind::function: break;
        }
        const scaled_form inner = form(e.left());
        if (e.function() == function_kind::sqrt && inner.exponent % 2 == 0) {
            return {inner.exponent / 2, sqrt(inner.rest)};
        }
        return {0, with_argument(e, inner.value())};
    }

    static scaled_form constant(const expression& e) {
        const precision_scope scope(scale_digits);
        const long size = binary_exponent(constant_value<mpfr>::of(e.constant()));
        if (size == exponent_of_zero || std::abs(size) <= static_cast<long>(usual_size)) {
            return {0, e};
        }
        return {size, expression(power_of_two(-size)) * e};
    }

    static scaled_form sum(const scaled_form& a, const scaled_form& b) {
        const long larger = std::max(a.exponent, b.exponent);
        const auto part = [larger](const scaled_form& x) { return scaled_form{x.exponent - larger, x.rest}.value(); };
        return {larger, part(a) + part(b)};
    }

    scaled_form power(const expression& e) {
        const scaled_form base = form(e.left());
        const auto r = e.right().fraction();
        if (r && denominator(*r) == 1 && abs(numerator(*r)) <= 64) {
            return {base.exponent * numerator(*r).convert_to<long>(), pow(base.rest, e.right())};
        }
        if (r && denominator(*r) <= 64 && base.exponent % denominator(*r).convert_to<long>() == 0) {
            const long times = base.exponent / denominator(*r).convert_to<long>();
            return {times * numerator(*r).convert_to<long>(), pow(base.rest, e.right())};
        }
        return {0, pow(base.value(), e.right())};
    }

    long time_;
    std::map<std::string, long> sizes_;
    std::unordered_map<const void*, std::pair<expression, scaled_form>> done_;
};

explicit_system in_units(const explicit_system& of, long time, const std::vector<long>& sizes) {
    scaling scale(of, time, sizes);
    equation_system given;
    given.variable = of.variable();
    const expression point(of.point() * power_of_two(-time));
    for (std::size_t i = 0; i < of.unknowns().size(); ++i) {
        const unknown_function& each = of.unknowns()[i];
        scaled_form right = scale.form(of.right()[i]);
        right.exponent += each.order * time - sizes[i];
        given.add(unknown(each.name, each.order), right.value());
        for (int j = 0; j < each.order; ++j) {
            const number value = of.starts()[i][static_cast<std::size_t>(j)] * power_of_two(j * time - sizes[i]);
            given.begin(unknown(each.name, j), expression(value), point);
        }
    }
    return explicit_system(given);
}

}  // namespace

scaled_problem scaled_to_start(const explicit_system& of) {
    const precision_scope scope(scale_digits);
    const path_system paths(of);
    local_series<mpfr> series(paths, scale_order);
    series.about_start();
    const double radius = series.log_of_radius(std::max(2, tape::about_start(of).stride()));
    const bool has_radius = std::isfinite(radius);
    const long time = has_radius && std::abs(radius) > usual_time ? std::lround(radius) : 0;
    std::vector<long> sizes;
    bool is_scaled = time != 0;
    for (const std::size_t leaf : paths.functions) {
        const double size = series.log_of_size(leaf, has_radius ? radius : 0);
        sizes.push_back(std::isfinite(size) && std::abs(size) > usual_size ? std::lround(size) : 0);
        is_scaled = is_scaled || sizes.back() != 0;
    }
    return {is_scaled ? in_units(of, time, sizes) : of, time, std::move(sizes)};
}

}  // namespace libration::ode
