#include "movable_expansion.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "libration/expansion/ball_expansion.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

// |log w| + pi + 1/(e h)
ball size_of_logarithm(const ball& w) {
    return abs(log(w)) + pi<ball>() + ball(parts_of_movable_logarithm) / exp(ball(1));
}
ball value_of_variable(const movable_variable& of, const ball& w, const ball& size) {
    ball sum(0);
    for (std::size_t k = of.moduli.size(); k-- > 0;) {
        sum = sum * size + of.moduli[k].exact();
    }
    return sum * pow(w, of.rate) * of.turn;
}

}  // namespace

std::vector<movable_variable> polydisc_for(const local_solution& local, const local_model& model, const complex_row& x,
                                           double reach, const weighted_monomials& monomials) {
    const std::vector<complex_row> variables = local.variables_of(model, x, monomials);
    std::vector<movable_variable> result(monomials.variables());
    std::vector<std::size_t> order(monomials.variables());
    for (std::size_t v = 0; v < order.size(); ++v) {
        order[v] = v;
    }
    std::ranges::stable_sort(order, {}, [&](std::size_t v) { return monomials.weight_of(v).real_part(); });
    ball at;
    arb_set_d(at.handle(), reach);
    for (const std::size_t v : order) {
        movable_variable& each = result[v];
        const complex_ball weight = monomials.weight_of(v).value();
        each.rate = weight.re;
        each.turn = exp(ball(pi<ball>() * abs(weight.im)));
        for (const complex_ball& c : variables[v]) {
            each.moduli.push_back(size_of(c));
        }
        each.radius = ball(1);
        each.radius = upper_bound(value_of_variable(each, at, size_of_logarithm(at)) * ball(129) / 128);
        magnitude resonant;
        for (const auto& term : model.series.resonant) {
            if (term.variable == v) {
                magnitude product = size_of(term.factor);
                for (std::size_t u = 0; u < monomials.variables(); ++u) {
                    for (int k = 0; k < monomials[term.monomial][u]; ++k) {
                        product *= magnitude(result[u].radius);
                    }
                }
                resonant += product;
            }
        }
        const ball least = upper_bound(ball(resonant.exact() * 3 / weight.re));
        each.radius = upper_bound(certainly_less(each.radius, least) ? least : each.radius);
        if (contains_zero(each.radius)) {
            arb_set_d(each.radius.handle(), std::ldexp(1.0, -60));
        }
    }
    return result;
}

// w^(Re r) (|log w| + pi)^k increases for w < 1 if k <= pi Re r.
rational degrees_of_logarithms(const std::vector<movable_variable>& variables, const weighted_monomials& monomials) {
    rational largest = 0;
    for (std::size_t v = 0; v < variables.size(); ++v) {
        const auto degree = static_cast<long>(variables[v].moduli.size()) - 1;
        const quadratic_number& weight = monomials.weight_of(v);
        if (degree > 0 && (!certainly_less(ball(degree), ball(variables[v].rate * 3)) ||
                           (!weight.is_rational() && weight.radicand > 0))) {
            throw error(error_kind::undecided, error_subject::problem, "",
                        "has a singularity with powers of logarithms that are too high for their resonance");
        }
        largest = degree > 0 ? std::max(largest, rational(rational(degree) / weight.p)) : largest;
    }
    return largest;
}

std::vector<movable_term> terms_of(const local_solution& local, const local_model& model, const complex_row& box,
                                   const weighted_monomials& monomials, std::size_t shown) {
    std::vector<movable_term> result;
    const std::vector<complex_row> variables = local.variables_of(model, box, monomials);
    std::vector<std::vector<complex_row>> powers;
    powers.resize(variables.size(), {{complex_ball(1)}});
    struct collected {
        quadratic_number exponent;
        complex_row by_logarithm;
    };
    std::map<std::pair<rational, rational>, collected> sums;
    const auto add = [&](std::size_t m, const complex_ball& c) {
        complex_row part{c};
        for (std::size_t v = 0; v < monomials.variables(); ++v) {
            const auto e = static_cast<std::size_t>(monomials[m][v]);
            while (powers[v].size() <= e) {
                powers[v].push_back(product_of_polynomials(powers[v].back(), variables[v]));
            }
            part = e == 0 ? part : product_of_polynomials(part, powers[v][e]);
        }
        const quadratic_number exponent = monomials.weight(m) - quadratic_number(local.balance().orders[shown]);
        collected& sum = sums[{exponent.p, exponent.q}];
        sum.exponent = exponent;
        sum.by_logarithm.resize(std::max(sum.by_logarithm.size(), part.size()), complex_ball(0));
        for (std::size_t k = 0; k < part.size(); ++k) {
            sum.by_logarithm[k] = sum.by_logarithm[k] + part[k];
        }
    };
    const complex_row limits = local.field().limits(
        complex_row(box.begin() + 1, box.begin() + 1 + static_cast<std::ptrdiff_t>(local.balance().finite.size())));
    for (std::size_t m = 0; m < monomials.count(); ++m) {
        const complex_ball c = m == 0 ? limits[shown] : model.series.nodes[shown][m];
        if (!is_zero_term(c)) {
            add(m, model.scales[shown] * c);
        }
    }
    for (auto& [key, each] : sums) {
        result.push_back({each.exponent.value(),
                          each.exponent.is_rational() ? std::optional(each.exponent.p) : std::nullopt,
                          std::move(each.by_logarithm)});
    }
    std::ranges::stable_sort(result, [](const movable_term& a, const movable_term& b) {
        return arf_cmp(arb_midref(a.exponent.re.handle()), arb_midref(b.exponent.re.handle())) < 0;
    });
    return result;
}

ball movable_point::kappa_at(const ball& w, const ball& size) const {
    ball kappa(0);
    for (const movable_variable& each : variables) {
        const ball part = upper_bound(value_of_variable(each, w, size) / each.radius);
        if (!certainly_less(part, ball(1))) {
            throw precision_exhausted("the polydisc at a singularity");
        }
        kappa = contains_zero(part) ? kappa : upper_bound(hull(kappa, pow(part, ball(1 / each.rate))));
    }
    return kappa;
}

magnitude movable_point::bound_over(const ball& x) const {
    const magnitude infinite = magnitude(1U) / magnitude(0U);
    const precision_scope few(20);
    ball end;
    arb_set_d(end.handle(), reach);
    const ball high = upper_bound(x);
    const ball low = lower_bound(x);
    if (!certainly_less(high, end) || !certainly_less(ball(0), low)) {
        return infinite;
    }
    const ball size = upper_bound(hull(abs(log(high)), abs(log(low)))) + pi<ball>();
    magnitude sum;
    for (const movable_term& each : terms) {
        ball part(0);
        for (std::size_t k = each.by_logarithm.size(); k-- > 0;) {
            part = part * size + size_of(each.by_logarithm[k]).exact();
        }
        const ball& at = certainly_less(each.exponent.re, ball(0)) ? low : high;
        sum += magnitude(ball(part * pow(at, each.exponent.re) * exp(ball(pi<ball>() * abs(each.exponent.im)))));
    }
    sum += rest * magnitude(pow(order < 0 ? high : low, from_rational<ball>(-order)));
    return sum;
}

}  // namespace libration::ode
