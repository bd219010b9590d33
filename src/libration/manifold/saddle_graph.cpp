#include "saddle_graph.hpp"

#include <algorithm>

#include "libration/algebra/ball_matrix.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

constexpr std::size_t highest_power_of_decay = 4;
constexpr std::size_t no_cut = static_cast<std::size_t>(-1);

// The product up to so many powers.
layer_polynomial graph_product(const layer_polynomial& a, const layer_polynomial& b, std::size_t rows,
                               std::size_t columns) {
    if (a.rows() == 0 || b.rows() == 0) {
        return {};
    }
    layer_polynomial result(std::min(rows, a.rows() + b.rows() - 1), std::min(columns, a.columns() + b.columns() - 1));
    for (std::size_t i = 0; i < std::min(a.rows(), result.rows()); ++i) {
        for (std::size_t j = 0; j < std::min(a.columns(), result.columns()); ++j) {
            if (arb_is_zero(a.at(i, j).handle()) != 0) {
                continue;
            }
            for (std::size_t k = 0; k < b.rows() && i + k < result.rows(); ++k) {
                for (std::size_t l = 0; l < b.columns() && j + l < result.columns(); ++l) {
                    result.at(i + k, j + l) += a.at(i, j) * b.at(k, l);
                }
            }
        }
    }
    return result;
}

// a + factor w^i s^j b, as large as both.
layer_polynomial graph_sum(const layer_polynomial& a, const ball& factor, const layer_polynomial& b, std::size_t i = 0,
                           std::size_t j = 0) {
    if (b.rows() == 0) {
        return a;
    }
    layer_polynomial result(std::max(a.rows(), b.rows() + i), std::max(a.columns(), b.columns() + j));
    result.add(ball(1), 0, 0, a);
    result.add(factor, i, j, b);
    return result;
}

layer_polynomial constant_polynomial(const ball& value) {
    layer_polynomial result(1, 1);
    result.at(0, 0) = value;
    return result;
}

// -w^2 p_w: the change of p along a solution.
layer_polynomial along_time(const layer_polynomial& p) {
    layer_polynomial result(p.rows() + 1, p.columns());
    result.add(ball(-1), 2, 0, p.by_sigma());
    return result;
}

ball binomial_of(unsigned n, unsigned k) {
    ball result(1);
    for (unsigned i = 0; i < k; ++i) {
        result = result * static_cast<long>(n - i) / static_cast<long>(i + 1);
    }
    return result;
}

// A(w, s) and B(w, s) without rho, and the coefficients of the powers of rho in R.
struct expanded_field {
    layer_polynomial u, v;
    std::vector<layer_polynomial> powers;
};

std::vector<layer_polynomial> powers_of(const layer_polynomial& base, unsigned most, std::size_t rows,
                                        std::size_t columns) {
    std::vector<layer_polynomial> result{constant_polynomial(ball(1))};
    while (result.size() <= most) {
        result.push_back(graph_product(result.back(), base, rows, columns));
    }
    return result;
}

expanded_field expanded_about(const saddle_equation& of, const saddle_graph& at, unsigned most, std::size_t rows,
                              std::size_t columns) {
    layer_polynomial s(1, 2);
    s.at(0, 1) = ball(1);
    expanded_field result;
    result.u = graph_sum(graph_sum(at.far, ball(1), at.phi), ball(1), s);
    result.v = graph_sum(graph_sum(at.far_slope, at.unstable, at.phi), at.stable, s);
    unsigned highest_u = 0;
    unsigned highest_v = 0;
    for (const auto& each : of.terms) {
        highest_u = std::max(highest_u, each.u);
        highest_v = std::max(highest_v, each.v);
    }
    const auto of_u = powers_of(result.u, highest_u, rows, columns);
    const auto of_v = powers_of(result.v, highest_v, rows, columns);
    for (const auto& each : of.terms) {
        for (unsigned i = 0; i <= each.u; ++i) {
            for (unsigned j = 0; j <= each.v && i + j <= most; ++j) {
                if (result.powers.size() <= i + j) {
                    result.powers.resize(i + j + 1);
                }
                ball factor = each.factor * binomial_of(each.u, i) * binomial_of(each.v, j);
                for (unsigned k = 0; k < j; ++k) {
                    factor *= at.unstable;
                }
                auto& here = result.powers[i + j];
                here =
                    graph_sum(here, factor, graph_product(of_u[each.u - i], of_v[each.v - j], rows, columns), each.w);
            }
        }
    }
    result.powers.resize(std::max<std::size_t>(result.powers.size(), 2));
    return result;
}

// rho' = residual + rho .., and s' without rho, each times r+ - r-.
struct slopes_at_graph {
    layer_polynomial residual, of_s;
};

slopes_at_graph slopes_about(const saddle_graph& at, const expanded_field& field) {
    const layer_polynomial excess = graph_sum(field.powers[0], ball(-1), along_time(at.far_slope));
    const layer_polynomial drift = graph_sum(field.v, ball(-1), at.far_slope);
    const ball gap = at.unstable - at.stable;
    slopes_at_graph result;
    result.of_s = graph_sum(graph_sum({}, at.unstable, drift), ball(-1), excess);
    result.residual = graph_sum(graph_sum(excess, -at.stable, drift), ball(-1),
                                graph_product(at.phi.by_u(), result.of_s, no_cut, no_cut));
    result.residual = graph_sum(result.residual, -gap, along_time(at.phi));
    return result;
}

}  // namespace

saddle_graph::place saddle_graph::place_of(const ball& u, const ball& v, const ball& w_here) const {
    const ball from_far = u - far.value(w_here, ball(0));
    const ball moving = v - far_slope.value(w_here, ball(0));
    const ball gap = unstable - stable;
    const ball s_here = (unstable * from_far - moving) / gap;
    return {(moving - stable * from_far) / gap - phi.value(w_here, s_here), s_here};
}

ball saddle_graph::slope_along(const ball& u, const ball& v, const ball& w_here, const std::vector<ball>& along) const {
    const ball from_far = along[0] - far.by_sigma().value(w_here, ball(0)) * along[2];
    const ball moving = along[1] - far_slope.by_sigma().value(w_here, ball(0)) * along[2];
    const ball gap = unstable - stable;
    const ball of_s = (unstable * from_far - moving) / gap;
    const ball s_here = place_of(u, v, w_here).s;
    const ball of_rho = (moving - stable * from_far) / gap - phi.by_u().value(w_here, s_here) * of_s -
                        phi.by_sigma().value(w_here, s_here) * along[2];
    if (slope.is_zero()) {
        return of_rho;
    }
    return widened(of_rho, slope * std::max(magnitude(of_s) / s, magnitude(along[2]) / w));
}

std::optional<saddle_graph> formal_saddle_graph(const saddle_equation& of, std::size_t terms) {
    ball by_u(0);
    ball by_v(0);
    for (const auto& each : of.terms) {
        if (each.w == 0 && each.v == 0 && each.u > 0) {
            by_u += each.factor * static_cast<long>(each.u) * pow(of.limit, static_cast<long>(each.u) - 1);
        }
        if (each.w == 0 && each.v == 1) {
            by_v += each.factor * pow(of.limit, static_cast<long>(each.u));
        }
    }
    if (arb_is_positive(by_u.handle()) == 0) {
        return std::nullopt;
    }
    const ball root = sqrt(by_v * by_v / 4 + by_u);
    saddle_graph result;
    result.unstable = exact_midpoint(by_v / 2 + root);
    result.stable = exact_midpoint(by_v / 2 - root);
    result.far = layer_polynomial(terms + 1, 1);
    result.far.at(0, 0) = exact_midpoint(of.limit);
    result.far_slope = along_time(result.far);
    result.phi = layer_polynomial(terms + 1, highest_power_of_decay + 1);
    const std::size_t rows = terms + 1;
    const std::size_t columns = highest_power_of_decay + 1;
    // Each round determines one more order.
    for (std::size_t round = 0; round < rows + columns; ++round) {
        const auto slopes = slopes_about(result, expanded_about(of, result, 0, rows, columns));
        const ball gap = result.unstable - result.stable;
        for (std::size_t i = 0; i < std::min(rows, slopes.residual.rows()); ++i) {
            if (i > 0) {
                ball& far = result.far.at(i, 0);
                far = exact_midpoint(far - slopes.residual.at(i, 0) / -(result.unstable * result.stable));
            }
            for (std::size_t j = 1; j < std::min(columns, slopes.residual.columns()); ++j) {
                ball& phi = result.phi.at(i, j);
                if (i + j > 1) {
                    phi = exact_midpoint(phi - slopes.residual.at(i, j) /
                                                   (gap * (result.unstable - result.stable * static_cast<long>(j))));
                }
            }
        }
        result.far_slope = along_time(result.far);
    }
    return result;
}

std::optional<saddle_graph> proved_saddle_graph(const saddle_equation& of, const saddle_graph& formal,
                                                const magnitude& w, const magnitude& s) {
    saddle_graph result = formal;
    // The exact limit, from which the midpoint differs.
    result.far.at(0, 0) = of.limit;
    result.w = w;
    result.s = s;
    const auto field = expanded_about(of, result, static_cast<unsigned>(-1), no_cut, no_cut);
    auto [residual, of_s] = slopes_about(result, field);
    const auto size = [&](const layer_polynomial& p) { return p.rows() == 0 ? ball(0) : p.norm(w, s).exact(); };
    const auto by_w = [&](const layer_polynomial& p) {
        return p.rows() == 0 ? ball(0) : size(p.by_sigma()) * w.exact();
    };
    const auto by_s = [&](const layer_polynomial& p) { return p.rows() == 0 ? ball(0) : size(p.by_u()) * s.exact(); };
    const layer_polynomial turned = graph_sum(constant_polynomial(ball(1)), ball(1), result.phi.by_u());  // 1 + phi_s
    // The factor of rho in s', r+^2 - R_1, and in rho', R_1 - r- r+ - phi_s (r+^2 - R_1); all times r+ - r-.
    const layer_polynomial coupling =
        graph_sum(constant_polynomial(result.unstable * result.unstable), ball(-1), field.powers[1]);
    layer_polynomial rate =
        graph_sum(graph_sum(field.powers[1], ball(-1), graph_product(result.phi.by_u(), coupling, no_cut, no_cut)),
                  -(result.stable * result.unstable), constant_polynomial(ball(1)));
    const ball residual_size = size(residual);
    const ball rate_at_rest = rate.at(0, 0);
    rate.at(0, 0) = ball(0);
    const ball least_rate = rate_at_rest - size(rate);
    if (arb_is_positive(least_rate.handle()) == 0) {
        return std::nullopt;
    }
    result.eps = magnitude(residual_size / least_rate).shifted(1) + s * magnitude::of(1, -ball::working_bits());
    const ball eps = result.eps.exact();
    // Sums over the powers rho^k, k >= 2, of rho' and s'.
    ball beyond_rho(0);
    ball beyond_s(0);
    ball slope_rho(0);
    ball slope_s(0);
    ball mixed_rho = by_w(residual) + by_s(residual) + eps * (by_w(rate) + by_s(rate));
    ball mixed_s_by_w = by_w(of_s) + eps * by_w(coupling);
    ball mixed_s_by_s = eps * by_s(coupling);
    ball power = eps;
    for (std::size_t k = 2; k < field.powers.size(); ++k) {
        const layer_polynomial here = graph_product(field.powers[k], turned, no_cut, no_cut);
        slope_rho += size(here) * power * static_cast<long>(k);
        slope_s += size(field.powers[k]) * power * static_cast<long>(k);
        power *= eps;
        beyond_rho += size(here) * power;
        beyond_s += size(field.powers[k]) * power;
        mixed_rho += (by_w(here) + by_s(here)) * power;
        mixed_s_by_w += by_w(field.powers[k]) * power;
        mixed_s_by_s += by_s(field.powers[k]) * power;
    }
    const ball decay = of_s.at(0, 1);
    of_s.at(0, 1) = ball(0);
    const ball s_0 = s.exact();
    const bool leaves = certainly_less(residual_size + beyond_rho, least_rate * eps);
    const bool stays = certainly_less(size(of_s) + eps * size(coupling) + beyond_s, -decay * s_0);
    if (!leaves || !stays) {
        return std::nullopt;
    }
    const ball m_a = least_rate - slope_rho;
    const ball row_s = decay + (by_s(of_s) + mixed_s_by_s) / s_0;
    const ball n_ba = (size(coupling) + slope_s) / s_0;
    const ball row = row_s + mixed_s_by_w / s_0;
    const ball mu_b = certainly_less(row, ball(0)) ? ball(0) : abs(row);
    const ball n_ab = mixed_rho;
    const ball room = m_a - mu_b;
    if (arb_is_positive(room.handle()) == 0) {
        return std::nullopt;
    }
    result.slope = magnitude(n_ab * 3 / (room * 2)) + magnitude::of(1, -2 * ball::working_bits());
    const ball l = result.slope.exact();
    const bool is_only = certainly_less(n_ab / l + n_ba * l, room) && certainly_less(n_ab / l, m_a);
    const bool tends = certainly_less(row_s + n_ba * l, ball(0));
    return is_only && tends ? std::optional(result) : std::nullopt;
}

}  // namespace libration::ode
